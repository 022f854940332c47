"""Peaks of each channel as a level meter shows them: up at once, down slowly."""

import math

from hapticplayer.model.device import ChannelLevel

FALL_DB_PER_S = 20.0 / 1.7
"""Return of a peak meter, IEC 60268-10, type I: 20 dB in 1.7 s."""
LIMITED_S = 1.0
"""So long a channel is said to have been limited."""
SILENT = 1e-4
"""-80 dB: what is quieter is nothing."""


class LevelMeter:
    """Peaks by channel; written by the stream's thread, read by the loop's.

    Each channel has one value that is replaced as a whole, so neither waits.
    """

    def __init__(self, channels: tuple[int, ...]) -> None:
        self._held = dict.fromkeys(channels, (0.0, -math.inf, -math.inf))

    def note(self, channel: int, peak: float, at_s: float, *, is_limited: bool) -> None:
        """Take the largest sample (0 to 1) of a block that sounds at `at_s`.

        `is_limited` is whether the limiter bent any sample of it.
        """
        held, held_s, limited_s = self._held[channel]
        if is_limited:
            limited_s = at_s
        if peak >= _fallen(held, at_s - held_s):
            held, held_s = peak, at_s
        self._held[channel] = held, held_s, limited_s

    def levels(self, now_s: float) -> tuple[ChannelLevel, ...]:
        """The levels now, in the order of the channels' settings."""
        return tuple(
            ChannelLevel(channel, _fallen(held, now_s - held_s), now_s < end_s)
            for channel, (held, held_s, limited_s) in self._held.items()
            for end_s in (limited_s + LIMITED_S,)
        )


def _fallen(peak: float, elapsed_s: float) -> float:
    """Return a peak after it has fallen for a while."""
    if elapsed_s <= 0.0:
        return peak
    left = peak * 10.0 ** (-FALL_DB_PER_S * min(elapsed_s, 60.0) / 20.0)
    return left if left > SILENT else 0.0
