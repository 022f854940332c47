"""Whether a tick waits for the Falcon: lateness, time in `exchange`, age of answers.

    python benchmarks/falcon_exchange.py [--rounds 6] [--seconds 5]

A bare loop of 1 kHz, with the scheduling of the haptics process, runs in turns without
a device, with the driver on a simulated Falcon at the chip's 1 ms latency timer, and
with the event character. pyusb is the real one; chip, board and physics are a process
of their own, as they are for `--device falcon-simulated`. A real Falcon takes no
time of this machine, so the loop and its threads have the first core and the simulated
device the last one, in every kind of run.
"""

import argparse
import gc
import os
import socket
import statistics
import subprocess
import sys
from typing import Any

import numpy as np
from common import save, table

from hapticplayer.clock import SystemClock
from hapticplayer.devices import DEVICES
from hapticplayer.devices.falcon.driver import FalconDriver, Options
from hapticplayer.haptics.scheduling import (
    DEVICE_PRIORITY,
    CpuLatencyRequest,
    acquire,
    grant,
)
from hapticplayer.simulation.usb import driver

PERIOD_S = 0.001
SETTLING_TICKS = 200
KINDS: dict[str, Options | None] = {
    "no device": None,
    "latency timer": Options(),
    "event character": Options(event_character=True),
}


def run(options: Options | None, ticks: int) -> dict[str, float]:
    """Return percentiles of one run, us."""
    clock = SystemClock()
    device, server = None, None
    if options is not None:
        server, descriptor = start_falcon()
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
            replied_s, end_s = exchange(device, now_s, clock)
            took.append(end_s - now_s)
            age.append(now_s - replied_s)
        missed = int((clock.now_s() - deadline_s) / PERIOD_S)
        deadline_s += (missed + 1) * PERIOD_S
    gc.enable()
    if device is not None and server is not None:
        device.close()
        server.kill()
        server.wait()
    found = {}
    for name, values in (("late", late), ("exchange", took), ("age", age)):
        for q in (50, 99) if values else ():
            us = 1e6 * float(np.percentile(values[SETTLING_TICKS:], q))
            found[f"{name} p{q}"] = us
    return found


def start_falcon() -> tuple[subprocess.Popen[bytes], int]:
    """Return the process of a simulated Falcon, and our end of its line."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    command = [sys.executable, "-P", "-m", DEVICES["falcon-simulated"].server]
    command += ["--line", str(theirs.fileno()), "--running"]
    server = subprocess.Popen(command, pass_fds=[theirs.fileno()])
    theirs.close()
    os.sched_setaffinity(server.pid, {(os.cpu_count() or 1) - 1})
    grant(server.pid, priority=DEVICE_PRIORITY)
    return server, ours.detach()


def exchange(
    device: FalconDriver, now_s: float, clock: SystemClock
) -> tuple[float, float]:
    """Do one exchange; return when its answer was read, and when it was over."""
    reading = device.exchange((0.5, 0.0, -0.5), now_s)
    return reading.replied_s, clock.now_s()


def main() -> int:
    """Run all kinds in turns, print and save medians over the rounds."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--seconds", type=float, default=5.0)
    options = parser.parse_args()
    scheduling = acquire(None).value
    CpuLatencyRequest().set_active(is_active=True)  # as the loop does while it plays
    ticks = int(options.seconds / PERIOD_S)
    cores = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, cores[:1])
    rounds = [
        {name: run(kind, ticks) for name, kind in KINDS.items()}
        for _ in range(options.rounds)
    ]
    result: dict[str, Any] = {"scheduling": scheduling}
    for name in KINDS:
        result[name] = {
            key: statistics.median(one[name][key] for one in rounds)
            for key in rounds[0][name]
        }
        for q in ("p50", "p99"):
            result[name][f"late {q}, of no device"] = statistics.median(
                one[name][f"late {q}"] / one["no device"][f"late {q}"] for one in rounds
            )
    keys = list(result["latency timer"])
    rows = [[key, *(result[name].get(key, "-") for name in KINDS)] for key in keys]
    print(f"scheduling: {scheduling}; microseconds, medians of {options.rounds} rounds")
    print(table(["", *KINDS], rows))
    print(f"saved {save('falcon_exchange', result).name}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
