"""The paper's four rides, two on foot, and two motions that show a pipeline's limits.

Each begins with a standstill in which the camera is patted three times, as the
paper's protocol has it (Danieau et al. 2012: a bicycle, 61 s; a horse, 60 s; a car
that turns in a roundabout, 45 s; a car that brakes, 75 s). Levels of acceleration are
ordinary ones: 0.1 g for a cyclist's start, 0.45 g around a roundabout, 0.65 g for hard
braking.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import find_peaks

from hapticplayer.extras.rides.horse import ride_horse
from hapticplayer.extras.rides.noise import Shaker
from hapticplayer.extras.rides.pats import displacement, three_pats
from hapticplayer.extras.rides.people import WALK, go_on_foot
from hapticplayer.extras.rides.scenes import Scene, Vehicle, demo, tour
from hapticplayer.extras.rides.script import (
    KNOT_HZ,
    Channel,
    Drive,
    Path,
    integral,
    knot_times,
    snapped,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.extras.rides.vehicles import BICYCLE, Car, drive_car, ride_bike
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

STILL_S = 6.0
"""The standstill at the beginning of the clip, pats included."""

FIRST_PAT_S = (1.6, 2.8)
LEAD_S = (3.0, 9.0)
"""How long the logger is switched on before the camera."""

TAIL_S = 2.0
_WHEELBASE_M = {"bicycle": 1.05, "car": 2.6}
_DRIVER_EYE_M = (-0.38, 0.25, 1.22)


@dataclass(frozen=True, slots=True, eq=False)
class _ScriptedRide:
    """What a script gives, on the ride's own time (0 when the logger starts)."""

    trajectory: Trajectory
    path: Path
    footfalls: tuple[tuple[float, float], ...] = ()
    nod_rad: Floats | None = None
    stairs_m: tuple[float, ...] = ()


Script = Callable[[np.random.Generator, float, float], _ScriptedRide]
"""Makes a ride from a generator, the time at which it starts and its whole length."""


@dataclass(frozen=True, slots=True)
class Ride:
    """A scenario: its name in SCENES, its title, and the script of the motion."""

    name: str
    title: str
    duration_s: float
    vehicle: Vehicle
    script: Script

    def __call__(self, rng: np.random.Generator) -> Scene:
        """Return the scene; its time 0 is the first frame."""
        lead_s = snapped(float(rng.uniform(*LEAD_S)))
        length_s = lead_s + self.duration_s + TAIL_S
        pats = three_pats(rng, float(rng.uniform(*FIRST_PAT_S)))
        ridden = self.script(rng, lead_s + STILL_S, length_s)
        time_s = ridden.path.time_s - lead_s
        return Scene(
            name=self.name,
            title=self.title,
            duration_s=self.duration_s,
            trajectory=ridden.trajectory.changed(
                later_s=-lead_s, displacement_m=displacement(pats, time_s)
            ),
            wheel_hits=(),
            bumps=(),
            route_m=ridden.path.position_m[:, :2],
            route_time_s=time_s,
            speed_mps=ridden.path.speed_mps,
            vehicle=self.vehicle,
            steering_rad=_steering(ridden.path, self.vehicle),
            nod_rad=ridden.nod_rad,
            footfalls=tuple((t - lead_s, v) for t, v in ridden.footfalls),
            pats=pats,
            lead_s=lead_s,
            tail_s=TAIL_S,
            stairs_m=ridden.stairs_m,
        )


def _steering(path: Path, vehicle: Vehicle) -> Floats | None:
    """Return the angle of the wheels: wheelbase times the path's curvature."""
    if vehicle not in _WHEELBASE_M:
        return None
    speed = np.maximum(path.speed_mps, 1.0)
    return np.asarray(np.arctan(_WHEELBASE_M[vehicle] * path.lateral_mps2 / speed**2))


def _bike(rng: np.random.Generator, start_s: float, length_s: float) -> _ScriptedRide:
    """A cycle path: low vertical shaking, gentle bends, one stop on the way."""
    drive = Drive(edge_s=1.3)  # a bicycle leans before it turns
    drive.stand(start_s, engine_off=True)
    drive.change_speed(5.0, 1.0)
    for side, level, bend_s in ((1, 1.2, 5.0), (-1, 1.6, 6.0), (1, 1.4, 4.0)):
        drive.cruise(rng.uniform(2.0, 3.0))
        drive.bend(side * level * rng.uniform(0.8, 1.2), bend_s)
    drive.cruise(2.0)
    drive.change_speed(2.0, 1.8)
    drive.change_speed(5.5, 0.9)
    while drive.clock_s < length_s - 14.0:
        drive.bend(rng.choice((-1.0, 1.0)) * rng.uniform(0.8, 1.6), 4.0)
        drive.cruise(rng.uniform(1.0, 2.5))
    drive.change_speed(0.0, 2.2)
    bike = replace(BICYCLE, ground_mps2=1.2, edges_s=0.0)
    return _ScriptedRide(ride_bike(drive, bike, rng, length_s), drive.path(length_s))


