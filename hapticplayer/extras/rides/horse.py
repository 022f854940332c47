"""A horse under its rider: walk, trot and canter, and the footfalls to be heard.

Each gait is a sum of harmonics of the stride. Stride frequencies (ordinary ones, from
memory: 0.8 to 1.1, 1.3 to 1.8 and 1.6 to 2.0 Hz) and the number of vertical waves in a
stride (two in walk and trot, one in canter) are those of the literature on equine gait;
the amplitudes are chosen so that a sitting rider's trunk feels up to 3, 13 and 9 m/s2
upwards, and never much more than free fall downwards.
"""

from dataclasses import dataclass

import numpy as np

from hapticplayer.extras.rides.noise import Shaker
from hapticplayer.extras.rides.script import KNOT_HZ, Drive, integral
from hapticplayer.extras.rides.trajectory import Trajectory, smooth_step
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

Footfall = tuple[float, float]
"""Time in s and strength, 0 to 1."""


@dataclass(frozen=True, slots=True)
class HorseGait:
    """How a horse moves its rider."""

    stride_hz: float  # strides a second
    heave_m: tuple[float, ...]  # amplitude of each harmonic of the stride, vertically
    surge_m: tuple[float, ...]  # likewise along
    pitch_rad: float  # amplitude of nodding, once or twice a stride as the heave
    sway_m: float  # amplitude across, once a stride
    # phases of the stride (0 to 1) at which hooves land, with strength
    beats: tuple[Footfall, ...]


WALK = HorseGait(0.95, (0.0, 0.018, 0.0, -0.001), (0.0, 0.012), 0.03, 0.02,
            ((0.0, 0.4), (0.25, 0.5), (0.5, 0.4), (0.75, 0.5)))  # fmt: skip
TROT = HorseGait(1.4, (0.002, 0.034, 0.0, -0.0022), (0.0, 0.006), 0.02, 0.012,
            ((0.0, 0.9), (0.03, 0.6), (0.5, 0.9), (0.53, 0.6)))  # fmt: skip
CANTER = HorseGait(1.7, (0.05, -0.008, 0.002), (0.03, 0.006), 0.075, 0.01,
              ((0.0, 0.8), (0.22, 1.0), (0.44, 0.9)))  # fmt: skip
GAITS = (WALK, TROT, CANTER)

CHANGES_MPS = ((0.15, 1.0), (2.2, 0.9), (4.3, 1.0))
"""Where each gait begins, as speed and width of the change to it."""

EYE_M = 2.35
"""Height of a rider's chest camera."""


@dataclass(frozen=True, slots=True, eq=False)
class HorseRide:
    """What comes of a ride: camera on the rider's chest, hoof beats (s, strength).

    `nod_rad` is that of the horse's head, at the knots.
    """

    trajectory: Trajectory
    footfalls: tuple[Footfall, ...]
    nod_rad: Floats


def ride_horse(drive: Drive, rng: np.random.Generator, duration_s: float) -> HorseRide:
    """Return the motion of a camera on the chest of a rider."""
    path = drive.path(duration_s)
    shaker = Shaker(rng, len(path.time_s), KNOT_HZ)
    shares = _shares(path.speed_mps)
    wavering = 1.0 + shaker.wander(0.2, 0.015)
    stride_hz = sum(s * g.stride_hz for s, g in zip(shares, GAITS, strict=True))
    phase = 2.0 * np.pi * integral(np.asarray(stride_hz) * wavering)
    heave, surge, pitch, sway, nod = (np.zeros_like(phase) for _ in range(5))
    for share, gait in zip(shares, GAITS, strict=True):
        heave += share * _waves(gait.heave_m, phase)
        surge += share * _waves(gait.surge_m, phase + 0.7)
        order = 1.0 if gait.heave_m[0] > gait.heave_m[1] else 2.0
        pitch += share * gait.pitch_rad * np.sin(order * phase + 0.9)
        nod += share * (0.03 + gait.pitch_rad) * np.sin(order * phase + 2.2)
        sway += share * gait.sway_m * np.sin(phase + 0.4)
    position = path.position_m.copy()
    ahead = np.stack([-np.sin(path.yaw_rad), np.cos(path.yaw_rad)], axis=1)
    right = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    position[:, :2] += surge[:, None] * ahead + sway[:, None] * right
    position[:, 2] += EYE_M + heave
    position += np.stack([shaker.wander(0.3, 0.006) for _ in range(3)], axis=1)
    going = shares[0] + shares[1] + shares[2]
    jolts = [shaker.shake(9.0, damping=0.3, below_hz=22.0, rms_mps2=0.5) for _ in "xyz"]
    position += going[:, None] * np.stack(jolts, axis=1)
    posture = [shaker.wander(0.25, np.radians(1.2)) for _ in range(3)]
    angles = np.stack(
        [
            path.yaw_rad + posture[0],
            np.radians(-7.0) + posture[1] + pitch,
            posture[2]
            + 1.2 * sway
            - 0.35 * np.arctan(path.lateral_mps2 / STANDARD_GRAVITY_MPS2),
        ],
        axis=1,
    )
    trajectory = Trajectory(path.time_s, position, angles)
    return HorseRide(trajectory, _footfalls(path.time_s, phase, shares), nod)


def _shares(speed_mps: Floats) -> tuple[Floats, Floats, Floats]:
    """Return how much of each gait there is; all of them 0 at a standstill."""
    walk, trot, canter = (smooth_step(speed_mps, *change) for change in CHANGES_MPS)
    return walk - trot, trot - canter, canter


def _waves(amplitudes_m: tuple[float, ...], phase: Floats) -> Floats:
    wave = np.zeros_like(phase)
    for order, amplitude in enumerate(amplitudes_m, start=1):
        wave += amplitude * np.cos(order * phase)
    return wave


def _footfalls(
    time_s: Floats, phase: Floats, shares: tuple[Floats, ...]
) -> tuple[Footfall, ...]:
    """Return when the phase passes each beat of the gait that prevails."""
    falls = []
    strides = np.arange(int(phase[-1] / (2.0 * np.pi)) + 1)
    for share, gait in zip(shares, GAITS, strict=True):
        for beat, strength in gait.beats:
            at_s = np.interp(
                2.0 * np.pi * (strides + beat), phase, time_s, right=np.nan
            )
            at_s = at_s[np.isfinite(at_s)]
            loud = strength * np.interp(at_s, time_s, share)
            falls += [
                (float(t), float(v)) for t, v in zip(at_s, loud, strict=True) if v > 0.1
            ]
    return tuple(sorted(falls))
