"""What each format of force costs: kbit/s, error and time; and how well curves are thinned.

Force tracks: a drone's GoPro (`../shared/data/capture/gopro/karma.mp4`, where it is) and
simulated rides. Each is written, read back and compared at every millisecond; times are
those of the processor, the best of three, per minute of force. Thinning: ours and Ramer-
Douglas-Peucker at the same tolerance, and the error that is felt: differences below 8 % of
the force or 0.03 N count nothing. Published figures of the reference software on another
recording of the same kind (12 s, three axes, 199 Hz) stand beside.
"""

import argparse
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import DATA, Report, on_one_thread
from benchmarks.haptics.washout import ride_force
from hapticplayer.capture import read_recording
from hapticplayer.extras.formats.thinning import thin
from hapticplayer.model import ForceTrack, Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import remove_gravity
from hapticplayer.rendering import render_force
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    read_formats,
    written_formats,
)
from hapticplayer.sequence.milliseconds import Ticks, corners, end_ms

RIDES = ("bike", "car-turning", "horse")
SECONDS, MOST_FELT_N = 60.0, 0.01
TOLERANCES_N = (0.001, 0.003, 0.01, 0.03, 0.06, 0.1, 0.2)
SHARE, LEAST_N = 0.08, 0.03


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, default=SECONDS)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure all formats, then the thinning."""
    on_one_thread()
    seconds = 12.0 if options.quick else options.seconds
    tracks = {name: ride_force(name, 0, seconds) for name in RIDES}
    recording = DATA / "capture" / "gopro" / "karma.mp4"
    if recording.is_file():
        motion = remove_gravity(read_recording(recording).imu)
        tracks = {"karma": render_force(motion, Mapping()), **tracks}
    else:
        print(f"left out: {recording} is not there")
    costs = {
        name: {kind: cost(track, kind) for kind in written_formats()}
        for name, track in tracks.items()
    }
    header = ["format", "kbit/s", "compressed", "RMS N", "largest N"]
    header += ["write s/min", "read s/min"]
    for name, each in costs.items():
        rows = [[kind, *one.values()] for kind, one in each.items()]
        report.table(name, header, rows)
        for kind in ("hjif", "mpegv", "ahap"):
            largest = each[kind]["error_max_n"]
            report.target(f"{kind}, {name}: largest N", largest, ("<=", 0.01002))
    thinned = {name: thinning(track) for name, track in tracks.items()}
    report.figures |= {"costs": costs, "thinning": thinned}
    columns = ["tolerance N", "ours kbit/s", "RDP kbit/s", "RMS N"]
    columns += ["RDP RMS N", "felt RMS N"]
    for name, rows in thinned.items():
        report.table(f"Thinning, {name}", columns, [list(one.values()) for one in rows])
        at = next(one for one in rows if one["tolerance_n"] == 0.01)
        ratio = at["kbit_s"] / at["rdp_kbit_s"]
        report.target(f"thinning, {name}: of RDP at 0.01 N", ratio, ("<=", 0.9))
        report.target(f"felt at 0.01 N, {name}: N", at["felt_rms_n"], ("<=", 0.0))


def cost(track: ForceTrack, kind: str) -> dict[str, Any]:
    """Write a track and read it back."""
    form, writing, reading = written_formats()[kind], [], []
    minutes = end_ms(track, None) / 60_000.0
    with tempfile.TemporaryDirectory() as folder:
        found: dict[str, Any] = {}
        for turn in range(3):
            path = Path(folder) / f"{turn}{form.suffix}"
            assert form.write is not None
            begin_s = time.process_time()
            with path.open("xb") as out:
                form.write(track, out, WriteChoices())
            writing.append(time.process_time() - begin_s)
            if kind in read_formats():
                begin_s = time.process_time()
                assert form.read is not None
                form.read(path, ReadChoices())
                reading.append(time.process_time() - begin_s)
        found = export_track(track, Path(folder) / "last", form, WriteChoices())
    keys = ("kbit_s", "kbit_s_compressed", "error_rms_n", "error_max_n")
    times = [min(one) / minutes if one else None for one in (writing, reading)]
    return {
        **{key: found[key] for key in keys},
        **dict(zip(("write_s_min", "read_s_min"), times, strict=True)),
    }


def thinning(track: ForceTrack) -> list[dict[str, float]]:
    """Return rate and error at each tolerance; a keyframe is 62 bytes of hjif."""
    until_ms = end_ms(track, None)
    ticks, force_n = corners(track, 0, until_ms)
    at_ms = np.arange(until_ms)
    exact_n = track.at(at_ms / 1000.0)
    rows = []
    for tolerance_n in TOLERANCES_N:
        axis_n = tolerance_n / np.sqrt(3.0)
        ours = [thin(ticks, axis, axis_n, axis_n / 20.0) for axis in force_n.T]
        theirs = [peucker(ticks, axis, axis_n) for axis in force_n.T]
        chords_n = [
            np.interp(at_ms, ticks[kept], axis[kept])
            for kept, axis in zip(theirs, force_n.T, strict=True)
        ]
        chords_error_n = np.linalg.norm(np.stack(chords_n, axis=1) - exact_n, axis=1)
        back_n = np.stack([np.interp(at_ms, *one) for one in ours], axis=1)
        size_n = np.linalg.norm(back_n - exact_n, axis=1)
        deadband_n = np.maximum(SHARE * np.linalg.norm(exact_n, axis=1), LEAST_N)
        felt_n = np.maximum(size_n - deadband_n, 0.0)
        rate = 62 * 8 / until_ms
        rows.append(
            {
                "tolerance_n": tolerance_n,
                "kbit_s": rate * sum(len(one[0]) for one in ours),
                "rdp_kbit_s": rate * sum(map(len, theirs)),
                "rms_n": float(np.sqrt(np.mean(size_n**2))),
                "rdp_rms_n": float(np.sqrt(np.mean(chords_error_n**2))),
                "felt_rms_n": float(np.sqrt(np.mean(felt_n**2))),
            }
        )
    return rows


def peucker(ticks: Ticks, values: Floats, tolerance: float) -> list[int]:
    """Return the corners of Ramer-Douglas-Peucker with vertical distances."""
    kept, open_spans = {0, len(ticks) - 1}, [(0, len(ticks) - 1)]
    while open_spans:
        first, last = open_spans.pop()
        if last - first < 2:
            continue
        inside = slice(first + 1, last)
        line = np.interp(ticks[inside], ticks[[first, last]], values[[first, last]])
        away = np.abs(values[inside] - line)
        worst = int(np.argmax(away))
        if away[worst] > tolerance:
            middle = first + 1 + worst
            kept.add(middle)
            open_spans += [(first, middle), (middle, last)]
    return sorted(kept)
