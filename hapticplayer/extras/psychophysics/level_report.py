"""The analysis of yes-no and two-interval trials as JSON, report and tables."""

from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from hapticplayer.errors import Progress, counted
from hapticplayer.extras.psychophysics.framing import (
    Findings,
    contents,
    few_people,
    summary,
)
from hapticplayer.extras.psychophysics.level_figures import (
    LABELS,
    NAMES,
    STAIRCASES,
    figures,
    words_of,
)
from hapticplayer.extras.psychophysics.levels import (
    ALL,
    MOST_FITS,
    AxisAnalysis,
    Curve,
    LevelAnalysis,
    Share,
    analyse_levels,
)
from hapticplayer.extras.psychophysics.psychometric import MOST_LAPSES
from hapticplayer.extras.psychophysics.staircases import (
    GroupThreshold,
    PersonTrack,
    group_thresholds,
    tracks_of,
)
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.blocks import (
    Heading,
    ReportBlock,
    ReportFigure,
    ReportTable,
)
from hapticplayer.study.analysis.figures import marked
from hapticplayer.study.analysis.methods import computed_with, invalid_text
from hapticplayer.study.analysis.parts import ReportParts
from hapticplayer.study.analysis.references import (
    EFRON_1993,
    LEVITT_1971,
    SCHNEIDER_2003,
    WETHERILL_1965,
    WICHMANN_2001,
    WILSON_1927,
    YARROW_2011,
)
from hapticplayer.study.analysis.statistic import (
    interval,
    number,
    p_value,
    plain,
    rounded,
)
from hapticplayer.study.answers import Answers, simulated_mark
from hapticplayer.study.intervals import converges_to

AXIS_NAMES = {"delay_s": "time shift", "gain": "gain"}
_ALPHA, _LOW_PEAK = 0.05, 0.75

