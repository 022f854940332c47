"""The command `export`: sequences, and records of the haptic loop, for other programs."""

import argparse
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from hapticplayer import storage
from hapticplayer.cli.common import (
    add_overwrite,
    refuse_idle,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.cli.force_options import (
    add_writing,
    write_choices,
    written_text,
)
from hapticplayer.errors import Progress, UsageError
from hapticplayer.extension import rows
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.sequence.force_files import NOT_MEASURED
from hapticplayer.sequence.force_formats import (
    format_of,
    loss_line,
    written_formats,
)
from hapticplayer.sequence.force_import import export_force
from hapticplayer.sequence.pack import CONTAINERS
from hapticplayer.storage import FILE, IsOurs, refuse_existing


class RecordExporter(NamedTuple):
    """A format of records.

    Attributes:
        name: for `--format`.
        text: for people.
        write: writes all intact ticks of a record, and returns what to report of them.
        is_ours: recognises its files, to overwrite them.
    """

    name: str
    text: str
    write: Callable[[RecordReader, BinaryIO, Progress], dict[str, Any]]
    is_ours: IsOurs


def record_exporters() -> dict[str, RecordExporter]:
    return {one.name: one for one in rows("record_exporters", RecordExporter)}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    of_records = record_exporters()
    command.add_argument(
        "source",
        metavar="SEQUENCE_OR_RECORD",
        help="a sequence (folder or packed video), of which a force track is written, or a record of "
        "`play --record`, of which every tick is",
    )
    command.add_argument("-o", "--output", required=True, metavar="FILE")
    command.add_argument(
        "--format",
        choices=list(dict.fromkeys([*written_formats(), *of_records])),
        help=f"for a sequence: {written_text()}; for a record: "
        + "; ".join(f"{one.name}: {one.text}" for one in of_records.values())
        + " (default: by the name of FILE; csv for a record)",
    )
    command.add_argument(
        "--feedback",
        metavar="NAME",
        help="force track of a sequence (default: realistic, or estimated where nothing "
        "measured the motion)",
    )
    add_writing(command)
    command.add_argument(
        "--with-motion",
        action="store_true",
        help="with mpegv: also write the motion, as RigidBodyMotion, for motion seats",
    )
    add_overwrite(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Export a sequence, or convert a record."""
    source = Path(options.source)
    if source.is_dir() or source.suffix.lower() in CONTAINERS:
        return _export_sequence(options)
    return _export_record(options)


def _export_sequence(options: argparse.Namespace) -> int:
    """Write a force track of a sequence, and say its size and largest error."""
    target = Path(options.output)
    form = format_of(target, options.format)
    is_ours = form.is_ours if options.overwrite else None
    refuse_existing(target, FILE, is_ours)
    with shown_progress() as progress:
        cost = export_force(
            Path(options.source),
            options.feedback,
            target,
            form.name,
            choices=replace(write_choices(options), with_motion=options.with_motion),
            progress=progress,
        )
    report = {
        "sequence": str(options.source),
        "output": str(target),
        "format": form.name,
        **cost,
    }
    if cost["is_estimated"]:
        say_aside(f"{options.source}: the force was {NOT_MEASURED}")
    say(json.dumps(report) if options.json else f"{target}: {loss_line(cost)}")
    return 0


_OF_A_SEQUENCE = (
    *("--feedback", "--with-motion", "--tolerance", "--sample-rate"),
    "--funscript-version",
)


def _export_record(options: argparse.Namespace) -> int:
    """Convert a record, showing the progress, and say what is in it."""
    refuse_idle(options, "on a record of `play --record`", *_OF_A_SEQUENCE)
    target = Path(options.output)
    name = options.format or _named_by(target) or "csv"
    known = record_exporters()
    if (exporter := known.get(name)) is None:
        raise UsageError(
            "a record is not exported as {name}; choose one of {known}",
            name=name,
            known=", ".join(known),
        )
    is_ours = exporter.is_ours if options.overwrite else None
    refuse_existing(target, FILE, is_ours)
    with (
        RecordReader(Path(options.source)) as reader,
        shown_progress() as progress,
        storage.file_written_aside(target, is_ours) as part,
        part.open("xb") as out,
    ):
        report = exporter.write(reader, out, progress)
    report = {
        "record": str(options.source),
        "output": str(target),
        "format": name,
        **report,
    }
    if report["remark"]:
        say_aside(f"{options.source}: {report['remark']}")
    say(json.dumps(report) if options.json else _text(report))
    return 0


def _named_by(target: Path) -> str:
    """The format that a file's suffix stands for, "" if none."""
    try:
        return format_of(target).name
    except UsageError:
        return ""


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
