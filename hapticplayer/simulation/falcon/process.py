"""What the processes of simulated devices share: their options, and a record.

The record has the state of the Falcon at each tick, in memory that outlives every
process, a ring in a file or memfd: a benchmark that holds the descriptor reads when the
zero arrived, also when player, loop and device have died meanwhile.
"""

import argparse
import math
import mmap
import os
import struct

from hapticplayer.devices.dynamics import HANDS, Mechanism
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.simulation import Simulation

RING_RECORDS = 1 << 16
RECORD_FIELDS = struct.Struct("<dd9fI")
MAGIC = b"HPsimrec"
RING_AT = 64
RECORD_BYTES = RING_AT + RING_RECORDS * RECORD_FIELDS.size


class PlantRecorder:
    """Writer of the ring, into a file or memfd that is given its size."""

    def __init__(self, descriptor: int) -> None:
        os.ftruncate(descriptor, RECORD_BYTES)
        self._map = mmap.mmap(descriptor, RECORD_BYTES)
        self._map[:8] = MAGIC
        self._head = memoryview(self._map)[8:16].cast("Q")
        self._head[0] = 0

    def write(self, now_s: float, simulation: Simulation) -> None:
        """Append one tick, then publish it."""
        count = self._head[0]
        at = RING_AT + (count % RING_RECORDS) * RECORD_FIELDS.size
        RECORD_FIELDS.pack_into(
            self._map,
            at,
            now_s,
            simulation.applied_since_s,
            *simulation.commanded_n,
            *simulation.applied_n,
            *simulation.position_m,
            simulation.refused,
        )
        self._head[0] = count + 1


def device_parser(program: str) -> argparse.ArgumentParser:
    """Return the options of every simulated device; it may get more."""
    parser = argparse.ArgumentParser(prog=program)
    parser.add_argument("--line", type=int, required=True, help="descriptor")
    parser.add_argument("--control", type=int, help="descriptor, for faults only")
    parser.add_argument("--record", type=int, help="descriptor of a file or memfd")
    parser.add_argument("--hand", choices=HANDS, default="relaxed")
    parser.add_argument(
        "--grip-mass-kg", type=float, help="mass of the free grip, sideways"
    )
    parser.add_argument("--hold-s", type=float, default=math.inf)
    parser.add_argument("--delay-s", type=float, default=0.0)
    return parser


def simulation_of(options: argparse.Namespace) -> Simulation:
    """Return the grip and the hand that the options say."""
    mechanism = Mechanism()
    if options.grip_mass_kg is not None:
        mechanism = mechanism.with_lateral_mass(options.grip_mass_kg)
    return Simulation(
        HANDS[options.hand],
        mechanism=mechanism,
        electronics=Electronics(options.hold_s, options.delay_s),
    )
