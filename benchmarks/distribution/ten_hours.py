"""Ten hours of force in every format: memory and time to write it and to read it back.

A second of vibration (200 Hz, 1 N RMS on each axis) in each minute. Each format is written,
compared and read back by a process of its own, whose largest memory counts; a format may
refuse the track in a sentence instead. Of a ride (200 Hz from beginning to end) the export as
CSV is measured, by what it takes beside the track: a table of ten hours has 36 million rows.
"""

import argparse
import multiprocessing
import resource
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import Report
from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack
from hapticplayer.sequence.force_files import WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    read_force,
    read_formats,
    written_formats,
)

HOURS, MOST_MB = 10.0, 350.0
MOST_BESIDE_MB = 100.0


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--hours", type=float, default=HOURS)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure each format."""
    hours = 0.5 if options.quick else options.hours
    context = multiprocessing.get_context("spawn")
    rows: list[list[Any]] = []
    for name in written_formats():
        with context.Pool(1) as pool:
            found = pool.apply(measured, (name, hours))
        rows.append([name, *found.values()])
        report.figures[name] = found
        report.target(f"{name}: largest memory, MB", found["peak_mb"], ("<=", MOST_MB))
        if found["refused"] is None:
            is_kept = found["error_max_n"] is None or found["error_max_n"] <= 0.01002
            report.target(f"{name}: within its tolerance (1)", int(is_kept), (">=", 1))
    with context.Pool(1) as pool:
        found = pool.apply(ride_as_csv, (hours,))
    report.figures["ride, csv"] = found
    rows.append(["ride, csv", found["write_s"], None, found["mb"], found["error_max_n"],
                 found["peak_mb"], None])  # fmt: skip
    report.target(
        "ride as csv: memory beside the track, MB",
        found["beside_mb"],
        ("<=", MOST_BESIDE_MB),
    )
    header = ["format", "write s", "read s", "MB of file", "largest N"]
    report.table(f"{hours:g} h", [*header, "largest memory MB", "refused"], rows)


def measured(name: str, hours: float) -> dict[str, Any]:
    """Write, compare and read back in this process."""
    track, form = bursts(hours), written_formats()[name]
    found: dict[str, Any] = dict.fromkeys(("write_s", "read_s", "mb", "error_max_n"))
    refused = None
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"track{form.suffix}"
        begin_s = time.monotonic()
        try:
            cost = export_track(track, path, form, WriteChoices())
            found["write_s"] = time.monotonic() - begin_s
            found |= {"mb": 1e-6 * cost["bytes"], "error_max_n": cost["error_max_n"]}
            if name in read_formats():
                begin_s = time.monotonic()
                read_force(path)
                found["read_s"] = time.monotonic() - begin_s
        except InputError as error:
            refused = str(error)
    peak_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return {**found, "peak_mb": peak_mb, "refused": refused}


def ride_as_csv(hours: float) -> dict[str, float]:
    """Export a ride without a pause in this process."""
    time_s = np.arange(round(720_000 * hours)) / 200.0
    force_n = np.random.default_rng(0).normal(0.0, 1.0, (len(time_s), 3))
    track = ForceTrack(time_s, force_n.astype(np.float32))
    del force_n
    before_mb = memory_mb("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")  # the largest is counted from here
    with tempfile.TemporaryDirectory() as folder:
        begin_s = time.monotonic()
        cost = export_track(
            track, Path(folder) / "ride.csv", written_formats()["csv"], WriteChoices()
        )
        write_s = time.monotonic() - begin_s
    peak_mb = memory_mb("VmHWM")
    return {
        "write_s": write_s,
        "mb": 1e-6 * cost["bytes"],
        "error_max_n": cost["error_max_n"],
        "peak_mb": peak_mb,
        "beside_mb": peak_mb - before_mb,
    }


def memory_mb(name: str) -> float:
    """A figure of this process."""
    lines = Path("/proc/self/status").read_text().splitlines()
    line = next(one for one in lines if one.startswith(name))
    return float(line.split()[1]) / 1024.0


def bursts(hours: float) -> ForceTrack:
    """Return a second of vibration in each minute."""
    minutes = round(60.0 * hours)
    burst_s = np.arange(201) / 200.0
    time_s = (60.0 * np.arange(minutes)[:, None] + burst_s).ravel()
    force_n = np.random.default_rng(0).normal(0.0, 1.0, (minutes, 201, 3))
    force_n[:, [0, -1]] = 0.0
    return ForceTrack(time_s, force_n.reshape(-1, 3).astype(np.float32))
