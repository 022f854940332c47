"""The command `export`: records of the haptic loop for other programs."""

import argparse
import json
from pathlib import Path
from typing import Any

from hapticplayer.cli.common import (
    add_overwrite,
    interruptible,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.interchange.exporters import RECORD_EXPORTERS
from hapticplayer.outputs import FILE, refuse_existing
from hapticplayer.sequence import files


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("record", metavar="RECORD")
    command.add_argument("-o", "--output", required=True, metavar="FILE")
    command.add_argument(
        "--format",
        default="csv",
        choices=RECORD_EXPORTERS,
        help="; ".join(f"{one.name}: {one.text}" for one in RECORD_EXPORTERS.values())
        + " (default: csv)",
    )
    add_overwrite(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Convert a record, showing the progress, and say what is in it."""
    target = Path(options.output)
    exporter = RECORD_EXPORTERS[options.format]
    is_ours = exporter.is_ours if options.overwrite else None
    refuse_existing(target, FILE, is_ours)
    with (
        RecordReader(Path(options.record)) as reader,
        interruptible(),
        shown_progress() as progress,
        files.file_written_aside(target, is_ours) as part,
        part.open("xb") as out,
    ):
        report = exporter.write(reader, out, progress)
    report = {
        "record": str(options.record),
        "output": str(target),
        "format": options.format,
        **report,
    }
    if report["remark"]:
        say_aside(f"{options.record}: {report['remark']}")
    say(json.dumps(report) if options.json else _text(report))
    return 0


def _text(report: dict[str, Any]) -> str:
    header = report["header"]
    made = [str(header[key]) for key in ("started_utc", "device") if key in header]
    duration_s = report["duration_s"]
    return (
        f"{report['output']}: {report['ticks']} ticks"
        + (f" in {duration_s:.1f} s" if duration_s is not None else "")
        + f", {report['lost']} lost"
        + (f" ({', '.join(made)})" if made else "")
    )
