"""What shakes: two motors that follow the force, the newest command counts, zero at the end."""

import math
import subprocess
import sys
import threading

import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices.capabilities import VIBRATION
from hapticplayer.devices.paced import (
    NewestWriter,
    PacedDriver,
    QuietPort,
    Rumble,
    silencer,
)
from hapticplayer.errors import DeviceError
from tests.doubles import DirectWriter

ZERO = (0.0, 0.0, 0.0)
REFRESH_S = 0.5


class FakePad(QuietPort):
    """Two motors whose command is two bytes (`paced.Port` and its translator)."""

    off = bytes(2)

    def __init__(self):
        self.written, self.is_plugged, self.is_open = [], True, True
        self.translator, self._rumble = self, Rumble()

    def command(self, force_n, now_s):
        return bytes(self._rumble.levels(force_n, now_s))

    def write(self, command):
        if not self.is_plugged:
            raise DeviceError("the pad was unplugged; plug it in and choose it again")
        self.written.append(command)

    def read(self):
        return b""

    def close(self):
        self.is_open = False

    @property
    def motors(self):
        """(large, small) as last sent."""
        return tuple(self.written[-1]) if self.written else (0, 0)


def steady(rumble, force_n, seconds, begin_s=0.0):
    for k in range(round(1000 * seconds)):
        levels = rumble.levels(force_n(k / 1000.0), begin_s + k / 1000.0)
    return levels


def test_a_steady_force_is_felt_in_the_large_motor():
    assert steady(Rumble(), lambda _: (0.0, 2.25, 0.0), 1.0) == (128, 0)
    assert steady(Rumble(), lambda _: (3.0, 3.0, 3.0), 1.0) == (255, 0)  # above full
    assert Rumble().levels((0.0, 4.5, 0.0), 0.0)[1] > 200  # a jolt


@pytest.mark.parametrize(("hertz", "least", "most"), [(1, 0, 20), (40, 45, 85)])
def test_force_changes_above_10_hz_turn_the_small_motor(hertz, least, most):
    """Of 2.25 N +- 1 N (57 levels): a one-pole high-pass at 10 Hz lets 0.1 and 0.97 by."""
    levels = []
    rumble = Rumble()
    for k in range(2000):
        t = k / 1000.0
        size = 2.25 + math.sin(2 * math.pi * hertz * t)
        levels.append(rumble.levels((size, 0.0, 0.0), t)[1])
    assert least <= max(levels[1000:]) <= most


def test_a_force_that_is_not_a_number_turns_no_motor():
    rumble = Rumble()
    for bad in (math.nan, math.inf):
        assert rumble.levels((bad, 0.0, 0.0), 1.0) == (0, 0)
    assert steady(rumble, lambda _: (0.0, 2.25, 0.0), 1.0, 2.0) == (128, 0)


def test_at_most_100_reports_a_second_and_none_without_news():
    pad = FakePad()
    device = PacedDriver("pad", VIBRATION, lambda: pad, REFRESH_S, DirectWriter)
    device.open()
    for k in range(1000):
        t = k / 1000.0
        device.exchange((2.0 + math.sin(50 * t), 0.0, 0.0), 5.0 + t)
    assert 80 < len(pad.written) <= 100
    for k in range(3000):
        device.exchange((2.0, 0.0, 0.0), 6.0 + k / 1000.0)
    pad.written.clear()
    for k in range(2000):  # a steady force is sent again from time to time
        device.exchange((2.0, 0.0, 0.0), 9.0 + k / 1000.0)
    assert 3 <= len(pad.written) <= 4
    for k in range(1000):
        device.exchange(ZERO, 11.0 + k / 1000.0)
    assert pad.motors == (0, 0)
    pad.written.clear()
    for k in range(1000):
        device.exchange(ZERO, 12.0 + k / 1000.0)
    assert pad.written == []
    device.close()
    assert pad.motors == (0, 0)
    assert not pad.is_open


def test_the_thread_sends_the_newest_and_tells_of_a_lost_pad():
    pad, written = FakePad(), threading.Event()
    write = pad.write

    def slow_write(report):
        write(report)
        written.set()

    pad.write = slow_write
    writer = NewestWriter(pad)
    writer.post(bytes((7, 0)))
    assert written.wait(30)
    pad.is_plugged = False
    written.clear()

    def go_on():
        for _ in range(10_000):  # the thread meets it a little later
            writer.post(bytes((8, 0)))
            written.wait(0.001)

    with pytest.raises(DeviceError, match="unplugged"):
        go_on()
    writer.stop()
    assert pad.motors == (7, 0)


