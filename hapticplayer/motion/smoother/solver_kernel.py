"""The banded least squares of `calibrated`, compiled by numba.

Imported by `fast` alone. Columns, the constant one and those of the calibration, come
last in an array, because all of them go through the solver side by side.
"""

from typing import Any

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion.smoother.jit import (
    BOOL,
    IN1,
    IN2,
    INDICES,
    INT,
    OUT1,
    OUT2,
    compiled,
    inner,
)

HALF_GRAVITY = 0.5 * STANDARD_GRAVITY_MPS2


@inner(BOOL, IN1, IN1, IN1, IN1, IN1, BOOL, OUT2)
def _factorise(
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    upright: bool,
    band: Any,
) -> bool:
    """Write the matrix as L D L': D first in each row of the band, then L."""
    count, size = len(duration), len(band)
    for k in range(count):
        s, v = 2 * k, 2 * k + 1
        h, wt, wv = HALF_GRAVITY * duration[k], tilt_weight[k], velocity_weight[k]
        if upright:
            h, wt = 0.0, 0.0
            band[s, 0] = 1.0
        side, slope = wv + rest_weight[k], wv * h
        square = slope * h
        band[s, 0] += wt + square
        band[s, 1] -= slope  # (v[k], s[k])
        band[s, 2] = square - wt  # (s[k+1], s[k])
        band[s, 3] = slope  # (v[k+1], s[k])
        band[v, 0] += side + bound_weight[k]
        band[v, 1] = -slope  # (s[k+1], v[k])
        band[v, 2] = -side  # (v[k+1], v[k])
        band[s + 2, 0] += wt + square
        band[s + 2, 1] += slope  # (v[k+1], s[k+1])
        band[v + 2, 0] += side
    band[size - 1, 0] += bound_weight[count]
    if upright:
        band[size - 2, 0] = 1.0
    for j in range(size):
        if not band[j, 0] > 0.0:
            return False
        width = min(4, size - j)
        for i in range(1, width):
            factor = band[j, i] / band[j, 0]
            for m in range(i, width):
                band[j + i, m - i] -= factor * band[j, m]
            band[j, i] = factor
    return True


@compiled(BOOL, IN2, OUT2, INT, IN1, IN1, IN1, IN1, IN1, BOOL, OUT2, OUT2)
def solve(
    rows: Any,
    left: Any,
    speed: int,
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    upright: bool,
    band: Any,
    nodes: Any,
) -> bool:
    """Find tilt and velocity for all columns; see `calibrated` for the equations.

    Args:
        rows: (K, any) what the tilt shall change by in each interval, column by column
            from the first one on, and the velocity, from `speed` on.
        left: (K, any) what the solutions leave of them, weighted.
        speed: the first column of the velocity.
        duration: (K,).
        tilt_weight, velocity_weight, rest_weight: (K,).
        bound_weight: (K + 1,) of the velocity.
        upright: nothing falls upwards; the tilt is held at zero and takes no part.
        band: (2 (K + 1), 4) zero before.
        nodes: (2 (K + 1), columns) tilt and velocity of each node; zero before.

    Returns:
        Whether there is a solution.
    """
    if not _factorise(
        duration, tilt_weight, velocity_weight, rest_weight, bound_weight, upright, band
    ):
        return False
    count, columns = len(rows), nodes.shape[1]
    size = 2 * count + 2
    for k in range(count):
        s, v = 2 * k, 2 * k + 1
        h, wt, wv = HALF_GRAVITY * duration[k], tilt_weight[k], velocity_weight[k]
        if upright:
            h, wt = 0.0, 0.0
        for c in range(columns):
            moved, pushed = wt * rows[k, c], wv * rows[k, speed + c]
            nodes[s, c] += h * pushed - moved
            nodes[v, c] -= pushed
            nodes[s + 2, c] = h * pushed + moved
            nodes[v + 2, c] = pushed
    for j in range(size):
        for i in range(1, min(4, size - j)):
            for c in range(columns):
                nodes[j + i, c] -= band[j, i] * nodes[j, c]
    for j in range(size - 1, -1, -1):
        for c in range(columns):
            nodes[j, c] /= band[j, 0]
        for i in range(1, min(4, size - j)):
            for c in range(columns):
                nodes[j, c] -= band[j, i] * nodes[j + i, c]
    for k in range(count):
        s, v = 2 * k, 2 * k + 1
        h, wt, wv = HALF_GRAVITY * duration[k], tilt_weight[k], velocity_weight[k]
        for c in range(columns):
            here, there = nodes[s, c], nodes[s + 2, c]
            left[k, c] = wt * (rows[k, c] - there + here)
            fall = nodes[v + 2, c] - nodes[v, c] + h * (there + here)
            left[k, speed + c] = wv * (rows[k, speed + c] - fall)
    return True


@compiled(BOOL, IN1, IN1, IN1, IN1, IN1, INDICES, OUT2, OUT1, OUT1)
def tilt_variances(
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    chosen: Any,
    band: Any,
    column: Any,
    variances: Any,
) -> bool:
    """Find the variance of one tilt at some nodes, for a known calibration.

    With the matrix L D L' it is what L leaves of a one there, squared, over D.

    Args:
        duration, tilt_weight, velocity_weight, rest_weight: (K,) as in `solve`.
        bound_weight: (K + 1,).
        chosen: (n,) nodes.
        band: (2 (K + 1), 4) zero before.
        column: (2 (K + 1),) scratch.
        variances: (n,).

    Returns:
        Whether there is one.
    """
    if not _factorise(
        duration, tilt_weight, velocity_weight, rest_weight, bound_weight, False, band
    ):
        return False
    size = len(band)
    for n in range(len(chosen)):
        first = 2 * chosen[n]
        column[first:] = 0.0
        column[first] = 1.0
        variances[n] = 0.0
        for j in range(first, size):
            variances[n] += column[j] * column[j] / band[j, 0]
            for i in range(1, min(4, size - j)):
                column[j + i] -= band[j, i] * column[j]
    return True
