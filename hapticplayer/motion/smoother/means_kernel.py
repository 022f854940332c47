"""Means over windows and over the neighbourhood of nodes, compiled by numba.

Imported by `fast` alone. See `strapdown.coarse` and `linearise.local_mean`.
"""

from typing import Any

from hapticplayer.motion.smoother.jit import (
    FLOAT,
    IN1,
    IN2,
    INT,
    NOTHING,
    OUT1,
    OUT2,
    compiled,
)


@compiled(NOTHING, IN1, IN1, FLOAT, OUT2, OUT1)
def local_mean(
    values: Any, duration: Any, half_width: float, at: Any, out: Any
) -> None:
    """See `linearise.local_mean`.

    Args:
        values: (K + 1,) at the nodes.
        duration: (K,) between them.
        half_width: of the mean, in time.
        at: (3, K + 2) scratch; its first column is zero.
        out: (K + 1,).
    """
    # rows: time of the node; sums of value and width over the nodes before
    for k in range(len(out)):
        before, after = 0.0, 0.0
        if k > 0:
            before = duration[k - 1]
        if k < len(duration):
            after = duration[k]
        around = 0.5 * (before + after)
        at[0, k + 1] = at[0, k] + after
        at[1, k + 1] = at[1, k] + values[k] * around
        at[2, k + 1] = at[2, k] + around
    first, last = 0, 0
    for k in range(len(out)):
        while at[0, first] < at[0, k] - half_width:
            first += 1
        while last < len(out) and at[0, last] <= at[0, k] + half_width:
            last += 1
        out[k] = (at[1, last] - at[1, first]) / (at[2, last] - at[2, first])


@compiled(NOTHING, IN1, IN2, IN2, IN1, IN1, INT, OUT2, OUT2, OUT2)
def coarse(
    step: Any,
    force: Any,
    rate: Any,
    lost: Any,
    doubt: Any,
    per_window: int,
    spent: Any,
    mean_force: Any,
    mean_rate: Any,
) -> None:
    """See `strapdown.coarse`.

    Args:
        step, force, rate, lost, doubt: of the samples.
        per_window: samples.
        spent: (3, windows) sums of step, lost, doubt.
        mean_force, mean_rate: (windows, 3).
    """
    count = len(step)
    for w in range(len(mean_force)):
        first = w * per_window
        time, unknown, doubtful = 0.0, 0.0, 0.0
        f0, f1, f2, r0, r1, r2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(first, min(first + per_window, count)):
            dt = step[k]
            time, unknown, doubtful = time + dt, unknown + lost[k], doubtful + doubt[k]
            f0, f1, f2 = (
                f0 + dt * force[k, 0],
                f1 + dt * force[k, 1],
                f2 + dt * force[k, 2],
            )
            r0, r1, r2 = (
                r0 + dt * rate[k, 0],
                r1 + dt * rate[k, 1],
                r2 + dt * rate[k, 2],
            )
        spent[0, w], spent[1, w], spent[2, w] = time, unknown, doubtful
        part = 1.0
        if time > 0.0:
            part = 1.0 / time
        mean_force[w, 0], mean_force[w, 1], mean_force[w, 2] = (
            part * f0,
            part * f1,
            part * f2,
        )
        mean_rate[w, 0], mean_rate[w, 1], mean_rate[w, 2] = (
            part * r0,
            part * r1,
            part * r2,
        )
