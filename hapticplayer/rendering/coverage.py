"""Checks whether the rows of a force track belong to a clip."""

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack
from hapticplayer.model.timing import time_unit_remedy

HARDLY = 0.1
"""A track that ends before this part of the clip, or begins after it."""

MUCH_LONGER = 10.0
"""Times of so many clips are mostly in another unit."""

UNIT_FITS = (0.05, 2.0)
"""Lengths of the clip that a track has in its own unit of time."""


def coverage_notice(track: ForceTrack, duration_s: float) -> Message | None:
    """Return a notice about a track that covers hardly anything of a clip."""
    first_s, last_s = float(track.time_s[0]), float(track.time_s[-1])
    is_constant = len(track.time_s) == 1 and first_s <= 0.0
    fits = first_s <= HARDLY * duration_s <= last_s <= MUCH_LONGER * duration_s
    if fits or is_constant:
        return None
    notice = Message(
        "the force track goes from {first_s:.6g} s to {last_s:.6g} s, "
        "the clip to {duration_s:.6g} s",
        first_s=first_s,
        last_s=last_s,
        duration_s=duration_s,
    )
    remedy = _unit_remedy(last_s, duration_s)
    return Message("{what}; {remedy}", what=notice, remedy=remedy) if remedy else notice


def refuse_late(track: ForceTrack, duration_s: float, where: str) -> None:
    """Refuse a track that begins after the end of the clip."""
    if track.time_s[0] < duration_s:
        return
    raise InputError(
        "starts at {time_s:.3f} s, but the clip ends at {duration_s:.3f} s",
        where=where,
        remedy=_unit_remedy(float(track.time_s[-1]), duration_s)
        or Message("give times in seconds of the clip"),
        time_s=track.time_s[0],
        duration_s=duration_s,
    )


def _unit_remedy(last_s: float, duration_s: float) -> Message | None:
    low, high = UNIT_FITS
    return time_unit_remedy(
        lambda per_s: low * duration_s <= last_s / per_s <= high * duration_s
    )
