import builtins
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.telemetry import (
    TelemetryPacket,
    add_telemetry,
    data_tracks,
    read_telemetry_packets,
)

KARMA = Path(__file__).parents[3].parent / "shared" / "data" / "capture/gopro/karma.mp4"
needs_karma = pytest.mark.skipif(
    not KARMA.exists(), reason="needs ../shared/data/capture/gopro/karma.mp4"
)


@pytest.fixture
def with_telemetry(tmp_path: Path, clip: Path) -> Path:
    path = tmp_path / "camera.mp4"
    packets = [
        TelemetryPacket(1.001 * number, 1.001, bytes([number]) * (100 + number))
        for number in range(5)
    ]
    add_telemetry(clip, path, packets)
    return path


def test_payloads_come_back_with_their_times(with_telemetry: Path) -> None:
    packets = read_telemetry_packets(with_telemetry)
    assert [len(packet.payload) for packet in packets] == [100, 101, 102, 103, 104]
    assert [packet.start_s for packet in packets] == pytest.approx(
        1.001 * np.arange(5), abs=1e-6
    )
    assert packets[0].duration_s == pytest.approx(1.001)
    assert packets[3].payload == bytes([3]) * 103


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs the program ffmpeg")
@pytest.mark.parametrize(
    "options",
    [
        ("-movflags", "faststart"),
        ("-movflags", "frag_keyframe+empty_moov"),
        ("-output_ts_offset", "1.5"),
    ],
    ids=["index first", "fragments", "edit list"],
)
def test_other_layouts_give_the_same(
    with_telemetry: Path, tmp_path: Path, options: tuple[str, ...]
) -> None:
    other = tmp_path / "again.mp4"
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-i", str(with_telemetry)]
    command += ["-map", "0", "-c", "copy", "-copy_unknown", *options, str(other)]
    subprocess.run(command, check=True)
    found, packets = (read_telemetry_packets(p) for p in (other, with_telemetry))
    assert [p.payload for p in found] == [p.payload for p in packets]
    steps_s = np.diff([p.start_s for p in found[1:]])  # ffmpeg moves a first fragment
    assert steps_s == pytest.approx(np.full(3, 1.001), abs=2e-3)


def test_copy_keeps_pictures_and_sound(with_telemetry: Path, clip: Path) -> None:
    before, after = probe(clip), probe(with_telemetry)
    assert after.has_telemetry
    assert not before.has_telemetry
    assert after.duration_s == pytest.approx(before.duration_s, abs=1e-3)
    assert (after.width, after.frame_count) == (before.width, before.frame_count)
    assert after.has_audio
    assert [(t.name, t.mark) for t in data_tracks(with_telemetry)] == [
        ("GoPro MET", "gpmd")
    ]


def test_clip_without_telemetry_gives_no_packets(clip: Path) -> None:
    assert read_telemetry_packets(clip) == []
    assert data_tracks(clip) == ()


@pytest.mark.parametrize(
    ("limit", "value"),
    [
        ("MAX_TELEMETRY_PACKET_BYTES", 103),
        ("MAX_TELEMETRY_BYTES", 509),
        ("MAX_TELEMETRY_PACKETS", 4),
    ],
)
def test_limits_hold_just_above_and_refuse_just_below(
    with_telemetry: Path, monkeypatch: pytest.MonkeyPatch, limit: str, value: int
) -> None:
    name = f"hapticplayer.media.telemetry.{limit}"
    monkeypatch.setattr(name, value)
    with pytest.raises(MediaError, match="telemetry is larger"):
        read_telemetry_packets(with_telemetry)
    monkeypatch.setattr(name, value + 1)
    assert len(read_telemetry_packets(with_telemetry)) == 5


def test_clip_is_not_copied_onto_itself(clip: Path) -> None:
    with pytest.raises(MediaError, match="onto itself"):
        add_telemetry(clip, clip, [])


@needs_karma
def test_karma_holds_13_payloads_of_a_second() -> None:
    packets = read_telemetry_packets(KARMA)
    assert len(packets) == 13
    assert [packet.start_s for packet in packets] == pytest.approx(
        1.001 * np.arange(13), abs=1e-9
    )
    assert all(packet.payload.startswith(b"DEVC") for packet in packets)
    info = probe(KARMA)
    assert info.has_telemetry
    assert (info.width, info.height) == (854, 480)
    assert info.frame_rate_hz == pytest.approx(29.97, abs=0.01)
    assert info.duration_s == pytest.approx(12.08, abs=0.01)


@needs_karma
def test_no_other_file_is_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[Any] = []
    real = builtins.open

    def noted(path: Any, *args: Any, **more: Any) -> Any:
        opened.append(path)
        return real(path, *args, **more)

    monkeypatch.setattr(builtins, "open", noted)
    assert read_telemetry_packets(KARMA)
    assert {path.resolve() for path in opened} == {KARMA.resolve()}
