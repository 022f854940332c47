"""What the Inverse Service does with each message; no socket, no clock, no chance.

One state for each message, and the inventory first. A force is applied once and
forgotten: without another within a hold time the device idles (how long the real one
waits is not known). The grip is the simulated Falcon's, 2.5 times as wide.
"""

import json
from dataclasses import replace
from typing import Any

from hapticplayer.devices.dynamics import RELAXED, Hand, Mechanism
from hapticplayer.model.device import Vector
from hapticplayer.simulation.falcon.parameters import Electronics, PlantGeometry
from hapticplayer.simulation.falcon.simulation import Simulation

WIDER = 2.5
DEVICE = "0423"
_WORKSPACE_M = 0.10
_LENGTHS = ("thigh_m", "shin_m", "shin_ends_m", "radial_m", "sideways_m", "centre_z_m")
NONSENSE = '{"inverse3":[{"device_id":"0423","state":{"cursor_position":{"x":nul'


def simulation_of(
    hand: Hand | None = RELAXED, electronics: Electronics | None = None
) -> Simulation:
    """Return the grip in a hand: as heavy, 2.5 times as wide."""
    plain = PlantGeometry()
    geometry = replace(
        plain, **{name: WIDER * getattr(plain, name) for name in _LENGTHS}
    )
    small = Mechanism()
    mechanism = replace(
        small,
        joint_inertia_kg_m2=WIDER**2 * small.joint_inertia_kg_m2,
        viscous_nm_s=WIDER**2 * small.viscous_nm_s,
        coulomb_nm=WIDER * small.coulomb_nm,
        stop_radius_m=_WORKSPACE_M,
    )
    return Simulation(
        hand, mechanism=mechanism, electronics=electronics, geometry=geometry
    )


class Service:
    """Answers messages.

    Attributes:
        version: of the service; before 3.5 a force goes under "values".
        corrupt: answers still to come that make no sense.
        frozen: the state that is repeated for ever, as a service that hangs inside.
    """

    def __init__(self, simulation: Simulation, version: str = "3.5.0") -> None:
        self.simulation, self.version = simulation, version
        self.corrupt = 0
        self.frozen: str | None = None

    def inventory(self, now_s: float) -> str:
        """Return the first message of a connection."""
        device = self._device(now_s)
        device["config"] = {"type": "inverse3", "handedness": "right"}
        grip = {"device_id": "61576", "state": self._grip()}
        return json.dumps(
            {
                "session_id": 1,
                "version": self.version,
                "inverse3": [device],
                "wireless_verse_grip": [grip],
            }
        )

    def answer(self, text: str | bytes, now_s: float) -> str:
        """Execute a message and return the state."""
        self._execute(text, now_s)
        if self.corrupt > 0:
            self.corrupt -= 1
            return NONSENSE
        if self.frozen is not None:
            return self.frozen
        state = {
            "inverse3": [self._device(now_s)],
            "wireless_verse_grip": [{"device_id": "61576", "state": self._grip()}],
        }
        return json.dumps(state)

    def _execute(self, text: str | bytes, now_s: float) -> None:
        try:
            commands = json.loads(text)["inverse3"][0].get("commands", {})
            field = "vector" if self.version >= "3.5" else "values"
            force = commands["set_cursor_force"][field] if commands else None
        except (AttributeError, KeyError, IndexError, TypeError, ValueError):
            self.simulation.refused += 1
            return
        if force is not None:
            force_n = (float(force["x"]), float(force["z"]), -float(force["y"]))
            self.simulation.command(force_n, now_s)

    def _device(self, now_s: float) -> dict[str, Any]:
        simulation = self.simulation
        simulation.advance(now_s)
        state = {
            "cursor_position": _theirs(simulation.position_m),
            "cursor_velocity": _theirs(simulation.velocity_mps),
            "current_cursor_force": _theirs(simulation.applied_n),
        }
        is_ready = simulation.is_homed
        status = {"calibrated": is_ready, "ready": is_ready, "power_supply": True}
        return {"device_id": DEVICE, "state": state, "status": status}

    def _grip(self) -> dict[str, Any]:
        pressed = self.simulation.buttons
        buttons = {name: bool(pressed >> bit & 1) for bit, name in enumerate("abc")}
        return {"buttons": buttons}


def _theirs(vector: Vector) -> dict[str, float]:
    """Return a vector of frame D in the service's: x right, y forward, z up."""
    x, y, z = vector
    return {"x": x, "y": -z, "z": y}
