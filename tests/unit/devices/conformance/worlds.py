"""Each device with another side that a test can command; what a device has to bear.

A `World` has the device under test as `device`, and lets the time pass in `tick`.
"""

import contextlib
import os
import re
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from fake_card import FakeCard
from fake_input import FakeInput
from fake_intiface import FakeIntiface
from falcon_rig import FalconGrip
from inverse_rig import VirtualLink

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.devices.falcon.silence import Silencer
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.extras.inverse3.driver import Inverse3Driver
from hapticplayer.extras.inverse3.protocol import command
from hapticplayer.extras.inverse3.simulated.service import Service, simulation_of
from hapticplayer.extras.shakers.driver import ALIVE_S, ShakerDriver
from hapticplayer.extras.shakers.silence import silence as silence_shaker
from hapticplayer.extras.toys import buttplug, tcode
from hapticplayer.simulation.falcon.record_reader import read_record
from hapticplayer.simulation.falcon.remote import Controls
from tests.doubles import DirectWriter

ROOT = Path(__file__).parents[4]
ZERO = (0.0, 0.0, 0.0)


class World:
    """What the tests ask for; times are virtual unless a process is at the other side."""

    has_place = True
    """Whether the device knows where its grip is."""
    has_buttons = has_answers = needs_guard = True

    def __init__(self):
        self.clock = ManualClock()

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


class Falcon(World):
    """The driver on a simulated bus, in virtual time."""

    def __init__(self):
        super().__init__()
        self.grip = FalconGrip(self.clock)
        self.device = self.grip.driver
        self.device.close()

    def press(self, buttons):
        self.grip.buttons = buttons

    def fall_silent(self):
        self.grip.answers = False

    def talk_nonsense(self):
        self.grip.malformed = 10**6

    def unplug(self):
        self.grip.chip.unplug()

    def are_off(self):
        commands = self.grip.mechanics.commands
        return not commands or commands[-1][1] == (0, 0, 0)

    def guard(self):
        return Silencer(self.grip.bus)

    def kill(self):
        self.grip.port.is_claimed = False  # as the system does


class EventDevice(World):
    """A wheel or a rumbling pad on a fake kernel."""

    has_place = False

    def __init__(self, name):
        super().__init__()
        self.patch = pytest.MonkeyPatch()
        self.kernel = FakeInput(self.clock, self.patch)
        self.name, self.is_stuck = name, False
        self.device = installed_devices()[name].make(-1)
        self.device.make_writer = lambda port: Stuckable(port, self)

    def press(self, _buttons):
        self.kernel.press(0x122)

    def fall_silent(self):
        self.is_stuck = True

    def talk_nonsense(self):
        self.kernel.garbage = 10**6

    def unplug(self):
        self.kernel.is_plugged = False

    def are_off(self):
        return self.kernel.felt == (0, 0)

    def guard(self):
        return installed_devices()[self.name].silence(-1)

    def kill(self):
        """Nothing: the effect goes on until it ends by itself."""

    def close(self):
        super().close()
        self.patch.undo()


class Stuckable(DirectWriter):
    """Writes, until its device takes nothing any more."""

    def __init__(self, port, world):
        super().__init__(port)
        self._world = world

    def post(self, command):
        if self._world.is_stuck:
            self.is_waiting = True
        else:
            super().post(command)


class Inverse3(World):
    """The driver on the simulated service, in virtual time."""

    def __init__(self):
        super().__init__()
        self.service = Service(simulation_of(), "3.5.0")
        self.links = []
        self.device = Inverse3Driver(self.connected, clock=self.clock)

    def connected(self):
        self.links.append(VirtualLink(self.service, self.clock))
        return self.links[-1]

    def press(self, buttons):
        self.service.simulation.buttons = buttons

    def fall_silent(self):
        self.links[-1].answers = False

    def talk_nonsense(self):
        self.service.corrupt = 10**6

    def unplug(self):
        self.links[-1].is_open = False

    def are_off(self):
        return self.service.simulation.applied_n == ZERO

    def guard(self):
        return lambda: self.links[-1].take(command("0423", "vector", ZERO))

    def kill(self):
        """Nothing: the guard holds the connection."""


class Shaker(World):
    """The driver on a card that plays in virtual time; what it plays ends with it."""

    has_place = has_buttons = has_answers = needs_guard = False

    def __init__(self):
        super().__init__()
        self.card = FakeCard(self.clock)
        settings = installed_devices()["shaker"].settings
        self.device = ShakerDriver(settings, self.clock, self.card.stream)

    def wait(self):
        super().wait()
        self.card.play()

    def fall_silent(self):
        self.card.is_asking = False
        self.clock.advance(ALIVE_S)

    def unplug(self):
        self.card.is_asking = False

    def are_off(self):
        return not self.card.heard(0.002).any()

    def guard(self):
        return silence_shaker(-1)

    def kill(self):
        self.card.is_there = False  # the card drops what a dead process left


