"""Clipped peaks: found, reconstructed where they are short, else marked.

A sensor that is driven beyond its full scale repeats one extreme value, its rail. The
rail is given, or found: many readings equal to the extreme one within 1e-4, several of
them in a row, and far more than just below it. No smooth peak looks like that.

Short runs at the rail are replaced by the cubic through the two samples on each side,
which continues both flanks. It is bounded: never inside the rail; never above the tent
of the two flanks' chords (a peak that curves towards the rail everywhere lies below
it); never more than `max_overshoot` beyond the rail. Longer runs, and those whose flanks
don't point beyond the rail, keep their values and are marked in `valid`: what happened
there was not measured. On recordings that were clipped afterwards this takes away a
third to two thirds of the RMS error of what it reconstructs.

Frequency response: not linear. Samples that are not clipped come out bit for bit.
Time stamps stay as they are. Repair before averaging; a mean hides its rail.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats, frozen
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.rails import (
    MIN_FORCE_RAIL_MPS2,
    MIN_RATE_RAIL_RADPS,
    sensor_rails,
)
from hapticplayer.motion.conditioning.timing import Indices, Mask


@dataclass(frozen=True, slots=True)
class ClippingLimits:
    """What is reconstructed, and how far.

    Attributes:
        max_run: most samples in a row.
        max_overshoot: most beyond the rail, as a share of it.

    Raises:
        InputError: when a number is not positive.
    """

    max_run: int = 8
    max_overshoot: float = 0.5

    def __post_init__(self) -> None:
        for name in self.__slots__:
            timing.positive(getattr(self, name), name, "see ClippingLimits")


DEFAULT_CLIPPING = ClippingLimits()


@dataclass(frozen=True, slots=True, eq=False)
class Clipping:
    """What was clipped in one sensor.

    Attributes:
        rails: (3, 2) low and high; what is at or beyond is clipped. Infinite where
            an axis has none.
        clipped: (N, 3) True at a rail.
        reconstructed: (N, 3) True where a value was replaced; part of `clipped`.
    """

    rails: Floats
    clipped: Mask
    reconstructed: Mask

    def __post_init__(self) -> None:
        rails = np.array(self.rails, dtype=np.float64)
        rails.setflags(write=False)
        object.__setattr__(self, "rails", rails)
        for name in ("clipped", "reconstructed"):
            mask = frozen(getattr(self, name), (None, None), name, np.bool_)
            object.__setattr__(self, name, mask)

    @property
    def marked(self) -> Mask:
        """(N,) True where an axis is clipped and could not be reconstructed."""
        return np.asarray((self.clipped & ~self.reconstructed).any(axis=1))

    @property
    def share(self) -> float:
        """Share of samples with a clipped axis."""
        return float(np.mean(self.clipped.any(axis=1))) if len(self.clipped) else 0.0


@dataclass(frozen=True, slots=True, eq=False)
class ClippingReport:
    """What was clipped, by sensor.

    Attributes:
        force: of the accelerometer, m/s^2.
        rate: of the gyro, rad/s.
    """

    force: Clipping
    rate: Clipping

    def __str__(self) -> str:
        parts = []
        for name, one in (("accelerometer", self.force), ("gyro", self.rate)):
            clipped = int(one.clipped.any(axis=1).sum())
            parts.append(
                f"{name}: {clipped} clipped samples ({100 * one.share:.2f} %), "
                f"{int(one.marked.sum())} of them only marked"
            )
        return "; ".join(parts)


def repair_clipping(
    imu: ImuLog,
    *,
    full_scale_mps2: float | None = None,
    full_scale_radps: float | None = None,
    limits: ClippingLimits = DEFAULT_CLIPPING,
) -> tuple[ImuLog, ClippingReport]:
    """Return the log with short clipped peaks reconstructed, and what was done.

    Longer runs are marked as not valid; reconstructed samples stay valid.

    Args:
        imu: samples as the sensor gave them.
        full_scale_mps2: rail of the accelerometer (19.6 for +-2 g); found if None.
        full_scale_radps: rail of the gyro; found if None.
        limits: what is reconstructed.

    Raises:
        InputError: for a full scale that is not positive.
    """
    trusted = np.ones(len(imu), dtype=np.bool_) if imu.valid is None else imu.valid
    force, force_report = _repair(
        imu.time_s,
        imu.specific_force_mps2,
        sensor_rails(
            imu.specific_force_mps2, full_scale_mps2, MIN_FORCE_RAIL_MPS2, trusted
        ),
        limits,
        trusted,
    )
    rate, rate_report = _repair(
        imu.time_s,
        imu.angular_rate_radps,
        sensor_rails(
            imu.angular_rate_radps, full_scale_radps, MIN_RATE_RAIL_RADPS, trusted
        ),
        limits,
        trusted,
    )
    valid = trusted & ~force_report.marked & ~rate_report.marked
    log = dataclasses.replace(
        imu,
        specific_force_mps2=force,
        angular_rate_radps=rate,
        valid=imu.valid if np.array_equal(valid, trusted) else valid,
    )
    return log, ClippingReport(force_report, rate_report)


def reconstruct(
    time_s: Floats,
    values: Floats,
    rails: Floats,
    limits: ClippingLimits = DEFAULT_CLIPPING,
    trusted: Mask | None = None,
) -> tuple[Floats, Mask, Mask]:
    """Return values (N, C), clipped (N, C) and reconstructed (N, C).

    Args:
        time_s: (N,) increasing.
        values: (N, C).
        rails: (C, 2) low and high; a reading at or beyond it is clipped.
        limits: what is reconstructed.
        trusted: (N,) samples that may serve as a flank; all by default.
    """
    clipped = (values <= rails[:, 0]) | (values >= rails[:, 1])
    done = np.zeros(values.shape, dtype=np.bool_)
    if len(values) < 2 or not clipped.any():
        return values, clipped, done
    out = values.copy()
    usable = np.ones(len(values), dtype=np.bool_) if trusted is None else trusted
    for axis, side in np.argwhere(np.isfinite(rails)):
        sign = 1.0 if side else -1.0
        column, rail = sign * values[:, axis], sign * float(rails[axis, side])
        starts, ends = timing.runs((column >= rail) & usable)
        good = usable & ~clipped[:, axis]
        starts, ends = _with_flanks(time_s, good, starts, ends, limits.max_run)
        rows, peak = _peaks(time_s, column, starts, ends)
        bounded = np.minimum(peak, rail + limits.max_overshoot * abs(rail))
        bounded = np.maximum(bounded, column[rows])
        told = _spread(bounded > column[rows], ends - starts)
        out[rows[told], axis] = sign * bounded[told]
        done[rows[told], axis] = True
    return out, clipped, done


def _repair(
    time_s: Floats,
    values: Floats,
    rails: Floats,
    limits: ClippingLimits,
    trusted: Mask,
) -> tuple[Floats, Clipping]:
    values, clipped, done = reconstruct(time_s, values, rails, limits, trusted)
    return values, Clipping(rails, clipped & trusted[:, None], done)


def _with_flanks(
    time_s: Floats, good: Mask, starts: Indices, ends: Indices, max_run: int
) -> tuple[Indices, Indices]:
    """Return the short runs that have two good samples on each side, no gap between."""
    fits = (ends - starts <= max_run) & (starts >= 2) & (ends + 1 < len(time_s))
    starts, ends = starts[fits], ends[fits]
    flanks = np.stack([starts - 2, starts - 1, ends, ends + 1])
    gaps = timing.gaps(time_s, timing.median_step_s(time_s))
    before = np.concatenate(([0], np.cumsum(gaps)))
    fits = good[flanks].all(axis=0) & (before[flanks[3]] == before[flanks[0]])
    return starts[fits], ends[fits]


def _peaks(
    time_s: Floats, column: Floats, starts: Indices, ends: Indices
) -> tuple[Indices, Floats]:
    """Return the rows of all runs and what the cubic, kept below the tent, gives."""
    lengths = ends - starts
    run = np.repeat(np.arange(len(starts)), lengths)
    first = np.concatenate(([0], np.cumsum(lengths)[:-1])).astype(np.intp)
    rows = starts[run] + np.arange(len(run)) - first[run]
    flanks = np.stack([starts - 2, starts - 1, ends, ends + 1], axis=1)[run]
    x, y, t = time_s[flanks], column[flanks], time_s[rows]
    cubic = np.zeros(len(rows))
    for i in range(4):  # Lagrange's form
        others = [j for j in range(4) if j != i]
        factors = (t[:, None] - x[:, others]) / (x[:, [i]] - x[:, others])
        cubic += y[:, i] * np.prod(factors, axis=1)
    rise = y[:, 1] + (y[:, 1] - y[:, 0]) / (x[:, 1] - x[:, 0]) * (t - x[:, 1])
    fall = y[:, 2] + (y[:, 3] - y[:, 2]) / (x[:, 3] - x[:, 2]) * (t - x[:, 2])
    return rows, np.minimum(cubic, np.minimum(rise, fall))


def _spread(found: Mask, lengths: Indices) -> Mask:
    """Return True for all rows of each run in which any row is True."""
    run = np.repeat(np.arange(len(lengths)), lengths)
    hits = np.bincount(run[found], minlength=len(lengths)) > 0
    return np.asarray(hits[run])
