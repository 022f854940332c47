"""Entry: `python -m hapticplayer.devices.falcon.simulated_usb`."""

import argparse
import gc
import math
import os
import signal
import socket
import sys
import threading

from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.simulated_usb.board import Board, Stage
from hapticplayer.devices.falcon.simulated_usb.chip import Chip
from hapticplayer.devices.falcon.simulated_usb.mechanics import (
    Homing,
    RecordedMechanics,
    SimulatedMechanics,
)
from hapticplayer.devices.falcon.simulated_usb.server import Server, serve_acts
from hapticplayer.devices.simulated.parameters import HANDS, Electronics, Mechanism
from hapticplayer.devices.simulated.record import Recorder
from hapticplayer.devices.simulated.simulation import Simulation


def main(argv: list[str] | None = None) -> int:
    """Be a Falcon on USB until all others have closed their end of the line."""
    parser = argparse.ArgumentParser(prog="hapticplayer.devices.falcon.simulated_usb")
    parser.add_argument("--line", type=int, required=True, help="descriptor")
    parser.add_argument("--control", type=int, help="descriptor, for faults only")
    parser.add_argument("--record", type=int, help="descriptor of a file or memfd")
    parser.add_argument("--hand", choices=HANDS, default="relaxed")
    parser.add_argument("--grip-mass-kg", type=float, help="of the free grip, sideways")
    parser.add_argument("--hold-s", type=float, default=math.inf)
    parser.add_argument("--delay-s", type=float, default=0.0)
    parser.add_argument("--running", action="store_true", help="with its firmware")
    parser.add_argument("--unhomed", action="store_true", help="its owner will home it")
    options = parser.parse_args(argv)

    # the device does not go because somebody wants the player to go
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    mechanism = Mechanism()
    if options.grip_mass_kg is not None:
        mechanism = mechanism.with_lateral_mass(options.grip_mass_kg)
    simulation = Simulation(
        HANDS[options.hand],
        mechanism=mechanism,
        electronics=Electronics(options.hold_s, options.delay_s),
    )
    mechanics = SimulatedMechanics(simulation)
    if options.record is not None:
        mechanics = RecordedMechanics(simulation, Recorder(options.record))
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
    Server(chip, socket.socket(fileno=options.line)).run()
    os._exit(0)  # not after threads that wait for somebody who has left


if __name__ == "__main__":
    sys.exit(main())
