"""Isolated spikes: found, separated from real impacts, and replaced.

A Hampel test (local median and median absolute deviation, MAD; Hampel 1974, Pearson
2002) finds samples that stand out. Standing out is not enough: a tap on the camera
does so too. A spike is a fault of the sampling, and these facts tell it from motion:

- It is short: one sample, or two that drop to zero. A sensor's own low-pass spreads what is real
  over several samples and lets it ring.
- It is alone: the samples around it (three on each side) go on as if nothing had
  happened. Taps recorded at 286 Hz ring for ten samples.
- It is on one axis. What several axes of accelerometer and gyro show at the same
  moment is motion, unless all of them drop towards zero: that is a reading that was
  skipped or scaled twice (stock firmware of the SparkFun Ultimate IMU divides the old
  gyro value by 14.375 again).

In doubt the sample stays. In averaged samples a real impact may fill a single one, so
only drops towards zero are removed there: remove spikes first, average then.

Frequency response: not linear. Samples that are no spikes come out bit for bit; a
removed one is read from a straight line between its neighbours in time. Time stamps
stay as they are.
"""

import dataclasses
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Indices, Mask

SIGMA_PER_MAD = 1.4826
"""Standard deviation over MAD of a Gaussian."""
BLOCK_ROWS = 1 << 16


@dataclass(frozen=True, slots=True, eq=False)
class Deviations:
    """Windows around rows, straightened.

    Attributes:
        index: (R, W) sample numbers of each window.
        value: (R, W) deviation from the window's line.
        line: (R, W) that line.
        sigma: (R,) robust standard deviation of `value`.
    """

    index: Indices
    value: Floats
    line: Floats
    sigma: Floats

    def at(self, rows: Indices) -> tuple[Floats, Floats]:
        """Return deviation and line (R,) at the rows themselves."""
        place = (rows - self.index[:, 0])[:, None]
        value = np.take_along_axis(self.value, place, axis=1)[:, 0]
        return value, np.take_along_axis(self.line, place, axis=1)[:, 0]


@dataclass(frozen=True, slots=True, eq=False)
class Neighbourhood:
    """Windows of 2 half + 1 samples that don't reach across gaps.

    Attributes:
        half: samples on each side; near an end the window is shifted inwards.
        begins: (K,) first sample of each stretch without gaps.
        ends: (K,) one past its last.
    """

    half: int
    begins: Indices
    ends: Indices

    @classmethod
    def of(cls, time_s: Floats, half: int) -> "Neighbourhood":
        """Return the windows of a recording with times (N,), N >= 2."""
        cuts = np.flatnonzero(timing.gaps(time_s, timing.median_step_s(time_s))) + 1
        begins = np.concatenate(([0], cuts)).astype(np.intp)
        return cls(half, begins, np.concatenate((cuts, [len(time_s)])).astype(np.intp))

    def bounds(self, rows: Indices) -> tuple[Indices, Indices]:
        """Return first and one-past-last sample (R,) of the stretches of `rows`."""
        stretch = np.searchsorted(self.begins, rows, side="right") - 1
        return self.begins[stretch], self.ends[stretch]

    def has_window(self, rows: Indices) -> Mask:
        """Return (R,) True where the stretch is long enough for a window."""
        begin, end = self.bounds(rows)
        return np.asarray(end - begin > 2 * self.half)

    def deviations(self, column: Floats, rows: Indices) -> Deviations:
        """Return the straightened windows of (N,) around rows that have one."""
        begin, end = self.bounds(rows)
        width = 2 * self.half + 1
        first = np.clip(rows - self.half, begin, end - width)
        index = first[:, None] + np.arange(width)
        window = column[index]
        left = np.median(window[:, : self.half], axis=1)
        right = np.median(window[:, self.half + 1 :], axis=1)
        slope = (right - left) / (self.half + 1)
        line = slope[:, None] * np.arange(-self.half, self.half + 1)
        line += np.median(window - line, axis=1)[:, None]
        value = window - line
        sigma = SIGMA_PER_MAD * np.median(np.abs(value), axis=1)
        return Deviations(index, value, line, sigma)


def blocks(rows: Indices) -> Iterator[slice]:
    """Yield slices of `rows`, so that the windows of all never exist at once."""
    for begin in range(0, len(rows), BLOCK_ROWS):
        yield slice(begin, begin + BLOCK_ROWS)


