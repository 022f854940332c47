"""Rides without frame and sound: motion and inertial log only, truth known.

They are what gravity removal is judged on: cars that brake and corner for seconds,
people who walk and run, cameras in hands that are almost still.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.errors import Message, UsageError, entry_named
from hapticplayer.extras.rides import drives
from hapticplayer.extras.rides.people import (
    RUN,
    WALK,
    go_on_foot,
    hold_briskly,
    hold_still,
)
from hapticplayer.extras.rides.script import Drive
from hapticplayer.extras.rides.sensors import (
    SENSORS,
    LogWithTruth,
    SensorModel,
    measure,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.extras.rides.vehicles import (
    BICYCLE,
    MOUNTAIN_BIKE,
    Car,
    drive_car,
    ride_bike,
)
from hapticplayer.model.arrays import Floats

Build = Callable[[np.random.Generator, float], Trajectory]

LONGEST_S = 12 * 3600.0
"""Beyond this the path is so long that float64 costs more than 1e-3 m/s^2."""


@dataclass(frozen=True, slots=True)
class MotionScene:
    """A kind of ride; `build` makes its trajectory from a generator and a duration."""

    name: str
    title: str
    duration_s: float
    build: Build


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedMotion(LogWithTruth):
    """A scene's log with its truth, at other times that of the trajectory."""

    title: str
    trajectory: Trajectory

    def truth_arrays(self) -> dict[str, Floats]:
        """Return the truth as arrays by name, for a `.npz`."""
        return {
            **self.truth.arrays(),
            "acceleration_mps2": self.acceleration_mps2,
            "vertical": self.vertical,
        }


def simulate_motion(
    name: str,
    seed: int,
    *,
    duration_s: float | None = None,
    sensor: str | SensorModel = "camera",
) -> SimulatedMotion:
    """Ride a scene with an inertial sensor only; equal arguments give equal bits.

    Time and memory grow linearly with the duration (None for the scene's own).
    """
    scene = entry_named(MOTION_SCENES, name, Message("motion scene"))
    length_s = scene.duration_s if duration_s is None else duration_s
    if not 1.0 <= length_s <= LONGEST_S:
        raise UsageError(
            "a duration of {length_s:g} s; give one from 1 to {longest_s:g} s",
            length_s=length_s,
            longest_s=LONGEST_S,
        )
    trajectory = scene.build(np.random.default_rng([seed, 0]), length_s)
    measured = measure(trajectory, length_s, _sensor(sensor), seed)
    return SimulatedMotion(
        replace(measured.imu, source=f"simulated: {scene.title}"),
        measured.truth,
        measured.vertical,
        measured.acceleration_mps2,
        scene.title,
        trajectory,
    )


def _sensor(sensor: str | SensorModel) -> SensorModel:
    if isinstance(sensor, SensorModel):
        return sensor
    return entry_named(SENSORS, sensor, Message("sensor"))


def _car(
    script: Callable[[np.random.Generator, float], Drive], road_mps2: float
) -> Build:
    def build(rng: np.random.Generator, duration_s: float) -> Trajectory:
        drive = script(rng, duration_s)
        return drive_car(drive, Car(road_mps2=road_mps2), rng, duration_s)

    return build


def _town(style: drives.Style, road_mps2: float) -> Build:
    return _car(lambda rng, s: drives.town(rng, s, style), road_mps2)


_SCENES = (
    MotionScene(
        "car-calm", "Car in town, 0.10 to 0.15 g", 180.0, _town(drives.CALM, 0.2)
    ),
    MotionScene(
        "car-brisk", "Car in town, 0.25 to 0.35 g", 150.0, _town(drives.BRISK, 0.3)
    ),
    MotionScene(
        "car-hard", "Car in town, 0.5 to 0.7 g", 120.0, _town(drives.HARD, 0.4)
    ),
    MotionScene(
        "car-roundabouts", "Car, many roundabouts", 120.0, _car(drives.roundabouts, 0.3)
    ),
    MotionScene(
        "car-motorway", "Car on a motorway", 180.0, _car(drives.motorway, 0.35)
    ),
    MotionScene(
        "car-stop-and-go", "Car in a queue", 120.0, _car(drives.stop_and_go, 0.2)
    ),
    MotionScene(
        "car-on-ramp", "Car on motorway ramps", 120.0, _car(drives.on_ramp, 0.3)
    ),
    MotionScene("car-hills", "Car in hills", 120.0, _car(drives.hills, 0.3)),
    MotionScene(
        "walk",
        "Walking, camera on the chest",
        90.0,
        lambda rng, s: go_on_foot(drives.stroll(rng, s, WALK.speed_mps), WALK, rng, s),
    ),
    MotionScene(
        "run",
        "Running, camera on the arm",
        90.0,
        lambda rng, s: go_on_foot(drives.stroll(rng, s, RUN.speed_mps), RUN, rng, s),
    ),
    MotionScene("handheld-quiet", "Quiet hand-held footage", 120.0, hold_still),
    MotionScene("handheld-brisk", "Brisk hand-held camera", 90.0, hold_briskly),
    MotionScene(
        "bicycle",
        "Bicycle, longer than the demo",
        120.0,
        lambda rng, s: ride_bike(drives.bicycle(rng, s), BICYCLE, rng, s),
    ),
    MotionScene(
        "mountain-bike",
        "Downhill mountain bike, camera on the head",
        90.0,
        lambda rng, s: ride_bike(drives.downhill(rng, s), MOUNTAIN_BIKE, rng, s),
    ),
)

MOTION_SCENES: dict[str, MotionScene] = {scene.name: scene for scene in _SCENES}
"""Scenes of motion only, by name."""
