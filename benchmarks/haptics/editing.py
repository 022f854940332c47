"""The rendering of 75 s after an edit of one effect, and how soon a hand feels it.

True motion of simulated rides with three effects; in each round the amplitude of a knock
changes, at another place of the clip. `Rendering.track`, which keeps what the edit does
not reach, beside `render_preset` from scratch in the same rounds: both tracks have to be
the same bits. Then an edit while the real haptics processes play: from the edit to the
first tick of the new version, and to the end of the change-over, in real time.
"""

import argparse
import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.common import Report, interleaved, on_one_thread, ratio
from hapticplayer.clock import SystemClock
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.model import ForceTrack, MotionTrack, PlaybackClock
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence.presets import PRESETS, Rendering, render_preset

LENGTH_S = 75.0
SCENES = ("car-hard", "car-brisk", "bicycle", "walk", "run", "mountain-bike")
MOST_MS, MOST_FELT_MS = 100.0, 200.0
NEAR_N, LEAST_WAIT_S = 1e-5, 0.3
OTHERS = (
    Effect("gain", 12.0, 30.0, fade_in_s=0.5, fade_out_s=0.5),
    Effect("low-pass", 40.0, 60.0),
)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(15)")
    parser.add_argument("--scene", action="append", choices=SCENES)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure both, for each preset."""
    on_one_thread()
    rounds = options.rounds or (3 if options.quick else 15)
    scenes = options.scene or (SCENES[:2] if options.quick else SCENES)
    details: list[tuple[str, str, dict[str, float]]] = []
    for preset in PRESETS:
        for scene in scenes:
            found = _rendered(_motion(scene), preset.name, rounds)
            details.append((preset.name, scene, found))
    header = ["preset", "ride", "edit ms", "p90", "whole ms", "share", "least", "most"]
    rendered = [[name, scene, *times.values()] for name, scene, times in details]
    report.table("Processor time of a rendering of 75 s", header, rendered)
    for preset in PRESETS:
        own = [times["edit_ms"] for name, _, times in details if name == preset.name]
        what = f"{preset.name}: ms after an edit, median of the slowest ride"
        report.target(what, max(own), ("<=", MOST_MS))
    felt = _felt(_motion("car-hard"), rounds)
    rows = [[name, *values] for name, values in felt.items()]
    report.table("From an edit to the hand, ms", ["", "median", "most"], rows)
    for name, values in felt.items():
        report.target(f"an edit {name}, median ms", values[0], ("<=", MOST_FELT_MS))
    report.figures |= {
        "columns": header,
        "rows": rendered,
        "felt_ms": felt,
        "rounds": rounds,
    }


def _motion(scene: str) -> MotionTrack:
    """Return the true motion of a ride."""
    ride = simulate_motion(scene, 0, duration_s=LENGTH_S)
    count = len(ride.imu.time_s)
    return MotionTrack(
        time_s=ride.imu.time_s - ride.imu.time_s[0],
        acceleration_mps2=ride.acceleration_mps2,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, dtype=bool),
    )


def _effects(number: int) -> EffectList:
    """Return the list after an edit; no two are the same."""
    start_s = 2.0 + (17.3 * number) % (LENGTH_S - 5.0)
    amplitude = {"amplitude": 1.0 + 0.01 * number}
    knock = Effect("knock", start_s, start_s + 0.3, parameters=amplitude)
    return EffectList((*OTHERS, knock))


def _rendered(motion: MotionTrack, preset: str, rounds: int) -> dict[str, float]:
    """Return processor times, ms, and their ratio."""
    rendering = Rendering(motion, name=preset)
    rendering.track(_effects(0))
    made: dict[str, tuple[int, ForceTrack]] = {}
    counts = {"edit": 0, "whole": 0}

    def timed(name: str, render: Callable[[EffectList], ForceTrack]) -> float:
        counts[name] += 1
        effects = _effects(counts[name])
        begin_s = time.process_time()
        track = render(effects)
        taken_ms = 1e3 * (time.process_time() - begin_s)
        _compare(made, name, (counts[name], track))
        return taken_ms

    found = interleaved(
        {
            "edit": lambda: timed("edit", rendering.track),
            "whole": lambda: timed(
                "whole", lambda e: render_preset(motion, name=preset, effects=e)
            ),
        },
        rounds,
    )
    share = ratio(found["edit"], found["whole"])
    return {
        "edit_ms": statistics.median(found["edit"]),
        "edit_p90_ms": float(np.percentile(found["edit"], 90)),
        "whole_ms": statistics.median(found["whole"]),
        "share": share.median,
        "share_least": share.least,
        "share_most": share.largest,
    }


def _compare(
    made: dict[str, tuple[int, ForceTrack]], name: str, new: tuple[int, ForceTrack]
) -> None:
    """Refuse an edit that is another track than the whole rendering."""
    made[name] = new
    numbers = {number for number, _ in made.values()}
    if len(made) == 2 and len(numbers) == 1:
        one, other = (track for _, track in made.values())
        if one.force_n.tobytes() != other.force_n.tobytes():
            raise AssertionError(f"edit {new[0]}: not the bits of a whole rendering")


def _felt(motion: MotionTrack, rounds: int) -> dict[str, list[float]]:
    """Return times from an edit to what the loop plans: median and most, ms."""
    rendering = Rendering(motion, name="balanced")
    player = _Playing(rendering.track(_effects(0)))
    begun: list[float] = []
    over: list[float] = []
    try:
        for number in range(1, rounds + 1):
            first_ms, last_ms = player.edited(rendering, number)
            begun.append(first_ms)
            over.append(last_ms)
    finally:
        player.processes.close()
    return {
        "to the first tick of the new version": [statistics.median(begun), max(begun)],
        "to the end of the change-over": [statistics.median(over), max(over)],
    }


class _Playing:
    """Plays over and over, as a player that loops a span."""

    def __init__(self, track: ForceTrack) -> None:
        self._clock, self._track = SystemClock(), track
        self.processes = HapticsProcesses(self._clock)
        self.processes.wait_ready()
        self.processes.load({"track": track})
        self._start_s = self._clock.now_s()

    def edited(self, rendering: Rendering, number: int) -> tuple[float, float]:
        """Edit what plays; return ms until it begins and has ended to change over."""
        self._feed(lambda ticks: ticks["mode"][-1] == Mode.FOLLOWING)
        before = self._track
        now_s = self._clock.now_s()
        media_s = now_s - self._start_s
        amplitude = {"amplitude": 0.5 if number % 2 else -0.5}  # against the last one
        pulse = Effect("pulse", media_s, media_s + 2.0, parameters=amplitude)
        edit_s = self._clock.now_s()
        self._track = rendering.track(EffectList((*OTHERS, pulse)))
        self.processes.replace("track", self._track)
        ticks = self._feed(lambda ticks: self._is_over(ticks, edit_s))
        ticks = ticks[ticks["monotonic_s"] > edit_s]
        is_new = np.cumsum(_distance(ticks, before) > NEAR_N) > 0
        is_over = is_new & (_distance(ticks, self._track) < NEAR_N)
        first_s, last_s = (
            ticks["monotonic_s"][np.argmax(x)] for x in (is_new, is_over)
        )
        return 1e3 * float(first_s - edit_s), 1e3 * float(last_s - edit_s)

    def _is_over(self, ticks: Any, edit_s: float) -> bool:
        is_late = ticks["monotonic_s"][-1] > edit_s + LEAST_WAIT_S
        return bool(is_late and _distance(ticks[-1:], self._track)[0] < NEAR_N)

    def _feed(self, is_done: Callable[[Any], bool]) -> Any:
        """Keep the loop fed until a condition on its ticks holds; return them."""
        kept = []
        end_s = self._clock.now_s() + 20.0
        while (now_s := self._clock.now_s()) < end_s:
            self.processes.beat()
            self.processes.poll()
            clock = PlaybackClock(1, self._start_s, 0.0, 1.0, now_s + 0.15)
            self.processes.publish(clock, "track")
            kept.append(self.processes.read_ticks()[0])
            ticks = np.concatenate(kept)
            if len(ticks) and is_done(ticks):
                return ticks
            self._clock.sleep_until(now_s + 0.005)
        raise AssertionError("the loop does not play")


def _distance(ticks: Any, track: ForceTrack) -> Any:
    """Return how far what was planned is from a track, (N,) N."""
    return np.linalg.norm(ticks["planned_n"] - track.at(ticks["media_s"]), axis=1)
