"""Measuring without the loop: the guard takes the force away all the same."""

import os
import signal
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.extras.measuring.measuring import PUSH_N
from tests.material.plant_record import read_record

pytestmark = pytest.mark.realtime

PATIENCE_S = 30.0
OWNER = Path(__file__).with_name("measuring_owner.py")


class Measurement:
    """A process that measures, and what the hand feels."""

    def __init__(self, record):
        self.clock, self._record = SystemClock(), record
        self.process = subprocess.Popen(
            [sys.executable, str(OWNER), str(record)],
            pass_fds=[record],
            stdout=subprocess.PIPE,
            text=True,
        )
        self.guard = int(self.process.stdout.readline())

    def pushed_n(self):
        applied_n = read_record(self._record)["applied_n"]
        return applied_n[-1][0] if len(applied_n) else 0.0

    def wait(self, condition):
        end_s = self.clock.now_s() + PATIENCE_S
        while not condition():
            assert self.clock.now_s() < end_s, "it did not happen"
            self.clock.sleep_until(self.clock.now_s() + 0.002)

    def wait_until_it_pushes(self):
        self.wait(lambda: os.fstat(self._record).st_size > 0)
        self.wait(lambda: self.pushed_n() > 0.9 * PUSH_N)

    def has_ended(self, pid):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return True
        return False


@contextmanager
def measuring():
    record = os.memfd_create("record")
    made = Measurement(record)
    try:
        yield made
    finally:
        made.process.kill()
        made.process.communicate()
        made.wait(lambda: made.has_ended(made.guard))
        os.close(record)


def rest(measurement):
    measurement.wait(lambda: measurement.pushed_n() == 0.0)
    measurement.clock.sleep_until(measurement.clock.now_s() + 0.1)
    assert measurement.pushed_n() == 0.0


@pytest.mark.parametrize("after_s", [0.0, 0.5])
def test_when_the_measurement_is_killed_the_motors_are_off(after_s):
    with measuring() as made:
        made.wait_until_it_pushes()
        made.clock.sleep_until(made.clock.now_s() + after_s)
        made.process.send_signal(signal.SIGKILL)
        rest(made)
        made.wait(lambda: made.has_ended(made.guard))


def test_a_measurement_that_stands_still_is_silenced():
    with measuring() as made:
        made.wait_until_it_pushes()
        made.process.send_signal(signal.SIGSTOP)
        rest(made)
        assert not made.has_ended(made.guard)


def test_without_its_guard_a_measurement_ends_at_zero():
    with measuring() as made:
        made.wait_until_it_pushes()
        os.kill(made.guard, signal.SIGKILL)
        said, _ = made.process.communicate(timeout=PATIENCE_S)
        assert "guard has ended" in said
        assert made.process.returncode == 1
        assert made.pushed_n() == 0.0


def test_when_both_are_killed_the_last_force_stays():
    """So that it is the guard, and nothing else, that the tests above show."""
    with measuring() as made:
        made.wait_until_it_pushes()
        os.kill(made.guard, signal.SIGKILL)
        made.process.kill()
        made.process.wait()
        made.clock.sleep_until(made.clock.now_s() + 0.2)
        assert made.pushed_n() > 0.5 * PUSH_N
