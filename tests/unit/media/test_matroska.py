"""Attachments are found by their elements, within limits, whatever the file says."""

import contextlib
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media import matroska
from hapticplayer.media.matroska import Attachment, read_attachments
from hapticplayer.media.remux import MATROSKA, Additions, remux, write_attachments

FILES = (
    Attachment("marker.json", "application/json", b'{"a": 1}'),
    Attachment("f\u00fcnf.npz", "application/octet-stream", bytes(range(256)) * 40),
)


@pytest.fixture
def carrier(clip: Path, tmp_path: Path) -> Path:
    path = tmp_path / "carrier.mkv"
    remux(clip, path, MATROSKA, Additions(FILES))
    return path


def test_attachments_come_back(carrier: Path, tmp_path: Path) -> None:
    assert read_attachments(carrier, "marker.json") == list(FILES)
    write_attachments(tmp_path / "alone.mkv", FILES)
    assert read_attachments(tmp_path / "alone.mkv", "marker.json") == list(FILES)


def test_without_the_marker_nothing_is_read(carrier: Path, clip: Path) -> None:
    assert read_attachments(carrier, "other.json") == []
    assert read_attachments(clip, "marker.json") == []


@pytest.mark.skipif(not shutil.which("mkvmerge"), reason="needs mkvtoolnix")
def test_attachments_that_mkvmerge_wrote_are_read(clip: Path, tmp_path: Path) -> None:
    source, made = tmp_path / "marker.json", tmp_path / "made.mkv"
    source.write_bytes(FILES[0].content)
    how = ["--attachment-mime-type", "application/json", "--attach-file", str(source)]
    words = ["mkvmerge", "-q", "-o", str(made), *how, str(clip)]
    subprocess.run(words, check=True)
    assert read_attachments(made, "marker.json") == [FILES[0]]


@pytest.mark.parametrize(("limit", "value"), [("BYTES", 10_000), ("FILES", 1)])
def test_more_than_the_limits_is_refused(
    carrier: Path, monkeypatch, limit: str, value: int
) -> None:
    monkeypatch.setattr(matroska, f"MAX_ATTACHED_{limit}", value)
    monkeypatch.setattr(matroska, "_content", lambda *_: b"marker.json")
    with pytest.raises(MediaError, match="attachments are too large"):
        read_attachments(carrier, "marker.json")


def test_a_size_beyond_the_file_is_not_believed(carrier: Path) -> None:
    content = bytearray(carrier.read_bytes())
    at = content.index(FILES[1].content) - 2  # the two bytes of its size
    content[at : at + 2] = b"\x7f\xfe"
    carrier.write_bytes(content)
    found = read_attachments(carrier, "marker.json")
    assert found[0] == FILES[0]
    assert found[1].content == b""


def test_a_live_stream_of_unknown_sizes_is_walked(tmp_path: Path) -> None:
    """Segment and cluster without a size, then the attachments."""
    unknown = b"\x01" + b"\xff" * 7
    alone = tmp_path / "alone.mkv"
    write_attachments(alone, FILES)
    content = alone.read_bytes()
    begin = content.index(b"\x18\x53\x80\x67")
    attached = content[content.index(b"\x19\x41\xa4\x69", begin + 200) :]
    cluster = b"\x1f\x43\xb6\x75" + unknown + b"\xe7\x81\x00" + b"\xa3\x84\x81\0\0\0"
    live = content[: begin + 4] + unknown + cluster + attached
    alone.write_bytes(live)
    assert read_attachments(alone, "marker.json") == list(FILES)


def test_any_damage_gives_files_or_a_sentence(carrier: Path, rng) -> None:
    """Here the first 12 kB, where all elements are; `faults` plays damaged files."""
    whole = carrier.read_bytes()[:12_000]
    for _ in range(300):
        damaged = bytearray(whole)
        for _ in range(int(rng.integers(1, 8))):
            damaged[int(rng.integers(len(whole)))] = int(rng.integers(256))
        cut = int(rng.integers(len(whole))) if rng.random() < 0.2 else len(whole)
        carrier.write_bytes(damaged[:cut])
        with contextlib.suppress(MediaError):
            found = read_attachments(carrier, "marker.json")
            assert sum(len(one.content) for one in found) <= len(whole)


def test_random_bytes_after_the_header_end_the_walk(carrier: Path) -> None:
    noise = np.random.default_rng(3).integers(0, 256, 5000).astype(np.uint8).tobytes()
    carrier.write_bytes(carrier.read_bytes()[:60] + noise)
    assert read_attachments(carrier, "marker.json") == []
