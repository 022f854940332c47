"""Open-loop strapdown integration over short windows of samples.

Everything that happens at the full rate is here; all that follows sees windows of
about 1/16 s. Standard pre-integration (Forster et al. 2017, IEEE T-RO 33(1):1,
section V; the coning term and the half-window terms for averaged samples as in
Savage 1998, J. Guidance 21(1):19).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import SMALL_SQUARED_RAD2, Complexes, Pair

# What is taken off the gyro: bias (3,) rad/s and matrix (3, 3).
Correction = tuple[Floats, Floats]

# Samples at a time: what is in flight then fits into the cache of a core.
CHUNK = 8192
# Windows within which nothing turns further take first-order rotations; the vertical
# is off by less than 2e-4 of g.
_CALM_RAD = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Inertial samples of one block.

    Attributes:
        step_s: (n,) how long each sample holds.
        specific_force_mps2: (n, 3).
        angular_rate_radps: (n, 3).
        averaged: whether a sample is the mean over its step, else its end.
        lost_s: (n,) how long before the sample nothing is known about the rotation.
        doubt_s: (n,) how long the specific force is not to be trusted.
        gain: what the specific force is to be multiplied with.
        usual_step_s: the median step, where it is known already.
    """

    step_s: Floats
    specific_force_mps2: Floats
    angular_rate_radps: Floats
    averaged: bool
    lost_s: Floats
    doubt_s: Floats
    gain: float = 1.0
    usual_step_s: float | None = None

    def __len__(self) -> int:
        return len(self.step_s)

    @property
    def interval_s(self) -> float:
        """The median step."""
        if self.usual_step_s is None:
            return float(np.median(self.step_s))
        return self.usual_step_s

    def cut(self, start: int, stop: int) -> "Samples":
        """Return the samples from start to stop."""
        part = slice(start, stop)
        return Samples(
            self.step_s[part],
            self.specific_force_mps2[part],
            self.angular_rate_radps[part],
            self.averaged,
            self.lost_s[part],
            self.doubt_s[part],
            self.gain,
            self.usual_step_s,
        )


@dataclass(frozen=True, slots=True, eq=False)
class Windows:
    """What the sensor did in each window, in its own frame at the window's start.

    Attributes:
        duration_s: (n,).
        lost_s: (n,) sum of the samples'.
        rotation: from the end of the window to its start, (n,).
        impulse_mps: (3, n) the integral of the specific force.
        turn_rad: (3, n) the integral of the angular rate.
        power_m2ps3: (n,) the integral of the squared specific force.
        doubt_s: (n,) sum of the samples'.
        inside: orientation of each sample relative to the start, (per window, n).
    """

    duration_s: Floats
    lost_s: Floats
    rotation: Pair
    impulse_mps: Floats
    turn_rad: Floats
    power_m2ps3: Floats
    doubt_s: Floats
    inside: Pair