def _horse(rng: np.random.Generator, start_s: float, length_s: float) -> _ScriptedRide:
    """Walk, trot, canter, trot and a halt, with wide bends."""
    drive = Drive(edge_s=0.8)
    drive.stand(start_s, engine_off=True)
    for speed_mps, level, length in ((1.6, 0.9, 4.5), (3.4, 0.9, 11.0),
                                     (6.0, 1.1, 13.0), (3.3, 1.2, 5.5)):  # fmt: skip
        drive.change_speed(speed_mps, level)
        drive.cruise(0.3 * length)
        side = rng.choice((-1.0, 1.0))
        drive.bend(side * 0.10 * speed_mps * rng.uniform(0.8, 1.2), 0.5 * length)
        drive.cruise(0.2 * length)
    drive.change_speed(1.6, 1.0)
    drive.cruise(2.0)
    drive.change_speed(0.0, 0.9)
    ridden = ride_horse(drive, rng, length_s)
    return _ScriptedRide(
        ridden.trajectory, drive.path(length_s), ridden.footfalls, ridden.nod_rad
    )


def _car(drive: Drive, rng: np.random.Generator, length_s: float) -> _ScriptedRide:
    car = Car(road_mps2=0.3, camera_m=_DRIVER_EYE_M)
    return _ScriptedRide(drive_car(drive, car, rng, length_s), drive.path(length_s))


def _car_turning(
    rng: np.random.Generator, start_s: float, length_s: float
) -> _ScriptedRide:
    """Twice around a roundabout: strong lateral acceleration for a long time."""
    drive = Drive(edge_s=0.7)
    drive.stand(start_s, engine_off=False)
    drive.change_speed(8.0, 1.9)
    drive.cruise(0.6)
    lateral = rng.uniform(4.1, 4.7)
    drive.bend(-0.8 * lateral, 2.6)
    drive.bend(lateral, 19.0)
    drive.bend(-0.8 * lateral, 2.4)
    drive.cruise(1.0)
    drive.change_speed(0.0, 2.6)
    return _car(drive, rng, length_s)


def _car_braking(
    rng: np.random.Generator, start_s: float, length_s: float
) -> _ScriptedRide:
    """Three times up to town speed and down again, as hard as a driver brakes."""
    drive = Drive(edge_s=0.35)
    drive.stand(start_s, engine_off=False)
    for to_mps, level in ((4.0, 4.5), (2.5, 5.5), (0.0, 6.5)):
        drive.change_speed(14.0, 1.9)
        drive.cruise(rng.uniform(3.0, 5.0))
        drive.bend(rng.choice((-1.0, 1.0)) * 1.0, 4.0)
        drive.cruise(rng.uniform(2.0, 3.5))
        drive.change_speed(to_mps, level)
        drive.cruise(1.5)
    return _car(drive, rng, length_s)


def _standing(
    position_m: Floats,
    angles_rad: Floats,
    length_s: float,
    impacts_s: tuple[tuple[float, float], ...] = (),
) -> _ScriptedRide:
    path = Drive().path(length_s)
    return _ScriptedRide(
        Trajectory(path.time_s, position_m, angles_rad, impacts_s), path
    )


def _still(
    _rng: np.random.Generator, _start_s: float, length_s: float
) -> _ScriptedRide:
    """A tripod: nothing moves but for the pats."""
    count = len(knot_times(length_s))
    position = np.tile([0.0, 0.0, 1.4], (count, 1))
    angles = np.tile(np.radians([0.0, -4.0, 1.5]), (count, 1))
    return _standing(position, angles, length_s)


_DROPS_S = (1.0, 5.5, 10.0)
_DROP_M, _CUSHION_SHARE = 1.0, 0.12


def _free_fall(
    rng: np.random.Generator, start_s: float, length_s: float
) -> _ScriptedRide:
    """A camera in a hand that drops a metre, three times, caught softly.

    The deceleration makes up the fall's speed: level * time is the same for both.
    """
    time_s = knot_times(length_s)
    push, raised = Channel(), Channel()
    catches_s = []
    for after_s in _DROPS_S:
        edge_s, air_s = 0.03, snapped(0.42)
        catch_s = snapped(_CUSHION_SHARE * air_s)
        fall = STANDARD_GRAVITY_MPS2 * (air_s + edge_s)
        at_s = snapped(start_s + after_s)
        push.pulse(at_s, edge_s, air_s, -STANDARD_GRAVITY_MPS2)
        at_s += 2.0 * edge_s + air_s
        push.pulse(at_s, edge_s, catch_s, fall / (catch_s + edge_s))
        catches_s.append((at_s, at_s + 2.0 * edge_s + catch_s))
        # the centres of the two pulses lie so far apart
        apart_s = 0.5 * (air_s + catch_s) + 2.0 * edge_s
        raised.step(snapped(at_s + 1.2), 1.5, fall * apart_s)
    shaker = Shaker(rng, len(time_s), KNOT_HZ)
    position = np.stack([shaker.wander(0.3, 0.004) for _ in range(3)], axis=1)
    position[:, 2] += 1.7 + integral(integral(push.at(time_s))) + raised.at(time_s)
    angles = np.stack([shaker.wander(0.4, np.radians(0.7)) for _ in range(3)], axis=1)
    angles[:, 1] += np.radians(-8.0)
    return _standing(position, angles, length_s, tuple(catches_s))


