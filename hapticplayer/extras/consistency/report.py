"""The analysis of consistency trials as JSON, report and tables."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any

import numpy as np

from hapticplayer.errors import Progress
from hapticplayer.extras.consistency.analysis import (
    ALL,
    MOST_FITS,
    AxisAnalysis,
    ConsistencyAnalysis,
    Curve,
    Share,
    analyse_consistency,
)
from hapticplayer.extras.consistency.figures import LABELS, NAMES, figures
from hapticplayer.extras.consistency.psychometric import MOST_LAPSES
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
    numbered,
)
from hapticplayer.study.analysis.conduct_report import (
    feedback_conditions,
    identity,
    order_balance,
    people,
    playback,
)
from hapticplayer.study.analysis.contents import reproducibility
from hapticplayer.study.analysis.figures import marked
from hapticplayer.study.analysis.methods import computed_with, invalid_text, references
from hapticplayer.study.analysis.parts import ReportParts
from hapticplayer.study.analysis.question_report import question_summary
from hapticplayer.study.analysis.references import (
    EFRON_1993,
    SCHNEIDER_2003,
    WICHMANN_2001,
    WILSON_1927,
    YARROW_2011,
)
from hapticplayer.study.analysis.scale_report import scale_summary
from hapticplayer.study.analysis.statistic import (
    interval,
    number,
    p_value,
    plain,
    rounded,
)
from hapticplayer.study.analysis.trial_force_report import (
    trial_force_blocks,
    trial_force_summary,
)
from hapticplayer.study.answers import Answers, simulated_mark

_VALUES = ("lower", "upper", "centre", "window", "spread", "lapse", "peak")
AXIS_NAMES = {"delay_s": "time shift", "gain": "gain"}
_ALPHA, _LOW_PEAK, _FEW = 0.05, 0.75, 6

ASSUMPTIONS = (
    (
        "Shares pool all answers to a level; their Wilson intervals assume independent "
        "answers and are too narrow if a participant answered several times."
    ),
    (
        "Curves assume that what is perceived of a change has normal noise and is felt as "
        "consistent between two criteria: a force may come too early or too late, be too weak "
        "or too strong, and the two criteria need not be alike. A bell curve with one "
        "centre and width could not show this. If only one side was tested there is one "
        "criterion. "
        "At a criterion half of the answers are yes, if the window is wide against the "
        "spread. Up to 10 % of the answers may be at random (lapse). Gains count as ratios."
    ),
    (
        "Participants are pooled: the spread includes their differences and the noise of "
        "each. Intervals are bootstrap intervals over participants; they are too narrow for "
        "few participants."
    ),
    (
        "The fit is tested by its deviance, compared with that of answers simulated from the "
        "fitted curve. A large p does not prove the curve."
    ),
)


def analysed(
    answers: Answers, options: AnalysisOptions | None, progress: Progress
) -> ReportParts:
    found = analyse_consistency(answers, options, progress)
    mark = simulated_mark(answers.participants)
    return ReportParts(
        answers,
        mark,
        rounded(summary(found)),
        tuple(_lines(found)),
        tuple(contents(found)),
        lambda: marked(figures(found), mark),
        tables(found),
    )


def _lines(found: ConsistencyAnalysis) -> Iterator[str]:
    for axis, one in found.axes.items():
        for sequence, curve in one.curves.items():
            if curve is not None:
                values = (f"{name} {number(v)}" for name, v in curve.values.items())
                yield f"{axis} {sequence}: {', '.join(values)}"


def summary(analysis: ConsistencyAnalysis) -> dict[str, Any]:
    """Return the analysis as JSON; undefined values are None."""
    return {
        "consistency": {axis: _axis(one) for axis, one in analysis.axes.items()},
        "mixed_levels": [plain(asdict(one)) for one in analysis.mixed],
        "missing": {
            "participants": len(analysis.participants),
            "answers_planned": analysis.planned,
            "answers_missing": analysis.missing,
            "of_these_invalid": analysis.invalid,
        },
        "scales": scale_summary(analysis.answers),
        "questions": question_summary(analysis.answers),
        "felt": trial_force_summary(analysis.answers),
        "warnings": warnings_of(analysis),
        "provenance": analysis.options.provenance(),
    }


def contents(analysis: ConsistencyAnalysis) -> Iterator[ReportBlock]:
    """Yield the parts of the report, with numbers of tables and figures."""
    yield from numbered(_contents(analysis))


def _contents(analysis: ConsistencyAnalysis) -> Iterator[ReportBlock]:
    yield from identity(analysis.answers)
    yield from people(analysis.answers)
    yield from feedback_conditions(analysis.answers)
    yield from order_balance(analysis.answers)
    yield Heading("Answers")
    yield Paragraph(
        f"{len(analysis.participants)} participants; {analysis.missing} of "
        f"{analysis.planned} answers are missing ({analysis.invalid} because the "
        "playback was not valid)."
    )
    yield Heading("Warnings")
    for text in warnings_of(analysis) or ["No warnings."]:
        yield Paragraph(text)
    described = tuple(_methods(analysis))
    yield from described
    for axis, one in analysis.axes.items():
        yield from _axis_blocks(axis, one)
    if analysis.mixed:
        yield _share_table("Delay and gain changed together", analysis.mixed)
    yield from playback(analysis.answers, analysis.answers.feedbacks)
    yield from trial_force_blocks(analysis.answers, analysis.answers.feedbacks)
    yield Heading("Assumptions")
    for text in ASSUMPTIONS:
        yield Paragraph(text)
    works = (EFRON_1993, SCHNEIDER_2003, WICHMANN_2001, WILSON_1927, YARROW_2011)
    yield from references(works, described)
    yield from reproducibility(analysis.options)


def _methods(analysis: ConsistencyAnalysis) -> Iterator[ReportBlock]:
    resamples = min(analysis.options.resampling.count, MOST_FITS)
    yield Heading("Methods")
    yield Paragraph(
        "Participants answered whether a shifted or scaled force was consistent with the "
        f"video. {invalid_text(analysis.options)} Shares of answers have Wilson intervals "
        "(Wilson, 1927). Psychometric curves with independent criteria (Schneider and "
        "Bavelier, 2003; Yarrow et al., 2011) and a lapse rate of at most "
        f"{MOST_LAPSES:.0%} (Wichmann and Hill, 2001) were fitted by maximum likelihood; "
        f"intervals (95 %) are percentile bootstrap intervals of {resamples} resamples of "
        "the participants (Efron and Tibshirani, 1993; none where all resamples agree). "
        f"The fit was tested by its deviance among {resamples} simulated ones. "
        f"{computed_with(analysis.options)}"
    )


def _axis_blocks(axis: str, one: AxisAnalysis) -> Iterator[ReportBlock]:
    name = AXIS_NAMES[axis]
    yield Heading(f"Consistency by {name}")
    shares = ", ".join(
        f"{getattr(share, axis):g}: {number(share.share)}" for share in one.shares[ALL]
    )
    caption = f"Share felt as consistent by {name}, all sequences."
    text = f"Shares of consistent answers by {LABELS[axis]}. {shares}."
    yield ReportFigure(NAMES[axis], caption, text)
    rows = tuple(_curve_row(k, c) for k, c in one.curves.items() if c is not None)
    yield ReportTable(
        f"Curves by {name}",
        ("sequence", *(h for v in _VALUES[:5] for h in (v, "95 % CI")), "lapse", "p"),
        rows,
        "CI: confidence interval, by bootstrap; -: all resamples agree (at a bound of "
        "the fit). p: of the deviance from the curve.",
    )
    for sequence, parts in one.shares.items():
        yield _share_table(f"Felt as consistent by {name}, {sequence}", parts)


def tables(analysis: ConsistencyAnalysis) -> dict[str, list[list[Any]]]:
    """Return the rows of `levels.csv` and `curves.csv`."""
    levels: list[list[Any]] = [
        ["sequence", "delay_s", "gain", "yes", "asked", "share", "low", "high"]
    ]
    curves: list[list[Any]] = [["axis", "sequence", "value", "estimate", "low", "high"]]
    for axis, one in analysis.axes.items():
        for sequence, shares in one.shares.items():
            levels += [_share_row(sequence, share) for share in shares]
        for sequence, curve in one.curves.items():
            for name, value in (curve.values if curve else {}).items():
                assert curve is not None
                ends = curve.intervals[name] or (None, None)
                curves.append([axis, sequence, name, value, *ends])
    levels += [_share_row(ALL, share) for share in analysis.mixed]
    return {"levels.csv": levels, "curves.csv": curves}


def warnings_of(analysis: ConsistencyAnalysis) -> list[str]:
    """Return warnings about missing data and unreliable curves."""
    warned = list(analysis.answers.notices)
    if analysis.missing:
        warned.append(
            f"{analysis.missing} of {analysis.planned} answers are missing, "
            f"{analysis.invalid} of them because the playback was not valid."
        )
    if len(analysis.participants) < _FEW:
        warned.append(
            f"There are {len(analysis.participants)} participants: intervals are too "
            "narrow and do not generalise."
        )
    if len(analysis.answers.feedbacks) > 1:
        warned.append("Answers to all feedbacks are pooled.")
    if analysis.mixed:
        warned.append(
            f"{len(analysis.mixed)} levels change delay and gain together; they are not on a "
            "curve."
        )
    if not analysis.axes:
        warned.append("There is only one level of each change, hence no curve.")
    for axis in analysis.axes.values():
        for name, curve in axis.curves.items():
            lead = f"{AXIS_NAMES[axis.axis]}, {name}: "
            warned += [lead + text for text in _curve_warnings(axis, curve)]
    return warned


def _curve_warnings(axis: AxisAnalysis, curve: Curve | None) -> Iterator[str]:
    if curve is None:
        yield "too few levels for a curve."
        return
    if curve.is_flat:
        yield (
            "the shares of the levels do not differ significantly; the curve and its "
            "criteria are meaningless."
        )
    if curve.p_fit < _ALPHA:
        yield (
            f"the curve does not fit (deviance {curve.deviance:.1f}, p = "
            f"{curve.p_fit:.3f}): use the shares, not the criteria."
        )
    values = curve.values
    outside = [
        name
        for name in ("lower", "upper")
        if name in values and not axis.levels[0] <= values[name] <= axis.levels[-1]
    ]
    if outside:
        yield f"{' and '.join(outside)}: beyond the tested levels."
    if bool(np.any(curve.fits.is_steep)):
        yield (
            "a flank lies between two levels; its position and slope "
            "need levels in between."
        )
    if values.get("peak", 1.0) < _LOW_PEAK:
        yield (
            f"even at its centre only {values['peak']:.0%} of the answers are yes; at "
            "the criteria it is less than half."
        )
    if values["lapse"] > 0.99 * MOST_LAPSES:
        yield "the share of random answers is at its limit; the spread is unreliable."


def _axis(one: AxisAnalysis) -> dict[str, Any]:
    return {
        "levels": {k: [plain(asdict(s)) for s in v] for k, v in one.shares.items()},
        "curves": {k: _plain_curve(c) for k, c in one.curves.items()},
    }


def _plain_curve(curve: Curve | None) -> dict[str, Any] | None:
    if curve is None:
        return None
    found = {
        "shape": curve.fits.shape.value,
        **curve.values,
        "intervals": curve.intervals,
        "deviance": curve.deviance,
        "p_fit": curve.p_fit,
        "is_flat": curve.is_flat,
    }
    return {name: plain(value) for name, value in found.items()}


def _curve_row(name: str, curve: Curve) -> tuple[str, ...]:
    cells = [
        cell
        for value in _VALUES[:5]
        for cell in (
            number(curve.values.get(value)),
            interval(curve.intervals.get(value)),
        )
    ]
    return name, *cells, number(curve.values["lapse"]), p_value(curve.p_fit)


def _share_table(title: str, shares: tuple[Share, ...]) -> ReportTable:
    rows = tuple(
        (
            number(one.delay_s, 3),
            number(one.gain),
            f"{one.yes} of {one.asked}",
            number(one.share),
            interval(one.interval),
        )
        for one in shares
    )
    return ReportTable(title, ("delay, s", "gain", "yes", "share", "95 % CI"), rows)


def _share_row(sequence: str, one: Share) -> list[Any]:
    *counted, between = asdict(one).values()
    return [sequence, *counted, *(between or (None, None))]
