"""Messages of Intiface, versions 4 and 3 of the Buttplug protocol, as typed structures.

Source: docs.buttplug.io. Every message is a list of objects with one key. What is not
read here may be anything.
"""

import json
from typing import Annotated, Any, NamedTuple

from msgspec import UNSET, Meta, Struct, UnsetType

from hapticplayer.devices.websocket import SHOWN, reported
from hapticplayer.errors import DeviceError, Message, message_of
from hapticplayer.structures import message_in, understood

VIBRATE = "Vibrate"
ANSWERED = {
    "OutputCmd": 1,
    "ScalarCmd": 1,
    "StopCmd": 2,
    "StopAllDevices": 2,
    "Ping": 3,
}
"""The number of each kind of message that is sent while it plays, of others 4: an answer
has that of its message, which tells what has been answered."""
_OTHER = 4
_Number = Annotated[int, Meta(ge=0, le=2**32 - 1)]
_Steps = Annotated[int, Meta(ge=0, le=10**6)]
_Ms = Annotated[float, Meta(ge=0, le=60_000)]
_Version = Annotated[int, Meta(ge=3, le=1000)]


class Motor(NamedTuple):
    """A motor that vibrates: of which device, which of its features, how many steps."""

    device: int
    feature: int
    steps: int


class Toy(NamedTuple):
    """A device that vibrates, and how much time it needs between messages, s."""

    name: str
    motors: tuple[Motor, ...]
    gap_s: float


class ServerInfo(Struct, rename="pascal"):
    """The answer to a greeting."""

    max_ping_time: Annotated[int, Meta(ge=0, le=3_600_000)] = 0
    protocol_version_major: _Version | UnsetType = UNSET
    message_version: _Version | UnsetType = UNSET

    @property
    def version(self) -> int:
        return self.protocol_version_major or self.message_version or 3


class Removed(Struct, rename="pascal"):
    """That a device has left; version 3."""

    device_index: _Number


class _Output(Struct, rename="pascal"):
    value: tuple[_Steps, _Steps]


class _Outputs(Struct, rename="pascal"):
    vibrate: _Output | None = None


class _Feature(Struct, rename="pascal"):
    output: _Outputs | None = None


class _Scalar(Struct, rename="pascal"):
    step_count: _Steps
    actuator_type: str


class _Messages(Struct, rename="pascal"):
    scalar_cmd: list[_Scalar] | None = None


class _Device(Struct, rename="pascal", kw_only=True):
    device_index: _Number
    device_name: str | None = None
    device_message_timing_gap: _Ms | None = None

    def toy(self, motors: list[Motor]) -> Toy:
        usable = tuple(one for one in motors if one.steps)
        gap_ms = self.device_message_timing_gap or 0.0
        return Toy((self.device_name or "")[:SHOWN], usable, 1e-3 * gap_ms)


class _Newer(_Device, rename="pascal", kw_only=True):
    device_features: dict[str, _Feature]

    def found(self) -> Toy:
        return self.toy(
            [
                Motor(self.device_index, int(key), one.output.vibrate.value[1])
                for key, one in self.device_features.items()
                if key.isdecimal() and one.output and one.output.vibrate
            ]
        )


class _Older(_Device, rename="pascal", kw_only=True):
    device_messages: _Messages

    def found(self) -> Toy:
        scalars = enumerate(self.device_messages.scalar_cmd or ())
        return self.toy(
            [
                Motor(self.device_index, index, scalar.step_count)
                for index, scalar in scalars
                if scalar.actuator_type == VIBRATE
            ]
        )


class _NewerList(Struct, rename="pascal"):
    devices: dict[str, Any]


class _OlderList(Struct, rename="pascal"):
    devices: list[Any]


class Toys(NamedTuple):
    """The devices that vibrate, by number, and why another one is left out."""

    found: dict[int, Toy]
    refused: Message | str


def toys_of(listed: Any, version: int, where: str) -> Toys:
    """The toys of a DeviceList.

    Raises:
        DeviceError: for what is no such list, or when none of its devices makes sense.
    """
    kind: type[_Newer | _Older] = _Newer if version >= 4 else _Older
    devices: list[tuple[Any, Any]]
    if version >= 4:
        devices = [*understood(listed, _NewerList, where).devices.items()]
    else:
        devices = [*enumerate(understood(listed, _OlderList, where).devices)]
    found, problems = {}, []
    for key, one in devices:
        try:
            device = understood(one, kind, f"{where}, Devices.{str(key)[:SHOWN]}")
            found[device.device_index] = device.found()
        except DeviceError as problem:
            problems.append(problem)
    if problems and not found:
        raise problems[0]
    toys = {number: toy for number, toy in found.items() if toy.motors}
    return Toys(toys, message_of(problems[0]) if problems else "")


def text_of(*messages: tuple[str, dict[str, Any]]) -> bytes:
    """Messages as they are sent."""
    found = [
        {name: {"Id": ANSWERED.get(name, _OTHER), **content}}
        for name, content in messages
    ]
    return json.dumps(found, separators=(",", ":")).encode()


def messages_in(text: str | bytes, where: str) -> list[tuple[str, dict[str, Any]]]:
    """The messages in a text, each with its content; raises DeviceError."""
    found = understood(message_in(text, where), list[dict[str, dict[str, Any]]], where)
    return [message for one in found for message in one.items()]


def error_text(content: dict[str, Any]) -> str:
    """What an Error says, whatever it holds."""
    return reported(content.get("ErrorMessage")) or "no reason"


def is_list(text: bytes) -> bool:
    """Whether a report is a list of messages."""
    try:
        return bool(messages_in(text, ""))
    except DeviceError:
        return False
