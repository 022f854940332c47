"""Half an hour of normal use, and every RAMP or TRIP that nobody has asked for.

    python benchmarks/nuisance.py [--minutes 30] [--seed 1] [--offscreen] [--no-sound]

The real window plays the demo over and over with the simulated device, on a screen and
a sound server of its own, while a script uses everything there is (nuisance_script).
Every tick of the loop is read; a reaction that the script did not cause is a nuisance.
Beside it stand the gaps between heartbeats: where the window's thread was meanwhile, how
long it computed, waited for a core, or slept, and what the machine stalled by itself.
"""

import argparse
import contextlib
import faulthandler
import json
import os
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from common import need, save, screen, sound_server
from nuisance_beats import Beats
from sentinel import Sentinel, sentinel
from starved import PERIOD_S, Starved

from hapticplayer.haptics.residence import Residence

GRACE_S = 0.3
MACHINE_SHARE = 0.5  # of a gap that the machine and other programs explain
# By the first word of a cause: how long before a reaction the machine must have taken
# how much, s, to be the reason.
BEFORE = defaultdict(
    lambda: (0.05, 0.01),
    {"HEARTBEAT": (0.2, 0.075), "CLOCK": (0.2, 0.075), "REPLY": (0.12, 0.01)},
)
SOUND = (3.0, 0.05)
MOST_GAPS = 40
# A moment is undisturbed while no core has stood still for so long, in all, within so
# long before it: twice as long as the slowest rule waits.
STOOD_STILL_S, BEFORE_S = 0.01, 0.2
BIN_S = 0.01
STALE_S = 0.02


def use(options: argparse.Namespace) -> int:
    """Run the window with the script, and write what was seen."""
    from nuisance_script import Places, Script
    from nuisance_watch import Watch
    from PySide6.QtCore import QTimer

    from app.bridge.settings import Settings
    from app.player.application import make_application
    from app.player.video_surface import SurfaceSink, VideoSurface
    from app.player.window import PlayerWindow
    from hapticplayer.clock import SystemClock
    from hapticplayer.playback.clock import AudioReport
    from hapticplayer.playback.player import Player
    from hapticplayer.playback.sound_process import SoundProcess
    from hapticplayer.playback.source import open_source
    from hapticplayer.simulation.demo import demo_folder

    folder, demo = Path(options.folder), demo_folder()
    beats = Beats()

    class HeardPlayer(Player):
        def poll(self) -> float:
            next_s = super().poll()
            beats.doing = script.doing
            beats.beat()
            return next_s

        def _resync(self, report: AudioReport) -> None:
            beats.resyncs_s.append(clock.now_s())
            super()._resync(report)

    application, clock, surface = make_application(), SystemClock(), VideoSurface()
    audio = None if options.no_sound else SoundProcess
    player = HeardPlayer(clock, SurfaceSink(surface), audio=audio)
    window = PlayerWindow(player, surface, clock, Settings(folder / "window.json"))
    watch = Watch(player, GRACE_S)
    places = Places(demo, demo / "clip.mp4", motion_log(demo, folder), folder)
    script = Script(window, watch, clock, places, options.seed)
    script.only = options.only
    player.set_device("simulated")
    window.show()
    window.session.show_source(open_source(demo))
    player.play()
    window.session.gateway.install()
    script.start()
    QTimer.singleShot(round(60e3 * options.minutes), lambda: application.exit(0))
    application.exec()
    script.stop()
    beats.end()
    window.session.gateway.uninstall()
    snapshot = player.snapshot()
    seen = {
        "minutes": options.minutes,
        "end_s": clock.now_s(),
        "scheduling": snapshot.scheduling,
        "platform": application.platformName(),
        "sound": snapshot.audio,
        "things": script.done,
        "told": script.told,
        "ticks": dict(watch.modes),
        "lost": watch.lost,
        "causes": watch.counts(watch.reactions),
        "reactions": [{**asdict(r), "cause": r.cause.name} for r in watch.reactions],
        "gaps_s": beats.gaps_s,
        "long_gaps": beats.long,
        "resyncs_s": beats.resyncs_s,
    }
    window.close()
    (folder / "seen.json").write_text(json.dumps(seen))
    return 0


