"""Rotation and direction of travel of a camera between two frames.

A static world moves in the frame by a part that depends on the rotation alone, and by a
part along lines through the focus of expansion that depends on the distance of each point
(H. C. Longuet-Higgins and K. Prazdny, The interpretation of a moving retinal image, 1980).
What is across those lines is fitted, so that distances need not be known (A. R. Bruss
and B. K. P. Horn, Passive navigation, 1983). What is along them counts as little as the
parallax is large: all of it for a camera that only rotates, next to nothing for one that
travels. The direction of travel may swing in the camera's own frame, as it does on a horse
or on foot: held tighter, the swing is taken for a rotation.

Coordinates are the camera's: x right, y down, z ahead; points are at z = 1.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

AHEAD = np.array([0.0, 0.0, 1.0])

_COARSE_PX = (1000.0, 8.0, 4.0, 2.0, 1.0, 0.5)
_FINE_PX = (2.0, 1.0, 0.5, 0.3, 0.3, 0.3)
"""Scales of the robust weight, from coarse to fine."""

_NOISE_PX = 0.15  # of a match
_CHANGE_RAD = 0.3  # SD of the direction of travel, from its recent mean
_PARALLAX_QUANTILE = 0.8  # of what lies along the lines, taken for its SD
_SLOWEST = 0.05  # distance from the focus of expansion at which its lines lose meaning
_INLIER = 0.25  # least weight
_MOST_STEP_RAD = 0.3
_MOST_SKEW_RAD = 0.05
_SKEW_ROUNDS = 4


class Egomotion(NamedTuple):
    """Motion from a frame to the next.

    Attributes:
        rotation_rad: (3,) rotation vector of the camera.
        travel: (3,) unit vector; its sign is open.
        is_inlier: (M,) which matches agree.
        height: (3,) mean of y, by its share in the rotation about each axis.
        skew_rad: (3,) how much larger the rotation is per unit of y: where rows are
            exposed one after the other, that is its change meanwhile.
    """

    rotation_rad: Floats
    travel: Floats
    is_inlier: NDArray[np.bool_]
    height: Floats
    skew_rad: Floats


def egomotion(before: Floats, after: Floats, travel: Floats, px: float) -> Egomotion:
    """Fit rotation and direction of travel.

    Args:
        before: (M, 2) points of the first frame, three or more.
        after: (M, 2) the same points of the second one.
        travel: (3,) recent mean of the direction.
        px: size of a pixel at z = 1.
    """
    middle, flow = (before + after) / 2.0, after - before
    rotation = rotation_alone(middle, flow, px)
    expected = travel
    at = _linearised(middle, flow, rotation, travel)
    for scale_px in _FINE_PX:
        normal, right = _equations(at, scale_px * px, _NOISE_PX * px)
        right[3:] += at.tangent.T @ (expected - travel) / _CHANGE_RAD**2
        step = np.linalg.solve(normal, right)
        aside = np.clip(step[3:], -_MOST_STEP_RAD, _MOST_STEP_RAD)
        rotation, travel = rotation + step[:3], travel + at.tangent @ aside
        travel = travel / np.linalg.norm(travel)
        at = _linearised(middle, flow, rotation, travel)
    weight = _weight(at.error**2, _FINE_PX[-1] * px)
    height = _height(at, middle[:, 1], px)
    skew = _skew(middle, flow, (rotation, travel, expected), px)
    return Egomotion(rotation, travel, weight > _INLIER, height, skew)


class _Linearised(NamedTuple):
    """Flow that the rotation leaves across and along the lines of travel, M matches.

    Attributes:
        error: (M,) across.
        jacobian: (M, 5) its change by the rotation and by the directions of `tangent`.
        tangent: (3, 2) the directions in which the travel may change.
        along: (M,) along.
        along_jacobian: (M, 3) its change by the rotation.
        length: (M,) distance from the focus of expansion, times the share ahead.
    """

    error: Floats
    jacobian: Floats
    tangent: Floats
    along: Floats
    along_jacobian: Floats
    length: Floats


def _linearised(
    points: Floats, flow: Floats, rotation: Floats, travel: Floats
) -> _Linearised:
    of_rotation = rotation_flow(points)
    left = flow - of_rotation @ rotation
    across, moment, length = _across(points, left, travel)
    along = np.stack([across[:, 1], -across[:, 0]], axis=1)
    tangent = _tangent(travel)
    return _Linearised(
        np.einsum("mi,mi->m", across, left),
        np.column_stack(
            [-np.einsum("mi,mij->mj", across, of_rotation), moment @ tangent]
        ),
        tangent,
        np.einsum("mi,mi->m", along, left),
        -np.einsum("mi,mij->mj", along, of_rotation),
        length,
    )


def _equations(at: _Linearised, scale: float, noise: float) -> tuple[Floats, Floats]:
    """Return the normal equations (5, 5), (5,) of a step; see `_normal` for the priors."""
    agrees = _weight(at.error**2, scale)
    trust = agrees / noise**2
    parallax = np.quantile(np.abs(at.along) / at.length, _PARALLAX_QUANTILE)
    spread = parallax * at.length
    is_usual = _weight(at.along**2 / (scale**2 + (2.0 * spread) ** 2), 1.0)
    along_trust = agrees * is_usual / (noise**2 + spread**2)
    normal = _normal(at.jacobian, trust)
    normal[:3, :3] += (at.along_jacobian * along_trust[:, None]).T @ at.along_jacobian
    right = -(at.jacobian * trust[:, None]).T @ at.error
    right[:3] -= (at.along_jacobian * along_trust[:, None]).T @ at.along
    return normal, np.asarray(right)


def _normal(jacobian: Floats, trust: Floats) -> Floats:
    """Return the normal matrix of rotation, travel and perhaps more, with the priors."""
    normal = (jacobian * trust[:, None]).T @ jacobian + 1e-6 * np.eye(jacobian.shape[1])
    normal[3:5, 3:5] += np.eye(2) / _CHANGE_RAD**2
    return np.asarray(normal)


def _height(at: _Linearised, y: Floats, px: float) -> Floats:
    """Return `Egomotion.height`, at the end of the fit."""
    trust = _weight(at.error**2, _FINE_PX[-1] * px) / (_NOISE_PX * px) ** 2
    weighted = (at.jacobian * trust[:, None]).T
    by_height = weighted @ (at.jacobian[:, :3] * y[:, None])
    return np.diag(np.linalg.solve(_normal(at.jacobian, trust), by_height)[:3]).copy()


def _skew(
    points: Floats, flow: Floats, start: tuple[Floats, Floats, Floats], px: float
) -> Floats:
    """Return `Egomotion.skew_rad`: rotation, travel and skew together, from the fit on.

    `start` is the rotation, the direction of travel and the expected one.
    """
    rotation, travel, expected = start
    y = points[:, 1]
    by_height = rotation_flow(points) * y[:, None, None]
    skew: Floats = np.zeros(3)
    for _ in range(_SKEW_ROUNDS):
        at = _linearised(points, flow - by_height @ skew, rotation, travel)
        trust = _weight(at.error**2, _FINE_PX[-1] * px) / (_NOISE_PX * px) ** 2
        longer = np.column_stack([at.jacobian, at.jacobian[:, :3] * y[:, None]])
        normal = _normal(longer, trust)
        normal[5:, 5:] += np.eye(3) / _MOST_SKEW_RAD**2
        right = -(longer * trust[:, None]).T @ at.error
        right[3:5] += at.tangent.T @ (expected - travel) / _CHANGE_RAD**2
        right[5:] -= skew / _MOST_SKEW_RAD**2
        step = np.asarray(np.linalg.solve(normal, right))
        aside = np.clip(step[3:5], -_MOST_STEP_RAD, _MOST_STEP_RAD)
        rotation, skew = rotation + step[:3], skew + step[5:]
        travel = travel + at.tangent @ aside
        travel = travel / np.linalg.norm(travel)
    return skew


def rotation_alone(middle: Floats, flow: Floats, px: float) -> Floats:
    """Return the rotation vector (3,) that explains most of the flow (M, 2) by itself."""
    of_rotation = rotation_flow(middle)
    rotation: Floats = np.zeros(3)
    for scale_px in _COARSE_PX:
        left = flow - of_rotation @ rotation
        weight = _weight((left**2).sum(axis=1), scale_px * px)
        weighted = (of_rotation * weight[:, None, None]).reshape(-1, 3).T
        normal = weighted @ of_rotation.reshape(-1, 3) + 1e-9 * np.eye(3)
        rotation = np.asarray(np.linalg.solve(normal, weighted @ flow.reshape(-1)))
    return rotation


def _weight(square: Floats, scale: float) -> Floats:
    """Return Geman and McClure's robust weights."""
    return np.asarray(1.0 / (1.0 + square / scale**2) ** 2)


def rotation_flow(points: Floats) -> Floats:
    """Return (M, 2, 3): the flow of each point per unit of rotation about x, y, z."""
    x, y = points.T
    across = np.stack([x * y, -(1.0 + x * x), y], axis=1)
    down = np.stack([1.0 + y * y, -x * y, -x], axis=1)
    return np.stack([across, down], axis=1)


def _across(
    points: Floats, left: Floats, travel: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return the unit vectors across the lines of travel (M, 2).

    And the derivative (M, 3) of the flow across by the direction of travel, and how
    far each point is from the focus of expansion (M,).
    """
    x, y = points.T
    along = np.stack([x * travel[2] - travel[0], y * travel[2] - travel[1]], axis=1)
    distance = np.sqrt((along**2).sum(axis=1) + _SLOWEST**2)
    length = distance[:, None]
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) / length
    u, v = left.T
    moment = np.stack([-v, u, x * v - y * u], axis=1) / length
    return across, moment, distance


def _tangent(direction: Floats) -> Floats:
    """Return two unit vectors (3, 2) across a unit vector."""
    least = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(direction, least)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(direction, first)], axis=1)
