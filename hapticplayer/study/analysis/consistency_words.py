"""What the curves assume, and where they do not hold, in words."""

from collections.abc import Iterator

import numpy as np

from hapticplayer.study.analysis.consistency import (
    AxisAnalysis,
    ConsistencyAnalysis,
    Curve,
)
from hapticplayer.study.analysis.psychometric import MOST_LAPSES

AXIS_NAMES = {"delay_s": "time shift", "gain": "gain"}
_ALPHA, _LOW_PEAK, _FEW = 0.05, 0.75, 6

ASSUMPTIONS = (
    (
        "Shares",
        (
            "count all answers of a level; their Wilson intervals take answers as "
            "independent, and are too narrow where one participant answered several times."
        ),
    ),
    (
        "Curves",
        (
            "assume that what is perceived of a change has normal noise and is felt as "
            "consistent between two criteria: a force may come too early or too late, be "
            "too weak or too strong, and the two criteria need not be alike. A bell with "
            "one centre and width would force them to be. Where only one side was tried "
            "there is one criterion. At a criterion half of the answers are yes, if the "
            "window is wide against the spread. Up to 10 % of the answers may be at random "
            "(lapse). Gains count as ratios."
        ),
    ),
    (
        "Participants",
        (
            "are counted together: the spread holds their differences as well as the noise "
            "of each. Intervals are bootstrap intervals over participants, each with all "
            "answers; they are too narrow for few of them."
        ),
    ),
    (
        "Fit",
        (
            "is judged by the deviance, compared with that of answers drawn from the fitted "
            "curve. A large p is no proof that the curve is right."
        ),
    ),
)


def warnings_of(analysis: ConsistencyAnalysis) -> list[str]:
    """Return where something does not hold, is missing or cannot be told."""
    told = list(analysis.remarks)
    if analysis.missing:
        told.append(
            f"{analysis.missing} of {analysis.planned} answers are missing, "
            f"{analysis.unsound} of them because the playback was not sound."
        )
    if len(analysis.participants) < _FEW:
        told.append(
            f"There are {len(analysis.participants)} participants: intervals are too "
            "narrow, and say little about other people."
        )
    if len(analysis.feedbacks) > 1:
        told.append("Answers to all feedbacks are counted together.")
    if analysis.mixed:
        told.append(
            f"{len(analysis.mixed)} levels change time and gain at once; they are on no "
            "curve."
        )
    if not analysis.axes:
        told.append("Nothing was changed by more than one amount: there is no curve.")
    for axis in analysis.axes.values():
        for name, curve in axis.curves.items():
            lead = f"{AXIS_NAMES[axis.axis]}, {name}: "
            told += [lead + text for text in _curve(axis, curve)]
    return told


def _curve(axis: AxisAnalysis, curve: Curve | None) -> Iterator[str]:
    if curve is None:
        yield "there are too few levels for a curve."
        return
    if curve.is_flat:
        yield (
            "the shares of the levels do not differ significantly; the curve and its "
            "criteria mean nothing."
        )
    if curve.p_fit < _ALPHA:
        yield (
            f"the curve does not fit (deviance {curve.deviance:.1f}, p = "
            f"{curve.p_fit:.3f}): read the shares, not the criteria."
        )
    values = curve.values
    outside = [
        name
        for name in ("lower", "upper")
        if name in values and not axis.levels[0] <= values[name] <= axis.levels[-1]
    ]
    if outside:
        yield f"{' and '.join(outside)}: beyond the levels that were tried."
    if bool(np.any(curve.fits.is_steep)):
        yield (
            "the flanks lie between two levels; where exactly, and how steep they are, "
            "only levels in between could tell."
        )
    if values.get("peak", 1.0) < _LOW_PEAK:
        yield (
            f"even at its centre only {values['peak']:.0%} of the answers are yes; at "
            "the criteria it is less than half."
        )
    if values["lapse"] > 0.99 * MOST_LAPSES:
        yield "as many answers as allowed are at random; the spread is hard to tell."
