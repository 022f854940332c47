"""The command `export`: records of the haptic loop for other programs."""

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from hapticplayer.cli.common import interruptible, say, say_aside, shown_progress
from hapticplayer.errors import UsageError
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.interchange import record_csv
from hapticplayer.sequence import files


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("record", metavar="RECORD")
    command.add_argument("-o", "--output", required=True, metavar="FILE")
    command.add_argument(
        "--format",
        default="csv",
        metavar="FORMAT",
        help="csv: a line per tick with the units in the names (default)",
    )
    command.add_argument("--json", action="store_true", help="print a report as JSON")


FORMATS = ("csv",)
CHUNK_TICKS = 1 << 14


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Convert a record, showing the progress, and say what is in it."""
    if options.format not in FORMATS:
        raise UsageError(
            f"there is no format {options.format!r}; there is {', '.join(FORMATS)}"
        )
    target = Path(options.output)
    files.refuse_existing(target, "file")
    with (
        RecordReader(Path(options.record)) as reader,
        interruptible(),
        shown_progress() as progress,
        files.file_written_aside(target) as part,
        part.open("xb") as out,
    ):
        report = write_csv(reader, out, progress)
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


def write_csv(
    reader: RecordReader, out: BinaryIO, progress: files.Progress
) -> dict[str, Any]:
    """Write all intact ticks as CSV, and return what a person wants to know of them.

    Args:
        reader: at its beginning.
        out: gets the text.
        progress: told after each chunk.
    """
    columns = record_csv.columns_of(reader.dtype, reader.header)
    out.write(record_csv.head_line(columns))
    count = 0
    times_s: list[float] = []
    for first, ticks in _chunks(reader):
        out.write(record_csv.lines(first, ticks, columns))
        count += len(ticks)
        if "monotonic_s" in (reader.dtype.names or ()):
            ends_s = ticks["monotonic_s"][[0, -1]].tolist()
            times_s = [times_s[0] if times_s else ends_s[0], ends_s[1]]
        progress(reader.done, "converting")
    duration_s = times_s[1] - times_s[0] if times_s else 0.0
    return {
        "ticks": count,
        "lost": reader.lost,
        "is_complete": reader.is_complete,
        "remark": reader.remark,
        "duration_s": round(duration_s, 6) if np.isfinite(duration_s) else None,
        "columns": [record_csv.TICK_COLUMN, *[column.name for column in columns]],
        "header": {k: v for k, v in reader.header.items() if k != "dtype"},
    }


def _chunks(reader: RecordReader) -> Iterator[tuple[int, NDArray[Any]]]:
    """Yield (number of the first, ticks in a row) in pieces worth formatting."""
    plain = np.dtype((np.void, reader.dtype.itemsize))  # joins much faster
    held: list[NDArray[Any]] = []
    first = count = 0
    for frame in reader.frames():
        if held and (frame.first != first + count or count >= CHUNK_TICKS):
            yield from _cut(first, np.concatenate(held).view(reader.dtype))
            held, count = [], 0
        if not held:
            first = frame.first
        held.append(frame.ticks.view(plain))
        count += len(frame.ticks)
    if held:
        yield from _cut(first, np.concatenate(held).view(reader.dtype))


def _cut(first: int, ticks: NDArray[Any]) -> Iterator[tuple[int, NDArray[Any]]]:
    for begin in range(0, len(ticks), CHUNK_TICKS):
        yield first + begin, ticks[begin : begin + CHUNK_TICKS]


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
