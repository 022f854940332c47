"""Vectors and 3 x 3 matrices as tuples: at kilohertz, numpy's overhead is too much."""

import math

from hapticplayer.model.device import Vector

Rows = tuple[Vector, Vector, Vector]


def minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a: Vector, b: Vector) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def transposed_times(rows: Rows, vector: Vector) -> Vector:
    """Return the transposed matrix times a vector."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    x, y, z = vector
    return (
        a * x + d * y + g * z,
        b * x + e * y + h * z,
        c * x + f * y + i * z,
    )


def condition_bound(rows: Rows) -> float:
    """An upper bound of the condition number, 2 / |det| (norm / sqrt 3)^3.

    Guggenheimer, Edelman & Johnson 1995, "A simple estimate of the condition number
    of a linear system"; a fifth of the time that `condition` takes.
    """
    (a, b, c), (d, e, f), (g, h, i) = rows
    det = a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    squares = a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i
    if det == 0.0:
        return math.inf
    mean = squares / 3.0
    return 2.0 * mean * math.sqrt(mean) / abs(det)


def condition(rows: Rows) -> float:
    """Return the ratio of the largest to the smallest singular value.

    From the eigenvalues of A A^T in closed form (Smith 1961, "Eigenvalues of a
    symmetric 3 x 3 matrix"); good to 1e-6 for conditions below 1000, infinite for
    singular matrices.
    """
    xx, yy, zz = (dot(row, row) for row in rows)
    xy, yz, zx = dot(rows[0], rows[1]), dot(rows[1], rows[2]), dot(rows[2], rows[0])
    mean = (xx + yy + zz) / 3.0
    if mean == 0.0:
        return math.inf
    dx, dy, dz = xx - mean, yy - mean, zz - mean
    squares = dx * dx + dy * dy + dz * dz + 2.0 * (xy * xy + yz * yz + zx * zx)
    spread = math.sqrt(squares / 6.0)
    if spread < 1e-12 * mean:
        return 1.0
    det = dot((dx, xy, zx), cross((xy, dy, yz), (zx, yz, dz)))
    angle = math.acos(max(-1.0, min(1.0, 0.5 * det / spread**3))) / 3.0
    largest = mean + 2.0 * spread * math.cos(angle)
    smallest = mean + 2.0 * spread * math.cos(angle + 2.0 * math.pi / 3.0)
    return math.sqrt(largest / smallest) if smallest > 0.0 else math.inf
