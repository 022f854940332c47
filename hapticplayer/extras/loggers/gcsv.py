"""Gyroflow's .gcsv: a header of `key,value` lines, then t, gyro, accelerometer, field.

A number times tscale is seconds, times gscale rad/s, times ascale g, times mscale
gauss. Writers differ in ascale, so the norm at rest is checked. The orientation string
refers to Gyroflow's own axes and does not define the front, so the stored axes are used
and checked against gravity.

Source: docs.gyroflow.xyz, GCSV format; telemetry-parser, gcsv.rs (units).
"""

import math

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import Shape, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, SensorStream, counted_on
from hapticplayer.errors import InputError, Message
from hapticplayer.model.spellings import column_names

_MARKS = ("GYROFLOW IMU LOG", "CAMERA IMU LOG")
_DEFAULT_TIME_SCALE = 0.001
_AXES = (("g", "r"), ("a",), ("m",))
"""First letters of gyro, accelerometer and magnetometer; some name the rates rx, ry, rz."""


def recognises(source: LogSource) -> Confidence:
    if (
        len(source.names) == 1
        and source.first_line(source.names[0]).rstrip(",;") in _MARKS
    ):
        return Confidence.CERTAIN
    return Confidence.NO


def read(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    name = source.names[0]
    where = source.where(name)
    header, names, lines = _header(source, name)
    columns = _columns(names)
    if len(columns) < 7:
        raise InputError(
            "holds {held}; columns of gyro and accelerometer are needed "
            "(t,gx,gy,gz,ax,ay,az)",
            where=where,
            remedy="record both",
            held=",".join(names)[:80],
        )
    shape = Shape(len(names), tuple(columns), skip_lines=lines)
    numbers = read_table(source, name, shape)
    values = numbers.values
    with np.errstate(all="ignore"):
        time_s = counted_on(values[:, 0]) * _scale(
            header, "tscale", where, _DEFAULT_TIME_SCALE
        )
        of_rate, of_accel = (_scale(header, k, where) for k in ("gscale", "ascale"))
        rate, accel = values[:, 1:4] * of_rate, values[:, 4:7] * of_accel
        field = values[:, 7:10] * _scale(header, "mscale", where)
    orientation = header.get("orientation", "")
    return RawLog(
        name=Message(
            "gcsv of {logger}",
            logger=header.get("id", "")[:40] or Message("an unknown logger"),
        ),
        accel=SensorStream(time_s, accel),
        rate=SensorStream(time_s, rate),
        field=SensorStream(time_s, field) if len(columns) >= 10 else None,
        accel_unit="g",
        field_unit="gauss",
        scale_ratio=of_accel / of_rate,
        axes_words=Message(
            "as stored, orientation {orientation}", orientation=orientation[:20]
        )
        if orientation
        else "",
        time_names=(names[0], "tscale"),
        notes=numbers.notes,
    )


def _columns(names: tuple[str, ...]) -> list[int]:
    """Return the places of the time and of the axes of each sensor, as far as there are."""
    found = [0]
    for letters in _AXES:
        for letter in letters:
            axes = [letter + axis for axis in "xyz"]
            if set(axes) <= set(names):
                found += [names.index(axis) for axis in axes]
                break
        else:
            break
    return found


def _header(
    source: LogSource, name: str
) -> tuple[dict[str, str], tuple[str, ...], int]:
    """Return the keys, the names of the columns and the lines before the rows."""
    header: dict[str, str] = {}
    for number, line in enumerate(source.head(name).splitlines(), start=1):
        cells = column_names(line)
        if cells[0] in {"t", "time"} and len(cells) > 2:
            return header, cells, number
        if len(cells) >= 2:
            header[cells[0]] = cells[1]
    raise InputError(
        "has no header row (t,gx,gy,gz,ax,ay,az) below its keys",
        where=source.where(name),
        remedy="export the log again, or write that line above the first row",
    )


def _scale(header: dict[str, str], key: str, where: str, default: float = 1.0) -> float:
    try:
        value = float(header.get(key, default))
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or value <= 0.0:
        raise InputError(
            "its {key} is {value!r}, not a number above zero",
            where=where,
            remedy="export the log again",
            key=key,
            value=header[key][:20],
        )
    return value


READER = log_reader(recognises, read)
