"""Writes docs/performance.md from the saved results of benchmarks.

python -m tools.performance_page
"""

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS, PAGE = ROOT / "benchmarks", ROOT / "docs" / "performance.md"
RESULTS = BENCHMARKS / "results"
Table = tuple[list[str], list[list[Any]]]
TEXT = """# Performance

Written by `python -m tools.performance_page` from the results of the
[benchmarks](../benchmarks/README.md). A peer ran in the same rounds; ratios are medians over the
rounds. A row is of the code of its date. Gravity removal, error of the force and washout are in
[numerics.md](numerics.md).

## All benchmarks

`python -m benchmarks.` and the name in a row runs one; a click on the name shows all of its figures.

{summary}

Targets that were missed:

{missed}

## From a fault to no force, ms

Real faults at random moments under a rotating force of 4 N, read from the device's side.

{faults}

## Lateness of the haptic loop, us

Beside cyclictest in the same rounds; `stress` holds the window's interpreter for 2 s every 7 s.

{loop}

The loop sleeps to its deadline and does not spin before it. Waking 18 us early, and spinning for the rest,
takes so much off the lateness, which no hand notices (cyclictest is as late), and costs what the kernel
comes back too soon:

{waking}

## What playing costs

CPU of all processes beside mpv's on the same clip in the same rounds, with their shares of a core, and PSS of
all of them, beside mpv's. `with plots`: in a window with the live plots.

{players}

## Synchronisation of frame, sound and force, ms

Measured from outside: median and, in brackets, 95 % of the magnitude; positive: the first named is
later. Targets: sound - frame within 3 (6) and at most 2 worse than mpv, force - frame 0 to 3 (5),
force - sound within 2 (4). Other speeds are reported only.

{outside}

## Synchronisation of a log with its clip

By three taps:

{pats}

By the frames, beside three taps: clips of 28 s, log at 200 and 30 Hz; errors of confident results in
the middle of the clip, ms: median, p95, largest (results that are confident, of all).

{frames}
"""


def faults(found: dict[str, Any]) -> Table:
    """Return the time from each fault to no force."""
    rows = [[*row[:6], row[8]] for row in found["rows"]]
    return ["fault", "n", "target ms", "p50", "p99", "max", "re-armed, off by ms"], rows


def outside(found: dict[str, Any]) -> Table:
    """Return median and 95 % of the magnitude of each difference."""
    kinds = ("sound - frame", "force - frame", "force - sound")

    def cell(one: dict[str, Any] | None) -> str:
        return f"{one['p50']:+.1f} ({one['abs_p95']:.1f})" if one else ""

    rows = []
    for case, players in found.items():
        if isinstance(players, dict) and "hapticplayer" in players:
            ours, mpv = players["hapticplayer"], players.get("mpv", {})
            cells = [*(ours.get(kind) for kind in kinds), mpv.get(kinds[0])]
            rows.append([case, *map(cell, cells)])
    return ["case", *kinds, "mpv: sound - frame"], rows


def pats(found: dict[str, Any]) -> Table:
    """Return the shares of clips, in %, and the errors of long ones."""
    keys = ("within_half_frame", "variance_kindest", "wrong_unflagged", "right_flagged")
    rows = []
    for kind, one in found["60 s"].items():
        shares = (f"{100 * one[key]:.1f}" for key in keys)
        long = found["600 s"].get(kind, {})
        rows.append([kind, *shares, one["run_ms"], long.get("end_rms_ms", "")])
    header = ["clips", "half a frame %", "variance threshold %", "wrong, unflagged %"]
    return [*header, "right, flagged %", "ms", "600 s: RMS at the end, ms"], rows


def frames(found: dict[str, Any]) -> Table:
    """Return the errors of each method side by side."""
    by_clips: dict[str, dict[str, str]] = {}
    for clips, method, logs, confident, *errors in found["rows"]:
        text = f"{', '.join(map(_cell, errors))} ({confident} of {logs})"
        by_clips.setdefault(clips, {})[method] = text
    methods = list(next(iter(by_clips.values())))
    rows = [[clips, *one.values()] for clips, one in by_clips.items()]
    return ["clips", *methods], rows


def loop(found: dict[str, Any]) -> Table:
    """Return lateness under each load."""
    keys = ("p50", "p99", "p999", "missed", "p99_ratio", "p999_ratio")
    rows = [
        [f"{load}: {name}", *(_first(one.get(key, "")) for key in keys)]
        for load in ("playback", "stress")
        for name, one in found.get(load, {}).items()
    ]
    header = ["us", "p50", "p99", "p99.9", "missed a minute"]
    return [*header, "p99 of cyclictest (1.2)", "p99.9 (1.5)"], rows


