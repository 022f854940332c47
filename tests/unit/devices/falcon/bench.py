"""A Falcon on a simulated bus, under the real pyusb."""

from dataclasses import dataclass, field

from hapticplayer.clock import ManualClock
from hapticplayer.devices.falcon.driver import FalconDriver, Options
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.link import DirectLink
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.extras.faults.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.extras.faults.usb.board import Board, Stage
from hapticplayer.extras.faults.usb.chip import Chip
from tests.doubles import BenchMechanics


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