def motion_log(demo: Path, folder: Path) -> Path:
    """Write the demo's motion as a CSV that can be imported."""
    with np.load(demo / "imu.npz") as imu:
        rows = np.column_stack(
            [imu["time_s"], imu["specific_force_mps2"], imu["angular_rate_radps"]]
        )
    path = folder / "imu.csv"
    header = "time_s,ax,ay,az,gx,gy,gz"
    np.savetxt(path, rows, "%.6f", delimiter=",", header=header, comments="")
    return path


def judge(
    seen: dict[str, Any], witness: Sentinel, starved: Starved, nice: int
) -> dict[str, Any]:
    """Return the figures; what the machine explains is told apart."""
    gaps_s = np.array(seen.pop("gaps_s"))
    resyncs_s = seen.pop("resyncs_s")
    end_s = seen.pop("end_s")
    begin_s = end_s - 60.0 * seen["minutes"]

    def lost_s(begin_s: float, end_s: float) -> float:
        """Return what stalls of the machine and other programs took."""
        waited_s = starved.waited_s(begin_s, end_s)
        return max(witness.stalled_s(begin_s, end_s), waited_s)

    for gap in seen["long_gaps"]:
        gap["machine_s"] = lost_s(gap["begin_s"], gap["begin_s"] + gap["gap_s"])
        gap["is_of_the_machine"] = gap["machine_s"] > MACHINE_SHARE * gap["gap_s"]
    nuisances = [r for r in seen.pop("reactions") if not r["by"]]
    for nuisance in nuisances:
        at_s = nuisance["monotonic_s"]
        if nuisance["cause"] == "COMMAND_STALE":
            at_s += STALE_S  # the tick has begun in time, and then stood still
        before_s, least_s = BEFORE[nuisance["cause"].partition("_")[0]]
        if any(0.0 <= at_s - resync_s < GRACE_S for resync_s in resyncs_s):
            nuisance["cause"] += " after a leap of the sound"
            before_s, least_s = SOUND
        nuisance["machine_s"] = lost_s(at_s - before_s, at_s)
        nuisance["is_of_the_machine"] = nuisance["machine_s"] > least_s
        stalled_s = witness.stalled_s(at_s - BEFORE_S, at_s)
        nuisance["is_undisturbed"] = stalled_s < STOOD_STILL_S
    stalls_s = [late_s for _, late_s in witness.stalls()]
    return {
        **seen,
        "nice": nice,
        "share_with_force": _share_with_force(seen["ticks"]),
        "nuisances": nuisances,
        "ramps": sum(r["had_force"] or r["is_trip"] for r in nuisances),
        "not_of_the_machine": sum(not r["is_of_the_machine"] for r in nuisances),
        "undisturbed_minutes": undisturbed_s(witness, begin_s, end_s) / 60.0,
        "nuisances_undisturbed": sum(r["is_undisturbed"] for r in nuisances),
        "gap_ms": {
            name: 1e3 * float(np.quantile(gaps_s, q))
            for name, q in (("p50", 0.5), ("p99", 0.99), ("p999", 0.999), ("max", 1.0))
        },
        "resyncs_of_the_sound": len(resyncs_s),
        "machine_stalls": {
            "count": len(stalls_s),
            "longest_ms": 1e3 * max(stalls_s, default=0.0),
        },
        "load_average": os.getloadavg(),
    }


def undisturbed_s(witness: Sentinel, begin_s: float, end_s: float) -> float:
    """Return for how long nothing could be put down to the machine.

    In bins of 10 ms; the worst core counts.
    """
    count = int((end_s - begin_s) / BIN_S)
    longest = np.zeros(count)
    for stalls in witness.of_cores():
        still_s = np.zeros(count)
        for due_s, late_s in stalls:
            first = int((due_s - begin_s) / BIN_S)
            last = int((due_s + late_s - begin_s) / BIN_S)
            for at in range(max(first, 0), min(last + 1, count)):
                from_s = max(due_s, begin_s + at * BIN_S)
                until_s = min(due_s + late_s, begin_s + (at + 1) * BIN_S)
                still_s[at] += max(0.0, until_s - from_s)
        total = np.concatenate([np.zeros(round(BEFORE_S / BIN_S)), np.cumsum(still_s)])
        longest = np.maximum(longest, total[-count:] - total[:count])
    return BIN_S * float(np.count_nonzero(longest < STOOD_STILL_S))


def _share_with_force(ticks: dict[str, int]) -> float:
    acting = ticks.get("ENTERING", 0) + ticks.get("FOLLOWING", 0)
    return acting / max(1, sum(ticks.values()))


