"""How late picture, sound and force reach a person, beyond what the machine knows of.

A television that works on its picture, headphones without a wire and a device on a
slow link all come late, and no interface tells by how much. A person measures it once
(`app.player.latency_page`); whatever comes later than the others is begun earlier.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from hapticplayer.errors import UsageError

MOST_S = 1.0
LARGE_S = 0.200
"""A sound output that reports more than this is no cable: 120 ms are our own buffer, and
a sound server adds 20 ms (141 ms were measured), headphones without a wire 100 to 250."""

_WIRELESS = (
    *("bluetooth", "bluez", "a2dp", "airpods", "hands-free", "handsfree"),
    *("wireless", "airplay", "chromecast"),
)


@dataclass(frozen=True, slots=True)
class Latency:
    """From the machine to the person, s; each from 0 to `MOST_S`.

    Attributes:
        display_s: from a painted picture to the light.
        sound_s: from the time that the sound output states to the ear.
        device_s: from a command on the wire to the hand.

    Raises:
        UsageError: when one of them is out of range.
    """

    display_s: float = 0.0
    sound_s: float = 0.0
    device_s: float = 0.0

    def __post_init__(self) -> None:
        for value in (self.display_s, self.sound_s, self.device_s):
            if not (math.isfinite(value) and 0.0 <= value <= MOST_S):
                raise UsageError(
                    "a latency of {value:g} s is not between 0 and 1 s", value=value
                )

    @property
    def lead_s(self) -> float:
        """How much earlier than the clip the first of picture and force begins."""
        return max(self.display_s, self.device_s)


@dataclass(frozen=True, slots=True)
class Latencies:
    """What was measured on this machine.

    Attributes:
        display_s: of the screen that the pictures are on.
        sound_s: by the name of the sound output.
        device_s: by the engine's name of the haptic device.
    """

    display_s: float = 0.0
    sound_s: Mapping[str, float] = field(default_factory=dict)
    device_s: Mapping[str, float] = field(default_factory=dict)

    def of(self, sound: str, device: str) -> Latency:
        """Return those of the outputs that are in use; 0 for what nobody measured."""
        return Latency(
            self.display_s, self.sound_s.get(sound, 0.0), self.device_s.get(device, 0.0)
        )


def is_wireless(output: str) -> bool:
    """Whether the name of a sound output says that it has no wire."""
    return any(word in output.lower() for word in _WIRELESS)
