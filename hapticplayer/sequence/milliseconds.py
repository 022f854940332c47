"""Force tracks on the milliseconds of media time, where the haptic loop takes its values.

Between two milliseconds the limiter allows no more than a line anyway, so a polyline with
corners at whole milliseconds that has a track's values at all of them is felt as it is.
"""

import math
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_SECONDS
from hapticplayer.sequence.force_files import Loss

Ticks = NDArray[np.int64]

PIECE_MS = 600_000
"""Ten minutes are in memory at a time."""

_COMPARED_MS = 60_000

OF_FORCE = Message("force vector, every millisecond")


def end_ms(track: ForceTrack, duration_s: float | None) -> int:
    """Return the first millisecond at which a track, or the clip, has ended.

    It is the first k with `k / 1000 >= end`, as `ForceTrack.at` compares, rounding or not.
    A HOLD track without a clip ends a millisecond after its last entry has begun.
    """
    holds = duration_s is None and track.reconstruction is Reconstruction.HOLD
    if duration_s is None:
        until_s = float(track.time_s[-1])
    else:
        until_s = min(track.end_s, duration_s)
    if not until_s <= MAX_SECONDS:
        raise InputError(
            "the track ends at {end_s:.4g} s, after the longest clip ({most_s:.0f} s)",
            end_s=until_s,
            most_s=MAX_SECONDS,
        )
    near_ms = max(0, round(until_s * 1000.0))
    around = range(max(0, near_ms - 1), near_ms + 2)
    return next(k for k in around if k / 1000.0 >= until_s) + holds


def corners(track: ForceTrack, first_ms: int, last_ms: int) -> tuple[Ticks, Floats]:
    """Return a polyline with a track's values at all milliseconds of a span.

    Args:
        track: any.
        first_ms: of the span, its first corner.
        last_ms: of the span, its last corner.

    Returns:
        Times (K,) ms, increasing, and forces (K, 3) N.
    """
    begin, end = np.searchsorted(
        track.time_s, [(first_ms - 2) / 1000.0, (last_ms + 2) / 1000.0]
    )
    times_ms = track.time_s[begin:end] * 1000.0
    below = np.floor(times_ms).astype(np.int64)
    near = [[first_ms, last_ms], below, below + 1]
    if track.reconstruction is Reconstruction.HOLD:
        near += [below - 1, below + 2]
    elif len(below):  # a line begins and ends with a jump
        near += [below[[0, -1]] - 1, below[[0, -1]] + 2]
    ticks = np.unique(np.concatenate([np.asarray(one, np.int64) for one in near]))
    ticks = ticks[(ticks >= first_ms) & (ticks <= last_ms)]
    return ticks, track.at(ticks / 1000.0)


def goes_on_after(track: ForceTrack, end_s: float) -> bool:
    """Whether a track has force of its own a millisecond after the end of a clip."""
    active, last_s = track.active_s, float(track.time_s[-1])
    return bool(len(active)) and min(float(active[-1, 1]), last_s) > end_s + 0.001


def pieces(until_ms: int, size_ms: int = PIECE_MS) -> Iterator[tuple[int, int]]:
    """Yield spans that follow each other, from 0 to the end; one at least."""
    for first in range(0, max(until_ms, 1), size_ms):
        yield first, max(first + 1, min(first + size_ms, until_ms))


def force_loss(
    track: ForceTrack, read: Iterable[tuple[int, ForceTrack]], until_ms: int
) -> Loss:
    """Return how a track differs from what was read of it.

    Args:
        track: any.
        read: parts that follow each other, each with the millisecond at which it ends.
        until_ms: where the comparison ends.
    """
    squares, largest, count, begin = 0.0, 0.0, 0, 0
    for end, part in read:
        for first in range(begin, min(end, max(until_ms, 1)), _COMPARED_MS):
            last = min(first + _COMPARED_MS, end, max(until_ms, 1))
            at_s = np.arange(first, last) / 1000.0
            size = np.square(track.at(at_s) - part.at(at_s)).sum(axis=1)
            squares += float(size.sum())
            largest = max(largest, float(size.max()))
            count += len(at_s)
        begin = max(begin, end)
    return Loss(math.sqrt(squares / max(count, 1)), math.sqrt(largest), OF_FORCE)
