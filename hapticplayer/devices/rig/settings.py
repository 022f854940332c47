"""What a person chooses about a rig, as the text after `rig:`.

`FORMAT[,HOST:PORT][,NAME=VALUE]...`, such as `outsim,127.0.0.1:4123,rate=200,invert=sway`.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from hapticplayer.devices.addresses import host_and_port
from hapticplayer.devices.rig.packets import FORMATS, RigFormat
from hapticplayer.errors import DeviceError, HapticPlayerError, Message, joined
from hapticplayer.model.ranges import Range
from hapticplayer.model.rig import RigMotion

LOOPBACK = "127.0.0.1"
RATE_HZ = Range(50, 500, "Hz")
GAIN = Range(0, 4)
LATENCY_MS = Range(0, 1000, "ms")
IDENTITY = Range(-(2**31), 2**31 - 1, is_whole=True)

AXES: dict[str, tuple[str, ...]] = {
    "surge": ("front_mps2", "front_mps"),
    "sway": ("right_mps2", "right_mps"),
    "heave": ("up_mps2", "up_mps"),
    "roll": ("roll_rad", "roll_radps", "roll_radps2"),
    "pitch": ("pitch_rad", "pitch_radps", "pitch_radps2"),
    "yaw": ("heading_rad", "yaw_radps", "yaw_radps2"),
}
"""The words of rig software, and what of a `RigMotion` belongs to each."""

_ORDERS = {"right-forward": False, "forward-right": True}


@dataclass(frozen=True, slots=True)
class RigSettings:
    """Where packets go, and how.

    Attributes:
        format: of the packets.
        host: the receiver; this machine unless a person says otherwise.
        port: UDP port of the receiver.
        rate_hz: packets per second.
        id: OutSim's ID; 0 leaves it out.
        gain: multiplies everything that is sent.
        latency_s: from a packet to the motion of the seat, compensated.
        invert: names of `AXES` with the other sign; vendors differ.
        forward_first: of Codemasters' two unit vectors the forward one comes first.
    """

    format: RigFormat = FORMATS["outsim"]
    host: str = LOOPBACK
    port: int = FORMATS["outsim"].port
    rate_hz: float = 200.0
    id: int = 0
    gain: float = 1.0
    latency_s: float = 0.0
    invert: frozenset[str] = frozenset()
    forward_first: bool = False

    def factors(self) -> tuple[float, ...]:
        """Return gain and sign of each number of a `RigMotion`."""
        turned = {name for axis in self.invert for name in AXES[axis]}
        names = RigMotion._fields
        return tuple(-self.gain if name in turned else self.gain for name in names)

    @property
    def address(self) -> str:
        """HOST:PORT for people."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{host}:{self.port}"


@cache
def rig_settings(text: str) -> RigSettings:
    """Return the settings in a text; "" is OutSim to this machine.

    Raises:
        DeviceError: for what is not allowed, with what is.
    """
    name, *parts = text.split(",") if text else ["outsim"]
    if name not in FORMATS:
        raise DeviceError(
            "{name!r} is not a packet format; use {known}",
            name=name,
            known=joined(Message(" or "), FORMATS),
        )
    kind = FORMATS[name]
    settings = RigSettings(kind, port=kind.port)
    try:
        for part in parts:
            settings = _with(settings, part)
    except HapticPlayerError as problem:
        raise DeviceError(
            "rig:{text}: {reason}", text=text, reason=problem
        ) from problem
    return settings


def _with(settings: RigSettings, part: str) -> RigSettings:
    name, is_named, value = part.partition("=")
    return replace(settings, **(_named(name, value) if is_named else _address(part)))


def _address(text: str) -> dict[str, Any]:
    host, port = host_and_port(text)
    return {"host": host, "port": port}


def _named(name: str, value: str) -> dict[str, Any]:
    field, parse = _OPTIONS[_one_of(name, _OPTIONS)]
    return {field: parse(name, value)}


def _seconds(name: str, value: str) -> float:
    return 1e-3 * LATENCY_MS.parse(name, value)


def _axes(_name: str, value: str) -> frozenset[str]:
    return frozenset(_one_of(axis, AXES) for axis in value.split("+"))


def _order(_name: str, value: str) -> bool:
    return _ORDERS[_one_of(value, _ORDERS)]


def _one_of(word: str, known: Any) -> str:
    if word not in known:
        raise DeviceError(
            "{word!r} is unknown; use {known}",
            word=word,
            known=joined(", ", known),
        )
    return word


_OPTIONS: dict[str, tuple[str, Callable[[str, str], Any]]] = {
    "rate": ("rate_hz", RATE_HZ.parse),
    "id": ("id", IDENTITY.parse),
    "gain": ("gain", GAIN.parse),
    "latency_ms": ("latency_s", _seconds),
    "invert": ("invert", _axes),
    "vectors": ("forward_first", _order),
}
