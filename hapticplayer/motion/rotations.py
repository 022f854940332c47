"""Products of many rotations without a loop over samples.

A unit quaternion w + xi + yj + zk is kept as the pair of complex numbers
(w + xi, y + zi), so that q = a + b j and (a1 + b1 j)(a2 + b2 j) =
(a1 a2 - b1 b2*) + (a1 b2 + b1 a2*) j: four complex products instead of sixteen
real ones, and as few array operations. Axes come first: vectors are (3, n).
"""

import math

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

Complexes = NDArray[np.complex128]
Pair = tuple[Complexes, Complexes]

# Up to this squared angle (0.7 rad) the series below is exact to 1e-16.
SMALL_SQUARED_RAD2 = 0.5
# How many of the lowest terms are as good up to a squared angle (0.02 and 0.2 rad).
_ENOUGH_TERMS = ((4e-4, 4), (0.04, 6))
# sin(a / 2) / a in powers of a^2, highest first
_HALF_SINC = tuple(
    0.5 * (-0.25) ** k / math.factorial(2 * k + 1) for k in range(7, -1, -1)
)
# The elements of a rotation matrix, row by row, from the products w w, w x, ... z z.
_OF_PRODUCTS = np.array(
    [
        [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1],
        [0, 0, 0, -2, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1],
        [0, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0],
        [0, 0, -2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0],
        [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1],
    ],
    dtype=np.float64,
)


def half_sinc(squared_rad2: Floats) -> Floats:
    """Return sin(a / 2) / a for squared angles."""
    largest = squared_rad2.max(initial=0.0)
    if largest >= SMALL_SQUARED_RAD2:
        # np.sinc(x) = sin(pi x) / (pi x) is exact at zero
        return np.asarray(0.5 * np.sinc(np.sqrt(squared_rad2) / (2.0 * np.pi)))
    terms = next((n for limit, n in _ENOUGH_TERMS if largest < limit), len(_HALF_SINC))
    out = np.full(squared_rad2.shape, _HALF_SINC[-terms])
    for factor in _HALF_SINC[1 - terms :]:
        out *= squared_rad2
        out += factor
    return out


def multiply(left: Pair, right: Pair) -> Pair:
    """Return the Hamilton product, elementwise."""
    a1, b1 = left
    a2, b2 = right
    first = a1 * a2
    first -= b1 * b2.conj()
    second = a1 * b2
    second += b1 * a2.conj()
    return first, second


def dot(left: Floats, right: Floats) -> Floats:
    """Return the scalar product along the first axis, (3, ...)."""
    return np.asarray(left[0] * right[0] + left[1] * right[1] + left[2] * right[2])


def squared_norm(vector: Floats) -> Floats:
    """Return the squared norm along the first axis, (2 or 3, ...)."""
    out = np.square(vector[0])
    for axis in vector[1:]:
        out += np.square(axis)
    return np.asarray(out)


def cross(left: Floats, right: Floats) -> Floats:
    """Return the vector product along the first axis, (3, ...)."""
    out = np.empty(np.broadcast(left, right).shape)
    np.subtract(left[1] * right[2], left[2] * right[1], out=out[0])
    np.subtract(left[2] * right[0], left[0] * right[2], out=out[1])
    np.subtract(left[0] * right[1], left[1] * right[0], out=out[2])
    return out


def exponential(turn_rad: Floats) -> Pair:
    """Return the rotations of rotation vectors (3, ...) in rad."""
    squared = squared_norm(turn_rad)
    by = half_sinc(squared)
    first = np.empty(squared.shape, np.complex128)
    second = np.empty(squared.shape, np.complex128)
    if squared.max(initial=0.0) < SMALL_SQUARED_RAD2:
        np.sqrt(1.0 - squared * by * by, out=first.real)
    else:
        np.cos(0.5 * np.sqrt(squared), out=first.real)
    np.multiply(by, turn_rad[0], out=first.imag)
    np.multiply(by, turn_rad[1], out=second.real)
    np.multiply(by, turn_rad[2], out=second.imag)
    return first, second


def cumulative(steps: Pair) -> Pair:
    """Return the products of the first 1, 2, ... n rotations (n,).

    Pairs are multiplied, the half as many products treated the same way, and the
    places between filled in: 2 n products in log2 n array operations.
    """
    first, second = steps
    count = len(first)
    if count < 2:
        return first.copy(), second.copy()
    even = count // 2 * 2
    halves = multiply(
        (first[:even:2], second[:even:2]), (first[1:even:2], second[1:even:2])
    )
    halves = cumulative(halves)
    out = (np.empty_like(first), np.empty_like(second))
    rest = len(first[2::2])
    between = multiply(
        (halves[0][:rest], halves[1][:rest]), (first[2::2], second[2::2])
    )
    for target, source, half, filled in zip(out, steps, halves, between, strict=True):
        target[0] = source[0]
        target[1:even:2] = half
        target[2::2] = filled
    return out


