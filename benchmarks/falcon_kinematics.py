"""What one tick of the Falcon's driver costs and how exact it is, beside two others.

    python benchmarks/falcon_kinematics.py [--ticks 20000]

The grip runs along a circle of 30 mm at 2 Hz; each tick gets encoder counts and gives
a position and a frame with motor words. In turns, in the same run:

* ours: parse the reply, full Newton from the last position, J^T F, saturation, frame;
* numpy: the same mathematics with numpy.linalg for three legs at once;
* half steps: the method of libnifalcon (half Newton steps until the angles before the
  step are within 0.01 rad, at most 15, from the last position), in our scalars.

Error: position against the truth that the angles were computed from, once with exact
angles (the method's own error), once with angles in whole counts.
"""

import argparse
import math
import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from common import save, table

from hapticplayer.devices.falcon.geometry import FALCON_GEOMETRY
from hapticplayer.devices.falcon.kinematics import Kinematics, motor_words
from hapticplayer.devices.falcon.protocol import (
    Reply,
    ReplyParser,
    encode_command,
    encode_reply,
)

RADIUS_M, RATE_HZ = 0.03, 2.0
FORCE_N = (1.0, 2.0, -3.0)
LEGS = Kinematics()
Solve = Callable[[Any, Any], Any]


def truth(ticks: int) -> list[tuple[float, float, float]]:
    """Return the grip's places, one each millisecond."""
    turn = 2.0 * math.pi * RATE_HZ / 1000.0
    return [
        (
            RADIUS_M * math.cos(turn * k),
            RADIUS_M * math.sin(turn * k),
            0.12 + 0.01 * math.sin(3 * turn * k),
        )
        for k in range(ticks)
    ]


class WithNumpy:
    """The same Newton steps with arrays and numpy.linalg."""

    def __init__(self) -> None:
        g = FALCON_GEOMETRY
        phi = np.array(g.azimuths_rad)
        self.cos, self.sin = np.cos(phi), np.sin(phi)
        self.radial = g.base_radius_m - g.grip_radius_m
        self.across = g.base_offset_m - g.grip_offset_m

    def closure(self, p: Any, theta: Any) -> tuple[Any, Any, Any]:
        """Return W, the closures, and D."""
        g = FALCON_GEOMETRY
        u = p[0] * self.cos + p[1] * self.sin - self.radial
        v = -p[0] * self.sin + p[1] * self.cos - self.across
        h = np.sqrt(g.shin_m**2 - v**2)
        reach = g.shin_ends_m + h
        a = u - g.thigh_m * np.cos(theta)
        b = p[2] - g.thigh_m * np.sin(theta)
        lean = reach * v / h
        w = np.stack(
            [a * self.cos - lean * self.sin, a * self.sin + lean * self.cos, b], axis=1
        )
        d = g.thigh_m * (b * np.cos(theta) - a * np.sin(theta))
        return w, a * a + b * b - reach * reach, d

    def position(self, theta: Any, near: Any) -> Any:
        """Return the grip's place."""
        p = np.array(near)
        for _ in range(25):
            w, closure, _ = self.closure(p, theta)
            step = np.linalg.solve(2.0 * w, closure)
            p -= step
            if np.abs(step).max() < 1e-9:
                break
        return p

    def words(self, p: Any, theta: Any, force: Any) -> Any:
        """Return saturated motor words."""
        w, _, d = self.closure(p, theta)
        jacobian = np.linalg.inv(w) * d
        if np.linalg.cond(jacobian) > 9.0:
            return np.zeros(3)
        words = -10_000.0 * jacobian.T @ force
        return words * min(1.0, 4096 / np.abs(words).max())


def half_steps(theta: Any, near: Any) -> Any:
    """Return the place as libnifalcon's method finds it."""
    p = near
    for _ in range(15):
        error = [a - b for a, b in zip(theta, LEGS.inverse(p), strict=True)]
        step = [
            0.5 * sum(row[i] * error[i] for i in range(3)) for row in LEGS.jacobian(p)
        ]
        p = (p[0] + step[0], p[1] + step[1], p[2] + step[2])
        if max(map(abs, error)) < 0.01:
            break
    return p


