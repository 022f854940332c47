"""phyphox: a CSV for each sensor (or one for all), in a zip or alone.

Headers name quantity and unit: "Time (s)","Acceleration x (m/s^2)" (with gravity),
"Linear Acceleration x (m/s^2)" (without), "Gyroscope x (rad/s)", or "X (m/s^2)" in
Accelerometer.csv or Linear Acceleration.csv. Separator comma, semicolon or tab, decimal
point or comma. meta/time.csv maps the start to the clock.

Source: phyphox.org, data export; checked on exports of Android and iOS.
"""

import re
from typing import NamedTuple

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import Shape, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.loggers.named_tables import UNITS
from hapticplayer.model.spellings import column_names, find_separator

_TIME = "Time (s)"
_AXIS = re.compile(
    r"^(?:(Linear Acceleration|Linear Accelerometer|Acceleration|Accelerometer|"
    r"Gyroscope|Gyroscope rate|Magnetic field|Magnetometer) )?([xyz]) \((.+)\)$",
    re.IGNORECASE,
)
_KINDS = {
    "linear acceleration": "linear",
    "linear accelerometer": "linear",
    "acceleration": "accel",
    "accelerometer": "accel",
    "gyroscope": "rate",
    "gyroscope rate": "rate",
    "magnetic field": "field",
    "magnetometer": "field",
}
_KINDS_BY_UNIT = {
    "m/s2": "accel",
    "g": "accel",
    "rad/s": "rate",
    "deg/s": "rate",
    "uT": "field",
}


class _SensorColumns(NamedTuple):
    """Where a sensor is stored."""

    name: str
    separator: str
    width: int
    columns: tuple[int, int, int, int]
    unit: str


def recognises(source: LogSource) -> Confidence:
    """A table whose first cell is "Time (s)" and that names a sensor's axes."""
    return Confidence.CERTAIN if _sensors(source) else Confidence.NO


def read(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    found = _sensors(source)
    is_free = "accel" not in found and "linear" in found
    accel = found.get("accel") or found.get("linear")
    if accel is None:
        raise InputError(
            "holds no acceleration (only {held})",
            where=str(source.path),
            remedy="give the whole zip, recorded with accelerometer and gyroscope",
            held=", ".join(sorted(found)),
        )
    rate, field = found.get("rate"), found.get("field")
    tables: dict[str, _MemberTable] = {}
    accel_stream = _stream(source, accel, tables)
    rate_stream = _stream(source, rate, tables) if rate else None
    field_stream = _stream(source, field, tables) if field else None
    notes = [note for table in tables.values() for note in table.notes]
    if source.text_of("time.csv").count('"START"') > 1:
        notes.append(Message("the experiment was paused; its clock skips the pause"))
    return RawLog(
        name="phyphox",
        accel=accel_stream,
        rate=rate_stream,
        field=field_stream,
        accel_unit=accel.unit,
        rate_unit=rate.unit if rate else "rad/s",
        field_unit=field.unit if field else "uT",
        axes_words=Message("the phone's axes: x right, y top, z out of the screen"),
        back_axis="z",
        is_gravity_free=is_free,
        notes=tuple(notes),
    )


class _MemberTable(NamedTuple):
    """A member: its streams share their times."""

    streams: dict[tuple[int, ...], SensorStream]
    notes: tuple[str, ...]


def _stream(
    source: LogSource, found: _SensorColumns, tables: dict[str, _MemberTable]
) -> SensorStream:
    if found.name not in tables:
        tables[found.name] = _read(source, found)
    return tables[found.name].streams[found.columns]


def _read(source: LogSource, one: _SensorColumns) -> _MemberTable:
    """Read all sensors of a member at once, so that they share their times."""
    here = [found for found in _sensors(source).values() if found.name == one.name]
    wanted = (here[0].columns[0], *(c for found in here for c in found.columns[1:]))
    decimal = "."
    if one.separator != "," and "," in source.head(one.name).partition("\n")[2]:
        decimal = ","
    shape = Shape(one.width, wanted, one.separator, decimal, skip_lines=1)
    numbers = read_table(source, one.name, shape)
    time_s = numbers.values[:, 0].copy()
    streams: dict[tuple[int, ...], SensorStream] = {}
    for number, found in enumerate(here):
        at = 1 + 3 * number
        streams[found.columns] = SensorStream(time_s, numbers.values[:, at : at + 3])
    return _MemberTable(streams, numbers.notes)


def _sensors(source: LogSource) -> dict[str, _SensorColumns]:
    """Return the sensors of a source by kind, the first member of each."""
    found: dict[str, _SensorColumns] = {}
    for name in source.names:
        line = source.first_line(name)
        separator = find_separator(line)
        columns = column_names(line, separator)
        if not columns or columns[0] != _TIME:
            continue
        axes: dict[tuple[str, str], dict[str, int]] = {}
        for number, column in enumerate(columns):
            match = _AXIS.match(column)
            if match and (kind := _kind(match[1], match[3], source.base(name))):
                axes.setdefault((kind, match[3]), {})[match[2].lower()] = number
        for (kind, unit), at in axes.items():
            if set(at) == set("xyz") and unit in UNITS and kind not in found:
                where = (0, at["x"], at["y"], at["z"])
                found[kind] = _SensorColumns(
                    name, separator, len(columns), where, UNITS[unit]
                )
    return found


def _kind(sensor: str | None, unit: str, base: str) -> str:
    """The quantity of a column; "" if it is not a sensor's.

    Experiments of a user's own name the axis and the unit only; then the name of the
    member tells linear acceleration from acceleration.
    """
    if sensor:
        return _KINDS[sensor.lower()]
    if "grav" in base:
        return ""
    kind = _KINDS_BY_UNIT.get(UNITS.get(unit, ""), "")
    return "linear" if kind == "accel" and "linear" in base else kind


READER = log_reader(recognises, read)
