"""Each device with another side; those of an extra are beside its tests."""

import contextlib
import importlib
import re
import socket
from pathlib import Path

from hapticplayer.devices import find_device
from hapticplayer.devices.falcon.silence import Silencer
from hapticplayer.devices.options import DeviceOptions
from tests.unit.devices.conformance.world import Process, World

ROOT = Path(__file__).parents[4]


class Falcon(World):
    """The driver on a simulated bus, in virtual time."""

    def __init__(self):
        super().__init__()
        from tests.faults.falcon_rig import FalconGrip

        self.grip = FalconGrip(self.clock)
        self.device = self.grip.driver
        self.device.close()

    def wait(self):
        super().wait()
        if self.is_slow and self.clock.now_s() > self.grip.chip.stalled_until_s + 0.004:
            self.grip.chip.stalled_until_s = self.clock.now_s() + 0.011

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
        if self.is_slow and round(1e3 * self.clock.now_s()) % 15:
            return
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
    "example": Example,
}
for _file in sorted((ROOT / "tests" / "unit" / "extras").glob("*/worlds.py")):
    WORLDS |= importlib.import_module(
        f"tests.unit.extras.{_file.parent.name}.worlds"
    ).WORLDS


def capabilities_of(name, world):
    """Return the record under which a device is offered."""
    if name == "example":
        return world.module["SEAT"]
    return find_device(name).capabilities
