"""Figures and curves of a rendering, to compare it with another one.

before = stored_rendering(folder)
after = previewed_rendering(folder, mapping, preset="equal")
"""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hapticplayer import model
from hapticplayer.errors import InputError, Message, Progress, no_progress
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence import editing, store
from hapticplayer.sequence.description import ExcursionEntry
from hapticplayer.sequence.excursion import predict, travel_m
from hapticplayer.sequence.figures import ForceFigures, force_figures
from hapticplayer.sequence.presets import preset_of

SPANS = 600
"""Of the curves: about as many as a picture has columns."""

HAND = "relaxed"
"""Whose excursion is drawn: it moves furthest."""

_RATE_HZ = 200.0
_AT_A_TIME = 50  # spans


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """A force track and the predicted excursion, for a picture of the whole clip.

    Attributes:
        duration_s: of the clip, divided into `SPANS` equal spans.
        force_n: (SPANS, 3, 2) the lowest and the highest in each span, frame D.
        excursion_m: (SPANS,) the largest distance of a relaxed hand from the centre.
    """

    duration_s: float
    force_n: Floats
    excursion_m: Floats


@dataclass(frozen=True, slots=True, eq=False)
class RenderingResult:
    """A mapping, a preset, and what they make of a motion.

    Attributes:
        mapping: with the gain that was used.
        preset: its name.
        fitted_gain_n_per_mps2: what `fit` would give; None where there is no motion.
        figures: of the realistic track.
        excursion: of `excursion.predict`, for its warnings.
        curves: of the realistic track.
    """

    mapping: model.Mapping
    preset: str
    fitted_gain_n_per_mps2: float | None
    figures: ForceFigures
    excursion: ExcursionEntry
    curves: Curves


def stored_rendering(
    folder: Path, *, progress: Progress = no_progress
) -> RenderingResult:
    """Return the rendering that a sequence has."""
    sequence = store.open_sequence(folder)
    store.motion_of(sequence)
    feedbacks = sequence.description.feedbacks
    described, track = feedbacks[model.rendered_feedback(feedbacks)], sequence.rendered
    excursion = described.excursion or _predicted(sequence, track, progress)
    return _described(sequence, sequence.mapping, track, excursion)


def previewed_rendering(
    folder: Path,
    mapping: model.Mapping,
    *,
    fits_gain: bool = False,
    preset: str | None = None,
    progress: Progress = no_progress,
) -> RenderingResult:
    """The outcome of `editing.set_mapping`; nothing is written.

    Arguments and errors as there.
    """
    sequence = store.open_sequence(folder)
    mapping, track = editing.render_sequence(
        sequence, mapping, fits_gain=fits_gain, preset=preset
    )
    excursion = _predicted(sequence, track, progress)
    return _described(sequence, mapping, track, excursion)


def _described(
    sequence: store.Sequence,
    mapping: model.Mapping,
    track: ForceTrack,
    excursion: ExcursionEntry,
) -> RenderingResult:
    duration_s, limit_n = sequence.duration_s, mapping.force_limit_n
    try:
        offer = editing.fitted_gain(sequence, mapping)
    except InputError:  # no valid motion while the clip plays, or no log for the arm
        offer = None
    return RenderingResult(
        mapping,
        preset_of(track),
        offer,
        force_figures(track, duration_s, limit_n, prediction=excursion),
        excursion,
        curves_of(track, duration_s),
    )


def _predicted(
    sequence: store.Sequence, track: ForceTrack, progress: Progress
) -> ExcursionEntry:
    text = Message("predicting excursions")
    return predict(track, sequence.duration_s, lambda share: progress(share, text))


def curves_of(track: ForceTrack, duration_s: float) -> Curves:
    """Return the curves of a track.

    Args:
        track: in media time.
        duration_s: of the clip; force outside it is not played.
    """
    span_s = duration_s / SPANS
    count = max(2, math.ceil(span_s * _RATE_HZ))
    inside_s = np.linspace(0.0, span_s, count)  # both edges: curves have no holes
    force_n = np.empty((SPANS, 3, 2))
    for first in range(0, SPANS, _AT_A_TIME):
        starts_s = span_s * np.arange(first, min(first + _AT_A_TIME, SPANS))
        at_s = (starts_s[:, None] + inside_s).ravel()
        values = track.at(at_s).reshape(len(starts_s), count, 3)
        force_n[first : first + len(starts_s), :, 0] = values.min(axis=1)
        force_n[first : first + len(starts_s), :, 1] = values.max(axis=1)
    return Curves(duration_s, force_n, _excursion_m(track, duration_s))


def _excursion_m(track: ForceTrack, duration_s: float) -> Floats:
    time_s, place_m = travel_m(track, duration_s, HAND)
    distance_m = np.linalg.norm(place_m, axis=1)
    edges = np.searchsorted(time_s, np.linspace(0.0, duration_s, SPANS + 1))
    edges = np.minimum(edges, len(distance_m) - 1)
    # a span without a sample of its own takes the next one
    return np.maximum.reduceat(np.append(distance_m, 0.0), edges[:-1])
