"""Any other table of numbers, or a table for each sensor: a person names the columns.

Separator, decimal sign and header lines are detected, a semicolon behind each row (data
set SisFall) is passed over; columns and units are not guessed. The answers can be saved
as a template (`choices`) for all logs of the same logger.
"""

from typing import NamedTuple

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    FIELD_UNITS,
    RATE_UNITS,
    TIME_UNITS,
    LogChoices,
    LogQuestion,
    factor,
)
from hapticplayer.capture.csv_table import Numbers, Shape, head_lines, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import NANO, RawLog, SensorStream, split_sensors
from hapticplayer.errors import Message, UsageError, joined
from hapticplayer.model.arrays import Floats

_MIN_COLUMNS = 4
_SAMPLE_LINES = 60
_SENSORS = {
    "accel": ("ax", "ay", "az"),
    "rate": ("gx", "gy", "gz"),
    "field": ("mx", "my", "mz"),
}
_TIME, _SKIP, _BETWEEN_TABLES = "time", "-", "/"


class _Layout(NamedTuple):
    """The layout of a table."""

    separator: str
    decimal: str
    width: int
    header: tuple[str, ...]
    skip_lines: int


def recognises(source: LogSource) -> Confidence:
    """Tables of at least four columns of numbers below any header, and nothing else."""
    return Confidence.POSSIBLE if _layouts(source) else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the log in one table, or in one for each sensor."""
    layouts = _layouts(source)
    where = str(source.path)
    if not layouts:
        raise UsageError(
            "{file}: is not a table of numbers; choose another log", file=where
        )
    columns = _columns(choices, list(layouts.values()), where)
    choices.take("columns")
    _ask_units(choices, {name for names in columns for name in names}, where)
    streams: dict[str, SensorStream] = {}
    notes: list[str] = []
    first_origin: int | None = None
    for (name, layout), named in zip(layouts.items(), columns, strict=True):
        numbers, time_s, parts = _read_table(source, name, layout, named, choices)
        if first_origin is None:
            first_origin = numbers.origin
        time_s += (numbers.origin - first_origin) * NANO
        streams |= split_sensors(time_s, parts)
        notes += [
            note if len(layouts) == 1 else f"{name}: {note}" for note in numbers.notes
        ]
    return RawLog(
        name=Message("CSV with chosen columns"),
        accel=streams["accel"],
        rate=streams["rate"],
        field=streams.get("field"),
        accel_unit=choices.accel_unit,
        rate_unit=choices.rate_unit,
        field_unit=choices.field_unit or "uT",
        notes=tuple(notes),
    )


def _read_table(
    source: LogSource,
    name: str,
    layout: _Layout,
    columns: tuple[str, ...],
    choices: LogChoices,
) -> tuple[Numbers, Floats, dict[str, Floats]]:
    """Return the numbers, the times and the sensors of one table."""
    at = {column: number for number, column in enumerate(columns) if column != _SKIP}
    time_unit = (choices.take("time_unit") if _TIME in at else "") or "s"
    integer = at[_TIME] if time_unit == "ns" and _TIME in at else None
    numbers = read_table(
        source,
        name,
        Shape(
            layout.width,
            tuple(at.values()),
            layout.separator,
            layout.decimal,
            integer,
            layout.skip_lines,
            marks=() if layout.separator == ";" else ((b";\n", b"\n"),),
        ),
    )
    place = {column: number for number, column in enumerate(at)}
    parts = {
        kind: numbers.values[:, [place[axis] for axis in axes]]
        for kind, axes in _SENSORS.items()
        if axes[0] in place
    }
    return numbers, _times(numbers.values, place, choices, time_unit), parts


def _columns(
    choices: LogChoices, layouts: list[_Layout], where: str
) -> list[tuple[str, ...]]:
    """Return the name of each column of each table, checked."""
    if not choices.columns.replace(",", "").strip():
        raise _question(layouts, where)
    columns = [
        tuple(c.strip().lower() for c in part.split(",") if c.strip())
        for part in choices.columns.split(_BETWEEN_TABLES)
    ]
    if fault := _fault(columns, layouts, choices):
        raise UsageError(
            "{file}: columns={columns} {fault}",
            file=where,
            columns=choices.columns,
            fault=fault,
        )
    return columns


def _question(layouts: list[_Layout], where: str) -> LogQuestion:
    if len(layouts) == 1:
        return LogQuestion(
            Message(
                "is a table of {count} columns ({shown}) without a description",
                count=layouts[0].width,
                shown=_shown(layouts[0]),
            ),
            (Message("columns=time,ax,ay,az,gx,gy,gz (- to ignore a column)"),),
            where,
        )
    return LogQuestion(
        Message(
            "are {count} tables ({shown}) without a description",
            count=len(layouts),
            shown=joined("; ", [_shown(layout) for layout in layouts]),
        ),
        (
            Message(
                "columns=time,ax,ay,az/time,gx,gy,gz (/ between the tables, - to "
                "ignore a column)"
            ),
        ),
        where,
    )


def _shown(layout: _Layout) -> str:
    return layout.separator.join(layout.header)[:120] or Message("without names")


def _fault(
    columns: list[tuple[str, ...]], layouts: list[_Layout], choices: LogChoices
) -> str:
    """The fault in the names of the columns, or ""."""
    if len(columns) != len(layouts):
        return Message(
            "describes {count} of {total} tables (/ between them)",
            count=len(columns),
            total=len(layouts),
        )
    named = [name for names in columns for name in names if name not in {_TIME, _SKIP}]
    missing = [
        axis for axis in _SENSORS["accel"] + _SENSORS["rate"] if axis not in named
    ]
    if not (choices.rate_hz or all(_TIME in names for names in columns)):
        missing.insert(0, Message("{time} (or rate-hz=100)", time=_TIME))
    faults = [
        _misfit(names, layout) for names, layout in zip(columns, layouts, strict=True)
    ]
    is_twice = any(names.count(_TIME) > 1 for names in columns)
    if is_twice or len(set(named)) != len(named):
        faults.append(Message("names a column twice"))
    if missing:
        faults.append(Message("lacks {missing}", missing=joined(", ", missing)))
    faults += [
        Message("names a part of {axes}", axes=", ".join(axes))
        for names in columns
        for axes in _SENSORS.values()
        if 0 < len(set(axes) & set(names)) < len(axes)
    ]
    return next((fault for fault in faults if fault), "")


def _misfit(names: tuple[str, ...], layout: _Layout) -> str:
    """Return why names do not fit the columns of a table, or ""."""
    if len(names) != layout.width:
        return Message(
            "names {count} columns, the table has {total} ({shown})",
            count=len(names),
            total=layout.width,
            shown=_shown(layout),
        )
    known = {_TIME, _SKIP, *(axis for axes in _SENSORS.values() for axis in axes)}
    unknown = [name for name in names if name not in known]
    return (
        Message("has the unknown name {unknown!r}", unknown=unknown[0])
        if unknown
        else ""
    )


def _ask_units(choices: LogChoices, columns: set[str], where: str) -> None:
    """Ask for all missing units."""
    wanted = []
    if _TIME in columns and not choices.time_unit:
        wanted.append(f"time-unit={'|'.join(TIME_UNITS)}")
    if not choices.accel_unit:
        wanted.append(f"accel-unit={'|'.join(ACCEL_UNITS)}")
    if not choices.rate_unit:
        wanted.append(f"rate-unit={'|'.join(RATE_UNITS)}")
    if "mx" in columns and not choices.field_unit:
        wanted.append(f"field-unit={'|'.join(FIELD_UNITS)}")
    if wanted:
        raise LogQuestion(
            Message("its units are not known"),
            (joined(Message(" and "), wanted),),
            where,
        )


def _times(
    values: Floats, place: dict[str, int], choices: LogChoices, unit: str
) -> Floats:
    if _TIME not in place:
        rate_hz = choices.take_rate_hz()
        assert rate_hz is not None  # checked by _columns
        return np.arange(len(values)) / rate_hz
    with np.errstate(all="ignore"):
        time_s = values[:, place[_TIME]] * factor(unit, TIME_UNITS, "time-unit")
    return np.asarray(time_s)


def _layouts(source: LogSource) -> dict[str, _Layout]:
    """Return the layouts of the tables of a source, {} if it holds anything else."""
    if len(source.names) > len(_SENSORS):
        return {}
    found = {name: _layout(source, name) for name in source.names}
    held = {name: layout for name, layout in found.items() if layout is not None}
    return held if len(held) == len(found) else {}


def _layout(source: LogSource, name: str) -> _Layout | None:
    """Return the layout of a table, or None."""
    lines = head_lines(source, name)
    for separator, decimal in (
        (",", "."),
        (";", "."),
        (";", ","),
        ("\t", "."),
        ("\t", ","),
    ):
        for number, line in enumerate(lines[:_SAMPLE_LINES]):
            width = _width(line, separator, decimal)
            if width < _MIN_COLUMNS:
                continue
            rows = [_width(text, separator, decimal) for text in lines[number:] if text]
            if rows.count(width) < max(2, 0.8 * len(rows)):
                break
            header = lines[number - 1].split(separator) if number else []
            names = tuple(cell.strip().strip('"') for cell in header)
            return _Layout(separator, decimal, width, names, number)
    return None


def _width(line: str, separator: str, decimal: str) -> int:
    """Return how many numbers a line has, 0 if it has anything else."""
    if not line.strip() or not line.isascii():
        return 0
    text = line.replace('"', "")
    if separator != ";":
        text = text.rstrip().removesuffix(";")
    text = text.replace(",", ".") if decimal == "," else text
    cells = [cell.strip() for cell in text.split(separator)]
    held = 0
    for cell in cells:
        try:
            held += bool(cell) and "_" not in cell and np.isfinite(float(cell))
        except ValueError:
            return 0
    return len(cells) if held >= min(_MIN_COLUMNS, len(cells)) else 0


READER = log_reader(recognises, read)
