"""Writes docs/performance.md from the saved results of benchmarks.

python -m tools.performance_page
"""

import json
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS, PAGE = ROOT / "benchmarks", ROOT / "docs" / "performance.md"
RESULTS = BENCHMARKS / "results"
MOST_SHOWN = 12
Table = tuple[list[str], list[list[Any]]]
TEXT = """# Performance

Written by `python -m tools.performance_page` from the results of the
[benchmarks](../benchmarks/README.md). A peer ran in the same rounds; ratios are medians over the
rounds. A row is of the code of its date. Gravity removal, error of the force and washout are in
[numerics.md](numerics.md).

## All benchmarks

In brackets the target; a figure that missed it is bold.

{summary}

## From a fault to no force, ms

Real faults at random moments under a rotating force of 4 N, read from the device's side.

{faults}

## Lateness of the haptic loop, us

Beside cyclictest in the same rounds; `stress` holds the window's interpreter for 2 s every 7 s.

{loop}

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

{pictures}
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


def pictures(found: dict[str, Any]) -> Table:
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


TABLES: dict[str, Callable[[dict[str, Any]], Table]] = {
    "faults": faults,
    "outside": outside,
    "pats": pats,
    "pictures": pictures,
    "loop": loop,
}


def result(path: Path) -> dict[str, Any]:
    """Return a saved result."""
    return dict(json.loads(path.read_text(encoding="utf-8")))


def kinematics(found: dict[str, Any]) -> list[str]:
    """Return time and error of one tick beside two other methods."""
    return [
        f"{name}: {_cell(found[name]['p50 us'])} us, p99 {_cell(found[name]['p99 us'])} "
        f"us, RMS error {_cell(found[name]['error rms mm'])} mm"
        for name in ("ours", "numpy", "half steps")
    ]


def skips(found: dict[str, Any]) -> list[str]:
    """Return the time with each skip as a share of the time without it."""
    ratios = [f"{what} {_cell(ratio)}" for what, _, _, _, ratio, *_ in found["rows"]]
    return ["time with each skip over the time without it", *ratios]


def memory(found: dict[str, Any]) -> list[str]:
    """Return the growth of each player."""
    return [f"{r[0]} {r[1]:+.1f} ± {r[2]:.1f} MB an hour" for r in found["rows"]]


FIGURES: dict[str, Callable[[dict[str, Any]], list[str]]] = {
    "kinematics": kinematics,
    "skips": skips,
    "memory": memory,
}
"""Of benchmarks without a target."""


def peers() -> dict[str, str]:
    """Return what each benchmark is compared with, by its command: its README's."""
    lines = (BENCHMARKS / "README.md").read_text(encoding="utf-8").splitlines()
    rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("| `")]
    return {" ".join(row[0].strip("`").split()[:2]): row[2] for row in rows}


def summary() -> Table:
    """Return a row for each benchmark: target, figure, peer, date and machine."""
    rows = []
    known = peers()
    results = {path.stem: result(path) for path in RESULTS.glob("*.json")}
    for name, found in sorted(results.items(), key=lambda one: one[1]["command"]):
        command = found["command"].removeprefix("python -m benchmarks.")
        where = found["machine"].get("processor", "virtual machine")
        rows.append([
            f"`{command}`",
            "; ".join(_figures(name, found)) or "no target",
            known[" ".join(command.split()[:2])],
            found["date"],
            f"{where}, {found['machine']['cores']} cores",
        ])  # fmt: skip
    header = ["`python -m benchmarks.`", "measured (target)", "peer or limit"]
    return [*header, "date", "machine"], rows


def _figures(name: str, found: dict[str, Any]) -> list[str]:
    """Return what is shown of a benchmark: of many targets only those missed."""
    if name in FIGURES:
        return FIGURES[name](found)
    asked = found["targets"]
    if len(asked) <= MOST_SHOWN:
        return [_asked(one) for one in asked]
    missed = [_asked(one) for one in asked if not one["met"]]
    return [f"{len(asked) - len(missed)} of {len(asked)} targets met", *missed]


def _asked(one: dict[str, Any]) -> str:
    bound = one["target"].replace("<=", "≤").replace(">=", "≥")
    text = f"{one['what']}: {_cell(one['measured'])} ({bound})"
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
