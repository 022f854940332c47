"""The memory that the player and the sound process share, and how the latter reads it.

The player writes samples and the `Cue`, the sound process the `HeardBlock` records; none
ever waits for the other. Standard library only: the sound process loads no numpy, and
copying bytes needs none.
"""

import mmap
import os
import struct
from array import array
from itertools import repeat
from operator import mul
from typing import NamedTuple

from hapticplayer.haptics.slots import Slots

CHANNELS = 2
FRAME_BYTES = 4 * CHANNELS  # float32
HEARD_RECORDS = 4096  # a minute of callbacks that were not read

_HEADER = struct.Struct("<qq")  # rate, capacity
_CUE = struct.Struct("<5q2d2?6xq3d")
_HEARD = struct.Struct("<qddqqq")
# the writers have cache lines of their own
_SLOTS_AT, _NEWEST_AT, _HEAD_AT = (64, 192), 320, 384
_HEARD_AT = 4096
_SAMPLES_AT = _HEARD_AT + HEARD_RECORDS * _HEARD.size


class Cue(NamedTuple):
    """What the sound process shall play; indices count samples, at the speed that is set."""

    number: int = 0  # another one means: begin at `start`
    epoch: int = 0  # of the clock, for the records
    start: int = 0  # where to begin
    begin: int = 0  # the oldest sample that may still be there
    written: int = 0  # up to here there are samples
    speed: float = 1.0  # media seconds per second of sound
    gain: float = 1.0  # of the amplitude
    is_playing: bool = False  # silence and standstill otherwise
    is_complete: bool = False  # nothing follows what is written
    # another one than 0 and than before means: jump to where a line through
    # (`join_monotonic_s`, `join_media_s`) with the slope `join_rate` will be
    join: int = 0
    join_monotonic_s: float = 0.0
    join_media_s: float = 0.0
    join_rate: float = 0.0


class HeardBlock(NamedTuple):
    """One block of sound: from `monotonic_s` on, `media_s` is heard."""

    epoch: int = 0
    monotonic_s: float = 0.0
    media_s: float = 0.0
    cue: int = 0  # number of the cue that it belongs to
    read: int = 0  # the sample that comes next
    missing: int = 0  # samples in all, since the first block, that had to be silence


def block_bytes(capacity: int) -> int:
    return _SAMPLES_AT + capacity * FRAME_BYTES


class SoundBlock:
    """Typed access to the memory; both sides hold one.

    Sample number k, interleaved float32, lies in row k % capacity.
    """

    def __init__(self, descriptor: int) -> None:
        size = os.fstat(descriptor).st_size
        self._map = mmap.mmap(descriptor, size)
        self.rate_hz, self.capacity = _HEADER.unpack_from(self._map)
        if size != block_bytes(self.capacity):
            raise ValueError("the memory of the sound has another size")
        view = memoryview(self._map)
        self._cue = Slots(self._map, _CUE, _SLOTS_AT, _NEWEST_AT)
        self._head = view[_HEAD_AT : _HEAD_AT + 8].cast("Q")
        self.samples = view[_SAMPLES_AT:]

    @staticmethod
    def shape(descriptor: int, rate_hz: int, capacity: int) -> None:
        """Give new memory the size that it needs (player)."""
        os.ftruncate(descriptor, block_bytes(capacity))
        os.pwrite(descriptor, _HEADER.pack(rate_hz, capacity), 0)

    def write_cue(self, cue: Cue) -> None:
        """Say what shall be played (player)."""
        self._cue.write(*cue)

    def read_cue(self) -> Cue | None:
        """Return the newest cue, None when it is being written."""
        fields = self._cue.read()
        return None if fields is None else Cue(*fields)

    @property
    def head(self) -> int:
        """How many blocks have been played."""
        return self._head[0]

    def write_heard(self, heard: HeardBlock) -> None:
        """Say what has been handed to the DAC (sound process)."""
        head = self._head[0]
        _HEARD.pack_into(self._map, self._at(head), *heard)
        self._head[0] = head + 1

    def last_heard(self) -> HeardBlock:
        """Return the newest record; zeros before the first."""
        head = self._head[0]
        if not head:
            return HeardBlock()
        return HeardBlock(*_HEARD.unpack_from(self._map, self._at(head - 1)))

    def heard_since(self, tail: int) -> tuple[list[HeardBlock], int]:
        """Return the records from number `tail` on, oldest first, and the next tail.

        Records are kept for a minute.
        """
        head = self._head[0]
        # one slot aside: it may be written while it is read
        first = max(tail, head - HEARD_RECORDS + 1)
        records = [
            HeardBlock(*_HEARD.unpack_from(self._map, self._at(number)))
            for number in range(first, head)
        ]
        return records, head

    @staticmethod
    def _at(number: int) -> int:
        return _HEARD_AT + number % HEARD_RECORDS * _HEARD.size


class SoundReader:
    """Fills the blocks that a sound output asks for; one thread at a time.

    Its position moves with the DAC in any case: samples that come too late are skipped,
    missing ones are silence. So the sound never stalls the clock.
    """

    def __init__(self, block: SoundBlock) -> None:
        self._block = block
        self._cue = block.read_cue() or Cue()
        last = block.last_heard()
        self._number, self._join = last.cue, self._cue.join
        self._read, self._missing = last.read, last.missing
        self._gain = self._cue.gain

    def render(self, out: memoryview, dac_s: float, silence_s: float = 0.0) -> None:
        """Fill a block (writable bytes of interleaved float32) that sounds at `dac_s`.

        `silence_s` is what the output has put in before it for want of samples: so much
        sound is left out, and the rest is as late as it was before.
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
        self._amplify(out, cue.gain)
        media_s = self._read / self._block.rate_hz * cue.speed
        self._read += count
        self._block.write_heard(
            HeardBlock(cue.epoch, dac_s, media_s, cue.number, self._read, self._missing)
        )

    def _place(self, cue: Cue, dac_s: float) -> None:
        """Go where a new cue or a running clock asks for."""
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

    def _amplify(self, out: memoryview, gain: float) -> None:
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