def unit(pair: Pair) -> Pair:
    """Return the rotations with unit norm."""
    first, second = pair
    squared = first.real**2 + first.imag**2 + second.real**2 + second.imag**2
    scale = 1.0 / np.sqrt(squared)
    return first * scale, second * scale


def before(products: Pair) -> Pair:
    """Return the product in front of each step: identity, then all but the last."""
    first = np.empty_like(products[0])
    second = np.empty_like(products[1])
    first[:1], second[:1] = 1.0, 0.0
    first[1:], second[1:] = products[0][:-1], products[1][:-1]
    return first, second


def inverse(rotation: Pair) -> Pair:
    return rotation[0].conj(), -rotation[1]


def rotate(rotation: Pair, vector: Floats) -> Floats:
    """Return q v q* for vectors (3, ...)."""
    # numpy is slow along every second element
    w, x = rotation[0].real.copy(), rotation[0].imag.copy()
    y, z = rotation[1].real.copy(), rotation[1].imag.copy()
    v0, v1, v2 = vector
    t0 = y * v2 - z * v1
    t1 = z * v0 - x * v2
    t2 = x * v1 - y * v0
    out = np.empty_like(vector)
    np.add(v0, 2.0 * (w * t0 + (y * t2 - z * t1)), out=out[0])
    np.add(v1, 2.0 * (w * t1 + (z * t0 - x * t2)), out=out[1])
    np.add(v2, 2.0 * (w * t2 + (x * t1 - y * t0)), out=out[2])
    return out


def matrices(rotation: Pair) -> Floats:
    """Return the rotation matrices (3, 3, ...)."""
    first, second = rotation
    q = np.array([first.real, first.imag, second.real, second.imag])
    products = (q[:, None] * q).reshape(16, -1)
    return np.asarray(_OF_PRODUCTS @ products).reshape(3, 3, *first.shape)


def mean_matrices(turn_rad: Floats) -> Floats:
    """Return the means of R(t) over turns at a steady rate, (3, 3, n) for (3, n).

    The left Jacobian of SO(3): sin(a)/a I + (1 - sin(a)/a) n n' + (1 - cos(a))/a [n]x.
    """
    angle = np.maximum(np.sqrt(squared_norm(turn_rad)), 1e-12)
    n = turn_rad / angle
    sine, cosine = np.sin(angle) / angle, (1.0 - np.cos(angle)) / angle
    out = (1.0 - sine) * n[:, None] * n[None]
    for axis in range(3):
        after, last = (axis + 1) % 3, (axis + 2) % 3
        out[axis, axis] += sine
        out[last, after] += cosine * n[axis]
        out[after, last] -= cosine * n[axis]
    return np.asarray(out)


def vertical(rotation: Pair) -> Floats:
    """Return the earth's up direction in the sensor frame, (3, ...)."""
    w, x = rotation[0].real, rotation[0].imag
    y, z = rotation[1].real, rotation[1].imag
    out = np.empty((3, *w.shape))
    np.multiply(2.0, x * z - w * y, out=out[0])
    np.multiply(2.0, y * z + w * x, out=out[1])
    np.subtract(w * w + z * z, x * x + y * y, out=out[2])
    return out


def shortest(start: Floats, end: Floats) -> Pair:
    """Return the smallest rotations that take unit vectors (3, n) to others.

    Opposite vectors have no smallest one: half a turn about some axis across.
    """
    w = 1.0 + dot(start, end)
    axis = cross(start, end)
    opposite = w < 1e-9
    if opposite.any():
        across = np.zeros_like(start)
        across[np.argmin(np.abs(start), axis=0), np.arange(start.shape[1])] = 1.0
        axis = np.where(opposite, cross(start, across), axis)
        w = np.where(opposite, 0.0, w)
    return unit((w + 1j * axis[0], axis[1] + 1j * axis[2]))


def to_wxyz(rotation: Pair) -> Floats:
    """Return quaternions (..., 4)."""
    out = np.empty((*rotation[0].shape, 2), np.complex128)
    out[..., 0], out[..., 1] = rotation
    return out.view(np.float64)
