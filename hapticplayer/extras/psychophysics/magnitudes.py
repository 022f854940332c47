"""Magnitude estimation: numbers by level, and the exponent of their power law.

Numbers are analysed by their logarithms, and as if all people had used one scale: each
participant's are divided by their geometric mean, and multiplied by that of all. The
exponent is the slope of log number against log gain of each participant (Stevens 1957);
the interval of its mean is a percentile bootstrap over participants.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.describing import TAILS
from hapticplayer.study.answers import Answers, Judgement

ALL = "all"
Level = tuple[float, float]
"""Delay, s, and gain."""
_Log = tuple[Judgement, float]


@dataclass(frozen=True, slots=True)
class Exponent:
    """Exponents of the power law, by participant, with mean and its 95 % interval."""

    by_person: Mapping[str, float]
    mean: float
    interval: tuple[float, float] | None


@dataclass(frozen=True, slots=True)
class MagnitudeAnalysis:
    """The analysis of magnitude estimation; all feedbacks are pooled.

    Attributes:
        options: of the analysis.
        answers: that were analysed.
        means: geometric mean by level, and the number of answers, by sequence.
        exponents: by sequence; empty without two gains at one delay.
        not_positive: number of answers that are zero or below: they have no logarithm.
        missing: number of answers that were not given, or not counted.
    """

    options: AnalysisOptions
    answers: Answers
    means: Mapping[str, Mapping[Level, tuple[float, int]]]
    exponents: Mapping[str, Exponent]
    not_positive: int
    missing: int


def analyse_magnitudes(
    answers: Answers, options: AnalysisOptions | None = None
) -> MagnitudeAnalysis:
    """Analyse the numbers of a study."""
    options = options or AnalysisOptions()
    given = [
        (one, float(one.answer))
        for one in answers.judgements
        if one.answer is not None and (one.is_valid or options.include_invalid)
    ]
    logs = _of_one_scale([(one, value) for one, value in given if value > 0.0])
    if not logs:
        raise InputError("there is no number above 0 to analyse")
    parts = {ALL: logs}
    if len(answers.sequences) > 1:
        parts |= {
            name: [row for row in logs if row[0].sequence == name]
            for name in answers.sequences
        }
    exponents = {name: _exponent(rows, options, name) for name, rows in parts.items()}
    return MagnitudeAnalysis(
        options,
        answers,
        {name: _means(rows) for name, rows in parts.items()},
        {name: one for name, one in exponents.items() if one is not None},
        len(given) - len(logs),
        len(answers.judgements) - len(given),
    )


def _of_one_scale(given: Sequence[_Log]) -> list[_Log]:
    """The logarithms of numbers, moved to one mean."""
    by_person: dict[str, list[float]] = {}
    for one, value in given:
        by_person.setdefault(one.participant, []).append(np.log(value))
    means = {code: float(np.mean(logs)) for code, logs in by_person.items()}
    middle = float(np.mean(list(means.values()))) if means else 0.0
    return [
        (one, float(np.log(value)) - means[one.participant] + middle)
        for one, value in given
    ]


def _means(rows: Sequence[_Log]) -> dict[Level, tuple[float, int]]:
    by_level: dict[Level, list[float]] = {}
    for one, log in rows:
        by_level.setdefault((one.delay_s, one.gain), []).append(log)
    return {
        level: (float(np.exp(np.mean(logs))), len(logs))
        for level, logs in sorted(by_level.items())
    }


def _slope(points: Floats) -> float:
    """The slope of the line through points (N, 2) by least squares."""
    x, y = (points - points.mean(axis=0)).T
    return float(x @ y / (x @ x))


def _exponent(
    rows: Sequence[_Log], options: AnalysisOptions, name: str
) -> Exponent | None:
    by_person: dict[str, list[tuple[float, float]]] = {}
    for one, log in rows:
        if one.gain > 0.0:
            points = by_person.setdefault(one.participant, [])
            points.append((float(np.log(one.gain)), log))
    if len({one.delay_s for one, _ in rows}) != 1:
        return None
    slopes = {
        code: _slope(np.array(points))
        for code, points in by_person.items()
        if len({gain for gain, _ in points}) > 1
    }
    if not slopes:
        return None
    values = np.array(list(slopes.values()))
    interval = None
    if len(values) > 1:
        rng = options.resampling.generator(f"exponent/{name}")
        drawn = rng.choice(values, (options.resampling.count, len(values)))
        low, high = np.quantile(drawn.mean(axis=1), TAILS)
        interval = float(low), float(high)
    return Exponent(slopes, float(values.mean()), interval)
