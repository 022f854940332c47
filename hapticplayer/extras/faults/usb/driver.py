"""The real driver on the simulated USB: whole sets for tests, and for the loop."""

from dataclasses import dataclass
from typing import Any

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.falcon.driver import DEFAULTS, FalconDriver, Options
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.silence import NO_LINE
from hapticplayer.devices.falcon.transport import OpenTransport, Transport, open_falcon
from hapticplayer.extras.faults.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.extras.faults.usb.board import Board, Stage, synthetic_image
from hapticplayer.extras.faults.usb.chip import Chip
from hapticplayer.extras.faults.usb.mechanics import Homing, SimulatedMechanics
from hapticplayer.extras.faults.usb.remote import RemoteChip
from hapticplayer.simulation.falcon.simulation import Simulation


@dataclass(frozen=True, slots=True)
class SimulatedSet:
    """A driver, not yet open, and all that it stands on, for faults and truth."""

    driver: FalconDriver
    simulation: Simulation
    board: Board
    chip: Chip
    bus: SimulatedBus


def make_set(
    simulation: Simulation | None = None,
    *,
    clock: Clock | None = None,
    stage: Stage = Stage.RUNNING,
    homing: Homing | None = None,
) -> SimulatedSet:
    """Return a Falcon in a hand (a relaxed one by default), with the real driver on it.

    It is RUNNING with its firmware or DARK when just plugged in; one that does not know
    its zero yet needs a `homing` owner.
    """
    clock = clock or SystemClock()
    simulation = simulation or Simulation()
    mechanics = SimulatedMechanics(simulation)
    mechanics.homing = homing
    board = Board(mechanics, stage)
    chip = Chip(board, clock)
    bus = SimulatedBus([SimulatedPort(chip)])
    driver = FalconDriver(
        lambda: open_falcon(backend=bus), clock=clock, image=synthetic_image
    )
    return SimulatedSet(driver, simulation, board, chip, bus)


def opening(descriptor: int) -> OpenTransport:
    """The opener of the Falcon at the other end of a descriptor, which it takes."""
    bus: list[Any] = []

    def open_transport() -> Transport:
        if not bus:
            port = SimulatedPort(RemoteChip(descriptor))
            bus.append(SimulatedBus([port]))
        return open_falcon(backend=bus[0])

    return open_transport


def make(descriptor: int, options: Options = DEFAULTS) -> FalconDriver:
    return FalconDriver(opening(descriptor), image=synthetic_image, options=options)


def simulated(line: int, _serial: str) -> Reach:
    """Return how to get at one: at the other end of a line, or made here and now."""
    if line != NO_LINE:
        return Reach(opening(line), synthetic_image)
    bus = make_set(stage=Stage.DARK, homing=Homing()).bus
    return Reach(lambda: open_falcon(backend=bus), synthetic_image)
