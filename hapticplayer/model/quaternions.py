"""Quaternions: wxyz, Hamilton, unit, sensor to earth (z up).

v_earth = q v_sensor q*. The vertical seen by the sensor is the third row of R(q).
"""

import numpy as np

from hapticplayer.model.arrays import Floats


def multiply(left: Floats, right: Floats) -> Floats:
    """Return the Hamilton product of (..., 4) and (..., 4)."""
    w1, x1, y1, z1 = (left[..., k] for k in range(4))
    w2, x2, y2, z2 = (right[..., k] for k in range(4))
    product: Floats = np.stack(
        [
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
        ],
        axis=-1,
    )
    return product


def chained(turns: Floats) -> Floats:
    """Return the products of unit quaternions (..., K, 4) from the first up to each.

    Each step doubles how many are multiplied: log2(K) products of arrays.
    """
    products, reach = turns.copy(), 1
    while reach < products.shape[-2]:
        products[..., reach:, :] = multiply(
            products[..., :-reach, :], products[..., reach:, :]
        )
        reach *= 2
    return products


def conjugate(q: Floats) -> Floats:
    """Return the inverse rotation of unit quaternions (..., 4)."""
    return np.asarray(q * np.array([1.0, -1.0, -1.0, -1.0]))


def rotate(q: Floats, v: Floats) -> Floats:
    """Rotate vectors (..., 3) from sensor to earth by (..., 4)."""
    w, r = q[..., :1], q[..., 1:]
    twice = 2.0 * np.cross(r, v)
    return np.asarray(v + w * twice + np.cross(r, twice))


def from_rotation_vector(phi_rad: Floats) -> Floats:
    """Return exp(phi / 2) for rotation vectors (..., 3) in rad."""
    angle = np.linalg.norm(phi_rad, axis=-1, keepdims=True)
    # np.sinc(x) = sin(pi x) / (pi x) is exact at zero
    half_sinc = 0.5 * np.sinc(angle / (2.0 * np.pi))
    return np.concatenate([np.cos(0.5 * angle), half_sinc * phi_rad], axis=-1)


def to_rotation_vector(q: Floats) -> Floats:
    """Return the rotation vectors (N, 3), rad, of at most half a turn, of (N, 4)."""
    q = np.where(q[:, :1] < 0.0, -q, q)
    sine = np.linalg.norm(q[:, 1:], axis=1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, q[:, :1])
    safe = np.where(sine > 1e-12, sine, 1.0)
    return np.where(sine > 1e-12, q[:, 1:] / safe * angle, 2.0 * q[:, 1:])


def vertical(q: Floats) -> Floats:
    """Return the earth's up direction in the sensor frame, (..., 3)."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    return np.stack(
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            w * w - x * x - y * y + z * z,
        ],
        axis=-1,
    )


def normalized(q: Floats) -> Floats:
    """Return q with unit norm."""
    return np.asarray(q / np.linalg.norm(q, axis=-1, keepdims=True))


def interpolate(query_s: Floats, time_s: Floats, q: Floats) -> Floats:
    """Return orientations at `query_s` (M,) between samples (N,), (N, 4).

    Normalised linear interpolation with aligned signs: within 1e-6 rad of the
    great arc for the steps of a few degrees that an IMU log has. Outside the
    range the end values hold.
    """
    q = q.copy()
    flips = np.cumprod(np.where(np.sum(q[1:] * q[:-1], axis=1) < 0.0, -1.0, 1.0))
    q[1:] *= flips[:, None]
    columns = [np.interp(query_s, time_s, q[:, i]) for i in range(4)]
    return normalized(np.stack(columns, axis=1))
