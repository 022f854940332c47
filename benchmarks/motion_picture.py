"""Draws error against run time, one panel to a family."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox
from motion_data import TITLES
from motion_pareto import DEFAULT, Point, front

DPI = 100
COLUMNS = 3
# Okabe and Ito's colours: told apart by everybody, with one marker to each as well
STYLES: dict[str, tuple[str, str]] = {
    "smoother": ("#0072B2", "*"),
    "offlineVQF": ("#D55E00", "s"),
    "offlineVQF + averaging terms": ("#D55E00", "P"),
    "VQF": ("#CC79A7", "^"),
    "ekf": ("#009E73", "D"),
    "lowpass": ("#555555", "v"),
}
# settings of ours: marker, and what it stands for
KNOBS = {
    "node_s": ("o", "s between nodes"),
    "window_hz": ("s", "Hz of windows"),
    "solutions": ("^", "solutions"),
    "time_constant_s": ("D", "s time constant, fixed"),
}
_UNITS = {
    "node_s": "{} s",
    "window_hz": "{} Hz",
    "solutions": "{}",
    "time_constant_s": "{} s",
    "tauAcc_s": "τ {} s",
    "gate_mps2": "gate {}",
    "cutoff_hz": "{} Hz",
}
# how the point of a method with its usual setting is called, and which one that is
_USUAL = {
    ("offlineVQF", "3"): "offlineVQF",
    ("offlineVQF + averaging terms", ""): "offlineVQF, averaging terms",
    ("VQF", "3"): "VQF",
    ("ekf", "2"): "ekf",
    ("lowpass", "1"): "low-pass",
}
# settings that are called by their value too, where there is room
_NAMED = {
    "node_s": ("0.1", "2"),
    "window_hz": ("8", "64"),
    "solutions": ("1", "2"),
    "time_constant_s": ("3", "10", "30"),
    "tauAcc_s": ("1", "20"),
    "gate_mps2": ("none",),
    "cutoff_hz": ("0.1",),
}


@dataclass(frozen=True, slots=True)
class Sheet:
    """One picture.

    Attributes:
        path: .svg or .png.
        panels: keys of the families.
        width_px: of the picture; a panel is as high as wide.
        detailed: whether settings are named, or methods only.
    """

    path: Path
    panels: Sequence[str]
    width_px: int
    detailed: bool


def draw(sheet: Sheet, panels: Mapping[str, Sequence[Point]]) -> Path:
    """Draw some panels and write the file."""
    shown = [key for key in sheet.panels if key in panels]
    columns = min(COLUMNS, len(shown))
    rows = -(-len(shown) // columns)
    settings: dict[str, Any] = {
        "font.size": 9.5 if sheet.detailed else 9,
        "svg.fonttype": "none",  # text stays text: sharp, small, searchable
        "svg.hashsalt": "motion",  # the same figures give the same file
        "axes.linewidth": 0.6,
    }
    with mpl.rc_context(settings):
        width = sheet.width_px / DPI
        height = width / columns * rows * 0.92 + 0.35
        figure = Figure(figsize=(width, height), dpi=DPI, layout="constrained")
        FigureCanvasAgg(figure)
        grid = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
        for axes, key in zip(grid.flat, shown, strict=False):
            _panel(axes, key, panels[key], detailed=sheet.detailed)
        for axes in grid.flat[len(shown) :]:
            axes.set_axis_off()
        figure.supxlabel("run time of the orientation, µs per sample, one thread")
        figure.supylabel("mean gravity error, m/s²")
        if sheet.detailed:
            _legend(figure)
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
        for axes, key in zip(grid.flat, shown, strict=False):
            _label(axes, panels[key], detailed=sheet.detailed)
        metadata = {"Date": None} if sheet.path.suffix == ".svg" else None
        figure.savefig(sheet.path, metadata=metadata)
    return sheet.path


def _panel(axes: Axes, key: str, points: Sequence[Point], *, detailed: bool) -> None:
    name, _, rate = key.partition(" ")
    axes.set_title(f"{TITLES[name]}, {rate}", fontsize="medium")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(visible=True, which="major", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    edge = front(points)
    reach = [*(p.us for p in edge), 100.0], [*(p.error_mps2 for p in edge)]
    axes.step(reach[0], [*reach[1], reach[1][-1]], where="post", color="#bbbbbb", lw=1)
    size = 5.0 if detailed else 3.5
    for (method, knob), held in _lines(points).items():
        colour, marker = STYLES[method]
        marker = KNOBS[knob][0] if knob in KNOBS else marker
        us, errors = zip(*((p.us, p.error_mps2) for p in held), strict=True)
        axes.plot(us, errors, color=colour, lw=0.7, alpha=0.5, zorder=2)
        axes.plot(us, errors, marker, color=colour, ms=size, mec="white", mew=0.4)
    default = _default(points)
    colour, _ = STYLES[default.setting.method]
    axes.plot(
        default.us, default.error_mps2, "*", color=colour, ms=15, mec="black", zorder=5
    )
    axes.set_xlim(0.05, 60.0)


def _legend(figure: Figure) -> None:
    colour, _ = STYLES["smoother"]
    handles = [
        Line2D([], [], color=colour, marker=marker, ls="", label=f"smoother: {text}")
        for marker, text in KNOBS.values()
    ]
    handles.append(Line2D([], [], color="#bbbbbb", label="front"))
    figure.legend(handles=handles, loc="outside upper center", ncols=5, frameon=False)


def _lines(points: Sequence[Point]) -> dict[tuple[str, str], list[Point]]:
    """Return the points by what is turned, the usual setting among them."""
    found: dict[tuple[str, str], list[Point]] = {}
    for point in points:
        setting = point.setting
        found.setdefault((setting.method, setting.knob), []).append(point)
    return found


def _default(points: Sequence[Point]) -> Point:
    return next(point for point in points if point.setting.value == DEFAULT)


def _label(axes: Axes, points: Sequence[Point], *, detailed: bool) -> None:
    """Write names beside points, each where it covers least."""
    pixels = axes.transData.transform([(p.us, p.error_mps2) for p in points])
    taken = [Bbox.from_bounds(x - 4, y - 4, 8, 8) for x, y in pixels]
    x, y = axes.transData.transform((_default(points).us, _default(points).error_mps2))
    taken.append(Bbox.from_bounds(x - 9, y - 9, 18, 18))
    for rank in (0, 1) if detailed else (0,):
        for point in points:
            text = _name(point, rank)
            if text:
                _place(axes, point, text, taken, bold=point.setting.value == DEFAULT)


def _name(point: Point, rank: int) -> str:
    """Return what a point is called: rank 0 the method, 1 the setting, or nothing."""
    setting = point.setting
    if setting.value == DEFAULT:
        return "" if rank else "smoother, default"
    usual = _USUAL.get((setting.method, setting.value), "")
    if rank == 0 or usual:
        return "" if rank else usual
    if setting.value in _NAMED.get(setting.knob, ()):
        text = _UNITS[setting.knob].format(setting.value)
        return "no gate" if setting.value == "none" else text
    return ""


def _place(
    axes: Axes, point: Point, text: str, taken: list[Bbox], *, bold: bool
) -> None:
    colour, _ = STYLES[point.setting.method]
    mark = axes.annotate(
        text,
        (point.us, point.error_mps2),
        (0.0, 0.0),
        textcoords="offset pixels",
        color=colour,
        fontsize="medium" if bold else "small",
        fontweight="bold" if bold else "normal",
        zorder=6,
        annotation_clip=False,
    )
    renderer = axes.figure.canvas.get_renderer()  # type: ignore[attr-defined]
    frame = axes.get_window_extent(renderer)
    best: tuple[float, tuple[float, float, str, str]] | None = None
    for place in _places():
        _move(mark, place)
        box = mark.get_window_extent(renderer)
        cost = sum(_shared_px2(box, other) for other in taken) + abs(place[1])
        cost += abs(place[0]) + 50.0 * _outside_px(box, frame)
        if best is None or cost < best[0]:
            best = cost, place
    assert best is not None
    _move(mark, best[1])
    taken.append(mark.get_window_extent(renderer))
    if abs(best[1][0]) + abs(best[1][1]) > 20.0:
        axes.annotate(
            "",
            (point.us, point.error_mps2),
            (best[1][0], best[1][1]),
            textcoords="offset pixels",
            arrowprops={"arrowstyle": "-", "color": colour, "lw": 0.5, "shrinkB": 3},
            zorder=4,
        )


def _places() -> list[tuple[float, float, str, str]]:
    """Return offsets in pixels with how the text lies to them, near ones first."""
    found: list[tuple[float, float, str, str]] = []
    for far in (8.0, 14.0, 22.0, 32.0, 44.0, 58.0):
        for across in (1, -1):
            side = "left" if across > 0 else "right"
            found += [(across * far, up * far, side, "center") for up in (0, 0.7, -0.7)]
        found += [(0.0, far, "center", "bottom"), (0.0, -far, "center", "top")]
    return found


def _move(mark: Any, place: tuple[float, float, str, str]) -> None:
    mark.set_position(place[:2])
    mark.set_horizontalalignment(place[2])
    mark.set_verticalalignment(place[3])


def _shared_px2(one: Bbox, other: Bbox) -> float:
    shared = Bbox.intersection(one, other)
    return 0.0 if shared is None else 5.0 + float(shared.width * shared.height)


def _outside_px(box: Bbox, frame: Bbox) -> float:
    """Return by how much a box leaves the frame."""
    return float(
        max(0.0, frame.x0 + 2 - box.x0)
        + max(0.0, box.x1 + 2 - frame.x1)
        + max(0.0, frame.y0 + 2 - box.y0)
        + max(0.0, box.y1 + 2 - frame.y1)
    )
