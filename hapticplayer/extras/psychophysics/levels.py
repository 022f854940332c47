"""Yes-no and two-interval trials: shares by level, and psychometric curves.

A curve describes the group: the answers of all participants are pooled, so its spread
includes the noise of each person and the differences between persons. Intervals are
percentile bootstrap intervals over participants. Gains are analysed as ratios (natural
logarithm).
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy import stats

from hapticplayer.errors import InputError, Message, Progress
from hapticplayer.extras.psychophysics.psychometric import (
    CurveShape,
    Fits,
    deviance,
    fit,
    shape_of,
)
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.describing import CONFIDENCE, TAILS
from hapticplayer.study.answers import Answers, Judgement
from hapticplayer.study.definition import FeedbackLevel, ForceLevel

ALL = "all"
Axis = Literal["delay_s", "gain"]
Interval = tuple[float, float]
_AXES: tuple[Axis, ...] = ("delay_s", "gain")
MOST_FITS = 1999
JND_Z = float(stats.norm.ppf(0.75))
"""Of the change that is chosen in 75 % of the trials."""
_FEW_PARTICIPANTS = 2
_SAME = 1e-9
_SAME_DEVIANCE = 1e-5  # of fits through all shares: what their last steps leave


@dataclass(frozen=True, slots=True)
class Share:
    """Answers at one level.

    Attributes:
        delay_s: delay of the force, s.
        gain: of the force.
        yes: number of answers "yes", or of choices of this force.
        asked: number of answers.
        share: yes / asked; None without answers.
        interval: Wilson interval, 95 %, for independent answers.
    """

    delay_s: float
    gain: float
    yes: int
    asked: int
    share: float | None
    interval: Interval | None


@dataclass(frozen=True, slots=True)
class Curve:
    """A fitted curve; criteria in s or as a gain, 95 % intervals.

    Attributes:
        fits: one curve, in s or the logarithm of the gain.
        values: "lower", "upper", "centre", "window", "spread", "lapse", "peak", as far
            as the shape has them. For gains the window is upper / lower and the spread
            a factor. Of two intervals "equal", "threshold", "spread" and "lapse".
        intervals: of `values`, by bootstrap; None where all resamples agree, such as
            at a bound of the fit.
        deviance: of the fit from the shares of the levels.
        p_fit: share of simulated fits with at least this deviance.
        is_flat: whether the shares do not differ (G test, 5 %).
    """

    fits: Fits
    values: dict[str, float]
    intervals: dict[str, Interval | None]
    deviance: float
    p_fit: float
    is_flat: bool


@dataclass(frozen=True, slots=True)
class AxisAnalysis:
    """The analysis of one kind of change.

    Attributes:
        axis: the changed quantity.
        levels: in ascending order.
        by_person: shares (P, L) of each participant, NaN without answers.
        shares: by sequence, "all" first.
        curves: by sequence, "all" first; None with too few levels.
    """

    axis: Axis
    levels: Floats
    by_person: Floats
    shares: dict[str, tuple[Share, ...]]
    curves: dict[str, Curve | None]


@dataclass(frozen=True, slots=True)
class LevelAnalysis:
    """The analysis of yes-no and two-interval trials.

    Attributes:
        participants: codes.
        options: of the analysis.
        axes: by changed quantity, "delay_s" or "gain".
        mixed: levels that change both, which are not on a curve.
        planned, missing, invalid: numbers of answers; missing includes invalid.
        answers: that were analysed; all feedbacks are pooled in `axes`.
        feedbacks: shares of the choice of each feedback against the standard's, by
            name, of trials without a change; empty where there was one.
    """

    participants: tuple[str, ...]
    options: AnalysisOptions
    axes: dict[Axis, AxisAnalysis]
    mixed: tuple[Share, ...]
    planned: int
    missing: int
    invalid: int
    answers: Answers
    feedbacks: Mapping[str, Share]


def analyse_levels(
    answers: Answers,
    options: AnalysisOptions | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> LevelAnalysis:
    """Analyse the judgements of a study."""
    options = options or AnalysisOptions()
    counted = [
        one
        for one in answers.judgements
        if one.answer is not None and (one.is_valid or options.include_invalid)
    ]
    if not counted:
        raise InputError("there is no judgement to analyse")
    axes: dict[Axis, AxisAnalysis] = {}
    for place, axis in enumerate(_AXES):
        progress(place / 2.0, Message("fitting {axis}", axis=axis))
        on_axis = [one for one in counted if _is_on(one, axis, answers.standard)]
        if len({getattr(one, axis) for one in on_axis}) > 1:
            axes[axis] = _axis(axis, on_axis, answers, options)
    mixed = [
        one
        for one in counted
        if not any(_is_on(one, axis, answers.standard) for axis in _AXES)
    ]
    return LevelAnalysis(
        tuple(person.code for person in answers.participants),
        options,
        axes,
        _shares(mixed),
        len(answers.judgements),
        len(answers.judgements) - len(counted),
        0
        if options.include_invalid
        else sum(not j.is_valid for j in answers.judgements),
        answers,
        {} if axes or answers.standard is None else _chosen(counted, answers.feedbacks),
    )


def position(axis: Axis, level: Floats, standard: FeedbackLevel | None) -> Floats:
    """Return the positions of levels on a curve; 0 is no change."""
    unchanged = _unchanged(axis, standard)
    with np.errstate(divide="ignore"):
        return np.asarray(
            level - unchanged if axis == "delay_s" else np.log(level / unchanged)
        )


def _unchanged(axis: Axis, standard: FeedbackLevel | None) -> float:
    return float(getattr(standard or ForceLevel(), axis))


def _is_on(one: Judgement, axis: Axis, standard: FeedbackLevel | None) -> bool:
    other: Axis = "gain" if axis == "delay_s" else "delay_s"
    return bool(getattr(one, other) == _unchanged(other, standard))


def _chosen(counted: Sequence[Judgement], feedbacks: Sequence[str]) -> dict[str, Share]:
    by_name = {
        name: _shares(one for one in counted if one.feedback == name)
        for name in feedbacks
    }
    return {name: found[0] for name, found in by_name.items() if len(found) == 1}


def _shares(judged: Iterable[Judgement]) -> tuple[Share, ...]:
    counts: dict[tuple[float, float], list[int]] = {}
    for one in judged:
        counted = counts.setdefault((one.delay_s, one.gain), [0, 0])
        counted[0] += bool(one.answer)
        counted[1] += 1
    return tuple(_share(*level, *counts[level]) for level in sorted(counts))


def _share(delay_s: float, gain: float, yes: int, asked: int) -> Share:
    found = stats.binomtest(yes, asked).proportion_ci(CONFIDENCE, "wilson")
    between = (float(found.low), float(found.high))
    return Share(delay_s, gain, yes, asked, yes / asked, between)


def _axis(
    axis: Axis, judged: list[Judgement], answers: Answers, options: AnalysisOptions
) -> AxisAnalysis:
    levels = np.unique([getattr(one, axis) for one in judged])
    standard = answers.standard
    parts = {ALL: judged}
    if len(answers.sequences) > 1:
        for name in answers.sequences:
            parts[name] = [one for one in judged if one.sequence == name]
    codes = [person.code for person in answers.participants]
    counts = {name: _counts(axis, part, codes, levels) for name, part in parts.items()}
    yes, asked = counts[ALL]
    return AxisAnalysis(
        axis,
        levels,
        np.where(asked > 0, yes / np.maximum(asked, 1), np.nan),
        {name: _shares(part) for name, part in parts.items()},
        {
            name: _curve(axis, levels, *counted, options, (f"{axis}/{name}", standard))
            for name, counted in counts.items()
        },
    )


def _counts(
    axis: Axis, judged: list[Judgement], codes: list[str], levels: Floats
) -> tuple[Floats, Floats]:
    """Return the numbers (P, L) of answers "yes" and of all answers."""
    rows = {code: row for row, code in enumerate(codes)}
    yes, asked = np.zeros((2, len(codes), len(levels)))
    for one in judged:
        cell = rows[one.participant], np.searchsorted(levels, getattr(one, axis))
        asked[cell] += 1.0
        yes[cell] += bool(one.answer)
    return yes, asked


def _curve(
    axis: Axis,
    levels: Floats,
    yes: Floats,
    asked: Floats,
    options: AnalysisOptions,
    of: tuple[str, FeedbackLevel | None],
) -> Curve | None:
    (label, standard), used = of, asked.sum(axis=0) > 0
    x, yes, asked = position(axis, levels[used], standard), yes[:, used], asked[:, used]
    if np.isfinite(x).sum() < 2:
        return None
    shape = shape_of(x) if standard is None else _shape_of_two(x)
    if len(x) < shape.least_levels:
        return None
    rng = options.resampling.generator(f"curve/{label}")
    total_yes, total = yes.sum(axis=0)[None], asked.sum(axis=0)[None]
    found = fit(x, total_yes, total, shape)
    count = min(options.resampling.count, MOST_FITS)
    p = found.shares(x).clip(0.0, 1.0)
    size = (count, len(x))
    drawn_yes = rng.binomial(total.astype(int), p, size).astype(float)
    drawn_asked = np.broadcast_to(total, size)
    drawn = fit(x, drawn_yes, drawn_asked, shape)
    apart = float(deviance(total_yes, total, found)[0])
    simulated = deviance(drawn_yes, drawn_asked, drawn)
    hits = int((simulated >= apart - _SAME_DEVIANCE).sum())
    people = asked.sum(axis=1) > 0
    if people.sum() >= _FEW_PARTICIPANTS:
        n = int(people.sum())
        weights = rng.multinomial(n, np.full(n, 1.0 / n), count).astype(float)
        drawn = fit(x, weights @ yes[people], weights @ asked[people], shape)
    return Curve(
        found,
        {name: float(v[0]) for name, v in _values(axis, found, standard).items()},
        _intervals(_values(axis, drawn, standard)),
        apart,
        (hits + 1) / (count + 1),
        _is_flat(total_yes[0], total[0], shape),
    )


def _shape_of_two(x: Floats) -> CurveShape:
    """Of two intervals: changes of both signs show the point of equality, too."""
    is_of_both = x.min() < 0.0 < x.max()
    return CurveShape.RISING if is_of_both else CurveShape.FROM_HALF


def _values(
    axis: Axis, fits: Fits, standard: FeedbackLevel | None
) -> dict[str, Floats]:
    back: Callable[[Floats], Floats] = np.exp if axis == "gain" else np.asarray
    lower, upper = fits.lower, fits.upper
    if standard is not None:
        apart = {"threshold": back(JND_Z * fits.spread)}
        if fits.shape is CurveShape.RISING:
            unchanged = _unchanged(axis, standard)
            equal = back(lower)
            equal = equal * unchanged if axis == "gain" else equal + unchanged
            apart = {"equal": equal, **apart}
        return {**apart, "spread": back(fits.spread), "lapse": fits.lapse}
    found = {"lower": back(lower), "upper": back(upper)}
    if np.isfinite(lower).all() and np.isfinite(upper).all():
        found |= {"centre": back((lower + upper) / 2.0), "window": back(upper - lower)}
        half = (upper - lower) / (2.0 * fits.spread)
        inside = 2.0 * stats.norm.cdf(half) - 1.0
        found["peak"] = fits.lapse / 2.0 + (1.0 - fits.lapse) * inside
    else:
        known = "lower" if np.isfinite(lower).all() else "upper"
        found = {known: found[known]}
    return {**found, "spread": back(fits.spread), "lapse": fits.lapse}


def _intervals(values: dict[str, Floats]) -> dict[str, Interval | None]:
    ends = {name: np.quantile(v, TAILS) for name, v in values.items()}
    return {
        name: (float(low), float(high)) if high - low > _SAME else None
        for name, (low, high) in ends.items()
    }


def _is_flat(yes: Floats, asked: Floats, shape: CurveShape) -> bool:
    if shape is CurveShape.FROM_HALF:  # a staircase seeks levels of one share
        counts = int(yes.sum()), int(asked.sum())
        at_random = stats.binomtest(*counts, 0.5, alternative="greater")
        return bool(at_random.pvalue >= 1.0 - CONFIDENCE)
    table = np.array([yes, asked - yes])
    if (table.sum(axis=1) == 0.0).any():
        return True
    found = stats.chi2_contingency(table, lambda_="log-likelihood")
    return bool(found.pvalue >= 1.0 - CONFIDENCE)
