"""Force tracks of a clip: whether they belong to it; later, scaled, inverted ones."""

from dataclasses import replace

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.model.arrays import Floats
from hapticplayer.model.timing import time_unit_remedy

SHUFFLED_RATE_HZ = 200.0
"""Of camera IMUs; the loop draws straight lines between."""

BLEND_S = 1.0
"""Over which the end of a short track becomes its beginning again."""


def shifted_and_scaled(track: ForceTrack, delay_s: float, gain: float) -> ForceTrack:
    """Return a force track delayed by `delay_s` and scaled by `gain`."""
    if delay_s == 0.0 and gain == 1.0:
        return track
    return ForceTrack(
        track.time_s + delay_s,
        track.force_n * np.float32(gain),
        track.reconstruction,
        {**track.provenance, "delay_s": delay_s, "gain": gain},
    )


def inverted(track: ForceTrack) -> ForceTrack:
    """Return the same force in the opposite direction."""
    made_of = {**track.provenance, "inverted": True}
    return replace(track, force_n=-track.force_n, provenance=made_of)


def shuffled(realistic: ForceTrack, other: ForceTrack) -> ForceTrack:
    """Return the force of another clip over the span of this one, with its RMS per axis.

    A longer track is cut, a shorter one repeated. Motion and picture have nothing to do
    with each other then, but the force is one that a recording has.

    Args:
        realistic: track of this clip.
        other: realistic track of another one.

    Returns:
        LINEAR track at 200 Hz.
    """
    start_s, end_s = float(realistic.time_s[0]), float(realistic.time_s[-1])
    count = max(2, int(np.ceil((end_s - start_s) * SHUFFLED_RATE_HZ)) + 1)
    time_s = np.linspace(start_s, max(end_s, start_s + 1e-3), count)
    force = _repeated(other, time_s - start_s)
    wanted_n = realistic.rms_n()
    found_n = np.sqrt(np.mean(np.square(force), axis=0))
    if np.any((found_n == 0.0) & (wanted_n > 0.0)):
        raise InputError("the other clip has no force along an axis that this one uses")
    gain = np.divide(wanted_n, found_n, out=np.zeros(3), where=found_n > 0.0)
    return ForceTrack(
        time_s,
        (force * gain).astype(np.float32),
        Reconstruction.LINEAR,
        {
            "feedback": "shuffled",
            "gain_per_axis": gain.tolist(),
            "other": dict(other.provenance),
        },
    )


def _repeated(track: ForceTrack, since_s: Floats) -> Floats:
    """Return the force (N, 3) after times since the track began, again and again."""
    first_s, length_s = float(track.time_s[0]), float(np.ptp(track.time_s))
    if since_s[-1] <= length_s:
        return track.at(first_s + since_s)
    blend_s = min(BLEND_S, 0.5 * length_s)
    period_s = length_s - blend_s
    if period_s <= 0.0:
        raise InputError("the other clip has a force track of a single row")
    lap, phase_s = np.divmod(since_s, period_s)
    # each lap but the first begins as the one before ends
    share = np.where(lap > 0.0, np.clip(phase_s / blend_s, 0.0, 1.0), 1.0)[:, None]
    before = track.at(first_s + phase_s + period_s)
    return np.asarray(share * track.at(first_s + phase_s) + (1.0 - share) * before)


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
