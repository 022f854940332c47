"""The optimised washout beside classical ones at equal excursion.

Force of simulated rides (true motion, default mapping), for the hands of each preset
and for the yielding hand alone. Classical washouts: Butterworth high-passes of 2nd and 3rd
order (causal), of 1st and 2nd forwards and backwards (zero phase), and a gain; cut-off and
gain are the best of all that keep the hands as far inside as the optimised washout does, for
that ride. Excursion as the washout defines it: 10 ms ahead, without the device's spring.
Rides whose hands stay within the limit anyway have to come back unchanged; they do not
count in the ratios.
"""

import argparse
import dataclasses
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy import fft, signal

from benchmarks.common import Report, on_one_thread
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering import render_force
from hapticplayer.rendering.washout import Washout, washed_out
from hapticplayer.rendering.weighting import weighted
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.presets import PRESETS, washout_of
from hapticplayer.simulation.rides.catalogue import SCENES
from hapticplayer.simulation.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.simulation.rides.recording import simulate

RATE_HZ, PAD_S = 200.0, 10.0
STANDARD_GRAVITY_MPS2 = 9.80665
CUTOFFS_HZ = np.geomspace(0.01, 3.0, 30)
CAUSAL = ("causal 2nd", "causal 3rd")
MOST_OF_CAUSAL, MOST_OF_CLASSICAL = 0.55, 0.70
MOST_S_PER_MIN = 0.5


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--seeds", type=int, help="(3)")
    parser.add_argument("--seconds", type=float, default=60.0)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure weighted errors, unchanged rides and the time."""
    on_one_thread()
    balanced, equal = (washout_of(one, 4.5) for one in PRESETS[1:])
    alone = dataclasses.replace(equal, hands=equal.hands[:1])
    cases = {"balanced": balanced, "equal": equal, "yielding alone": alone}
    seeds = options.seeds or (1 if options.quick else 3)
    scenes = [*SCENES, *MOTION_SCENES]
    scenes = scenes[2::5] if options.quick else scenes
    found: dict[str, list[dict[str, Any]]] = {name: [] for name in cases}
    for scene in scenes:
        for seed in range(seeds):
            track = ride_force(scene, seed, options.seconds)
            for name, washout in cases.items():
                found[name].append(
                    {"ride": scene, "seed": seed, **compare(track, washout)}
                )
            reach = predict(track, track.end_s)["hands"]["relaxed"]["reach"]
            found["balanced"][-1]["predicted"] = reach
    rows = []
    for name, each in found.items():
        bound = [one for one in each if one["before"] > 1.0]
        rows.append([name, len(each), len(bound), *_medians(bound)])
    header = ["hands", "rides", "limited", *COLUMNS]
    report.table("Weighted error, medians of the limited rides", header, rows)
    report.figures |= {"columns": header, "rows": rows, "rides": found}
    _targets(report, found)


COLUMNS = ["optimised", "of best causal", "p90", "of best classical", "p90", "reach/R"]


def _medians(bound: list[dict[str, Any]]) -> list[float]:
    if not bound:
        return [float("nan")] * len(COLUMNS)
    causal, classical = ([one[key] for one in bound] for key in ("causal", "classical"))
    return [
        float(np.median([one["error"] for one in bound])),
        *np.percentile(causal, [50, 90]).tolist(),
        *np.percentile(classical, [50, 90]).tolist(),
        max(one["after"] for one in bound),
    ]


def _targets(report: Report, found: dict[str, list[dict[str, Any]]]) -> None:
    equal = _medians([one for one in found["equal"] if one["before"] > 1.0])
    report.target(
        "equal: error of best causal, median", equal[1], ("<=", MOST_OF_CAUSAL)
    )
    what = "equal: error of best classical, median"
    report.target(what, equal[3], ("<=", MOST_OF_CLASSICAL))
    everything = [one for each in found.values() for one in each]
    changed = sum(one["changed"] for one in everything if one["before"] <= 1.0)
    report.target("rides within the limit that were changed", changed, ("<=", 0))
    slowest = max(one["s_per_min"] for one in everything)
    report.target("slowest, CPU s per minute of ride", slowest, ("<=", MOST_S_PER_MIN))
    inside = [one for one in found["balanced"] if one["predicted"] * 40.0 <= 26.0]
    report.figures["within 26 mm with the device's spring"] = len(inside)
    changed = sum(one["changed"] for one in inside)
    report.figures["of these changed"] = changed
    print(f"with the device's spring {len(inside)} within 26 mm, {changed} changed")


def ride_force(scene: str, seed: int, length_s: float) -> ForceTrack:
    """Return the force of the true motion of a scene."""
    if scene in SCENES:
        truth = simulate(scene, seed).truth
        up = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])
        gravity = quat.rotate(quat.conjugate(truth.quaternion_wxyz), up)
        acceleration = truth.specific_force_mps2 - gravity
        time_s = truth.time_s
    else:
        ride = simulate_motion(scene, seed, duration_s=length_s)
        time_s, acceleration = ride.imu.time_s, ride.acceleration_mps2
    count = len(time_s)
    motion = MotionTrack(
        time_s=time_s - time_s[0],
        acceleration_mps2=acceleration,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, dtype=bool),
    )
    return render_force(motion)


class Judge:
    """Weighted error and excursion of forces (3, N) at 200 Hz beside one that is wanted."""

    def __init__(self, wanted: Floats, washout: Washout) -> None:
        frequency_hz = fft.rfftfreq(wanted.shape[1], 1.0 / RATE_HZ)
        self._reaches = washout.reaches(frequency_hz)
        self._size = wanted.shape[1]
        self._wanted = weighted(wanted, RATE_HZ)

    def reach(self, force: Floats) -> float:
        """Return the furthest of any hand, in limits."""
        ways = fft.irfft(self._reaches * fft.rfft(force), self._size)
        return float(np.sqrt(np.square(ways).sum(axis=1)).max())

    def error(self, force: Floats) -> float:
        """Return rms(W(force - wanted)) / rms(W wanted)."""
        return self._error(weighted(force, RATE_HZ))

    def best_error(self, force: Floats, limit: float) -> float:
        """Return the error at the best gain that keeps the hands within a limit."""
        made = weighted(force, RATE_HZ)
        gain = np.vdot(made, self._wanted) / max(np.vdot(made, made), 1e-12)
        most = limit / max(self.reach(force), 1e-12)
        return self._error(min(gain, most) * made)

    def _error(self, made: Floats) -> float:
        off = np.linalg.norm(made - self._wanted)
        return float(off / np.linalg.norm(self._wanted))


def compare(track: ForceTrack, washout: Washout) -> dict[str, Any]:
    """Return errors of the washouts and what the optimised one did to a ride."""
    begin_s = time.process_time()
    done = washed_out(track, washout)
    took_s = time.process_time() - begin_s
    time_s = np.arange(-PAD_S, track.end_s + PAD_S, 1.0 / RATE_HZ)
    wanted = track.at(time_s).T
    judge = Judge(wanted, washout)
    made = done.at(time_s).T
    before, after = judge.reach(wanted), judge.reach(made)
    figures = {
        "before": before,
        "after": after,
        "changed": not np.array_equal(done.force_n, track.force_n),
        "s_per_min": 60.0 * took_s / track.end_s,
    }
    if before <= 1.0:
        return figures
    limit, best = max(1.0, after), {"gain": judge.best_error(wanted, max(1.0, after))}
    for name, force in classical(wanted):
        error = judge.best_error(force, limit)
        best[name] = min(error, best.get(name, np.inf))
    error = judge.error(made)
    causal = error / min(best[name] for name in CAUSAL)
    return {
        **figures,
        "error": error,
        **best,
        "causal": causal,
        "classical": error / min(best.values()),
    }


def classical(force: Floats) -> Iterator[tuple[str, Floats]]:
    """Yield the force after each washout and cut-off."""
    for cutoff_hz in CUTOFFS_HZ.tolist():
        for order, name in ((2, CAUSAL[0]), (3, CAUSAL[1])):
            yield name, signal.sosfilt(_high_pass(order, cutoff_hz), force)
        for order, name in ((1, "zero phase 1st"), (2, "zero phase 2nd")):
            sections = _high_pass(order, cutoff_hz)
            yield name, signal.sosfiltfilt(sections, force, padtype=None)


def _high_pass(order: int, cutoff_hz: float) -> Floats:
    return np.asarray(signal.butter(order, cutoff_hz, "high", fs=RATE_HZ, output="sos"))
