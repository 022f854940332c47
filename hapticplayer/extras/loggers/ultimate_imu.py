"""SparkFun Ultimate IMU with its stock firmware (ADXL345, ITG-3200, HMC5843).

Rows without a header: ms, gyro deg/s, acceleration g, field gauss, two decimals
each; the lines end with LF CR, in this order. With Euler output on there are four
cells and no acceleration.

Source: ryowens84/Ultimate-IMU, main.cpp (2011).
"""

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import Shape, first_numbers, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.live.serial_imus import RESCALED_RATE_DPS
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, split
from hapticplayer.errors import InputError, Message
from hapticplayer.model.limits import REST_G

_WIDTH = 10
_EULER_WIDTH = 4


def recognises(source: LogSource) -> Confidence:
    """Whole milliseconds that rise, then cells with two decimals, LF CR."""
    if len(source.names) != 1:
        return Confidence.NO
    name = source.names[0]
    rows = first_numbers(source, name)
    widths = {len(row) for row in rows}
    if not rows or widths not in ({_WIDTH}, {_EULER_WIDTH}):
        return Confidence.NO
    is_lf_cr = "\n\r" in source.head(name) and "\r\n" not in source.head(name)
    has_blanks = ", " in source.first_line(name)
    times = [row[0] for row in rows]
    if has_blanks or times != sorted(times) or any(time % 1 for time in times):
        return Confidence.NO
    if widths == {_EULER_WIDTH}:
        return Confidence.CERTAIN if is_lf_cr else Confidence.NO
    norm = np.nanmedian(np.linalg.norm(np.array(rows)[:, 4:7], axis=1))
    if not REST_G[0] < norm < REST_G[1]:
        return Confidence.POSSIBLE if is_lf_cr else Confidence.NO
    return Confidence.CERTAIN if is_lf_cr else Confidence.LIKELY


def read(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    name = source.names[0]
    if len(source.first_line(name).split(",")) == _EULER_WIDTH:
        raise InputError(
            "holds Euler angles and no acceleration",
            where=source.where(name),
            remedy="switch the Euler output of the board off and record again",
        )
    numbers = read_table(source, name, Shape(_WIDTH, tuple(range(_WIDTH))))
    values = numbers.values
    spikes = _unscale_skipped(values)
    time_s = values[:, 0] * 1e-3
    accel, rate, field = split(values, time_s, (4, 1, 7))
    notes = numbers.notes
    if spikes:
        notes += (
            Message(
                "{count} gyroscope values were scaled twice and are ignored",
                count=spikes,
            ),
        )
    return RawLog(
        name=Message("Ultimate IMU, stock firmware"),
        accel=accel,
        rate=rate,
        field=field,
        accel_unit="g",
        rate_unit="deg/s",
        field_unit="gauss",
        axes_words=Message("the board's axes"),
        notes=notes,
    )


def _unscale_skipped(values: np.ndarray) -> int:
    """Mark rates that the firmware divided twice by its scale; return how many.

    Such a value is a fourteenth of both neighbours on all axes, while these are fast.
    """
    rate = values[:, 1:4]
    if len(rate) < 3:
        return 0
    inner, fast = rate[1:-1], 20.0 * np.ones(len(rate) - 2)
    before, after = rate[:-2], rate[2:]
    expected = 0.5 * (before + after)
    is_fast = np.linalg.norm(expected, axis=1) > fast
    is_scaled = np.abs(inner - before / RESCALED_RATE_DPS).max(axis=1) < 0.02
    spikes = np.flatnonzero(is_fast & is_scaled) + 1
    values[spikes, 1:4] = np.nan
    return len(spikes)


READER = log_reader(recognises, read)
