"""People on foot and cameras in hands: the motion of what they wear or hold."""

from dataclasses import dataclass

import numpy as np
from scipy.special import ive

from hapticplayer.extras.rides.noise import Shaker
from hapticplayer.extras.rides.script import (
    KNOT_HZ,
    MARGIN_S,
    Channel,
    Drive,
    integral,
    knot_times,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model.arrays import Floats

_HARMONICS = 10


@dataclass(frozen=True, slots=True)
class Gait:
    """Gait of a person with a camera worn on the body."""

    speed_mps: float  # at the given cadence
    steps_hz: float  # both feet
    impact_mps2: float  # height of the upward push of each step above the lowest value
    sharpness: float  # of that push; kappa of exp(kappa (cos - 1))
    along_mps2: float  # amplitude of the to and fro at each step
    across_m: float  # amplitude of the swaying at each stride
    pitch_rad: float  # nodding at each step
    swing_rad: float  # pitch swing at each stride (of an arm)
    roll_rad: float  # rocking at each stride
    yaw_rad: float  # twisting at each stride
    tilt_rad: tuple[float, float]  # (pitch, roll) at which the camera hangs


WALK = Gait(
    speed_mps=1.35,
    steps_hz=1.85,
    impact_mps2=7.0,
    sharpness=2.5,
    along_mps2=1.4,
    across_m=0.02,
    pitch_rad=float(np.radians(1.5)),
    swing_rad=0.0,
    roll_rad=float(np.radians(2.5)),
    yaw_rad=float(np.radians(4.0)),
    tilt_rad=(float(np.radians(-8.0)), float(np.radians(3.0))),
)
RUN = Gait(
    speed_mps=3.0,
    steps_hz=2.75,
    impact_mps2=36.0,
    sharpness=2.2,
    along_mps2=5.0,
    across_m=0.02,
    pitch_rad=float(np.radians(4.0)),
    swing_rad=float(np.radians(18.0)),
    roll_rad=float(np.radians(6.0)),
    yaw_rad=float(np.radians(9.0)),
    tilt_rad=(float(np.radians(-25.0)), float(np.radians(10.0))),
)


def go_on_foot(
    drive: Drive, gait: Gait, rng: np.random.Generator, duration_s: float
) -> Trajectory:
    """Return the motion of a camera worn by a person who walks or runs."""
    path = drive.path(duration_s)
    shaker = Shaker(rng, len(path.time_s), KNOT_HZ)
    share = path.speed_mps / gait.speed_mps
    # the cadence wavers by 2 %; standing, the legs do not move
    step = 2.0 * np.pi * integral(gait.steps_hz * (1.0 + shaker.wander(0.15, 0.02)))
    stride = 0.5 * step
    ahead = np.stack([-np.sin(path.yaw_rad), np.cos(path.yaw_rad)], axis=1)
    right = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    omega = 2.0 * np.pi * gait.steps_hz
    along_m = -share * gait.along_mps2 / omega**2 * np.sin(step + 0.6)
    across_m = share * gait.across_m * np.sin(stride)
    position = path.position_m.copy()
    position[:, :2] += along_m[:, None] * ahead + across_m[:, None] * right
    position[:, 2] += 1.3 + share * _push(gait, step)
    position += np.stack([shaker.wander(0.3, 0.006) for _ in range(3)], axis=1)
    pitch = gait.pitch_rad * np.sin(step + 1.0) + gait.swing_rad * np.sin(stride + 0.3)
    posture = [shaker.wander(0.2, np.radians(1.5)) for _ in range(3)]
    angles = np.stack(
        [
            path.yaw_rad + posture[0] + share * gait.yaw_rad * np.sin(stride + 0.5),
            gait.tilt_rad[0] + posture[1] + share * pitch,
            gait.tilt_rad[1] + posture[2] + share * gait.roll_rad * np.sin(stride + 1),
        ],
        axis=1,
    )
    return Trajectory(path.time_s, position, angles)


def _push(gait: Gait, phase: Floats) -> Floats:
    """Return the height whose second derivative is a push at each step.

    exp(kappa (cos x - 1)) less its mean has the Fourier coefficients
    2 exp(-kappa) I_n(kappa); each is integrated twice at the nominal cadence.
    """
    height = np.zeros_like(phase)
    for n in range(1, _HARMONICS + 1):
        omega = 2.0 * np.pi * gait.steps_hz * n
        push = 2.0 * gait.impact_mps2 * float(ive(n, gait.sharpness))
        height -= push / omega**2 * np.cos(n * phase)
    return height


def hold_still(rng: np.random.Generator, duration_s: float) -> Trajectory:
    """Return quiet hand-held footage: tremor, slow sway, and a slow pan at times.

    Tremor of hands lies at 8 to 12 Hz; a filmer who stands sways by millimetres.
    """
    time_s = knot_times(duration_s)
    shaker = Shaker(rng, len(time_s), KNOT_HZ)
    pan, tilt = Channel(), Channel(start=float(np.radians(-5.0)))
    at_s, level_rad = float(rng.uniform(4.0, 8.0)), 0.0
    while at_s < duration_s + MARGIN_S:
        length_s = float(rng.uniform(5.0, 10.0))
        pan.step(at_s, length_s, float(np.radians(rng.uniform(-35.0, 35.0))))
        to_rad = float(np.radians(rng.uniform(-6.0, 6.0)))
        tilt.step(at_s, length_s, to_rad - level_rad)
        level_rad = to_rad
        at_s += length_s + float(rng.uniform(6.0, 20.0))
    sways = [shaker.wander(0.25, 0.004) + _tremor(shaker, 0.03) for _ in range(3)]
    wobbles = [
        shaker.wander(0.3, np.radians(0.25)) + _tremor(shaker, 0.12) for _ in range(3)
    ]
    angles = np.stack(wobbles, axis=1)
    angles += np.stack([pan.at(time_s), tilt.at(time_s), np.zeros_like(time_s)], axis=1)
    return Trajectory(time_s, np.stack(sways, axis=1), angles)


def _tremor(shaker: Shaker, rms_per_s2: float) -> Floats:
    return shaker.shake(9.0, damping=0.15, below_hz=16.0, rms_mps2=rms_per_s2)


def hold_briskly(rng: np.random.Generator, duration_s: float) -> Trajectory:
    """Return a camera that is carried and turned briskly through a room."""
    time_s = knot_times(duration_s)
    shaker = Shaker(rng, len(time_s), KNOT_HZ)
    position = np.stack(
        [
            shaker.wander(0.12, 0.8) + shaker.wander(0.7, 0.06),
            shaker.wander(0.12, 0.8) + shaker.wander(0.7, 0.06),
            1.4 + shaker.wander(0.3, 0.15) + shaker.wander(0.8, 0.04),
        ],
        axis=1,
    )
    position += np.stack([_tremor(shaker, 0.3) for _ in range(3)], axis=1)
    angles = np.stack(
        [
            shaker.wander(0.1, np.radians(80.0)) + shaker.wander(0.5, np.radians(15.0)),
            shaker.wander(0.3, np.radians(17.0)) + shaker.wander(1.0, np.radians(3.0)),
            shaker.wander(0.3, np.radians(14.0)) + shaker.wander(1.0, np.radians(3.0)),
        ],
        axis=1,
    )
    return Trajectory(time_s, position, angles)
