"""What is skipped, what that saves, and what each stage of playing costs.

    python benchmarks/skips.py [--rounds 5] [--only NAME ...] [--no-runs]

Every case does the same work with its skip and without it, in turns; CPU time of this
process (all its threads) for each picture, tick, packet or seek, medians of the rounds.
What the X server does for a painting is not in it. The muted run is a process tree of its
own, sound process included. With `--only`, figures of an earlier run stay beside the new
ones. Tests hold what remains equal (`tests/**/test_skips.py`,
`tests/app/test_unseen.py`).
"""

import argparse
import json
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from common import (
    RESULTS,
    player_command,
    run_measured,
    save,
    screen,
    scrolling_clip,
    sound_server,
    table,
)

if TYPE_CHECKING:
    from skip_cases import Case

CLIP_S, RUN_S = 8.0, 5.0
WITH, WITHOUT = "with", "without"
MUTED = "`--headless --mute`: sound decoding, sound process"


def us_each(run: Callable[[], int]) -> float:
    """Return the CPU time of one unit, us."""
    begin_s = time.process_time()
    count = run()
    return 1e6 * (time.process_time() - begin_s) / count


def compare(case: "Case", rounds: int) -> dict[str, Any]:
    """Return the medians with and without the skip, and of the ratios."""
    found: dict[str, list[float]] = {WITH: [], WITHOUT: []}
    for name in (WITH, WITHOUT):  # what runs first is slow
        case.run(name == WITH)
    for number in range(rounds):
        for name in (WITH, WITHOUT) if number % 2 else (WITHOUT, WITH):
            found[name].append(us_each(lambda n=name: case.run(n == WITH)))
    return summary(found) | {"unit": case.unit}


def summary(found: dict[str, list[float]]) -> dict[str, Any]:
    """Return medians, and the median, least and largest ratio."""
    pairs = zip(found[WITH], found[WITHOUT], strict=True)
    ratios = [a / b for a, b in pairs]
    return {
        **{name: statistics.median(values) for name, values in found.items()},
        "ratio": statistics.median(ratios),
        "ratios": [min(ratios), max(ratios)],
    }


def muted_runs(clip: Path, rounds: int) -> dict[str, Any]:
    """Play without a window, with sound and without; CPU time per second played."""
    found: dict[str, list[float]] = {WITH: [], WITHOUT: []}
    command = player_command("play", str(clip), "--headless", "--device", "none")
    command += ["--duration", str(RUN_S), "--json"]
    with sound_server() as environment:
        for number in range(rounds):
            for name in (WITH, WITHOUT) if number % 2 else (WITHOUT, WITH):
                more = ["--mute"] if name == WITH else []
                _, cpu_s, _ = run_measured([*command, *more], environment, 60.0)
                found[name].append(1e6 * cpu_s / RUN_S)
    return summary(found) | {"unit": "second"}


def earlier(part: str) -> dict[str, Any]:
    """Return a part of what was saved before."""
    path = RESULTS / "skips.json"
    found: dict[str, Any] = json.loads(path.read_text()) if path.exists() else {}
    return dict(found.get(part, {}))


def report(cases: dict[str, Any], stages: dict[str, Any], options: Any) -> None:
    """Print both tables and keep the figures."""
    rows = [
        [
            name,
            f["unit"],
            f"{f[WITH]:.1f}",
            f"{f[WITHOUT]:.1f}",
            f"{f['ratio']:.3f}",
            f"{f['ratios'][0]:.3f} to {f['ratios'][1]:.3f}",
        ]
        for name, f in cases.items()
    ]
    print(table(["skipped", "per", "with, us", "without", "ratio", "of rounds"], rows))
    if stages:
        rows = [[n, f["unit"], f"{f['us']:.2f}"] for n, f in stages.items()]
        print("\n" + table(["stage", "per", "us"], rows))
    if options.only:
        cases, stages = earlier("skips") | cases, earlier("stages") | stages
    figures = {"rounds": options.rounds, "skips": cases, "stages": stages}
    print(f"saved {save('skips', figures).name}")


def main() -> int:
    """Measure everything in turns."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", nargs="*", default=[], help="part of a name")
    parser.add_argument("--no-runs", action="store_true", help="no muted runs")
    options = parser.parse_args()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="hp-")))
        os.environ.update(stack.enter_context(screen()))
        os.environ["XDG_CONFIG_HOME"] = str(folder)
        clip = scrolling_clip(folder, CLIP_S, "1280x720", 30)
        # only now: Qt takes the screen when it is loaded
        from skip_cases import all_cases
        from skip_stages import all_stages

        def is_wanted(name: str) -> bool:
            return not options.only or any(part in name for part in options.only)

        cases = {
            name: compare(make(), options.rounds)
            for name, make in all_cases(folder, clip, stack).items()
            if is_wanted(name)
        }
        if not options.no_runs and is_wanted(MUTED):
            cases[MUTED] = muted_runs(clip, max(2, options.rounds // 2))
        stages: dict[str, Any] = {}
        wanted = [s for s in all_stages(folder, clip, stack) if is_wanted(s.name)]
        taken: dict[str, list[float]] = {stage.name: [] for stage in wanted}
        for _ in range(options.rounds):
            for stage in wanted:
                taken[stage.name].append(us_each(stage.run))
        for stage in wanted:
            us = statistics.median(taken[stage.name])
            stages[stage.name] = {"unit": stage.unit, "us": us}
        report(cases, stages, options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
