"""What stands still from beginning to end: looked at a sixteenth of a second at a time.

Nothing is to be seen there at the full rate but noise.
"""

import math
from dataclasses import replace

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.rest import Rest

_PART_S = 1.0 / 16.0
# Too short a recording is not worth it.
_PARTS = 100


def samples_of_a_part(rest: Rest | None, count: int, interval_s: float) -> int:
    """Return how many samples may be taken as one, 1 where something moves.

    Args:
        rest: where the block stands still, or None.
        count: samples of it.
        interval_s: of a sample.
    """
    if rest is None or rest.count[-1] < rest.at[-1] - rest.at[0]:
        return 1
    per_part = max(1, round(_PART_S / interval_s))
    return per_part if count >= _PARTS * per_part else 1


def in_parts(rest: Rest, per_part: int, count: int) -> Rest:
    """Return the still spans of so many samples, counted in parts.

    A last part of fewer samples counts as a whole one.
    """
    at, still = rest.at / per_part, rest.count / per_part
    missing = -(-count // per_part) - at[-1]
    if missing <= 1.0:
        at[-1] += missing
        still[-1] += missing
    return replace(rest, at=at, count=still)


def at_samples(values: Floats, per_part: int, count: int, *, averaged: bool) -> Floats:
    """Return means over parts (m, columns) at the samples of the parts (count, columns).

    Args:
        values: one row for the middle of each part.
        per_part: samples of a part; the last may be shorter.
        count: samples.
        averaged: whether a sample stands for its middle, else for its end.
    """
    width = values.shape[1]
    lag = 0.5 if averaged else 1.0
    first = math.ceil(0.5 * per_part - lag)  # sample after the first part's middle
    share = (np.arange(first, first + per_part) + lag) / per_part - 0.5
    # straight lines from middle to middle as one product, because numpy is slow along
    # short axes
    lines = np.stack([1.0 - share, share])[:, None, :, None] * np.eye(width)[:, None]
    ends = np.concatenate([values[:-1], values[1:]], axis=1)
    # a last part that is shorter lets the lines go on beyond the last sample
    stop = first + len(ends) * per_part
    out = np.empty((max(stop, count), width))
    out[:first] = values[0]
    between = out[first:stop].reshape(len(ends), -1)
    np.matmul(ends, lines.reshape(2 * width, -1), out=between)
    out[stop:] = values[-1]
    return out[:count]


def turned_to(quaternion: Floats) -> Floats:
    """Return quaternions (m, 4) of one sign each with the one before."""
    flips = np.sum(quaternion[1:] * quaternion[:-1], axis=1) < 0.0
    sign = np.where(np.append(0, np.cumsum(flips)) % 2, -1.0, 1.0)
    return sign[:, None] * quaternion


def orientation(
    quaternion: Floats, per_part: int, count: int, *, averaged: bool
) -> Floats:
    """Return `at_samples` of quaternions, unit again."""
    found = at_samples(turned_to(quaternion), per_part, count, averaged=averaged)
    found /= np.sqrt(np.einsum("ni,ni->n", found, found))[:, None]
    return found