# Samples on each side for median and MAD, and distance from the median in local sigmas.
HALF_WINDOW, THRESHOLD_SIGMAS = 5, 6.0
# Longest spike and longest drop to zero, in samples. Vibration with a period of four or
# five samples looks like isolated pairs, so that spikes of 2 would remove motion.
MAX_RUN, MAX_DROP = 1, 2
# Samples on each side that must be quiet: deviate by less than a share of the height.
FLANK, ISOLATION_SHARE = 3, 0.2
# A value below this share of its median's magnitude is a drop to zero.
DROP_SHARE = 0.25
# Another axis that deviates by this share of what a spike needs shows the same event.
COHERENCE_SHARE = 0.5
# Smaller deviations are never spikes.
FORCE_FLOOR_MPS2, RATE_FLOOR_RADPS, FIELD_FLOOR_UT = 2.0, 0.2, 20.0


@dataclass(frozen=True, slots=True, eq=False)
class SpikeReport:
    """What was removed, and what stood out but was left.

    Attributes:
        force: (N, 3) True where the specific force was replaced.
        rate: (N, 3) the same for the angular rate.
        field: (N, 3) the same for the magnetic field; all False without one.
        kept: (N,) True where a run short enough for a spike was left as motion.
    """

    force: Mask
    rate: Mask
    field: Mask
    kept: Mask

    @property
    def message(self) -> Message:
        """For people."""
        return Message(
            "spikes removed from {force} accelerometer, {rate} gyro, {field} "
            "magnetometer samples; {kept} samples stood out and were left as motion",
            force=int(self.force.any(axis=1).sum()),
            rate=int(self.rate.any(axis=1).sum()),
            field=int(self.field.any(axis=1).sum()),
            kept=int(self.kept.sum()),
        )


def remove_spikes(imu: ImuLog) -> tuple[ImuLog, SpikeReport]:
    """Return the log without isolated spikes, and what was done.

    Replaced samples are as good as their neighbours, so `valid` stays as it is. Samples
    that are not valid are neither judged nor used.
    """
    trusted = np.ones(len(imu), dtype=np.bool_) if imu.valid is None else imu.valid
    only_drops = imu.sampling is Sampling.AVERAGED

    def found(values: Floats, floor: Floats) -> tuple[Floats, Mask, Mask]:
        spikes, kept = find_spikes(imu.time_s, values, floor, trusted, only_drops)
        return _replaced(imu.time_s, values, spikes, trusted), spikes, kept

    motion = np.hstack([imu.specific_force_mps2, imu.angular_rate_radps])
    floors = np.repeat([FORCE_FLOOR_MPS2, RATE_FLOOR_RADPS], 3)
    motion, spikes, kept = found(motion, floors)
    field, field_spikes = imu.magnetic_field_ut, np.zeros((len(imu), 3), np.bool_)
    if field is not None:
        # a magnet does not come and go within one sample: no axis vouches for another
        floor = np.array([FIELD_FLOOR_UT])
        axes = [found(field[:, axis : axis + 1], floor) for axis in range(3)]
        field = np.hstack([values for values, *_ in axes])
        field_spikes = np.hstack([marked for _, marked, _ in axes])
    log = dataclasses.replace(
        imu,
        specific_force_mps2=motion[:, :3],
        angular_rate_radps=motion[:, 3:],
        magnetic_field_ut=field,
    )
    return log, SpikeReport(spikes[:, :3], spikes[:, 3:], field_spikes, kept)


def find_spikes(
    time_s: Floats,
    values: Floats,
    floors: Floats,
    trusted: Mask,
    only_drops: bool,
) -> tuple[Mask, Mask]:
    """Return spikes (N, C), and (N,) where a short run was left as motion.

    At the ends and beside gaps only drops are spikes: a change may begin there.

    Args:
        time_s: (N,) increasing.
        values: (N, C), axes that see the same motion.
        floors: (C,) deviations below these are never spikes.
        trusted: (N,) samples to judge and to use.
        only_drops: leave everything but drops towards zero.
    """
    spikes = np.zeros(values.shape, dtype=np.bool_)
    kept = np.zeros(len(values), dtype=np.bool_)
    if len(values) < 2 or not trusted.any():
        return spikes, kept
    missing = np.repeat(~trusted[:, None], values.shape[1], axis=1)
    values = _replaced(time_s, values, missing, trusted)
    window = Neighbourhood.of(time_s, HALF_WINDOW)
    same = np.all(values[1:] == values[:-1], axis=1)
    repeats = np.concatenate(([0], np.cumsum(same)))
    search = _Search(window, values, floors, repeats)
    for axis in range(values.shape[1]):
        flagged, dropped = search.outliers(axis)
        flagged &= trusted
        starts, ends = timing.runs(flagged)
        short = ends - starts <= max(MAX_RUN, MAX_DROP)
        starts, ends = starts[short], ends[short]
        is_spike = np.zeros(len(starts), dtype=np.bool_)
        for block in blocks(starts):
            is_spike[block] = search.judge(
                axis, dropped, starts[block], ends[block], only_drops
            )
        spikes[:, axis] = _mark(starts[is_spike], ends[is_spike], len(values))
        kept |= _mark(starts[~is_spike], ends[~is_spike], len(values))
    return spikes, kept


