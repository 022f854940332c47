"""SparkFun 9DoF Razor IMU M0 (MPU-9250) with its example firmware.

Rows without a header, comma and blank between the cells, CRLF: optional ms, then
acceleration, gyro, field, each switched on or off, in g, deg/s and uT, or in counts
when "calculated values" are off. The file does not declare its columns; nine or ten are
time and three sensors, or three sensors, in the default order.

Source: sparkfun/9DOF_Razor_IMU, _9DoF_Razor_M0_Firmware.ino, logIMUData.
"""

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.csv_table import Shape, first_numbers, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, split
from hapticplayer.errors import Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2

_WITH_TIME = {7: False, 10: True, 14: True}
"""Widths that begin with ms, accelerometer, gyro; whether a field follows."""

_ONE_G = (0.5, 2.0)
_COUNTS_PER_G = (16384.0, 8192.0, 4096.0, 2048.0)
_COUNTS_PER_DPS = 16.4
"""Of the default range of 2000 deg/s."""


def recognises(source: LogSource) -> Confidence:
    """Comma and blank between numbers only, CRLF, whole milliseconds that rise."""
    if len(source.names) != 1:
        return Confidence.NO
    name = source.names[0]
    rows = first_numbers(source, name)
    if not rows or ", " not in source.first_line(name):
        return Confidence.NO
    is_whole = all(row and row[0] % 1 == 0 for row in rows)
    rising = [row[0] for row in rows] == sorted(row[0] for row in rows)
    is_crlf = "\r\n" in source.head(name)
    if len(rows[0]) in _WITH_TIME and is_whole and rising and is_crlf:
        return Confidence.LIKELY
    return Confidence.POSSIBLE if is_crlf else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the log."""
    name = source.names[0]
    rows = first_numbers(source, name)
    width = len(rows[0]) if rows else 0
    if width not in _WITH_TIME:
        raise LogQuestion(
            Message(
                "has {count} columns, and a Razor M0 does not declare them",
                count=width,
            ),
            (Message("format=csv and columns=time,ax,ay,az,gx,gy,gz (- for others)"),),
            source.where(name),
        )
    used = 10 if _WITH_TIME[width] else 7
    numbers = read_table(source, name, Shape(width, tuple(range(used))))
    values = numbers.values
    accel, rate, field = split(
        values, values[:, 0] * 1e-3, (1, 4, 7) if used > 7 else (1, 4)
    )
    norm = float(np.nanmedian(np.linalg.norm(values[:, 1:4], axis=1)))
    accel_unit, rate_unit, field_unit = _units(norm, source.where(name), choices)
    return RawLog(
        name="Razor M0",
        accel=accel,
        rate=rate,
        field=field if field_unit else None,
        accel_unit=accel_unit,
        rate_unit=rate_unit,
        field_unit=field_unit or "uT",
        axes_words=Message("the chip's axes"),
        notes=numbers.notes,
    )


def _units(norm: float, where: str, choices: LogChoices) -> tuple[str, str, str]:
    if _ONE_G[0] < norm < _ONE_G[1]:
        return "g", "deg/s", "uT"
    if choices.accel_unit and choices.rate_unit:
        return choices.accel_unit, choices.rate_unit, ""
    nearest = min(
        _COUNTS_PER_G, key=lambda counts: abs(np.log(max(norm, 1e-9) / counts))
    )
    accel_unit = f"accel-unit={STANDARD_GRAVITY_MPS2 / nearest:.8g}"
    rate_unit = f"rate-unit={np.radians(1.0 / _COUNTS_PER_DPS):.8g}"
    ranges = Message("1 g = {counts:.0f} and 2000 deg/s", counts=nearest)
    raise LogQuestion(
        Message("holds counts of an unknown range (norm {norm:.4g})", norm=norm),
        (
            Message(
                "{accel_unit} and {rate_unit} for {ranges}",
                accel_unit=accel_unit,
                rate_unit=rate_unit,
                ranges=ranges,
            ),
        ),
        where,
    )


READER = log_reader(recognises, read)
