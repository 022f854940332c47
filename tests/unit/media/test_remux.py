"""Streams are copied bit for bit; FFmpeg's own checksums of packets and frames agree."""

import hashlib
import shutil
import subprocess
from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import Cancelled, MediaError
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.clip_info import probe
from hapticplayer.media.identity import ANOTHER
from hapticplayer.media.matroska import Attachment
from hapticplayer.media.opening import open_media
from hapticplayer.media.remux import MATROSKA, MP4, Additions, remux, video_payload
from hapticplayer.media.video import VideoDecoder
from tests.unit.media.conftest import CLICKS_S

needs_ffmpeg = pytest.mark.skipif(not shutil.which("ffmpeg"), reason="needs ffmpeg")
KINDS = [(MATROSKA, "mkv"), (MP4, "mp4")]


def hashes_of(path: Path, *options: str) -> list[str]:
    """Return what FFmpeg prints: a checksum of each frame, or of the packets."""
    words = ["ffmpeg", "-v", "error", "-i", str(path), "-map", "0:v:0", *options, "-"]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    lines = [one for one in done.stdout.splitlines() if not one.startswith("#")]
    return [one.replace("=", ",").split(",")[-1].strip() for one in lines]


@needs_ffmpeg
@pytest.mark.parametrize(("kind", "ending"), KINDS)
def test_packets_and_decoded_frames_are_those_of_the_clip(
    clip: Path, tmp_path: Path, kind: str, ending: str
) -> None:
    copy = tmp_path / f"copy.{ending}"
    payload = remux(clip, copy, kind)
    (of_packets,) = hashes_of(clip, "-c", "copy", "-f", "streamhash")
    assert payload.sha256 == of_packets == video_payload(copy).sha256
    frames = hashes_of(clip, "-vsync", "0", "-f", "framehash")
    assert hashes_of(copy, "-vsync", "0", "-f", "framehash") == frames
    assert len(frames) == payload.packets


def packets_of(path: Path) -> dict[str, list[tuple[float, float, bool, bytes]]]:
    """Return presentation and decoding time (s), key or not, and payload of packets."""
    found: dict[str, list[tuple[float, float, bool, bytes]]] = {}
    with open_media(path) as container:
        for one in container.demux(container.streams.video, container.streams.audio):
            if one.size:
                assert one.pts is not None
                assert one.dts is not None
                times_s = (float(t * one.time_base) for t in (one.pts, one.dts))
                row = (*times_s, one.is_keyframe, bytes(one))
                found.setdefault(one.stream.type, []).append(row)
    return found


def test_an_mp4_has_every_packet_at_its_time_and_a_note_more(
    clip: Path, tmp_path: Path
) -> None:
    source, copy = tmp_path / "clip.mp4", tmp_path / "copy.mp4"
    remux(clip, source, MP4)
    remux(source, copy, MP4, Additions((), {"hapticplayer": "sha256"}))
    before = packets_of(source)
    assert set(before) == {"video", "audio"}
    assert packets_of(copy) == before
    with open_media(copy) as container:
        assert container.metadata["hapticplayer"] == "sha256"


@pytest.mark.parametrize(("kind", "ending"), KINDS)
def test_frames_and_sound_keep_their_times(
    clip: Path, tmp_path: Path, kind: str, ending: str
) -> None:
    """Matroska rounds both to 1 ms, so they may be 1 ms apart."""
    copy = tmp_path / f"copy.{ending}"
    remux(clip, copy, kind)
    assert probe(copy).duration_s == pytest.approx(probe(clip).duration_s, abs=2e-3)
    with VideoDecoder(clip) as first, VideoDecoder(copy) as second:
        for one, other in zip(first.frames(), second.frames(), strict=True):
            assert other.pts_s == pytest.approx(one.pts_s, abs=1e-3)
    found = []
    with AudioDecoder(copy) as audio:
        while block := audio.next_block():
            at = int(np.argmax(np.abs(block.samples[:, 0])))
            if abs(block.samples[at, 0]) > 0.4:
                found.append(block.media_s + at / audio.rate_hz)
    for at_s in CLICKS_S:
        assert min(abs(at_s - one) for one in found) < 1.2e-3


