"""A wheel and a rumbling pad on a fake kernel."""

import errno

import pytest

from hapticplayer.devices import installed_devices
from tests.unit.devices.conformance.world import Stuckable, World
from tests.unit.extras.wheels.fake_input import FakeInput


class EventDevice(World):
    """A wheel or a rumbling pad on a fake kernel."""

    has_place = False

    def __init__(self, name):
        super().__init__()
        self.patch = pytest.MonkeyPatch()
        self.kernel = FakeInput(self.clock, self.patch)
        self.name = name
        self.device = installed_devices()[name].make(-1)
        self.device.make_writer = lambda port: Stuckable(port, self)

    def press(self, _buttons):
        self.kernel.press(0x122)

    def be_slow(self):
        self.takes_s = 0.1

    def refuse(self):
        self.kernel.refusal = errno.ENOSPC

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


WORLDS = {
    "wheel": lambda: EventDevice("wheel"),
    "rumble": lambda: EventDevice("rumble"),
}
