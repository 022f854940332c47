"""Entry of the device's process: `python -m hapticplayer.simulation.falcon`."""

import gc
import socket
import sys

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.lifeline import outlive_the_player
from hapticplayer.simulation.falcon.process import (
    PlantRecorder,
    device_parser,
    simulation_of,
)
from hapticplayer.simulation.falcon.server import Server


def main(argv: list[str] | None = None) -> int:
    """Serve one end of a SOCK_SEQPACKET pair until all others have closed theirs."""
    options = device_parser("hapticplayer.simulation.falcon").parse_args(argv)
    outlive_the_player()
    simulation = simulation_of(options)
    server = Server(
        SystemClock(),
        socket.socket(fileno=options.line),
        simulation,
        None if options.record is None else PlantRecorder(options.record),
        None if options.control is None else socket.socket(fileno=options.control),
    )
    gc.freeze()
    gc.disable()  # no cycles are made here; a collection costs milliseconds
    server.run()
    return 0


if __name__ == "__main__":
    sys.exit(main())
