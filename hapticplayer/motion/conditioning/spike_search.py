"""Which samples are isolated spikes; the reasons are in `spikes`."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.hampel import Neighbourhood, blocks
from hapticplayer.motion.conditioning.timing import Indices, Mask


@dataclass(frozen=True, slots=True)
class SpikeLimits:
    """What counts as a spike.

    Attributes:
        half_window: samples on each side for median and MAD.
        threshold: distance from the median in local standard deviations.
        max_run: most samples in a row of a spike. Vibration with a period of four or
            five samples looks like isolated pairs, so 2 removes real motion.
        max_drop: most samples in a row of a drop to zero.
        flank: samples on each side that must be quiet.
        isolation: most that they may deviate, as a share of the spike's height.
        drop: a value below this share of its median's magnitude is a drop to zero.
        coherence: another axis that deviates by this share of what a spike needs
            shows the same event.
        force_floor_mps2: smaller deviations of the accelerometer are never spikes.
        rate_floor_radps: the same for the gyro.
        field_floor_ut: the same for the magnetometer.

    Raises:
        InputError: when a number is not positive.
    """

    half_window: int = 5
    threshold: float = 6.0
    max_run: int = 1
    max_drop: int = 2
    flank: int = 3
    isolation: float = 0.2
    drop: float = 0.25
    coherence: float = 0.5
    force_floor_mps2: float = 2.0
    rate_floor_radps: float = 0.2
    field_floor_ut: float = 20.0

    def __post_init__(self) -> None:
        for name in self.__slots__:
            timing.positive(getattr(self, name), name, "see SpikeLimits for defaults")
        if self.longest + self.flank > self.half_window:
            raise InputError(
                "a run of {longest} and a flank of {flank} samples are more than half "
                "a window, {half_window}",
                remedy="give a smaller max_run or flank, or a larger half_window",
                longest=self.longest,
                flank=self.flank,
                half_window=self.half_window,
            )

    @property
    def longest(self) -> int:
        """The longest run of either kind."""
        return max(self.max_run, self.max_drop)


DEFAULT_LIMITS = SpikeLimits()


def find_spikes(
    time_s: Floats,
    values: Floats,
    floors: Floats,
    limits: SpikeLimits = DEFAULT_LIMITS,
    *,
    trusted: Mask | None = None,
    only_drops: bool = False,
) -> tuple[Mask, Mask]:
    """Return spikes (N, C), and (N,) where a short run was left as motion.

    At the ends and beside gaps only drops are spikes: a change may begin there.

    Args:
        time_s: (N,) increasing.
        values: (N, C), axes that see the same motion.
        floors: (C,) deviations below these are never spikes.
        limits: see SpikeLimits.
        trusted: (N,) samples to judge and to use; all by default.
        only_drops: leave everything but drops towards zero.
    """
    spikes = np.zeros(values.shape, dtype=np.bool_)
    kept = np.zeros(len(values), dtype=np.bool_)
    if trusted is None:
        trusted = np.ones(len(values), dtype=np.bool_)
    if len(values) < 2 or not trusted.any():
        return spikes, kept
    missing = np.repeat(~trusted[:, None], values.shape[1], axis=1)
    values = replace_samples(time_s, values, missing, trusted)
    window = Neighbourhood.of(time_s, limits.half_window)
    same = np.all(values[1:] == values[:-1], axis=1)
    repeats = np.concatenate(([0], np.cumsum(same)))
    search = _Search(window, values, floors, limits, repeats)
    for axis in range(values.shape[1]):
        flagged, dropped = search.outliers(axis)
        flagged &= trusted
        starts, ends = timing.runs(flagged)
        short = ends - starts <= limits.longest
        starts, ends = starts[short], ends[short]
        is_spike = np.zeros(len(starts), dtype=np.bool_)
        for block in blocks(starts):
            is_spike[block] = search.judge(
                axis, dropped, starts[block], ends[block], only_drops
            )
        spikes[:, axis] = _mark(starts[is_spike], ends[is_spike], len(values))
        kept |= _mark(starts[~is_spike], ends[~is_spike], len(values))
    return spikes, kept


def replace_samples(
    time_s: Floats, values: Floats, bad: Mask, trusted: Mask | None = None
) -> Floats:
    """Return values (N, C) with the bad ones on lines between good neighbours in time.

    Args:
        time_s: (N,) increasing.
        values: (N, C).
        bad: (N, C) what to replace.
        trusted: (N,) what may be a neighbour; all by default.
    """
    if not bad.any():
        return values
    out = values.copy()
    for axis in np.flatnonzero(bad.any(axis=0)):
        here = bad[:, axis]
        good = ~here if trusted is None else ~here & trusted
        if good.any():
            out[here, axis] = np.interp(time_s[here], time_s[good], values[good, axis])
    return out


@dataclass(frozen=True, slots=True, eq=False)
class _Search:
    """The tests for one set of axes (N, C) that see the same motion."""

    window: Neighbourhood
    values: Floats
    floors: Floats
    limits: SpikeLimits
    repeats: Indices
    """(N,) how many samples up to this one equal their predecessor on all axes."""

    def outliers(self, axis: int) -> tuple[Mask, Mask]:
        """Return (N,) where a sample stands out, and where it drops to zero."""
        from scipy.ndimage import median_filter

        column, limits = self.values[:, axis], self.limits
        # the exact test costs ten times as much: only where it can be positive
        level = median_filter(column, 2 * limits.half_window + 1, mode="mirror")
        rows = np.flatnonzero(np.abs(column - level) > 0.5 * self.floors[axis])
        rows = rows[self.window.has_window(rows)]
        flagged = np.zeros(len(column), dtype=np.bool_)
        dropped = np.zeros(len(column), dtype=np.bool_)
        for block in blocks(rows):
            here = rows[block]
            local = self.window.deviations(column, here)
            deviation, line = local.at(here)
            flagged[here] = np.abs(deviation) > self._needed(axis, local.sigma)
            dropped[here] = np.abs(column[here]) <= limits.drop * np.abs(line)
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
        flank = self.limits.flank
        near = (local.index >= starts[:, None] - flank) & ~inside
        near &= local.index < ends[:, None] + flank
        height = np.max(size, axis=1, where=inside, initial=0.0)
        is_drop = np.all(dropped[local.index] | ~inside, axis=1)
        # neighbours that drop too are faults themselves and witness no motion
        calm = np.max(size, axis=1, where=near & ~dropped[local.index], initial=0.0)
        is_spike = calm <= self.limits.isolation * height
        may_leave_zero = (ends - starts <= self.limits.max_run) & (not only_drops)
        may_leave_zero &= np.sum(near, axis=1) == 2 * flank
        may_leave_zero &= self._held(starts - flank, starts) == self._held(
            ends, ends + flank
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
        needed = self.limits.coherence * self._needed(axis, local.sigma)
        is_drop = np.abs(local.value + local.line) <= self.limits.drop * np.abs(
            local.line
        )
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
        needed: Floats = np.maximum(self.floors[axis], self.limits.threshold * sigma)
        return needed


def _mark(starts: Indices, ends: Indices, count: int) -> Mask:
    """Return (count,) True inside the runs."""
    edges = np.zeros(count + 1, dtype=np.int8)
    edges[starts] += 1
    edges[ends] -= 1  # runs never touch
    return np.cumsum(edges[:-1], dtype=np.int8).astype(np.bool_)
