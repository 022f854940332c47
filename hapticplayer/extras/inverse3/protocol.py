"""Messages of Haply's Inverse Service, JSON 3.x, as texts.

Source: docs.haply.co/inverseSDK 3.5. The service's first message is a full inventory;
afterwards it answers each message with one state, and says nothing by itself. Its frame
is x right, y forward, z up; ours, D, is x right, y up, z towards the user. A force goes
under "vector" from version 3.5 on, before it under "values".
"""

import json
import math
from typing import Any, NamedTuple

from hapticplayer.model.device import Vector

ZERO: Vector = (0.0, 0.0, 0.0)
FIELDS = ("vector", "values")
PRESET = "arm_front_centered"
"""Puts the origin in the middle of the reach."""
_BUTTONS = ("a", "b", "c")
_FARTHEST_M = 1.0


class Inverse3State(NamedTuple):
    """What one message of the service says.

    Attributes:
        device: its identifier.
        position_m: of the grip, frame D.
        is_ready: whether it is calibrated and ready.
        buttons: of the wireless grip, as a mask: a, b, c.
        field: name of the vector in a command, by the service's version; "" unknown.
    """

    device: str
    position_m: Vector
    is_ready: bool
    buttons: int
    field: str


def command(device: str, field: str, force_n: Vector) -> str:
    """Return a force, N, frame D, as a message."""
    x, y, z = force_n
    vector = {field: {"x": x, "y": -z, "z": y}}
    return _message(device, {"commands": {"set_cursor_force": vector}})


def configuration(device: str) -> str:
    """Return the message that puts the origin in the middle of the reach."""
    return _message(device, {"configure": {"preset": {"preset": PRESET}}})


def _message(device: str, content: dict[str, Any]) -> str:
    one = {"device_id": device, **content}
    return json.dumps({"inverse3": [one]}, separators=(",", ":"))


def state_of(text: str | bytes) -> Inverse3State | None:
    """Return the first device's state; None for what makes no sense."""
    try:
        message = json.loads(text)
        device = message["inverse3"][0]
        place = device["state"]["cursor_position"]
        position_m = (float(place["x"]), float(place["z"]), -float(place["y"]))
        status = device["status"]
        ready = bool(status["calibrated"]) and bool(status.get("ready", True))
        pressed = _pressed(message.get("wireless_verse_grip"))
        field = _field(message.get("version"))
        name = str(device["device_id"])
    except (
        AttributeError,
        KeyError,
        IndexError,
        OverflowError,
        TypeError,
        ValueError,
        RecursionError,
    ):
        return None
    if not math.hypot(*position_m) < _FARTHEST_M:
        return None
    return Inverse3State(name, position_m, ready, pressed, field)


def _pressed(grips: Any) -> int:
    """Return the buttons of all wireless grips; there may be none."""
    mask = 0
    for grip in grips or ():
        buttons = grip["state"]["buttons"]
        for bit, name in enumerate(_BUTTONS):
            mask |= bool(buttons.get(name)) << bit
    return mask


def _field(version: Any) -> str:
    """Return the name of the vector in commands to a service of this version."""
    if not isinstance(version, str):
        return ""
    major, minor = (int(part) for part in version.split(".")[:2])
    return FIELDS[0] if (major, minor) >= (3, 5) else FIELDS[1]
