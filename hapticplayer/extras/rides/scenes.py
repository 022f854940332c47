"""What a scene of the recording simulator is, and the built-in demo's."""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from scipy.signal import lfilter

from hapticplayer.extras.rides.pats import Tap
from hapticplayer.extras.rides.script import integral
from hapticplayer.extras.rides.trajectory import Trajectory, smooth_step
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

Vehicle = Literal["bicycle", "horse", "car", "foot", "tripod"]
"""What the camera is on: decides what is seen in front of it, and what is heard."""

_DESIGN_HZ = 2000
_SPLINE_HZ = 200
_MARGIN_S = 0.5


@dataclass(frozen=True, slots=True)
class Bump:
    """An edge that both wheels roll over, the front one at `time_s`; up is positive."""

    time_s: float
    height_m: float


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """A ride of the camera, which is the sensor.

    Attributes:
        wheel_hits: (K, 2) time and strength (0 to 1) of each thump to be heard.
        route_m: (N, 2) middle of the lane in earth x, y, one point every 5 mm or
            less while riding.
        route_time_s: (N,) when the camera is there.
        speed_mps: (N,) along the route.
        steering_rad: (N,) angle of the wheels, to the left; None for straight on.
        nod_rad: (N,) of a horse's head; None for none.
        footfalls: time and strength (0 to 1) of hooves or feet.
        pats: the taps for synchronisation.
        lead_s: how long a logger ran before the first frame; the trajectory
            reaches so far back, and 0.5 s beyond.
        tail_s: how long it ran after the last one.
        stairs_m: distances along the route at which a stair's risers stand.
        cobbles_s: when the front wheel comes to cobbles, and leaves them.
        stones: time and strength (0 to 1) of the cobbles to be heard.
    """

    name: str
    title: str
    duration_s: float
    trajectory: Trajectory
    wheel_hits: tuple[tuple[float, float], ...]
    bumps: tuple[Bump, ...]
    route_m: Floats
    route_time_s: Floats
    speed_mps: Floats
    vehicle: Vehicle = "bicycle"
    steering_rad: Floats | None = None
    nod_rad: Floats | None = None
    footfalls: tuple[tuple[float, float], ...] = ()
    pats: tuple[Tap, ...] = field(default=())
    lead_s: float = 0.0
    tail_s: float = 0.0
    stairs_m: tuple[float, ...] = ()
    cobbles_s: tuple[float, float] | None = None
    stones: tuple[tuple[float, float], ...] = ()


def demo(rng: np.random.Generator) -> Scene:
    """A bicycle on a country road: away from rest, a bend, a kerb, a hard stop."""
    time_s = _times(10.0)
    speed = 5.0 * (smooth_step(time_s, 1.5, 3.2) - smooth_step(time_s, 7.75, 1.75))
    yaw = np.radians(75.0) * smooth_step(time_s, 3.7, 2.9)
    bumps = (Bump(6.70, 0.045), Bump(7.30, -0.045))
    title = "Bicycle: away, a bend, a kerb, a hard stop"
    return _bicycle("demo", title, _Ride(time_s, speed, yaw, bumps), rng)


def tour(rng: np.random.Generator) -> Scene:
    """The demo that ships: bends, kerbs, cobbles and a hard stop in half a minute."""
    time_s = _times(30.0)
    speed = _steps(
        time_s, (1.0, 3.0, 5.0), (15.2, 2.0, -1.2), (17.6, 2.6, 2.7), (26.3, 1.9, -6.5)
    )
    yaw = np.radians(
        _steps(time_s, (4.2, 2.6, 70.0), (17.8, 2.8, -80.0), (20.9, 2.6, 60.0))
    )
    bumps = (Bump(7.80, 0.045), Bump(8.50, -0.045), Bump(24.6, 0.05), Bump(25.3, -0.05))
    title = "Bicycle: bends, kerbs, cobbles, a hard stop"
    ride = _Ride(time_s, speed, yaw, bumps, cobbles_s=(9.8, 15.0))
    return _bicycle("tour", title, ride, rng)


def _times(duration_s: float) -> Floats:
    return np.arange(-_MARGIN_S, duration_s + _MARGIN_S, 1.0 / _DESIGN_HZ)


def _steps(time_s: Floats, *steps: tuple[float, float, float]) -> Floats:
    """The sum of smooth steps, each with start, length and height."""
    total = np.zeros(len(time_s))
    for start_s, length_s, height in steps:
        total += height * smooth_step(time_s, start_s, length_s)
    return total


