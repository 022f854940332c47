"""Payloads that are read where the index says are those that FFmpeg would deliver."""

import shutil
import subprocess
from pathlib import Path

import av
import pytest

from hapticplayer.media import telemetry as module
from hapticplayer.media.telemetry import (
    TelemetryPacket,
    add_telemetry,
    read_telemetry_packets,
)


@pytest.fixture
def camera(tmp_path: Path, clip: Path) -> Path:
    path = tmp_path / "camera.mp4"
    packets = [
        TelemetryPacket(1.001 * number, 1.001, bytes([number + 1]) * (100 + 7 * number))
        for number in range(5)
    ]
    add_telemetry(clip, path, packets)
    return path


def demuxed(path: Path, monkeypatch: pytest.MonkeyPatch) -> list[TelemetryPacket]:
    with monkeypatch.context() as patch:
        patch.setattr(module, "_indexed", lambda _stream: None)
        return read_telemetry_packets(path)


def is_indexed(path: Path) -> bool:
    with av.open(str(path)) as container:
        stream = module.find_telemetry(container)
        assert stream is not None
        return module._indexed(stream) is not None


needs_ffmpeg = pytest.mark.skipif(
    shutil.which("ffmpeg") is None, reason="the program ffmpeg is not installed"
)


def remuxed(path: Path, *options: str) -> Path:
    target = path.with_stem("again")
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-i", str(path)]
    command += ["-map", "0", "-c", "copy", "-copy_unknown", *options, str(target)]
    subprocess.run(command, check=True)
    return target


def test_the_index_gives_what_demuxing_gives(
    camera: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert is_indexed(camera)
    found = read_telemetry_packets(camera)
    assert len(found) == 5
    assert found == demuxed(camera, monkeypatch)


def test_so_it_does_for_a_real_camera(
    shared_data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    karma = shared_data / "capture" / "gopro" / "karma.mp4"
    assert is_indexed(karma)
    assert read_telemetry_packets(karma) == demuxed(karma, monkeypatch)


@needs_ffmpeg
@pytest.mark.parametrize(
    ("options", "has_index"),
    [
        (("-movflags", "faststart"), True),
        (("-movflags", "frag_keyframe+empty_moov"), False),
        (("-output_ts_offset", "1.5"), None),
    ],
    ids=["index first", "fragments", "edit list"],
)
def test_other_layouts_give_the_same(
    camera: Path,
    monkeypatch: pytest.MonkeyPatch,
    options: tuple[str, ...],
    has_index: bool | None,
) -> None:
    other = remuxed(camera, *options)
    if has_index is not None:
        assert is_indexed(other) is has_index
    found = read_telemetry_packets(other)
    assert [one.payload for one in found] == [
        one.payload for one in read_telemetry_packets(camera)
    ]
    assert found == demuxed(other, monkeypatch)


def test_pictures_are_not_read(camera: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What lies around a payload may be damaged: its bytes alone are fetched."""
    wanted = [len(one.payload) for one in read_telemetry_packets(camera)]
    asked: list[int] = []
    pread = module.os.pread

    def watched(number: int, size_bytes: int, place: int) -> bytes:
        asked.append(size_bytes)
        return pread(number, size_bytes, place)

    monkeypatch.setattr(module.os, "pread", watched)
    read_telemetry_packets(camera)
    assert asked == wanted
