"""Writes docs/numerics.md from the saved results of benchmarks.

python -m tools.numerics_page

No figure of a result is typed: prose says what was measured, and against what.
"""

from typing import Any

from tools.performance_page import RESULTS, ROOT, Table, date_of, lines_of, result

PAGE = ROOT / "docs" / "numerics.md"
REFERENCE = "offlineVQF"
PEER_ALONE = f"{REFERENCE} alone"  # of clips of the shortest length
HOLE = "one with a hole"  # a recording that shows what a hole does; no family
RIDES = {
    "bike": "bike",
    "horse": "horse",
    "car-turning": "car turning",
    "car-braking": "car braking",
}
CAUSES = (
    ("the force itself", "signal", "force"),
    ("accelerometer: bias, scale, axes", "sensor", "bias, scale, axes"),
    ("averaging, then the spline", "sampling", "averaging and spline"),
    ("synchronisation, embedded clock", "synchronisation", "camera"),
    ("synchronisation, pats at 30 Hz", "synchronisation", "event pattern, 30 Hz"),
    ("gravity: smoother, with the gyro's errors", "gravity removal", "smoother, board's gyro"),
    ("**the paper's chain**: 30 Hz, half a frame, hold", "chain", "paper"),
    ("**today**: 30 Hz, pats, spline", "chain", "today"),
    ("**camera**: 200 Hz, embedded clock, linear", "chain", "camera"),
)  # fmt: skip
BETWEEN = (("lines, mN", "lines"), ("spline, mN", "today"))
TEXT = """# Errors of gravity removal, force and washout

Written by `python -m tools.numerics_page` from the [results](../benchmarks/results) of the
[benchmarks](../benchmarks/README.md); what was missed stands in [performance.md](performance.md).
Methods and equations: [methods.md](methods.md). Gravity errors are 9.81 |n - n_true| with n the vertical
in the sensor's frame, RMS over a recording, mean over recordings, m/s^2. Native is the sensor's own
rate; 30 Hz are means over windows, as the paper's board gives them. Machine: a virtual machine with 2
cores, one thread.

## Gravity: error and uncertainty

`{accuracy_command}`, {accuracy_date}: {accuracy_targets}. Peer: offlineVQF in the same run, with
its published setting and with the best of four (`tauAcc`) for each family, which a user could not choose
without the truth. *Ratio* and *of the best*: smoother over either. *Within*: share of samples within 2
sigma; *sigma*: median over RMS error. *us* per sample and *of its time*: of `run_time`, {run_time_date}, in
interleaved rounds.

![Error against run time, one panel for each kind of recording](motion-pareto.svg)

{accuracy}

## Gravity: short clips

`{short_clips_command}`, {short_clips_date}: {short_clips_targets}. Clips of three lengths, both rates,
alone and with a flaw put on the sensor: largest error of offlineVQF's on the same samples (least share
within 2 sigma). Last, the shortest ones out of the whole log, and with the calibration of its other half.

{short}

## Gravity: run time

`{run_time_command}`, {run_time_date}: {run_time_targets}. CPU time beside
offlineVQF's, medians of interleaved rounds. Hand-held, simulated; us per sample.

{lengths}

## Gravity: rounding

`{numerics_command}`, {numerics_date}. The smoother works in float64. Condition of
its scaled normal matrix and the largest error of its solution by rounding, m/s^2, by family, and of a
peer in float32:

{condition}

## Error of the force, cause by cause

`{budget_command}`, {budget_date}: the four rides of the paper with true motion as
reference, each cause alone; RMS of the error vector, mN. Peer: the paper's chain.

![Each cause's share](error-budget.png)

{budget}

## Force between window means

The same command, {budget_targets}: scenes of motion alone, 3 rides each, windows and noise of the paper's
accelerometer, gravity known; error of the force below 8 Hz, lines between the means against the
spline through their integral (`rendering/window_means.py`), which overshoots the means beside a step.

{between}

## Motion suggested by frames

`{suggested_command}`, {suggested_date}: {suggested_targets}. Sway and bounce on clips not used to
build it (3 seeds of 6 rides; karma, a MAX walk); error as a share of the truth's RMS, with gain 1. Peers:
no force, whose error is 1, and a random one.

{estimate}

## Washout

`{washout_command}`, {washout_date}: {washout_targets}. Simulated rides with 3 seeds each, a drone, a
car. Error: rms(W (u - F)) / rms(W F), for the rides that would pass R. Classical washouts (2nd and 3rd
order; zero phase, gain alone) have the best cut-off and gain for that ride at the same excursion of the
same hands.

{washout-errors}

Eight hands (relaxed to firm, two that yield, and a limp one of 60 N/m) with the device's spring, fade and
caps: mean error of the force that is sent, largest difference between two hands (without limp) as a share
of the force, furthest reach as a share of the workspace, trips (at most one a second counts),
share of time with a force against the desired one or out of nothing.

{washout-hands}
"""


