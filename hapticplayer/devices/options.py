"""What a person chooses with a device: the text after its name and a colon.

Parts are divided by commas, such as `outsim,127.0.0.1:4123,rate=200`: those without a
`=` say which one, where or what kind, the others are named.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import DeviceError, HapticPlayerError, joined
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.ranges import Range

PORT = Range(1, 65535, is_whole=True)
GAIN, LATENCY_MS = Range(0, 4), Range(0, 1000, "ms")
_GAIN = "gain="
Fields = dict[str, Any]
Parse = Callable[[str, str], Any]
"""Called with the name and the value; raises ValueError or HapticPlayerError."""


@dataclass(frozen=True, slots=True)
class DeviceOptions:
    """What was chosen; devices with more than a place have a class of their own.

    Attributes:
        capabilities: of the device with these options.
        address: which one, or where it is, for people.
        latency_s: from a command to what is felt, 0 for what is typical.
        gain: of everything that it plays; the player multiplies, not the driver.
        sole_use: what two outputs cannot use at once; "" for nothing.
    """

    capabilities: DeviceCapabilities
    address: str = ""
    latency_s: float = 0.0
    gain: float = 1.0

    @property
    def sole_use(self) -> str:
        """See above."""
        return ""


def fields_of(
    device: str,
    text: str,
    place: Callable[[str], Fields],
    named: Mapping[str, tuple[str, Parse]],
) -> Fields:
    """The fields that a text sets.

    Args:
        device: its name, for messages.
        text: what follows it and a colon.
        place: returns the fields of a part without a name.
        named: field and parser of each option by its name.
    """
    found: Fields = {}
    for part in filter(None, text.split(",")):
        name, equals, value = part.partition("=")
        try:
            if not equals:
                more = place(part)
            else:
                field, parse = named[one_of(name, (*named, "gain"))]
                more = {field: parse(name, value)}
            if more.keys() & found.keys():
                raise DeviceError("say it once")
        except (HapticPlayerError, ValueError) as problem:
            raise DeviceError(
                "{device} option {part!r}: {reason}",
                device=device,
                part=part,
                reason=problem,
            ) from problem
        found |= more
    return found


def divided(name: str) -> tuple[str, Fields]:
    """What follows a name and a colon: for the device's own parser, and for all devices."""
    kind, _, text = name.partition(":")
    parts = text.split(",")
    shared = [part for part in parts if part.startswith(_GAIN)]
    own = ",".join(part for part in parts if part not in shared)
    parsers = {"gain": ("gain", GAIN.parse)}
    return own, fields_of(kind, ",".join(shared), lambda _part: {}, parsers)


def with_gain(name: str, gain: float = 1.0) -> str:
    """The name of a device with another gain; without one for 1."""
    kind, _, text = name.partition(":")
    parts = [part for part in text.split(",") if not part.startswith(_GAIN)]
    chosen = ",".join(
        parts if gain == 1.0 else [*filter(None, parts), f"{_GAIN}{gain:g}"]
    )
    return f"{kind}:{chosen}" if chosen else kind


def one_of(word: str, known: Iterable[str]) -> str:
    """The word, if it is one of those; raises DeviceError."""
    known = tuple(known)
    if word not in known:
        raise DeviceError(
            "{word!r} is unknown; use {known}", word=word, known=joined(", ", known)
        )
    return word


def milliseconds(allowed: Range) -> Parse:
    """A parser of milliseconds within a range, which returns seconds."""
    return lambda name, value: 1e-3 * allowed.parse(name, value)


def host_and_port(text: str) -> tuple[str, int]:
    """Both parts of HOST:PORT or [HOST]:PORT; raises DeviceError."""
    host, colon, port = text.rpartition(":")
    host = host.removeprefix("[").removesuffix("]")
    if not (colon and host):
        raise DeviceError("{text!r} is not HOST:PORT", text=text)
    return host, int(PORT.parse("port", port))


def service_options(
    text: str, default: str, capabilities: DeviceCapabilities
) -> DeviceOptions:
    """The options of a device whose one option is HOST:PORT; raises DeviceError."""
    fields = fields_of("device", text, _address, {})
    return DeviceOptions(capabilities, **{"address": default, **fields})


def _address(part: str) -> Fields:
    host_and_port(part)
    return {"address": part}
