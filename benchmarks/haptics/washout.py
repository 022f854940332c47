"""The optimised washout beside classical ones at equal excursion, and what hands get.

Force of simulated rides (true motion, default mapping), of a drone's GoPro and of a minute
in a car (`../shared/data/capture`, left out where they are not), for the hands of each preset.
Classical washouts: Butterworth high-passes of 2nd and 3rd order (causal), of 1st and 2nd
forwards and backwards (zero phase), and a gain; cut-off and gain are the best of all that
keep the same hands as far inside as the optimised washout does, for that ride. Excursion
as the washout defines it: 10 ms ahead, without the device's spring. Rides whose hands stay
within the limit anyway have to come back unchanged; they do not count in the ratios.

Then eight hands with the device's spring, fade and caps, see `washout_hands`: trips, reach,
weighted error of the felt force, its spread between hands, false cues. Last, two hours.
"""

import argparse
import time
import tracemalloc
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy import fft, signal

from benchmarks.common import DATA, Report, on_one_thread
from benchmarks.haptics.washout_hands import false_share, hold, judged, overview
from benchmarks.motion.recordings import COMMA, comma
from hapticplayer.capture import read_recording
from hapticplayer.extras.rides.catalogue import SCENES
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.extras.rides.recording import simulate
from hapticplayer.model import ForceTrack, Mapping, MotionTrack, PresetName
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.motion import remove_gravity
from hapticplayer.rendering import render_force
from hapticplayer.rendering.washout import Washout, washed_out, weighted
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.presets import PRESETS, washout_of

RATE_HZ, PAD_S = 200.0, 10.0
STANDARD_GRAVITY_MPS2 = 9.80665
CUTOFFS_HZ = np.geomspace(0.01, 3.0, 30)
CAUSAL = ("causal 2nd", "causal 3rd")
RIDES_AT_ONCE = 12
LONG_S, SHORT_S = 7200.0, 600.0
COLUMNS = ["optimised", "of best causal", "p90", "worst"]
COLUMNS += ["of best classical", "p90", "worst", "reach / limit"]