_ASSUMPTIONS = (
    (
        "Shares pool all answers to a level; their Wilson intervals assume independent "
        "answers and are too narrow if a participant answered several times."
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
_OF_CRITERIA = (
    "Curves assume that what is perceived of a change has normal noise and is answered "
    "with yes between two criteria: a force may come too early or too late, be too weak "
    "or too strong, and the two criteria need not be alike. A bell curve with one "
    "centre and width could not show this. If only one side was tested there is one "
    "criterion. "
    "At a criterion half of the answers are yes, if the window is wide against the "
    "spread. Up to 10 % of the answers may be at random (lapse). Gains count as ratios."
)
_OF_DIFFERENCES = (
    "Curves assume that the difference of the two plays has normal noise: the threshold "
    "is the change that is chosen in 75 % of the trials, 0.674 of the spread. With changes "
    "of one sign two plays that do not differ are chosen by half each, and the question "
    "asks for that change; with both signs the curve has a point of equality. Up to 10 % "
    "of the answers may be at random (lapse). Gains count as ratios, thresholds of gains "
    "are factors."
)
_OF_STAIRCASES = (
    "The threshold of a staircase is the geometric mean of its last reversals (at most "
    "eight, not the first two), about where {share} % are correct. It is too large by "
    "a tenth or more where a staircase has few trials or begins far from it: the curve "
    "of all answers is the better estimate of the group. Trials that were not valid do "
    "not move a staircase."
)


def analysed(
    answers: Answers, options: AnalysisOptions | None, progress: Progress
) -> ReportParts:
    found = analyse_levels(answers, options, progress)
    mark = simulated_mark(answers.participants)
    tracks = list(tracks_of(answers))
    groups = list(group_thresholds(tracks, found.options))
    findings = _findings(found, tracks, groups)
    return ReportParts(
        answers,
        mark,
        rounded(
            {**_summary(found, groups), **summary(answers, found.options, findings)}
        ),
        (*_lines(found), *map(_group_line, groups)),
        tuple(contents(answers, found.options, findings)),
        lambda: marked(figures(found, tracks), mark),
        {**tables(found), **_track_tables(tracks)},
    )


def _lines(found: LevelAnalysis) -> Iterator[str]:
    for axis, one in found.axes.items():
        for sequence, curve in one.curves.items():
            if curve is not None:
                values = (f"{name} {number(v)}" for name, v in curve.values.items())
                yield f"{axis} {sequence}: {', '.join(values)}"
    for name, share in found.feedbacks.items():
        yield f"{name}: chosen in {share.yes} of {share.asked}"


def _group_line(one: GroupThreshold) -> str:
    return (
        f"staircase {one.sequence} {one.feedback}: threshold {number(one.mean)}, "
        f"95 % CI {interval(one.interval)}, {counted(one.count, 'participant')}"
    )


def _summary(found: LevelAnalysis, groups: list[GroupThreshold]) -> dict[str, Any]:
    """The analysis as JSON; undefined values are None."""
    return {
        "levels": {axis: _axis(one) for axis, one in found.axes.items()},
        "mixed_levels": [plain(asdict(one)) for one in found.mixed],
        "feedbacks": {k: plain(asdict(one)) for k, one in found.feedbacks.items()},
        "staircases": [plain(asdict(one)) for one in groups],
        "missing": {
            "participants": len(found.participants),
            "answers_planned": found.planned,
            "answers_missing": found.missing,
            "of_these_invalid": found.invalid,
        },
    }


def _findings(
    found: LevelAnalysis, tracks: list[PersonTrack], groups: list[GroupThreshold]
) -> Findings:
    answers, rule = found.answers, found.answers.staircase
    curve = _OF_CRITERIA if answers.standard is None else _OF_DIFFERENCES
    of_staircase = (
        ()
        if rule is None
        else (_OF_STAIRCASES.format(share=f"{100.0 * converges_to(rule):.0f}"),)
    )
    return Findings(
        f"{counted(len(found.participants), 'participant')}; {found.missing} of "
        f"{found.planned} answers are missing ({found.invalid} because the "
        "playback was not valid).",
        [*warnings_of(found), *_track_warnings(tracks)],
        tuple(_methods(found)),
        tuple(_results(found, tracks, groups)),
        (_ASSUMPTIONS[0], curve, *_ASSUMPTIONS[1:], *of_staircase),
        (
            *(EFRON_1993, LEVITT_1971, SCHNEIDER_2003, WETHERILL_1965),
            *(WICHMANN_2001, WILSON_1927, YARROW_2011),
        ),
    )


def _methods(analysis: LevelAnalysis) -> Iterator[str]:
    resamples = min(analysis.options.resampling.count, MOST_FITS)
    if analysis.answers.standard is None:
        asked = (
            "Participants answered a yes-no question about a shifted or scaled force."
        )
        curve = (
            "Psychometric curves with independent criteria (Schneider and Bavelier, 2003; "
            "Yarrow et al., 2011)"
        )
    else:
        asked = (
            "Participants chose one of two plays of a clip, with the standard and another "
            "force, in random order (two-interval forced choice)."
        )
        curve = "Cumulative normal curves of the difference"
    if (rule := analysis.answers.staircase) is not None:
        asked += (
            f" Levels followed a {rule.correct}-down 1-up staircase (Levitt, 1971), which "
            f"converges to {100.0 * converges_to(rule):.1f} % correct; thresholds are means of "
            "reversals (Wetherill and Levitt, 1965)."
        )
    yield (
        f"{asked} {invalid_text(analysis.options)} Shares of answers have Wilson intervals "
        f"(Wilson, 1927). {curve} and a lapse rate of at most "
        f"{100.0 * MOST_LAPSES:.0f} % (Wichmann and Hill, 2001) were fitted by maximum likelihood; "
        f"intervals (95 %) are percentile bootstrap intervals of {resamples} resamples of "
        "the participants (Efron and Tibshirani, 1993; none where all resamples agree). "
        f"The fit was tested by its deviance among {resamples} simulated ones. "
        f"{computed_with(analysis.options)}"
    )


def _results(
    found: LevelAnalysis, tracks: list[PersonTrack], groups: list[GroupThreshold]
) -> Iterator[ReportBlock]:
    if groups:
        yield from _staircase_blocks(found, tracks, groups)
    if found.feedbacks:
        yield Heading("Choices between feedbacks")
        standard = found.answers.standard
        shares = tuple(
            (
                name,
                f"{one.yes} of {one.asked}",
                number(one.share),
                interval(one.interval),
            )
            for name, one in found.feedbacks.items()
        )
        of = standard.feedback if standard else ""
        head = ("feedback", "chosen", "share", "95 % CI")
        yield ReportTable(f"Chosen against {of}", head, shares)
    for axis, one in found.axes.items():
        yield from _axis_blocks(found, axis, one)
    if found.mixed:
        title = "Delay and gain changed together"
        yield _share_table(title, words_of(found).key, found.mixed)


def _staircase_blocks(
    found: LevelAnalysis, tracks: list[PersonTrack], groups: list[GroupThreshold]
) -> Iterator[ReportBlock]:
    yield Heading("Staircases")
    caption = "Changes that the staircases of all participants went through."
    shown = ", ".join(
        f"{one.participant} {number(one.track.threshold)}" for one in tracks
    )
    yield ReportFigure(STAIRCASES, caption, f"Thresholds: {shown}.")
    rows = tuple(
        (
            *(one.sequence, one.feedback, str(one.count), number(one.mean)),
            *(number(one.sd), interval(one.interval)),
        )
        for one in groups
    )
    changed = found.answers.staircase.changes if found.answers.staircase else ""
    head = ("sequence", "feedback", "participants", "threshold", "SD", "95 % CI")
    yield ReportTable(
        f"Thresholds of {changed}, as a change of the standard", head, rows
    )


def _track_warnings(tracks: list[PersonTrack]) -> Iterator[str]:
    short = [one.participant for one in tracks if one.track.threshold is None]
    if short:
        yield f"{len(short)} staircases have too few reversals for a threshold."


def _track_tables(tracks: list[PersonTrack]) -> dict[str, list[list[Any]]]:
    if not tracks:
        return {}
    head = ["participant", "sequence", "feedback", "threshold", "reversals"]
    rows = [
        [
            *(one.participant, one.sequence, one.feedback),
            *(one.track.threshold, len(one.track.reversals)),
        ]
        for one in tracks
    ]
    return {"staircases.csv": [head, *rows]}


def _axis_blocks(
    found: LevelAnalysis, axis: str, one: AxisAnalysis
) -> Iterator[ReportBlock]:
    name, words = AXIS_NAMES[axis], words_of(found)
    yield Heading(f"Answers by {name}")
    shares = ", ".join(
        f"{getattr(share, axis):g}: {number(share.share)}" for share in one.shares[ALL]
    )
    caption = f"{words.share.capitalize()} by {name}, all sequences."
    text = f"{words.share.capitalize()} by {LABELS[axis]}. {shares}."
    yield ReportFigure(f"{words.key}-{NAMES[axis]}", caption, text)
    rows = tuple(
        _curve_row(k, c, words.values) for k, c in one.curves.items() if c is not None
    )
    yield ReportTable(
        f"Curves by {LABELS[axis]}",
        ("sequence", *(h for v in words.values for h in (v, "95 % CI")), "lapse", "p"),
        rows,
        "CI: confidence interval, by bootstrap; -: all resamples agree (at a bound of "
        "the fit). p: of the deviance from the curve.",
    )
    for sequence, parts in one.shares.items():
        title = f"{words.share.capitalize()} by {name}, {sequence}"
        yield _share_table(title, words.key, parts)


def tables(analysis: LevelAnalysis) -> dict[str, list[list[Any]]]:
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


def warnings_of(analysis: LevelAnalysis) -> list[str]:
    """Return warnings about missing data and unreliable curves."""
    warned = list(few_people(analysis.answers))
    if analysis.missing:
        warned.append(
            f"{analysis.missing} of {analysis.planned} answers are missing, "
            f"{analysis.invalid} of them because the playback was not valid."
        )
    if analysis.mixed:
        warned.append(
            f"{len(analysis.mixed)} levels change delay and gain together; they are not on a "
            "curve."
        )
    if not analysis.axes and not analysis.feedbacks:
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
        for name in ("lower", "upper", "equal")
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
            f"even at its centre only {100.0 * values['peak']:.0f} % of the answers are yes; at "
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


def _curve_row(name: str, curve: Curve, values: Sequence[str]) -> tuple[str, ...]:
    cells = [
        cell
        for value in values
        for cell in (
            number(curve.values.get(value)),
            interval(curve.intervals.get(value)),
        )
    ]
    return name, *cells, number(curve.values["lapse"]), p_value(curve.p_fit)


def _share_table(title: str, answer: str, shares: tuple[Share, ...]) -> ReportTable:
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
    return ReportTable(title, ("delay, s", "gain", answer, "share", "95 % CI"), rows)


def _share_row(sequence: str, one: Share) -> list[Any]:
    *counted, between = asdict(one).values()
    return [sequence, *counted, *(between or (None, None))]
