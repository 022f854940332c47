"""Another side of a device that a test can command.

A `World` has the device under test as `device`, and lets the time pass in `tick`.
"""

import contextlib
import os
import socket
import subprocess
import sys

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices import installed_devices
from hapticplayer.simulation.falcon.remote import Controls
from tests.doubles import DirectWriter
from tests.material.plant_record import read_record

ZERO = (0.0, 0.0, 0.0)


class World:
    """What the tests ask for; times are virtual unless a process is at the other side."""

    has_place = True
    """Whether the device knows where its grip is."""
    has_buttons = has_answers = needs_guard = can_be_slow = True
    is_slow = is_stuck = False
    takes_s = 0.0
    """For each command, a device that is slow to take them."""

    def __init__(self):
        self.clock = ManualClock()

    def be_slow(self):
        """Be as slow as no fault is; called before the device is opened."""
        self.is_slow = True

    def refuse(self):
        """Answer everything from now on with an error."""
        self.talk_nonsense()

    def tick(self, force_n=ZERO, count=1):
        """Exchange every millisecond; return the last reading."""
        for _ in range(count):
            reading = self.device.exchange(force_n, self.clock.now_s())
            self.wait()
        return reading

    def wait(self):
        self.clock.advance(0.001)

    def until(self, condition, force_n=ZERO):
        """Exchange until the reading is so; time enough for a busy machine."""
        for _ in range(3000):
            if condition(reading := self.tick(force_n)):
                return reading
        raise AssertionError(f"never; last {reading}")

    def until_motors(self, are_off, force_n=None):
        """Wait until the motors are off, or on; with exchanges if there is a force."""
        for _ in range(3000):
            if self.are_off() is are_off:
                return
            if force_n is not None:
                self.tick(force_n)
            else:
                self.wait()
        raise AssertionError("the motors never were")

    def close(self):
        self.device.close()


class Stuckable(DirectWriter):
    """Writes, each in its time, until its device takes nothing any more."""

    def __init__(self, port, world):
        super().__init__(port)
        self._world, self._newest, self._due_s = world, b"", None
        self.taken = 0

    def post(self, command):
        self._newest = command
        if self._due_s is None:
            self._due_s = self._world.clock.now_s() + self._world.takes_s
        self._take()

    @property
    def is_waiting(self):
        self._take()
        return self._due_s is not None

    def _take(self):
        if self._due_s is None or self._world.is_stuck:
            return
        if self._world.clock.now_s() >= self._due_s:
            self._due_s = None
            super().post(self._newest)
            self.taken += 1


class Process(World):
    """A device that is a process at the other end of a line, in real time."""

    can_be_slow = False  # its driver is slow in virtual time

    def __init__(self, name, *more):
        self.clock = SystemClock()
        entry = installed_devices()[name]
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        control, their_control = socket.socketpair(
            socket.AF_UNIX, socket.SOCK_SEQPACKET
        )
        self.record = os.memfd_create("record")
        passed = (theirs.fileno(), self.record, their_control.fileno())
        command = [sys.executable, "-P", "-m", entry.server, "--line", str(passed[0])]
        command += ["--record", str(passed[1]), "--control", str(passed[2])]
        command += more
        self.process = subprocess.Popen(command, pass_fds=passed)
        theirs.close()
        their_control.close()
        self.guard_end = os.dup(ours.fileno())
        self.controls = Controls(control.detach())
        self.entry = entry
        self.device = entry.make(ours.detach())

    def wait(self):
        self.clock.sleep_until(self.clock.now_s() + 0.001)

    def press(self, buttons):
        self.controls.press(buttons)

    def fall_silent(self):
        self.controls.stall(30.0)

    def talk_nonsense(self):
        self.controls.corrupt(10**6)

    def unplug(self):
        self.controls.unplug()

    def are_off(self):
        with contextlib.suppress(ValueError):  # nothing was written yet
            found = read_record(self.record)
            return not len(found) or not found["applied_n"][-1].any()
        return True

    def guard(self):
        return self.entry.silence(self.guard_end)

    def kill(self):
        """Nothing: the device outlives its loop."""

    def close(self):
        super().close()
        self.process.kill()
        self.process.wait()
        self.controls.close()
        os.close(self.guard_end)
        os.close(self.record)
