"""Cars and bicycles: from a path on the ground to the motion of a camera on board."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.extras.rides.noise import Shaker, settled
from hapticplayer.extras.rides.script import KNOT_HZ, Channel, Drive, Path, integral
from hapticplayer.extras.rides.trajectory import Trajectory, quaternion_from_angles
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import rotate


@dataclass(frozen=True, slots=True)
class Car:
    """A car's body, and the road's and the engine's shaking of it.

    Attributes:
        road_mps2: RMS of the vertical vibration at speed.
        engine_mps2: amplitude of the engine's vibration.
        squat_rad_per_mps2: nose up per forward acceleration (1.5 deg/g).
        roll_rad_per_mps2: leaning out of bends per lateral acceleration (3.5 deg/g).
        camera_m: (right, front, up) of the camera from the centre of that motion.
    """

    road_mps2: float = 0.25
    engine_mps2: float = 0.06
    squat_rad_per_mps2: float = 0.0027
    roll_rad_per_mps2: float = 0.0062
    camera_m: tuple[float, float, float] = (0.1, 0.5, 0.6)


def drive_car(
    drive: Drive, car: Car, rng: np.random.Generator, duration_s: float
) -> Trajectory:
    """Return the motion of a camera at a car's windscreen.

    The body follows braking and cornering as a sprung mass (1.5 and 1.3 Hz, damping
    0.35), bounces at 1.4 Hz, and its wheels hop at 11 Hz; the shaking fades out
    towards a standstill, where the engine idles (25 Hz) unless it is off.
    """
    path = drive.path(duration_s)
    shaker = Shaker(rng, len(path.time_s), KNOT_HZ)
    going = path.speed_mps / (path.speed_mps + 4.0)
    pitch = path.grade_rad + _body(car.squat_rad_per_mps2 * path.thrust_mps2, 1.5)
    roll = _body(car.roll_rad_per_mps2 * path.lateral_mps2, 1.3)
    pitch = pitch + going * shaker.wander(1.6, np.radians(0.15))
    roll = roll + going * (
        shaker.wander(1.3, np.radians(0.15)) + shaker.wander(0.1, np.radians(0.8))
    )
    look_down, tilt = np.radians(rng.uniform(-5.0, 2.0)), np.radians(rng.normal(0, 1.0))
    angles = np.stack([path.yaw_rad, look_down + pitch, tilt + roll], axis=1)
    shake = _road_shake(shaker, car.road_mps2) * going[:, None]
    shake[:, 2] += _engine(path, car.engine_mps2)
    aboard = np.broadcast_to(np.array(car.camera_m), angles.shape)
    moved = rotate(quaternion_from_angles(angles), aboard + shake)
    return Trajectory(path.time_s, path.position_m + moved, angles)


def _body(drive: Floats, frequency_hz: float) -> Floats:
    return settled(drive, frequency_hz=frequency_hz, damping=0.35, rate_hz=KNOT_HZ)


def _road_shake(shaker: Shaker, rms_mps2: float) -> Floats:
    """Return displacements (N, 3): mostly up and down, less across and along."""
    columns = []
    for share in (0.4, 0.3, 1.0):
        bounce = shaker.shake(
            1.4, damping=0.3, below_hz=6.0, rms_mps2=0.7 * share * rms_mps2
        )
        hop = shaker.shake(
            11.0, damping=0.2, below_hz=35.0, rms_mps2=0.7 * share * rms_mps2
        )
        columns.append(bounce + hop)
    return np.stack(columns, axis=1)


def _engine(path: Path, amplitude_mps2: float) -> Floats:
    """Return the vertical shaking by the second order of the engine."""
    frequency_hz = 25.0 + 35.0 * path.speed_mps / (path.speed_mps + 12.0)
    phase = 2.0 * np.pi * integral(frequency_hz)
    amplitude_m = amplitude_mps2 / (2.0 * np.pi * frequency_hz) ** 2
    return np.asarray(path.engine * amplitude_m * np.sin(phase))


_KERB_S = 0.11  # in which the camera is lifted


@dataclass(frozen=True, slots=True)
class Bike:
    """A bicycle, its rider and its ground."""

    ground_mps2: float  # RMS of the vertical shaking at speed
    ground_hz: float  # where the shaking has its resonance
    below_hz: float  # where it ends
    # (right, front, up) of the camera from the ground
    camera_m: tuple[float, float, float]
    lean_share: float  # of the lean that balances a bend, which the camera takes
    grade_share: float  # of the slope that the camera follows (a head stays level)
    look_rad: float = 0.0  # RMS of looking around
    cadence_hz: float = 1.15  # of pedalling
    sway_rad: float = 0.0  # of the rocking by it
    edges_s: float = 0.0  # mean time between kerbs; 0 for none
    drops_s: float = 0.0  # mean time between drops; 0 for none


BICYCLE = Bike(
    ground_mps2=1.0,
    ground_hz=4.0,
    below_hz=25.0,
    camera_m=(0.0, 0.3, 1.35),
    lean_share=0.6,
    grade_share=1.0,
    sway_rad=float(np.radians(1.5)),
    edges_s=12.0,
)
MOUNTAIN_BIKE = Bike(
    ground_mps2=4.0,
    ground_hz=3.0,
    below_hz=18.0,
    camera_m=(0.0, 0.1, 1.6),
    lean_share=0.4,
    grade_share=0.5,
    look_rad=float(np.radians(12.0)),
    drops_s=9.0,
)


def ride_bike(
    drive: Drive, bike: Bike, rng: np.random.Generator, duration_s: float
) -> Trajectory:
    """Return the motion of a camera on a bicycle or on its rider's head."""
    path = drive.path(duration_s)
    shaker = Shaker(rng, len(path.time_s), KNOT_HZ)
    going = path.speed_mps / (path.speed_mps + 2.0)
    balance = np.arctan2(path.lateral_mps2, STANDARD_GRAVITY_MPS2)
    pedalling = 2.0 * np.pi * bike.cadence_hz * path.time_s
    nod = shaker.wander(2.0, np.radians(0.25 * bike.ground_mps2))
    roll = bike.sway_rad * np.sin(pedalling) + 0.6 * bike.look_rad * shaker.wander(
        0.4, 1.0
    )
    pitch = going * nod + 0.5 * bike.look_rad * shaker.wander(0.5, 1.0)
    thrust_nod = _body(0.008 * path.thrust_mps2, 1.6)
    look = bike.look_rad * shaker.wander(0.35, 1.0)
    angles = np.stack(
        [
            path.yaw_rad + look,
            np.radians(-6.0) + bike.grade_share * path.grade_rad + thrust_nod + pitch,
            going * roll - bike.lean_share * balance,
        ],
        axis=1,
    )
    position = path.position_m + _held(bike, balance, path.yaw_rad)
    position[:, :2] += going[:, None] * _ground(shaker, bike, 0.35, 2)
    position[:, 2] += going * _ground(shaker, bike, 1.0, 1)[:, 0]
    edges_m, kerbs_s = _edges(path, bike, rng)
    drops_m, landings_s = _drops(path, bike, rng)
    position[:, 2] += edges_m + drops_m
    return Trajectory(path.time_s, position, angles, (*kerbs_s, *landings_s))


