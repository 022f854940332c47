"""What a force track is like in a few numbers, to compare two versions of it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from hapticplayer.model import ForceTrack, rendered_feedback
from hapticplayer.model.limits import AT_LIMIT
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.sequence.description import ExcursionEntry, TrackEntry
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.store import Sequence

RATE_HZ = 500.0
_ROWS = 1 << 16  # at a time: an hour has 1.8 million


@dataclass(frozen=True, slots=True)
class ForceFigures:
    """A force track while its clip plays.

    Attributes:
        peak_n: largest magnitude.
        rms_n: of the magnitude over the clip.
        rms_axes_n: of each axis over the clip.
        saturated_share: of the clip's time, at the force limit.
        reaches: furthest share of the workspace for each hand.
        trips: hands that would cause a trip.
    """

    peak_n: float
    rms_n: float
    rms_axes_n: tuple[float, ...]
    saturated_share: float
    reaches: Mapping[str, float]
    trips: tuple[str, ...]


def force_figures(
    track: ForceTrack,
    duration_s: float,
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N,
    *,
    prediction: ExcursionEntry | None = None,
    progress: Callable[[float], None] = lambda _share: None,
) -> ForceFigures:
    """Return the figures of a track.

    Args:
        track: in media time, frame D, N.
        duration_s: of the clip; force outside it does not count.
        force_limit_n: magnitude, of the mapping.
        prediction: what `excursion.predict` returned for the track; None predicts.
        progress: called with the done share of a prediction; may raise to stop it.
    """
    count = max(1, round(duration_s * RATE_HZ))
    square, saturated = np.zeros(3), 0
    for first in range(0, count, _ROWS):
        time_s = np.arange(first, min(first + _ROWS, count)) / RATE_HZ
        each = np.square(track.at(time_s), dtype=np.float64)
        square += each.sum(axis=0)
        at_limit = each.sum(axis=1) >= (AT_LIMIT * force_limit_n) ** 2
        saturated += int(np.count_nonzero(at_limit))
    inside = (track.time_s >= 0.0) & (track.time_s <= duration_s)
    peaks = np.linalg.norm(track.force_n[inside].astype(np.float64), axis=1)
    found = prediction or predict(track, duration_s, progress)
    hands = found.hands
    return ForceFigures(
        peak_n=float(peaks.max(initial=0.0)),
        rms_n=float(np.sqrt(square.sum() / count)),
        rms_axes_n=tuple(np.sqrt(square / count).tolist()),
        saturated_share=saturated / count,
        reaches={name: one.reach for name, one in hands.items()},
        trips=tuple(name for name, one in hands.items() if one.trip is not None),
    )


def describe_track(
    track: ForceTrack,
    file: str,
    duration_s: float,
    force_limit_n: float,
    excursion: ExcursionEntry,
) -> TrackEntry:
    """The entry of a track: its figures are those of every page that shows some."""
    found = force_figures(track, duration_s, force_limit_n, prediction=excursion)
    return TrackEntry(
        file,
        found.peak_n,
        found.rms_axes_n,
        found.saturated_share,
        excursion,
        dict(track.provenance),
    )


def sequence_figures(sequence: Sequence) -> ForceFigures:
    """Return the figures of a sequence's rendered track, with its own prediction."""
    feedbacks = sequence.description.feedbacks
    entry = feedbacks[rendered_feedback(feedbacks)]
    return force_figures(
        sequence.rendered,
        sequence.duration_s,
        sequence.mapping.force_limit_n,
        prediction=entry.excursion,
    )
