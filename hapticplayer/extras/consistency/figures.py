"""The figures of consistency trials: shares, curves and criteria."""

from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.extras.consistency.analysis import (
    ALL,
    AxisAnalysis,
    ConsistencyAnalysis,
    Curve,
    position,
)
from hapticplayer.study.analysis.figures import draw_lines, new_panel

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NAMES = {"delay_s": "consistency-by-time-shift", "gain": "consistency-by-gain"}
LABELS = {
    "delay_s": "delay of the force against the video (s)",
    "gain": "gain of the force",
}
_INK, _CURVE, _PERSON = "#222222", "#0072b2", "#999999"


def figures(analysis: ConsistencyAnalysis) -> dict[str, "Figure"]:
    return {NAMES[axis]: _figure(one) for axis, one in analysis.axes.items()}


def _figure(one: AxisAnalysis) -> "Figure":
    with new_panel("share felt as consistent") as (figure, panel):
        style: dict[str, Any] = {"color": _PERSON, "linewidth": 0.7, "alpha": 0.45}
        label = "one participant"
        draw_lines(panel, one.levels, one.by_person, label=label, **style)
        _draw_shares(panel, one)
        if (curve := one.curves[ALL]) is not None:
            _draw_curve(panel, one, curve)
        panel.set_xlabel(LABELS[one.axis])
        panel.set_ylim(-0.03, 1.03)
        figure.legend(loc="outside upper center", ncols=4, frameon=False)
    return figure


def _draw_shares(panel: "Axes", one: AxisAnalysis) -> None:
    shares = one.shares[ALL]
    at = [getattr(share, one.axis) for share in shares]
    middle = np.array([share.share for share in shares], dtype=float)
    ends = np.array([share.interval for share in shares], dtype=float)
    apart = np.abs(ends.T - middle).clip(0.0)
    style: dict[str, Any] = {"fmt": "o", "color": _INK, "capsize": 3, "zorder": 4}
    panel.errorbar(at, middle, apart, label="all, 95 %", **style)


def _draw_curve(panel: "Axes", one: AxisAnalysis, curve: Curve) -> None:
    levels = np.linspace(one.levels[0], one.levels[-1], 401)
    p = curve.fits.shares(position(one.axis, levels))[0]
    panel.plot(levels, p, color=_CURVE, lw=2.0, zorder=3, label="fitted curve")
    label: str | None = "criterion, 95 %"
    for name in ("lower", "upper"):
        if name in curve.values:
            if (ends := curve.intervals[name]) is not None:
                low, high = np.clip(ends, one.levels[0], one.levels[-1])
                panel.axvspan(low, high, color=_CURVE, alpha=0.15, lw=0.0)
            at = curve.values[name]
            if one.levels[0] <= at <= one.levels[-1]:
                panel.axvline(at, color=_CURVE, ls="--", lw=1.2, label=label)
                label = None
