"""Normal use, and every RAMP or TRIP that the person did not cause.

The real window plays the demo with the simulated device, on a screen and a sound server
of its own, while a scripted person uses everything there is. Every tick of the haptic
loop is read; a reaction that no action explains is a nuisance. Each stands beside what
the machine did at that time, watched from outside: cores that stalled, threads that
were ready and had no core. Beside it the gaps between heartbeats of the window. With
`--quick` 15 s in a hurry, without screen and sound; what load alone can cause is not
judged then.
"""

import argparse
import contextlib
import faulthandler
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report
from benchmarks.stage import screen, sound_server
from hapticplayer.haptics.contract import Cause
from hapticplayer.playback.player import Player
from tools.reactions import OF_LOAD, Watch
from tools.witness import Seen, machine_witness

GRACE_S, QUICK_GRACE_S = 0.3, 15.0
LEAST_KINDS, LEAST_SHARE, QUICK_LEAST_SHARE = 10, 0.2, 0.02
MACHINE_SHARE = 0.5  # of a gap that stalls and other programs explain
# By the first word of a cause: how long before a reaction the machine must have taken
# how much, s, to be the reason.
BEFORE = defaultdict(
    lambda: (0.05, 0.01),
    {"HEARTBEAT": (0.2, 0.075), "CLOCK": (0.2, 0.075), "REPLY": (0.12, 0.01)},
)
STALE_S = 0.02


def judge(seen: dict[str, Any], machine: Seen, *, judge_load: bool) -> dict[str, Any]:
    """Return the figures; what the machine explains is counted apart."""
    gaps_s = np.array(seen.pop("gaps_s"))
    del seen["end_s"]

    def lost_s(begin_s: float, end_s: float) -> float:
        """The time that stalls of the machine and other programs took."""
        waited_s = machine.waited_s(begin_s, end_s)
        return max(machine.stalled_s(begin_s, end_s), waited_s)

    for gap in seen["long_gaps"]:
        gap["machine_s"] = lost_s(gap["begin_s"], gap["begin_s"] + gap["gap_s"])
    found = [r for r in seen.pop("reactions") if not r["by"]]
    if not judge_load:
        found = [r for r in found if Cause[r["cause"]] not in OF_LOAD]
    for one in found:
        at_s = one["monotonic_s"]
        if one["cause"] == "COMMAND_STALE":
            at_s += STALE_S  # the tick has begun in time, and then stalled
        before_s, least_s = BEFORE[one["cause"].partition("_")[0]]
        one["machine_s"] = lost_s(at_s - before_s, at_s)
        one["is_explained"] = one["machine_s"] > least_s
    quantiles = {"p50": 0.5, "p99": 0.99, "p999": 0.999, "max": 1.0}
    return {
        **seen,
        "nuisances": found,
        "with_force": sum(r["had_force"] or r["is_trip"] for r in found),
        "not_of_the_machine": sum(not r["is_explained"] for r in found),
        "gap_ms": {
            k: 1e3 * float(np.quantile(gaps_s, q)) for k, q in quantiles.items()
        },
        "machine_stalls": machine.summary(),
    }


@contextlib.contextmanager
def stage(*, is_offscreen: bool, has_sound: bool) -> Iterator[tuple[Path, Any]]:
    """Yield a folder, and the environment with a screen and a sound server."""
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="hp-window-"))
        environment = {**os.environ, "XDG_CONFIG_HOME": folder}
        environment["QT_QPA_PLATFORM"] = "offscreen"
        if not is_offscreen:
            environment |= stack.enter_context(screen())
        if has_sound:
            environment |= stack.enter_context(sound_server()).environment
        yield Path(folder), environment


