"""A sound output without a device: it consumes a ring as far as time is advanced."""

from hapticplayer.clock import Clock
from hapticplayer.playback.sound_device import LATENCY_S
from hapticplayer.playback.sound_memory import (
    CHANNELS,
    FRAME_BYTES,
    SoundBlock,
    SoundReader,
)
from hapticplayer.playback.sound_process import OutputState
from hapticplayer.playback.sound_ring import AudioRing


class SilentOutput:
    """An `AudioOut` whose DAC is `advance`; `state` is what `poll` returns."""

    name = "silent"

    def __init__(
        self, ring: AudioRing, clock: Clock, *, latency_s: float = LATENCY_S
    ) -> None:
        self.problem = ""
        self.is_alive = True
        self.state = OutputState.OPEN
        self.block = SoundBlock(ring.descriptor)
        self._reader = SoundReader(self.block)
        self._clock, self._latency_s = clock, latency_s

    def poll(self) -> OutputState:
        """Return the state that it was given."""
        return self.state

    def advance(self, frames: int) -> "memoryview[float]":
        """Take the next `frames` samples as a DAC would; float32, (frames, 2)."""
        out = memoryview(bytearray(frames * FRAME_BYTES))
        if self.is_alive:
            self._reader.render(out, self._clock.now_s() + self._latency_s)
        return out.cast("f", (frames, CHANNELS))

    def close(self) -> None:
        """There is no device to close."""
