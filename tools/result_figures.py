"""Draws the figures of docs/numerics.md and docs/formats.md from saved results.

python -m tools.result_figures

`docs/motion-pareto.svg` and `.png` (error against run time: `python -m
benchmarks.motion accuracy` and `run_time`), `docs/error-budget.png` (`budget`) and
`docs/thinning.png` (`python -m benchmarks.distribution formats`).
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

ROOT = Path(__file__).resolve().parents[1]
TITLES = {
    "broad": "hand-held (BROAD)",
    "tumvi": "camera rig (TUM-VI)",
    "tyrex": "phone on people (tyrex)",
    "repoimu_TStick": "stick swung (RepoIMU)",
    "repoimu_Pendulum": "repoimu_Pendulum (RepoIMU)",
    "car": "phone in a car (comma2k19)",
    "sim-car": "simulated car rides",
    "sim-people": "simulated people, bikes",
}
RECORDED = ("broad", "tumvi", "tyrex", "repoimu_TStick", "repoimu_Pendulum")
DPI, COLUMNS = 100, 3
# Okabe and Ito's colours: safe for colour-blind readers; a marker for each as well
STYLES: dict[str, tuple[str, str]] = {
    "smoother": ("#0072B2", "*"),
    "offlineVQF": ("#D55E00", "s"),
    "vqf": ("#CC79A7", "^"),
    "ekf": ("#009E73", "D"),
    "lowpass": ("#555555", "v"),
}
Point = tuple[str, float, float]
"""Method, run time per sample in us, error in m/s^2."""


def result(name: str) -> dict[str, Any]:
    path = ROOT / "benchmarks" / "results" / f"{name}.json"
    return dict(json.loads(path.read_text(encoding="utf-8")))


# --- error against run time --------------------------------------------------------


def points_of(key: str) -> list[Point]:
    """Return a point of each method; other settings of the reference share its time."""
    errors = result("accuracy")["error_mps2"][key]
    times = result("run_time")["us_per_sample"][key]
    times = {"smoother": times["gravity"], **times}
    return [
        (method, times[method.partition(",")[0]], error)
        for method, error in errors.items()
        if method
        != "offline-vqf"  # ours of offlineVQF: the same error, nearly its time
    ]


def draw_pareto(path: Path, keys: Sequence[str], width_px: int) -> None:
    """Draw one panel to a family."""
    columns = min(COLUMNS, len(keys))
    rows = -(-len(keys) // columns)
    settings: dict[str, Any] = {
        "font.size": 9.5,
        "svg.fonttype": "none",  # text stays text: sharp, small, searchable
        "svg.hashsalt": "motion",  # the same figures give the same file
        "axes.linewidth": 0.6,
    }
    with mpl.rc_context(settings):
        width = width_px / DPI
        size = (width, width / columns * rows * 0.92)
        figure = Figure(figsize=size, dpi=DPI, layout="constrained")
        FigureCanvasAgg(figure)
        grid = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
        for axes, key in zip(grid.flat, keys, strict=False):
            _panel(axes, key)
        for axes in grid.flat[len(keys) :]:
            axes.set_axis_off()
        figure.supxlabel("run time of gravity removal, µs per sample, one thread")
        figure.supylabel("mean gravity error, m/s²")
        metadata = {"Date": None} if path.suffix == ".svg" else None
        figure.savefig(path, metadata=metadata)


def _panel(axes: Axes, key: str) -> None:
    name, _, rate = key.partition(" ")
    axes.set_title(f"{TITLES[name]}, {rate}", fontsize="medium")
    axes.set(xscale="log", yscale="log", xlim=(0.05, 100.0))
    axes.grid(visible=True, which="major", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    for method, us, error in points_of(key):
        base, _, setting = method.partition(", ")
        colour, marker = STYLES[base]
        is_default = base == "smoother"
        size = 15.0 if is_default else 3.0 if setting else 6.0
        edge = "black" if is_default else "white"
        axes.plot(us, error, marker, color=colour, ms=size, mec=edge, mew=0.6)
        text = setting.replace("tauAcc", "τ") or base
        axes.annotate(
            text,
            (us, error),
            (9.0 if is_default else 6.0, -4.0),
            textcoords="offset pixels",
            color=colour,
            fontweight="bold" if is_default else "normal",
            fontsize="x-small" if setting else "small",
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


# --- rate and error of thinned curves ------------------------------------------------


def draw_thinning(path: Path) -> None:
    """Draw the rate of hjif over the RMS error, and over the error that is felt."""
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    FigureCanvasAgg(figure)
    both = figure.subplots(1, 2, sharey=True)
    for (name, rows), (colour, marker) in zip(
        result("formats")["thinning"].items(), STYLES.values(), strict=False
    ):
        ours = [row["kbit_s"] for row in rows]
        for axes, key in zip(both, ("rms_n", "felt_rms_n"), strict=True):
            errors = [1000.0 * row[key] for row in rows]
            axes.plot(errors, ours, marker=marker, color=colour, label=name)
        theirs = [row["rdp_kbit_s"] for row in rows]
        errors = [1000.0 * row["rdp_rms_n"] for row in rows]
        both[0].plot(errors, theirs, ":", color=colour)
    both[0].plot([], [], "k:", label="Ramer-Douglas-Peucker")
    both[0].set_xscale("log")
    both[0].set_xlabel("RMS error, mN")
    both[1].set_xlabel("RMS of what exceeds 8 % and 30 mN, mN")
    both[0].set_ylabel("hjif as text, kbit/s")
    for axes in both:
        axes.spines[["top", "right"]].set_visible(False)
    both[0].legend(fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)


def main() -> int:
    """Draw all figures."""
    known = list(result("accuracy")["error_mps2"])
    everything = [key for key in known if "," not in key]
    small = [key for key in everything if key.startswith(RECORDED)]
    draw_pareto(ROOT / "docs" / "motion-pareto.svg", everything, 1200)
    draw_pareto(ROOT / "docs" / "motion-pareto.png", small, 900)
    draw_budget(ROOT / "docs" / "error-budget.png")
    draw_thinning(ROOT / "docs" / "thinning.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
