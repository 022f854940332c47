"""Simulated Falcons under the real pyusb, in virtual time."""

import json
import random
from dataclasses import dataclass, field

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.devices.falcon.driver import FalconDriver, Options
from hapticplayer.devices.falcon.firmware import MemoryBlock, build_image, parse_image
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.link import DirectLink
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.extras.faults.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.extras.faults.usb.board import Board, Stage
from hapticplayer.extras.faults.usb.chip import Chip
from tests.doubles import BenchMechanics


@pytest.fixture(scope="session")
def golden(shared_data):
    """Reference values that were computed before this package was written."""
    return json.loads((shared_data / "falcon" / "golden.json").read_text())


@pytest.fixture(scope="session")
def image():
    """A synthetic program of about a tenth of the real ones' length."""
    random_words = random.Random(1)
    words = tuple(random_words.randrange(0x10000) for _ in range(400))
    return parse_image(
        build_image(
            0x3F8002, (MemoryBlock(0x3F8002, words), MemoryBlock(0x93A2, (1, 0, 0, 2)))
        )
    )


@dataclass
class Bench:
    """A Falcon on a simulated bus, everything in virtual time."""

    image: object
    stage: Stage = Stage.DARK
    clock: ManualClock = field(default_factory=ManualClock)
    openings: int = 0

    def __post_init__(self):
        self.mechanics = BenchMechanics()
        self.board = Board(self.mechanics, self.stage)
        self.chip = Chip(self.board, self.clock)
        self.port = SimulatedPort(self.chip)
        self.bus = SimulatedBus([self.port])

    @property
    def faults(self):
        return self.board.faults

    def open(self):
        self.openings += 1
        return open_falcon(backend=self.bus)

    def ftdi(self):
        return Ftdi(self.open())

    def driver(self, **options):
        return FalconDriver(
            self.open,
            clock=self.clock,
            image=lambda: self.image,
            make_link=DirectLink,
            options=Options(**options),
        )


@pytest.fixture
def bench(image):
    """A Falcon that was just plugged in."""
    return Bench(image)


@pytest.fixture
def running(image):
    """A Falcon whose firmware runs."""
    return Bench(image, Stage.RUNNING)
