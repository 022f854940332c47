"""Ratings over the time of the clips in the report: curves, the force, the model."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
)
from hapticplayer.study.analysis.describing import TAILS
from hapticplayer.study.analysis.figures import (
    DARK,
    SIZE_IN,
    columns_of,
    settings,
)
from hapticplayer.study.analysis.scores import shown_at
from hapticplayer.study.analysis.statistic import interval, number
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import RatingKind
from hapticplayer.study.watched import COURSE_HZ, Course

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Model = dict[str, Any]
"""Of `first_order`."""

_DASHES = ("-", "--", "-.", ":")
_LEAST_SPAN = 0.2
_SHOWN_MOST = 8
"""Feedbacks in a figure; more would hide each other."""
_KEY_TEXT = (
    "Share of the participants who hold the key, with the interval of Wilson (1927); onset: media time of the first press, the "
    "end of the clip where there was none; held_s: time in which it was held."
)
_MODEL = (
    "The mean rating of all clips and feedbacks was fitted by a first-order model: an offset, "
    "and the mismatch of the force after a low pass with the time constant 'lag', times a "
    "gain. Mismatch: force of the recorded motion less the force that was played, absolute "
    "values of the lateral (x) and longitudinal (z) axis, each with a gain of its own, of "
    "which 'lateral' is the share of x (Kolff et al. found 0.66 in a driving simulator). Gain: "
    "both together, in units of the scale for each newton. Explained: share of the variance "
    "of the mean rating. Intervals (95 %) are by bootstrap over participants."
)


def _by_rating(answers: Answers) -> dict[str, list[Course]]:
    found: dict[str, list[Course]] = {}
    for one in answers.courses:
        found.setdefault(one.rating.key, []).append(one)
    return found


def _by_figure(answers: Answers) -> dict[str, list[Course]]:
    """The courses of a rating and sequence, feedbacks in their order."""
    found: dict[str, list[Course]] = {}
    for one in answers.courses:
        name = f"over-time-{one.rating.key}-{one.condition.sequence}"
        found.setdefault(name, []).append(one)
    return {
        name: sorted(each, key=lambda one: shown_at(one.condition.feedback))
        for name, each in found.items()
    }


def mean_with_band(values: Floats) -> tuple[Floats, Floats, Floats]:
    """Mean of (P, T) and its 95 % interval by Student's t; NaN for fewer than two."""
    is_known = ~np.isnan(values)
    count = is_known.sum(axis=0)
    held = np.where(is_known, values, 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = held.sum(axis=0) / count
        left = np.where(is_known, values - mean, 0.0)
        error = np.sqrt((left**2).sum(axis=0) / (count - 1) / count)
        reach = scipy.stats.t.ppf(TAILS[1], np.maximum(count - 1, 1)) * error
    reach = np.where(count > 1, reach, np.nan)
    return mean, mean - reach, mean + reach


def course_with_band(course: Course) -> tuple[Floats, Floats, Floats]:
    """The mean with its band; of a held key the share with the interval of Wilson."""
    mean, low, high = mean_with_band(course.values)
    if course.rating.kind is not RatingKind.HELD_KEY:
        return mean, low, high
    count = (~np.isnan(course.values)).sum(axis=0)
    z = float(scipy.stats.norm.ppf(TAILS[1]))
    with np.errstate(invalid="ignore", divide="ignore"):
        middle = (mean + z**2 / (2.0 * count)) / (1.0 + z**2 / count)
        spread = np.sqrt(mean * (1.0 - mean) / count + (z / (2.0 * count)) ** 2)
        reach = z * spread / (1.0 + z**2 / count)
    return mean, middle - reach, middle + reach


def course_blocks(
    answers: Answers, models: Mapping[str, Model]
) -> Iterator[ReportBlock]:
    """Yield the ratings over time, if there are any.

    Args:
        answers: with courses.
        models: of sliders, by key.
    """
    if not answers.courses:
        return
    yield Heading("Ratings while the clips played")
    if any(one.rating.kind is RatingKind.HELD_KEY for one in answers.courses):
        yield Paragraph(_KEY_TEXT)
    for name, courses in _by_figure(answers).items():
        rating, sequence = courses[0].rating, courses[0].condition.sequence
        has_force = any(one.force_n is not None for one in courses)
        is_key = rating.kind is RatingKind.HELD_KEY
        what = "share who hold the key" if is_key else "mean of the participants"
        beside = "; below, size of the force that was played" if has_force else ""
        yield ReportFigure(
            name,
            f"{rating.key} while {sequence} played: {what} with its 95 % interval{beside}.",
            _described(courses),
        )
    rows = tuple(_model_row(*one) for one in models.items())
    if rows:
        fitted = ("lag, s", "95 % CI", "gain, 1/N", "95 % CI", "lateral", "explained")
        head = ("rating", *fitted, "conditions", "participants")
        yield ReportTable("First-order model of ratings", head, rows, _MODEL)


def _described(courses: Sequence[Course]) -> str:
    """The curves in words: mean at the beginning, middle and end."""
    parts = []
    for one in courses:
        mean = mean_with_band(one.values)[0]
        at = [0, len(mean) // 2, len(mean) - 1]
        texts = ", ".join(f"{one.time_s[i]:.0f} s {number(float(mean[i]))}" for i in at)
        parts.append(f"{one.condition.feedback}: {texts}")
    return f"Curves of means. {'; '.join(parts)}."


def _model_row(key: str, model: Model) -> tuple[str, ...]:
    return (
        key,
        number(model["lag_s"]),
        interval(model["lag_interval"]),
        number(model["gain"]),
        interval(model["gain_interval"]),
        number(model["lateral"]),
        number(model["explained"]),
        str(model["conditions"]),
        str(model["participants"]),
    )


def course_rows(answers: Answers) -> Iterator[list[Any]]:
    """The curves as a table for other programs."""
    head = ["rating", "sequence", "feedback", "media_s", "participants"]
    yield [*head, "mean", "low", "high", "force_x_n", "force_y_n", "force_z_n"]
    for one in answers.courses:
        of = [one.rating.key, one.condition.sequence, one.condition.feedback]
        count = (~np.isnan(one.values)).sum(axis=0)
        force_n = one.force_n if one.force_n is not None else [[None] * 3] * len(count)
        columns = (one.time_s, count, *course_with_band(one), force_n)
        for time_s, people, *values, force in zip(*columns, strict=True):
            numbers = [None if np.isnan(value) else float(value) for value in values]
            forces = [None if value is None else float(value) for value in force]
            yield [*of, round(float(time_s), 3), int(people), *numbers, *forces]


def course_figures(answers: Answers) -> dict[str, "Figure"]:
    """The figures by name."""
    return {name: _drawn(each) for name, each in _by_figure(answers).items()}


def _drawn(courses: Sequence[Course]) -> "Figure":
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    has_force = any(one.force_n is not None for one in courses)
    with settings():
        figure = Figure(figsize=SIZE_IN, layout="constrained")
        FigureCanvasAgg(figure)
        heights = (2.0, 1.0) if has_force else (1.0,)
        panels = figure.subplots(
            len(heights), 1, sharex=True, squeeze=False, height_ratios=heights
        )[:, 0]
        for panel in panels:
            panel.grid(visible=True, axis="y", color="#dddddd", linewidth=0.6)
        for place, one in enumerate(courses[:_SHOWN_MOST]):
            style = {"color": DARK[place % len(DARK)]}
            style["linestyle"] = _DASHES[place % len(_DASHES)]
            mean, low, high = course_with_band(one)
            label = one.condition.feedback
            panels[0].plot(one.time_s, mean, label=label, linewidth=1.4, **style)
            panels[0].fill_between(
                one.time_s, low, high, color=style["color"], alpha=0.18, linewidth=0.0
            )
            if one.force_n is not None:
                size_n = np.linalg.norm(one.force_n, axis=1)
                panels[1].plot(one.time_s, size_n, linewidth=0.8, **style)
        panels[0].set_ylabel(_label(courses[0]))
        panels[0].set_ylim(*_limits(courses))
        panels[-1].set_xlabel("time of the clip, s")
        panels[-1].set_xlim(0.0, max(float(one.time_s[-1]) for one in courses))
        if has_force:
            panels[1].set_ylabel("force, N")
            panels[1].set_ylim(bottom=0.0)
        labels = [one.condition.feedback for one in courses[:_SHOWN_MOST]]
        figure.legend(
            loc="outside upper center", ncols=columns_of(labels), frameon=False
        )
    return figure


def _label(course: Course) -> str:
    rating = course.rating
    if rating.kind is RatingKind.HELD_KEY:
        return f"{rating.key}, share who hold"
    return f"{rating.key} ({rating.least} to {rating.most})"


def _limits(courses: Sequence[Course]) -> tuple[float, float]:
    """Ends of the axis: those of the curves and bands, at least a fifth of the scale."""
    rating = courses[0].rating
    is_key = rating.kind is RatingKind.HELD_KEY
    least, most = (
        (0.0, 1.0) if is_key else (float(rating.least or 0), float(rating.most or 0))
    )
    shown = np.concatenate([np.ravel(course_with_band(one)) for one in courses])
    shown = np.clip(shown[np.isfinite(shown)], least, most)
    low, high = (
        (shown.min(), shown.max()) if len(shown) and not is_key else (least, most)
    )
    short = max(0.0, _LEAST_SPAN * (most - least) - (high - low))
    low = max(least, low - short / 2.0)
    high = min(most, max(high, low + _LEAST_SPAN * (most - least)))
    margin = 0.03 * (high - low)
    return float(low - margin), float(high + margin)


def course_summary(answers: Answers, models: Mapping[str, Model]) -> dict[str, Any]:
    """The ratings over time as JSON, by rating; `courses.csv` has the curves."""
    return {
        key: {
            "kind": courses[0].rating.kind.value,
            "conditions": len(courses),
            "rate_hz": COURSE_HZ,
            "first_order": models.get(key),
        }
        for key, courses in _by_rating(answers).items()
    }
