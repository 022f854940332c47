"""A few bytes that declare millions of samples are refused before room is made."""

import struct
from pathlib import Path

import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media import opening
from hapticplayer.media import telemetry as module
from hapticplayer.media.opening import declared, open_media
from hapticplayer.media.telemetry import (
    TelemetryPacket,
    add_telemetry,
    read_telemetry_packets,
)


def box(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I4s", 8 + len(content), kind) + content


def nested(*kinds: bytes, content: bytes) -> bytes:
    for kind in reversed(kinds):
        content = box(kind, content)
    return content


@pytest.fixture
def bomb(tmp_path: Path, clip: Path) -> Path:
    """A clip whose first table says: 40 million samples of one byte."""
    content = bytearray(clip.read_bytes())
    at = content.index(b"stsz") + 8
    content[at : at + 8] = struct.pack(">II", 1, 40_000_000)
    path = tmp_path / "bomb.mp4"
    path.write_bytes(content)
    return path


def test_a_clip_declares_the_samples_that_it_has(clip: Path) -> None:
    with open_media(clip) as container:
        samples = sum(len(stream.index_entries) for stream in container.streams)
    assert declared(clip).samples == samples > 0


def test_a_bomb_is_refused_before_it_is_opened(
    bomb: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert declared(bomb).samples >= 40_000_000
    monkeypatch.setattr("hapticplayer.media.opening.av.open", None)
    with pytest.raises(MediaError, match="lists more samples than it has bytes"):
        open_media(bomb)


@pytest.mark.parametrize(
    ("content", "samples"),
    [
        (nested(b"moof", b"traf", content=box(b"trun", struct.pack(">II", 0, 9))), 9),
        (struct.pack(">I4sQ", 1, b"mdat", 2**63), 0),
        (struct.pack(">I4s", 0, b"mdat") + bytes(99), 0),
        (struct.pack(">I4s", 5, b"moov"), 0),
        (box(b"stsz", b""), 0),
    ],
    ids=["fragment", "far end", "to the end", "too short", "cut"],
)
def test_tables_are_found_and_damage_ends_the_search(
    tmp_path: Path, content: bytes, samples: int
) -> None:
    path = tmp_path / "boxes.mp4"
    path.write_bytes(box(b"ftyp", b"isom") + content)
    assert declared(path).samples == samples


def test_more_boxes_than_any_camera_writes_are_refused(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("hapticplayer.media.mp4.MAX_BOXES", 1000)
    path = tmp_path / "boxes.mp4"
    path.write_bytes(box(b"free", b"") * 999)
    assert declared(path).samples == 0
    path.write_bytes(clip.read_bytes() + box(b"free", b"") * 1000)
    with pytest.raises(MediaError, match=r"boxes\.mp4: it has more than 1000 boxes"):
        open_media(path)


def test_boxes_of_a_file_are_stepped_over_once(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "boxes.mp4"
    path.write_bytes(clip.read_bytes() + box(b"free", b"") * 100)
    seen: list[object] = []
    real = opening.declared
    monkeypatch.setattr(opening, "declared", lambda one: seen.append(one) or real(one))
    for _ in range(3):
        open_media(path).close()
    assert len(seen) == 1
    path.write_bytes(bytes(8) + clip.read_bytes())
    with pytest.raises(MediaError):
        open_media(path)
    assert len(seen) == 2


def test_a_box_is_no_longer_than_the_one_it_is_in(tmp_path: Path) -> None:
    """Its length hid what follows, of which FFmpeg would read the table."""
    too_long = struct.pack(">I4s", 10_000, b"free")
    table = nested(b"moov", b"trak", content=box(b"stsz", struct.pack(">III", 0, 1, 7)))
    path = tmp_path / "boxes.mp4"
    path.write_bytes(box(b"ftyp", b"isom") + box(b"moov", too_long) + table)
    assert declared(path) == (7, path.stat().st_size)


def test_an_index_beyond_the_limit_is_not_listed(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "camera.mp4"
    add_telemetry(clip, path, [TelemetryPacket(t, 1.0, b"1234") for t in range(5)])
    monkeypatch.setattr(module, "MAX_TELEMETRY_PACKETS", 4)
    monkeypatch.setattr(module, "read_only", None)
    with pytest.raises(MediaError, match="telemetry is larger"):
        read_telemetry_packets(path)
