"""The banded least squares of `calibrated`, compiled by numba.

Imported by `fast` alone. Columns, the constant one and those of the calibration, come
last in an array, because all of them go through the solver side by side.
"""

from typing import Any

from hapticplayer.motion.smoother.jit import BOOL, IN1, IN2, INT, OUT2, compiled


@compiled(BOOL, IN2, OUT2, INT, IN2, IN1, OUT2, OUT2)
def solve(
    rows: Any,
    left: Any,
    speed: int,
    weights: Any,
    bound_weight: Any,
    band: Any,
    nodes: Any,
) -> bool:
    """Find tilt and velocity for all columns; see `calibrated` for the equations.

    Args:
        rows: (K, any) what the tilt shall change by in each interval, column by column
            from the first one on, and the velocity, from `speed` on.
        left: (K, any) what the solutions leave of them.
        speed: the first column of the velocity.
        weights: (4, K) half of g times the durations; weights of tilt, velocity, rest.
        bound_weight: (K + 1,) of the velocity.
        band: (2 (K + 1), 4) zero but for what is to be added to the matrix.
        nodes: (2 (K + 1), columns) tilt and velocity of each node; zero before.

    Returns:
        Whether there is a solution.
    """
    count, columns = len(rows), nodes.shape[1]
    size = 2 * count + 2
    for k in range(count):
        s, v = 2 * k, 2 * k + 1
        h, wt, wv = weights[0, k], weights[1, k], weights[2, k]
        side, slope = wv + weights[3, k], wv * h
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
        for c in range(columns):
            moved, pushed = wt * rows[k, c], wv * rows[k, speed + c]
            nodes[s, c] += h * pushed - moved
            nodes[v, c] -= pushed
            nodes[s + 2, c] = h * pushed + moved
            nodes[v + 2, c] = pushed
    band[size - 1, 0] += bound_weight[count]
    for j in range(size):
        if not band[j, 0] > 0.0:
            return False
        width = min(4, size - j)
        for i in range(1, width):
            factor = band[j, i] / band[j, 0]
            for m in range(i, width):
                band[j + i, m - i] -= factor * band[j, m]
            band[j, i] = factor
            for c in range(columns):
                nodes[j + i, c] -= factor * nodes[j, c]
    for j in range(size - 1, -1, -1):
        for c in range(columns):
            nodes[j, c] /= band[j, 0]
        for i in range(1, min(4, size - j)):
            for c in range(columns):
                nodes[j, c] -= band[j, i] * nodes[j + i, c]
    for k in range(count):
        s, v = 2 * k, 2 * k + 1
        for c in range(columns):
            here, there = nodes[s, c], nodes[s + 2, c]
            left[k, c] = rows[k, c] - there + here
            fall = nodes[v + 2, c] - nodes[v, c] + weights[0, k] * (there + here)
            left[k, speed + c] = rows[k, speed + c] - fall
    return True
