"""Where the error of the force comes from: the paper's four rides, cause by cause.

The truth is the simulator's: p every millisecond, mapped by the same axes, gain and
limit as the recording. Each cause is let in alone, all others being perfect; the whole
chain runs with all of them. Causes are independent where their squares add up to the
chain's; the rest is shown as what they have in common. The pats and the stationary time
around them are left out. Figures are the RMS of the error vector in mN, over all seeds.

Five chains: *paper* (30 Hz means, pats found to half a frame, each value held), *lines*
(the same log, pats to the 8 ms that event matching reaches at 30 Hz, straight lines),
*today* (the same, and what `rendering.window_means` puts between the means), *frames* (the
same, synchronised by the frames) and *camera* (200 Hz beside the clip, embedded clock).
`python -m tools.result_figures` draws the saved result.

Between the means: all scenes of motion alone with the windows and the noise of the
paper's accelerometer, gravity known; the error of the force below 8 Hz, with straight
lines and as the player does it, and the largest force of the means and of the entries
between them beside the true one, without the limit.
"""

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfiltfilt

from benchmarks.common import Report, on_one_thread
from hapticplayer.devices.falcon import kinematics
from hapticplayer.extras.rides.board import PAPER, LoggerBoard, record
from hapticplayer.extras.rides.catalogue import RIDES
from hapticplayer.extras.rides.motion_scenes import (
    MOTION_SCENES,
    SimulatedMotion,
    simulate_motion,
)
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.extras.rides.sensors import (
    CAMERA,
    PAPER_BOARD,
    SensorErrors,
    SensorModel,
)
from hapticplayer.model import (
    STANDARD_GRAVITY_MPS2,
    ImuLog,
    Mapping,
    MotionTrack,
    Sampling,
)
from hapticplayer.motion import METHODS, remove_gravity
from hapticplayer.rendering import render_force
from hapticplayer.rendering.window_means import dense_motion

Floats = NDArray[np.float64]
SCENARIOS = ("bike", "horse", "car-turning", "car-braking")
SEEDS = (1, 2, 3)
QUICK_SCENES = ("walk", "handheld-quiet")
BEGIN_S = 6.0
SYNC_S = {"camera": 0.0015, "frames, 30 Hz": 0.0015,
          "event pattern, 200 Hz": 0.002, "event pattern, 30 Hz": 0.008,
          "half a frame, 30 Hz": 1.0 / 60.0, "a frame, 30 Hz": 1.0 / 30.0}  # fmt: skip
"""Errors of synchronisation by where they are met; the sign does not matter."""

BAND_HZ = 8.0
"""What moves a hand as a whole; beyond, it is vibration."""

BETTER, NOT_WORSE = 0.6, 1.1
"""Asked of the error below 8 Hz between the means: all scenes together, and each."""

_PERFECT = SensorModel("perfect", averaged_to_hz=30.0)
_MAPPING = Mapping()
_NOISY = replace(
    PAPER_BOARD,
    accelerometer=SensorErrors(noise=PAPER_BOARD.accelerometer.noise),
    gyro=SensorErrors(),
)


@dataclass(slots=True)
class Ride:
    """One ride with its truth.

    Attributes:
        scene: what was ridden.
        time_s: (N,) media time, every millisecond.
        p: (N, 3) true gravity-free acceleration.
        force: (N, 3) what it should become.
        seed: of the sensors.
    """

    scene: Scene
    time_s: Floats
    p: Floats
    force: Floats
    seed: int

    def error_mn(self, force: Floats) -> float:
        """Return the mean square of the error vector in mN^2."""
        return float(np.mean(np.sum((1e3 * (force - self.force)) ** 2, axis=1)))

    def error_of(self, p: Floats) -> float:
        """Return the mean square for accelerations at the truth's times."""
        return self.error_mn(force_of(p))

    def log(self, board: LoggerBoard) -> tuple[ImuLog, Floats]:
        """A board's log, and the true media times of its samples."""
        span_s = (-self.scene.lead_s, self.scene.duration_s + self.scene.tail_s)
        rng = np.random.default_rng([self.seed, 3])
        log = record(self.scene.trajectory, span_s, board, rng)
        media_s = log.clock_map.rate * log.imu.time_s + log.clock_map.offset_s
        return log.imu, media_s


def force_of(p: Floats) -> Floats:
    """Map accelerations as `rendering` does, without its rounding to float32."""
    force = _MAPPING.gain_n_per_mps2 * p @ _MAPPING.axes.T
    size = np.linalg.norm(force, axis=1, keepdims=True)
    return np.asarray(
        force * np.minimum(1.0, _MAPPING.force_limit_n / np.maximum(size, 1e-12))
    )