def test_the_guard_switches_off_beside_the_loop_and_after_it():
    pad = FakePad()
    write_zero = silencer(lambda: pad)
    pad.write(bytes((200, 100)))
    assert write_zero()
    assert pad.motors == (0, 0)
    pad.is_plugged = False
    assert not write_zero()


def test_a_program_that_ends_without_closing_leaves_no_motor_on():
    code = """
from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices.capabilities import VIBRATION
from hapticplayer.devices.paced import PacedDriver
from tests.unit.devices.test_paced import FakePad
pad = FakePad()
close = pad.close
pad.close = lambda: (print("motors", *pad.motors), close())
device = PacedDriver("pad", VIBRATION, lambda: pad, 0.5)
device.open()
for k in range(50):
    device.exchange((4.0, 0.0, 0.0), 1.0 + k / 1000.0)
raise RuntimeError("something else is broken")
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert "RuntimeError" in done.stderr
    assert done.stdout.splitlines()[-1] == "motors 0 0"


class SlowWriter:
    """A device that takes each command after so many milliseconds."""

    def __init__(self, port, takes_ms):
        self._port, self._takes_ms, self._left = port, takes_ms, 0
        self._newest, self.taken = None, 0

    @property
    def is_waiting(self):
        return self._left > 0

    def post(self, command):
        self._newest = command
        self._left = self._left or self._takes_ms

    def pass_1_ms(self):
        if self._left:
            self._left -= 1
            if not self._left:
                command, self._newest = self._newest, None
                self._port.write(command)
                self.taken += 1

    def stop(self):
        pass


@pytest.mark.parametrize(
    ("takes_ms", "is_fresh"), [(30, True), (120, True), (300, False)]
)
def test_a_device_that_is_slow_to_take_a_command_is_not_silent(takes_ms, is_fresh):
    clock, pad, made = ManualClock(), FakePad(), []

    def writer(port):
        made.append(SlowWriter(port, takes_ms))
        return made[0]

    device = PacedDriver("pad", VIBRATION, lambda: pad, REFRESH_S, writer)
    device.open()
    ages_s = []
    for k in range(1000):
        force_n = (2.0 + math.sin(k / 20.0), 0.0, 0.0)
        now_s = clock.now_s()
        ages_s.append(now_s - device.exchange(force_n, now_s).replied_s)
        made[0].pass_1_ms()
        clock.advance(0.001)
    assert (max(ages_s) < 0.02) is is_fresh
    period_ms = max(takes_ms, 1000 / VIBRATION.rate_hz)
    assert len(pad.written) == pytest.approx(1000 / period_ms, rel=0.25, abs=1)
    device.close()


def test_a_force_that_passes_zero_sends_no_stop():
    clock, pad = ManualClock(), FakePad()
    device = PacedDriver("pad", VIBRATION, lambda: pad, REFRESH_S, DirectWriter)
    device.open()
    for k in range(1000):
        force_n = (0.0, 0.0, 0.0) if k % 100 < 4 else (2.0, 0.0, 0.0)
        pad.pace_s = 0.09
        device.exchange(force_n, clock.now_s())
        clock.advance(0.001)
    assert pad.written.count(bytes(2)) <= 2
    for _ in range(25):
        device.exchange(ZERO, clock.now_s())
        clock.advance(0.001)
    assert pad.motors == (0, 0)
    device.close()


@pytest.mark.parametrize(
    "problem", [DeviceError("it is gone; connect it"), ValueError(7)]
)
def test_a_failure_of_the_writing_thread_is_heard(problem):
    pad = FakePad()

    def write(_command):
        raise problem

    pad.write = write
    device = PacedDriver("pad", VIBRATION, lambda: pad, REFRESH_S)
    device.open()

    def play():
        clock = SystemClock()
        end_s = clock.now_s() + 30.0
        while (now_s := clock.now_s()) < end_s:
            device.exchange((math.sin(now_s), 1.0, 0.0), now_s)
            clock.sleep_until(now_s + 0.001)

    with pytest.raises(DeviceError, match=r"it is gone; |driver failed \(ValueError"):
        play()
    del pad.write
    device.close()
