"""Says how good a recording's motion is, compares the methods, draws the result."""

import argparse
import dataclasses
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.mounting import mounted
from hapticplayer.capture.recording import Recording, refuse_gravity_free
from hapticplayer.clock import SystemClock
from hapticplayer.console.quality_text import comparison_text, quality_text
from hapticplayer.console.recordings import (
    chosen_log,
    chosen_mounting,
    chosen_processing,
)
from hapticplayer.console.speech import interruptible, say, shown_progress
from hapticplayer.errors import UsageError
from hapticplayer.model import ClockMap
from hapticplayer.sequence import files
from hapticplayer.sequence.notes import notes_on_motion
from hapticplayer.sequence.processing import Processed, Processing, process_motion
from hapticplayer.sequence.quality import compare_methods, describe_quality
from hapticplayer.sequence.store import DESCRIPTION, read_recorded

PLOT_FORMATS = (".png", ".svg")

Draw = Callable[[Path, Processed, str], None]
"""Draws into a new file; the title is the last argument."""


def process(options: argparse.Namespace, draw: Draw) -> int:
    """Print the quality report of a recording, with what else was asked for.

    Args:
        options: of `hapticplayer process`, see hapticplayer.cli.
        draw: used for `--plot` only.
    """
    plot = plot_target(options)
    processing = chosen_processing(options)
    with interruptible(), shown_progress() as progress:
        progress(0.0, f"reading {Path(options.recording).name}")
        recording = _read(
            Path(options.recording), chosen_log(options), chosen_mounting(options)
        )
        progress(0.3, f"removing gravity: {processing.method}")
        processed = process_motion(recording.imu, processing)
        report = describe_quality(recording, processed)
        report["notes"] = notes_on_motion(processed.imu, processed.summary)
        if options.compare:
            report["methods"] = _compared(processed, processing, progress)
        if plot:
            progress(0.9, f"drawing {plot.name}")
            with files.file_written_aside(plot) as part:
                draw(part, processed, report["recording"]["source"])
    _say(report, processed, options)
    return 0


def plot_target(options: argparse.Namespace) -> Path | None:
    """Return the file to draw, checked before the long work begins."""
    if options.plot is None:
        return None
    target = Path(options.plot)
    if target.suffix.lower() not in PLOT_FORMATS:
        raise UsageError(
            f"--plot {target.name} must end in {' or '.join(PLOT_FORMATS)}"
        )
    files.refuse_existing(target, "file")
    return target


def _read(path: Path, choices: LogChoices, mounting: str) -> Recording:
    """Return the motion of a recording, or of the folder of a sequence."""
    if not (path / DESCRIPTION).is_file():
        recording = read_recording(path, choices)
        refuse_gravity_free(recording)
        turned = mounted(recording.imu, mounting)
        return dataclasses.replace(recording, imu=turned)
    if mounting:
        raise UsageError(f"--mounting is for a recording; {path.name} is a sequence")
    imu, made_of = read_recorded(path)
    return Recording(imu, ClockMap(), str(made_of.get("camera", "")))


def _compared(
    processed: Processed, processing: Processing, progress: files.Progress
) -> list[dict[str, Any]]:
    rows = []
    progress(0.4, "comparing the methods")
    for row in compare_methods(processed.imu, processing, SystemClock()):
        rows.append(dataclasses.asdict(row))
        progress(min(0.85, 0.4 + 0.1 * len(rows)), f"compared {row.method}")
    return rows


def _say(
    report: dict[str, Any], processed: Processed, options: argparse.Namespace
) -> None:
    if options.json:
        say(json.dumps(report, ensure_ascii=False, allow_nan=False))
        return
    say(quality_text(report))
    if options.compare:
        say("\n" + comparison_text(report["methods"], processed.summary["method"]))
    if options.plot:
        say(f"\ndrawn: {options.plot}")