def make_ride(name: str, seed: int) -> Ride:
    """Ride a scenario; the first seconds with the pats are left out."""
    scene = RIDES[name](np.random.default_rng([seed, 0]))
    time_s = np.arange(round(1000 * BEGIN_S), round(1000 * scene.duration_s)) / 1000.0
    p = scene.trajectory.at(time_s).acceleration_mps2
    return Ride(scene, time_s, p, force_of(p), seed)


# --- what happens between two samples ---------------------------------------


def held(time_s: Floats, values: Floats, at_s: Floats) -> Floats:
    """Each value over the cell around its time, as the paper plays them."""
    edges = 0.5 * (time_s[1:] + time_s[:-1])
    return values[np.searchsorted(edges, at_s)]


def linear(time_s: Floats, values: Floats, at_s: Floats) -> Floats:
    """Straight lines."""
    return np.stack([np.interp(at_s, time_s, v) for v in values.T], axis=1)


def splined(time_s: Floats, values: Floats, at_s: Floats) -> Floats:
    """As the player plays averaged samples."""
    dense_s, dense, _ = dense_motion(_track(time_s, values))
    return linear(dense_s, dense, at_s)


def _track(time_s: Floats, means: Floats) -> MotionTrack:
    """Return averaged samples as a track, all valid."""
    count = len(time_s)
    return MotionTrack(
        time_s=time_s,
        acceleration_mps2=means,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, dtype=bool),
        sampling=Sampling.AVERAGED,
    )


RECONSTRUCTIONS = {"hold": held, "linear": linear, "spline": splined}


def quantised(force: Floats) -> Floats:
    """Round to the Falcon's motor words at the middle of its workspace."""
    jacobian = np.array(kinematics.jacobian((0.0, 0.0, 0.13)))
    to_words = -kinematics.WORDS_PER_NM * jacobian.T
    words = np.clip(np.rint(force @ to_words.T), -4096, 4096)
    return np.asarray(words @ np.linalg.inv(to_words).T)


# --- one cause at a time ----------------------------------------------------


def averaged_motion(ride: Ride, board: LoggerBoard) -> tuple[Floats, Floats]:
    """Return media times and true means of p, as a log of that board has windows."""
    imu, media_s = ride.log(board)
    half_s = 0.5 / imu.rate_hz
    fine_s = np.linspace(-half_s, half_s, 33)[None, :] + media_s[:, None]
    p = ride.scene.trajectory.at(fine_s.reshape(-1)).acceleration_mps2
    return media_s, p.reshape(*fine_s.shape, 3).mean(axis=1)


def with_errors(**parts: SensorErrors) -> LoggerBoard:
    return LoggerBoard(sensor=replace(_PERFECT, **parts))


def sensor_causes(ride: Ride) -> dict[str, float]:
    """Let the accelerometer's noise, its constant errors and the stalls in, one by one.

    What counts is what comes through the smoother, which levels with the same
    accelerometer; what the gyro does wrong is an error of the gravity removal.
    """
    whole = PAPER.sensor.accelerometer
    noise = SensorErrors(noise=whole.noise, step=whole.step, limit=whole.limit)
    constant = replace(whole, noise=0.0, step=0.0)
    stalling = replace(with_errors(), stall_every_s=PAPER.stall_every_s, stamp_s=0.001)
    perfect = _smoothed(ride, with_errors())
    return {
        name: ride.error_of(ride.p + _smoothed(ride, board) - perfect)
        for name, board in (
            ("noise", with_errors(accelerometer=noise)),
            ("bias, scale, axes", with_errors(accelerometer=constant)),
            ("stalls, stamps", stalling),
        )
    }


def _smoothed(ride: Ride, board: LoggerBoard) -> Floats:
    imu, media_s = ride.log(board)
    return linear(
        media_s, remove_gravity(imu, "smoother").acceleration_mps2, ride.time_s
    )


def sampling_causes(ride: Ride) -> dict[str, float]:
    """The averaging itself, and what each reconstruction does between the means."""
    smooth = _boxcar(ride, 0.0)
    media_s, means = averaged_motion(ride, with_errors())
    causes = {"averaging": ride.error_of(smooth)}
    for name, between in RECONSTRUCTIONS.items():
        p = between(media_s, means, ride.time_s)
        causes[f"averaging and {name}"] = ride.error_of(p)
        causes[name] = ride.error_of(ride.p + p - smooth)
    return causes


