"""Thresholds of staircases: of each participant, and of the group.

A threshold is the geometric mean of the last reversals (Wetherill and Levitt 1965), which
a short staircase leaves too large: the curve of `levels` is the estimate of the group. The
interval of the mean is a percentile bootstrap over participants.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.describing import TAILS
from hapticplayer.study.answers import Answers
from hapticplayer.study.intervals import StaircaseTrack, track_of


@dataclass(frozen=True, slots=True)
class PersonTrack:
    """The staircase of one participant, for a sequence and feedback."""

    participant: str
    sequence: str
    feedback: str
    track: StaircaseTrack


@dataclass(frozen=True, slots=True)
class GroupThreshold:
    """The thresholds of a sequence and feedback: number, mean, SD, 95 % interval."""

    sequence: str
    feedback: str
    count: int
    mean: float
    sd: float | None
    interval: tuple[float, float] | None


def tracks_of(answers: Answers) -> Iterator[PersonTrack]:
    """Yield the staircases that were begun."""
    rule = answers.staircase
    found: dict[tuple[str, str, str], list[bool]] = {}
    for one in sorted(answers.judgements, key=lambda one: one.position):
        if one.answer is not None and one.is_valid:
            of = one.participant, one.sequence, one.feedback
            found.setdefault(of, []).append(bool(one.answer))
    for of, correct in found.items():
        if rule is not None:
            yield PersonTrack(*of, track_of(rule, correct))


def group_thresholds(
    tracks: list[PersonTrack], options: AnalysisOptions
) -> Iterator[GroupThreshold]:
    """Yield the thresholds of each sequence and feedback that has some."""
    found: dict[tuple[str, str], list[float]] = {}
    for one in tracks:
        if one.track.threshold is not None:
            of = one.sequence, one.feedback
            found.setdefault(of, []).append(one.track.threshold)
    for of, values in found.items():
        count, mean = len(values), float(np.mean(values))
        if count == 1:
            yield GroupThreshold(*of, count, mean, None, None)
            continue
        rng = options.resampling.generator("/".join(("staircase", *of)))
        drawn = rng.choice(values, (options.resampling.count, count)).mean(axis=1)
        low, high = np.quantile(drawn, TAILS)
        sd = float(np.std(values, ddof=1))
        yield GroupThreshold(*of, count, mean, sd, (float(low), float(high)))
