"""The Inverse3 on its simulated service, in virtual time and as a process."""

from hapticplayer.extras.inverse3.driver import Inverse3Driver
from hapticplayer.extras.inverse3.protocol import command
from hapticplayer.extras.inverse3.simulated.service import Service, simulation_of
from tests.unit.devices.conformance.world import ZERO, Process, World
from tests.unit.extras.inverse3.inverse_rig import VirtualLink


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

    def wait(self):
        super().wait()
        if self.is_slow:  # each answer takes 15 ms
            self.links[-1].answers = round(1e3 * self.clock.now_s()) % 15 == 0

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


WORLDS = {
    "inverse3": Inverse3,
    "inverse3-simulated": lambda: Process("inverse3-simulated"),
}
