"""The figures of yes-no and two-interval trials: shares, curves, staircases."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from hapticplayer.extras.psychophysics.levels import (
    ALL,
    AxisAnalysis,
    Curve,
    LevelAnalysis,
    position,
)
from hapticplayer.extras.psychophysics.staircases import PersonTrack
from hapticplayer.study.analysis.figures import draw_lines, new_panel
from hapticplayer.study.definition import FeedbackLevel

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NAMES = {"delay_s": "by-time-shift", "gain": "by-gain"}
LABELS = {
    "delay_s": "delay of the force against the video (s)",
    "gain": "gain of the force",
}
STAIRCASES = "staircases"
_INK, _CURVE, _PERSON = "#222222", "#0072b2", "#999999"


class LevelWords(NamedTuple):
    """What the answers to a level are called, and the values of a curve that are reported."""

    key: str
    share: str
    values: tuple[str, ...]


def words_of(analysis: LevelAnalysis) -> LevelWords:
    if analysis.answers.standard is None:
        values = ("lower", "upper", "centre", "window", "spread")
        return LevelWords("yes", "share of answers yes", values)
    return LevelWords("chosen", "share of choices", ("equal", "threshold", "spread"))


def figures(
    analysis: LevelAnalysis, tracks: Sequence[PersonTrack]
) -> dict[str, "Figure"]:
    words = words_of(analysis)
    made = {
        f"{words.key}-{NAMES[axis]}": _figure(one, words.share, analysis)
        for axis, one in analysis.axes.items()
    }
    if tracks:
        made[STAIRCASES] = _staircases(tracks)
    return made


def _staircases(tracks: Sequence[PersonTrack]) -> "Figure":
    with new_panel("change of the standard") as (_figure, panel):
        for one in tracks:
            panel.plot(one.track.changes[:-1], color=_PERSON, lw=0.8, alpha=0.6)
        panel.set_xlabel("trial")
        panel.set_ylim(bottom=0.0)
    return _figure


def _figure(one: AxisAnalysis, share: str, analysis: LevelAnalysis) -> "Figure":
    with new_panel(share) as (figure, panel):
        style: dict[str, Any] = {"color": _PERSON, "linewidth": 0.7, "alpha": 0.45}
        label = "one participant"
        draw_lines(panel, one.levels, one.by_person, label=label, **style)
        _draw_shares(panel, one)
        if (curve := one.curves[ALL]) is not None:
            _draw_curve(panel, one, curve, analysis.answers.standard)
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


def _draw_curve(
    panel: "Axes", one: AxisAnalysis, curve: Curve, standard: FeedbackLevel | None
) -> None:
    levels = np.linspace(one.levels[0], one.levels[-1], 401)
    p = curve.fits.shares(position(one.axis, levels, standard))[0]
    panel.plot(levels, p, color=_CURVE, lw=2.0, zorder=3, label="fitted curve")
    label: str | None = "criterion, 95 %"
    for name in ("lower", "upper", "equal"):
        if name in curve.values:
            if (ends := curve.intervals[name]) is not None:
                low, high = np.clip(ends, one.levels[0], one.levels[-1])
                panel.axvspan(low, high, color=_CURVE, alpha=0.15, lw=0.0)
            at = curve.values[name]
            if one.levels[0] <= at <= one.levels[-1]:
                panel.axvline(at, color=_CURVE, ls="--", lw=1.2, label=label)
                label = None