def _bicycle(name: str, title: str, ride: "_Ride", rng: np.random.Generator) -> Scene:
    time_s, speed, yaw = ride.time_s, ride.speed, ride.yaw
    ahead = np.stack([-np.sin(yaw), np.cos(yaw)], axis=1)
    route_m = integral(speed[:, None] * ahead, 1.0 / _DESIGN_HZ)
    position_m, angles_rad = ride.camera(route_m, rng)
    step = _DESIGN_HZ // _SPLINE_HZ
    return Scene(
        name=name,
        title=title,
        duration_s=round(time_s[-1] - _MARGIN_S),
        trajectory=Trajectory(time_s[::step], position_m[::step], angles_rad[::step]),
        wheel_hits=ride.wheel_hits(),
        bumps=ride.bumps,
        route_m=route_m,
        route_time_s=time_s,
        speed_mps=speed,
        cobbles_s=ride.cobbles_s,
        stones=ride.stones(rng),
    )


_CAMERA_HEIGHT_M = 1.35
_WHEELBASE_M = 1.05
_FRONT_SHARE = 0.65  # the camera sits nearer to the front wheel
_LOOK_DOWN_RAD = np.radians(-4.0)
_LEAN_SHARE = 0.6  # rider and camera lean less than the bicycle
_CADENCE_HZ = 1.15
_ROUGHNESS_WAVES = 28
_COBBLES_ROUGHNESS = 3.2  # of asphalt's
_STONE_WAVES, _STONES_M = 12, (0.18, 0.45)
_STONE_AMPLITUDE_M = 6e-5  # of waves of 0.3 m, after the tyre
_STONE_EVERY_M = 0.22
_NOD_RAD_PER_MPS2 = 0.003
_EDGE_S = 0.3  # in which both wheels come onto the cobbles


