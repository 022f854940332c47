"""Whether a tick waits for the Falcon: lateness, time in `exchange`, age of answers.

A bare loop of 1 kHz, with the scheduling of the haptics process, runs alternating without
a device, with the driver on a simulated Falcon at the chip's 1 ms latency timer, and
with the event character. pyusb is the real one; chip, board and physics are a process
of their own. A real Falcon takes no time of this machine, so the loop and its threads
have the first core and the simulated device the last one, in every kind of run.
"""

import argparse
import functools
import gc
import os
import socket
import subprocess
import sys

import numpy as np

from benchmarks.common import Report, interleaved, medians, ratio
from hapticplayer.clock import SystemClock
from hapticplayer.devices import DEVICES
from hapticplayer.devices.falcon.driver import Options
from hapticplayer.haptics.scheduling import (
    DEVICE_PRIORITY,
    CpuLatencyRequest,
    acquire,
    grant,
)
from hapticplayer.simulation.usb import driver

PERIOD_S = 0.001
SETTLING_TICKS = 200
MOST_AGE_US = 3000.0
KINDS: dict[str, Options | None] = {
    "no device": None,
    "latency timer": Options(),
    "event character": Options(event_character=True),
}


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, default=5.0)


def run(options: argparse.Namespace, report: Report) -> None:
    """Run all kinds alternating."""
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
    command = [sys.executable, "-P", "-m", DEVICES["falcon-simulated"].server]
    command += ["--line", str(theirs.fileno()), "--running"]
    server = subprocess.Popen(command, pass_fds=[theirs.fileno()])
    theirs.close()
    os.sched_setaffinity(server.pid, {(os.cpu_count() or 1) - 1})
    grant(server.pid, priority=DEVICE_PRIORITY)
    return server, ours.detach()