def sync_causes(ride: Ride) -> dict[str, float]:
    """What is left after the averaging, shifted; of the 200 Hz log, all of it."""
    return {
        name: float(
            np.mean([shifted(ride, s, is_fine="30" not in name) for s in (-by_s, by_s)])
        )
        for name, by_s in SYNC_S.items()
    }


def shifted(ride: Ride, by_s: float, *, is_fine: bool) -> float:
    """Return the mean square of a shift alone, of a log of 200 or of 30 Hz."""
    at = ride.scene.trajectory.at
    if is_fine:
        return ride.error_of(at(ride.time_s + by_s).acceleration_mps2)
    wrong = _boxcar(ride, by_s) - _boxcar(ride, 0.0)
    return ride.error_of(ride.p + wrong)


def _boxcar(ride: Ride, later_s: float) -> Floats:
    """Return the true p averaged over a window of 1 / 30 s around each time."""
    at, fine_s = ride.scene.trajectory.at, np.linspace(-0.5, 0.5, 17) / 30.0 + later_s
    return np.asarray(
        np.mean([at(ride.time_s + s).acceleration_mps2 for s in fine_s], axis=0)
    )


def gravity_causes(ride: Ride) -> dict[str, float]:
    """Each method on a perfect log, and on the board's with its gyro's errors."""
    causes = {}
    media_s, means = averaged_motion(ride, with_errors())
    gyro = replace(
        with_errors(gyro=PAPER.sensor.gyro), rate_per_mps2=PAPER.rate_per_mps2
    )
    for kind, board in (("perfect", with_errors()), ("board's gyro", gyro)):
        imu, _ = ride.log(board)
        for method in METHODS:
            wrong = remove_gravity(imu, method).acceleration_mps2 - means
            p = ride.p + linear(media_s, wrong, ride.time_s)
            causes[f"{method}, {kind}"] = ride.error_of(p)
    return causes


def chains(ride: Ride) -> dict[str, float]:
    """Return the mean square of whole chains, as the player runs them."""
    imu, media_s = ride.log(PAPER)
    found = {}
    track = remove_gravity(imu, "smoother")
    plain = replace(track, sampling=Sampling.INSTANT)
    for name, late_s, one, between in (
        ("paper", SYNC_S["half a frame, 30 Hz"], plain, held),
        ("lines", SYNC_S["event pattern, 30 Hz"], plain, linear),
        ("today", SYNC_S["event pattern, 30 Hz"], track, linear),
        ("frames", SYNC_S["frames, 30 Hz"], track, linear),
    ):
        found[name] = _sent(ride, one, media_s + late_s, between)
    camera = LoggerBoard(sensor=replace(CAMERA, averaged_to_hz=None))
    imu, media_s = ride.log(camera)
    track = remove_gravity(replace(imu, sampling=Sampling.INSTANT), "smoother")
    found["camera"] = _sent(ride, track, media_s + SYNC_S["camera"], linear)
    return found


def _sent(
    ride: Ride,
    track: MotionTrack,
    media_s: Floats,
    between: Callable[[Floats, Floats, Floats], Floats],
) -> float:
    force = render_force(replace(track, time_s=media_s), _MAPPING)
    force_n = force.force_n.astype(np.float64)
    return ride.error_mn(quantised(between(force.time_s, force_n, ride.time_s)))


def measure(name: str, seed: int) -> dict[str, dict[str, float]]:
    """Return all mean squares of one ride by group and cause."""
    ride = make_ride(name, seed)
    rounded = quantised(ride.force)
    return {
        "sensor": sensor_causes(ride),
        "sampling": sampling_causes(ride),
        "synchronisation": sync_causes(ride),
        "gravity removal": gravity_causes(ride),
        "device": {"quantisation": ride.error_mn(rounded)},
        "chain": chains(ride),
        "signal": {"force": float(np.mean(np.sum((1e3 * ride.force) ** 2, axis=1)))},
    }


STACKS: dict[str, tuple[tuple[str, str], ...]] = {
    chain: (
        ("sensor", "noise"),
        ("sensor", "bias, scale, axes"),
        ("sensor", "stalls, stamps"),
        ("sampling", f"averaging and {between}"),
        ("synchronisation", sync),
        ("gravity removal", "smoother, board's gyro"),
        ("device", "quantisation"),
    )
    for chain, between, sync in (
        ("paper", "hold", "half a frame, 30 Hz"),
        ("today", "spline", "event pattern, 30 Hz"),
    )
}
"""What a chain's error is made of: group and cause."""


# --- between the means, on its own -------------------------------------------


