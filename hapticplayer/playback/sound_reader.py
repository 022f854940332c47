"""The side of the sound that has no time to lose: from the shared memory to the DAC.

The reader's position moves with the DAC whatever happens: samples that come too late
are skipped, missing ones are silence. So the sound never stalls the clock. It runs in
a process of its own, without numpy: copying bytes needs none.
"""

from array import array
from itertools import repeat
from operator import mul

from hapticplayer.playback.sound_block import (
    CHANNELS,
    FRAME_BYTES,
    Cue,
    Heard,
    SoundBlock,
)


class SoundReader:
    """Fills the blocks that a sound output asks for; one thread at a time."""

    def __init__(self, block: SoundBlock) -> None:
        self._block = block
        self._cue = block.read_cue() or Cue()
        last = block.last_heard()
        self._number, self._join = last.cue, self._cue.join
        self._read, self._missing = last.read, last.missing
        self._gain = self._cue.gain

    def render(self, out: memoryview, dac_s: float, silence_s: float = 0.0) -> None:
        """Fill a block.

        Args:
            out: bytes, writable; float32, interleaved.
            dac_s: monotonic time at which its first sample sounds.
            silence_s: that the output has put in before it for want of samples: so
                much sound is left out, and the rest is as late as it was before.
        """
        self._cue = cue = self._block.read_cue() or self._cue
        left_out = round(silence_s * self._block.rate_hz) if cue.is_playing else 0
        self._read += left_out
        self._missing += left_out
        self._place(cue, dac_s)
        if not cue.is_playing:
            out[:] = bytes(len(out))
            return
        count = len(out) // FRAME_BYTES
        ready = max(0, min(count, cue.written - self._read))
        self._copy(out[: ready * FRAME_BYTES])
        out[ready * FRAME_BYTES :] = bytes((count - ready) * FRAME_BYTES)
        if not cue.is_complete:
            self._missing += count - ready
        self._turn_up(out, cue.gain)
        media_s = self._read / self._block.rate_hz * cue.speed
        self._read += count
        self._block.write_heard(
            Heard(cue.epoch, dac_s, media_s, cue.number, self._read, self._missing)
        )

    def _place(self, cue: Cue, dac_s: float) -> None:
        """Go where a new cue or a running clock wants it."""
        if cue.number != self._number:
            self._number, self._read = cue.number, cue.start
        if cue.join != self._join:
            self._join = cue.join
            elapsed_s = max(0.0, dac_s - cue.join_monotonic_s)
            media_s = cue.join_media_s + cue.join_rate * elapsed_s
            wanted = round(media_s / cue.speed * self._block.rate_hz)
            self._read = max(cue.begin, wanted)

    def _copy(self, out: memoryview) -> None:
        """Copy samples from the present position; the memory is a ring."""
        at = self._read % self._block.capacity * FRAME_BYTES
        part = self._block.samples[at : at + len(out)]
        out[: len(part)] = part
        out[len(part) :] = self._block.samples[: len(out) - len(part)]

    def _turn_up(self, out: memoryview, gain: float) -> None:
        """Apply the volume; a step would be heard as a click."""
        before, self._gain = self._gain, gain
        if before == gain == 1.0:
            return
        samples = array("f", bytes(out))
        count = max(1, len(samples) // CHANNELS - 1)
        step = (gain - before) / count
        gains = (
            (before + step * (k // CHANNELS) for k in range(len(samples)))
            if step
            else repeat(gain)
        )
        out[:] = memoryview(array("f", map(mul, samples, gains))).cast("B")
