"""A Falcon that answers byte for byte, below the USB library.

`Mechanics` move, `Board` is the processors with boot loader and firmware, `Chip` the
FT232R with its timing, and `SimulatedBus` (in `backend`, which needs pyusb) a bus
for an unmodified pyusb. The driver on top is the one for real Falcons.
"""

from hapticplayer.simulation.usb.board import Board, BoardFaults, Stage
from hapticplayer.simulation.usb.chip import Chip
from hapticplayer.simulation.usb.mechanics import (
    BenchMechanics,
    Mechanics,
    SimulatedMechanics,
)

__all__ = [
    "BenchMechanics",
    "Board",
    "BoardFaults",
    "Chip",
    "Mechanics",
    "SimulatedMechanics",
    "Stage",
]
