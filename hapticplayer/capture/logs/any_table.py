"""Any other table of numbers, whose columns a person names.

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
from hapticplayer.capture.csv_table import Shape, head_lines, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import Source
from hapticplayer.capture.streams import RawLog, split_sensors
from hapticplayer.errors import Message, UsageError, joined
from hapticplayer.model.arrays import Floats

_MIN_COLUMNS = 4
_SAMPLE_LINES = 60
_SENSORS = (("ax", "ay", "az"), ("gx", "gy", "gz"), ("mx", "my", "mz"))
_TIME, _SKIP = "time", "-"


class _Layout(NamedTuple):
    """The layout of a table."""

    separator: str
    decimal: str
    width: int
    header: tuple[str, ...]
    skip_lines: int


def recognises(source: Source) -> Confidence:
    """A table of at least four columns of numbers below any header."""
    if len(source.names) != 1 or _layout(source, source.names[0]) is None:
        return Confidence.NO
    return Confidence.POSSIBLE


def read(source: Source, choices: LogChoices) -> RawLog:
    """Return the log.

    Raises:
        UsageError: asking for missing columns or units.
    """
    name = source.names[0]
    where = source.where(name)
    layout = _layout(source, name)
    if layout is None:
        raise UsageError(
            "{file}: is not a table of numbers; choose another log", file=where
        )
    columns = _columns(choices, layout, where)
    _ask_units(choices, columns, where)
    at = {column: number for number, column in enumerate(columns) if column != _SKIP}
    time_unit = choices.time_unit or "s"
    integer = at[_TIME] if time_unit == "ns" and _TIME in at else None
    wanted = tuple(at.values())
    numbers = read_table(
        source,
        name,
        Shape(
            layout.width,
            wanted,
            layout.separator,
            layout.decimal,
            integer,
            layout.skip_lines,
            marks=() if layout.separator == ";" else ((b";\n", b"\n"),),
        ),
    )
    place = {column: number for number, column in enumerate(at)}
    values = numbers.values
    time_s = _times(values, place, choices, time_unit)
    parts = [
        values[:, [place[axis] for axis in sensor]] if sensor[0] in place else None
        for sensor in _SENSORS
    ]
    assert parts[0] is not None  # checked by _columns
    accel, rate, field = split_sensors(time_s, parts[0], *parts[1:])
    return RawLog(
        name=Message("CSV with chosen columns"),
        accel=accel,
        rate=rate,
        field=field,
        accel_unit=choices.accel_unit,
        rate_unit=choices.rate_unit,
        field_unit=choices.field_unit or "uT",
        notes=numbers.notes,
    )


def _columns(choices: LogChoices, layout: _Layout, where: str) -> tuple[str, ...]:
    """Return the name of each column, checked.

    Raises:
        UsageError: when they are missing or do not fit.
    """
    columns = tuple(c.strip().lower() for c in choices.columns.split(",") if c.strip())
    shown = layout.separator.join(layout.header)[:120] or Message("without names")
    if not columns:
        raise LogQuestion(
            Message(
                "is a table of {count} columns ({shown}) without a description",
                count=layout.width,
                shown=shown,
            ),
            (Message("columns=time,ax,ay,az,gx,gy,gz (- to ignore a column)"),),
            where,
        )
    known = {_TIME, _SKIP, *(axis for sensor in _SENSORS for axis in sensor)}
    named = [column for column in columns if column != _SKIP]
    missing = [axis for axis in _SENSORS[0] + _SENSORS[1] if axis not in columns]
    if _TIME not in columns and not choices.rate_hz:
        missing.insert(0, Message("{time} (or rate-hz=100)", time=_TIME))
    has_field = {axis for axis in _SENSORS[2] if axis in columns}
    fault = ""
    if len(columns) != layout.width:
        fault = Message(
            "names {count} columns, the table has {total} ({shown})",
            count=len(columns),
            total=layout.width,
            shown=shown,
        )
    elif unknown := [column for column in columns if column not in known]:
        fault = Message("has the unknown name {unknown!r}", unknown=unknown[0])
    elif len(set(named)) != len(named):
        fault = Message("names a column twice")
    elif missing:
        fault = Message("lacks {missing}", missing=joined(", ", missing))
    elif len(has_field) not in (0, 3):
        fault = Message("names a part of mx, my, mz")
    if fault:
        raise UsageError(
            "{file}: columns={columns} {fault}",
            file=where,
            columns=choices.columns,
            fault=fault,
        )
    return columns


def _ask_units(choices: LogChoices, columns: tuple[str, ...], where: str) -> None:
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
        rate_hz = choices.sample_rate_hz
        assert rate_hz is not None  # checked by _columns
        return np.arange(len(values)) / rate_hz
    with np.errstate(all="ignore"):
        time_s = values[:, place[_TIME]] * factor(unit, TIME_UNITS, "time-unit")
    return np.asarray(time_s)


def _layout(source: Source, name: str) -> _Layout | None:
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
    if not line.strip():
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
