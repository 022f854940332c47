"""The processor time of the haptics processes while nothing plays, before and at rest.

The loop, its guard and the simulated device with a paused clip: at 1 kHz, and from 30 s
later at 20 Hz.
"""

import argparse
import os
from pathlib import Path

from benchmarks.common import Report
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.loop import REST_AFTER_S
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.model import ForceTrack, PlaybackClock

TRACK = ForceTrack([0.0, 60.0], [[0.0, 1.0, 0.0]] * 2)
SETTLING_S = 2.0
BEAT_S = 0.05
MARGIN_S = 1.0
LIMIT = 0.2
"""Of the processor time before: a fortieth of the ticks, each of them dearer."""


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, help="(20) in each of both states")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure both states in one run."""
    seconds = options.seconds or (5.0 if options.quick else 20.0)
    seconds = min(seconds, REST_AFTER_S - SETTLING_S - MARGIN_S)
    paused = _Paused()
    try:
        paused.wait(SETTLING_S)
        before = paused.measure(seconds)
        paused.wait(REST_AFTER_S - SETTLING_S - seconds + MARGIN_S)
        resting = paused.measure(seconds)
    finally:
        paused.processes.close()
    rows = [
        [name, before[name], resting[name], resting[name] / max(before[name], 1e-9)]
        for name in before
    ]
    report.table("Share of a core", ["", "at 1 kHz", "at rest", "ratio"], rows)
    share = sum(resting.values()) / sum(before.values())
    report.target("at rest, of 1 kHz", share, ("<=", LIMIT))
    report.figures |= {"before": before, "at_rest": resting, "seconds": seconds}


class _Paused:
    """Plays nothing, as a paused window."""

    def __init__(self) -> None:
        self._clock = SystemClock()
        self.processes = HapticsProcesses(self._clock)
        self.processes.wait_ready()
        self.processes.load({"track": TRACK})

    def wait(self, duration_s: float) -> None:
        """Beat, and publish the same position, for so long."""
        end_s = self._clock.now_s() + duration_s
        while (now_s := self._clock.now_s()) < end_s:
            self.processes.beat()
            clock = PlaybackClock(1, now_s, 3.0, 0.0, now_s + 0.15)
            self.processes.publish(clock, "track")
            self.processes.read_ticks()
            self.processes.poll()
            self._clock.sleep_until(now_s + BEAT_S)

    def measure(self, duration_s: float) -> dict[str, float]:
        """Return the share of a core that each process takes meanwhile."""
        pids = self.processes.pids
        before = {name: _cpu_s(pid) for name, pid in pids.items()}
        start_s = self._clock.now_s()
        self.wait(duration_s)
        took_s = self._clock.now_s() - start_s
        return {n: (_cpu_s(pid) - before[n]) / took_s for n, pid in pids.items()}


def _cpu_s(pid: int) -> float:
    """Return the time in user and kernel mode of a process (proc(5), stat)."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
