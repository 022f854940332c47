"""Writes docs/performance.md from the saved results of benchmarks.

python -m tools.performance_page
"""

import json
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
RESULTS, PAGE = ROOT / "benchmarks" / "results", ROOT / "docs" / "performance.md"
MOST_SHOWN = 12
Table = tuple[list[str], list[list[Any]]]
TEXT = """# Performance

Written by `python -m tools.performance_page` from the results of the
[benchmarks](../benchmarks/README.md). Each ran beside its reference in the same rounds; ratios are
medians over the rounds. Error and run time of gravity removal are in [numerics.md](numerics.md).
A row is of the code of its date; those before 2026-11-24 have not been measured again since.

## All benchmarks

In brackets the target; what missed it is bold.

{summary}

## From a fault to no force, ms

Real faults at random moments under a turning force of 4 N, read from the device's side.

{faults}

## Lateness of the haptic loop, us

Beside cyclictest in the same rounds; `stress` holds the window's interpreter for 2 s every 7 s.

{loop}

## One tick of the Falcon's kinematics

Beside the same with numpy.linalg, and libnifalcon's half Newton steps.

{kinematics}

## Synchronisation of frame, sound and force, ms

Measured from outside: median and, in brackets, 95 % of the magnitude; positive: the first named is
later. Targets: sound - frame within 3 (6) and at most 2 worse than mpv, force - frame 0 to 3 (5),
force - sound within 2 (4). Other speeds are reported only.

{outside}

## Synchronisation of a log with its clip by three taps

{pats}

## Synchronisation of a log with its clip by the frames

Clips of 28 s, log at 200 and 30 Hz; errors of confident results in the middle of the clip, ms.

{pictures}

## What skips save

{skips}
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
    rows = [
        [kind, *(f"{100 * one[key]:.1f}" for key in keys), one["run_ms"]]
        for kind, one in found["60 s"].items()
    ]
    rows += [
        [f"{kind}, 600 s: {one['end_rms_ms']:.1f} ms RMS at the end", "", "", "", "",
         one["run_ms"]]
        for kind, one in found["600 s"].items()
    ]  # fmt: skip
    header = ["clips", "half a frame %", "variance threshold %", "wrong, unflagged %"]
    return [*header, "right, flagged %", "ms"], rows


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


def kinematics(found: dict[str, Any]) -> Table:
    """Return time and error of one tick beside two other methods."""
    named = ("ours", "numpy", "half steps")
    keys = list(found["ours"])
    return ["", *keys], [[name, *found[name].values()] for name in named]


def columns(found: dict[str, Any]) -> Table:
    """Return a table that the result holds as it is."""
    return found["columns"], found["rows"]


TABLES: dict[str, Callable[[dict[str, Any]], Table]] = {
    "faults": faults,
    "outside": outside,
    "pats": pats,
    "pictures": columns,
    "loop": loop,
    "kinematics": kinematics,
    "skips": columns,
}


def result(path: Path) -> dict[str, Any]:
    """Return a saved result."""
    return dict(json.loads(path.read_text(encoding="utf-8")))


def summary() -> Table:
    """Return a row for each benchmark: targets, command, date and machine."""
    rows = []
    results = [result(path) for path in RESULTS.glob("*.json")]
    for found in sorted(results, key=lambda one: str(one["command"])):
        asked = found["targets"]
        missed = [one for one in asked if not one["met"]]
        figures = [_asked(one) for one in asked]
        if len(asked) > MOST_SHOWN:
            figures = [f"{len(asked) - len(missed)} of {len(asked)} targets met"]
            figures += [_asked(one) for one in missed]
        if "MB an hour" in found.get("columns", ()):
            figures = [
                f"{r[0]} {r[1]:+.1f} ± {r[2]:.1f} MB an hour" for r in found["rows"]
            ]
        machine = found["machine"]
        where = (
            f"{machine.get('processor', 'virtual machine')}, {machine['cores']} cores"
        )
        command = f"`{found['command'].removeprefix('python -m ')}`"
        text = "; ".join(figures) or "no target"
        rows.append([command, text, found["date"], where])
    return ["`python -m`", "measured (target)", "date", "machine"], rows


def _asked(one: dict[str, Any]) -> str:
    bound = one["target"].replace("<=", "≤").replace(">=", "≥")
    text = f"{one['what']} {_cell(one['measured'])} ({bound})"
    return text if one["met"] else f"**{text}**"


def _line(cells: Iterable[Any]) -> str:
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _cell(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def _first(value: Any) -> Any:
    return value[0] if isinstance(value, list) else value


def main() -> int:
    """Write the page."""
    tables = {"summary": summary()}
    for name, make in TABLES.items():
        tables[name] = make(result(RESULTS / f"{name}.json"))
    text = {
        name: "\n".join([_line(head), "|" + "---|" * len(head), *map(_line, rows)])
        for name, (head, rows) in tables.items()
    }
    PAGE.write_text(TEXT.format(**text), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
