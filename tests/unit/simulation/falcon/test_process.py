"""The simulated device as a process: it outlives its player, and then ends."""

import os
import signal
import socket
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import DeviceError
from hapticplayer.simulation.falcon.remote import Controls, RemoteFalcon, silence
from tests.material.plant_record import read_record

pytestmark = pytest.mark.realtime

ZERO = (0.0, 0.0, 0.0)
PUSH = (2.0, 0.0, 0.0)
PATIENCE_S = 30.0


class Bench:
    """One process, and three holders of the other end of its line."""

    def __init__(self, *options):
        self.clock = SystemClock()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        control, their_control = socket.socketpair(
            socket.AF_UNIX, socket.SOCK_SEQPACKET
        )
        self.record = os.memfd_create("record")
        passed = (theirs.fileno(), self.record, their_control.fileno())
        command = [sys.executable, "-P", "-m", "hapticplayer.simulation.falcon"]
        command += ["--line", str(passed[0]), "--record", str(passed[1])]
        command += ["--control", str(passed[2]), *options]
        self.process = subprocess.Popen(command, pass_fds=passed)
        theirs.close()
        their_control.close()
        self.guard_end = os.dup(ours.fileno())
        self.controls = Controls(control.detach())
        self.device = RemoteFalcon(ours.detach())
        self.device.open()

    def run(self, force_n, count):
        for _ in range(count):
            reading = self.device.exchange(force_n, self.clock.now_s())
            self.clock.sleep_until(self.clock.now_s() + 0.001)
        return reading

    def close(self):
        self.process.kill()
        self.process.wait()
        self.controls.close()
        self.device.close()
        os.close(self.record)


@pytest.fixture
def bench(request):
    bench = Bench(*getattr(request, "param", ()))
    yield bench
    bench.close()


def test_a_simulated_falcon_answers_and_moves(bench):
    os.close(bench.guard_end)
    reading = bench.run(PUSH, 500)
    assert reading.is_homed
    assert 0.005 < reading.position_m[0] < 0.03
    found = read_record(bench.record)
    assert found["applied_n"].max() == 2.0
    assert np.all(np.diff(found["monotonic_s"]) >= 0.0)


def test_zero_arrives_after_the_player_has_died_and_is_on_record(bench):
    write_zero = silence(bench.guard_end)
    bench.run(PUSH, 50)
    bench.device.close()  # what its death would do
    assert write_zero()
    os.close(bench.guard_end)
    bench.process.send_signal(signal.SIGTERM)  # and it does not go before its time
    bench.process.send_signal(signal.SIGINT)
    bench.process.send_signal(signal.SIGHUP)
    assert bench.process.wait(PATIENCE_S) == 0
    last = read_record(bench.record)[-1]
    np.testing.assert_array_equal(last["applied_n"], ZERO)
    assert last["position_m"][0] > 0.0


@pytest.mark.parametrize(
    "bench", [("--hold-s", "0.02", "--hand", "firm")], indirect=True
)
def test_the_motors_let_go_by_themselves_after_the_hold_time(bench):
    bench.run(PUSH, 50)
    last_s = bench.clock.now_s()
    bench.clock.sleep_until(last_s + 0.2)
    os.close(bench.guard_end)
    bench.device.close()
    assert bench.process.wait(PATIENCE_S) == 0
    found = read_record(bench.record)
    accepted = found[found["applied_n"][:, 0] > 0.0][-1]["monotonic_s"]
    np.testing.assert_array_equal(found[-1]["applied_n"], ZERO)
    # exact, although nothing woke the process at that very moment
    assert found[-1]["applied_since_s"] >= accepted
    assert found[-1]["applied_since_s"] < last_s + 0.021


def test_an_unplugged_device_is_an_error_and_not_a_crash(bench):
    os.close(bench.guard_end)
    bench.run(PUSH, 20)
    bench.controls.unplug()
    with pytest.raises(DeviceError, match="unplugged"):
        bench.run(PUSH, 10_000)
    assert bench.process.wait(PATIENCE_S) == 0


def test_a_device_that_was_killed_is_an_error_too(bench):
    write_zero = silence(bench.guard_end)
    bench.run(PUSH, 20)
    bench.process.kill()
    bench.process.wait()
    with pytest.raises(DeviceError, match="unplugged"):
        bench.device.exchange(PUSH, bench.clock.now_s())
    assert not write_zero()
    os.close(bench.guard_end)