def test_a_copy_of_a_copy_is_the_same_video(clip: Path, tmp_path: Path) -> None:
    """The first packets of a Matroska file have no decoding times."""
    first, second, third = (tmp_path / n for n in ("a.mkv", "b.mkv", "c.mp4"))
    payload = remux(clip, first, MATROSKA)
    assert payload.difference(remux(first, second, MATROSKA)) is None
    assert payload.difference(remux(second, third, MP4)) is None
    with VideoDecoder(third) as video:
        times_s = [frame.pts_s for frame in video.frames()]
    assert times_s == sorted(times_s)


def test_attachments_and_metadata_are_written(clip: Path, tmp_path: Path) -> None:
    copy = tmp_path / "copy.mkv"
    note = Attachment("note.json", "application/json", b"{}")
    remux(clip, copy, MATROSKA, Additions((note,), {"hapticplayer": "yes"}))
    with av.open(str(copy)) as container:
        held = [s for s in container.streams if s.type == "attachment"]
        assert [(s.name, s.mimetype, s.data) for s in held] == [note]
    with open_media(copy) as container:
        assert {s.type for s in container.streams} == {"video", "audio"}
    assert probe(copy).names_force
    assert not probe(clip).names_force


def test_the_same_parts_are_the_same_bytes(clip: Path, tmp_path: Path) -> None:
    made = [tmp_path / "a.mkv", tmp_path / "b.mkv"]
    attached = (Attachment("a.npz", "application/octet-stream", b"force"),)
    for one in made:
        remux(clip, one, MATROSKA, Additions(attached=attached))
    assert made[0].read_bytes() == made[1].read_bytes()


def test_one_changed_byte_changes_the_checksum(clip: Path, tmp_path: Path) -> None:
    content = bytearray(clip.read_bytes())
    content[content.index(b"mdat") + 500] ^= 1
    changed = tmp_path / "changed.mp4"
    changed.write_bytes(content)
    assert video_payload(clip).difference(video_payload(changed)) == ANOTHER


def test_a_hidden_beginning_is_refused(clip: Path, tmp_path: Path) -> None:
    """An edit list that starts within a group of pictures hides what precedes it."""
    content = bytearray(clip.read_bytes())
    at = content.index(b"elst") + 16  # behind version, count and duration
    with open_media(clip) as container:
        second, third = container.streams.video[0].index_entries[1:3]
        ticks = 10 * (third.timestamp - second.timestamp)
    start = int.from_bytes(content[at : at + 4], "big")
    content[at : at + 4] = (start + ticks).to_bytes(4, "big")
    trimmed = tmp_path / "trimmed.mp4"
    trimmed.write_bytes(content)
    with pytest.raises(MediaError, match="hidden by an edit list"):
        remux(trimmed, tmp_path / "copy.mkv", MATROSKA)


def test_a_cancelled_checksum_stops(clip: Path, monkeypatch) -> None:
    def stop(_share: float) -> None:
        raise Cancelled

    monkeypatch.setattr("hapticplayer.media.remux.REPORT_BYTES", 1)
    with pytest.raises(Cancelled):
        video_payload(clip, stop)


def test_the_checksum_is_that_of_the_payloads(clip: Path) -> None:
    digest = hashlib.sha256()
    with open_media(clip) as container:
        for packet in container.demux(video=0):
            digest.update(bytes(packet))
    assert video_payload(clip).sha256 == digest.hexdigest()


def test_the_index_comes_before_the_frames(clip, tmp_path):
    remux(clip, tmp_path / "copy.mkv", MATROSKA)
    content = (tmp_path / "copy.mkv").read_bytes()
    assert (
        0 < content.index(b"\x1c\x53\xbb\x6b", 200) < content.index(b"\x1f\x43\xb6\x75")
    )
