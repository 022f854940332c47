"""A Stewart platform: what its six legs do for a pose, and how far it gets.

Frame A on the platform and in the room: x right, y front, z up. A leg of a pose is
|T + R p - b| with R = Rz(yaw) Rx(pitch) Ry(roll), see `extras.rigs.packets`; the pose is
neutral where T is the home height. A pose out of reach is clamped, and reported.
"""

import math
from typing import NamedTuple

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.model.rig import RigMotion

BASE_RADIUS_M, PLATFORM_RADIUS_M, HOME_M = 0.65, 0.45, 0.80
SHORTEST_M, LONGEST_M = 0.72, 1.05
SHIFT_M_PER_MPS2 = 0.02
"""What an acceleration becomes: a shift, as the first moment of one feels."""
YAW_S = 1.5
"""A seat cannot turn on; its heading comes back with this time constant."""
_BASE_DEG = (-10.0, 10.0, 110.0, 130.0, 230.0, 250.0)
_PLATFORM_DEG = (-50.0, 50.0, 70.0, 170.0, 190.0, 290.0)
_HALVINGS = 20


class PlatformPose(NamedTuple):
    """Of the platform against neutral: right, front, up, m; roll, pitch, yaw, rad."""

    right_m: float = 0.0
    front_m: float = 0.0
    up_m: float = 0.0
    roll_rad: float = 0.0
    pitch_rad: float = 0.0
    yaw_rad: float = 0.0

    def scaled(self, share: float) -> "PlatformPose":
        return PlatformPose(*(share * value for value in self))


def base_m() -> Floats:
    """Return the six joints on the floor, (6, 3)."""
    return _ring(_BASE_DEG, BASE_RADIUS_M)


def platform_m(pose: PlatformPose) -> Floats:
    """Return the six joints of the platform in the room, (6, 3)."""
    r, p, y = pose.roll_rad, pose.pitch_rad, pose.yaw_rad
    about_y = np.array(
        [[math.cos(r), 0, math.sin(r)], [0, 1, 0], [-math.sin(r), 0, math.cos(r)]]
    )
    about_x = np.array(
        [[1, 0, 0], [0, math.cos(p), -math.sin(p)], [0, math.sin(p), math.cos(p)]]
    )
    about_z = np.array(
        [[math.cos(y), -math.sin(y), 0], [math.sin(y), math.cos(y), 0], [0, 0, 1]]
    )
    turned = _ring(_PLATFORM_DEG, PLATFORM_RADIUS_M) @ (about_z @ about_x @ about_y).T
    centre = np.array((pose.right_m, pose.front_m, HOME_M + pose.up_m))
    return np.asarray(turned + centre)


def legs_m(pose: PlatformPose) -> Floats:
    """Return the lengths of the six legs."""
    return np.asarray(np.linalg.norm(platform_m(pose) - base_m(), axis=1))


def is_reachable(pose: PlatformPose) -> bool:
    """Whether every leg is as long as it can be."""
    lengths = legs_m(pose)
    return bool(np.all((lengths >= SHORTEST_M) & (lengths <= LONGEST_M)))


def reached(pose: PlatformPose) -> tuple[PlatformPose, float]:
    """Return the pose that the legs can follow, and its share of the one asked for.

    It lies between neutral and what was asked for, as far out as the legs go.
    """
    if not all(map(math.isfinite, pose)):
        return PlatformPose(), 0.0
    if is_reachable(pose):
        return pose, 1.0
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (
            (middle, high) if is_reachable(pose.scaled(middle)) else (low, middle)
        )
    return pose.scaled(low), low


class Follower:
    """From motion to the pose that it asks for; headings that turn on come back."""

    def __init__(self) -> None:
        self._heading_rad: float | None = None
        self._yaw_rad = self._last_s = 0.0

    def pose(self, motion: RigMotion, now_s: float) -> PlatformPose:
        """The pose of a motion that came at a time."""
        before = self._heading_rad
        if before is not None:
            turned = math.remainder(motion.heading_rad - before, math.tau)
            kept = math.exp(-max(0.0, now_s - self._last_s) / YAW_S)
            self._yaw_rad = kept * self._yaw_rad + turned
        self._heading_rad, self._last_s = motion.heading_rad, now_s
        right, front, up = (SHIFT_M_PER_MPS2 * a for a in motion[:3])
        return PlatformPose(
            right, front, up, motion.roll_rad, motion.pitch_rad, self._yaw_rad
        )


def _ring(degrees: tuple[float, ...], radius_m: float) -> Floats:
    angles = np.radians(degrees)
    flat = np.stack([np.sin(angles), np.cos(angles), np.zeros_like(angles)], axis=1)
    return np.asarray(radius_m * flat)
