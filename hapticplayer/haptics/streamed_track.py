"""A force track that is streamed, as the loop reads it.

Its samples are 1 ms apart. It comes in packets of 128 ms, and a byte for each says
whether it is there. Towards one that is not, the force fades to zero, and after it fades
in again, so that neither a gap nor a late packet is ever a step.
"""

import mmap
import struct

from hapticplayer.haptics.limiter import PERIOD_S, ZERO
from hapticplayer.model.device import Vector

RATE_HZ = 1000.0
PACKET_SAMPLES = 128
FADE_S = 0.1
"""Longer than the 20 ms of a stop, shorter than a packet: a whole one is felt between two
that are lost."""

HEADER = struct.Struct("<QQQ")
STREAMED = 2  # third number of the header; a whole track has 0 or 1 there


class StreamedTrack:
    """A track in shared memory that another process writes.

    What it holds cannot be checked beforehand: `step` checks each force.
    """

    def __init__(self, block: mmap.mmap) -> None:
        samples, packets, _ = HEADER.unpack_from(block, 0)
        if not samples or len(block) != streamed_track_bytes(samples):
            raise ValueError("it does not match its shared memory")
        view, force_at = memoryview(block), HEADER.size
        self._force_n = view[force_at : force_at + 12 * samples].cast("f")
        self._is_there = view[force_at + 12 * samples :]
        self._last, self._packets = samples - 1, packets
        self.end_s = self._last / RATE_HZ

    def check(self, _count: int) -> bool:
        """Return True: there is nothing to be checked beforehand."""
        return True

    def force_at(self, media_s: float) -> Vector:
        """Return the planned force, N, frame D; zero where nothing has arrived."""
        place = media_s * RATE_HZ
        if not 0.0 <= place < self._last:
            return ZERO
        row = int(place)
        force, at, u = self._force_n, 3 * row, place - row
        x, y, z = force[at], force[at + 1], force[at + 2]
        return (
            x + u * (force[at + 3] - x),
            y + u * (force[at + 4] - y),
            z + u * (force[at + 5] - z),
        )

    def share(
        self, before: float, media_s: float, rate: float, elapsed_s: float
    ) -> float:
        """Return the share of the force that may be felt now, 0 to 1.

        Args:
            before: the share a tick ago.
            media_s: finite.
            rate: media seconds per second: how soon comes what lies ahead.
            elapsed_s: since the tick before.
        """
        ahead_s = media_s + rate * (FADE_S + 2.0 * PERIOD_S)
        change = max(PERIOD_S, elapsed_s) / FADE_S
        if self._has(media_s) and self._has(ahead_s):
            return min(1.0, before + change)
        return max(0.0, before - change)

    def _has(self, media_s: float) -> bool:
        """Whether the force of a time has arrived; none is due outside the track."""
        packet = int(media_s * RATE_HZ) // PACKET_SAMPLES
        return not 0 <= packet < self._packets or self._is_there[packet] != 0


def streamed_track_bytes(samples: int) -> int:
    """Return the size of the memory for so many samples."""
    return HEADER.size + 12 * samples + -(-samples // PACKET_SAMPLES)
