"""Draws the figures of docs/numerics.md from the saved results of benchmarks.

python -m tools.result_figures

`docs/motion-pareto.svg` and `.png` (error against run time, `python -m benchmarks.motion
pareto`) and `docs/error-budget.png` (`... budget`).
"""

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

ROOT = Path(__file__).resolve().parents[1]
TITLES = {
    "broad": "hand-held (BROAD)",
    "tumvi": "camera rig (TUM-VI)",
    "tyrex": "phone on people (tyrex)",
    "car": "phone in a car (comma2k19)",
    "sim-car": "simulated car rides",
    "sim-people": "simulated people, bikes",
}
RECORDED = ("broad", "tumvi", "tyrex")
DPI, COLUMNS = 100, 3
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
# the usual setting of each method, which is named
USUAL = {
    ("offlineVQF", "3"): "offlineVQF",
    ("offlineVQF + averaging terms", ""): "+ averaging terms",
    ("VQF", "3"): "VQF",
    ("ekf", "2"): "ekf",
    ("lowpass", ""): "low-pass",
    ("lowpass", "1"): "low-pass",
    ("smoother", "default"): "smoother, default",
}
Point = dict[str, Any]


def result(name: str) -> dict[str, Any]:
    """Return a saved result."""
    path = ROOT / "benchmarks" / "results" / f"{name}.json"
    return dict(json.loads(path.read_text(encoding="utf-8")))


# --- error against run time --------------------------------------------------------


def draw_pareto(path: Path, keys: Sequence[str], width_px: int) -> None:
    """Draw one panel to a family."""
    panels = result("pareto")
    shown = [key for key in keys if key in panels]
    columns = min(COLUMNS, len(shown))
    rows = -(-len(shown) // columns)
    settings: dict[str, Any] = {
        "font.size": 9.5,
        "svg.fonttype": "none",  # text stays text: sharp, small, searchable
        "svg.hashsalt": "motion",  # the same figures give the same file
        "axes.linewidth": 0.6,
    }
    with mpl.rc_context(settings):
        width = width_px / DPI
        size = (width, width / columns * rows * 0.92 + 0.35)
        figure = Figure(figsize=size, dpi=DPI, layout="constrained")
        FigureCanvasAgg(figure)
        grid = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
        for axes, key in zip(grid.flat, shown, strict=False):
            _panel(axes, key, panels[key])
        for axes in grid.flat[len(shown) :]:
            axes.set_axis_off()
        figure.supxlabel("run time of the orientation, µs per sample, one thread")
        figure.supylabel("mean gravity error, m/s²")
        colour = STYLES["smoother"][0]
        handles = [
            Line2D([], [], color=colour, marker=m, ls="", label=f"smoother: {text}")
            for m, text in KNOBS.values()
        ]
        handles.append(Line2D([], [], color="#bbbbbb", label="front"))
        place = {"loc": "outside upper center", "frameon": False}
        figure.legend(handles=handles, ncols=width_px // 220, fontsize="small", **place)
        metadata = {"Date": None} if path.suffix == ".svg" else None
        figure.savefig(path, metadata=metadata)


def _panel(axes: Axes, key: str, points: Sequence[Point]) -> None:
    name, _, rate = key.partition(" ")
    axes.set_title(f"{TITLES[name]}, {rate}", fontsize="medium")
    axes.set(xscale="log", yscale="log")
    axes.grid(visible=True, which="major", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    front = _front(points)
    us, errors = (
        [*(p["us"] for p in front), 100.0],
        [*(p["error_mps2"] for p in front)],
    )
    axes.step(us, [*errors, errors[-1]], where="post", color="#bbbbbb", lw=1)
    lines: dict[tuple[str, str], list[Point]] = {}
    for point in points:
        lines.setdefault((point["method"], point["knob"]), []).append(point)
    for (method, knob), held in lines.items():
        colour, marker = STYLES[method]
        marker = KNOBS[knob][0] if knob in KNOBS else marker
        at = [p["us"] for p in held], [p["error_mps2"] for p in held]
        axes.plot(*at, color=colour, lw=0.7, alpha=0.5, zorder=2)
        axes.plot(*at, marker, color=colour, ms=5.0, mec="white", mew=0.4)
    for point in points:
        text = USUAL.get((point["method"], point["value"]))
        if text:
            _name(axes, point, text)
    axes.set_xlim(0.05, 60.0)


def _front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other one beats in both, fastest first."""
    best: list[Point] = []
    for point in sorted(points, key=lambda p: (p["us"], p["error_mps2"])):
        if not best or point["error_mps2"] < best[-1]["error_mps2"]:
            best.append(point)
    return best


def _name(axes: Axes, point: Point, text: str) -> None:
    colour, marker = STYLES[point["method"]]
    is_default = point["value"] == "default"
    at = (point["us"], point["error_mps2"])
    if is_default:
        axes.plot(*at, marker, color=colour, ms=15, mec="black", zorder=5)
    axes.annotate(
        text,
        at,
        (8.0, -9.0 if is_default or text.startswith("+") else 6.0),
        textcoords="offset pixels",
        color=colour,
        fontweight="bold" if is_default else "normal",
        fontsize="small",
        zorder=6,
    )


# --- the error of the force, cause by cause ----------------------------------------


def draw_budget(path: Path) -> None:
    """Draw each cause's share of the squares of all causes."""
    found = result("budget")
    figures, stacks = found["rms_mn"], found["stacks"]
    figure = Figure(figsize=(9.0, 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots()
    colours = mpl.colormaps["tab10"].colors
    labels: list[tuple[float, str]] = []
    at = 0.0
    for name, causes in figures.items():
        for chain, parts in stacks.items():
            squares = [causes[group][cause] ** 2 for group, cause in parts]
            total, bottom = sum(squares) ** 0.5, 0.0
            for number, square in enumerate(squares):
                height = square / sum(squares) * total
                label = ", ".join(parts[number]) if at == 0.0 else None
                axes.bar(at, height, 0.8, bottom, color=colours[number], label=label)
                bottom += height
            label = "the whole chain" if at == 0.0 else None
            axes.plot(at, causes["chain"][chain], "kD", ms=5, label=label)
            labels.append((at, f"{chain}\n{name}" if chain == "paper" else chain))
            at += 1.0
        label = "camera at 200 Hz" if at == 2.0 else None
        axes.plot(at - 1.0, causes["chain"]["camera"], "k_", ms=18, mew=2, label=label)
        at += 0.6
    axes.set_xticks([x for x, _ in labels], [text for _, text in labels], fontsize=8)
    axes.set_ylabel("RMS error of the force, mN")
    title = "Each cause's share of the error of the force (by squares)"
    axes.set_title(title, fontsize=10)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(fontsize=8, ncols=2, frameon=False)
    figure.savefig(path, dpi=110)


def main() -> int:
    """Draw all figures."""
    small = [f"{name} {rate}" for rate in ("native", "30 Hz") for name in RECORDED]
    rest = [f"{name} {rate}" for rate in ("native", "30 Hz") for name in TITLES]
    everything = small + [key for key in rest if key not in small]
    draw_pareto(ROOT / "docs" / "motion-pareto.svg", everything, 1200)
    draw_pareto(ROOT / "docs" / "motion-pareto.png", small, 900)
    draw_budget(ROOT / "docs" / "error-budget.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
