"""The banded least squares of `calibrated`, compiled by numba.

Imported by `fast` alone. Columns, the constant one and those of the calibration, come
last in an array, because all of them go through the solver side by side.
"""

from typing import Any

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion.smoother.jit import (
    BANDS,
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


@inner
def _factorise(
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    free: float,
    band: Any,
) -> bool:
    """Write the matrix as L D L': D first in each row of the band, then L.

    `free` is 1, or 0 where the tilt is held at zero. Rows beyond the matrix are
    written to, and mean nothing.
    """
    count, size = len(duration), 2 * len(duration) + 2
    # what the interval before adds to a node
    tilt, slope, speed = 1.0 - free, 0.0, 0.0
    for k in range(count + 1):
        s, v = band[2 * k], band[2 * k + 1]
        s.main, s.first = tilt, slope
        v.main = speed + bound_weight[k]
        s.second = s.third = v.first = v.second = v.third = 0.0
        if k < count:
            h, wt = free * HALF_GRAVITY * duration[k], free * tilt_weight[k]
            wv = velocity_weight[k]
            speed, slope = wv + rest_weight[k], wv * h
            square = slope * h
            tilt = wt + square
            s.main += tilt
            s.first -= slope  # (v[k], s[k])
            s.second = square - wt  # (s[k+1], s[k])
            s.third = slope  # (v[k+1], s[k])
            v.main += speed
            v.first = -slope  # (s[k+1], v[k])
            v.second = -speed  # (v[k+1], v[k])
            tilt += 1.0 - free
    for j in range(size):
        row, one, two, three = band[j], band[j + 1], band[j + 2], band[j + 3]
        if not row.main > 0.0:
            return False
        first, second, third = row.first, row.second, row.third
        part = 1.0 / row.main
        row.first, row.second, row.third = part * first, part * second, part * third
        one.main -= row.first * first
        one.first -= row.first * second
        one.second -= row.first * third
        two.main -= row.second * second
        two.first -= row.second * third
        three.main -= row.third * third
    return True


@compiled(BOOL, IN2, OUT2, INT, IN1, IN1, IN1, IN1, IN1, BANDS, OUT2)
def solve(
    rows: Any,
    left: Any,
    columns: int,
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    band: Any,
    nodes: Any,
) -> bool:
    """Find tilt and velocity for all columns; see `calibrated` for the equations.

    Nothing falls upwards: that axis comes first, with a tilt that is held at zero and
    takes no part, then both horizontal ones side by side.

    Args:
        rows: (K, 5 columns) what the tilt and the velocity shall change by in each
            interval, see `Problem`.
        left: (K, 5 columns) what the solutions leave of them, weighted.
        columns: of the problem.
        duration: (K,).
        tilt_weight, velocity_weight, rest_weight: (K,).
        bound_weight: (K + 1,) of the velocity.
        band: (2 (K + 1) + 3,) scratch.
        nodes: (2 (K + 1) + 3, 2 columns) tilt and velocity of each node; nothing is
            beyond the last.

    Returns:
        Whether there is a solution.
    """
    count, size = len(rows), 2 * len(rows) + 2
    for axes in range(1, 3):
        free, width, speed = axes - 1.0, axes * columns, (6 - 2 * axes) * columns
        if not _factorise(
            *(duration, tilt_weight, velocity_weight, rest_weight, bound_weight),
            *(free, band),
        ):
            return False
        for c in range(width):
            nodes[0, c] = nodes[1, c] = 0.0
            nodes[size, c] = nodes[size + 1, c] = nodes[size + 2, c] = 0.0
        for k in range(count):
            s, v = 2 * k, 2 * k + 1
            h, wt = free * HALF_GRAVITY * duration[k], free * tilt_weight[k]
            wv = velocity_weight[k]
            for c in range(width):
                moved, pushed = wt * rows[k, c], wv * rows[k, speed + c]
                nodes[s, c] += h * pushed - moved
                nodes[v, c] -= pushed
                nodes[s + 2, c] = h * pushed + moved
                nodes[v + 2, c] = pushed
        for j in range(size):
            row = band[j]
            f1, f2, f3 = row.first, row.second, row.third
            for c in range(width):
                x = nodes[j, c]
                nodes[j + 1, c] -= f1 * x
                nodes[j + 2, c] -= f2 * x
                nodes[j + 3, c] -= f3 * x
        for j in range(size - 1, -1, -1):
            row = band[j]
            f0, f1, f2, f3 = 1.0 / row.main, row.first, row.second, row.third
            for c in range(width):
                x, y, z = nodes[j + 1, c], nodes[j + 2, c], nodes[j + 3, c]
                nodes[j, c] = f0 * nodes[j, c] - f1 * x - f2 * y - f3 * z
        for k in range(count):
            s, v = 2 * k, 2 * k + 1
            h, wt = free * HALF_GRAVITY * duration[k], free * tilt_weight[k]
            wv = velocity_weight[k]
            for c in range(width):
                here, there = nodes[s, c], nodes[s + 2, c]
                left[k, c] = wt * (rows[k, c] - there + here)
                fall = nodes[v + 2, c] - nodes[v, c] + h * (there + here)
                left[k, speed + c] = wv * (rows[k, speed + c] - fall)
    return True


@compiled(BOOL, IN1, IN1, IN1, IN1, IN1, INDICES, BANDS, OUT1)
def tilt_variances(
    duration: Any,
    tilt_weight: Any,
    velocity_weight: Any,
    rest_weight: Any,
    bound_weight: Any,
    chosen: Any,
    band: Any,
    variances: Any,
) -> bool:
    """Find the variance of one tilt at some nodes, for a known calibration.

    With the matrix L D L' it is what L leaves of a one there, squared, over D.

    Args:
        duration, tilt_weight, velocity_weight, rest_weight: (K,) as in `solve`.
        bound_weight: (K + 1,).
        chosen: (n,) nodes.
        band: (2 (K + 1) + 3,) scratch.
        variances: (n,).

    Returns:
        Whether there is one.
    """
    if not _factorise(
        duration, tilt_weight, velocity_weight, rest_weight, bound_weight, 1.0, band
    ):
        return False
    for n in range(len(chosen)):
        now, one, two, found = 1.0, 0.0, 0.0, 0.0
        for j in range(2 * chosen[n], 2 * len(bound_weight)):
            row = band[j]
            found += now * now / row.main
            one, two, now = (
                two - row.second * now,
                -row.third * now,
                one - row.first * now,
            )
        variances[n] = found
    return True