class Toy(World):
    """A toy through a fake Intiface, in real time."""

    has_place = has_buttons = False

    def __init__(self):
        self.clock = SystemClock()
        self.server = FakeIntiface()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.lines = ours, theirs
        self.device = installed_devices()["buttplug"].make(ours.fileno())
        self.device.open_port = lambda: buttplug.ButtplugPort(
            self.server.where, ours.fileno(), self.clock, overdue_s=0.01
        )

    def wait(self):
        self.clock.sleep_until(self.clock.now_s() + 0.001)

    def fall_silent(self):
        self.server.answers = False

    def talk_nonsense(self):
        self.server.babble(100)

    def unplug(self):
        self.server.hang_up()

    def are_off(self):
        return not any(self.server.strength.values())

    def guard(self):
        return buttplug.silence(self.lines[1].fileno())

    def kill(self):
        """Nothing: the connection stays, as that of a loop that stands still."""

    def close(self):
        super().close()
        self.server.close()
        for line in self.lines:
            line.close()


class Board(World):
    """A board that takes TCode by UDP, in virtual time."""

    has_place = has_buttons = False

    def __init__(self):
        super().__init__()
        self.end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.end.bind(("127.0.0.1", 0))
        self.end.setblocking(False)
        self.where = f"127.0.0.1:{self.end.getsockname()[1]}"
        self.strength, self.sender, self.is_stuck = 0, None, False
        self.babbles = False
        self.device = installed_devices()["tcode"].make(-1)
        self.options = tcode.tcode_options(self.where)
        self.device.open_port = lambda: tcode.open_board(self.options)
        self.device.make_writer = lambda port: Stuckable(port, self)

    def wait(self):
        super().wait()
        with contextlib.suppress(OSError):
            while True:
                data, self.sender = self.end.recvfrom(200)
                for line in data.decode().splitlines():
                    is_stop = line == "DSTOP"
                    self.strength = 0 if is_stop else int(line[2:6])
        if self.babbles and self.sender:
            self.end.sendto(b"\xff\xfe", self.sender)

    def fall_silent(self):
        self.is_stuck = True

    def talk_nonsense(self):
        self.tick((1.0, 0.0, 0.0), 30)
        self.babbles = True

    def unplug(self):
        self.end.close()

    def are_off(self):
        return self.strength == 0

    def guard(self):
        return tcode.silence(-1, self.options)

    def kill(self):
        """Nothing: the board keeps its last target."""

    def close(self):
        super().close()
        self.end.close()


class Process(World):
    """A device that is a process at the other end of a line, in real time."""

    def __init__(self, name):
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
        command += ["--running"] if "falcon-simulated" in name else []
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


class Example(World):
    """The device of docs/devices.md, with a seat at the other side."""

    def __init__(self):
        super().__init__()
        self.seat = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.seat.bind(("127.0.0.1", 0))
        self.seat.setblocking(False)
        address = "{}:{}".format(*self.seat.getsockname())
        text = (ROOT / "docs" / "devices.md").read_text(encoding="utf-8")
        self.code = re.search(r"```python\n(.*?)```", text, re.DOTALL)[1]
        self.module = {}
        exec(self.code, self.module)
        self.options = DeviceOptions(self.module["SEAT"], address)
        self.device = self.module["Seat"](-1, self.options)
        self.buttons, self.answer, self.force = 0, b"P 0.001 0 %d", ["0", "0"]

    def wait(self):
        super().wait()
        with contextlib.suppress(OSError):
            while True:
                data, sender = self.seat.recvfrom(64)
                self.force = data.decode().split()[1:]
                if self.answer:
                    answer = self.answer
                    full = answer % self.buttons if b"%d" in answer else answer
                    self.seat.sendto(full, sender)

    def press(self, buttons):
        self.buttons = buttons

    def fall_silent(self):
        self.answer = b""

    def talk_nonsense(self):
        self.answer = b"P nan what"

    def unplug(self):
        self.seat.close()

    def are_off(self):
        return [float(part) for part in self.force] == [0.0, 0.0]

    def guard(self):
        return self.module["silence"](-1, self.options)

    def kill(self):
        """Nothing: UDP knows no death."""

    def close(self):
        super().close()
        self.seat.close()


WORLDS = {
    "simulated": lambda: Process("simulated"),
    "falcon": Falcon,
    "falcon-simulated": lambda: Process("falcon-simulated"),
    "inverse3": Inverse3,
    "inverse3-simulated": lambda: Process("inverse3-simulated"),
    "wheel": lambda: EventDevice("wheel"),
    "rumble": lambda: EventDevice("rumble"),
    "buttplug": Toy,
    "shaker": Shaker,
    "tcode": Board,
    "example": Example,
}


def capabilities_of(name, world):
    """Return the record under which a device is offered."""
    if name == "example":
        return world.module["SEAT"]
    return find_device(name).capabilities
