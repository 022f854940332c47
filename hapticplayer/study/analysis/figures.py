"""The figures of a study: means, standard deviations, and lines of participants.

The same analysis gives the same bytes: fixed ids in SVG, no dates.
"""

import io
import textwrap
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.analysis import Analysis
from hapticplayer.study.analysis.ordinal_mixed import EFFECTS_FIGURE, known_effects
from hapticplayer.study.analysis.scores import factors_figure
from hapticplayer.study.analysis.sequence_factor_tests import (
    effects_at_levels,
    effects_figure,
    levels_figure,
)
from hapticplayer.study.definition import QOE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FORMATS = (".svg", ".pdf", ".png")
SIZE_IN = (9.0, 4.6)
DPI = 150

# Okabe and Ito: safe for colour blindness; hatches for print
_COLOURS = ("#bbbbbb", "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442")
_HATCHES = ("", "//", "..", "xx", "\\\\", "++")
DARK = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#222222")
_MARKERS = "osD^v*"
_INK, _LINE, _MARK = "#222222", "#444444", "#a32020"
_GROUP = 0.84  # share of the space between two groups
_ASIDE = 0.18  # share of a bar by which error bars and lines are moved apart
_MARK_PT, _MARK_ACROSS_PT = 30.0, 800.0  # size, and sum of a mark's characters
_LETTERS, _LEAST_LETTERS = 95, 6  # of the names of all groups, side by side
_SIGN_LETTERS = 8  # a sign in a legend with the gaps around it
_SETTINGS: dict[Any, Any] = {
    "svg.hashsalt": "hapticplayer",
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
    "hatch.linewidth": 0.5,
    "text.parse_math": False,  # names may contain a dollar
    "font.size": 10.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def figures(analysis: Analysis) -> dict[str, "Figure"]:
    """Return the figures by name: `qoe-by-sequence`, and factors for each range."""
    scores = analysis.scores
    found = {"qoe-by-sequence": qoe_by_sequence(analysis)} if scores.qoe else {}
    for limits, factors in scores.by_range().items():
        made = factors_by_feedback(analysis, factors, limits)
        found[factors_figure(scores, limits)] = made
    if effects := known_effects(analysis.found):
        found[EFFECTS_FIGURE] = effects_by_measure(effects)
    for factor in scores.sequence_factors:
        found[levels_figure(factor)] = ratings_by_level(analysis, factor)
        levels = scores.levels_of(factor)
        if effects := effects_at_levels(analysis.found, levels):
            found[effects_figure(factor)] = effects_by_measure(effects)
    return found


def qoe_by_sequence(analysis: Analysis) -> "Figure":
    """Draw QoE by sequence and feedback, as figure 7 of the paper, and over all."""
    scores = analysis.scores
    values = scores.of(QOE)  # (P, S, F)
    groups = dict(zip(scores.sequences, np.moveaxis(values, 1, 0), strict=True))
    groups["all"] = analysis.measures[QOE].sample.values
    limits = scores.limits_of(QOE)
    return _figure(
        groups, scores.feedbacks, f"QoE ({limits[0]:g} to {limits[1]:g})", limits
    )


def ratings_by_level(analysis: Analysis, factor: str) -> "Figure":
    """Draw the first measure by level of a factor of the sequences and feedback."""
    scores, name = analysis.scores, analysis.scores.measures[0]
    limits = scores.limits_of(name)
    label = "QoE" if name == QOE else name
    return _figure(
        analysis.measures[name].sample.by_level(factor),
        scores.feedbacks,
        f"{label} ({limits[0]:g} to {limits[1]:g})",
        limits,
    )


def factors_by_feedback(
    analysis: Analysis, factors: list[str], limits: tuple[float, float]
) -> "Figure":
    """Draw factors by feedback, as figure 8 of the paper."""
    groups = {name: analysis.measures[name].sample.values for name in factors}
    label = f"rating ({limits[0]:g} to {limits[1]:g})"
    return _figure(groups, analysis.scores.feedbacks, label, limits)


def effects_by_measure(effects: dict[str, dict[str, Any]]) -> "Figure":
    """Draw the differences of pairs in the mixed model, with their intervals.

    Args:
        effects: results of pairs, by measure.
    """
    pairs = list(dict.fromkeys(name for one in effects.values() for name in one))
    with new_panel("difference on the latent scale (logit)") as (figure, panel):
        panel.axhline(0.0, color=_LINE, linewidth=1.0)
        width = _GROUP / len(pairs)
        for number, pair in enumerate(pairs):
            aside = (number - (len(pairs) - 1) / 2.0) * width
            known = [
                (i, one[pair]) for i, one in enumerate(effects.values()) if pair in one
            ]
            values = np.array([part["estimate"] for _, part in known])
            low, high = np.array([part["interval"] for _, part in known]).T
            look: dict[str, Any] = {
                "fmt": _MARKERS[number % len(_MARKERS)],
                "capsize": 3,
            }
            look["color"] = DARK[number % len(DARK)]
            at = np.array([i for i, _ in known]) + aside
            panel.errorbar(
                at, values, [values - low, high - values], label=pair, **look
            )
        width = _LETTERS // len(effects)
        is_wide = any(len(word) > width for name in effects for word in name.split())
        turned: dict[str, Any] = {"rotation": 30.0, "ha": "right"} if is_wide else {}
        names = [
            textwrap.fill(
                "QoE" if name == QOE else name, _LETTERS if is_wide else width
            )
            for name in effects
        ]
        panel.set_xticks(range(len(effects)), names, **turned)
        figure.legend(
            loc="outside upper center", ncols=columns_of(pairs), frameon=False
        )
    return figure


def marked(figures: dict[str, "Figure"], mark: str) -> dict[str, "Figure"]:
    """Return the figures with a mark across each; empty for none."""
    size_pt = min(_MARK_PT, _MARK_ACROSS_PT / max(1, len(mark)))
    style: dict[str, Any] = {
        "color": _MARK,
        "alpha": 0.5,
        "fontsize": size_pt,
        "zorder": 10,
    }
    for figure in figures.values() if mark else ():
        figure.text(0.5, 0.5, mark, ha="center", va="center", rotation=20, **style)
    return figures


def image(figure: "Figure", suffix: str = ".png") -> bytes:
    """Return a figure as SVG, PDF or PNG; the same analysis gives the same bytes."""
    none = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    out = io.BytesIO()
    with settings():
        figure.savefig(
            out,
            dpi=DPI,
            format=suffix[1:],
            metadata=none.get(suffix, {"Software": None}),
        )
    return out.getvalue()


@contextmanager
def settings() -> Iterator[None]:
    """Use the style of all figures, independent of the user's settings."""
    import matplotlib as mpl

    with mpl.rc_context(_SETTINGS), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing", UserWarning)
        yield


@contextmanager
def new_panel(label: str) -> Iterator[tuple["Figure", "Axes"]]:
    """Yield a figure with one panel, in the style of all figures.

    Args:
        label: of the values.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with settings():
        figure = Figure(figsize=SIZE_IN, layout="constrained")
        FigureCanvasAgg(figure)
        panel = figure.subplots()
        panel.set_ylabel(label)
        panel.grid(visible=True, axis="y", color="#dddddd", linewidth=0.6)
        panel.set_axisbelow(True)
        yield figure, panel


def _figure(
    groups: dict[str, Floats],
    feedbacks: tuple[str, ...],
    label: str,
    limits: tuple[float, float],
) -> "Figure":
    """Draw groups of (P, F) side by side."""
    with new_panel(label) as (figure, panel):
        for place, values in enumerate(groups.values()):
            _draw_group(panel, place, values, min(max(0.0, limits[0]), limits[1]))
        width = max(_LEAST_LETTERS, _LETTERS // len(groups))
        panel.set_xticks(
            range(len(groups)), [textwrap.fill(name, width) for name in groups]
        )
        panel.tick_params(axis="x", length=0)
        drawn = panel.dataLim  # error bars may exceed the scale
        low, high = min(limits[0], drawn.y0), max(limits[1], drawn.y1)
        panel.set_ylim(low - 0.02 * (limits[1] - limits[0]), high * 1.04)
        _draw_legend(figure, feedbacks)
    return figure


def _draw_group(panel: "Axes", place: int, values: Floats, floor: float) -> None:
    count = values.shape[1]
    width = _GROUP / count
    at = place + (np.arange(count) - (count - 1) / 2.0) * width
    aside = _ASIDE * width
    for column in range(count):
        known = values[~np.isnan(values[:, column]), column]
        if not len(known):
            continue
        mean = known.mean()
        panel.bar(
            *(at[column], mean - floor, 0.92 * width, floor), lw=0.6, **_look(column)
        )
        if len(known) > 1:
            bar: dict[str, Any] = {
                "color": _INK,
                "capsize": 4,
                "linewidth": 1.4,
                "zorder": 4,
            }
            panel.errorbar(at[column] + aside, mean, known.std(ddof=1), **bar)
    style: dict[str, Any] = {"color": _LINE, "alpha": 0.35, "zorder": 3}
    draw_lines(panel, at - aside, values, linewidth=0.7, **style)
    spots, _ = np.broadcast_arrays(at - aside, values)
    known = ~np.isnan(values)
    panel.plot(spots[known], values[known], "o", markersize=2.0, mew=0.0, **style)


def _look(number: int) -> dict[str, Any]:
    """Return colour and hatch, together different for 36 feedbacks."""
    hatch = (number + number // len(_COLOURS)) % len(_HATCHES)
    colour = _COLOURS[number % len(_COLOURS)]
    return {"facecolor": colour, "hatch": _HATCHES[hatch], "ec": _INK}


def draw_lines(panel: "Axes", at: Floats, values: Floats, **style: Any) -> None:
    """Draw the rows of values (P, L) at (L,), broken where they are NaN, as one artist.

    An artist for each line takes 1 ms in each of the formats.
    """
    from matplotlib.collections import LineCollection

    spots, _ = np.broadcast_arrays(at, values)
    panel.add_collection(LineCollection(list(np.dstack([spots, values])), **style))


def _draw_legend(figure: "Figure", feedbacks: tuple[str, ...]) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    marks: list[Patch | Line2D] = [
        Patch(label=name, **_look(i)) for i, name in enumerate(feedbacks)
    ]
    marks.append(Line2D([], [], color=_INK, marker="_", label="mean ± SD"))
    one = "one participant"
    marks.append(Line2D([], [], color=_LINE, alpha=0.6, marker="o", ms=3, label=one))
    figure.legend(
        handles=marks,
        loc="outside upper center",
        ncols=columns_of([str(one.get_label()) for one in marks]),
        frameon=False,
    )


def columns_of(labels: Sequence[str]) -> int:
    """How many labels fit side by side above a figure."""
    width = _SIGN_LETTERS + max(map(len, labels))
    return max(1, min(len(labels), _LETTERS // width))