def integrate(
    samples: Samples,
    per_window: int,
    bias_radps: Floats,
    matrix: Floats,
    *,
    shortcuts: bool = True,
) -> Windows:
    """Return the windows of some samples; the last one may be shorter.

    Args:
        samples: of one block.
        per_window: how many samples make a window.
        bias_radps: (3,) of the gyro.
        matrix: (3, 3) of the gyro's errors: what it reads beside the bias is
            (1 + matrix) times the angular rate.
        shortcuts: whether stretches that hardly turn are integrated to first order.
    """
    correct = np.linalg.inv(np.eye(3) + matrix) if matrix.any() else None
    calm = calm_chunks(samples, per_window, bias_radps) if shortcuts else None
    total = -(-len(samples) // per_window)
    inside = (
        np.empty((per_window, total), complex),
        np.empty((per_window, total), complex),
    )
    rotation = np.empty(total, complex), np.empty(total, complex)
    impulse, turned = np.empty((3, total)), np.empty((3, total))
    duration, power = np.empty(total), np.empty(total)
    chunk = max(1, CHUNK // per_window)
    for start in range(0, total, chunk):
        part = slice(start, min(start + chunk, total))
        step = _columns(samples.step_s, per_window, part)
        force = _columns(samples.specific_force_mps2, per_window, part)
        if samples.gain != 1.0:
            force *= samples.gain
        turn = _columns(samples.angular_rate_radps, per_window, part)
        turn -= bias_radps[:, None, None]
        turn *= step
        if correct is not None:
            turn = (correct @ turn.reshape(3, -1)).reshape(turn.shape)
        if samples.averaged:
            change = _changes(samples, per_window, part, bias_radps)
            _averaged(turn, change, force, inside, rotation, part)
        elif calm is not None and calm[start // chunk]:
            _calm(turn, inside, rotation, part)
        else:
            _running(rot.exponential(turn), inside, rotation, part)
        duration[part] = step.sum(axis=0)
        turned[:, part] = turn.sum(axis=1)
        power[part] = np.einsum("iwn,iwn->n", force, force)
        force *= step
        local = inside[0][:, part], inside[1][:, part]
        impulse[:, part] = rot.rotate(local, force).sum(axis=1)
    power *= duration / np.minimum(
        per_window, len(samples) - per_window * np.arange(total)
    )
    return Windows(
        duration,
        _sums(samples.lost_s, per_window, total),
        rotation,
        impulse,
        turned,
        power,
        _sums(samples.doubt_s, per_window, total),
        inside,
    )


def calm_chunks(
    samples: Samples, per_window: int, bias_radps: Floats
) -> NDArray[np.bool_]:
    """Return in which chunks no window can turn far, so that its turns add up."""
    size = max(1, CHUNK // per_window) * per_window
    starts = range(0, len(samples), size)
    calm = np.zeros(len(starts), dtype=np.bool_)
    if samples.averaged:
        return calm
    bias = float(np.abs(bias_radps).max())
    for number, start in enumerate(starts):
        rate = samples.angular_rate_radps[start : start + size]
        longest_s = float(samples.step_s[start : start + size].max())
        slow_radps = _CALM_RAD / (per_window * longest_s) - bias
        if float(rate.max()) < slow_radps:
            calm[number] = -float(rate.min()) < slow_radps
    return calm


def coarse(samples: Samples, per_window: int) -> Samples:
    """Return means over windows: enough to see bias, speed and a rough vertical."""
    if per_window == 1:
        return samples
    total = -(-len(samples) // per_window)
    step = _sums(samples.step_s, per_window, total)
    weight = (1.0 / np.where(step > 0.0, step, 1.0))[:, None]

    def mean(values: Floats) -> Floats:
        return weight * _weighted_sums(samples.step_s, values, per_window, total)

    return Samples(
        step,
        mean(samples.specific_force_mps2),
        mean(samples.angular_rate_radps),
        True,
        _sums(samples.lost_s, per_window, total),
        _sums(samples.doubt_s, per_window, total),
        samples.gain,
        per_window * samples.interval_s,
    )


def _sums(values: Floats, per_window: int, total: int) -> Floats:
    """Return (..., total) sums over windows of (..., n)."""
    if per_window == 1:
        return values
    if not values.any():  # mostly so, of time lost and in doubt
        return np.zeros((*values.shape[:-1], total))
    starts = np.arange(0, per_window * total, per_window)
    return np.add.reduceat(values, starts, axis=-1)


def _weighted_sums(
    weight: Floats, values: Floats, per_window: int, total: int
) -> Floats:
    """Return (total, 3) sums over windows of weighted (n, 3)."""
    used = len(values) // per_window * per_window
    # axis by axis and as a product, because numpy is slow along short axes
    weighted = values.T * weight
    out = np.empty((3, total))
    by_window = weighted[:, :used].reshape(3, -1, per_window)
    out[:, : used // per_window] = by_window @ np.ones(per_window)
    if used < len(values):
        out[:, -1] = weighted[:, used:].sum(axis=1)
    return out.T


def _columns(values: Floats, per_window: int, part: slice) -> Floats:
    """Return ([3,] per_window, windows) of the (n[, 3]) samples, zeros at the end."""
    start, stop = part.start * per_window, part.stop * per_window
    values = values[start:stop]
    short = stop - start - len(values)
    if short:
        values = np.concatenate([values, np.zeros((short, *values.shape[1:]))])
    shaped = values.reshape(part.stop - part.start, per_window, *values.shape[1:])
    return np.array(shaped.T, order="C")


def _running(steps: Pair, inside: Pair, rotation: Pair, part: slice) -> None:
    """Multiply along each window; leave the product of the whole one in `rotation`."""
    ends = _products(steps)
    inside[0][:, part], inside[1][:, part] = ends
    rotation[0][part], rotation[1][part] = ends[0][-1], ends[1][-1]


def _calm(turn: Floats, inside: Pair, rotation: Pair, part: slice) -> None:
    """Like `_running`, for small turns: they add up."""
    first, second = rot.exponential(np.cumsum(turn, axis=1))
    inside[0][:, part], inside[1][:, part] = first, second
    rotation[0][part], rotation[1][part] = first[-1], second[-1]


def _products(steps: Pair) -> tuple[Complexes, Complexes]:
    first, second = steps
    for row in range(1, len(first)):
        first[row], second[row] = rot.multiply(
            (first[row - 1], second[row - 1]), (first[row], second[row])
        )
    return first, second


def _changes(
    samples: Samples, per_window: int, part: slice, bias_radps: Floats
) -> Floats:
    """Return the turn of the next sample less that of the one before, (3, per, n)."""
    first, last = part.start * per_window, part.stop * per_window
    around = slice(max(first - 1, 0), last + 1)
    turn = samples.angular_rate_radps[around] - bias_radps
    turn *= samples.step_s[around, None]
    change = np.zeros_like(turn)
    change[1:-1] = turn[2:] - turn[:-2]
    change = change[first - around.start :][: last - first]
    return _columns(change, per_window, slice(0, part.stop - part.start))


def _averaged(
    turn: Floats,
    change: Floats,
    force: Floats,
    inside: Pair,
    rotation: Pair,
    part: slice,
) -> None:
    """Find the orientation in the middle of each sample, and over the window.

    With the mean rate of the neighbours, the rotation over a sample gains the coning
    term (d[k] x (d[k+1] - d[k-1])) / 24, and its first half is half of it less
    (d[k+1] - d[k-1]) / 16. `force` becomes what it is in the middle.
    """
    whole = rot.exponential(turn + rot.cross(turn, change) / 24.0)
    half = rot.exponential(0.5 * turn - change / 16.0)
    force[:] = window_mean(force, turn, inverse=True)
    ends = _products(whole)
    inside[0][0, part], inside[1][0, part] = half[0][0], half[1][0]
    if len(ends[0]) > 1:
        inside[0][1:, part], inside[1][1:, part] = rot.multiply(
            (ends[0][:-1], ends[1][:-1]), (half[0][1:], half[1][1:])
        )
    rotation[0][part], rotation[1][part] = ends[0][-1], ends[1][-1]


def spread(
    start: Pair, windows: Windows, samples: Samples, bias_radps: Floats
) -> tuple[Floats, Floats]:
    """Return orientation (n, 4) and vertical (n, 3) at the samples.

    Args:
        start: orientation of each window's start, sensor to earth.
        windows: of the samples.
        samples: of one block.
        bias_radps: (3,) of the gyro; matters to averaged samples only.
    """
    count = len(samples)
    per_window, total = windows.inside[0].shape
    orientation = np.empty((total, per_window, 4))
    vertical = np.empty((total, per_window, 3))
    chunk = max(1, CHUNK // per_window)
    for first in range(0, total, chunk):
        part = slice(first, min(first + chunk, total))
        local = windows.inside[0][:, part], windows.inside[1][:, part]
        q = rot.multiply((start[0][part], start[1][part]), local)
        if windows.lost_s[part].any():
            _beyond_holes(q, start, windows, samples, part)
        up = rot.vertical(q)
        if samples.averaged:
            rate = _columns(samples.angular_rate_radps, per_window, part)
            rate -= bias_radps[:, None, None]
            rate *= _columns(samples.step_s, per_window, part)
            up = window_mean(up, rate)
        for axis, values in enumerate((q[0].real, q[0].imag, q[1].real, q[1].imag)):
            orientation[part, :, axis] = values.T
        vertical[part] = up.T
    # nobody writes to these again, and a value type need not copy them
    orientation.setflags(write=False)
    return orientation.reshape(-1, 4)[:count], vertical.reshape(-1, 3)[:count]


def _beyond_holes(
    q: Pair, start: Pair, windows: Windows, samples: Samples, part: slice
) -> None:
    """Take the samples after a hole from the end of their window, not its start."""
    per_window = len(q[0])
    lost = _columns(samples.lost_s, per_window, part) > 0.0
    # the last window has no end of its own
    holed = np.flatnonzero(
        lost.any(axis=0) & (np.arange(part.start, part.stop) + 1 < len(start[0]))
    )
    after = np.maximum.accumulate(lost[:, holed], axis=0)
    number = holed + part.start
    rotation = windows.rotation[0][number], windows.rotation[1][number]
    end = start[0][number + 1], start[1][number + 1]
    back = rot.multiply(end, rot.inverse(rotation))
    inside = windows.inside[0][:, number], windows.inside[1][:, number]
    for target, found in zip(q, rot.multiply(back, inside), strict=True):
        target[:, holed] = np.where(after, found, target[:, holed])


def window_mean(vector: Floats, turn_rad: Floats, *, inverse: bool = False) -> Floats:
    """Return the mean of a fixed vector as a turning sensor sees it.

    Its part across the axis of rotation shrinks by sin(a/2) / (a/2).

    Args:
        vector: (3, ...) as seen in the middle of the window.
        turn_rad: (3, ...) rotation over the window.
        inverse: return the vector in the middle for a given mean instead.
    """
    squared = rot.squared_norm(turn_rad)
    if squared.size and squared.max() < SMALL_SQUARED_RAD2:
        factor = 2.0 * rot.half_sinc(squared)
    else:
        factor = np.sinc(np.sqrt(squared) / (2.0 * np.pi))
    if inverse:
        # beyond a full turn nothing is left of it to be enlarged
        factor = 1.0 / np.maximum(factor, 0.1)
    along = rot.dot(vector, turn_rad)
    along *= (1.0 - factor) / np.where(squared > 0.0, squared, 1.0)
    return np.asarray(factor * vector + along * turn_rad)