class Ride(NamedTuple):
    """The force of a ride under each preset, and how each was judged."""

    name: str
    tracks: dict[str, ForceTrack]
    compared: dict[str, dict[str, Any]]


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seeds", type=int, help="(3)")
    text = "of rides of motion alone (each scene's own length, 90 to 180; quick: 60)"
    parser.add_argument("--seconds", type=float, help=text)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure weighted errors, unchanged rides, what hands get, and the time."""
    on_one_thread()
    rides = [planned(*one) for one in forces(options)]
    compared = {
        name: [{"ride": ride.name, **ride.compared[name]} for ride in rides]
        for name in (PresetName.BALANCED, PresetName.EQUAL)
    }
    rows = []
    for name, each in compared.items():
        bound = [one for one in each if one["before"] > 1.0]
        rows.append([name, len(each), len(bound), *_ratios(bound)])
    header = ["preset", "rides", "limited", *COLUMNS]
    title = "Weighted error, medians of the limited rides"
    report.table(title, header, rows, "washout-errors")
    report.figures |= {"columns": header, "rows": rows, "rides": compared}
    _ratio_targets(report, compared)
    _hands(report, rides)
    _long(report, 0.1 if options.quick else 1.0)


def forces(options: argparse.Namespace) -> Iterator[tuple[str, ForceTrack]]:
    """Yield names and forces of all rides."""
    scenes = [*SCENES, *MOTION_SCENES]
    length_s = options.seconds or (60.0 if options.quick else None)
    for scene in scenes[2::5] if options.quick else scenes:
        for seed in range(options.seeds or (1 if options.quick else 3)):
            yield f"{scene} {seed}", ride_force(scene, seed, length_s)
    recording = DATA / "capture" / "gopro" / "karma.mp4"
    if recording.is_file():
        motion = remove_gravity(read_recording(recording).imu)
        yield "karma", render_force(motion, Mapping())
    else:
        print(f"left out: {recording} is not there")
    if COMMA.is_dir():
        yield "comma2k19", render_force(remove_gravity(comma().imu), Mapping())
    else:
        print(f"left out: {COMMA} is not there")


def planned(name: str, track: ForceTrack) -> Ride:
    """Return a ride under each preset."""
    tracks, compared = {PresetName.FAITHFUL: track}, {}
    for preset in PRESETS[1:]:
        washout = washout_of(preset, DEFAULT_FORCE_LIMIT_N)
        begin_s = time.process_time()
        tracks[preset.name] = washed_out(track, washout)
        took_s = time.process_time() - begin_s
        found = compare(track, tracks[preset.name], washout)
        found["s_per_min"] = 60.0 * took_s / track.end_s
        compared[preset.name] = found
    reach = predict(track, track.end_s).hands["relaxed"].reach
    compared[PresetName.BALANCED]["predicted"] = reach
    return Ride(name, tracks, compared)


def _ratios(bound: list[dict[str, Any]]) -> list[float]:
    if not bound:
        return [float("nan")] * len(COLUMNS)
    causal, classical = ([one[key] for one in bound] for key in ("causal", "classical"))
    return [
        float(np.median([one["error"] for one in bound])),
        *np.percentile(causal, [50, 90, 100]).tolist(),
        *np.percentile(classical, [50, 90, 100]).tolist(),
        max(one["after"] for one in bound),
    ]


def _ratio_targets(report: Report, compared: dict[str, list[dict[str, Any]]]) -> None:
    equal = [one for one in compared[PresetName.EQUAL] if one["before"] > 1.0]
    for key, median, worst in (("causal", 0.55, 0.90), ("classical", 0.70, 0.96)):
        each = [one[key] for one in equal]
        what = f"equal: error of best {key}, "
        report.target(f"{what}median", float(np.median(each)), ("<=", median))
        report.target(f"{what}any ride", max(each), ("<=", worst))
    false = [one["false"] for one in compared[PresetName.EQUAL]]
    report.target("equal: false cues, mean", float(np.mean(false)), ("<=", 0.005))
    report.target("equal: false cues, any ride", max(false), ("<=", 0.03))
    everything = [one for each in compared.values() for one in each]
    changed = sum(one["changed"] for one in everything if one["before"] <= 1.0)
    report.target("rides within the limit that were changed", changed, ("<=", 0))
    slowest = max(one["s_per_min"] for one in everything)
    report.target("slowest, CPU s per minute of ride", slowest, ("<=", 0.5))
    inside = [
        one for one in compared[PresetName.BALANCED] if one["predicted"] * 40.0 <= 26.0
    ]
    report.figures["within 26 mm with the device's spring"] = len(inside)
    changed = sum(one["changed"] for one in inside)
    report.figures["of these changed"] = changed
    print(f"with the device's spring {len(inside)} within 26 mm, {changed} changed")


def _hands(report: Report, rides: list[Ride]) -> None:
    """Hold the grip through all rides."""
    found: dict[str, list[dict[str, Any]]] = {one.name: [] for one in PRESETS}
    rides = sorted(rides, key=lambda ride: ride.tracks[PresetName.FAITHFUL].end_s)
    for first in range(0, len(rides), RIDES_AT_ONCE):
        some = rides[first : first + RIDES_AT_ONCE]
        held = iter(hold([ride.tracks[name] for ride in some for name in found]))
        for ride in some:
            for each in found.values():
                judgement = judged(ride.tracks[PresetName.FAITHFUL], next(held))
                each.append({"ride": ride.name, **judgement})
    rows = [[name, *overview(each).values()] for name, each in found.items()]
    header = ["preset", *overview(found[PresetName.EQUAL])]
    title = "What hands get, with the device's spring, fade and caps"
    report.table(title, header, rows, "washout-hands")
    by_ride = {
        name: {one["ride"]: list(overview([one]).values()) for one in each}
        for name, each in found.items()
    }
    report.figures["hands"] = {"columns": header, "rows": rows, "rides": by_ride}
    faithful, balanced, equal = (overview(each) for each in found.values())
    for name, one, reach, limp in (
        (PresetName.BALANCED, balanced, 0.75, 0.86),
        (PresetName.EQUAL, equal, 0.58, 0.82),
    ):
        report.target(f"{name}: trips", one["trips"] + one["limp trips"], ("<=", 0))
        report.target(f"{name}: reach", one["reach"], ("<=", reach))
        report.target(f"{name}: reach, limp", one["limp reach"], ("<=", limp))
    most = ("<=", faithful["error, relaxed"])
    report.target("balanced: error, relaxed", balanced["error, relaxed"], most)
    report.target("equal: spread, any ride", equal["worst spread"], ("<=", 0.06))


def _long(report: Report, share: float) -> None:
    """Measure time and memory of long tracks."""
    ride, rows = ride_force("car-hard", 0, 60.0), []
    for length_s in (SHORT_S, share * LONG_S):
        track = repeated(ride, length_s)
        tracemalloc.start()
        begin_s = time.process_time()
        washed_out(track, washout_of(PRESETS[2], DEFAULT_FORCE_LIMIT_N))
        took_s = time.process_time() - begin_s
        peak_mb = tracemalloc.get_traced_memory()[1] / 1e6
        tracemalloc.stop()
        size_mb = (track.time_s.nbytes + track.force_n.nbytes) / 1e6
        rows.append([length_s, 60.0 * took_s / track.end_s, size_mb, peak_mb])
    header = ["s", "CPU s per minute", "track MB", "peak MB, with its result"]
    report.table("Long tracks", header, rows)
    report.figures["long"] = {"columns": header, "rows": rows}


def repeated(track: ForceTrack, length_s: float) -> ForceTrack:
    """Return a track again and again."""
    times = round(length_s / track.end_s)
    count, step_s = len(track.time_s), track.end_s / (len(track.time_s) - 1)
    time_s = step_s * np.arange(times * count)
    return ForceTrack(time_s, np.tile(track.force_n, (times, 1)))


def ride_force(scene: str, seed: int, length_s: float | None) -> ForceTrack:
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


def compare(track: ForceTrack, done: ForceTrack, washout: Washout) -> dict[str, Any]:
    """Return errors of the washouts and what the optimised one did to a ride."""
    time_s = np.arange(-PAD_S, track.end_s + PAD_S, 1.0 / RATE_HZ)
    wanted = track.at(time_s).T
    judge = Judge(wanted, washout)
    made = done.at(time_s).T
    before, after = judge.reach(wanted), judge.reach(made)
    figures = {
        "before": before,
        "after": after,
        "changed": not np.array_equal(done.force_n, track.force_n),
        "false": false_share(made, wanted, RATE_HZ),
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
