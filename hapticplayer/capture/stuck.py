"""Sensors that repeat readings: a stuck one has none there, a slow one has fewer.

A logger that lost its sensor writes the last readings again: all axes, one of them, or
a few rows in turn; or its last bit goes on changing while the other sensor moves. A
coarse sensor at rest repeats itself, too: there its noise does not reach from one step
of its values to the next. Noise and step come from the rest of the log, so that units
do not matter.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.streams import SensorStream
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.model.arrays import Floats, all_of_rows
from hapticplayer.model.limits import LEAST_REPEATS, MAX_MISSING

Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]

ASKED_SHARE = 0.1
"""Of the readings of a sensor that was stuck; more is a decision for a person."""

_STUCK = "stuck"  # in the provenance of a recording
_NAMES = Message("accelerometer"), Message("gyroscope"), Message("magnetometer")
_SHOWN_SPANS = 3

_RESOLVED_STEPS = 0.5
_MAX_PERIOD_ROWS = 16
# Noise is that of the calmest tenth of the windows of so many readings.
_WINDOW_READINGS, _CALM_PERCENT = 16, 10.0
_SHOWN_VALUES = 20_000  # for the step of the values
# What comes to rest and leaves it does so within this many steps at one end.
_GENTLE_STEPS = 2.5
# A log begins at rest; a sensor that shows fewer levels in it may repeat itself there.
_COARSE_LEVELS = 256
_MIN_SHARE_OF_HELD = 0.9
# Where only the last bit of a sensor changes and its noise, even if two thirds are
# motion, does not explain that, the other sensor has to show motion of this usual size.
_MAX_OF_MOTION, _MOVES = 3.0, 0.5
_LEAST_OF_GRAVITY = 0.02


class Repeats(NamedTuple):
    """What sensors repeat.

    Attributes:
        notes: on stuck and slow ones.
        stuck_share: of the readings of accelerometer or gyroscope, whichever is more.
    """

    notes: tuple[Message, ...] = ()
    stuck_share: float = 0.0

    @property
    def provenance(self) -> dict[str, Any]:
        """For a recording, where a sensor was stuck."""
        share = round(self.stuck_share, 5)
        found = {"share": share, "what": joined("; ", self.notes)}
        return {_STUCK: found} if share else {}


class Working(NamedTuple):
    """The streams of a log as far as its sensors worked.

    Attributes:
        accel: accelerometer; NaN where it was stuck, one row for each reading.
        rate: gyroscope, the same.
        field: magnetometer, NaN where it was stuck, or None.
        repeats: what was found.
        rows: (K,) of the accelerometer that were kept.
    """

    accel: SensorStream
    rate: SensorStream
    field: SensorStream | None
    repeats: Repeats
    rows: Rows


def working(
    accel: SensorStream, rate: SensorStream, field: SensorStream | None, where: str
) -> Working:
    """The streams of a log without what stuck and slow sensors repeat.

    Raises:
        InputError: for a sensor that was stuck most of the time.
    """
    given = [accel, rate] if field is None else [accel, rate, field]
    stuck = [stuck_rows(stream.values) for stream in given]
    for one, other in ((0, 1), (1, 0)):
        time_s = given[one].time_s
        for begin, end in flickers(given[one].values):
            if _moves(other == 1, given[other], (time_s[begin], time_s[end])):
                stuck[one][begin + 1 : end + 1] = True
    _exempt_rest(given, stuck)
    each = [readings_each(stream.values) for stream in given[:2]]
    rows = [_rows_of_readings(*pair) for pair in zip(given[:2], each, strict=True)]
    is_shared = rate.time_s is accel.time_s
    if is_shared and each[0] == each[1]:
        rows = [np.union1d(*rows)] * 2
    notes = [
        _stuck_text(name, stream.time_s, flags)
        for name, stream, flags in zip(_NAMES, given, stuck, strict=False)
        if flags.any()
    ] + [
        _held_text(name, stream.time_s, count)
        for name, stream, count in zip(_NAMES, given, each, strict=False)
        if count > 1
    ]
    streams = [
        SensorStream(stream.time_s, np.where(flags[:, None], np.nan, stream.values))
        if flags.any()
        else stream
        for stream, flags in zip(given, stuck, strict=True)
    ]
    if max(each) > 1:
        kept_s = [one.time_s[kept] for one, kept in zip(given, rows, strict=False)]
        if is_shared and rows[0] is rows[1]:
            kept_s[1] = kept_s[0]
        streams[:2] = [
            SensorStream(time_s, stream.values[kept])
            for time_s, stream, kept in zip(kept_s, streams, rows, strict=False)
        ]
    repeats = Repeats(tuple(notes), max(float(np.mean(flags)) for flags in stuck[:2]))
    if repeats.stuck_share > MAX_MISSING:
        raise InputError(
            "{notes}",
            where=where,
            remedy="give a recording of sensors that worked",
            notes=joined("; ", notes),
        )
    field = streams[2] if field is not None else None
    return Working(streams[0], streams[1], field, repeats, rows[0])


def ask_about_stuck(recording: Recording, choices: LogChoices, where: str) -> None:
    """Ask whether a log may be used whose sensors were stuck for long."""
    found = recording.provenance.get(_STUCK)
    if found is None or choices.take("stuck") or found["share"] <= ASKED_SHARE:
        return
    raise LogQuestion(
        found["what"],
        (Message("stuck=no-force to have no force there, or record it again"),),
        where,
    )


def _rows_of_readings(stream: SensorStream, each: int) -> Rows:
    """Return the first row of each reading, which is held for so many."""
    values = stream.values
    count = len(values)
    if each == 1:
        return np.arange(count)
    is_new = np.append(True, ~all_of_rows(values[1:] == values[:-1]))
    last = np.maximum.accumulate(np.where(is_new, np.arange(count), 0))
    return np.flatnonzero((np.arange(count) - last) % each == 0)


def _exempt_rest(streams: Sequence[SensorStream], stuck: Sequence[Flags]) -> None:
    """Take back, in place, that the sensors were stuck where the gyro reads exactly 0.

    A program's log of something at rest repeats itself, and so do sensors that suppress
    their noise there. Stuck ones repeat what they read last.
    """
    accel, rate = streams[:2]
    if not (stuck[0].any() and stuck[1].any()):
        return
    is_still = stuck[1] & ~rate.values.any(axis=1)
    if rate.time_s is accel.time_s:
        at_rest, of_rate = is_still & stuck[0], is_still & stuck[0]
    else:
        at_rest = stuck[0] & _nearest(is_still, rate.time_s, accel.time_s)
        of_rate = is_still & _nearest(stuck[0], accel.time_s, rate.time_s)
    stuck[0][at_rest] = False
    stuck[1][of_rate] = False


def _nearest(flags: Flags, time_s: Floats, at_s: Floats) -> Flags:
    return np.asarray(flags[np.searchsorted(time_s, at_s).clip(0, len(flags) - 1)])


def _moves(is_rate: bool, other: SensorStream, span_s: tuple[float, float]) -> bool:
    """Whether a sensor moves in a span as it does elsewhere, about its rest or its mean."""
    values = other.values
    inside = values[(other.time_s > span_s[0]) & (other.time_s < span_s[1])]
    if not np.isfinite(inside).any():
        return False
    rest = np.nanmedian(values if is_rate else inside, axis=0)
    size, usual = (np.sqrt(np.nanmean((one - rest) ** 2)) for one in (inside, values))
    least = 0.0 if is_rate else _LEAST_OF_GRAVITY * np.linalg.norm(rest)
    return bool(size > max(_MOVES * usual, least))


def _stuck_text(name: str, time_s: Floats, flags: Flags) -> Message:
    edges = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    spans = [
        Message(
            "{begin_s:.2f} to {end_s:.2f} s",
            begin_s=time_s[begin] - time_s[0],
            end_s=time_s[end - 1] - time_s[0],
        )
        for begin, end in zip(edges[::2], edges[1::2], strict=True)
    ]
    more = len(spans) - _SHOWN_SPANS
    if more > 0:
        spans[_SHOWN_SPANS:] = [Message("{more} more", more=more)]
    return Message(
        "the {sensor} repeats its readings as a stuck sensor does, {share:.1%} of "
        "the time ({spans} from the start of the log); they are not used",
        sensor=name,
        share=float(np.mean(flags)),
        spans=joined(", ", spans),
    )


def _held_text(name: str, time_s: Floats, each: int) -> Message:
    return Message(
        "the {sensor} is slower than the log: each reading is held for {each} rows, so "
        "that there are {rate_hz:.4g} a second",
        sensor=name,
        each=each,
        rate_hz=1.0 / (each * float(np.nanmedian(np.diff(time_s)))),
    )


class _Axes(NamedTuple):
    """What an axis of a sensor is like where it works, (3,) each."""

    step: Floats
    noise_steps: Floats
    levels: Floats

    @property
    def is_resolved(self) -> Flags:
        return np.asarray(self.noise_steps >= _RESOLVED_STEPS)


def readings_each(values: Floats) -> int:
    """Return how many rows hold each reading: 1, or more of a slow sensor's (N, 3)."""
    changes = np.flatnonzero(~all_of_rows(values[1:] == values[:-1]))
    lengths = np.diff(changes)
    if len(lengths) < _WINDOW_READINGS:
        return 1
    usual = int(np.median(lengths))
    near = np.abs(lengths - usual) <= (1 if usual > 1 else 0)
    return usual if np.mean(near) >= _MIN_SHARE_OF_HELD else 1


