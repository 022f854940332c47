"""Open-loop strapdown integration over short windows of samples.

Everything that happens at the full rate is here; all that follows sees windows of
about 1/16 s. Standard pre-integration (Forster et al. 2017, IEEE T-RO 33(1):1,
section V).
"""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.samples import InertialSamples, window_mean

# At a time, so that intermediate arrays stay in the cache of a core; run_time.py: half of
# it costs 7 % more, twice as many save 2 %.
CHUNK_SAMPLES = 8192


@dataclass(frozen=True, slots=True, eq=False)
class Windows:
    """What the sensor did in each window, in its own frame at the window's start.

    Attributes:
        duration_s: (n,).
        rotation: from the end of the window to its start, (n,).
        impulse_mps: (3, n) the integral of the specific force.
        turn_rad: (3, n) the integral of the angular rate.
        power_m2ps3: (n,) the integral of the squared specific force.
        lost_s: (n,) sum of the samples'.
        doubt_s: (n,) sum of the samples'.
        inside: orientation of each sample relative to the start, (per window, n).
    """

    duration_s: Floats
    rotation: Pair
    impulse_mps: Floats
    turn_rad: Floats
    power_m2ps3: Floats
    lost_s: Floats
    doubt_s: Floats
    inside: Pair


def integrate(
    samples: InertialSamples, per_window: int, bias_radps: Floats, matrix: Floats
) -> Windows:
    """Return the windows of some samples; the last one may be shorter.

    Args:
        samples: of one block, averaged ones `at_middles`.
        per_window: how many samples make a window.
        bias_radps: (3,) of the gyro.
        matrix: (3, 3) of the gyro's errors: what it reads beside the bias is
            (1 + matrix) times the angular rate.
    """
    correct = np.linalg.inv(np.eye(3) + matrix) if matrix.any() else None
    total = -(-len(samples) // per_window)
    inside = (
        np.empty((per_window, total), complex),
        np.empty((per_window, total), complex),
    )
    rotation = np.empty(total, complex), np.empty(total, complex)
    impulse, turned = np.empty((3, total)), np.empty((3, total))
    duration, power = np.empty(total), np.empty(total)
    chunk = max(1, CHUNK_SAMPLES // per_window)
    for start in range(0, total, chunk):
        part = slice(start, min(start + chunk, total))
        step = _columns(samples.step_s, per_window, part)
        force = _columns(samples.specific_force_mps2, per_window, part)
        turn = _columns(samples.angular_rate_radps, per_window, part)
        turn -= bias_radps[:, None, None]
        turn *= step
        if correct is not None:
            turn = (correct @ turn.reshape(3, -1)).reshape(turn.shape)
        ends = local = _products(rot.exponential(turn))
        if samples.middle_rad is not None:
            half = 0.5 * turn + _columns(samples.middle_rad, per_window, part)
            local = rot.exponential(half)
            before = ends[0][:-1], ends[1][:-1]
            later = rot.multiply(before, (local[0][1:], local[1][1:]))
            local[0][1:], local[1][1:] = later
        inside[0][:, part], inside[1][:, part] = local
        rotation[0][part], rotation[1][part] = ends[0][-1], ends[1][-1]
        turned[:, part] = turn.sum(axis=1)
        duration[part] = step.sum(axis=0)
        if samples.gain != 1.0:
            force *= samples.gain
        push = force * step
        power[part] = np.einsum("iwn,iwn->n", force, push)
        impulse[:, part] = rot.rotate(local, push).sum(axis=1)
    return Windows(
        duration,
        rotation,
        impulse,
        turned,
        power,
        samples.sums(samples.lost_s, per_window),
        samples.sums(samples.doubt_s, per_window),
        inside,
    )


def _columns(values: Floats, per_window: int, part: slice) -> Floats:
    """Return ([3,] per_window, windows) of the (n[, 3]) samples, zeros at the end."""
    start, stop = part.start * per_window, part.stop * per_window
    values = values[start:stop]
    short = stop - start - len(values)
    if short:
        values = np.concatenate([values, np.zeros((short, *values.shape[1:]))])
    shaped = values.reshape(part.stop - part.start, per_window, *values.shape[1:])
    return np.array(shaped.T, order="C")


def _products(steps: Pair) -> Pair:
    """Return the running products along each window, in place."""
    first, second = steps
    for row in range(1, len(first)):
        first[row], second[row] = rot.multiply(
            (first[row - 1], second[row - 1]), (first[row], second[row])
        )
    return first, second


def spread(
    start: Pair, windows: Windows, samples: InertialSamples, bias_radps: Floats
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
    chunk = max(1, CHUNK_SAMPLES // per_window)
    for first in range(0, total, chunk):
        part = slice(first, min(first + chunk, total))
        local = windows.inside[0][:, part], windows.inside[1][:, part]
        q = rot.multiply((start[0][part], start[1][part]), local)
        if windows.lost_s[part].any():
            _after_gaps(q, start, windows, samples, part)
        up = rot.vertical(q)
        if samples.middle_rad is not None:
            rate = _columns(samples.angular_rate_radps, per_window, part)
            rate -= bias_radps[:, None, None]
            rate *= _columns(samples.step_s, per_window, part)
            up = window_mean(up, rate)
        orientation[part] = rot.to_wxyz((q[0].T, q[1].T))
        vertical[part] = up.T
    # read-only, so that a value type need not copy it
    orientation.setflags(write=False)
    return orientation.reshape(-1, 4)[:count], vertical.reshape(-1, 3)[:count]


def _after_gaps(
    q: Pair, start: Pair, windows: Windows, samples: InertialSamples, part: slice
) -> None:
    """Take the samples after a gap from the end of their window, not its start."""
    lost = _columns(samples.lost_s, len(q[0]), part) > 0.0
    # the last window has no end of its own
    has_end = np.arange(part.start, part.stop) + 1 < len(start[0])
    gaps = np.flatnonzero(lost.any(axis=0) & has_end)
    after = np.maximum.accumulate(lost[:, gaps], axis=0)
    number = gaps + part.start
    rotation = windows.rotation[0][number], windows.rotation[1][number]
    end = start[0][number + 1], start[1][number + 1]
    back = rot.multiply(end, rot.inverse(rotation))
    inside = windows.inside[0][:, number], windows.inside[1][:, number]
    for target, found in zip(q, rot.multiply(back, inside), strict=True):
        target[:, gaps] = np.where(after, found, target[:, gaps])
