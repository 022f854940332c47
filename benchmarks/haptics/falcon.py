"""The Falcon's driver: whether a tick waits for it, and what one costs."""

import argparse
import functools
import gc
import math
import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.common import Report, interleaved, medians, ratio, rms
from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device
from hapticplayer.devices.falcon.driver import Options
from hapticplayer.devices.falcon.kinematics import (
    FALCON_GEOMETRY,
    Kinematics,
    motor_words,
)
from hapticplayer.devices.falcon.protocol import (
    Reply,
    ReplyParser,
    encode_command,
    encode_reply,
)
from hapticplayer.extras.faults.usb import driver
from hapticplayer.linux import DEVICE_PRIORITY, CpuLatencyRequest, acquire, grant

PERIOD_S = 0.001
SETTLING_TICKS = 200
MOST_AGE_US = 3000.0
KINDS: dict[str, Options | None] = {
    "no device": None,
    "latency timer": Options(),
    "event character": Options(event_character=True),
}


def exchange_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, default=5.0)


def exchange(options: argparse.Namespace, report: Report) -> None:
    """Whether a tick waits for the Falcon: lateness, time in `exchange`, age of answers.

    A bare loop of 1 kHz, with the scheduling of the haptics process, runs alternating without
    a device, with the driver on a simulated Falcon at the chip's 1 ms latency timer, and
    with the event character. pyusb is the real one; chip, board and physics are a process
    of their own. A real Falcon takes no time of this machine, so the loop and its threads
    have the first core and the simulated device the last one, in every kind of run.
    """
    rounds = options.rounds or (1 if options.quick else 6)
    scheduling = acquire(None).value
    CpuLatencyRequest().set_active(is_active=True)  # as the loop does while it plays
    ticks = int((1.0 if options.quick else options.seconds) / PERIOD_S)
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:1])
    kinds = {n: functools.partial(_exchange, kind, ticks) for n, kind in KINDS.items()}
    found = interleaved(kinds, rounds)
    figures = {name: medians(each) for name, each in found.items()}
    for name, each in found.items():
        for key in ("late p50", "late p99"):
            beside = [one[key] for one in found["no device"]]
            figures[name][f"{key}, of no device"] = ratio(
                [one[key] for one in each], beside
            ).median
        if "age p99" in figures[name]:
            age, limit = figures[name]["age p99"], ("<=", MOST_AGE_US)
            report.target(f"{name}: age of answers, p99 us", age, limit)
    keys = list(figures["latency timer"])
    rows = [[key, *(figures[name].get(key, "-") for name in KINDS)] for key in keys]
    report.table(f"Scheduling {scheduling}; us", ["", *KINDS], rows)
    report.figures |= {"scheduling": scheduling, "rounds": rounds, **figures}


def _exchange(options: Options | None, ticks: int) -> dict[str, float]:
    """Return percentiles of one run, us."""
    clock, device, server = SystemClock(), None, None
    if options is not None:
        server, descriptor = _start_falcon()
        device = driver.make(descriptor, options)
        device.open()
    gc.collect()
    gc.disable()
    late, took, age = [], [], []
    deadline_s = clock.now_s() + PERIOD_S
    for _ in range(ticks):
        clock.sleep_until(deadline_s)
        now_s = clock.now_s()
        late.append(now_s - deadline_s)
        if device is not None:
            reading = device.exchange((0.5, 0.0, -0.5), now_s)
            took.append(clock.now_s() - now_s)
            age.append(now_s - reading.replied_s)
        missed = int((clock.now_s() - deadline_s) / PERIOD_S)
        deadline_s += (missed + 1) * PERIOD_S
    gc.enable()
    if device is not None and server is not None:
        device.close()
        server.kill()
        server.wait()
    return {
        f"{name} p{q}": 1e6 * float(np.percentile(values[SETTLING_TICKS:], q))
        for name, values in (("late", late), ("exchange", took), ("age", age))
        for q in ((50, 99) if values else ())
    }


def _start_falcon() -> tuple[subprocess.Popen[bytes], int]:
    """Return the process of a simulated Falcon, and our end of its line."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    command = [sys.executable, "-P", "-m", find_device("falcon-simulated").server]
    command += ["--line", str(theirs.fileno()), "--running"]
    server = subprocess.Popen(command, pass_fds=[theirs.fileno()])
    theirs.close()
    os.sched_setaffinity(server.pid, {(os.cpu_count() or 1) - 1})
    grant(server.pid, priority=DEVICE_PRIORITY)
    return server, ours.detach()


# --- what a tick costs ------------------------------------------------------------

RADIUS_M, RATE_HZ, PARTS = 0.03, 2.0, 20
FORCE_N = (1.0, 2.0, -3.0)
START_M = (0.03, 0.0, 0.12)
LEGS = Kinematics()
Words = tuple[Any, Any, Any]
Tick = Callable[[Any, Any], tuple[Any, Words]]
"""(angles, position before) -> (position, motor words)"""


def truth(ticks: int) -> list[tuple[float, float, float]]:
    """Return the grip's places, one each millisecond."""
    step = 2.0 * math.pi * RATE_HZ / 1000.0
    return [
        (
            RADIUS_M * math.cos(step * k),
            RADIUS_M * math.sin(step * k),
            0.12 + 0.01 * math.sin(3 * step * k),
        )
        for k in range(ticks)
    ]


def ours(theta: Any, near: Any) -> tuple[Any, Words]:
    """The driver's result."""
    pose = LEGS.pose(theta, near)
    return pose.position_m, motor_words(pose.jacobian, FORCE_N)


