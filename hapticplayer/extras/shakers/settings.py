"""What a person chooses about a shaker, as the text after `shaker:`.

`[CARD][,NAME=VALUE]...`, such as `pulse,channels=3+4,band=15-80,gain=0.5`.
"""

from dataclasses import dataclass, replace

from hapticplayer.devices.options import (
    DeviceOptions,
    Fields,
    Parse,
    fields_of,
    milliseconds,
    one_of,
)
from hapticplayer.errors import DeviceError
from hapticplayer.extras.shakers.extension import SHAKER
from hapticplayer.model.device import MOST_CHANNELS, DeviceCapabilities
from hapticplayer.model.ranges import Range

CHANNEL = Range(1, MOST_CHANNELS, is_whole=True)
HERTZ = Range(5, 400, "Hz")
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
class ShakerSettings(DeviceOptions):
    """Which card and channels, and how strongly.

    Attributes:
        address: name of a sound output; "" for the default one.
        channels: counted from 1; all others are silent.
        bands: one for each channel.
        axis: 0, 1, 2 for x, y, z of frame D: the part that is played directly.
        latency_s: from a force to its sound: a promise that the driver keeps, and the
            player compensates.
    """

    capabilities: DeviceCapabilities = SHAKER
    latency_s: float = SHAKER.latency_s
    channels: tuple[int, ...] = (1, 2)
    bands: tuple[Band, ...] = (Band(), Band())
    axis: int = 1

    @property
    def width(self) -> int:
        """Channels that the stream has: cards take 2, 4, 6 or 8."""
        return max(2, 2 * ((max(self.channels) + 1) // 2))

    def text(self) -> str:
        """What has these settings when it follows `shaker:`."""
        bands = (
            f"{one.low_hz:g}-{one.high_hz:g}-{one.carrier_hz:g}" for one in self.bands
        )
        return (
            f"{self.address},channels={'+'.join(map(str, self.channels))},"
            f"band={'+'.join(bands)},axis={AXES[self.axis]},gain={self.gain:g},"
            f"latency_ms={1e3 * self.latency_s:g}"
        )

    def alone(self, channel: int) -> str:
        """The name of the device of one of the channels."""
        band = self.bands[self.channels.index(channel)]
        return f"shaker:{replace(self, channels=(channel,), bands=(band,)).text()}"


def shaker_settings(text: str) -> ShakerSettings:
    """The settings in a text; "" is the default card, channels 1 and 2.

    Raises:
        DeviceError: for what is not allowed, with what is.
    """
    fields = fields_of("shaker", text, _card, _OPTIONS)
    channels, bands = fields.get("channels", (1, 2)), fields.get("bands", (Band(),))
    if len(bands) == 1:
        bands *= len(channels)
    if len(bands) != len(channels) or len(set(channels)) != len(channels):
        raise DeviceError(
            "shaker:{text}: {count} channels need one band, or one each, and each "
            "channel once",
            text=text,
            count=len(channels),
        )
    found = ShakerSettings(**{**fields, "bands": bands})
    record = replace(SHAKER, latency_s=found.latency_s)
    return replace(found, capabilities=record)


def _card(part: str) -> Fields:
    return {"address": part}


def _channels(_name: str, text: str) -> tuple[int, ...]:
    return tuple(int(CHANNEL.parse("channel", one)) for one in text.split("+"))


def _bands(_name: str, text: str) -> tuple[Band, ...]:
    return tuple(_band(one) for one in text.split("+"))


def _band(text: str) -> Band:
    numbers = [HERTZ.parse("frequency", one) for one in text.split("-")]
    low_hz, high_hz = numbers[:2]
    carrier_hz = numbers[2] if len(numbers) == 3 else (low_hz * high_hz) ** 0.5
    if len(numbers) > 3 or not low_hz < carrier_hz < high_hz:
        raise ValueError("LOW-HIGH or LOW-HIGH-CARRIER, rising, in Hz")
    return Band(low_hz, high_hz, carrier_hz)


_OPTIONS: dict[str, tuple[str, Parse]] = {
    "channels": ("channels", _channels),
    "band": ("bands", _bands),
    "axis": ("axis", lambda _name, value: AXES.index(one_of(value, AXES))),
    "latency_ms": ("latency_s", milliseconds(LATENCY_MS)),
}
