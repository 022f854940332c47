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

from hapticplayer.devices.websocket import reported
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
    ready: bool | None = True
    error: Any = None


class _Inverse3(Struct):
    device_id: Annotated[str, Meta(min_length=1, max_length=64)]
    state: _State
    status: _Status


class _GripButtons(Struct):
    a: bool | None = False
    b: bool | None = False
    c: bool | None = False


class _GripState(Struct):
    buttons: _GripButtons | None = None


class _Grip(Struct):
    state: _GripState | None = None


class _Answer(Struct):
    """What is read of a message; the rest may be anything."""

    inverse3: list[_Inverse3]
    wireless_verse_grip: list[_Grip | None] | None = None
    version: str | None = None


class _Listed(Struct):
    """The same message, each device to be judged by itself."""

    inverse3: list[Any]
    wireless_verse_grip: Any = None
    version: Any = None


_DECODER, _LISTED = msgspec.json.Decoder(_Answer), msgspec.json.Decoder(_Listed)
_UNREADABLE = (msgspec.MsgspecError, RecursionError, UnicodeError)


class Inverse3State(NamedTuple):
    """What one message of the service says.

    Attributes:
        device: its identifier.
        devices: how many the message tells of.
        error: that the device reports, in its words; "" for none.
        position_m: of the grip, frame D.
        is_ready: whether it is calibrated and ready.
        buttons: of the wireless grip, as a mask: a, b, c; None where what it says
            makes no sense.
        field: name of the vector in a command, by the service's version; "" unknown.
    """

    device: str
    devices: int
    error: str
    position_m: Vector
    is_ready: bool
    buttons: int | None
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
        buttons: int | None = _pressed(answer.wireless_verse_grip)
    except _UNREADABLE:
        try:
            answer, buttons = _judged_apart(_LISTED.decode(text), name)
        except _UNREADABLE:
            return None
    named = (one for one in answer.inverse3 if name in {"", one.device_id})
    device = next(named, None)
    if device is None:
        return None
    place, status = device.state.cursor_position, device.status
    return Inverse3State(
        device.device_id,
        len(answer.inverse3),
        reported(status.error),
        (place.x, place.z, -place.y),
        status.calibrated and bool(status.ready),
        buttons,
        _field(answer.version),
    )


def _judged_apart(listed: _Listed, name: str) -> tuple[_Answer, int | None]:
    """A message of which a part makes no sense: another device's, or a grip's."""
    wanted = [
        one
        for one in listed.inverse3
        if one is not None and (not name or _is_named(one, name))
    ]
    devices = msgspec.convert(wanted, list[_Inverse3])
    version = listed.version if isinstance(listed.version, str) else None
    try:
        kind = list[_Grip | None] | None
        grips = msgspec.convert(listed.wireless_verse_grip, kind)
    except msgspec.ValidationError:
        return _Answer(devices, None, version), None
    return _Answer(devices, None, version), _pressed(grips)


def _is_named(one: Any, name: str) -> bool:
    return isinstance(one, dict) and one.get("device_id") == name


def refusal(text: str | bytes, where: str) -> Message | None:
    """Why a message makes no sense, None if it does."""
    try:
        understood(message_in(text, where), _Answer, where)
    except DeviceError as problem:
        return message_of(problem)
    return None


def complaint(text: str | bytes) -> str:
    """The error that a message without a state holds, "" for none."""
    try:
        said = msgspec.json.decode(text)
    except _UNREADABLE:
        return ""
    if not isinstance(said, dict):
        return ""
    return reported(said.get("error")) or reported(said.get("errors"))


def _pressed(grips: list[_Grip | None] | None) -> int:
    """The buttons of all wireless grips; there may be none, or one switched off."""
    mask = 0
    for grip in grips or ():
        if grip and grip.state and (one := grip.state.buttons):
            mask |= bool(one.a) | bool(one.b) << 1 | bool(one.c) << 2
    return mask


def _field(version: str | None) -> str:
    """The name of the vector in commands to a service of this version."""
    found = re.match(r"(\d{1,4})\.(\d{1,4})", version or "")
    if found is None:
        return ""
    return FIELDS[0] if (int(found[1]), int(found[2])) >= (3, 5) else FIELDS[1]
