"""Entry of the device's process: `python -m hapticplayer.devices.simulated`."""

import argparse
import gc
import math
import signal
import socket
import sys

from hapticplayer.clock import SystemClock
from hapticplayer.devices.simulated.parameters import HANDS, Electronics, Mechanism
from hapticplayer.devices.simulated.record import Recorder
from hapticplayer.devices.simulated.server import Server
from hapticplayer.devices.simulated.simulation import Simulation


def main(argv: list[str] | None = None) -> int:
    """Serve one end of a SOCK_SEQPACKET pair until all others have closed theirs."""
    parser = argparse.ArgumentParser(prog="hapticplayer.devices.simulated")
    parser.add_argument("--line", type=int, required=True, help="descriptor")
    parser.add_argument("--control", type=int, help="descriptor, for faults only")
    parser.add_argument("--record", type=int, help="descriptor of a file or memfd")
    parser.add_argument("--hand", choices=HANDS, default="relaxed")
    parser.add_argument("--grip-mass-kg", type=float, help="of the free grip, sideways")
    parser.add_argument("--hold-s", type=float, default=math.inf)
    parser.add_argument("--delay-s", type=float, default=0.0)
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
    server = Server(
        SystemClock(),
        socket.socket(fileno=options.line),
        simulation,
        None if options.record is None else Recorder(options.record),
        None if options.control is None else socket.socket(fileno=options.control),
    )
    gc.freeze()
    gc.disable()  # no cycles are made here; a collection costs milliseconds
    server.run()
    return 0


if __name__ == "__main__":
    sys.exit(main())
