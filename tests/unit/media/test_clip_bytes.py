"""A clip that is no file is read for FFmpeg, which opens nothing by itself."""

import io
import socket

import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.media.clip_info import probe
from hapticplayer.media.matroska import Attachment
from hapticplayer.media.remux import MATROSKA, Additions, remux
from hapticplayer.media.video import VideoDecoder


class InMemory(ClipBytes):
    def __init__(self, content):
        super().__init__("ride.mp4", len(content))
        self._content = content

    def open(self):
        return io.BytesIO(self._content)

    def beside(self, name):
        return None

    @property
    def waiting(self):
        return None

    def is_ahead(self, share):
        return True

    def close(self):
        pass


def test_a_clip_in_memory_is_decoded_like_the_file(tiny_clip):
    clip = InMemory(tiny_clip.path.read_bytes())
    found = probe(clip)
    assert found.content is clip
    assert str(found.path) == "ride.mp4"
    assert found.duration_s == tiny_clip.duration_s
    with VideoDecoder(clip) as one, VideoDecoder(tiny_clip.path) as other:
        for a, b in zip(one.frames(), other.frames(), strict=True):
            assert np.array_equal(a.native.to_ndarray(), b.native.to_ndarray())


@pytest.mark.parametrize(
    "text",
    [
        "#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\n{0}\n#EXT-X-ENDLIST\n",
        "ffconcat version 1.0\nfile {0}\n",
        '<?xml version="1.0"?><MPD><BaseURL>{0}</BaseURL></MPD>',
    ],
)
def test_addresses_in_it_are_never_asked(text):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.setblocking(False)
        address = f"http://127.0.0.1:{listener.getsockname()[1]}/canary.ts"
        with pytest.raises(MediaError):
            probe(InMemory(text.format(address).encode()))
        with pytest.raises(BlockingIOError):
            listener.accept()


def test_an_index_beyond_the_limit_is_refused(tiny_clip, monkeypatch):
    clip = InMemory(tiny_clip.path.read_bytes())
    clip.size_bytes = 1 << 60  # as a server may say
    monkeypatch.setattr("hapticplayer.media.opening.MAX_INDEXED", 10)
    with pytest.raises(MediaError, match=r"its index lists \d+ frames .*limit: 10"):
        probe(clip)


def test_headers_beyond_the_limit_are_refused(tiny_clip, monkeypatch):
    content = tiny_clip.path.read_bytes()
    monkeypatch.setattr("hapticplayer.media.clip_bytes.MAX_HEADER_BYTES", 100)
    with pytest.raises(MediaError, match="its headers are too large"):
        probe(InMemory(content))
    path = tiny_clip.path.with_name("again.mp4")
    path.write_bytes(content)
    with pytest.raises(MediaError, match="its headers are too large"):
        probe(path)


def test_attachments_are_not_fetched(tiny_clip, tmp_path):
    target = tmp_path / "large.mkv"
    one = Attachment("large", "application/octet-stream", bytes(4 << 20))
    remux(tiny_clip.path, target, MATROSKA, Additions((one,)))
    clip = InMemory(target.read_bytes())
    before = probe(target)
    assert probe(clip).duration_s == before.duration_s
    assert before.frame_rate_hz == tiny_clip.frame_rate_hz


def test_a_clip_that_ends_early_is_refused(tiny_clip):
    with pytest.raises(MediaError):
        probe(InMemory(tiny_clip.path.read_bytes()[:-500]))
