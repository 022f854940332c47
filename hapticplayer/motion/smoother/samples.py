"""The samples of one block: cut, averaged over windows, dropped ones put back."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot

# A step of a whole number of intervals has dropped samples, within this tolerance.
DROPOUT_TOLERANCE_INTERVALS = 0.15
# A logger that drops samples has at least this share of regular steps.
MIN_REGULAR_STEP_SHARE, REGULAR_TOLERANCE_INTERVALS = 0.6, 0.1
# A logger that would have dropped more stamps packets, not samples.
MAX_FILLED_COUNT_RATIO = 2.0

# More repetitions are those of a sensor that measures nothing.
MAX_HELD = 20.0


@dataclass(frozen=True, slots=True, eq=False)
class InertialSamples:
    """Inertial samples of one block.

    Attributes:
        step_s: (n,) how long each sample holds.
        specific_force_mps2: (n, 3).
        angular_rate_radps: (n, 3).
        averaged: whether a sample is the mean over its step, else its end.
        lost_s: (n,) time before the sample in which the rotation is unknown.
        doubt_s: (n,) time in which the specific force is unknown.
        interval_s: the median step.
        gain: factor for the specific force.
        middle_rad: (n, 3) what half the turn over an averaged sample lacks to its
            middle; None where that is not known.
    """

    step_s: Floats
    specific_force_mps2: Floats
    angular_rate_radps: Floats
    averaged: bool
    lost_s: Floats
    doubt_s: Floats
    interval_s: float
    gain: float = 1.0
    middle_rad: Floats | None = None

    def __len__(self) -> int:
        return len(self.step_s)

    def held(self) -> float:
        """Return how many samples repeat one reading, on average; at most MAX_HELD."""
        changed = np.zeros(len(self) - 1, np.bool_)
        for values in (self.angular_rate_radps, self.specific_force_mps2):
            for axis in values.T:
                changed |= axis[1:] != axis[:-1]
        readings = max(int(np.count_nonzero(changed)), 1)
        return min(len(changed) / readings, MAX_HELD) if len(changed) else 1.0

    def cut(self, part: slice) -> "InertialSamples":
        """Return some of the samples."""
        return replace(
            self,
            step_s=self.step_s[part],
            specific_force_mps2=self.specific_force_mps2[part],
            angular_rate_radps=self.angular_rate_radps[part],
            lost_s=self.lost_s[part],
            doubt_s=self.doubt_s[part],
        )

    def sums(self, values: Floats, per_window: int) -> Floats:
        """Return sums (windows,) of values (n,); the last window may be shorter."""
        if per_window == 1:
            return values
        return np.add.reduceat(values, np.arange(0, len(self), per_window))

    def averages(self, per_window: int) -> "InertialSamples":
        """Return means over windows: enough for bias, speed and a rough vertical."""
        if per_window == 1:
            return self
        step = self.sums(self.step_s, per_window)
        scale = 1.0 / np.where(step > 0.0, step, 1.0)

        def means(values: Floats) -> Floats:
            # axis by axis, because numpy is slow along short axes
            sums = [self.sums(self.step_s * axis, per_window) for axis in values.T]
            return (scale * np.array(sums)).T

        return replace(
            self,
            step_s=step,
            specific_force_mps2=means(self.specific_force_mps2),
            angular_rate_radps=means(self.angular_rate_radps),
            averaged=True,
            lost_s=self.sums(self.lost_s, per_window),
            doubt_s=self.sums(self.doubt_s, per_window),
            interval_s=per_window * self.interval_s,
        )


def at_middles(samples: InertialSamples, bias_radps: Floats) -> InertialSamples:
    """Return averaged samples as seen in their middles; others as they are.

    With the mean rate of the neighbours, the rotation d[k] over a sample gains the
    coning term d[k] x D[k] / 24, D[k] = d[k+1] - d[k-1], and its first half is half of it
    less D[k] / 16 (Savage 1998, J. Guidance 21(1):19). The specific force f[k], mean of
    what a turning sensor sees, gains D[k] x f[k] / 48, and where it changes by c[k] in
    the inertial frame from k - 1 to k + 1 the sculling term d[k] x c[k] / 24 (same
    author, 21(2):208).

    Args:
        samples: of one block.
        bias_radps: (3,) of the gyro, estimated.
    """
    if not samples.averaged:
        return samples
    step = np.maximum(samples.step_s, 1e-9)
    rate = samples.angular_rate_radps.T
    turn = (rate - bias_radps[:, None]) * step
    change = np.zeros_like(turn)
    np.subtract(turn[:, 2:], turn[:, :-2], out=change[:, 1:-1])
    force = window_mean(samples.specific_force_mps2.T, turn, inverse=True)
    # what the sensor sees of a fixed force changes by this
    fixed = 4.0 * rot.half_sinc(4.0 * rot.squared_norm(turn)) * rot.cross(force, turn)
    sculling = np.zeros_like(turn)
    np.subtract(force[:, 2:] - force[:, :-2], fixed[:, 1:-1], out=sculling[:, 1:-1])
    force += (rot.cross(turn, sculling) + 0.5 * rot.cross(change, force)) / 24.0
    return replace(
        samples,
        specific_force_mps2=force.T,
        angular_rate_radps=(rate + rot.cross(turn, change) / (24.0 * step)).T,
        middle_rad=change.T / -16.0,
    )


def window_mean(vector: Floats, turn_rad: Floats, *, inverse: bool = False) -> Floats:
    """Return the mean of a fixed vector as a turning sensor sees it.

    Its part across the axis of rotation shrinks by sin(a/2) / (a/2).

    Args:
        vector: (3, ...) as seen in the middle of the window.
        turn_rad: (3, ...) rotation over the window.
        inverse: return the vector in the middle for a given mean instead.
    """
    squared = rot.squared_norm(turn_rad)
    factor = 2.0 * rot.half_sinc(squared)
    if inverse:
        # beyond a full turn nothing is left to be enlarged
        factor = 1.0 / np.maximum(factor, 0.1)
    along = rot.dot(vector, turn_rad)
    along *= (1.0 - factor) / np.where(squared > 0.0, squared, 1.0)
    return np.asarray(factor * vector + along * turn_rad)


def with_dropouts_filled(
    samples: InertialSamples,
) -> tuple[InertialSamples, NDArray[np.intp] | None]:
    """Return the samples with dropped ones interpolated, and the places of the others.

    The places are None where nothing was dropped.
    """
    if samples.step_s.max() < (2.0 - DROPOUT_TOLERANCE_INTERVALS) * samples.interval_s:
        return samples, None
    steps = samples.step_s / samples.interval_s
    whole = np.round(steps)
    dropped = (whole >= 2.0) & (np.abs(steps - whole) < DROPOUT_TOLERANCE_INTERVALS)
    regular = np.mean(np.abs(steps - 1.0) < REGULAR_TOLERANCE_INTERVALS)
    if not dropped.any() or regular < MIN_REGULAR_STEP_SHARE:
        return samples, None
    parts = np.where(dropped, whole, 1.0).astype(np.intp)
    if parts.sum() > MAX_FILLED_COUNT_RATIO * len(samples):
        return samples, None
    places = np.cumsum(parts) - 1
    rows = np.interp(np.arange(places[-1] + 1), places, np.arange(len(samples)))
    before = np.floor(rows).astype(np.intp)
    share = (rows - before)[:, None]
    after = np.minimum(before + 1, len(samples) - 1)

    def between(values: Floats) -> Floats:
        return np.asarray(values[before] + share * (values[after] - values[before]))

    spread = np.repeat(1.0 / parts, parts)
    filled = replace(
        samples,
        step_s=np.repeat(samples.step_s, parts) * spread,
        specific_force_mps2=between(samples.specific_force_mps2),
        angular_rate_radps=between(samples.angular_rate_radps),
        lost_s=np.repeat(samples.lost_s, parts) * spread,
        doubt_s=np.repeat(samples.doubt_s, parts) * spread,
    )
    return filled, places
