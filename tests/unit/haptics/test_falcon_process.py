"""The Falcon's own driver in the real processes, on a simulated USB device."""

import os
import signal
import socket
from contextlib import contextmanager

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.simulation.falcon.remote import Controls
from tests.material.plant_record import read_record
from tests.rigs import PATIENCE_S, FeedingPlayer

pytestmark = pytest.mark.realtime

PUSH_N = 2.8


class Bench(FeedingPlayer):
    """A player, and what the hand feels."""

    def __init__(self, process, record, controls):
        super().__init__(process, PUSH_N)
        self.controls = controls
        self._record = record

    def play_until_it_pushes(self):
        """Play until the hand feels what is commanded.

        While the grip moves, torques for where it was are another force where it is.
        """
        return self.play_until(
            lambda t: (
                t["force_n"][-1, 2] > PUSH_N - 0.01
                and self.pushed_n() == pytest.approx(PUSH_N, abs=0.2)
            )
        )

    def pushed_n(self):
        return read_record(self._record)["applied_n"][-1][2]

    def wait_until_let_go(self):
        """Return the seconds until the motors are off, without a beat or word."""
        start_s = self.clock.now_s()
        while self.pushed_n() != 0.0:
            assert self.clock.now_s() < start_s + PATIENCE_S
            self.clock.sleep_until(self.clock.now_s() + 0.001)
        return self.clock.now_s() - start_s


@contextmanager
def falcon(*options):
    record = os.memfd_create("record")
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    options += ("--record", str(record), "--control", str(theirs.fileno()))
    process = HapticsProcesses(
        SystemClock(),
        "falcon-simulated",
        device_options=["--hand", "firm", *options],
        device_descriptors=[record, theirs.fileno()],
    )
    theirs.close()
    controls = Controls(ours.detach())
    try:
        yield Bench(process, record, controls)
    finally:
        process.close()
        controls.close()
        os.close(record)


def test_firmware_and_homing_come_before_any_force():
    with falcon("--unhomed") as bench:
        ticks = bench.play_until_it_pushes()
    causes = ticks["cause"]
    homed_at = np.flatnonzero(causes == Cause.NOT_HOMED)[-1]
    assert homed_at > 1000  # out and in again
    assert not ticks["force_n"][: homed_at + 1].any()
    followed = ticks[ticks["mode"] == Mode.FOLLOWING]
    assert len(followed) == 0 or followed["reply_age_s"].max() < 0.1


def test_when_the_loop_is_killed_the_guard_takes_the_force_away():
    with falcon("--running") as bench:
        bench.play_until_it_pushes()
        os.kill(bench.process.pids["loop"], signal.SIGKILL)
        os.waitid(os.P_PID, bench.process.pids["guard"], os.WEXITED | os.WNOWAIT)
        assert bench.pushed_n() == 0.0


def test_a_loop_that_stands_still_is_silenced_over_its_own_line():
    with falcon("--running") as bench:
        bench.play_until_it_pushes()
        os.kill(bench.process.pids["loop"], signal.SIGSTOP)
        try:
            bench.wait_until_let_go()
            bench.clock.sleep_until(bench.clock.now_s() + 0.1)
            assert bench.pushed_n() == 0.0
            assert bench.process.health is Health.READY  # the guard has not ended
        finally:
            os.kill(bench.process.pids["loop"], signal.SIGCONT)
        ticks = bench.play_until(lambda t: t["mode"][-1] == Mode.TRIPPED)
        assert ticks["cause"][-1] == Cause.TICK_LOST
        assert bench.process.health is Health.READY


def test_pulling_the_cable_is_told():
    with falcon("--running") as bench:
        bench.play_until_it_pushes()
        bench.controls.unplug()
        bench.play_until(lambda t: t["cause"][-1] == Cause.UNPLUGGED)
        bench.play_until(lambda _: bench.process.health is Health.FAILED)
        assert "unplugged" in bench.process.problem


def test_a_stall_of_200_ms_trips_and_the_exchange_resumes():
    with falcon("--running") as bench:
        bench.play_until_it_pushes()
        bench.controls.stall(0.2)
        ticks = bench.play_until(lambda t: t["mode"][-1] == Mode.TRIPPED)
        assert ticks["cause"][-1] in (Cause.REPLY_LOST, Cause.TICK_LOST)
        bench.play_until(lambda t: t["reply_age_s"][-1] < 0.01)
        assert bench.pushed_n() == 0.0
        assert bench.process.health is Health.READY