_TREAD_M, _RISER_M = 0.30, 0.165
_UP = 12
STAIR_GAIT = replace(
    WALK,
    speed_mps=_TREAD_M * 1.7,
    steps_hz=1.7,
    impact_mps2=9.0,
    pitch_rad=float(np.radians(2.5)),
)


def _stairs(rng: np.random.Generator, start_s: float, length_s: float) -> _ScriptedRide:
    """Up a flight of stairs: a step a riser, the body lifted at each."""
    gait = STAIR_GAIT
    drive = Drive(edge_s=0.6)
    drive.stand(start_s, engine_off=True)
    begin_s = drive.clock_s
    drive.change_speed(gait.speed_mps, 0.6)
    drive.cruise(length_s - begin_s - 6.0)
    drive.change_speed(0.0, 0.6)
    path = drive.path(length_s)
    along_m = integral(path.speed_mps)
    first_m = float(along_m[-1]) - _UP * _TREAD_M - 1.5
    climbing = Channel()
    for number in range(_UP):
        at_m = first_m + (number - 0.8) * _TREAD_M
        at_s = snapped(float(np.interp(at_m, along_m, path.time_s)))
        climbing.step(at_s, 0.9 * _TREAD_M / gait.speed_mps, _RISER_M)
    lift = np.zeros((len(path.time_s), 3))
    lift[:, 2] = climbing.at(path.time_s)
    trajectory = go_on_foot(drive, gait, rng, length_s).changed(displacement_m=lift)
    risers = tuple(first_m + number * _TREAD_M for number in range(_UP))
    return _ScriptedRide(trajectory, path, _steps(trajectory), stairs_m=risers)


def _stroll(rng: np.random.Generator, start_s: float, length_s: float) -> _ScriptedRide:
    """A walk on a path with bends, the camera on the chest."""
    drive = Drive(edge_s=0.6)
    drive.stand(start_s, engine_off=True)
    drive.change_speed(WALK.speed_mps, 0.7)
    while drive.clock_s < length_s - 9.0:
        drive.cruise(float(rng.uniform(1.5, 3.0)))
        drive.bend(rng.choice((-1.0, 1.0)) * float(rng.uniform(0.15, 0.35)), 3.0)
    drive.change_speed(0.0, 0.7)
    trajectory = go_on_foot(drive, WALK, rng, length_s)
    return _ScriptedRide(trajectory, drive.path(length_s), _steps(trajectory))


def _steps(trajectory: Trajectory) -> tuple[tuple[float, float], ...]:
    """Return when feet land: the peaks of the upward acceleration."""
    time_s = trajectory.time_s
    upward = trajectory.at(time_s).acceleration_mps2[:, 2]
    peaks, found = find_peaks(upward, height=2.0, distance=round(0.35 * KNOT_HZ))
    strength = np.clip(found["peak_heights"] / 10.0, 0.0, 1.0)
    return tuple(zip(time_s[peaks].tolist(), strength.tolist(), strict=True))


_RIDES = (
    Ride("bike", "Bicycle: low vertical shaking", 61.0, "bicycle", _bike),
    Ride("horse", "Horse: recurrent high vertical motion", 60.0, "horse", _horse),
    Ride("car-turning", "Car: around a roundabout", 45.0, "car", _car_turning),
    Ride("car-braking", "Car: hard braking", 75.0, "car", _car_braking),
    Ride("still", "Camera on a tripod", 20.0, "tripod", _still),
    Ride("free-fall", "Camera dropped three times", 22.0, "tripod", _free_fall),
    Ride("stairs", "Up a flight of stairs", 25.0, "foot", _stairs),
    Ride("stroll", "Walking, camera on the chest", 40.0, "foot", _stroll),
)

RIDES: dict[str, Ride] = {ride.name: ride for ride in _RIDES}
"""Rides that are recorded by a camera and by a board with a clock of its own."""

SCENES: dict[str, Callable[[np.random.Generator], Scene]] = {
    "demo": demo,
    "tour": tour,
    **RIDES,
}
"""Scenes by name; `simulate` gives each a seeded generator."""