def _replaced(time_s: Floats, values: Floats, bad: Mask, trusted: Mask) -> Floats:
    """Return values (N, C) with the bad ones on lines between good neighbours in time."""
    if not bad.any():
        return values
    out = values.copy()
    for axis in np.flatnonzero(bad.any(axis=0)):
        here = bad[:, axis]
        good = ~here & trusted
        if good.any():
            out[here, axis] = np.interp(time_s[here], time_s[good], values[good, axis])
    return out


@dataclass(frozen=True, slots=True, eq=False)
class _Search:
    """The tests for one set of axes (N, C) that see the same motion."""

    window: Neighbourhood
    values: Floats
    floors: Floats
    repeats: Indices
    """(N,) how many samples up to this one equal their predecessor on all axes."""

    def outliers(self, axis: int) -> tuple[Mask, Mask]:
        """Return (N,) where a sample stands out, and where it drops to zero."""
        from scipy.ndimage import median_filter

        column = self.values[:, axis]
        # the exact test costs ten times as much: only where it can be positive
        level = median_filter(column, 2 * HALF_WINDOW + 1, mode="mirror")
        rows = np.flatnonzero(np.abs(column - level) > 0.5 * self.floors[axis])
        rows = rows[self.window.has_window(rows)]
        flagged = np.zeros(len(column), dtype=np.bool_)
        dropped = np.zeros(len(column), dtype=np.bool_)
        for block in blocks(rows):
            here = rows[block]
            local = self.window.deviations(column, here)
            deviation, line = local.at(here)
            flagged[here] = np.abs(deviation) > self._needed(axis, local.sigma)
            dropped[here] = np.abs(column[here]) <= DROP_SHARE * np.abs(line)
        return flagged, flagged & dropped

    def judge(
        self,
        axis: int,
        dropped: Mask,
        starts: Indices,
        ends: Indices,
        only_drops: bool,
    ) -> Mask:
        """Return (R,) True for short runs that are spikes."""
        local = self.window.deviations(self.values[:, axis], starts)
        size = np.abs(local.value)
        inside = (local.index >= starts[:, None]) & (local.index < ends[:, None])
        near = (local.index >= starts[:, None] - FLANK) & ~inside
        near &= local.index < ends[:, None] + FLANK
        height = np.max(size, axis=1, where=inside, initial=0.0)
        is_drop = np.all(dropped[local.index] | ~inside, axis=1)
        # neighbours that drop too are faults themselves and witness no motion
        calm = np.max(size, axis=1, where=near & ~dropped[local.index], initial=0.0)
        is_spike = calm <= ISOLATION_SHARE * height
        may_leave_zero = (ends - starts <= MAX_RUN) & (not only_drops)
        may_leave_zero &= np.sum(near, axis=1) == 2 * FLANK
        may_leave_zero &= self._held(starts - FLANK, starts) == self._held(
            ends, ends + FLANK
        )
        is_spike &= is_drop | may_leave_zero
        # a run that leaves its window reaches over a gap
        is_spike &= ends <= local.index[:, -1] + 1
        for other in range(self.values.shape[1]):
            if other != axis:
                is_spike &= ~self._shows_motion(other, starts, inside)
        return np.asarray(is_spike)

    def _shows_motion(self, axis: int, starts: Indices, inside: Mask) -> Mask:
        """Return (R,) True where this axis deviates too, and not towards zero."""
        local = self.window.deviations(self.values[:, axis], starts)
        needed = COHERENCE_SHARE * self._needed(axis, local.sigma)
        is_drop = np.abs(local.value + local.line) <= DROP_SHARE * np.abs(local.line)
        seen = (np.abs(local.value) > needed[:, None]) & ~is_drop & inside
        return np.asarray(seen.any(axis=1))

    def _held(self, begins: Indices, ends: Indices) -> Mask:
        """Return (R,) True where all axes repeat one reading: a recorder that waits.

        Held readings on one side say as little about the motion as a gap.
        """
        last = len(self.repeats) - 1
        first, stop = np.clip(begins, 0, last), np.clip(ends - 1, 0, last)
        return np.asarray(self.repeats[stop] - self.repeats[first] == ends - begins - 1)

    def _needed(self, axis: int, sigma: Floats) -> Floats:
        needed: Floats = np.maximum(self.floors[axis], THRESHOLD_SIGMAS * sigma)
        return needed


def _mark(starts: Indices, ends: Indices, count: int) -> Mask:
    """Return (count,) True inside the runs."""
    edges = np.zeros(count + 1, dtype=np.int8)
    edges[starts] += 1
    edges[ends] -= 1  # runs never touch
    return np.cumsum(edges[:-1], dtype=np.int8).astype(np.bool_)
