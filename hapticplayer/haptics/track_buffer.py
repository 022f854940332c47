"""The player's side of a force track that is streamed; see `streamed_track`."""

import mmap
import threading

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.streamed_track import (
    HEADER,
    PACKET_SAMPLES,
    RATE_HZ,
    STREAMED,
    streamed_track_bytes,
)
from hapticplayer.haptics.track import anonymous_memory
from hapticplayer.model.arrays import Floats


class TrackBuffer:
    """Force that one thread writes, packet by packet, while loops may read it.

    Attributes:
        force_n: (N, 3) float32, 1 ms apart, zero where nothing has arrived.
        has_arrived: (P,) for each packet of 128 samples.
    """

    def __init__(self, samples: int) -> None:
        self.force_n = np.zeros((samples, 3), np.float32)
        self.has_arrived = np.zeros(-(-samples // PACKET_SAMPLES), np.uint8)
        self._lock = threading.Lock()
        self._shown: list[DeviceTrack] = []

    def fill(self, packet: int, force_n: NDArray[np.float32]) -> None:
        """Note the force (128, 3) of a packet, N; all of it is finite."""
        first = packet * PACKET_SAMPLES
        samples = force_n[: len(self.force_n) - first]
        with self._lock:
            self.force_n[first : first + len(samples)] = samples
            self.has_arrived[packet] = 1
            for shown in self._shown:
                shown.write(packet)

    def has(self, media_s: float) -> bool:
        """Whether the force of a time has arrived; none is due outside the track."""
        packet = int(media_s * RATE_HZ) // PACKET_SAMPLES
        return not 0 <= packet < len(self.has_arrived) or bool(self.has_arrived[packet])

    def begin(self, shown: "DeviceTrack") -> None:
        """Let a loop have what has arrived, and what will."""
        with self._lock:
            for packet in np.flatnonzero(self.has_arrived).tolist():
                shown.write(packet)
            self._shown.append(shown)

    def end(self, shown: "DeviceTrack") -> None:
        """Let a loop have no more."""
        with self._lock:
            if shown in self._shown:
                self._shown.remove(shown)


class DeviceTrack:
    """A streamed track, as the loop of one device reads it.

    Args:
        whole: the buffer.
        gain: (3,) per axis, see `rendering.device_gain`.
    """

    def __init__(self, whole: TrackBuffer, gain: Floats) -> None:
        self._whole, self._gain = whole, gain.astype(np.float32)
        self._memory: mmap.mmap | None = None

    def to_shared_memory(self) -> int:
        """Return the descriptor of memory that is written until `close`; the caller owns it."""
        whole = self._whole
        samples, packets = len(whole.force_n), len(whole.has_arrived)
        size = streamed_track_bytes(samples)
        descriptor = anonymous_memory("hapticplayer-track", size)
        self._memory = mmap.mmap(descriptor, size)
        self._memory.write(HEADER.pack(samples, packets, STREAMED))
        whole.begin(self)
        return descriptor

    def write(self, packet: int) -> None:
        """Write a packet, and only then that it is there."""
        assert self._memory is not None
        whole, first = self._whole, packet * PACKET_SAMPLES
        samples = whole.force_n[first : first + PACKET_SAMPLES]
        content = (self._gain * samples).astype("<f4").tobytes()
        at = HEADER.size + 12 * first
        self._memory[at : at + len(content)] = content
        self._memory[HEADER.size + 12 * len(whole.force_n) + packet] = 1

    def close(self) -> None:
        """Stop writing to it."""
        self._whole.end(self)
