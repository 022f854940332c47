"""A Falcon that is not there, for everyone who has none.

`Simulation` is the physics in virtual time, `SimulatedFalcon` the device made of it
in the caller's process, `RemoteFalcon` the same device in a process of its own
(`python -m hapticplayer.devices.simulated`). Each module is loaded when its first name
is used: who only holds the device has no use for its physics, and reading its record
needs numpy.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.devices.simulated.capabilities import FALCON
    from hapticplayer.devices.simulated.device import SimulatedFalcon
    from hapticplayer.devices.simulated.parameters import (
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
    from hapticplayer.devices.simulated.record_reader import RECORD, read_record
    from hapticplayer.devices.simulated.remote import Controls, RemoteFalcon, silence
    from hapticplayer.devices.simulated.simulation import Simulation

_HOMES = {
    "FALCON": "capabilities",
    "SimulatedFalcon": "device",
    "RECORD": "record_reader",
    "read_record": "record_reader",
    "Controls": "remote",
    "RemoteFalcon": "remote",
    "silence": "remote",
    "Simulation": "simulation",
}
_PARAMETERS = "parameters"

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
    """Load the module of a public name at its first use."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = _HOMES.get(name, _PARAMETERS)
    found: object = getattr(importlib.import_module(f"{__name__}.{home}"), name)
    globals()[name] = found
    return found
