"""How long the window's event loop is away, in a tour of everything a person does.

    python benchmarks/window.py [--offscreen] [--haste 0.4] [--only NAME] [--gaps FILE]

A timer of 5 ms beats in the real window, on a screen of its own with sound and the
simulated device. A gap is the time between two beats; where one is long, the tour's step
and the functions the window's thread was in are told. Judged is the whole gap, also the time
in which that thread could have run but others had the cores.
"""

import argparse
import contextlib
import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
from common import need, save, screen, sound_server, table

LIMIT_MS = 50.0
SHOWN, PARTICIPANTS = 14, 15
LONGEST_S = 900.0


def judge(seen: dict[str, Any]) -> dict[str, Any]:
    """Return the figures of the gaps."""
    gaps_ms, long = 1e3 * np.array(seen.pop("gaps_s")), seen.pop("long_gaps")
    worst: dict[str, dict[str, Any]] = {}
    for gap in long:
        gap["own_s"] = max(0.0, gap["gap_s"] - gap["waited_for_a_core_s"])
        name = gap["script"] or "begin"
        if gap["gap_s"] > worst.get(name, {"gap_s": 0.0})["gap_s"]:
            worst[name] = gap
    short_ms = gaps_ms[gaps_ms <= 1e3 * seen["long_s"]]
    own_ms = np.append(short_ms, [1e3 * gap["own_s"] for gap in long])
    return {
        **seen,
        "beats": len(gaps_ms),
        "gap_ms": _quantiles(gaps_ms),
        "own_ms": _quantiles(own_ms),
        "above_limit": int(np.count_nonzero(gaps_ms > LIMIT_MS)),
        "worst": sorted(
            (_shown(name, gap) for name, gap in worst.items()),
            key=lambda row: -row["gap_ms"],
        ),
        "load_average": os.getloadavg(),
    }


def _shown(name: str, gap: dict[str, Any]) -> dict[str, Any]:
    return {
        "step": name,
        "gap_ms": 1e3 * gap["gap_s"],
        "own_ms": 1e3 * gap["own_s"],
        "computed_ms": 1e3 * gap["computed_s"],
        "in": where(gap["stacks"]),
    }


def _quantiles(gaps_ms: Any) -> dict[str, float]:
    quantiles = (("p50", 0.5), ("p99", 0.99), ("p999", 0.999), ("max", 1.0))
    return {name: float(np.quantile(gaps_ms, q)) for name, q in quantiles}


def report(figures: dict[str, Any]) -> None:
    """Print gaps, the worst steps, and where these were."""
    print(f"{sum(figures['things'].values())} things, {figures['beats']} beats")
    for name, text in (("gap_ms", "gap"), ("own_ms", "without waiting for a core")):
        values = ", ".join(f"{k} {v:.1f}" for k, v in figures[name].items())
        print(f"{text}, ms: {values}")
    print(f"{figures['above_limit']} gaps are above {LIMIT_MS:.0f} ms")
    rows = [list(row.values()) for row in figures["worst"][:SHOWN]]
    print(table(["step", "gap ms", "own", "computed", "in"], rows))
    for text in figures["failed"]:
        print(f"failed: {text}")


def where(stacks: list[dict[str, Any]]) -> str:
    """Return the function of ours that most samples were in."""
    counts: defaultdict[str, int] = defaultdict(int)
    for stack in stacks:
        counts[" < ".join(stack["window"][:4])] += 1
    return max(counts, key=counts.__getitem__) if counts else ""


def _answer_a_study(folder: Path) -> None:
    """Let simulated people take part in a study, to be analysed in the tour."""
    words = ["study", "simulate", str(folder), "--participants", str(PARTICIPANTS)]
    command = [sys.executable, "-m", "app", *words]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def main() -> int:
    """Prepare a screen and a sound server, and take the tour on them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--offscreen", action="store_true")
    parser.add_argument("--no-sound", action="store_true")
    parser.add_argument("--haste", type=float, default=0.4)
    parser.add_argument("--only", default="")
    parser.add_argument("--gaps", default="", help="file for all long gaps")
    parser.add_argument("--folder", default="")
    options = parser.parse_args()
    if options.folder:
        from window_tour import use

        return use(options)
    need(*([] if options.offscreen else ["Xvfb"]))
    need(*([] if options.no_sound else ["pulseaudio", "pactl"]))
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="hp-window-"))
        environment = {**os.environ, "XDG_CONFIG_HOME": folder}
        environment["QT_QPA_PLATFORM"] = "offscreen"
        if not options.offscreen:
            environment |= stack.enter_context(screen())
        if not options.no_sound:
            environment |= stack.enter_context(sound_server())
        _answer_a_study(Path(folder) / "answered")
        command = [sys.executable, __file__, *sys.argv[1:], "--folder", folder]
        subprocess.run(command, env=environment, check=True, timeout=LONGEST_S)
        seen = json.loads((Path(folder) / "seen.json").read_text())
    if options.gaps:
        Path(options.gaps).write_text(json.dumps(seen["long_gaps"], indent=1))
    figures = judge(seen)
    report(figures)
    if not options.only:
        print(f"saved {save('window', figures).name}")
    return 0 if figures["gap_ms"]["p999"] <= LIMIT_MS else 1


if __name__ == "__main__":
    sys.exit(main())
