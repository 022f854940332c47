"""A few bytes that declare millions of samples are refused before room is made."""

import struct
from pathlib import Path

import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media import telemetry as module
from hapticplayer.media.opening import declared_samples, open_media
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
    assert declared_samples(clip) == samples > 0


def test_a_bomb_is_refused_before_it_is_opened(
    bomb: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert declared_samples(bomb) >= 40_000_000
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
    assert declared_samples(path) == samples


def test_boxes_without_end_are_too_many(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("hapticplayer.media.opening.MAX_BOXES", 50)
    path = tmp_path / "boxes.mp4"
    path.write_bytes(box(b"free", b"") * 50)
    assert declared_samples(path) == 0
    path.write_bytes(box(b"free", b"") * 51)
    assert declared_samples(path) > path.stat().st_size


def test_an_index_beyond_the_limit_is_not_listed(
    tmp_path: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "camera.mp4"
    add_telemetry(clip, path, [TelemetryPacket(t, 1.0, b"1234") for t in range(5)])
    monkeypatch.setattr(module, "MAX_TELEMETRY_PACKETS", 4)
    monkeypatch.setattr(module, "read_only", None)
    with pytest.raises(MediaError, match="telemetry is larger"):
        read_telemetry_packets(path)