def accuracy(
    errors: dict[str, Any], sigma: dict[str, Any], us_per_sample: dict[str, Any]
) -> Table:
    """Errors of each method beside the peer, as it comes and at its best, and the time."""
    methods = ("smoother", "ekf", "vqf", "lowpass")
    rows = []
    for family, of in errors.items():
        if HOLE in family:
            continue
        peers = {name: one for name, one in of.items() if name.startswith(REFERENCE)}
        best = min(peers.values())
        ours, told, us = of["smoother"], sigma[family], us_per_sample[family]
        rows.append([
            family, *(f"{of[name]:.3f}" for name in methods), f"{of[REFERENCE]:.3f}",
            f"{best:.3f}", f"{ours / of[REFERENCE]:.2f}", f"{ours / best:.2f}",
            f"{told['within']:.3f}", f"{told['sigma_over_rms']:.2f}", f"{us['gravity']:.2f}",
            f"{us['gravity'] / us[REFERENCE]:.2f}",
        ])  # fmt: skip
    header = ["recordings", *methods, REFERENCE, "its best", "ratio", "of the best"]
    return [*header, "within", "sigma", "us", "of its time"], rows


def short(
    clips: dict[str, dict[str, float]], errors: dict[str, dict[str, float]]
) -> Table:
    """One row for each flaw and each help, one column for each kind of recording."""
    cells: dict[str, dict[str, list[dict[str, float]]]] = {}
    for name, cell in clips.items():
        kind, _, flaw = name.split(", ")
        column = kind.removesuffix(" native").removesuffix(" 30 Hz")
        cells.setdefault(flaw, {}).setdefault(column, []).append(cell)
    columns = list(dict.fromkeys(kind for of in cells.values() for kind in of))
    rows = [
        [flaw, *(f"{max(one['ratio'] for one in of[kind]):.2f} "
                 f"({min(one['within'] for one in of[kind]):.2f})" for kind in columns)]
        for flaw, of in cells.items()
    ]  # fmt: skip
    for way in ("whole log", "calibration"):
        shown = [errors.get(kind, {}) for kind in columns]
        rows.append(
            [way, *(f"{of[way] / of[PEER_ALONE]:.2f}" if of else "" for of in shown)]
        )
    return ["", *columns], rows


def lengths(length: dict[str, Any]) -> Table:
    """One row for each length, native and at 30 Hz."""
    by_length: dict[str, list[str]] = {}
    for _, text, _, ours, theirs, ratio, _ in length["rows"]:
        by_length.setdefault(text, []).extend((ours, theirs, ratio))
    rows = [[text, *cells] for text, cells in by_length.items()]
    columns = ["smoother", REFERENCE, "ratio"]
    return ["length", *columns, *(f"30 Hz: {one}" for one in columns)], rows


def condition(found: dict[str, Any]) -> Table:
    """One row for each family."""
    rows = [
        [family, *(f"{of[key]:.1e}" for key in
         ("band_scaled", "error_float64_mps2", "error_float32_mps2"))]
        for family, of in found.items()
    ]  # fmt: skip
    return ["recordings", "condition", "float64", "float32"], rows


def budget(rms_mn: dict[str, Any]) -> Table:
    """One row for each cause or chain."""
    rows = [
        [text, *(f"{rms_mn[ride][group][cause]:.3g}" for ride in RIDES)]
        for text, group, cause in CAUSES
    ]
    return ["", *RIDES.values()], rows


def between(scenes: dict[str, Any]) -> Table:
    """Lines and spline on each scene."""
    rows = [
        [text, *(f"{of[key]:.3g}" for of in scenes.values())] for text, key in BETWEEN
    ]
    rows.append(
        ["ratio", *(f"{of['today'] / of['lines']:.2f}" for of in scenes.values())]
    )
    return ["", *scenes], rows


def page() -> str:
    """The page as the results have it."""
    names = (
        "accuracy",
        "run_time",
        "short_clips",
        "numerics",
        "budget",
        "suggested",
        "washout",
    )
    found = {name: result(RESULTS / f"{name}.json") for name in names}
    tables: dict[str, Table] = {
        "accuracy": accuracy(
            found["accuracy"]["error_mps2"],
            found["accuracy"]["sigma"],
            found["run_time"]["us_per_sample"],
        ),
        "lengths": lengths(found["run_time"]["length"]),
        "short": short(
            found["short_clips"]["clips"], found["short_clips"]["error_mps2"]
        ),
        "condition": condition(found["numerics"]["condition"]),
        "budget": budget(found["budget"]["rms_mn"]),
        "between": between(found["budget"]["between_means"]),
    }
    for one in found.values():
        for name, (head, *rows) in one.get("tables", {}).items():
            tables.setdefault(name, (head, rows))
    text = {name: lines_of(*table) for name, table in tables.items()}
    for name, one in found.items():
        met = [target["met"] for target in one["targets"]]
        text[f"{name}_command"], text[f"{name}_date"] = one["command"], date_of(one)
        text[f"{name}_targets"] = f"{sum(met)} of {len(met)} targets met"
    return TEXT.format(**text)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