class _Ride:
    """Turns speed and heading into the motion of a camera on a bicycle."""

    def __init__(
        self,
        time_s: Floats,
        speed: Floats,
        yaw: Floats,
        bumps: tuple[Bump, ...],
        cobbles_s: tuple[float, float] | None = None,
    ) -> None:
        self.time_s, self.speed, self.yaw, self.bumps = time_s, speed, yaw, bumps
        self._travel_m = integral(speed, 1.0 / _DESIGN_HZ)
        self.cobbles_s = cobbles_s
        first_s, last_s = cobbles_s or (np.inf, np.inf)
        steps = (first_s, _EDGE_S, 1.0), (last_s, _EDGE_S, -1.0)
        self._on_cobbles = _steps(time_s, *steps) if cobbles_s else np.zeros(1)

    def camera(
        self, route_m: Floats, rng: np.random.Generator
    ) -> tuple[Floats, Floats]:
        """Return position (N, 3) in m and yaw, pitch, roll (N, 3) in rad."""
        front_m, rear_m = self._wheels(rng)
        lift_m = _FRONT_SHARE * front_m + (1.0 - _FRONT_SHARE) * rear_m
        slope = (front_m - rear_m) / _WHEELBASE_M
        pitch = _LOOK_DOWN_RAD + 0.5 * slope + self._nod() + self._shaken(front_m)
        roll = self._lean() + self._sway()
        right = np.stack([np.cos(self.yaw), np.sin(self.yaw)], axis=1)
        aside_m = _CAMERA_HEIGHT_M * np.sin(roll)
        height_m = _CAMERA_HEIGHT_M * np.cos(roll) + lift_m
        position = np.column_stack([route_m + aside_m[:, None] * right, height_m])
        return position, np.stack([self.yaw, pitch, roll], axis=1)

    def wheel_hits(self) -> tuple[tuple[float, float], ...]:
        """Return when the wheels meet the bumps and how loud it is."""
        hits = []
        for bump in self.bumps:
            hits += [(bump.time_s, 1.0), (self._rear_time_s(bump), 0.6)]
        return tuple(sorted(hits))

    def stones(self, rng: np.random.Generator) -> tuple[tuple[float, float], ...]:
        """Return when a wheel meets which cobbles, and how loud it is."""
        if self.cobbles_s is None:
            return ()
        first_m, last_m = np.interp(self.cobbles_s, self.time_s, self._travel_m)
        stones_m = np.arange(first_m, last_m, _STONE_EVERY_M)
        stones_m += rng.uniform(-0.3, 0.3, len(stones_m)) * _STONE_EVERY_M
        times_s = np.interp(stones_m, self._travel_m, self.time_s)
        strengths = rng.uniform(0.3, 1.0, len(stones_m))
        return tuple(zip(times_s.tolist(), strengths.tolist(), strict=True))

    def _shaken(self, front_m: Floats) -> Floats:
        """Return how the handlebar nods on cobbles: a fork of 5 Hz, rad."""
        if self.cobbles_s is None:
            return np.zeros(1)
        upward = np.gradient(np.gradient(front_m, self.time_s), self.time_s)
        drive = _NOD_RAD_PER_MPS2 * self._on_cobbles * upward
        return _oscillator(drive, frequency_hz=5.0, damping=0.3)

    def _rear_time_s(self, bump: Bump) -> float:
        """Return when the rear wheel has come to the edge."""
        at_m = np.interp(bump.time_s, self.time_s, self._travel_m) + _WHEELBASE_M
        return float(np.interp(at_m, self._travel_m, self.time_s))

    def _wheels(self, rng: np.random.Generator) -> tuple[Floats, Floats]:
        """Return the heights of both wheels: asphalt, cobbles and the edges."""
        length_m = np.geomspace(0.5, 7.0, _ROUGHNESS_WAVES)
        phase = rng.uniform(0.0, 2.0 * np.pi, _ROUGHNESS_WAVES)
        # displacement spectrum of a road falls with the square of the wave number
        # (ISO 8608); the amplitude gives about 1 m/s2 RMS at 5 m/s
        amplitude_m = 3.2e-4 * length_m * rng.uniform(0.6, 1.4, _ROUGHNESS_WAVES)
        roughness = 1.0 + (_COBBLES_ROUGHNESS - 1.0) * self._on_cobbles
        stone_m = np.geomspace(*_STONES_M, _STONE_WAVES)
        wheels = []
        for behind_m in (0.0, _WHEELBASE_M):
            at_m = self._travel_m[:, None] - behind_m
            waves = np.sin(2.0 * np.pi * at_m / length_m + phase)
            wheels.append(roughness * (waves @ amplitude_m))
            if self.cobbles_s is not None:
                stones = np.sin(2.0 * np.pi * at_m / stone_m + phase[:_STONE_WAVES])
                stones_m = stones @ (_STONE_AMPLITUDE_M * (stone_m / 0.3) ** 2)
                wheels[-1] = wheels[-1] + self._on_cobbles * stones_m
        for bump in self.bumps:
            wheels[0] = wheels[0] + self._edge(bump.time_s, bump.height_m)
            wheels[1] = wheels[1] + self._edge(self._rear_time_s(bump), bump.height_m)
        return wheels[0], wheels[1]

    def _edge(self, hit_s: float, height_m: float) -> Floats:
        """Return the rise over an edge and the tyre's ringing after it."""
        rise = smooth_step(self.time_s, hit_s, 0.11)
        since_s = np.clip(self.time_s - hit_s, 0.0, None)
        fade = smooth_step(self.time_s, hit_s, 0.15) * np.exp(-since_s / 0.16)
        return height_m * (rise + 0.22 * fade * np.sin(2.0 * np.pi * 6.5 * since_s))

    def _nod(self) -> Floats:
        """Return the pitch by which braking and starting tip the rider, rad.

        A damped oscillator of 1.6 Hz that the acceleration drives.
        """
        thrust = np.gradient(self.speed, self.time_s)
        return _oscillator(0.010 * thrust, frequency_hz=1.6, damping=0.3)

    def _lean(self) -> Floats:
        """Return the roll into the bend: right side down is positive."""
        yaw_rate = np.gradient(self.yaw, self.time_s)
        leaning = np.arctan2(self.speed * yaw_rate, STANDARD_GRAVITY_MPS2)
        return -_LEAN_SHARE * leaning

    def _sway(self) -> Floats:
        """Return the rocking of hard pedalling while the bicycle gains speed."""
        effort = smooth_step(self.time_s, 1.6, 0.8) - smooth_step(self.time_s, 3.4, 1.2)
        turn = 2.0 * np.pi * _CADENCE_HZ * (self.time_s - 1.5)
        return np.asarray(np.radians(2.2) * effort * np.sin(turn))


def _oscillator(drive: Floats, *, frequency_hz: float, damping: float) -> Floats:
    """Return the response of a damped oscillator with gain 1 at rest."""
    dt = 1.0 / _DESIGN_HZ
    omega = 2.0 * np.pi * frequency_hz
    # backward differences: stable, and exact enough at a thousandth of the period
    denominator = np.array(
        [1.0 + 2.0 * damping * omega * dt + (omega * dt) ** 2,
         -2.0 - 2.0 * damping * omega * dt,
         1.0]
    )  # fmt: skip
    return np.asarray(lfilter([(omega * dt) ** 2], denominator, drive))
