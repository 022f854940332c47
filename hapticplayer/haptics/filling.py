"""The player's side of a force track that is still arriving; see `arriving`."""

import mmap
import threading

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.arriving import (
    ARRIVING,
    HEADER,
    PACKET_SAMPLES,
    RATE_HZ,
    arriving_bytes,
)
from hapticplayer.haptics.track import anonymous_memory
from hapticplayer.model.arrays import Floats


class FillingTrack:
    """Force that one thread fills in, packet by packet, while a loop may read it.

    Attributes:
        force_n: (N, 3) float32, 1 ms apart, zero where nothing has arrived.
        has_arrived: (P,) for each packet of 128 samples.
    """

    def __init__(self, samples: int) -> None:
        self.force_n = np.zeros((samples, 3), np.float32)
        self.has_arrived = np.zeros(-(-samples // PACKET_SAMPLES), np.uint8)
        self._lock = threading.Lock()
        self._gain: Floats = np.ones(3)
        self._shared: mmap.mmap | None = None

    def fill(self, packet: int, force_n: NDArray[np.float32]) -> None:
        """Note the force (128, 3) of a packet, N; all of it is finite."""
        first = packet * PACKET_SAMPLES
        samples = force_n[: len(self.force_n) - first]
        with self._lock:
            self.force_n[first : first + len(samples)] = samples
            self.has_arrived[packet] = 1
            if self._shared is not None:
                self._show(self._shared, packet, first, samples)

    def has(self, media_s: float) -> bool:
        """Whether the force of a time has arrived; none is due outside the track."""
        packet = int(media_s * RATE_HZ) // PACKET_SAMPLES
        return not 0 <= packet < len(self.has_arrived) or bool(self.has_arrived[packet])

    def adapt(self, gain: Floats) -> None:
        """Scale per axis (3,) what the next loop reads; see `rendering.device_gain`."""
        with self._lock:
            self._gain, self._shared = gain, None

    def to_shared_memory(self) -> int:
        """Return the descriptor of memory that is filled from now on, owned by the caller.

        A loop that had it before gets no more.
        """
        size = arriving_bytes(len(self.force_n))
        descriptor = anonymous_memory("hapticplayer-track", size)
        shared = mmap.mmap(descriptor, size)
        shared.write(HEADER.pack(len(self.force_n), len(self.has_arrived), ARRIVING))
        with self._lock:
            self._shared = shared
            for packet in np.flatnonzero(self.has_arrived).tolist():
                first = packet * PACKET_SAMPLES
                samples = self.force_n[first : first + PACKET_SAMPLES]
                self._show(shared, packet, first, samples)
        return descriptor

    def _show(
        self, shared: mmap.mmap, packet: int, first: int, samples: NDArray[np.float32]
    ) -> None:
        """Write a packet, and only then that it is there."""
        at = HEADER.size + 12 * first
        content = (self._gain * samples).astype("<f4").tobytes()
        shared[at : at + len(content)] = content
        shared[HEADER.size + 12 * len(self.force_n) + packet] = 1