def half_steps(theta: Any, near: Any) -> tuple[Any, Words]:
    """Return the place as libnifalcon's method finds it."""
    p = near
    for _ in range(15):
        error = [a - b for a, b in zip(theta, LEGS.inverse(p), strict=True)]
        rows = LEGS.jacobian(p)
        step = [0.5 * sum(row[i] * error[i] for i in range(3)) for row in rows]
        p = (p[0] + step[0], p[1] + step[1], p[2] + step[2])
        if max(map(abs, error)) < 0.01:
            break
    return p, motor_words(LEGS.jacobian(p), FORCE_N)


class WithNumpy:
    """The same Newton steps with arrays and numpy.linalg."""

    def __init__(self) -> None:
        g = FALCON_GEOMETRY
        phi = np.array(g.azimuths_rad)
        self.cos, self.sin = np.cos(phi), np.sin(phi)
        self.radial = g.base_radius_m - g.grip_radius_m
        self.across = g.base_offset_m - g.grip_offset_m

    def __call__(self, angles: Any, near: Any) -> tuple[Any, Words]:
        """Return position and saturated motor words."""
        theta, p = np.array(angles), np.array(near)
        for _ in range(25):
            w, closure, _ = self._closure(p, theta)
            step = np.linalg.solve(2.0 * w, closure)
            p -= step
            if np.abs(step).max() < 1e-9:
                break
        w, _, d = self._closure(p, theta)
        jacobian = np.linalg.inv(w) * d
        if np.linalg.cond(jacobian) > 9.0:
            return p, (0, 0, 0)
        words = -10_000.0 * jacobian.T @ np.array(FORCE_N)
        i, j, k = (words * min(1.0, 4096 / np.abs(words).max())).tolist()
        return p, (i, j, k)

    def _closure(self, p: Any, theta: Any) -> tuple[Any, Any, Any]:
        """Return W, the closures, and D."""
        g = FALCON_GEOMETRY
        u = p[0] * self.cos + p[1] * self.sin - self.radial
        v = -p[0] * self.sin + p[1] * self.cos - self.across
        h = np.sqrt(g.shin_m**2 - v**2)
        reach = g.shin_ends_m + h
        a = u - g.thigh_m * np.cos(theta)
        b = p[2] - g.thigh_m * np.sin(theta)
        lean = reach * v / h
        columns = [a * self.cos - lean * self.sin, a * self.sin + lean * self.cos, b]
        d = g.thigh_m * (b * np.cos(theta) - a * np.sin(theta))
        return np.stack(columns, axis=1), a * a + b * b - reach * reach, d


METHODS: dict[str, Tick] = {
    "ours": ours,
    "numpy": WithNumpy(),
    "half steps": half_steps,
}


def timed(tick: Tick, frames: list[bytes]) -> list[float]:
    """Time whole ticks, us."""
    parser, near, took = ReplyParser(), START_M, []
    for frame in frames:
        begin_ns = time.perf_counter_ns()
        near, (i, j, k) = tick(LEGS.angles(parser.feed(frame)[0].counts), near)
        encode_command((round(i), round(j), round(k)), 5)
        took.append((time.perf_counter_ns() - begin_ns) / 1000)
    return took


def errors_mm(tick: Tick, places: list[Any], *, in_counts: bool) -> list[float]:
    """Return how far a method's positions are from the truth."""
    near, distances = places[0], []
    for place in places:
        theta = LEGS.inverse(place)
        if in_counts:
            theta = LEGS.angles(LEGS.counts(theta))
        near, _ = tick(theta, near)
        distances.append(1000.0 * math.dist(near, place))
    return distances


def kinematics_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--ticks", type=int, help="(20000)")


def kinematics(options: argparse.Namespace, report: Report) -> None:
    """What one tick of the Falcon's driver costs and how exact it is, beside two others.

    The grip runs along a circle of 30 mm at 2 Hz; each tick gets encoder counts and gives
    a position and a frame with motor words. Beside ours (parse the reply, full Newton from
    the last position, J^T F, saturation, frame): *numpy*, the same with numpy.linalg for
    three legs at once; *half steps*, the method of libnifalcon (half Newton steps until the
    angles before the step are within 0.01 rad, at most 15), in our scalars. Error: position
    against the truth that the angles were computed from, with exact angles (the method's
    own error) and with angles in whole counts.
    """
    places = truth(options.ticks or (2000 if options.quick else 20_000))
    frames = [
        encode_reply(Reply(LEGS.counts(LEGS.inverse(place)), 0, 7)) for place in places
    ]
    part = max(1, len(frames) // PARTS)
    calls = {n: functools.partial(timed, t, frames[:part]) for n, t in METHODS.items()}
    rounds = interleaved(calls, PARTS, warm_up=True)
    took = {name: np.concatenate(each) for name, each in rounds.items()}
    rows = []
    for name, tick in METHODS.items():
        p50, p99 = np.percentile(took[name], [50, 99]).tolist()
        exact = errors_mm(tick, places[:2000], in_counts=False)
        counted = errors_mm(tick, places[:2000], in_counts=True)
        ratio = p50 / float(np.median(took["ours"]))
        rows.append([name, p50, p99, ratio, rms(exact), max(exact), rms(counted)])
        report.figures[name] = dict(zip(HEADER[1:], rows[-1][1:], strict=True))
    report.table("One tick of the Falcon", HEADER, rows)


HEADER = ["", "p50 us", "p99 us", "of ours", "error rms mm", "max mm", "rms mm, counts"]
