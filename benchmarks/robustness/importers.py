"""Importers of motion logs: damaged logs, logs of ten hours, a camera clip of 700 MB.

Each format is damaged 200 times (a real camera's clip as well, where it is at hand):
it must be read, or refused or asked about in one sentence, within 10 s and 1 GB. Ten
hours at 100 Hz in each format, read by a process of its own. The clip holds telemetry
beside frames that are never decoded; the best of five readings after one that loads the
libraries, and the bytes that were read from it.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.campaign import campaign
from benchmarks.common import Report

TESTS = "tests/faults/test_campaigns.py::"
CLIP_MB = 700.0
CLIP_LENGTHS_S = (112.0, 2580.0)
"""50 Mbit/s, what cameras write, and the 43 min of another program's test file."""
READINGS = 5
MAX_CLIP_S, MAX_CLIP_READ_MB = 0.2, 120.0


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--part", nargs="+", choices=PARTS, default=list(PARTS))
    parser.add_argument("--only", default="", help="formats with this word")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the parts."""
    for part in options.part:
        report.figures[part] = PARTS[part](options, report)


def damaged(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Damage logs of 8 s."""
    test, share = f"{TESTS}test_damaged_logs", 0.02 if options.quick else 1.0
    cases = campaign(report, test, share=share, only=options.only)
    keys = ("read", "refused", "asked", "longest_s", "peak_mb")
    rows = [[case.name, *(case.figures.get(k, 0) for k in keys)] for case in cases]
    report.table("Damaged logs", ["format", *keys], rows)
    return {case.name: case.figures for case in cases}


def ten_hours(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Read long logs."""
    test, share = f"{TESTS}test_logs_of_ten_hours", 0.01 if options.quick else 1.0
    cases = campaign(report, test, share=share, only=options.only)
    keys = ("mb", "samples", "s", "cpu_s", "peak_mb")
    rows = [[case.name, *(case.figures.get(k, "-") for k in keys)] for case in cases]
    report.table("Ten hours at 100 Hz", ["format", *keys], rows)
    return {case.name: case.figures for case in cases}


def clips(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Read the telemetry of a large clip without its frames."""
    figures: dict[str, Any] = {}
    size_mb = 0.05 * CLIP_MB if options.quick else CLIP_MB
    for length_s in CLIP_LENGTHS_S[:1] if options.quick else CLIP_LENGTHS_S:
        with tempfile.TemporaryDirectory(prefix="hp-importers-") as folder:
            path = Path(folder) / "clip.mp4"
            _write_clip(path, length_s, size_mb)
            command = [sys.executable, "-c", _READER, str(path), str(READINGS)]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
        found = figures[f"{length_s:.0f} s"] = json.loads(done.stdout)
        report.target(f"clip of {length_s:.0f} s: s", found["s"], ("<=", MAX_CLIP_S))
        what, limit = f"clip of {length_s:.0f} s: MB read", ("<=", MAX_CLIP_READ_MB)
        report.target(what, found["read_mb"], limit)
    rows = [[name, *found.values()] for name, found in figures.items()]
    report.table(
        f"Clip of {size_mb:.0f} MB",
        ["length", "samples", "s", "CPU s", "MB read"],
        rows,
    )
    return figures


PARTS: dict[str, Callable[[argparse.Namespace, Report], dict[str, Any]]] = {
    "clips": clips,
    "damaged": damaged,
    "ten-hours": ten_hours,
}

_READER = """
import json, sys, time
from hapticplayer.capture import read_recording
def read_bytes():
    lines = open("/proc/self/io").read().splitlines()
    return int(next(line for line in lines if line.startswith("rchar")).split()[1])
read_recording(sys.argv[1])  # loads the libraries
wall, cpu, size = [], [], []
for _ in range(int(sys.argv[2])):
    marks = read_bytes(), time.perf_counter(), time.process_time()
    samples = len(read_recording(sys.argv[1]).imu)
    size.append((read_bytes() - marks[0]) / 1e6)
    wall.append(time.perf_counter() - marks[1])
    cpu.append(time.process_time() - marks[2])
print(json.dumps(dict(samples=samples, s=min(wall), cpu_s=min(cpu), read_mb=max(size))))
"""


def _write_clip(path: Path, length_s: float, size_mb: float) -> None:
    """Mux frames that hold noise, and telemetry of a camera that moves."""
    import av
    from av.packet import Packet

    from hapticplayer.media.encode import write_clip
    from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry

    small, mixed = path.with_suffix(".small.mp4"), path.with_suffix(".mixed.mp4")
    grey = [np.full((48, 64, 3), 9 * k, np.uint8) for k in range(2)]
    write_clip(small, grey, frame_rate_hz=30.0)
    add_telemetry(
        small, mixed, [TelemetryPacket(t, 1.0, p) for t, p in _payloads(length_s)]
    )
    count = round(30 * length_s)
    noise = np.random.default_rng(1).bytes(int(1e6 * size_mb) // count)
    with av.open(str(mixed)) as source, av.open(str(path), "w") as target:
        video = target.add_stream_from_template(source.streams.video[0])
        data = target.add_stream_from_template(source.streams.data[0])
        data.metadata.update(source.streams.data[0].metadata)
        base = source.streams.video[0].time_base
        telemetry = iter([p for p in source.demux(source.streams.data[0]) if p.size])
        for number in range(count):
            packet = Packet(noise)
            packet.stream, packet.time_base = video, base
            packet.pts = packet.dts = round(number / 30.0 / base)
            packet.duration = round(1 / 30.0 / base)
            packet.is_keyframe = number % 30 == 0
            target.mux(packet)
            if number % 30 == 0 and (one := next(telemetry, None)) is not None:
                one.stream = data
                target.mux(one)
    small.unlink()
    mixed.unlink()


def _payloads(length_s: float) -> Any:
    """Return what a camera at 200 Hz writes each second."""
    from hapticplayer.simulation.rides.gpmf_writer import write_payloads
    from hapticplayer.simulation.rides.motion_scenes import simulate_motion

    ride = simulate_motion("handheld-brisk", 1, duration_s=length_s)
    return write_payloads(ride.imu)
