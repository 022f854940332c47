"""The inner loops of the smoother, compiled by numba.

The same formulas as in `strapdown`, `nodes`, `linearise`, `calibrated` and `rotations`,
where they are explained. Imported by `fast` alone, once it is known that compiled code
is wanted and can be kept.

All is in one file, because numba's cache does not see that another one has changed.
It takes seconds to compile, by the number of operations in the text: hence complex
numbers (rotations are pairs of them, see `rotations`), few tables, and loops over axes.
What belongs to a window or node comes first in an array.
"""

import math
from typing import Any

from hapticplayer.motion.smoother.jit import (
    BOOL,
    COLUMN,
    FLAGS,
    FLOAT,
    IN1,
    IN2,
    IN4,
    INT,
    NOTHING,
    OUT1,
    OUT2,
    OUT3,
    OUT4,
    OUT_PAIRS,
    OUT_PAIRS_BY_TWO,
    PAIRS,
    PAIRS_BY_TWO,
    compiled,
    inner,
)

# Columns of the table of windows, and of that of nodes: impulse and turn have three.
IMPULSE, TURN, DURATION, POWER, LOST, DOUBT, WINDOW_COLUMNS = 0, 3, 6, 7, 8, 9, 10
AT_DURATION, AT_POWER, AT_LOST, AT_DOUBT, AT_TURNED, NODE_COLUMNS = 3, 4, 5, 6, 7, 8

# cos(a / 2) and sin(a / 2) / a in powers of a^2, exact to 1e-16 up to a^2 = 0.04
COSINE = tuple((-0.25) ** k / math.factorial(2 * k) for k in range(6))
HALF_SINC = tuple(0.5 * (-0.25) ** k / math.factorial(2 * k + 1) for k in range(6))


@inner
def _multiply(a1: complex, b1: complex, a2: complex, b2: complex) -> Any:
    """Return the Hamilton product."""
    return a1 * a2 - b1 * b2.conjugate(), a1 * b2 + b1 * a2.conjugate()


@inner
def _halves(squared: float) -> Any:
    """Return cos(a / 2) and sin(a / 2) / a for a squared angle."""
    if squared < 1e-4:  # most samples are done with three terms
        cosine = (COSINE[2] * squared + COSINE[1]) * squared + COSINE[0]
        sine = (HALF_SINC[2] * squared + HALF_SINC[1]) * squared + HALF_SINC[0]
        return cosine, sine
    if squared < 0.04:
        cosine, sine = COSINE[5], HALF_SINC[5]
        for k in range(4, -1, -1):
            cosine = cosine * squared + COSINE[k]
            sine = sine * squared + HALF_SINC[k]
        return cosine, sine
    angle = math.sqrt(squared)
    return math.cos(0.5 * angle), math.sin(0.5 * angle) / angle


@inner
def _exponential(x: float, y: float, z: float) -> Any:
    """Return the rotation of a rotation vector."""
    w, by = _halves(x * x + y * y + z * z)
    return complex(w, by * x), complex(by * y, by * z)


@inner
def _rotate(first: complex, second: complex, x: float, y: float, z: float) -> Any:
    """Return q v q*."""
    w, i, j, k = first.real, first.imag, second.real, second.imag
    t0, t1, t2 = j * z - k * y, k * x - i * z, i * y - j * x
    return (
        x + 2.0 * (w * t0 + (j * t2 - k * t1)),
        y + 2.0 * (w * t1 + (k * t0 - i * t2)),
        z + 2.0 * (w * t2 + (i * t1 - j * t0)),
    )


@inner
def _unit(first: complex, second: complex) -> Any:
    size = (first * first.conjugate() + second * second.conjugate()).real
    scale = 1.0 / math.sqrt(size)
    return scale * first, scale * second


@inner
def _shortest(x: float, y: float, z: float, a: float, b: float, c: float) -> Any:
    """Return the smallest rotation from unit vector (x, y, z) to (a, b, c)."""
    w = 1.0 + (x * a + y * b + z * c)
    if w < 1e-9:  # opposite: half a turn about an axis across
        w = 0.0
        least = min(abs(x), abs(y), abs(z))
        a = 1.0 * (abs(x) == least)
        b = (1.0 - a) * (abs(y) == least)
        c = 1.0 - a - b
    return _unit(complex(w, y * c - z * b), complex(z * a - x * c, x * b - y * a))


