"""Entry: `python -m hapticplayer.extras.faults.usb`."""

import gc
import os
import socket
import sys
import threading

from hapticplayer.clock import SystemClock
from hapticplayer.extras.faults.usb.board import Board, Stage
from hapticplayer.extras.faults.usb.chip import Chip
from hapticplayer.extras.faults.usb.mechanics import (
    Homing,
    RecordedMechanics,
    SimulatedMechanics,
)
from hapticplayer.extras.faults.usb.server import UsbServer, serve_acts
from hapticplayer.haptics.lifeline import outlive_the_player
from hapticplayer.simulation.falcon.process import (
    PlantRecorder,
    device_parser,
    simulation_of,
)


def main(argv: list[str] | None = None) -> int:
    """Be a Falcon on USB until all others have closed their end of the line."""
    parser = device_parser("hapticplayer.extras.faults.usb")
    parser.add_argument("--running", action="store_true", help="with its firmware")
    parser.add_argument("--unhomed", action="store_true", help="its owner will home it")
    options = parser.parse_args(argv)

    outlive_the_player()
    simulation = simulation_of(options)
    mechanics = SimulatedMechanics(simulation)
    if options.record is not None:
        mechanics = RecordedMechanics(simulation, PlantRecorder(options.record))
    mechanics.homing = Homing() if options.unhomed else None
    clock = SystemClock()
    board = Board(mechanics, Stage.RUNNING if options.running else Stage.DARK)
    chip = Chip(board, clock)
    if options.control is not None:
        end = socket.socket(fileno=options.control)
        acts = (end, chip, board, simulation, clock)
        threading.Thread(target=serve_acts, args=acts, daemon=True).start()
    gc.freeze()
    gc.disable()  # no cycles are made here; a collection costs milliseconds
    UsbServer(chip, socket.socket(fileno=options.line)).run()
    os._exit(0)  # do not wait for threads whose peer has gone


if __name__ == "__main__":
    sys.exit(main())