def window_command(folder: Path, minutes: float, **chosen: Any) -> list[str]:
    settings = {"folder": str(folder), "minutes": minutes, **chosen}
    module = "benchmarks.robustness.nuisance"
    return [sys.executable, "-m", module, json.dumps(settings)]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--minutes", type=float, help="(10)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--offscreen", action="store_true")
    parser.add_argument("--no-sound", action="store_true")
    parser.add_argument("--only", default="", help="one thing that a person does")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the window in a process of its own, watch, and judge."""
    quick = options.quick
    has_sound = not (options.no_sound or quick)
    minutes = options.minutes or (0.25 if quick else 10.0)
    chosen = {"seed": options.seed, "only": options.only, "sound": has_sound}
    chosen |= {"quick": quick, "locked": True}
    with (
        stage(is_offscreen=options.offscreen or quick, has_sound=has_sound) as place,
        machine_witness() as witness,
    ):
        folder, environment = place
        command = window_command(folder, minutes, **chosen)
        window = subprocess.run(command, env=environment, cwd=ROOT, check=False)
        if window.returncode:
            sys.exit(f"the window ended with {window.returncode}")
        seen = json.loads((folder / "seen.json").read_text())
        figures = judge(seen, witness.seen(), judge_load=not quick)
    show(figures, report)
    if not options.only:
        kinds, share = len(figures["things"]), figures["share_with_force"]
        report.target("kinds of things done", kinds, (">=", LEAST_KINDS))
        least = QUICK_LEAST_SHARE if quick else LEAST_SHARE
        report.target("share of the time with force", share, (">=", least))
    count = figures["not_of_the_machine"]
    report.target("nuisances that the machine does not explain", count, ("<=", 0))
    report.figures |= {**figures, "long_gaps": len(figures["long_gaps"])}


def show(figures: dict[str, Any], report: Report) -> None:
    """Print what matters."""
    things = sorted(figures["things"].items())
    print(
        f"{figures['minutes']:.1f} minutes: " + ", ".join(f"{k} {v}" for k, v in things)
    )
    if figures["shown"]:
        print("messages of the window:", figures["shown"])
    report.table("Reactions", ["", "times"], sorted(figures["reactions_by"].items()))
    report.table(
        "Heartbeats, ms apart", list(figures["gap_ms"]), [figures["gap_ms"].values()]
    )
    keys = ("doing", "gap_s", "computed_s", "waited_s", "machine_s", "disk_waits")
    rows = [[gap[key] for key in keys] for gap in figures["long_gaps"][:20]]
    report.table("Long gaps", keys, rows)
    for one in figures["nuisances"]:
        print(one)
    print(
        f"nuisances {len(figures['nuisances'])}, with force {figures['with_force']}; "
        f"machine stalls {figures['machine_stalls']}"
    )


def _use_the_window(chosen: dict[str, Any]) -> None:
    """Run the window with the person, and write what was seen."""
    from PySide6.QtCore import QTimer

    from benchmarks.person import Person
    from benchmarks.window import Beats, open_window
    from hapticplayer.playback.source import open_source

    faulthandler.enable()
    folder, beats = Path(chosen["folder"]), Beats()

    class HeardPlayer(Player):
        def poll(self) -> float:
            next_s = super().poll()
            beats.doing = person.doing
            beats.beat()
            return next_s

    if not chosen["locked"]:
        from app.player import application as app_module

        app_module.lock_memory = bool  # type: ignore[attr-defined]
    settings = folder / "window.json"
    opened = open_window(settings, sound=chosen["sound"], player=HeardPlayer)
    application, player, window = opened.application, opened.player, opened.window
    quick = chosen["quick"]
    watch = Watch(player, QUICK_GRACE_S if quick else GRACE_S)
    person = Person(window, folder, chosen["seed"], haste=0.1 if quick else 1.0)
    person.only = chosen["only"]
    person.on_check = watch.read
    person.on_action = lambda *action: watch.expect(opened.clock.now_s(), *action)
    window.session.show_source(open_source(person.sequence))
    player.play()
    window.session.gateway.install()
    person.start()

    def end_if_enough() -> None:
        if quick and not chosen["only"] and len(person.done) < LEAST_KINDS:
            QTimer.singleShot(1000, end_if_enough)  # a busy machine
        else:
            application.exit(0)

    begin_s = opened.clock.now_s()
    QTimer.singleShot(round(60e3 * chosen["minutes"]), end_if_enough)
    application.exec()
    person.stop()
    beats.end()
    window.session.gateway.uninstall()
    end_s, snapshot = opened.clock.now_s(), player.snapshot()
    seen = {
        "minutes": (end_s - begin_s) / 60.0,
        "end_s": end_s,
        "scheduling": snapshot.leading.scheduling,
        "platform": application.platformName(),
        "sound": snapshot.audio,
        "things": person.done,
        "shown": person.shown,
        "gaps_s": beats.gaps_s,
        "long_gaps": beats.long,
        **_reactions(watch),
    }
    window.close()
    (folder / "seen.json").write_text(json.dumps(seen))


def _reactions(watch: Watch) -> dict[str, Any]:
    acting = watch.modes["ENTERING"] + watch.modes["FOLLOWING"]
    return {
        "share_with_force": acting / max(1, sum(watch.modes.values())),
        "ticks_lost": watch.lost,
        "reactions": [{**asdict(r), "cause": r.cause.name} for r in watch.reactions],
        "reactions_by": Counter(
            f"{'TRIP' if r.is_trip else 'RAMP'} {r.cause.name} by {r.by or 'nothing'}"
            for r in watch.reactions
        ),
    }


if __name__ == "__main__":
    _use_the_window(json.loads(sys.argv[1]))