@inner
def _window_mean(
    x: float, y: float, z: float, a: float, b: float, c: float, back: float
) -> Any:
    """Return the mean of vector (x, y, z) over a turn (a, b, c).

    Or what has it as its mean, where `back` is 1 and not 0.
    """
    squared = a * a + b * b + c * c
    factor = 2.0 * _halves(squared)[1]
    if back > 0.0:
        factor = 1.0 / max(factor, 0.1)
    along = (x * a + y * b + z * c) * (1.0 - factor)
    if squared > 0.0:
        along /= squared
    return factor * x + along * a, factor * y + along * b, factor * z + along * c


@compiled(
    *(NOTHING, IN1, IN2, IN2, IN1, IN1, IN2, FLOAT, BOOL, FLAGS, INT),
    *(OUT_PAIRS_BY_TWO, OUT_PAIRS, OUT2),
)
def integrate(
    step: Any,
    force: Any,
    rate: Any,
    lost: Any,
    doubt: Any,
    calibration: Any,
    gain: float,
    averaged: bool,
    calm: Any,
    chunk: int,
    inside: Any,
    rotation: Any,
    windows: Any,
) -> None:
    """See `strapdown.integrate`.

    Args:
        step, force, rate, lost, doubt: of the samples.
        calibration: (4, 3) what the turn is multiplied with, and the gyro's bias.
        gain: of the accelerometer.
        averaged: whether the samples are.
        calm: (chunks,) whether turns add up.
        chunk: windows of each.
        inside: (windows, per window, 2) orientations.
        rotation: (windows, 2).
        windows: (windows, WINDOW_COLUMNS).
    """
    count = len(step)
    total, per_window = inside.shape[0], inside.shape[1]
    bias0, bias1, bias2 = calibration[3, 0], calibration[3, 1], calibration[3, 2]
    m00, m01, m02 = calibration[0, 0], calibration[0, 1], calibration[0, 2]
    m10, m11, m12 = calibration[1, 0], calibration[1, 1], calibration[1, 2]
    m20, m21, m22 = calibration[2, 0], calibration[2, 1], calibration[2, 2]
    # the turns of three neighbours, as the gyro saw them
    p0, p1, p2 = 0.0, 0.0, 0.0
    x0 = (rate[0, 0] - bias0) * step[0]
    x1 = (rate[0, 1] - bias1) * step[0]
    x2 = (rate[0, 2] - bias2) * step[0]
    for w in range(total):
        q0, q1 = complex(1.0, 0.0), complex(0.0, 0.0)
        turn0, turn1, turn2 = 0.0, 0.0, 0.0
        v0, v1, v2 = 0.0, 0.0, 0.0
        duration, power, unknown, doubtful = 0.0, 0.0, 0.0, 0.0
        calmly = calm[w // chunk]
        first = w * per_window
        for k in range(first, min(first + per_window, count)):
            dt = step[k]
            t0 = m00 * x0 + m01 * x1 + m02 * x2
            t1 = m10 * x0 + m11 * x1 + m12 * x2
            t2 = m20 * x0 + m21 * x1 + m22 * x2
            d0, d1, d2 = 0.0, 0.0, 0.0
            n0, n1, n2 = 0.0, 0.0, 0.0
            if k < count - 1:
                after = step[k + 1]
                n0 = (rate[k + 1, 0] - bias0) * after
                n1 = (rate[k + 1, 1] - bias1) * after
                n2 = (rate[k + 1, 2] - bias2) * after
                if k > 0:
                    d0, d1, d2 = n0 - p0, n1 - p1, n2 - p2
            p0, p1, p2 = x0, x1, x2
            x0, x1, x2 = n0, n1, n2
            turn0, turn1, turn2 = turn0 + t0, turn1 + t1, turn2 + t2
            f0, f1, f2 = gain * force[k, 0], gain * force[k, 1], gain * force[k, 2]
            at0, at1 = q0, q1
            if averaged:
                f0, f1, f2 = _window_mean(f0, f1, f2, t0, t1, t2, 1.0)
                a, b = _exponential(
                    0.5 * t0 - d0 / 16.0, 0.5 * t1 - d1 / 16.0, 0.5 * t2 - d2 / 16.0
                )
                at0, at1 = _multiply(q0, q1, a, b)
                c0, c1, c2 = t1 * d2 - t2 * d1, t2 * d0 - t0 * d2, t0 * d1 - t1 * d0
                t0, t1, t2 = t0 + c0 / 24.0, t1 + c1 / 24.0, t2 + c2 / 24.0
            if calmly:
                q0, q1 = complex(1.0, 0.0), complex(0.0, 0.0)
                t0, t1, t2 = turn0, turn1, turn2
            a, b = _exponential(t0, t1, t2)
            q0, q1 = _multiply(q0, q1, a, b)
            if not averaged:
                at0, at1 = q0, q1
            inside[w, k - first, 0], inside[w, k - first, 1] = at0, at1
            duration += dt
            power += f0 * f0 + f1 * f1 + f2 * f2
            unknown += lost[k]
            doubtful += doubt[k]
            f0, f1, f2 = _rotate(at0, at1, f0 * dt, f1 * dt, f2 * dt)
            v0, v1, v2 = v0 + f0, v1 + f1, v2 + f2
        for m in range(count - first, per_window):
            inside[w, m, 0], inside[w, m, 1] = q0, q1
        rotation[w, 0], rotation[w, 1] = q0, q1
        windows[w, 0], windows[w, 1], windows[w, 2] = v0, v1, v2
        windows[w, 3], windows[w, 4], windows[w, 5] = turn0, turn1, turn2
        windows[w, 6] = duration
        windows[w, 7] = power * duration / min(per_window, count - first)
        windows[w, 8], windows[w, 9] = unknown, doubtful


@compiled(*(NOTHING, PAIRS, IN2, INT), *(OUT_PAIRS, OUT_PAIRS, OUT2, OUT4, OUT2))
def gather(
    rotation: Any,
    windows: Any,
    per_node: int,
    start: Any,
    at: Any,
    nodes: Any,
    levers: Any,
    axes: Any,
) -> None:
    """See `nodes.gather`; `nodes` and `levers` are zero before.

    Args:
        rotation, windows: from `integrate`.
        per_node: windows.
        start: (windows, 2).
        at: (K + 1, 2).
        nodes: (K, NODE_COLUMNS).
        levers: (K, 3, 3, 1 or 4) mean matrices times duration (and turn x, y, z).
        axes: (3, 3) scratch, the identity before: the sensor's at a window's start.
    """
    total, columns = len(rotation), levers.shape[3]
    fastest = 0.0
    for w in range(total):
        x, y, z = windows[w, 3], windows[w, 4], windows[w, 5]
        fastest = max(fastest, x * x + y * y + z * z)
    q0, q1 = complex(1.0, 0.0), complex(0.0, 0.0)
    at[0, 0], at[0, 1] = q0, q1
    for w in range(total):
        k = w // per_node
        start[w, 0], start[w, 1] = q0, q1
        x, y, z = windows[w, 3], windows[w, 4], windows[w, 5]
        nodes[k, 7] += math.sqrt(x * x + y * y + z * z)
        for m in range(3, 7):
            nodes[k, m] += windows[w, m + 3]
        u = _rotate(q0, q1, windows[w, 0], windows[w, 1], windows[w, 2])
        for i in range(3):
            nodes[k, i] += u[i]
        next0, next1 = _multiply(q0, q1, rotation[w, 0], rotation[w, 1])
        # a product of two units hardly differs from one: no root is needed
        off = (next0 * next0.conjugate() + next1 * next1.conjugate()).real - 1.0
        next0, next1 = next0 - 0.5 * off * next0, next1 - 0.5 * off * next1
        # the mean over a window: that of its ends, or exactly
        mean0, mean1 = next0, next1
        if w == total - 1:
            mean0, mean1 = q0, q1
        if fastest >= 1.0:
            mean0, mean1 = _exponential(0.5 * x, 0.5 * y, 0.5 * z)
            mean0, mean1 = _multiply(q0, q1, mean0, mean1)
        for j in range(3):
            e0, e1, e2 = 1.0 * (j == 0), 1.0 * (j == 1), 1.0 * (j == 2)
            if fastest >= 1.0:
                e0, e1, e2 = _window_mean(e0, e1, e2, x, y, z, 0.0)
            v = _rotate(mean0, mean1, e0, e1, e2)
            for i in range(3):
                mean = v[i]
                if fastest < 1.0:
                    mean, axes[j, i] = 0.5 * (axes[j, i] + mean), mean
                levers[k, i, j, 0] += mean * windows[w, 6]
                if columns > 1:
                    levers[k, i, j, 1] += mean * x
                    levers[k, i, j, 2] += mean * y
                    levers[k, i, j, 3] += mean * z
        q0, q1 = next0, next1
        at[k + 1, 0], at[k + 1, 1] = q0, q1
    for k in range(len(nodes)):
        x, y, z = nodes[k, 0], nodes[k, 1], nodes[k, 2]
        mean_power = (x * x + y * y + z * z) / max(nodes[k, 3], 1e-9)
        nodes[k, 4] = max(nodes[k, 4] - mean_power, 0.0)


@compiled(NOTHING, COLUMN, COLUMN, IN2, BOOL, OUT2)
def rotate(first: Any, second: Any, vector: Any, inverse: bool, out: Any) -> None:
    """Turn vectors (3, n) by rotations (n,), or back."""
    for k in range(len(first)):
        q0, q1 = first[k], second[k]
        if inverse:
            q0, q1 = q0.conjugate(), -q1
        v = _rotate(q0, q1, vector[0, k], vector[1, k], vector[2, k])
        out[0, k], out[1, k], out[2, k] = v


@compiled(
    *(NOTHING, IN2, IN2, IN4, PAIRS, IN1, IN1, INT, OUT_PAIRS, OUT3, OUT2, OUT1),
)
def linearise(
    vertical: Any,
    nodes: Any,
    levers: Any,
    ends: Any,
    bound: Any,
    noises: Any,
    columns: int,
    frames: Any,
    rows: Any,
    weights: Any,
    bound_weight: Any,
) -> None:
    """See `linearise.linearised`; what is written is zero before.

    Args:
        vertical: (3, K + 1).
        nodes, levers: from `gather`.
        ends: (K + 1, 2) orientations at the nodes.
        bound: (K + 1,) of the velocity.
        noises: gravity; then squared the rate noise, rotation error, lost rate, force
            noise, force error and doubtful force.
        columns: with those of `travel` there are more.
        frames: (K + 1, 2) level.
        rows: (K, 5, columns or more), see `Problem`.
        weights: (2, K) of tilt and velocity.
        bound_weight: (K + 1,).
    """
    x, y, z = vertical[0, 0], vertical[1, 0], vertical[2, 0]
    nearest = 1.0
    for k in range(len(bound)):
        dot = x * vertical[0, k] + y * vertical[1, k] + z * vertical[2, k]
        nearest = min(nearest, dot)
    q0, q1 = _shortest(x, y, z, 0.0, 0.0, 1.0)
    for k in range(len(bound)):
        a, b, c = vertical[0, k], vertical[1, k], vertical[2, k]
        s0, s1 = _shortest(a, b, c, x, y, z)
        s0, s1 = _multiply(q0, q1, s0, s1)
        frames[k, 0], frames[k, 1] = s0, s1
        if nearest <= 0.5:  # by way of the first would be singular: from node to node
            x, y, z = a, b, c
            q0, q1 = _unit(s0, s1)
            frames[k, 0], frames[k, 1] = q0, q1
    for k in range(len(rows)):
        q0, q1 = frames[k, 0], frames[k, 1]
        v = _rotate(q0, q1, nodes[k, 0], nodes[k, 1], nodes[k, 2])
        for i in range(3):
            rows[k, 2 + i, 0] = v[i]
            rows[k, 2 + i, 7] = -v[i]
        rows[k, 4, 0] -= noises[0] * nodes[k, 3]
        v = _rotate(
            frames[k + 1, 0],
            frames[k + 1, 1],
            vertical[0, k],
            vertical[1, k],
            vertical[2, k],
        )
        rows[k, 0, 0], rows[k, 1, 0] = v[0], v[1]
        for j in range(3):
            for c in range(levers.shape[3]):
                v = _rotate(
                    q0, q1, levers[k, 0, j, c], levers[k, 1, j, c], levers[k, 2, j, c]
                )
                at = 7 + 3 * j + c
                if c == 0:
                    at = 1 + j
                    for i in range(3):
                        rows[k, 2 + i, 4 + j] = -v[i]
                # a rotation w of frame I moves the vertical z by w x z = (w_y, -w_x)
                if at < columns:
                    rows[k, 0, at], rows[k, 1, at] = v[1], -v[0]
        if columns < rows.shape[2]:
            q0, q1 = _multiply(q0, q1, ends[k, 0], ends[k, 1])
            s0, s1 = frames[k + 1, 0], frames[k + 1, 1]
            s0, s1 = _multiply(s0, s1, ends[k + 1, 0], ends[k + 1, 1])
            for j in range(3):
                x, y, z = 1.0 * (j == 0), 1.0 * (j == 1), 1.0 * (j == 2)
                v = _rotate(q0, q1, x, y, z)
                u = _rotate(s0, s1, x, y, z)
                for i in range(3):
                    rows[k, 2 + i, columns + j] = v[i] - u[i]
        duration, lost, turned = nodes[k, 3], nodes[k, 5], nodes[k, 7]
        variance = noises[1] * duration + noises[2] * turned * turned
        weights[0, k] = 1.0 / (variance + noises[3] * lost * lost)
        doubt = noises[6] * nodes[k, 6] * nodes[k, 6]
        doubt = min(doubt, bound[k] * bound[k] + bound[k + 1] * bound[k + 1])
        variance = (noises[4] + noises[5] * nodes[k, 4]) * duration
        weights[1, k] = 1.0 / (variance + doubt)
        bound_weight[k] += 0.5 * duration
        bound_weight[k + 1] += 0.5 * duration
    for k in range(len(bound)):
        bound_weight[k] /= 2.0 * bound[k] * bound[k]


@compiled(
    *(NOTHING, IN2, PAIRS, IN2, PAIRS, PAIRS_BY_TWO, PAIRS),
    *(IN1, IN1, IN2, IN1, BOOL, OUT_PAIRS, OUT2, OUT2),
)
def spread(
    tilt: Any,
    frames: Any,
    share: Any,
    start: Any,
    inside: Any,
    rotation: Any,
    lost: Any,
    step: Any,
    rate: Any,
    bias: Any,
    averaged: bool,
    level: Any,
    orientation: Any,
    vertical: Any,
) -> None:
    """See `nodes.levelled`, `nodes.between` and `strapdown.spread`.

    Args:
        tilt: (2, K + 1) in the level frames.
        frames: (K + 1, 2).
        share: (1 or K, per node) how far each window's start is from node to node.
        start, inside, rotation: of the windows, in frame I.
        lost, step, rate: of the samples.
        bias: (3,) of the gyro.
        averaged: whether the samples are.
        level: (windows + K + 1, 2) scratch.
        orientation: (n, 4).
        vertical: (n, 3).
    """
    total, per_window, per_node = len(start), inside.shape[1], share.shape[1]
    for k in range(len(frames)):
        x, y = tilt[0, k], tilt[1, k]
        z = 1.0 / math.sqrt(x * x + y * y + 1.0)
        q0, q1 = _shortest(z * x, z * y, z, 0.0, 0.0, 1.0)
        q0, q1 = _multiply(q0, q1, frames[k, 0], frames[k, 1])
        level[total + k, 0], level[total + k, 1] = _unit(q0, q1)
    for w in range(total):
        k = w // per_node
        part = share[min(k, len(share) - 1), w - k * per_node]
        k += total
        q0 = level[k, 0] + part * (level[k + 1, 0] - level[k, 0])
        q1 = level[k, 1] + part * (level[k + 1, 1] - level[k, 1])
        q0, q1 = _multiply(q0, q1, start[w, 0], start[w, 1])
        level[w, 0], level[w, 1] = _unit(q0, q1)
    s0, s1 = level[0, 0], level[0, 1]
    for k in range(len(step)):
        w = k // per_window
        m = k - w * per_window
        if m == 0:
            s0, s1 = level[w, 0], level[w, 1]
        if lost[k] > 0.0 and w + 1 < total:  # from the end of the window instead
            s0, s1 = rotation[w, 0].conjugate(), -rotation[w, 1]
            s0, s1 = _multiply(level[w + 1, 0], level[w + 1, 1], s0, s1)
        q0, q1 = _multiply(s0, s1, inside[w, m, 0], inside[w, m, 1])
        orientation[k, 0], orientation[k, 1] = q0.real, q0.imag
        orientation[k, 2], orientation[k, 3] = q1.real, q1.imag
        v = _rotate(q0.conjugate(), -q1, 0.0, 0.0, 1.0)
        if averaged:
            x = (rate[k, 0] - bias[0]) * step[k]
            y = (rate[k, 1] - bias[1]) * step[k]
            z = (rate[k, 2] - bias[2]) * step[k]
            v = _window_mean(v[0], v[1], v[2], x, y, z, 0.0)
        vertical[k, 0], vertical[k, 1], vertical[k, 2] = v