def ours_tick(frames: list[bytes]) -> list[float]:
    """Time whole ticks of ours, us."""
    parser, near, took = ReplyParser(), (0.03, 0.0, 0.12), []
    for frame in frames:
        begin = time.perf_counter_ns()
        reply = parser.feed(frame)[0]
        pose = LEGS.pose(LEGS.angles(reply.counts), near)
        i, j, k = motor_words(pose.jacobian, FORCE_N)
        encode_command((round(i), round(j), round(k)), 5)
        took.append((time.perf_counter_ns() - begin) / 1000)
        near = pose.position_m
    return took


def numpy_tick(frames: list[bytes]) -> list[float]:
    """Time whole ticks with numpy, us."""
    other, parser, took = WithNumpy(), ReplyParser(), []
    near, force = np.array([0.03, 0.0, 0.12]), np.array(FORCE_N)
    for frame in frames:
        begin = time.perf_counter_ns()
        theta = np.array(LEGS.angles(parser.feed(frame)[0].counts))
        near = other.position(theta, near)
        words = np.round(other.words(near, theta, force)).astype(int).tolist()
        encode_command(tuple(words), 5)
        took.append((time.perf_counter_ns() - begin) / 1000)
    return took


def half_step_tick(frames: list[bytes]) -> list[float]:
    """Time whole ticks with half steps, us."""
    parser, near, took = ReplyParser(), (0.03, 0.0, 0.12), []
    for frame in frames:
        begin = time.perf_counter_ns()
        near = half_steps(LEGS.angles(parser.feed(frame)[0].counts), near)
        i, j, k = motor_words(LEGS.jacobian(near), FORCE_N)
        encode_command((round(i), round(j), round(k)), 5)
        took.append((time.perf_counter_ns() - begin) / 1000)
    return took


def errors_mm(solve: Solve, places: list[Any], *, in_counts: bool) -> dict[str, float]:
    """Return how far a method's positions are from the truth."""
    near, distances = places[0], []
    for place in places:
        theta = LEGS.inverse(place)
        if in_counts:
            theta = LEGS.angles(LEGS.counts(theta))
        near = solve(theta, near)
        distances.append(1000.0 * math.dist(near, place))
    rms = math.sqrt(statistics.fmean(d * d for d in distances))
    return {"rms": rms, "max": max(distances)}


def main() -> int:
    """Run all three in turns, print and save."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ticks", type=int, default=20_000)
    options = parser.parse_args()
    places = truth(options.ticks)
    frames = [
        encode_reply(Reply(LEGS.counts(LEGS.inverse(place)), 0, 7)) for place in places
    ]
    some = places[:2000]
    methods: dict[str, tuple[Callable[[list[bytes]], list[float]], Solve]] = {
        "ours": (ours_tick, LEGS.forward),
        "numpy": (numpy_tick, WithNumpy().position),
        "half steps": (half_step_tick, half_steps),
    }
    took: dict[str, list[float]] = {name: [] for name in methods}
    part = max(1, len(frames) // 20)
    for start in range(0, len(frames), part):  # in turns: the same machine noise
        for name, (tick, _) in methods.items():
            took[name] += tick(frames[start : start + part])
    result: dict[str, Any] = {}
    for name, (_, solve) in methods.items():
        p50, p99 = np.percentile(took[name], [50, 99])
        result[name] = {
            "tick_us": {"p50": float(p50), "p99": float(p99)},
            "exact_angles_mm": errors_mm(solve, some, in_counts=False),
            "counts_mm": errors_mm(solve, some, in_counts=True),
        }
    for name in methods:
        result[name]["time_of_ours"] = (
            result[name]["tick_us"]["p50"] / result["ours"]["tick_us"]["p50"]
        )
    report(result)
    return 0


def report(result: dict[str, Any]) -> None:
    """Print a table and write the JSON."""
    heads = [
        "",
        "tick p50 us",
        "p99 us",
        "ratio",
        "error rms mm",
        "max mm",
        "in counts",
    ]
    rows = [
        [
            name,
            f"{r['tick_us']['p50']:.1f}",
            f"{r['tick_us']['p99']:.1f}",
            f"{r['time_of_ours']:.1f}",
            f"{r['exact_angles_mm']['rms']:.2g}",
            f"{r['exact_angles_mm']['max']:.2g}",
            f"{r['counts_mm']['rms']:.3f}",
        ]
        for name, r in result.items()
    ]
    print(table(heads, rows))
    print(f"saved {save('falcon_kinematics', result).name}")


if __name__ == "__main__":
    raise SystemExit(main())
