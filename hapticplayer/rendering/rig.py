"""The motion of a rig from the motion of a recording.

A sequence stores the acceleration p[k] and the orientation q[k], not the angular rate;
that is the derivative of the orientation, w = 2 log(q[k]* q[k+1]) / dt, which holds no
bias of the gyro. A rig stands on the floor, so what it gets of the orientation is the
pitch and roll away from their medians over the recording (a camera is mounted at some
tilt). Heading and velocity are not known over a long time, and a rig has no room for
them: both are integrals that forget, with the time constants below.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from hapticplayer.model import MotionTrack, RigTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import conjugate, multiply
from hapticplayer.model.rig import RigMotion
from hapticplayer.rendering.window_means import dense_motion

HEADING_TIME_S = 2.0
VELOCITY_TIME_S = 2.0
DEMONSTRATION_S, DEMONSTRATION_REST_S = 3.0, 1.0
_DEMONSTRATED = {
    "surge": ("front_mps2", 0.75),
    "sway": ("right_mps2", 0.75),
    "heave": ("up_mps2", 0.75),
    "roll": ("roll_rad", 0.045),
    "pitch": ("pitch_rad", 0.045),
    "yaw": ("heading_rad", 0.045),
}
"""First number of a `RigMotion` that an axis moves, and its size."""


def rig_track(motion: MotionTrack) -> RigTrack:
    """Return the motion of a rig, in media time; columns as in `RigMotion`.

    Samples that are not valid give no acceleration, as in `render_force`.

    Args:
        motion: gravity-free acceleration and orientation of frame A, in media time.
    """
    time_s, acceleration, valid = dense_motion(motion)
    acceleration = np.where(valid[:, None], acceleration, 0.0)
    pitch_roll = _pitch_and_roll(motion.quaternion_wxyz)
    rate = _angular_rate(motion.time_s, motion.quaternion_wxyz)
    pitch_roll, rate = (
        np.stack([np.interp(time_s, motion.time_s, column) for column in part.T], 1)
        for part in (pitch_roll, rate)
    )
    return RigTrack(
        time_s,
        np.hstack(
            [
                acceleration,
                pitch_roll,
                _forgetful_integral(time_s, rate[:, 2:], HEADING_TIME_S),
                rate,
                _derivative(time_s, rate),
                _forgetful_integral(time_s, acceleration, VELOCITY_TIME_S),
            ]
        ).astype(np.float32),
    )


class RigStep(NamedTuple):
    """One motion of the demonstration: begin and end in media time, and its axis."""

    begin_s: float
    end_s: float
    axis: str


def rig_demonstration() -> tuple[RigTrack, tuple[RigStep, ...]]:
    """Return a gentle motion there and back for each axis in turn, and what moves when.

    Along an axis the acceleration is sin(2 pi u) sin^2(pi u) of at most about 0.5 m/s^2,
    about one the angle is, of at most about 0.03 rad; rates are its derivatives.
    """
    columns = {name: column for column, name in enumerate(RigMotion._fields)}
    steps, begin_s = [], DEMONSTRATION_REST_S
    for axis in _DEMONSTRATED:
        steps.append(RigStep(begin_s, begin_s + DEMONSTRATION_S, axis))
        begin_s += DEMONSTRATION_S + DEMONSTRATION_REST_S
    time_s = np.arange(0.0, begin_s, 0.01)
    motion = np.zeros((len(time_s), len(columns)))
    for step, (first, size) in zip(steps, _DEMONSTRATED.values(), strict=True):
        share = np.clip((time_s - step.begin_s) / DEMONSTRATION_S, 0.0, 1.0)
        shape = size * np.sin(2 * np.pi * share) * np.sin(np.pi * share) ** 2
        column = columns[first]
        motion[:, column] = shape
        if first.endswith("_rad"):
            motion[:, column + 3] = _derivative(time_s, shape)
            motion[:, column + 6] = _derivative(time_s, motion[:, column + 3])
    return RigTrack(time_s, motion.astype(np.float32)), tuple(steps)


def _pitch_and_roll(q: Floats) -> Floats:
    """Return pitch and roll less their medians, (N, 2), rad.

    R(q) = Rz Rx(pitch) Ry(roll): its last row is (-cos p sin r, sin p, cos p cos r).
    """
    w, x, y, z = q.T
    up_x, up_y = 2.0 * (x * z - w * y), 2.0 * (y * z + w * x)
    up_z = 1.0 - 2.0 * (x * x + y * y)
    pitch = np.arcsin(np.clip(up_y, -1.0, 1.0))
    roll = np.unwrap(np.arctan2(-up_x, up_z))
    both = np.stack([pitch, roll], axis=1)
    return np.asarray(both - np.median(both, axis=0))


def _angular_rate(time_s: Floats, q: Floats) -> Floats:
    """Return the angular rate about x, y, z of frame A, (N, 3), rad/s."""
    if len(time_s) < 2:
        return np.zeros((len(time_s), 3))
    turn = multiply(conjugate(q[:-1]), q[1:])
    turn *= np.where(turn[:, :1] < 0.0, -1.0, 1.0)
    sine = np.linalg.norm(turn[:, 1:], axis=1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, turn[:, :1])
    axis = turn[:, 1:] / np.maximum(sine, 1e-12)
    between = axis * angle / np.diff(time_s)[:, None]
    middle_s = 0.5 * (time_s[1:] + time_s[:-1])
    return np.stack([np.interp(time_s, middle_s, column) for column in between.T], 1)


def _derivative(time_s: Floats, values: Floats) -> Floats:
    if len(time_s) < 2:
        return np.zeros_like(values)
    return np.asarray(np.gradient(values, time_s, axis=0))


def _forgetful_integral(time_s: Floats, values: Floats, forget_s: float) -> Floats:
    """Return y with y' = values - y / forget_s, from 0; values as lines between.

    Each step forgets a share and adds the mean of its ends, so that
    y[k] exp(t[k] / forget_s) is a running sum; restarted every ten time constants,
    before it becomes too large a number.
    """
    out = np.zeros_like(values)
    kept = np.exp(-np.diff(time_s) / forget_s)[:, None]
    added = 0.5 * (values[1:] + values[:-1]) * forget_s * (1.0 - kept)
    starts_s = np.arange(time_s[0], time_s[-1], 10.0 * forget_s)
    edges = np.unique([*np.searchsorted(time_s, starts_s), len(time_s)])
    for first, end in pairwise(edges):
        if first:
            out[first] = kept[first - 1] * out[first - 1] + added[first - 1]
        growth = np.exp((time_s[first + 1 : end] - time_s[first]) / forget_s)[:, None]
        sums = np.cumsum(added[first : end - 1] * growth, axis=0)
        out[first + 1 : end] = (out[first] + sums) / growth
    return out
