"""Any other table of numbers, or a table for each sensor: a person names the columns.

Separator, decimal sign, header lines and columns of text are detected, a semicolon behind
each row (data set SisFall) is passed over; columns and units are not guessed. The answers
can be saved as a template (`choices`) for all logs of the same logger.
"""

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
from hapticplayer.capture.csv_table import (
    Numbers,
    Shape,
    read_table,
)
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.log_tables import (
    BETWEEN_TABLES,
    CLOCK,
    NUMBER,
    SENSORS,
    SKIP,
    TIME,
)
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import (
    NANO,
    RawLog,
    SensorStream,
    counted_on,
    split_sensors,
    unwrapped,
)
from hapticplayer.errors import Message, UsageError, joined
from hapticplayer.extras.loggers.table_layout import (
    Layout,
    layouts_of,
    proposed_names,
    tables,
    unread_columns,
)
from hapticplayer.model.arrays import Floats
from hapticplayer.model.spellings import DAY_S


def recognises(source: LogSource) -> Confidence:
    """Tables of at least four columns of numbers below any header, and nothing else."""
    return Confidence.POSSIBLE if layouts_of(source) else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the log in one table, or in one for each sensor."""
    layouts = layouts_of(source)
    where = str(source.path)
    if not layouts:
        raise UsageError(
            "{file}: is not a table of numbers; choose another log", file=where
        )
    for name, layout in layouts.items():
        layout.refuse_unnamable(source.where(name))
    columns = _columns(choices, list(layouts.values()), where)
    choices.take("columns")
    _ask_units(choices, columns, list(layouts.values()), where)
    streams: dict[str, SensorStream] = {}
    notes: list[str] = []
    first_origin: int | None = None
    for (name, layout), named in zip(layouts.items(), columns, strict=True):
        found, time_s, parts = _read_table(source, name, layout, named, choices)
        if first_origin is None:
            first_origin = found.origin
        time_s += (found.origin - first_origin) * NANO
        streams |= split_sensors(time_s, parts)
        notes += [
            note if len(layouts) == 1 else f"{name}: {note}" for note in found.notes
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
    layout: Layout,
    columns: tuple[str, ...],
    choices: LogChoices,
) -> tuple[Numbers, Floats, dict[str, Floats]]:
    """Return the numbers, the times and the sensors of one table."""
    at = {column: number for number, column in enumerate(columns) if column != SKIP}
    is_clock = TIME in at and layout.kinds[at[TIME]] == CLOCK
    time_unit = (choices.take("time_unit") if TIME in at else "") or "s"
    is_integer = is_clock or (time_unit == "ns" and TIME in at)
    numbers = read_table(
        source,
        name,
        Shape(
            layout.width,
            tuple(at.values()),
            layout.separator,
            layout.decimal,
            at[TIME] if is_integer else None,
            is_clock,
            layout.skip_lines,
            marks=() if layout.separator == ";" else ((b";\n", b"\n"),),
        ),
    )
    place = {column: number for number, column in enumerate(at)}
    parts = {
        kind: numbers.values[:, [place[axis] for axis in axes]]
        for kind, axes in SENSORS.items()
        if axes[0] in place
    }
    if TIME not in place:
        rate_hz = choices.take_rate_hz()
        assert rate_hz is not None  # checked by _columns
        return numbers, np.arange(len(numbers.values)) / rate_hz, parts
    stamps = numbers.values[:, place[TIME]]
    if is_clock:
        return numbers, unwrapped(NANO * stamps, DAY_S), parts
    if time_unit != "s":
        stamps = counted_on(stamps)
    with np.errstate(all="ignore"):
        time_s = stamps * factor(time_unit, TIME_UNITS, "time-unit")
    return numbers, np.asarray(time_s), parts


def _columns(
    choices: LogChoices, layouts: list[Layout], where: str
) -> list[tuple[str, ...]]:
    """Return the name of each column of each table, checked."""
    if not choices.columns.replace(",", "").strip():
        raise _question(layouts, where)
    columns = [
        tuple(c.strip().lower() for c in part.split(",") if c.strip())
        for part in choices.columns.split(BETWEEN_TABLES)
    ]
    if fault := _fault(columns, layouts, choices):
        raise UsageError(
            "{file}: columns={columns} {fault}",
            file=where,
            columns=choices.columns,
            fault=fault,
        )
    return columns


def _question(layouts: list[Layout], where: str) -> LogQuestion:
    if len(layouts) == 1:
        return LogQuestion(
            Message(
                "is a table of {count} columns ({shown}) without a description",
                count=len(layouts[0].kinds),
                shown=layouts[0].shown,
            ),
            (_proposal(layouts, "columns=time,ax,ay,az,gx,gy,gz"),),
            where,
        )
    return LogQuestion(
        Message(
            "are {count} tables ({shown}) without a description",
            count=len(layouts),
            shown=joined(" / ", [layout.shown for layout in layouts]),
        ),
        (_proposal(layouts, "columns=time,ax,ay,az/time,gx,gy,gz"),),
        where,
    )


def _proposal(layouts: list[Layout], example: str) -> Message:
    """The answer that the headers suggest, or an example of one."""
    if names := proposed_names(layouts):
        return Message(
            "columns={columns} (as the header suggests; - ignores a column)",
            columns=names,
        )
    return Message(
        "{example} (a name for each column, - to ignore one, / between tables)",
        example=example,
    )


def _fault(
    columns: list[tuple[str, ...]], layouts: list[Layout], choices: LogChoices
) -> str:
    """The fault in the names of the columns, or ""."""
    if len(columns) != len(layouts):
        return Message(
            "describes {count} of {total} tables (/ between them)",
            count=len(columns),
            total=len(layouts),
        )
    named = [name for names in columns for name in names if name not in {TIME, SKIP}]
    missing = [axis for axis in SENSORS["accel"] + SENSORS["rate"] if axis not in named]
    if not (choices.rate_hz or all(TIME in names for names in columns)):
        missing.insert(0, Message("{time} (or rate-hz=100)", time=TIME))
    faults = [
        _misfit(names, layout) for names, layout in zip(columns, layouts, strict=True)
    ]
    is_twice = any(names.count(TIME) > 1 for names in columns)
    if is_twice or len(set(named)) != len(named):
        faults.append(Message("names a column twice"))
    if missing:
        faults.append(Message("lacks {missing}", missing=joined(", ", missing)))
    faults += [
        Message("names a part of {axes}", axes=", ".join(axes))
        for names in columns
        for axes in SENSORS.values()
        if 0 < len(set(axes) & set(names)) < len(axes)
    ]
    return next((fault for fault in faults if fault), "")


def _misfit(names: tuple[str, ...], layout: Layout) -> str:
    """Return why names do not fit the columns of a table, or ""."""
    if len(names) != len(layout.kinds):
        return Message(
            "names {count} columns, the table has {total} ({shown})",
            count=len(names),
            total=len(layout.kinds),
            shown=layout.shown,
        )
    known = {TIME, SKIP, *(axis for axes in SENSORS.values() for axis in axes)}
    unknown = [name for name in names if name not in known]
    if unknown:
        return Message("has the unknown name {unknown!r}", unknown=unknown[0])
    for number, (name, kind) in enumerate(zip(names, layout.kinds, strict=True)):
        fits = name == SKIP or kind == NUMBER or (name, kind) == (TIME, CLOCK)
        if not fits:
            return Message(
                "takes column {number} for {name}, but it holds {text!r}; ignore it "
                "with -, or write it as numbers",
                number=number + 1,
                name=name,
                text=layout.sample[number][:40],
            )
    return ""


def _ask_units(
    choices: LogChoices,
    columns: list[tuple[str, ...]],
    layouts: list[Layout],
    where: str,
) -> None:
    """Ask for all missing units."""
    wanted = []
    named = {name for names in columns for name in names}
    time_kinds = {
        kind
        for names, layout in zip(columns, layouts, strict=True)
        for name, kind in zip(names, layout.kinds, strict=True)
        if name == TIME
    }
    if CLOCK in time_kinds and choices.time_unit not in {"", "s"}:
        raise UsageError(
            "{file}: its times are clock times, not {unit}; leave out time-unit={unit}",
            file=where,
            unit=choices.time_unit,
        )
    if NUMBER in time_kinds and not choices.time_unit:
        wanted.append(f"time-unit={'|'.join(TIME_UNITS)}")
    if not choices.accel_unit:
        wanted.append(f"accel-unit={'|'.join(ACCEL_UNITS)}")
    if not choices.rate_unit:
        wanted.append(f"rate-unit={'|'.join(RATE_UNITS)}")
    if "mx" in named and not choices.field_unit:
        wanted.append(f"field-unit={'|'.join(FIELD_UNITS)}")
    if wanted:
        raise LogQuestion(
            Message("its units are not known"),
            (joined(Message(" and "), wanted),),
            where,
        )


READER = log_reader(recognises, read, unread_columns)._replace(tables=tables)
