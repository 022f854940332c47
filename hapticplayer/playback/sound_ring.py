"""The player's side of the sound: samples by media time, in shared memory.

A process of its own plays them (see `sound_device`): a window that holds the
interpreter for a while stops the decoder, but neither the sound nor its clock.
"""

import os
import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.linux import anonymous_memory
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.clock import AudioReport
from hapticplayer.playback.sound_memory import CHANNELS, Cue, SoundBlock, block_bytes

RATE_HZ = 48_000
AHEAD_S = 3.5  # a window that hangs for 2 s and more is not heard
PAUSED_AHEAD_S = 1.0  # decoded while paused: most seeks are followed by another
HISTORY_S = 0.5  # kept behind the reader, for a pause that was heard late


class AudioRing:
    """Samples by media time between the decoder and the process that plays them.

    At another speed the samples are time-stretched before they are written, and an
    index counts stretched samples. `descriptor` is that of the `SoundBlock`;
    `latency_s` reaches from the time that the output states to the ear.
    """

    def __init__(self, rate_hz: int = RATE_HZ) -> None:
        self.rate_hz = rate_hz
        self.latency_s = 0.0
        capacity = round((AHEAD_S + HISTORY_S) * rate_hz)
        self.descriptor = anonymous_memory("hapticplayer-sound", block_bytes(capacity))
        SoundBlock.shape(self.descriptor, rate_hz, capacity)
        self._block = SoundBlock(self.descriptor)
        self._samples: NDArray[np.float32] = np.frombuffer(
            self._block.samples, dtype=np.float32
        ).reshape(capacity, CHANNELS)
        self._capacity = capacity
        self._cue = Cue()
        self._generation = 0  # of the samples: a pause keeps them
        self._tail = 0
        self._lock = threading.Lock()

    def close(self) -> None:
        """Close the descriptor; the memory is freed with its last user."""
        if self.descriptor >= 0:
            os.close(self.descriptor)
            self.descriptor = -1

    @property
    def gain(self) -> float:
        """Of the amplitude; a change is spread over one block."""
        return self._cue.gain

    @gain.setter
    def gain(self, gain: float) -> None:
        self._say(gain=gain)

    @property
    def speed(self) -> float:
        """Media seconds per second of the sound that is here."""
        return self._cue.speed

    @property
    def underrun_samples(self) -> int:
        return self._block.last_heard().missing

    @property
    def is_complete(self) -> bool:
        """Whether the decoder has reached the end of the sound."""
        return self._cue.is_complete

    def load(self, epoch: int, media_s: float, speed: float = 1.0) -> int:
        """Drop all samples, stop at a position, and return the next generation."""
        with self._lock:
            self._generation += 1
            at = round(media_s / speed * self.rate_hz)
            self._go_to(
                at, epoch=epoch, begin=at, written=at, speed=speed, is_complete=False
            )
            return self._generation

    def resume_from(self, epoch: int, media_s: float) -> bool:
        """Stop at a position without new samples, if they are still here."""
        index = self._index(media_s)
        with self._lock:
            cue = self._cue
            oldest = max(cue.begin, cue.written - self._capacity)
            if not oldest <= index <= cue.written:
                return False
            self._go_to(index, epoch=epoch)
            return True

    def follow(self, epoch: int) -> None:
        """Report for another epoch from now on; the sound continues."""
        self._say(epoch=epoch)
        self._tail = self._block.head

    def play(self) -> None:
        self._say(is_playing=True)

    def join(self, clock: PlaybackClock) -> None:
        """Play on from where a running clock will be when the next sample is heard."""
        clock = clock.ahead(self.latency_s)
        self._say(
            is_playing=True,
            join=self._cue.join + 1,
            join_monotonic_s=clock.monotonic0_s,
            join_media_s=clock.media0_s,
            join_rate=clock.rate,
        )

    def hold(self) -> None:
        """Silence; the position stays."""
        self._say(is_playing=False)

    def write(
        self, generation: int, media_s: float, samples: NDArray[np.float32]
    ) -> int:
        """Append samples (n, 2) that start at a media time, stretched to the speed.

        `generation` is that of the `load` that they were decoded for.

        Returns:
            How many rows were taken (late ones count as taken); fewer than n when
            the ring is full. A stale generation takes all and keeps none.
        """
        with self._lock:
            if generation != self._generation:
                return len(samples)
            cue, read = self._cue, self._read()
            written = max(cue.written, read)
            first = self._index(media_s)
            late = min(len(samples), max(0, written - first))
            start = first + late
            ahead_s = AHEAD_S if cue.is_playing else PAUSED_AHEAD_S
            room = read + round(ahead_s * self.rate_hz) - start
            count = max(0, min(len(samples) - late, room))
            if count:
                if start > written:
                    self._fill(written, np.zeros((start - written, CHANNELS)))
                self._fill(start, samples[late : late + count])
                self._publish(written=start + count)
            return late + count

    def finish(self, generation: int) -> None:
        """Say that the sound ends here: what follows is no underrun."""
        with self._lock:
            if generation == self._generation:
                self._publish(is_complete=True)

    def buffered_s(self) -> float:
        return max(0, self._cue.written - self._read()) / self.rate_hz

    def reports(self) -> list[AudioReport]:
        """The reports (DAC time, media time) since the last call, oldest first."""
        heard, self._tail = self._block.heard_since(self._tail)
        epoch, later_s = self._cue.epoch, self.latency_s
        return [
            AudioReport(epoch, one.monotonic_s + later_s, one.media_s)
            for one in heard
            if one.epoch == epoch
        ]

    def _read(self) -> int:
        last, cue = self._block.last_heard(), self._cue
        return last.read if last.cue == cue.number else cue.start

    def _go_to(self, index: int, **fields: Any) -> None:
        """Begin at an index, and hear no more of what was before."""
        self._publish(
            number=self._cue.number + 1, start=index, is_playing=False, **fields
        )
        self._tail = self._block.head

    def _say(self, **fields: Any) -> None:
        with self._lock:
            self._publish(**fields)

    def _publish(self, **fields: Any) -> None:
        """Change the cue; the lock is held."""
        self._cue = self._cue._replace(**fields)
        self._block.write_cue(self._cue)

    def _index(self, media_s: float) -> int:
        return round(media_s / self._cue.speed * self.rate_hz)

    def _fill(self, index: int, samples: NDArray[Any]) -> None:
        samples = samples[-self._capacity :]
        at = index % self._capacity
        before_the_end = min(len(samples), self._capacity - at)
        self._samples[at : at + before_the_end] = samples[:before_the_end]
        self._samples[: len(samples) - before_the_end] = samples[before_the_end:]
