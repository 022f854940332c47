"""A track as a loop reads it, one value at a time, from shared memory: force, or motion."""

import math
import mmap
import os
import struct
from bisect import bisect_right
from typing import TYPE_CHECKING

from hapticplayer.haptics.limiter import ZERO
from hapticplayer.haptics.live import LIVE_BYTES, LiveTrack, ScaledForce
from hapticplayer.linux import anonymous_memory
from hapticplayer.model.device import Vector

if TYPE_CHECKING:  # the loop, which loads this, has no numpy
    from hapticplayer.model import ForceTrack, RigTrack

_HEADER = struct.Struct("<QQQ")  # rows, spans, 1 when the track is HOLD
MAX_ROWS = 50_000_000  # fourteen hours at 1 kHz
FORCE_COLUMNS = 3


class LoadedTrack:
    """A track in shared memory, read without numpy.

    Scalars out of a memoryview cost 30 ns, out of an array 100 ns; at 1 kHz in
    plain Python that is the difference.
    """

    def __init__(self, block: mmap.mmap, columns: int = FORCE_COLUMNS) -> None:
        rows, spans, is_hold = _HEADER.unpack_from(block, 0)
        if not 1 <= rows <= MAX_ROWS or len(block) != _size(rows, spans, columns):
            raise ValueError("it does not match its shared memory")
        view = memoryview(block)
        times_at, spans_at = _HEADER.size, _HEADER.size + 8 * rows
        force_at = spans_at + 16 * spans
        self._time_s = view[times_at:spans_at].cast("d")
        self._span_edges_s = view[spans_at:force_at].cast("d")
        self._force_n = view[force_at:].cast("f")
        self._is_hold = bool(is_hold)
        self._last, self._columns = rows - 1, columns
        self._row = 0  # of the last call: the next one is near
        self._numbers, self._checked = (self._time_s, self._force_n), 0
        self.end_s = math.inf if is_hold else self._time_s[self._last]

    def check(self, count: int) -> bool:
        """Check so many further numbers; return whether all have been checked.

        Raises:
            ValueError: when one is not finite.
        """
        (times, forces), rows = self._numbers, len(self._numbers[0])
        begin, end = self._checked, self._checked + count
        # a sum with NaN or infinity in it is not finite
        total = sum(times[begin:end])
        total += sum(forces[max(0, begin - rows) : max(0, end - rows)])
        if not math.isfinite(total):
            raise ValueError("it contains NaN or infinity")
        self._checked = end
        return end >= rows + len(forces)

    def is_silent(self, _now_s: float) -> bool:
        """Whether its source is: it has none any more."""
        return False

    def force_at(self, media_s: float) -> Vector:
        """Return the planned force, N, frame D.

        Outside the active spans nothing is interpolated (an odd count of span
        edges before `media_s` means inside).
        """
        if not bisect_right(self._span_edges_s, media_s) & 1:
            return ZERO
        times, row = self._time_s, self._row
        if row >= self._last or not times[row] <= media_s < times[row + 1]:
            row = self._row_at(media_s)
        force, at = self._force_n, 3 * row
        x, y, z = force[at], force[at + 1], force[at + 2]
        if self._is_hold or row >= self._last:
            return (x, y, z)
        t0, t1 = times[row], times[row + 1]
        u = (media_s - t0) / (t1 - t0)
        return (
            x + u * (force[at + 3] - x),
            y + u * (force[at + 4] - y),
            z + u * (force[at + 5] - z),
        )

    def values_at(self, media_s: float) -> tuple[float, ...]:
        """Return the numbers of a track with any number of columns, as `force_at`."""
        columns = self._columns
        if not bisect_right(self._span_edges_s, media_s) & 1:
            return (0.0,) * columns
        row = self._row_at(media_s)
        at, values = columns * row, self._force_n
        first = values[at : at + columns].tolist()
        if self._is_hold or row >= self._last:
            return tuple(first)
        second = values[at + columns : at + 2 * columns].tolist()
        t0, t1 = self._time_s[row], self._time_s[row + 1]
        u = (media_s - t0) / (t1 - t0)
        return tuple(a + u * (b - a) for a, b in zip(first, second, strict=True))

    def _row_at(self, media_s: float) -> int:
        """Return the last row that is not after `media_s`: most often the next one."""
        times, row = self._time_s, self._row + 1
        if row >= self._last or not times[row] <= media_s < times[row + 1]:
            row = bisect_right(times, media_s) - 1
        self._row = row
        return row


AnyTrack = LoadedTrack | LiveTrack


def to_shared_memory(track: "ForceTrack | RigTrack | ScaledForce") -> int:
    """Return the descriptor of a memory block that holds the track, owned by the caller."""
    if isinstance(track, ScaledForce):
        descriptor = anonymous_memory("hapticplayer-live", LIVE_BYTES)
        track.attach(mmap.mmap(descriptor, LIVE_BYTES))
        return descriptor
    from hapticplayer.model import ForceTrack, Reconstruction

    if isinstance(track, ForceTrack):
        values, is_hold = track.force_n, track.reconstruction is Reconstruction.HOLD
    else:
        values, is_hold = track.motion, False
    rows, spans = len(track.time_s), len(track.active_s)
    size = _size(rows, spans, values.shape[1])
    descriptor = anonymous_memory("hapticplayer-track", size)
    with mmap.mmap(descriptor, size) as block:
        block.write(_HEADER.pack(rows, spans, int(is_hold)))
        for array in (track.time_s, track.active_s, values):
            block.write(array.data)
    return descriptor


def map_track(descriptor: int, columns: int = FORCE_COLUMNS) -> AnyTrack:
    """Return the track behind a descriptor; its numbers are still to be checked.

    Raises:
        ValueError: when the block is not a track of so many columns.
    """
    size = os.fstat(descriptor).st_size
    if size < _HEADER.size:
        raise ValueError("it does not match its shared memory")
    block = mmap.mmap(descriptor, size, prot=mmap.PROT_READ)
    if size == LIVE_BYTES and columns == FORCE_COLUMNS and not any(block[:8]):
        return LiveTrack(block)  # a track has rows
    return LoadedTrack(block, columns)


def _size(rows: int, spans: int, columns: int) -> int:
    return _HEADER.size + 8 * rows + 16 * spans + 4 * columns * rows
