"""Older Razor 9DOF firmwares, which write a line for each sensor or frame.

Razor-AHRS: a line for each sensor, `#A-C=x,y,z`, `#M-C=`, `#G-C=` (calibrated) or
`#A-R=` ... (raw); three lines are one frame of 20 ms, without a time. Its axes are x
forward, y right, z down; the acceleration is the negated specific force, 256 counts
a g, and the gyro has 14.375 counts per deg/s. `#YPR=` is angles only.

Stock: `!ANG:roll,pitch,yaw`, some with `,ACC:x,y,z`; or `$...#` with nine counts
(acceleration, gyro, field).

Source: Razor-AHRS 1.4.2 by Peter Bartz (Output.ino, Razor_AHRS.ino); capture notes.
"""

import re

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.csv_table import Shape, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.live.serial_imus import (
    RAZOR_COUNTS_PER_DPS,
    RAZOR_COUNTS_PER_G,
    RAZOR_FRAME_S,
    RAZOR_LINE,
)
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

_ANGLES = re.compile(r"^(#YPR=|!ANG:)")
_DOLLAR = re.compile(r"^\$(-?\d+(?:,-?\d+){8})#?$")
_SAMPLE_ROWS = 1000
_SENSOR_MARKS = tuple(
    (f"#{letter}-{kind}=".encode(), f"{number},".encode())
    for number, letter in enumerate("AMG")
    for kind in "RC"
)


def recognises(source: LogSource) -> Confidence:
    """The marks at the beginning of nearly every line."""
    if len(source.names) != 1:
        return Confidence.NO
    lines = [line.strip() for line in source.head(source.names[0]).splitlines()][1:-1]
    lines = [line for line in lines if line]
    marked = [
        line
        for line in lines
        if RAZOR_LINE.match(line) or _ANGLES.match(line) or _DOLLAR.match(line)
    ]
    if len(lines) > 2 and len(marked) > 0.8 * len(lines):
        return Confidence.CERTAIN
    return Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the log."""
    name = source.names[0]
    lines = [line.strip() for line in source.head(name).splitlines()]
    if any(RAZOR_LINE.match(line) for line in lines):
        numbers = read_table(source, name, Shape(4, (0, 1, 2, 3), marks=_SENSOR_MARKS))
        return _ahrs(_frames(numbers.values), choices, numbers.notes)
    if any(_DOLLAR.match(line) for line in lines):
        return _dollar(source, name, choices)
    raise InputError(
        "holds angles without angular rates, so motion cannot be computed",
        where=source.where(name),
        remedy="switch the board to its sensor output (#osct with Razor-AHRS)",
    )


def _frames(rows: Floats) -> Floats:
    """Return rows of acceleration, field and rate; NaN for a missing line.

    Args:
        rows: (N, 4) sensor (0, 1, 2) and three values. A frame begins where the order
            of the sensors restarts.
    """
    is_known = np.isin(rows[:, 0], (0.0, 1.0, 2.0))
    if not is_known.all():
        rows = rows[is_known]
    sensors = rows[:, 0].astype(np.int8)
    present, first_rows = np.unique(sensors[:_SAMPLE_ROWS], return_index=True)
    order = np.zeros(3, dtype=np.int8)
    order[present] = np.argsort(np.argsort(first_rows))
    frame = np.cumsum(np.diff(order[sensors], prepend=-1) <= 0, dtype=np.int32)
    frames = np.full((int(frame[-1]) + 1 if len(frame) else 0, 9), np.nan)
    for sensor in range(3):  # one by one, to save memory
        of_sensor = np.flatnonzero(sensors == sensor)
        at = frame[of_sensor]
        for axis in range(3):
            frames[at, 3 * sensor + axis] = rows[of_sensor, 1 + axis]
    return frames


def _ahrs(rows: Floats, choices: LogChoices, notes: tuple[str, ...]) -> RawLog:
    chosen_hz = choices.take_rate_hz()
    rate_hz = chosen_hz or 1.0 / RAZOR_FRAME_S
    if chosen_hz is None:
        notes += (
            Message("the log has no timestamps: 50 frames per second are assumed"),
        )
    time_s = np.arange(len(rows)) / rate_hz
    return RawLog(
        name="Razor-AHRS",
        accel=SensorStream(time_s, -rows[:, 0:3]),
        rate=SensorStream(time_s, rows[:, 6:9]),
        accel_unit=f"{STANDARD_GRAVITY_MPS2 / RAZOR_COUNTS_PER_G:.10g}",
        rate_unit=f"{np.radians(1.0 / RAZOR_COUNTS_PER_DPS):.10g}",
        axes="y,x,-z",
        axes_words=Message("the firmware's axes: x forward, y right, z down"),
        notes=notes,
    )


def _dollar(source: LogSource, name: str, choices: LogChoices) -> RawLog:
    rate_hz = choices.take_rate_hz()
    if rate_hz is None:
        raise LogQuestion(
            Message("has no timestamps, and its firmware has no fixed rate"),
            ("rate-hz=50",),
            source.where(name),
        )
    shape = Shape(9, tuple(range(6)), marks=((b"$", b""), (b"#", b"")))
    numbers = read_table(source, name, shape)
    values = numbers.values
    time_s = np.arange(len(values)) / rate_hz
    return RawLog(
        name=Message("Razor, raw output"),
        accel=SensorStream(time_s, values[:, 0:3]),
        rate=SensorStream(time_s, values[:, 3:6]),
        accel_unit=f"{STANDARD_GRAVITY_MPS2 / RAZOR_COUNTS_PER_G:.10g}",
        rate_unit=f"{np.radians(1.0 / RAZOR_COUNTS_PER_DPS):.10g}",
        axes_words=Message("the board's axes"),
        notes=numbers.notes,
    )


READER = log_reader(recognises, read)