def stuck_rows(values: Floats) -> Flags:
    """Return the rows (N,) that repeat others of one sensor (N, 3), NaN where missing."""
    count, each = len(values), readings_each(values)
    stuck, least = np.zeros(count, np.bool_), LEAST_REPEATS * each
    if count < 2 * least:
        return stuck
    if _has_stuck_axis(values, each):
        stuck[:] = True
        return stuck
    found = list(_repeats(values, each, least))
    if not found:
        return stuck
    works = np.ones(values.shape, np.bool_)
    for one in found:
        works[one.begin : one.end + 1, one.axes] = False
    axes = _axes(values, works, each)
    for one in found:
        if one.is_stuck(values, axes, least):
            stuck[one.begin + one.period : one.end + one.period] = True
    return stuck


@np.errstate(all="ignore")  # enormous numbers are damage, found later
def flickers(values: Floats) -> list[tuple[int, int]]:
    """First and last rows between which only the last bit of a sensor (N, 3) changes."""
    each = readings_each(values)
    everywhere = np.ones(values.shape, np.bool_)
    # two neighbouring levels are a pair of one or of the other kind
    same = [
        [pair[1:] == pair[:-1] for pair in (levels // 2, (levels + 1) // 2)]
        for levels in _levels(values, _axes(values, everywhere, each).step)
    ]
    found: set[tuple[int, int]] = set()
    for x, y, z in itertools.product(*same):
        found.update(_long_runs(x & y & z, LEAST_REPEATS * each))
    if not found:
        return []
    works = everywhere
    for begin, end in found:
        works[begin : end + 1] = False
    noises = _axes(values, works, each).noise_steps / _MAX_OF_MOTION
    stays = [math.erf(math.sqrt(0.5) / max(noise, 1e-9)) for noise in noises]
    bits = -sum(map(math.log2, stays)) / each
    return [(a, b) for a, b in sorted(found) if bits * (b - a) >= LEAST_REPEATS]


def _levels(values: Floats, steps: Floats) -> Iterator[Floats]:
    for axis, step in zip(values.T, steps, strict=True):
        yield np.rint(axis / step)


def _has_stuck_axis(values: Floats, each: int) -> bool:
    """Whether an axis has one value, not zero, throughout, and another has noise."""
    held = values[all_of_rows(np.isfinite(values))]
    if len(held) < LEAST_REPEATS:
        return False
    is_stuck = (held == held[0]).all(axis=0) & (held[0] != 0.0)
    if not is_stuck.any():
        return False
    return bool(_axes(held, np.ones(held.shape, np.bool_), each).is_resolved.any())


class _Repeats(NamedTuple):
    """Rows that are those of a period before.

    Attributes:
        begin: row that is repeated first.
        end: so many rows in all are, less the begin.
        period: in rows; 1 where one row is repeated.
        axes: of the sensor, in which they are.
    """

    begin: int
    end: int
    period: int
    axes: slice = slice(None)

    def is_stuck(self, values: Floats, axes: _Axes, least: int) -> bool:
        step, resolved = axes.step[self.axes], axes.is_resolved[self.axes]
        length = self.end - self.begin
        if length * np.count_nonzero(resolved) < least:
            return False
        used = values[:, self.axes]
        if self.period > 1:
            reach = np.ptp(used[self.begin : self.begin + self.period], axis=0)
            return bool((reach > _GENTLE_STEPS * step)[resolved].any())
        if self.begin == 0 and (axes.levels[self.axes] < _COARSE_LEVELS).all():
            return False
        # what comes to rest, or leaves it, does so gently at one end
        changes = [
            np.abs(used[after] - used[after - 1]) / step
            for after in (self.begin, self.end + 1)
            if 0 < after < len(values)
        ]
        return not any((change <= _GENTLE_STEPS).all() for change in changes)


def _repeats(values: Floats, each: int, least: int) -> Iterator[_Repeats]:
    same = values[1:] == values[:-1]
    for begin, end in _long_runs(all_of_rows(same), least // 3):
        yield _Repeats(begin, end, 1)
    for axis in range(3):
        for begin, end in _long_runs(same[:, axis], 3 * least // 2):
            yield _Repeats(begin, end, 1, slice(axis, axis + 1))
    for period in range(2, _MAX_PERIOD_ROWS * each + 1):
        first = values[period:, 0] == values[:-period, 0]
        if np.count_nonzero(first) < least:
            continue
        again = first & all_of_rows(values[period:] == values[:-period])
        for begin, end in _long_runs(again, max(least, 2 * period)):
            if np.ptp(values[begin : begin + period], axis=0).any():
                yield _Repeats(begin, end, period)


def _long_runs(flags: Flags, least: int) -> list[tuple[int, int]]:
    """Return begin and end of runs of at least so many."""
    edges = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    begins, ends = edges[::2], edges[1::2]
    is_long = ends - begins >= least
    return list(zip(begins[is_long].tolist(), ends[is_long].tolist(), strict=True))


def _axes(values: Floats, works: Flags, each: int) -> _Axes:
    steps, noises, reach = np.full(3, np.inf), np.zeros(3), np.zeros(3)
    for axis in range(3):
        held = values[works[:, axis], axis]
        held = held[np.abs(held) < 1e100][::each]  # squares of others are infinite
        levels = np.unique(held[:_SHOWN_VALUES])
        apart = np.diff(levels)
        apart = apart[apart > 1e-9 * np.abs(levels).max(initial=0.0)]
        if not len(apart):
            continue
        steps[axis], reach[axis] = apart.min(), levels[-1] - levels[0]
        windows = len(held) // _WINDOW_READINGS
        if not windows:
            continue
        rows = held[: windows * _WINDOW_READINGS].reshape(windows, _WINDOW_READINGS)
        rms = np.sqrt(np.square(np.diff(rows, axis=1)).mean(axis=1) / 2.0)
        noises[axis] = np.percentile(rms, _CALM_PERCENT)
    return _Axes(steps, noises / steps, reach / steps)