def prefer(nice: int) -> None:
    """Give window, screen and sound a priority over other sessions (root only).

    The kernel shares the cores among sessions first, so `nice` alone does nothing.
    """
    for task in Path("/proc/self/task").iterdir():
        for pid in (task / "children").read_text().split():
            os.setpriority(os.PRIO_PROCESS, int(pid), nice)
            with contextlib.suppress(OSError):  # a kernel without groups of sessions
                Path(f"/proc/{pid}/autogroup").write_text(str(nice))


def report(figures: dict[str, Any]) -> None:
    """Print what matters."""
    print(
        f"{figures['minutes']:.1f} minutes, {sum(figures['things'].values())} things:"
    )
    print("  " + ", ".join(f"{k} {v}" for k, v in sorted(figures["things"].items())))
    print(f"force on the hand {100 * figures['share_with_force']:.0f} % of the time")
    print("reactions of the loop:")
    for cause, count in sorted(figures["causes"].items()):
        print(f"  {count:5d}  {cause}")
    for nuisance in figures["nuisances"]:
        print("  ", {**nuisance, "monotonic_s": round(nuisance["monotonic_s"], 3)})
    if figures["told"]:
        print("the window told:", figures["told"])
    gaps = figures["gap_ms"]
    print(
        "ms between heartbeats: " + ", ".join(f"{k} {v:.0f}" for k, v in gaps.items())
    )
    for gap in figures["long_gaps"][:MOST_GAPS]:
        print(
            f"  {1e3 * gap['gap_s']:.0f} ms in {gap['script'] or 'between things'}: "
            f"computed {1e3 * gap['computed_s']:.0f}, waited for a core "
            f"{1e3 * gap['waited_for_a_core_s']:.0f}, by the machine "
            f"{1e3 * gap['machine_s']:.0f}, pages from the disk "
            f"{gap['waits_for_the_disk']}"
        )
    print(f"machine: {figures['machine_stalls']}, load {figures['load_average']}")
    print(
        f"nuisances: {len(figures['nuisances'])}, of these with force on the hand "
        f"{figures['ramps']}; not explained by the machine: "
        f"{figures['not_of_the_machine']}"
    )
    print(
        f"undisturbed by the machine: {figures['undisturbed_minutes']:.1f} minutes, "
        f"nuisances in these: {figures['nuisances_undisturbed']}"
    )


def stage(
    stack: contextlib.ExitStack, folder: str, *, offscreen: bool, with_sound: bool
) -> dict[str, str]:
    """Start a screen and a sound server, and return the environment of the window."""
    environment = {**os.environ, "XDG_CONFIG_HOME": folder}
    if offscreen:
        environment["QT_QPA_PLATFORM"] = "offscreen"
    else:
        need("Xvfb")
        environment.update(stack.enter_context(screen()))
    if with_sound:
        need("pulseaudio", "pactl")
        environment.update(stack.enter_context(sound_server()))
    return environment


def main() -> int:
    """Start screen and sound, run the window in a process of its own, and judge."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=30.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--offscreen", action="store_true")
    parser.add_argument("--no-sound", action="store_true")
    parser.add_argument("--only", default="", help="one thing of the script")
    parser.add_argument("--nice", type=int, default=0, help="where others compute, too")
    parser.add_argument(
        "--unlocked", action="store_true", help="leave code to the kernel"
    )
    parser.add_argument("--folder", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.folder:
        faulthandler.enable()
        if options.unlocked:
            Residence.lock = lambda _self: 0  # type: ignore[method-assign]
        return use(options)
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        environment = stage(
            stack, folder, offscreen=options.offscreen, with_sound=not options.no_sound
        )
        witness = stack.enter_context(sentinel())
        command = [sys.executable, *sys.argv, "--folder", folder]
        window = subprocess.Popen(command, env=environment, start_new_session=True)
        if options.nice:
            prefer(options.nice)
        starved = Starved()
        while window.poll() is None:
            starved.look()
            time.sleep(PERIOD_S)
        if window.returncode:
            sys.exit(f"the window ended with {window.returncode}")
        seen = json.loads((Path(folder) / "seen.json").read_text())
        figures = judge(seen, witness, starved, options.nice)
    report(figures)
    print(f"saved {save('nuisance', figures).name}")
    return 1 if figures["not_of_the_machine"] else 0


if __name__ == "__main__":
    sys.exit(main())
