"""Ratings while clips play, of all participants: what is compared, and their courses."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.model import Feedback
from hapticplayer.model.arrays import Floats
from hapticplayer.study.definition import (
    Condition,
    Definition,
    LiveRating,
    RatingKind,
    TrialKind,
)
from hapticplayer.study.live_ratings import FIGURES, RatingTrack, onset_s, read_ratings
from hapticplayer.study.sequence_folders import sequence_folder
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.study_folder import Study

COURSE_HZ = 5.0
COMPARED = {
    RatingKind.SLIDER: ("mean", "most"),
    RatingKind.NUMBER: ("mean", "most"),
    RatingKind.HELD_KEY: ("onset_s", "held_s"),
}
"""Figures of a trial by which feedbacks are compared."""

Forces = tuple[Callable[[Floats], Floats], Callable[[Floats], Floats]]
"""The force that is played, and that of the recorded motion, at media times."""

Tracks = Mapping[tuple[int, int, str], RatingTrack]
"""By position, attempt and key."""


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """A rating over the time of a clip.

    Attributes:
        rating: of the definition.
        condition: what was played.
        time_s: media time (T,).
        values: of each participant (P, T); NaN where missing.
        force_n: that was played (T, 3); None without the sequence.
        mismatch_n: force of the recorded motion less that (T, 3); None without it.
    """

    rating: LiveRating
    condition: Condition
    time_s: Floats
    values: Floats
    force_n: Floats | None
    mismatch_n: Floats | None


def tracks_of(session: StoredSession, notices: list[str]) -> Tracks:
    """The ratings of a session; what is damaged adds to the notices."""
    if not session.definition.while_watching:
        return {}
    read = read_ratings(session, notices)
    return {(one.position, one.attempt, one.rating.key): one for one in read}


def compared_keys(definition: Definition) -> dict[str, LiveRating]:
    """What feedbacks are compared by, such as `vection.onset_s`."""
    is_rating = definition.trial is TrialKind.RATING
    return {
        f"{one.key}.{name}": one
        for one in (definition.while_watching if is_rating else ())
        for name in COMPARED[one.kind]
    }


def compared_figures(
    definition: Definition, tracks: Tracks, position: int, attempt: int
) -> dict[str, float | None]:
    """The figures of a trial; where a key was never held, its onset is the clip's end."""
    found: dict[str, float | None] = {}
    for key, rating in compared_keys(definition).items():
        track = tracks.get((position, attempt, rating.key))
        if track is None or not len(track.media_s):
            found[key] = None
            continue
        figure = FIGURES[rating.kind][key.rpartition(".")[2]][0]
        value = figure(track)
        is_never = figure is onset_s and value is None
        found[key] = float(track.media_s[-1]) if is_never else value
    return found


def ranges_of_figures(
    definition: Definition, rows: Sequence[Mapping[str, float | None]]
) -> dict[str, tuple[float, float]]:
    """Least and most of the figures that anybody has: of the scale, or 0 to the longest time."""
    keys = {
        key: rating
        for key, rating in compared_keys(definition).items()
        if any(row[key] is not None for row in rows)
    }
    times = [key for key, one in keys.items() if one.kind is RatingKind.HELD_KEY]
    given = [one for row in rows for key in times if (one := row[key]) is not None]
    limits = {}
    for key, rating in keys.items():
        if rating.kind is RatingKind.HELD_KEY:
            limits[key] = (0.0, float(math.ceil(max([1.0, *given]))))
        else:
            limits[key] = (float(rating.least or 0), float(rating.most or 0))
    return limits


def courses(
    study: Study,
    tracks: Sequence[Mapping[Condition, Mapping[str, RatingTrack]]],
    notices: list[str],
) -> Iterator[Course]:
    """Yield the courses of each rating and condition.

    Args:
        study: opened.
        tracks: of each participant, of valid trials, by condition and key.
        notices: gets why there are no forces.
    """
    forces = played_forces(study, notices) if study.definition.while_watching else {}
    for rating in study.definition.while_watching:
        for condition in study.definition.conditions:
            found = [one.get(condition, {}).get(rating.key) for one in tracks]
            played = [
                max(
                    (o.media_s[-1] for o in each.values() if len(o.media_s)),
                    default=0.0,
                )
                for each in (one.get(condition, {}) for one in tracks)
            ]
            if not any(one is not None and len(one.media_s) for one in found):
                continue
            last_s = float(np.median([one for one in played if one > 0.0]))
            time_s = np.arange(0.0, last_s, 1.0 / COURSE_HZ)
            values = np.array(
                [_at(*one, time_s) for one in zip(found, played, strict=True)]
            )
            of = forces.get((condition.sequence, condition.feedback))
            force_n, mismatch_n = (
                (of[0](time_s), of[1](time_s) - of[0](time_s)) if of else (None, None)
            )
            yield Course(rating, condition, time_s, values, force_n, mismatch_n)


def _at(track: RatingTrack | None, until_s: float, time_s: Floats) -> Floats:
    """The value that was last given at media times, until the clip ended; else NaN."""
    if track is None or not len(track.media_s):
        return np.full(len(time_s), np.nan)
    is_given = ~np.isnan(track.value)
    at_s, value = np.maximum.accumulate(track.media_s)[is_given], track.value[is_given]
    if not len(at_s):
        return np.full(len(time_s), np.nan)
    rows = np.searchsorted(at_s, time_s, side="right") - 1
    is_known = (rows >= 0) & (time_s <= until_s + 1.0 / COURSE_HZ)
    return np.where(is_known, value[np.maximum(rows, 0)], np.nan)


def played_forces(study: Study, notices: list[str]) -> dict[tuple[str, str], Forces]:
    """By sequence and feedback, the force that is played and that of the motion."""
    from hapticplayer.playback.conditions import feedback_track
    from hapticplayer.playback.source import open_source  # few studies have ratings
    from hapticplayer.study.session_setup import others_of

    definition = study.definition
    chosen = definition.chosen_feedbacks
    realistic = next((o for o in chosen if o.condition == Feedback.REALISTIC), None)
    try:
        opened = {
            one.key: open_source(sequence_folder(study, one.key))
            for one in definition.sequences
        }
        found: dict[tuple[str, str], Forces] = {}
        for key, source in opened.items():
            others = others_of(opened, key)
            made = {
                one.name: feedback_track(source, one.condition, one.parameters, others)
                for one in chosen
            }
            motion = (
                made[realistic.name] if realistic else source.tracks[Feedback.REALISTIC]
            )
            for name, track in made.items():
                found[key, name] = (track.at, motion.at)
    except (InputError, UsageError, KeyError) as problem:
        text = "ratings are shown without the force: {reason}"
        notices.append(Message(text, reason=problem))
        return {}
    return found
