"""The analysis of consistency as JSON, as a report, as tables and figures."""

import dataclasses
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.study.analysis.consistency import (
    ALL,
    AxisAnalysis,
    ConsistencyAnalysis,
    Curve,
    Share,
    position,
)
from hapticplayer.study.analysis.consistency_words import (
    ASSUMPTIONS,
    AXIS_NAMES,
    warnings_of,
)
from hapticplayer.study.analysis.contents import (
    Block,
    Heading,
    Picture,
    Table,
    Words,
    made_with,
)
from hapticplayer.study.analysis.figures import SIZE_IN, settings
from hapticplayer.study.analysis.statistic import interval, number, p_value

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FIGURES = {"delay_s": "consistency-by-time-shift", "gain": "consistency-by-gain"}
_LABELS = {"delay_s": "force later than picture (s)", "gain": "gain of the force"}
_VALUES = ("lower", "upper", "centre", "window", "spread", "lapse", "peak")
_INK, _CURVE, _PERSON = "#222222", "#0072b2", "#999999"


def summary(analysis: ConsistencyAnalysis) -> dict[str, Any]:
    """Return everything that was found; what is not defined is None."""
    return {
        "consistency": {axis: _axis(one) for axis, one in analysis.axes.items()},
        "mixed_levels": [_plain_share(one) for one in analysis.mixed],
        "missing": {
            "participants": len(analysis.participants),
            "answers_planned": analysis.planned,
            "answers_missing": analysis.missing,
            "of_these_not_sound": analysis.unsound,
        },
        "warnings": warnings_of(analysis),
        "provenance": analysis.choices.provenance(),
    }


def contents(analysis: ConsistencyAnalysis) -> Iterator[Block]:
    """Yield the parts of the report."""
    yield Heading("Participants and answers")
    yield Words(
        f"{len(analysis.participants)} participants; {analysis.missing} of "
        f"{analysis.planned} answers are missing ({analysis.unsound} because the "
        "playback was not sound)."
    )
    yield Heading("Where care is needed")
    for text in warnings_of(analysis) or ["Nothing speaks against the curves below."]:
        yield Words(text)
    for axis, one in analysis.axes.items():
        name = AXIS_NAMES[axis]
        yield Heading(f"Consistency by {name}")
        yield Picture(_FIGURES[axis], f"Share felt as consistent by {name}")
        rows = tuple(_curve_row(k, c) for k, c in one.curves.items() if c is not None)
        yield Table(
            f"Curves by {name}; intervals of 95 %",
            ("sequence", *(h for v in _VALUES[:5] for h in (v, "95 %")), "lapse", "p"),
            rows,
        )
        for sequence, shares in one.shares.items():
            yield _share_table(f"Felt as consistent, {sequence}", shares)
    if analysis.mixed:
        yield _share_table("Time and gain changed at once", analysis.mixed)
    yield Heading("What this assumes")
    for name, text in ASSUMPTIONS:
        yield Words(text, name)
    yield from made_with(analysis.choices)


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
                curves.append([axis, sequence, name, value, *curve.intervals[name]])
    levels += [_share_row(ALL, share) for share in analysis.mixed]
    return {"levels.csv": levels, "curves.csv": curves}


def figures(analysis: ConsistencyAnalysis) -> dict[str, "Figure"]:
    """Return a figure for each kind of change by name."""
    return {_FIGURES[axis]: _figure(one) for axis, one in analysis.axes.items()}


def _axis(one: AxisAnalysis) -> dict[str, Any]:
    return {
        "levels": {k: [_plain_share(s) for s in v] for k, v in one.shares.items()},
        "curves": {k: _plain_curve(c) for k, c in one.curves.items()},
    }


def _plain_share(one: Share) -> dict[str, Any]:
    between = list(one.interval) if one.interval else None
    return {**dataclasses.asdict(one), "interval": between}


def _plain_curve(curve: Curve | None) -> dict[str, Any] | None:
    if curve is None:
        return None
    return {
        "shape": curve.fits.shape.value,
        **curve.values,
        "intervals": {name: list(pair) for name, pair in curve.intervals.items()},
        "deviance": curve.deviance,
        "p_fit": curve.p_fit,
        "is_flat": curve.is_flat,
    }


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


def _share_table(title: str, shares: tuple[Share, ...]) -> Table:
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
    return Table(title, ("later by, s", "gain", "yes", "share", "95 %"), rows)


def _share_row(sequence: str, one: Share) -> list[Any]:
    between = one.interval or (None, None)
    counted = (one.delay_s, one.gain, one.yes, one.asked, one.share)
    return [sequence, *counted, *between]


def _figure(one: AxisAnalysis) -> "Figure":
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with settings():
        figure = Figure(figsize=SIZE_IN, layout="constrained")
        FigureCanvasAgg(figure)
        panel = figure.subplots()
        for row, values in enumerate(one.by_person):
            label = "one participant" if row == 0 else None
            panel.plot(
                one.levels, values, color=_PERSON, lw=0.7, alpha=0.45, label=label
            )
        _draw_shares(panel, one)
        if (curve := one.curves[ALL]) is not None:
            _draw_curve(panel, one, curve)
        panel.set_xlabel(_LABELS[one.axis])
        panel.set_ylabel("share felt as consistent")
        panel.set_ylim(-0.03, 1.03)
        panel.grid(visible=True, axis="y", color="#dddddd", linewidth=0.6)
        figure.legend(loc="outside upper center", ncols=4, frameon=False)
    return figure


def _draw_shares(panel: "Axes", one: AxisAnalysis) -> None:
    shares = one.shares[ALL]
    at = [getattr(share, one.axis) for share in shares]
    middle = np.array([share.share for share in shares], dtype=float)
    ends = np.array([share.interval for share in shares], dtype=float)
    apart = np.abs(ends.T - middle).clip(0.0)
    panel.errorbar(
        at,
        middle,
        apart,
        fmt="o",
        color=_INK,
        capsize=3,
        label="all, 95 %",
        zorder=4,
    )


def _draw_curve(panel: "Axes", one: AxisAnalysis, curve: Curve) -> None:
    levels = np.linspace(one.levels[0], one.levels[-1], 401)
    p = curve.fits.shares(position(one.axis, levels))[0]
    panel.plot(levels, p, color=_CURVE, lw=2.0, zorder=3, label="fitted curve")
    label: str | None = "criterion, 95 %"
    for name in ("lower", "upper"):
        if name in curve.values:
            low, high = np.clip(curve.intervals[name], one.levels[0], one.levels[-1])
            panel.axvspan(low, high, color=_CURVE, alpha=0.15, lw=0.0)
            at = curve.values[name]
            if one.levels[0] <= at <= one.levels[-1]:
                panel.axvline(at, color=_CURVE, ls="--", lw=1.2, label=label)
                label = None
