import errno
import os
from collections.abc import Callable
from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.opening import declared, open_media
from hapticplayer.model.limits import MAX_PIXELS, MAX_SIDE_PX


def missing(path: Path, clip: Path) -> Path:
    return path


def folder(path: Path, clip: Path) -> Path:
    path.mkdir()
    return path


def fifo(path: Path, clip: Path) -> Path:
    os.mkfifo(path)
    return path


def device(path: Path, clip: Path) -> Path:
    path.symlink_to("/dev/zero")
    return path


def link_loop(path: Path, clip: Path) -> Path:
    path.symlink_to(path)
    return path


def empty(path: Path, clip: Path) -> Path:
    path.touch()
    return path


def one_byte(path: Path, clip: Path) -> Path:
    path.write_bytes(b"\x00")
    return path


def text(path: Path, clip: Path) -> Path:
    path.write_text("time_s,ax,ay,az\n0,0,0,9.8\n" * 40)
    return path


def zeros(path: Path, clip: Path) -> Path:
    path.write_bytes(bytes(1_000_000))
    return path


def random_bytes(path: Path, clip: Path) -> Path:
    path.write_bytes(np.random.default_rng(1).bytes(1_000_000))
    return path


def truncated(path: Path, clip: Path) -> Path:
    content = clip.read_bytes()
    path.write_bytes(content[: len(content) * 7 // 10])
    return path


def half_a_header(path: Path, clip: Path) -> Path:
    path.write_bytes(clip.read_bytes()[:406])
    return path


def playlist(path: Path, clip: Path) -> Path:
    path.write_text(
        "#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\n"
        "http://127.0.0.1:9/segment.ts\n#EXT-X-ENDLIST\n"
    )
    return path


def local_playlist(path: Path, clip: Path) -> Path:
    path.write_text(
        f"#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\nfile://{clip}\n#EXT-X-ENDLIST\n"
    )
    return path


def address(path: Path, clip: Path) -> Path:
    return Path(f"http://{clip.name}")


def concatenation(path: Path, clip: Path) -> Path:
    (path.parent / "sibling.mp4").write_bytes(clip.read_bytes())
    path.write_text("ffconcat version 1.0\nfile sibling.mp4\n")
    return path


def session_description(path: Path, clip: Path) -> Path:
    path.write_text("v=0\nc=IN IP4 127.0.0.1\nm=video 5004 RTP/AVP 96\n")
    return path


NASTY: dict[str, tuple[Callable[[Path, Path], Path], str]] = {
    "missing.mp4": (missing, "there is no such file"),
    "http:/numbered.mp4": (address, "is an address, not a file of this machine"),
    "folder.mp4": (folder, "is a folder"),
    "pipe.mp4": (fifo, "is a pipe"),
    "zero.mp4": (device, "is a device"),
    "loop.mp4": (link_loop, "cannot be reached"),
    "empty.mp4": (empty, "is empty"),
    "one.mp4": (one_byte, "cannot be|can be read|no video"),
    "text.mp4": (text, "can be read"),
    "zeros.mp4": (zeros, "can be read"),
    "random.mp4": (random_bytes, "can be read"),
    "cut.mp4": (truncated, r"the file ends at byte \d+ but its index needs \d+"),
    "header.mp4": (half_a_header, "headers are damaged"),
    "playlist.mp4": (playlist, "it is HLS, which is not read"),
    "list.m3u8": (playlist, "it is HLS, which is not read"),
    "local.m3u8": (local_playlist, "it is HLS, which is not read"),
    "concat.mp4": (concatenation, "can be read"),
    "concat.ffconcat": (concatenation, "can be read"),
    "session.sdp": (session_description, "can be read"),
}


@pytest.mark.parametrize("name", NASTY)
def test_nasty_file_is_refused_in_one_sentence(
    name: str, tmp_path: Path, clip: Path
) -> None:
    make, sentence = NASTY[name]
    path = make(tmp_path / name, clip)
    with pytest.raises(MediaError, match=sentence) as caught:
        open_media(path)
    assert name in str(caught.value) or "/dev/zero" in str(caught.value)
    assert "; " in str(caught.value), "it says what to do"
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "name",
    [
        "http://127.0.0.1:9/clip.mp4",
        "concat:{clip}|{clip}",
        "subfile,,start,0,end,0,,:{clip}",
        "async:{clip}",
        "tcp://127.0.0.1:9",
        "bad\0name.mp4",
    ],
)
def test_name_of_a_protocol_is_no_file(name: str, clip: Path) -> None:
    with pytest.raises(MediaError, match=r"is an address|no such file|be reached"):
        open_media(name.format(clip=clip))


def test_link_to_a_good_file_opens(tmp_path: Path, clip: Path) -> None:
    link = tmp_path / "link.mp4"
    link.symlink_to(clip)
    with open_media(link) as container:
        assert len(container.streams.video) == 1


def test_relative_and_unicode_names_open(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = "über:cañón %d 日本.mp4"
    (tmp_path / name).write_bytes(clip.read_bytes())
    monkeypatch.chdir(tmp_path)
    assert probe(name).path == tmp_path / name


def test_file_that_may_not_be_read_is_refused(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_arguments):  # tests may run as root
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(os, "open", refuse)
    with pytest.raises(MediaError, match="permission denied"):
        open_media(clip)


@pytest.mark.parametrize("suffix", ["mov", "mkv", "webm", "avi", "wav"])
def test_other_containers_open(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"clip.{suffix}"
    codec = {"webm": "libvpx", "avi": "mpeg4", "wav": "pcm_s16le"}.get(
        suffix, "libx264"
    )
    with av.open(str(path), "w") as container:
        if suffix == "wav":
            sound = container.add_stream(codec, rate=48_000)
            frame = av.AudioFrame.from_ndarray(
                np.zeros((1, 4800), np.int16), format="s16", layout="mono"
            )
            frame.sample_rate = 48_000
            container.mux(sound.encode(frame))
            container.mux(sound.encode(None))
        else:
            video = container.add_stream(codec, rate=30)
            video.width, video.height, video.pix_fmt = 64, 48, "yuv420p"
            for number in range(4):
                picture = av.VideoFrame(64, 48, "yuv420p")
                picture.pts = number
                container.mux(video.encode(picture))
            container.mux(video.encode())
    with open_media(path) as container:
        assert len(container.streams) == 1
    content = path.read_bytes()
    path.write_bytes(content[: len(content) - 20])
    with pytest.raises(MediaError, match="the file ends at byte"):
        open_media(path)


@pytest.mark.parametrize(
    "head",
    [
        b"RIFF" + b"\xff" * 4,
        b"RIFF" + b"\0" * 4,
        b"RIFF",
        b"\x1a\x45\xdf\xa3",
        b"\x1a\x45\xdf\xa3\x80",
        b"\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\xff",  # live: length unknown
        b"\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\x01" + b"\xff" * 7,
        b"\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\0",
    ],
)
def test_header_without_a_length_promises_nothing(tmp_path: Path, head: bytes) -> None:
    path = tmp_path / "head"
    path.write_bytes(head)
    assert declared(path).end == 0


def test_length_in_the_header_is_read(tmp_path: Path) -> None:
    path = tmp_path / "head"
    path.write_bytes(b"RIFF\x10\x27\0\0WAVE")
    assert declared(path).end == 10_008
    segment = b"\x1a\x45\xdf\xa3\x82\0\0\x18\x53\x80\x67\x41\x00"
    path.write_bytes(segment)
    assert declared(path).end == len(segment) + 256


def test_data_behind_the_boxes_is_no_damage(tmp_path: Path, clip: Path) -> None:
    """Some cameras append a trailer that is no box."""
    path = tmp_path / "trailer.mp4"
    path.write_bytes(clip.read_bytes() + b"\xff" * 1000)
    assert probe(path).frame_count == 150


def test_limits_leave_room_for_8k_and_stop_a_bomb() -> None:
    assert 7680 * 4320 <= MAX_PIXELS < 8192 * 8192
    assert MAX_SIDE_PX >= 8192


def test_huge_picture_is_refused_before_it_is_decoded(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("hapticplayer.media.opening.MAX_PIXELS", 320 * 180 - 1)
    with pytest.raises(MediaError, match="320 x 180 pixels are too large"):
        open_media(clip)
    monkeypatch.setattr("hapticplayer.media.opening.MAX_PIXELS", 320 * 180)
    open_media(clip).close()
