"""The inner loops of the smoother, compiled by numba.

The same formulas as in `strapdown`, `nodes`, `linearise`, `calibrated` and `rotations`,
where they are explained. Imported by `fast` alone, once it is known that compiled code
is wanted and can be kept.

All is in one file, because numba's cache does not see that another one has changed.
It takes seconds to compile, by the number of operations in the text. An element of a
matrix costs as much as three sums, the field of a record next to nothing: hence a
window, node or rotation (a pair of complex numbers, see `rotations`) is a record. min,
max and the product of complex numbers each bring a function of their own along, and are
written out. What belongs to a window or node comes first in an array.
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
    NODES,
    NOISES,
    NOTHING,
    OUT1,
    OUT2,
    OUT3,
    OUT4,
    OUT_VECTORS,
    PAIRS,
    PAIRS_BY_TWO,
    STRIDED2,
    VECTORS,
    WINDOWS,
    compiled,
    inner,
)

# cos(a / 2) and sin(a / 2) / a in powers of a^2, exact to 1e-16 up to a^2 = 0.04
COSINE = tuple((-0.25) ** k / math.factorial(2 * k) for k in range(6))
HALF_SINC = tuple(0.5 * (-0.25) ** k / math.factorial(2 * k + 1) for k in range(6))


@inner
def _multiply(a1: complex, b1: complex, a2: complex, b2: complex) -> Any:
    """Return the Hamilton product."""
    w1, i1, j1, k1 = a1.real, a1.imag, b1.real, b1.imag
    w2, i2, j2, k2 = a2.real, a2.imag, b2.real, b2.imag
    return (
        complex(
            w1 * w2 - i1 * i2 - (j1 * j2 + k1 * k2),
            w1 * i2 + i1 * w2 + (j1 * k2 - k1 * j2),
        ),
        complex(
            w1 * j2 - i1 * k2 + (j1 * w2 + k1 * i2),
            w1 * k2 + i1 * j2 + (k1 * w2 - j1 * i2),
        ),
    )


@inner
def _scaled(scale: float, first: complex, second: complex) -> Any:
    first = complex(scale * first.real, scale * first.imag)
    return first, complex(scale * second.real, scale * second.imag)


@inner
def _squared(first: complex, second: complex) -> Any:
    w, i, j, k = first.real, first.imag, second.real, second.imag
    return w * w + i * i + (j * j + k * k)


@inner
def _halves(squared: float) -> Any:
    """Return cos(a / 2) and sin(a / 2) / a for a squared angle."""
    if squared < 1e-4:  # most samples are done with three terms
        cosine = (COSINE[2] * squared + COSINE[1]) * squared + COSINE[0]
        sine = (HALF_SINC[2] * squared + HALF_SINC[1]) * squared + HALF_SINC[0]
        return cosine, sine
    if squared < 0.04:
        cosine = (COSINE[5] * squared + COSINE[4]) * squared + COSINE[3]
        cosine = (cosine * squared + COSINE[2]) * squared + COSINE[1]
        sine = (HALF_SINC[5] * squared + HALF_SINC[4]) * squared + HALF_SINC[3]
        sine = (sine * squared + HALF_SINC[2]) * squared + HALF_SINC[1]
        return cosine * squared + COSINE[0], sine * squared + HALF_SINC[0]
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
    return _scaled(1.0 / math.sqrt(_squared(first, second)), first, second)


@inner
def _shortest(x: float, y: float, z: float, a: float, b: float, c: float) -> Any:
    """Return the smallest rotation from unit vector (x, y, z) to (a, b, c)."""
    w = 1.0 + (x * a + y * b + z * c)
    if w < 1e-9:  # opposite: half a turn about an axis across
        w, a, b, c = 0.0, 1.0, 0.0, 0.0
        x2, y2, z2 = x * x, y * y, z * z
        if y2 < x2:
            x2, a, b = y2, 0.0, 1.0
        if z2 < x2:
            a, b, c = 0.0, 0.0, 1.0
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
        factor = 1.0 / factor if factor > 0.1 else 10.0
    along = (x * a + y * b + z * c) * (1.0 - factor)
    if squared > 0.0:
        along /= squared
    return factor * x + along * a, factor * y + along * b, factor * z + along * c


@compiled(
    *(NOTHING, IN1, VECTORS, VECTORS, IN1, IN1, VECTORS, FLOAT, BOOL, FLAGS, INT),
    *(PAIRS_BY_TWO, PAIRS, WINDOWS),
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
        calibration: (4,) rows of what the turn is multiplied with, and the gyro's bias.
        gain: of the accelerometer.
        averaged: whether the samples are.
        calm: (chunks,) whether turns add up.
        chunk: windows of each.
        inside: (windows, per window) orientations.
        rotation, windows: (windows,).
    """
    count = len(step)
    total, per_window = inside.shape[0], inside.shape[1]
    bias, read = calibration[3], rate[0]
    bias0, bias1, bias2 = bias.x, bias.y, bias.z
    row0, row1, row2 = calibration[0], calibration[1], calibration[2]
    m00, m01, m02 = row0.x, row0.y, row0.z
    m10, m11, m12 = row1.x, row1.y, row1.z
    m20, m21, m22 = row2.x, row2.y, row2.z
    # the turns of three neighbours, as the gyro saw them
    p0, p1, p2 = 0.0, 0.0, 0.0
    dt = step[0]
    x0, x1, x2 = (read.x - bias0) * dt, (read.y - bias1) * dt, (read.z - bias2) * dt
    for w in range(total):
        q0, q1 = complex(1.0, 0.0), complex(0.0, 0.0)
        turn0, turn1, turn2 = 0.0, 0.0, 0.0
        v0, v1, v2 = 0.0, 0.0, 0.0
        duration, power, unknown, doubtful = 0.0, 0.0, 0.0, 0.0
        calmly = calm[w // chunk]
        first = w * per_window
        stop = first + per_window
        if stop > count:
            stop = count
        for k in range(first, stop):
            dt = step[k]
            t0 = m00 * x0 + m01 * x1 + m02 * x2
            t1 = m10 * x0 + m11 * x1 + m12 * x2
            t2 = m20 * x0 + m21 * x1 + m22 * x2
            d0, d1, d2 = 0.0, 0.0, 0.0
            n0, n1, n2 = 0.0, 0.0, 0.0
            if k < count - 1:
                read, after = rate[k + 1], step[k + 1]
                n0 = (read.x - bias0) * after
                n1 = (read.y - bias1) * after
                n2 = (read.z - bias2) * after
                if k > 0:
                    d0, d1, d2 = n0 - p0, n1 - p1, n2 - p2
            p0, p1, p2 = x0, x1, x2
            x0, x1, x2 = n0, n1, n2
            turn0, turn1, turn2 = turn0 + t0, turn1 + t1, turn2 + t2
            pull = force[k]
            f0, f1, f2 = gain * pull.x, gain * pull.y, gain * pull.z
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
            here = inside[w, k - first]
            here.first, here.second = at0, at1
            duration += dt
            power += f0 * f0 + f1 * f1 + f2 * f2
            unknown += lost[k]
            doubtful += doubt[k]
            f0, f1, f2 = _rotate(at0, at1, f0 * dt, f1 * dt, f2 * dt)
            v0, v1, v2 = v0 + f0, v1 + f1, v2 + f2
        for m in range(count - first, per_window):
            here = inside[w, m]
            here.first, here.second = q0, q1
        here, window = rotation[w], windows[w]
        here.first, here.second = q0, q1
        window.x, window.y, window.z = v0, v1, v2
        window.turn_x, window.turn_y, window.turn_z = turn0, turn1, turn2
        window.duration = duration
        window.power = power * duration / (stop - first)
        window.lost, window.doubt = unknown, doubtful


@compiled(NOTHING, PAIRS, WINDOWS, INT, PAIRS, PAIRS, NODES, OUT4, OUT2)
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
        start: (windows,).
        at: (K + 1,).
        nodes: (K,).
        levers: (K, 3, 3, 1 or 4) mean matrices times duration (and turn x, y, z).
        axes: (3, 3) scratch, the identity before: the sensor's at a window's start.
    """
    total, columns = len(rotation), levers.shape[3]
    fastest = 0.0
    for w in range(total):
        window = windows[w]
        x, y, z = window.turn_x, window.turn_y, window.turn_z
        squared = x * x + y * y + z * z
        if squared > fastest:
            fastest = squared
    q0, q1 = complex(1.0, 0.0), complex(0.0, 0.0)
    here = at[0]
    here.first, here.second = q0, q1
    for w in range(total):
        k = w // per_node
        here, turned, window, node = start[w], rotation[w], windows[w], nodes[k]
        here.first, here.second = q0, q1
        x, y, z = window.turn_x, window.turn_y, window.turn_z
        node.turned += math.sqrt(x * x + y * y + z * z)
        node.duration += window.duration
        node.power += window.power
        node.lost += window.lost
        node.doubt += window.doubt
        u0, u1, u2 = _rotate(q0, q1, window.x, window.y, window.z)
        node.x += u0
        node.y += u1
        node.z += u2
        next0, next1 = _multiply(q0, q1, turned.first, turned.second)
        # a product of two units hardly differs from one: no root is needed
        off = _squared(next0, next1) - 1.0
        next0, next1 = _scaled(1.0 - 0.5 * off, next0, next1)
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
                levers[k, i, j, 0] += mean * window.duration
                if columns > 1:
                    levers[k, i, j, 1] += mean * x
                    levers[k, i, j, 2] += mean * y
                    levers[k, i, j, 3] += mean * z
        q0, q1 = next0, next1
        here = at[k + 1]
        here.first, here.second = q0, q1
    for k in range(len(nodes)):
        node = nodes[k]
        x, y, z, duration = node.x, node.y, node.z, node.duration
        if duration < 1e-9:
            duration = 1e-9
        node.power -= (x * x + y * y + z * z) / duration
        if node.power < 0.0:
            node.power = 0.0


@compiled(NOTHING, COLUMN, COLUMN, STRIDED2, BOOL, OUT_VECTORS)
def rotate(first: Any, second: Any, vector: Any, inverse: bool, out: Any) -> None:
    """Turn vectors (3, n) by rotations (n,), or back, into (n,)."""
    for k in range(len(first)):
        q0, q1, v = first[k], second[k], out[k]
        if inverse:
            q0, q1 = q0.conjugate(), -q1
        v.x, v.y, v.z = _rotate(q0, q1, vector[0, k], vector[1, k], vector[2, k])


@compiled(
    *(NOTHING, OUT_VECTORS, NODES, IN4, PAIRS, IN1, NOISES, INT),
    *(PAIRS, OUT3, OUT2, OUT1),
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
        vertical: (K + 1,).
        nodes, levers: from `gather`.
        ends: (K + 1,) orientations at the nodes.
        bound: (K + 1,) of the velocity.
        noises: (1,) squared, but gravity.
        columns: with those of `travel` there are more.
        frames: (K + 1,) level.
        rows: (K, 5, columns or more), see `Problem`.
        weights: (2, K) of tilt and velocity.
        bound_weight: (K + 1,).
    """
    noise, up = noises[0], vertical[0]
    x, y, z, nearest = up.x, up.y, up.z, 1.0
    for k in range(len(bound)):
        up = vertical[k]
        dot = x * up.x + y * up.y + z * up.z
        if dot < nearest:
            nearest = dot
    q0, q1 = _shortest(x, y, z, 0.0, 0.0, 1.0)
    for k in range(len(bound)):
        up = vertical[k]
        a, b, c = up.x, up.y, up.z
        s0, s1 = _shortest(a, b, c, x, y, z)
        s0, s1 = _multiply(q0, q1, s0, s1)
        if nearest <= 0.5:  # by way of the first would be singular: from node to node
            x, y, z = a, b, c
            s0, s1 = _unit(s0, s1)
            q0, q1 = s0, s1
        frame = frames[k]
        frame.first, frame.second = s0, s1
    for k in range(len(rows)):
        frame, after, node, up = frames[k], frames[k + 1], nodes[k], vertical[k]
        duration = node.duration
        q0, q1, s0, s1 = frame.first, frame.second, after.first, after.second
        v = _rotate(q0, q1, node.x, node.y, node.z)
        for i in range(3):
            rows[k, 2 + i, 0] = v[i]
            rows[k, 2 + i, 7] = -v[i]
        rows[k, 4, 0] -= noise.gravity * duration
        x, y, z = _rotate(s0, s1, up.x, up.y, up.z)
        rows[k, 0, 0], rows[k, 1, 0] = x, y
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
            begin, end = ends[k], ends[k + 1]
            q0, q1 = _multiply(q0, q1, begin.first, begin.second)
            s0, s1 = _multiply(s0, s1, end.first, end.second)
            for j in range(3):
                x, y, z = 1.0 * (j == 0), 1.0 * (j == 1), 1.0 * (j == 2)
                v = _rotate(q0, q1, x, y, z)
                u = _rotate(s0, s1, x, y, z)
                for i in range(3):
                    rows[k, 2 + i, columns + j] = v[i] - u[i]
        variance = noise.rate * duration + noise.rotation * node.turned * node.turned
        weights[0, k] = 1.0 / (variance + noise.lost * node.lost * node.lost)
        doubt = noise.doubt * node.doubt * node.doubt
        before, beyond = bound[k], bound[k + 1]
        most = before * before + beyond * beyond
        if doubt > most:
            doubt = most
        variance = (noise.force + noise.force_error * node.power) * duration
        weights[1, k] = 1.0 / (variance + doubt)
        bound_weight[k] = (bound_weight[k] + duration) / (4.0 * before * before)
        bound_weight[k + 1] = duration
    bound_weight[len(rows)] /= 4.0 * bound[len(rows)] * bound[len(rows)]


@compiled(
    *(NOTHING, IN2, PAIRS, IN2, PAIRS, PAIRS_BY_TWO, PAIRS),
    *(IN1, IN1, VECTORS, VECTORS, BOOL, PAIRS, PAIRS, OUT_VECTORS),
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
        frames: (K + 1,).
        share: (1 or K, per node) how far each window's start is from node to node.
        start, inside, rotation: of the windows, in frame I.
        lost, step, rate: of the samples.
        bias: (1,) of the gyro.
        averaged: whether the samples are.
        level: (windows + K + 1,) scratch.
        orientation, vertical: (n,).
    """
    total, per_window, per_node = len(start), inside.shape[1], share.shape[1]
    for k in range(len(frames)):
        x, y = tilt[0, k], tilt[1, k]
        z = 1.0 / math.sqrt(x * x + y * y + 1.0)
        q0, q1 = _shortest(z * x, z * y, z, 0.0, 0.0, 1.0)
        frame, here = frames[k], level[total + k]
        q0, q1 = _multiply(q0, q1, frame.first, frame.second)
        here.first, here.second = _unit(q0, q1)
    for w in range(total):
        k = w // per_node
        part = share[k if k < len(share) else 0, w - k * per_node]
        before, after, opened = level[total + k], level[total + k + 1], start[w]
        q0, q1 = before.first, before.second
        s0, s1 = _scaled(part, after.first - q0, after.second - q1)
        q0, q1 = _multiply(q0 + s0, q1 + s1, opened.first, opened.second)
        here = level[w]
        here.first, here.second = _unit(q0, q1)
    drift, w, m, s0, s1 = bias[0], 0, 0, level[0].first, level[0].second
    for k in range(len(step)):
        if m == per_window:
            w, m = w + 1, 0
        if m == 0:
            s0, s1 = level[w].first, level[w].second
        if lost[k] > 0.0 and w + 1 < total:  # from the end of the window instead
            here, turned = level[w + 1], rotation[w]
            s0, s1 = turned.first.conjugate(), -turned.second
            s0, s1 = _multiply(here.first, here.second, s0, s1)
        here, row, up, m = inside[w, m], orientation[k], vertical[k], m + 1
        q0, q1 = _multiply(s0, s1, here.first, here.second)
        row.first, row.second = q0, q1
        a, b, y, z = q0.real, q0.imag, q1.real, q1.imag
        x, y, z = b * z - a * y, y * z + a * b, a * a + z * z - (b * b + y * y)
        x, y = 2.0 * x, 2.0 * y
        if averaged:
            read, dt = rate[k], step[k]
            a, b, c = read.x - drift.x, read.y - drift.y, read.z - drift.z
            x, y, z = _window_mean(x, y, z, a * dt, b * dt, c * dt, 0.0)
        up.x, up.y, up.z = x, y, z
