"""What a person chooses about a rig, as the text after `rig:`.

`FORMAT[,HOST:PORT][,NAME=VALUE]...`, such as `outsim,127.0.0.1:4123,rate=200,invert=sway`.
"""

from dataclasses import dataclass, replace

from hapticplayer.devices.options import (
    LATENCY_MS,
    DeviceOptions,
    Fields,
    Parse,
    fields_of,
    host_and_port,
    milliseconds,
    one_of,
)
from hapticplayer.errors import DeviceError
from hapticplayer.extras.rigs.extension import RIG
from hapticplayer.extras.rigs.packets import FORMATS, RigFormat
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.ranges import Range
from hapticplayer.model.rig import NEUTRAL, RigMotion

LOOPBACK = "127.0.0.1"
RATE_HZ = Range(50, 500, "Hz")
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


@dataclass(frozen=True, slots=True)
class RigSettings(DeviceOptions):
    """Where packets go, and how.

    Attributes:
        format: of the packets.
        address: HOST:PORT of the receiver; this machine unless a person says otherwise.
        rate_hz: packets per second.
        id: OutSim's ID; 0 leaves it out.
        latency_s: from a packet to the motion of the seat, compensated.
        invert: names of `AXES` with the other sign; vendors differ.
    """

    capabilities: DeviceCapabilities = RIG
    format: RigFormat = FORMATS["outsim"]
    rate_hz: float = RIG.rate_hz
    id: int = 0
    invert: frozenset[str] = frozenset()

    @property
    def sole_use(self) -> str:
        """Packets of two outputs would alternate there."""
        return f"{self.format.name} to {self.address}"

    def signs(self) -> tuple[float, ...]:
        """1 or -1 for each number of a `RigMotion`."""
        turned = {name for axis in self.invert for name in AXES[axis]}
        names = RigMotion._fields
        return tuple(-1.0 if name in turned else 1.0 for name in names)


def rig_settings(text: str) -> RigSettings:
    """The settings in a text; "" is OutSim to this machine. Raises DeviceError."""
    settings = RigSettings(**fields_of("rig", text, _place, _OPTIONS))
    without = replace(settings, id=0)
    if settings.id and _packet(settings) == _packet(without):
        raise DeviceError(
            "rig option id={id} has no effect: packets of {format} have no ID; leave it "
            "out",
            id=settings.id,
            format=settings.format.name,
        )
    address = settings.address or f"{LOOPBACK}:{settings.format.port}"
    record = replace(RIG, rate_hz=settings.rate_hz)
    return replace(settings, address=address, capabilities=record)


def _packet(settings: RigSettings) -> bytes:
    return settings.format.encode(NEUTRAL, 0.0, settings)


def _place(part: str) -> Fields:
    if ":" not in part:
        return {"format": FORMATS[one_of(part, (*FORMATS, "HOST:PORT"))]}
    host_and_port(part)
    return {"address": part}


def _axes(_name: str, value: str) -> frozenset[str]:
    return frozenset(one_of(axis, AXES) for axis in value.split("+"))


_OPTIONS: dict[str, tuple[str, Parse]] = {
    "rate": ("rate_hz", RATE_HZ.parse),
    "id": ("id", IDENTITY.parse),
    "latency_ms": ("latency_s", milliseconds(LATENCY_MS)),
    "invert": ("invert", _axes),
}