def _held(bike: Bike, balance_rad: Floats, yaw_rad: Floats) -> Floats:
    """Return the camera from the ground: the bicycle leans, the camera above it."""
    zero = np.zeros_like(yaw_rad)
    leaning = quaternion_from_angles(np.stack([yaw_rad, zero, -balance_rad], axis=1))
    return rotate(leaning, np.broadcast_to(np.array(bike.camera_m), (len(yaw_rad), 3)))


def _ground(shaker: Shaker, bike: Bike, share: float, columns: int) -> Floats:
    shakes = [
        shaker.shake(
            bike.ground_hz,
            damping=0.35,
            below_hz=bike.below_hz,
            rms_mps2=share * bike.ground_mps2,
        )
        for _ in range(columns)
    ]
    return np.stack(shakes, axis=1)


def _edges(
    path: Path, bike: Bike, rng: np.random.Generator
) -> tuple[Floats, list[tuple[float, float]]]:
    """Return the height of kerbs, up and down in turn, met at speed; and their spans."""
    height, kerbs_s = Channel(), []
    rise_m = 0.035
    for hit_s in _events(path, bike.edges_s, rng):
        height.step(hit_s, _KERB_S, rise_m)
        kerbs_s.append((hit_s, hit_s + _KERB_S))
        rise_m = -rise_m
    return height.at(path.time_s), kerbs_s


def _drops(
    path: Path, bike: Bike, rng: np.random.Generator
) -> tuple[Floats, list[tuple[float, float]]]:
    """Return the height lost in drops: almost free fall, then twice as hard a landing.

    And the spans of the landings.
    """
    fall, landings_s = Channel(), []
    for hit_s in _events(path, bike.drops_s, rng):
        air_s, edge_s = float(rng.uniform(0.2, 0.45)), 0.08
        landing_s = 0.5 * (air_s + edge_s) - edge_s
        fall.pulse(hit_s, edge_s, air_s, -0.95 * STANDARD_GRAVITY_MPS2)
        after_s = hit_s + 2.0 * edge_s + air_s
        fall.pulse(after_s, edge_s, landing_s, 1.9 * STANDARD_GRAVITY_MPS2)
        landings_s.append((after_s, after_s + 2.0 * edge_s + landing_s))
    return integral(integral(fall.at(path.time_s))), landings_s


def _events(path: Path, every_s: float, rng: np.random.Generator) -> list[float]:
    """Return random times at which the path is not slow; none for every_s = 0."""
    events: list[float] = []
    if every_s == 0.0:
        return events
    at_s = float(rng.uniform(0.5, 1.5) * every_s)
    while at_s < path.time_s[-1] - 1.5:
        if np.interp(at_s, path.time_s, path.speed_mps) > 3.5:
            events.append(at_s)
        at_s += float(rng.uniform(0.5, 1.5) * every_s)
    return events