PROCESSES = ("window", "sound", "loop", "guard", "device")


def players(found: dict[str, Any]) -> Table:
    """Return CPU and memory of all processes with each clip."""
    rows = []
    for clip, each in found.items():
        for name, one in each.items() if isinstance(each, dict) else ():
            if isinstance(one, dict) and f"{PROCESSES[0]}_percent" in one:
                shares = [one.get(f"{part}_percent", "") for part in PROCESSES]
                ratios = [one[f"{kind}_ratio"][0] for kind in ("cpu", "memory")]
                rows.append([f"{clip}: {name}", *ratios, *shares, one["peak_mb"]])
    header = ["", "CPU / mpv", "memory / mpv", *(f"{part} %" for part in PROCESSES)]
    return [*header, "PSS MB"], rows


def waking(found: dict[str, Any]) -> Table:
    """Return lateness and cost of waking."""
    header, *rows = found["tables"]["waking"]
    return header, rows


TABLES: dict[str, Callable[[dict[str, Any]], Table]] = {
    "faults": faults,
    "outside": outside,
    "pats": pats,
    "frames": frames,
    "loop": loop,
    "players": players,
    "waking": waking,
}


def result(path: Path) -> dict[str, Any]:
    return dict(json.loads(path.read_text(encoding="utf-8")))


def known() -> dict[str, tuple[str, str]]:
    """What each benchmark measures, and against what, by its command: its README's."""
    lines = (BENCHMARKS / "README.md").read_text(encoding="utf-8").splitlines()
    rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("| `")]
    return {row[0].strip("`"): (row[1], row[2]) for row in rows}


def all_results() -> dict[str, dict[str, Any]]:
    """Every saved result by its file's name, in the order of the commands."""
    results = {path.stem: result(path) for path in RESULTS.glob("*.json")}
    return dict(sorted(results.items(), key=lambda one: one[1]["command"]))


def summary() -> Table:
    """A row for each result: what, against what, targets, date and machine."""
    described = known()
    rows = []
    for name, found in all_results().items():
        command = _command(found)
        met = [one["met"] for one in found.get("targets", [])]
        rows.append([
            f"[`{command}`](../benchmarks/results/{name}.json)",
            *described[" ".join(command.split()[:2])],
            f"{sum(met)} of {len(met)}" if met else "none",
            date_of(found),
            found["machine"].get("processor", "virtual machine"),
        ])  # fmt: skip
    return ["benchmark", "measures", "against", "targets met", "date", "machine"], rows


MANY_ALIKE = 4  # missed targets of one kind


def missed() -> Table:
    """A row for each target that was missed; many of a kind share one, with the worst."""
    rows = []
    for found in all_results().values():
        command = f"`{' '.join(_command(found).split()[:2])}`"
        kinds: dict[tuple[str, str], list[dict[str, Any]]] = {}
        for one in found.get("targets", []):
            if not one["met"]:
                kind = one["what"].rpartition(": ")[2], one["target"]
                kinds.setdefault(kind, []).append(one)
        for (what, target), alike in kinds.items():
            text = target.replace("<=", "≤").replace(">=", "≥")
            shown = [(one["what"], one["measured"]) for one in alike]
            if len(alike) >= MANY_ALIKE:
                worst = max if target.startswith("<=") else min
                value = worst(one["measured"] for one in alike)
                shown = [(f"{what}, worst of {len(alike)}", value)]
            rows += [[command, name, f"{value:.4g}", text] for name, value in shown]
    return ["benchmark", "figure", "measured", "target"], rows


def _command(found: dict[str, Any]) -> str:
    return str(found["command"]).removeprefix("python -m benchmarks.")


def date_of(found: dict[str, Any]) -> str:
    return str(found["date"])


def lines_of(head: list[str], rows: list[list[Any]]) -> str:
    """A table as a document has it."""
    return "\n".join([_line(head), "|" + "---|" * len(head), *map(_line, rows)])


def _line(cells: Iterable[Any]) -> str:
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _cell(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def _first(value: Any) -> Any:
    return value[0] if isinstance(value, list) else value


def page() -> str:
    """The page as the results have it."""
    tables = {"summary": summary(), "missed": missed()}
    for name, make in TABLES.items():
        path = RESULTS / f"{name}.json"
        tables[name] = make(result(path)) if path.exists() else (["not measured"], [])
    return TEXT.format(**{name: lines_of(*table) for name, table in tables.items()})


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
