"""Messages of Haply's Inverse Service, JSON 3.x, as texts.

Source: docs.haply.co/inverseSDK 3.5. The service's first message is a full inventory;
afterwards it answers each message with one state, and says nothing by itself. Its frame
is x right, y forward, z up; ours, D, is x right, y up, z towards the user. A force goes
under "vector" from version 3.5 on, before it under "values".
"""

import json
import re
from typing import Annotated, Any, NamedTuple

import msgspec
from msgspec import Meta, Struct

from hapticplayer.errors import DeviceError, Message, message_of
from hapticplayer.model.device import Vector
from hapticplayer.structures import message_in, understood

ZERO: Vector = (0.0, 0.0, 0.0)
FIELDS = ("vector", "values")
PRESET = "arm_front_centered"
"""Puts the origin in the middle of the reach."""
_Metres = Annotated[float, Meta(ge=-0.999, le=0.999)]


class _Place(Struct):
    x: _Metres
    y: _Metres
    z: _Metres


class _State(Struct):
    cursor_position: _Place


class _Status(Struct):
    calibrated: bool
    ready: bool = True
    error: int | None = None


class _Inverse3(Struct):
    device_id: Annotated[str, Meta(min_length=1, max_length=64)]
    state: _State
    status: _Status


class _GripButtons(Struct):
    a: bool = False
    b: bool = False
    c: bool = False


class _GripState(Struct):
    buttons: _GripButtons


class _Grip(Struct):
    state: _GripState


class _Answer(Struct):
    """What is read of a message; the rest may be anything."""

    inverse3: list[_Inverse3]
    wireless_verse_grip: list[_Grip] | None = None
    version: str | None = None


_DECODER = msgspec.json.Decoder(_Answer)


class Inverse3State(NamedTuple):
    """What one message of the service says.

    Attributes:
        device: its identifier.
        devices: how many the message tells of.
        error: that the device reports, 0 for none.
        position_m: of the grip, frame D.
        is_ready: whether it is calibrated and ready.
        buttons: of the wireless grip, as a mask: a, b, c.
        field: name of the vector in a command, by the service's version; "" unknown.
    """

    device: str
    devices: int
    error: int
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


def state_of(text: str | bytes, name: str = "") -> Inverse3State | None:
    """The state of the device of that name, or the first; None where there is none."""
    try:
        answer = _DECODER.decode(text)
    except (msgspec.MsgspecError, RecursionError, UnicodeError):
        return None
    named = (one for one in answer.inverse3 if name in {"", one.device_id})
    device = next(named, None)
    if device is None:
        return None
    place, status = device.state.cursor_position, device.status
    return Inverse3State(
        device.device_id,
        len(answer.inverse3),
        status.error or 0,
        (place.x, place.z, -place.y),
        status.calibrated and status.ready,
        _pressed(answer.wireless_verse_grip),
        _field(answer.version),
    )


def refusal(text: str | bytes, where: str) -> Message | None:
    """Why a message makes no sense, None if it does."""
    try:
        understood(message_in(text, where), _Answer, where)
    except DeviceError as problem:
        return message_of(problem)
    return None


def _pressed(grips: list[_Grip] | None) -> int:
    """The buttons of all wireless grips; there may be none."""
    mask = 0
    for grip in grips or ():
        one = grip.state.buttons
        mask |= one.a | one.b << 1 | one.c << 2
    return mask


def _field(version: str | None) -> str:
    """The name of the vector in commands to a service of this version."""
    found = re.match(r"(\d{1,4})\.(\d{1,4})", version or "")
    if found is None:
        return ""
    return FIELDS[0] if (int(found[1]), int(found[2])) >= (3, 5) else FIELDS[1]
