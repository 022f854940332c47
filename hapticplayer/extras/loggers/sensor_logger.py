"""Sensor Logger (Android and iOS): one CSV for each sensor, in a folder or a zip.

Header `time,seconds_elapsed,z,y,x`: ns since 1970, seconds since the start (the zero of
the log's clock), and the axes in that order, so they are read by name. Android's
Accelerometer.csv has no gravity, TotalAcceleration.csv has; iOS logs acceleration and
gravity separately, with opposite signs, unless "Standardise Units & Frames" is on.

Source: tszheichoi/awesome-sensor-logger (UNITS, COORDINATES, CROSSPLATFORM).
"""

import csv
import io

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.csv_table import Shape
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import (
    NANO,
    RawLog,
    Sensor,
    SensorStream,
    interpolated,
    ordered,
    read_sensor,
)
from hapticplayer.errors import InputError, Message
from hapticplayer.model.spellings import column_names

_COLUMNS = ("time", "x", "y", "z")
_IOS, _ANDROID = "ios", "android"
_TRUE = ("true", "1", "yes")

_MAX_ELAPSED_NS = 10**15
"""Eleven days: a longer time since the start is damaged."""

_TOTAL = "totalacceleration.csv"
_LINEAR = "accelerometer.csv"
_GRAVITY = "gravity.csv"
_RAW = "accelerometeruncalibrated.csv"
_GYRO = ("gyroscope.csv", "gyroscopeuncalibrated.csv")
_FIELD = ("magnetometer.csv", "magnetometeruncalibrated.csv")


def recognises(source: LogSource) -> Confidence:
    """The header of any of its sensors."""
    return Confidence.CERTAIN if _sensors(source) else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the log."""
    found = _sensors(source)
    where = str(source.path)
    system, is_standard = _metadata(source, choices)
    if system == "" and _TOTAL in found:
        system = _ANDROID
    gyro_name = next((name for name in _GYRO if name in found), None)
    if gyro_name is None:
        held = ", ".join(sorted(found.values()))
        raise InputError(
            "holds no gyroscope (only {held})",
            where=where,
            remedy="give the whole folder or zip, recorded with the gyroscope",
            held=held[:200],
        )
    accel, unit, notes = _accel(source, found, system, is_standard=is_standard)
    gyro = _read(source, found[gyro_name])
    field_name = next((name for name in _FIELD if name in found), None)
    field = _read(source, found[field_name]) if field_name else None
    origin_ns = _start_ns(source, found[gyro_name])
    if origin_ns is None or abs(accel.origin_ns - origin_ns) > _MAX_ELAPSED_NS:
        origin_ns = accel.origin_ns
    if field is not None:
        notes += field.notes
    return RawLog(
        name=Message(
            "Sensor Logger ({system})", system="iOS" if system == _IOS else "Android"
        ),
        accel=accel.since(origin_ns),
        rate=gyro.since(origin_ns),
        field=None if field is None else field.since(origin_ns),
        accel_unit=unit,
        axes_words=Message("the phone's axes: x right, y top, z out of the screen"),
        back_axis="z",
        notes=notes + gyro.notes,
    )


def _sensors(source: LogSource) -> dict[str, str]:
    """Return the members with the header of a sensor, by their name in lower case."""
    found: dict[str, str] = {}
    for name in source.names:
        columns = column_names(source.first_line(name), ",")
        if columns[:2] == ("time", "seconds_elapsed") and set(_COLUMNS) <= set(columns):
            found.setdefault(source.base(name), name)
    return found


def _metadata(source: LogSource, choices: LogChoices) -> tuple[str, bool]:
    """Return the phone's system ("" if unknown) and whether frames are standard."""
    for system in (_IOS, _ANDROID):
        if choices.format.endswith(f"-{system}"):
            choices.take("format")
            return system, False
    name = next((n for n in source.names if source.base(n) == "metadata.csv"), None)
    if name is None:
        return "", False
    try:
        rows = list(csv.reader(io.StringIO(source.text(name, 65_536))))[:2]
    except csv.Error:
        return "", False
    if len(rows) < 2:
        return "", False
    held = {key.strip().lower(): value for key, value in zip(*rows, strict=False)}
    system = held.get("platform", "").strip().lower()
    is_standard = held.get("standardisation", "").strip().lower() in _TRUE
    return (system if system in {_IOS, _ANDROID} else ""), is_standard


def _accel(
    source: LogSource, found: dict[str, str], system: str, *, is_standard: bool
) -> tuple[Sensor, str, tuple[str, ...]]:
    """Return the specific force with gravity, its unit, and notes."""
    where = str(source.path)
    if _TOTAL in found and system != _IOS:
        total = _read(source, found[_TOTAL])
        return total, "m/s2", total.notes
    if not system:
        raise LogQuestion(
            Message(
                "does not declare iOS or Android, whose "
                "accelerations have opposite signs"
            ),
            ("format=sensor-logger-ios", "format=sensor-logger-android"),
            where,
        )
    is_flipped = system == _IOS and not is_standard
    if _LINEAR in found and _GRAVITY in found:
        summed, notes = _with_gravity(source, found)
        unit = "m/s2"
    elif _RAW in found:
        summed = _read(source, found[_RAW])
        notes, unit = summed.notes, "g" if is_flipped else "m/s2"
    else:
        raise InputError(
            "holds no acceleration with gravity",
            where=where,
            remedy="record the gravity sensor (iOS) or total acceleration (Android)",
        )
    if is_flipped:
        stream = SensorStream(summed.stream.time_s, -summed.stream.values)
        summed = Sensor(stream, summed.origin_ns, summed.notes)
    return summed, unit, notes


def _with_gravity(
    source: LogSource, found: dict[str, str]
) -> tuple[Sensor, tuple[str, ...]]:
    """Return acceleration plus gravity at the times of the acceleration."""
    linear = _read(source, found[_LINEAR])
    gravity = _read(source, found[_GRAVITY])
    at_times = interpolated(
        linear.stream.time_s, gravity.since(linear.origin_ns), str(source.path)
    )
    if at_times is None:
        ordered(gravity.stream, "gravity", source.where(found[_GRAVITY]))
        raise InputError(
            "its gravity cannot be used",
            where=source.where(found[_GRAVITY]),
            remedy="record again with the gravity sensor",
        )
    with np.errstate(all="ignore"):
        stream = SensorStream(linear.stream.time_s, linear.stream.values + at_times)
    notes = (
        Message("specific force is acceleration plus the phone's gravity estimate"),
    )
    return (
        Sensor(stream, linear.origin_ns, linear.notes),
        notes + linear.notes + gravity.notes,
    )


def _start_ns(source: LogSource, name: str) -> int | None:
    """Return the time at which `seconds_elapsed` is 0, by the first row that tells."""
    columns = column_names(source.first_line(name))
    at, elapsed = columns.index("time"), columns.index("seconds_elapsed")
    for line in source.head(name).splitlines()[1:]:
        cells = column_names(line)
        try:
            return int(cells[at]) - round(float(cells[elapsed]) / NANO)
        except (ValueError, IndexError, OverflowError):
            continue
    return None


def _read(source: LogSource, name: str) -> Sensor:
    columns = column_names(source.first_line(name), ",")
    shape = Shape(
        width=len(columns),
        columns=tuple(columns.index(column) for column in _COLUMNS),
        integer=columns.index("time"),
        skip_lines=1,
    )
    return read_sensor(source, name, shape)


READER = log_reader(recognises, read)