def between_means(ride: SimulatedMotion) -> dict[str, float]:
    """Return errors below 8 Hz, mN, and largest forces, N, of one ride."""
    means = ride.imu.specific_force_mps2 - STANDARD_GRAVITY_MPS2 * ride.vertical
    track = _track(ride.imu.time_s, means)
    time_s = np.arange(*np.ceil(1000.0 * track.time_s[[0, -1]])) / 1000.0
    true = ride.trajectory.at(time_s).acceleration_mps2
    wanted, unlimited = force_of(true), replace(_MAPPING, force_limit_n=1e6)
    found = {"true peak": float(_MAPPING.gain_n_per_mps2 * _largest(true))}
    band = butter(4, BAND_HZ, fs=1000.0, output="sos")
    for name, sampling in (("lines", Sampling.INSTANT), ("today", Sampling.AVERAGED)):
        one = replace(track, sampling=sampling)
        wrong = 1e3 * (render_force(one, _MAPPING).at(time_s) - wanted)
        low = sosfiltfilt(band, wrong, axis=0)[500:-500]
        found[name] = _rms_of_vectors(low)
        found[f"{name}, all"] = _rms_of_vectors(wrong[500:-500])
        found[f"{name}, peak"] = render_force(one, unlimited).peak_n()
    return found


def _largest(vectors: Floats) -> float:
    return float(np.linalg.norm(vectors, axis=1).max())


def _rms_of_vectors(vectors: Floats) -> float:
    return float(np.sqrt(np.mean(np.sum(vectors**2, axis=1))))


def compare_reconstructions(
    scenes: Sequence[str], seeds: Sequence[int], report: Report
) -> None:
    """Measure lines and spline between window means, scene by scene."""
    found = {}
    for scene in scenes:
        runs = [between_means(simulate_motion(scene, s, sensor=_NOISY)) for s in seeds]
        found[scene] = {key: float(np.mean([r[key] for r in runs])) for key in runs[0]}
    found["mean"] = {
        key: float(np.mean([one[key] for one in found.values()]))
        for key in next(iter(found.values()))
    }
    ratios = {scene: one["today"] / one["lines"] for scene, one in found.items()}
    keys = ("lines", "today", "lines, all", "today, all",
            "lines, peak", "today, peak", "true peak")  # fmt: skip
    title = "Between window means: force error below {:g} Hz and whole, mN; peak, N"
    rows = [
        [name, ratios[name], *(one[k] for k in keys)] for name, one in found.items()
    ]
    report.table(title.format(BAND_HZ), ["scene", "ratio", *keys], rows)
    what = f"error below {BAND_HZ:g} Hz between the means, spline / lines"
    report.target(f"{what}, mean of the scenes", ratios.pop("mean"), ("<=", BETTER))
    worst = max(ratios, key=lambda scene: ratios[scene])
    report.target(f"{what}, worst ({worst})", ratios[worst], ("<=", NOT_WORSE))
    report.figures["between_means"] = found


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rides", nargs="+", choices=SCENARIOS, default=SCENARIOS)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure all causes of all rides, and what comes between window means."""
    on_one_thread()
    rides = options.rides[:1] if options.quick else options.rides
    seeds = SEEDS[:1] if options.quick else SEEDS
    figures: dict[str, dict[str, dict[str, float]]] = {}
    for name in rides:
        runs = [measure(name, seed) for seed in seeds]
        figures[name] = {
            group: {
                cause: float(np.sqrt(np.mean([run[group][cause] for run in runs])))
                for cause in causes
            }
            for group, causes in runs[0].items()
        }
    rows: list[list[Any]] = [
        [group, cause, *(figures[name][group][cause] for name in rides)]
        for group, causes in figures[rides[0]].items()
        for cause in causes
    ]
    for chain, parts in STACKS.items():
        rest = [_in_common(figures[name], chain, parts) for name in rides]
        rows.append(["chain", f"{chain}: not of one cause", *rest])
    title = "RMS error of the force by its cause, mN"
    header = ["group", "cause", *rides]
    report.table(title, header, rows)
    report.figures |= {"rms_mn": figures, "stacks": STACKS}
    scenes = QUICK_SCENES if options.quick else tuple(MOTION_SCENES)
    compare_reconstructions(scenes, seeds, report)


def _in_common(
    figures: dict[str, dict[str, float]], chain: str, parts: Sequence[tuple[str, str]]
) -> float:
    alone = sum(figures[group][cause] ** 2 for group, cause in parts)
    rest = figures["chain"][chain] ** 2 - alone
    return float(np.sign(rest) * np.sqrt(abs(rest)))
