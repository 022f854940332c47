"""A Falcon that is not there, for everyone who has none.

`Simulation` is the physics in virtual time, `SimulatedFalcon` the device made of it
in the caller's process, `RemoteFalcon` the same device in a process of its own
(`python -m hapticplayer.devices.simulated`).
"""

from hapticplayer.devices.simulated.device import SimulatedFalcon
from hapticplayer.devices.simulated.parameters import (
    FALCON,
    FIRM,
    HANDS,
    LIGHT,
    NORMAL,
    RELAXED,
    TENSE,
    Electronics,
    Geometry,
    Hand,
    Mechanism,
)
from hapticplayer.devices.simulated.record import RECORD, read_record
from hapticplayer.devices.simulated.remote import Controls, RemoteFalcon, silence
from hapticplayer.devices.simulated.simulation import Simulation

__all__ = [
    "FALCON",
    "FIRM",
    "HANDS",
    "LIGHT",
    "NORMAL",
    "RECORD",
    "RELAXED",
    "TENSE",
    "Controls",
    "Electronics",
    "Geometry",
    "Hand",
    "Mechanism",
    "RemoteFalcon",
    "SimulatedFalcon",
    "Simulation",
    "read_record",
    "silence",
]
