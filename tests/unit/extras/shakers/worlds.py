"""A shaker on a card that plays in virtual time."""

from hapticplayer.devices import installed_devices
from hapticplayer.extras.shakers.driver import ALIVE_S, ShakerDriver
from hapticplayer.extras.shakers.silence import silence as silence_shaker
from tests.unit.devices.conformance.world import World
from tests.unit.extras.shakers.fake_card import FakeCard


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
        if not self.is_slow or round(1e3 * self.clock.now_s()) % 150 == 0:
            self.card.play()

    def fall_silent(self):
        self.card.is_asking = False
        self.clock.advance(ALIVE_S)

    def refuse(self):
        self.card.problem = "Device unavailable"

    def unplug(self):
        self.card.is_asking = False

    def are_off(self):
        return not self.card.heard(0.002).any()

    def guard(self):
        return silence_shaker(-1)

    def kill(self):
        self.card.is_there = False  # the card drops what a dead process left


WORLDS = {"shaker": Shaker}
