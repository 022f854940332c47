"""What a person chooses about a shaker, as the text after `shaker:`.

`[CARD][,NAME=VALUE]...`, such as `pulse,channels=3+4,band=15-80,gain=0.5`.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from hapticplayer.errors import DeviceError, HapticPlayerError, Message, joined
from hapticplayer.model.device import MOST_CHANNELS
from hapticplayer.model.ranges import Range

CHANNEL = Range(1, MOST_CHANNELS, is_whole=True)
HERTZ = Range(5, 400, "Hz")
GAIN = Range(0, 4)
LATENCY_MS = Range(20, 500, "ms")
AXES = "xyz"


@dataclass(frozen=True, slots=True)
class Band:
    """What a shaker gives back: from, to, and its carrier, Hz.

    The carrier is inside the band: what is slower than the band swells it.
    """

    low_hz: float = 15.0
    high_hz: float = 80.0
    carrier_hz: float = 40.0


@dataclass(frozen=True, slots=True)
class ShakerSettings:
    """Which card and channels, and how strongly.

    Attributes:
        card: name of a sound output; "" for the default one.
        channels: counted from 1; all others are silent.
        bands: one for each channel.
        axis: 0, 1, 2 for x, y, z of frame D: the part that is played directly.
        gain: of everything.
        latency_s: from a force to its sound: a promise that the driver keeps, and the
            player compensates.
    """

    card: str = ""
    channels: tuple[int, ...] = (1, 2)
    bands: tuple[Band, ...] = (Band(), Band())
    axis: int = 1
    gain: float = 1.0
    latency_s: float = 0.080

    @property
    def address(self) -> str:
        """For people."""
        return self.card or "default"

    @property
    def width(self) -> int:
        """Channels that the stream has: cards take 2, 4, 6 or 8."""
        return max(2, 2 * ((max(self.channels) + 1) // 2))

    def alone(self, channel: int) -> str:
        """Return the text of one of the channels, as a device's name."""
        band = self.bands[self.channels.index(channel)]
        hertz = f"{band.low_hz:g}-{band.high_hz:g}-{band.carrier_hz:g}"
        return (
            f"shaker:{self.card},channels={channel},band={hertz},"
            f"axis={AXES[self.axis]},gain={self.gain:g},"
            f"latency_ms={1e3 * self.latency_s:g}"
        )


@cache
def shaker_settings(text: str) -> ShakerSettings:
    """Return the settings in a text; "" is the default card, channels 1 and 2.

    Raises:
        DeviceError: for what is not allowed, with what is.
    """
    found: dict[str, Any] = {}
    for part in filter(None, text.split(",")):
        name, is_named, value = part.partition("=")
        if not is_named and not found:
            found["card"] = name
            continue
        if name not in _OPTIONS:
            raise DeviceError(
                "shaker option {part!r} is unknown; use a card, then {known}",
                part=part,
                known=joined(Message(", "), [f"{one}=" for one in _OPTIONS]),
            )
        field, parse = _OPTIONS[name]
        try:
            found[field] = parse(value)
        except (HapticPlayerError, ValueError) as problem:
            raise DeviceError(
                "shaker option {part!r}: {reason}", part=part, reason=problem
            ) from problem
    channels = found.setdefault("channels", (1, 2))
    bands = found.get("bands", (Band(),))
    if len(bands) == 1:
        bands *= len(channels)
    if len(bands) != len(channels) or len(set(channels)) != len(channels):
        raise DeviceError(
            "shaker:{text}: {count} channels need one band, or one each, and each "
            "channel once",
            text=text,
            count=len(channels),
        )
    return replace(ShakerSettings(**found), bands=tuple(bands))


def _channels(text: str) -> tuple[int, ...]:
    return tuple(int(CHANNEL.parse("channel", one)) for one in text.split("+"))


def _bands(text: str) -> tuple[Band, ...]:
    return tuple(_band(one) for one in text.split("+"))


def _band(text: str) -> Band:
    numbers = [HERTZ.parse("frequency", one) for one in text.split("-")]
    low_hz, high_hz = numbers[:2]
    carrier_hz = numbers[2] if len(numbers) == 3 else (low_hz * high_hz) ** 0.5
    if len(numbers) > 3 or not low_hz < carrier_hz < high_hz:
        raise ValueError("LOW-HIGH or LOW-HIGH-CARRIER, rising, in Hz")
    return Band(low_hz, high_hz, carrier_hz)


def _axis(text: str) -> int:
    if len(text) != 1:
        raise ValueError("x, y or z")
    return AXES.index(text)


_OPTIONS: dict[str, tuple[str, Callable[[str], Any]]] = {
    "channels": ("channels", _channels),
    "band": ("bands", _bands),
    "axis": ("axis", _axis),
    "gain": ("gain", lambda text: GAIN.parse("gain", text)),
    "latency_ms": (
        "latency_s",
        lambda text: 1e-3 * LATENCY_MS.parse("latency", text),
    ),
}
