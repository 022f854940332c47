"""Means over windows and over the neighbourhood of nodes, compiled by numba.

Imported by `fast` alone. See `strapdown.coarse` and `linearise.mean_square`.
"""

from typing import Any

from hapticplayer.motion.smoother.jit import (
    ALL_SUMS,
    FLOAT,
    IN1,
    INT,
    NOTHING,
    OUT1,
    OUT2,
    OUT_VECTORS,
    STRIDED2,
    VECTORS,
    compiled,
)


@compiled(NOTHING, STRIDED2, IN1, FLOAT, ALL_SUMS, OUT1)
def mean_square(
    vectors: Any, duration: Any, half_width: float, at: Any, out: Any
) -> None:
    """See `linearise.mean_square`.

    Args:
        vectors: (2, K + 1) at the nodes.
        duration: (K,) between them.
        half_width: of the mean, in time.
        at: (K + 2,) scratch; the first is zero.
        out: (K + 1,).
    """
    # time of the node; sums of value and width over the nodes before
    before = 0.0
    for k in range(len(out)):
        after = duration[k] if k < len(duration) else 0.0
        here, there = at[k], at[k + 1]
        around = 0.5 * (before + after)
        there.time = here.time + after
        x, y = vectors[0, k], vectors[1, k]
        there.value = here.value + (x * x + y * y) * around
        there.width = here.width + around
        before = after
    first, last = 0, 0
    for k in range(len(out)):
        time = at[k].time
        while at[first].time < time - half_width:
            first += 1
        while last < len(out) and at[last].time <= time + half_width:
            last += 1
        here, there = at[first], at[last]
        out[k] = (there.value - here.value) / (there.width - here.width)


@compiled(
    *(NOTHING, IN1, VECTORS, VECTORS, IN1, IN1, INT, OUT2, OUT_VECTORS, OUT_VECTORS),
)
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
        mean_force, mean_rate: (windows,).
    """
    count = len(step)
    for w in range(len(mean_force)):
        first = w * per_window
        time, unknown, doubtful = 0.0, 0.0, 0.0
        f0, f1, f2, r0, r1, r2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        stop = first + per_window
        if stop > count:
            stop = count
        for k in range(first, stop):
            dt = step[k]
            time, unknown, doubtful = time + dt, unknown + lost[k], doubtful + doubt[k]
            pull, turn = force[k], rate[k]
            f0, f1, f2 = f0 + dt * pull.x, f1 + dt * pull.y, f2 + dt * pull.z
            r0, r1, r2 = r0 + dt * turn.x, r1 + dt * turn.y, r2 + dt * turn.z
        spent[0, w], spent[1, w], spent[2, w] = time, unknown, doubtful
        part = 1.0 / time if time > 0.0 else 1.0
        pull, turn = mean_force[w], mean_rate[w]
        pull.x, pull.y, pull.z = part * f0, part * f1, part * f2
        turn.x, turn.y, turn.z = part * r0, part * r1, part * r2
