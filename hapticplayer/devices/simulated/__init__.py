"""A Falcon that is not there, for everyone who has none.

`Simulation` is the physics in virtual time, `SimulatedFalcon` the device made of it
in the caller's process, `RemoteFalcon` the same device in a process of its own
(`python -m hapticplayer.devices.simulated`). Reading its record needs numpy, which
those that only hold the device do not load.
"""

from typing import TYPE_CHECKING

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
from hapticplayer.devices.simulated.remote import Controls, RemoteFalcon, silence
from hapticplayer.devices.simulated.simulation import Simulation

if TYPE_CHECKING:
    from hapticplayer.devices.simulated.record_reader import RECORD, read_record

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


def __getattr__(name: str) -> object:
    """Load the reader of records when one of its names is used."""
    if name not in {"RECORD", "read_record"}:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from hapticplayer.devices.simulated import record_reader

    return getattr(record_reader, name)
