"""A script of manoeuvres, and the path on the ground that follows from it.

Every channel is a sum of smooth steps, so that its length costs linear time and
that what is meant to be constant (a standstill, a steady bend) is exactly so.
"""

from dataclasses import dataclass, field

import numpy as np

from hapticplayer.extras.rides.trajectory import smooth_step
from hapticplayer.model.arrays import Floats

KNOT_HZ = 200
"""Knots of the trajectories: motion up to 80 Hz is resolved."""

MARGIN_S = 0.5
"""What a path has before and after the time that is asked for."""

_GRID_S = 1.0 / KNOT_HZ


def knot_times(duration_s: float) -> Floats:
    first, last = -round(MARGIN_S * KNOT_HZ), round((duration_s + MARGIN_S) * KNOT_HZ)
    return np.arange(first, last + 1) / KNOT_HZ


def snapped(length_s: float) -> float:
    """Return the length in whole knots, so that sums of a step's ends cancel."""
    return round(length_s * KNOT_HZ) / KNOT_HZ


@dataclass(slots=True)
class Channel:
    """A value over time: smooth steps (start_s, length_s, delta) from a start value."""

    start: float = 0.0
    steps: list[tuple[float, float, float]] = field(default_factory=list)

    def step(self, start_s: float, length_s: float, delta: float) -> None:
        """Add a smooth step by `delta`; steps may overlap."""
        self.steps.append((start_s, length_s, delta))

    def pulse(self, start_s: float, edge_s: float, hold_s: float, level: float) -> None:
        """Add a smooth trapezoid; its area is level (edge + hold)."""
        self.step(start_s, edge_s, level)
        self.step(start_s + edge_s + hold_s, edge_s, -level)

    def at(self, time_s: Floats) -> Floats:
        """Return the value at evenly spaced times (N,)."""
        moving = np.zeros(len(time_s))
        done = np.zeros(len(time_s) + 1)
        for start_s, length_s, delta in self.steps:
            low, high = np.searchsorted(time_s, [start_s, start_s + length_s])
            moving[low:high] += delta * smooth_step(time_s[low:high], start_s, length_s)
            done[high] += delta
        return self.start + moving + np.cumsum(done[:-1])


@dataclass(frozen=True, slots=True, eq=False)
class Path:
    """A way over the ground at N knots."""

    time_s: Floats
    position_m: Floats  # (N, 3) earth
    speed_mps: Floats
    thrust_mps2: Floats  # (N,) derivative of the speed along the path
    yaw_rad: Floats  # (N,) heading, counterclockwise from north
    lateral_mps2: Floats  # (N,) acceleration to the left
    grade_rad: Floats  # (N,) uphill
    engine: Floats  # (N,) 0 off to 1 running


class Drive:
    """Writes manoeuvres one after the other; `path` is where they lead."""

    def __init__(self, speed_mps: float = 0.0, edge_s: float = 0.5) -> None:
        """Start the script; a manoeuvre takes `edge_s` to reach its level."""
        self.clock_s = 0.0
        self.speed_mps = speed_mps
        self._first_speed_mps = speed_mps
        self._edge_s = snapped(edge_s)
        self._thrust = Channel()
        self._yaw_rate = Channel()
        self._grade = Channel()
        self._grade_now = 0.0
        self._engine = Channel(start=1.0)

    def cruise(self, length_s: float) -> None:
        """Go on at the same speed."""
        self.clock_s += snapped(length_s)

    def change_speed(self, to_mps: float, level_mps2: float) -> None:
        """Accelerate or brake at a level until the speed is reached."""
        change = to_mps - self.speed_mps
        hold_s = snapped(max(0.0, abs(change) / level_mps2 - self._edge_s))
        level = change / (hold_s + self._edge_s)
        self._thrust.pulse(self.clock_s, self._edge_s, hold_s, level)
        self.clock_s += hold_s + 2.0 * self._edge_s
        self.speed_mps = to_mps

    def stand(self, length_s: float, *, engine_off: bool) -> None:
        """Stand still, at speed 0; the engine idles or stops and starts again."""
        length_s = snapped(max(length_s, 1.0))
        if engine_off:
            self._engine.pulse(self.clock_s, 0.25, length_s - 0.5, -1.0)
        self.clock_s += length_s

    def bend(self, lateral_mps2: float, length_s: float) -> None:
        """Go through a bend: lateral acceleration, positive to the left."""
        rate = lateral_mps2 / self.speed_mps
        hold_s = snapped(max(0.0, length_s - 2.0 * self._edge_s))
        self._yaw_rate.pulse(self.clock_s, self._edge_s, hold_s, rate)
        self.clock_s += hold_s + 2.0 * self._edge_s

    def turn(self, angle_rad: float, rate_radps: float) -> None:
        """Turn by an angle at about a rate, as a walker does."""
        length_s = abs(angle_rad) / rate_radps + self._edge_s
        hold_s = snapped(max(0.0, length_s - 2.0 * self._edge_s))
        self._yaw_rate.pulse(
            self.clock_s, self._edge_s, hold_s, angle_rad / (hold_s + self._edge_s)
        )
        self.clock_s += hold_s + 2.0 * self._edge_s

    def slope(self, grade_rad: float, over_s: float) -> None:
        """Begin a slope here; the script's clock does not move."""
        self._grade.step(self.clock_s, snapped(over_s), grade_rad - self._grade_now)
        self._grade_now = grade_rad

    def path(self, duration_s: float) -> Path:
        """Return the way, MARGIN_S longer than the duration at both ends."""
        time_s = knot_times(duration_s)
        thrust = self._thrust.at(time_s)
        yaw_rate, grade = self._yaw_rate.at(time_s), self._grade.at(time_s)
        speed = self._first_speed_mps + integral(thrust)
        yaw = integral(yaw_rate)
        flat = speed * np.cos(grade)
        velocity = [-flat * np.sin(yaw), flat * np.cos(yaw), speed * np.sin(grade)]
        return Path(
            time_s=time_s,
            position_m=integral(np.stack(velocity, axis=1)),
            speed_mps=speed,
            thrust_mps2=thrust,
            yaw_rad=yaw,
            lateral_mps2=speed * yaw_rate,
            grade_rad=grade,
            engine=self._engine.at(time_s),
        )


def integral(rate: Floats, step_s: float = _GRID_S) -> Floats:
    """Return the integral over the knots from the first on (trapezoids), axis 0."""
    steps = 0.5 * step_s * (rate[1:] + rate[:-1])
    return np.concatenate([np.zeros_like(rate[:1]), np.cumsum(steps, axis=0)])
