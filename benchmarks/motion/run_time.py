"""Run time of gravity removal per sample beside offlineVQF, over length, and memory.

One thread, its CPU time (on a machine with nothing else to do the time that passes),
medians of interleaved rounds. Also what the shortcuts of a stationary scene
and of a heading that is not wanted save.
"""

import argparse
import gc
import statistics
import time
import tracemalloc
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from benchmarks.common import Ratio, Report, interleaved, on_one_thread, ratio
from benchmarks.motion.recordings import AVERAGED, NATIVE, Family, add_options, chosen
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion import (
    DEFAULT_METHOD,
    METHODS,
    estimate_orientation,
    remove_gravity,
)

REFERENCE = "offlineVQF"
# of a minute, and from ten minutes on
LIMITS_RATIO = {NATIVE: 0.5, AVERAGED: 2.0}
LONG_LIMITS_RATIO = {NATIVE: 0.5, AVERAGED: 1.0}
LIMIT_BYTES = 400.0
LENGTHS_S = (60.0, 600.0, 3600.0, 36000.0)
SENSORS = {NATIVE: "camera", AVERAGED: "paper-board"}
# at least so many samples to a timing, by repeating it: a millisecond is too short
MIN_SAMPLES = 30_000
# methods that take ten microseconds a sample are timed on this many samples
SLOW_METHODS, SLOW_SAMPLES = ("ekf",), 2000
HEADING_METHODS = ("vqf", "offline-vqf", "ekf")
_US = 1e6


@dataclass(frozen=True, slots=True)
class Contender:
    """Something to be timed.

    Attributes:
        run: does it once.
        samples: how many samples it processes.
        slow: whether it is not repeated to be timed better.
    """

    run: Callable[[], object]
    samples: int
    slow: bool = False

    def us_per_sample(self) -> float:
        """Do it, as often as a timing needs, and return what it took."""
        times = 1 if self.slow else max(1, round(MIN_SAMPLES / self.samples))
        begin_s = time.process_time()
        for _ in range(times):
            self.run()
        return _US * (time.process_time() - begin_s) / (times * self.samples)


class Timing(NamedTuple):
    """Median of the rounds, us per sample, and the ratio to a reference."""

    us: float
    ratio: Ratio


def time_rounds(
    contenders: Mapping[str, Contender], rounds: int, reference: str
) -> dict[str, Timing]:
    """Time contenders in turn, after a round that warms up."""
    calls = {name: one.us_per_sample for name, one in contenders.items()}
    gc.collect()
    us = interleaved(calls, rounds, warm_up=True)
    return {
        name: Timing(statistics.median(found), ratio(found, us[reference]))
        for name, found in us.items()
    }


def package_offline_vqf(logs: Sequence[ImuLog]) -> Contender:
    """Return offlineVQF as its package gives it; the arrays it wants are ready."""
    from vqf import offlineVQF

    ready = [
        (np.array(log.angular_rate_radps), np.array(log.specific_force_mps2), log)
        for log in logs
    ]

    def run() -> None:
        for rate, force, log in ready:
            offlineVQF(rate, force, None, 1.0 / log.rate_hz, None)

    return Contender(run, sum(len(log) for log in logs))


def ours(call: Callable[[ImuLog], object], logs: Sequence[ImuLog]) -> Contender:
    """Return a function of ours on some logs."""

    def run() -> None:
        for log in logs:
            call(log)

    return Contender(run, sum(len(log) for log in logs))


def of_method(method: str, logs: Sequence[ImuLog]) -> Contender:
    """Return `remove_gravity` with a method, slow ones on the first samples."""
    slow = method in SLOW_METHODS
    held = [head(logs[0], SLOW_SAMPLES)] if slow else logs
    return replace(ours(lambda log: remove_gravity(log, method), held), slow=slow)


def head(log: ImuLog, count: int) -> ImuLog:
    """Return the first samples of a log."""
    field = log.magnetic_field_ut
    return replace(
        log,
        time_s=log.time_s[:count],
        specific_force_mps2=log.specific_force_mps2[:count],
        angular_rate_radps=log.angular_rate_radps[:count],
        magnetic_field_ut=None if field is None else field[:count],
        valid=None if log.valid is None else log.valid[:count],
    )


def options(parser: argparse.ArgumentParser) -> None:
    add_options(parser, seeds=1)
    parser.add_argument("--rounds", type=int, help="(5)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Time everything."""
    on_one_thread()
    rounds = options.rounds or (3 if options.quick else 5)
    families = chosen(options)
    lengths_s = LENGTHS_S[:2] if options.quick else LENGTHS_S
    by_family(families, rounds, report)
    by_length(lengths_s, rounds, report)
    shortcuts(families, rounds, report)


def by_family(families: Sequence[Family], rounds: int, report: Report) -> None:
    """Time every method on every family."""
    others = [name for name in METHODS if name != DEFAULT_METHOD]
    rows = []
    for family in families:
        logs = family.logs
        contenders = {
            REFERENCE: package_offline_vqf(logs),
            "orientation": ours(estimate_orientation, logs),
            "gravity": ours(remove_gravity, logs),
            **{method: of_method(method, logs) for method in others},
        }
        found = time_rounds(contenders, rounds, REFERENCE)
        cells: list[Any] = [family.key, f"{found[REFERENCE].us:.3f}"]
        for name in ("orientation", "gravity"):
            cells += [f"{found[name].us:.3f}", f"{found[name].ratio.median:.2f}"]
        rows.append([*cells, *(f"{found[name].us:.2f}" for name in others)])
        report.figures.setdefault("us_per_sample", {})[family.key] = {
            name: timing.us for name, timing in found.items()
        }
        limit = ("<=", LIMITS_RATIO[family.rate])
        what = f"{family.key}: time, of {REFERENCE}"
        report.target(what, found["gravity"].ratio.median, limit)
    header = ["recordings", REFERENCE, "orientation", "ratio", "gravity", "ratio"]
    title = f"Run time, us per sample: {DEFAULT_METHOD} by both functions, the others"
    report.table(title, [*header, *others], rows)


def by_length(lengths_s: Sequence[float], rounds: int, report: Report) -> None:
    """Time `remove_gravity` over the length of a recording."""
    rows = []
    for rate, sensor in SENSORS.items():
        ride = simulate_motion(
            "handheld-brisk", 1, duration_s=lengths_s[-1], sensor=sensor
        )
        for length_s in lengths_s:
            log = head(ride.imu, round(length_s * ride.imu.rate_hz))
            contenders = {
                REFERENCE: package_offline_vqf([log]),
                DEFAULT_METHOD: ours(remove_gravity, [log]),
            }
            found = time_rounds(contenders, rounds, REFERENCE)
            bytes_each = _peak_bytes(log) / len(log)
            mine = found[DEFAULT_METHOD]
            row = [rate, f"{length_s / 60:g} min", len(log), f"{mine.us:.3f}"]
            row += [f"{found[REFERENCE].us:.3f}", f"{mine.ratio.median:.2f}"]
            rows.append([*row, f"{bytes_each:.0f}"])
            is_short = length_s == LENGTHS_S[0]
            limits = LIMITS_RATIO if is_short else LONG_LIMITS_RATIO
            what = f"{length_s / 60:g} min, {rate}: time, of {REFERENCE}"
            report.target(what, mine.ratio.median, ("<=", limits[rate]))
    header = ["rate", "length", "samples", DEFAULT_METHOD, REFERENCE, "ratio"]
    header.append("peak B/sample")
    title = (
        "Length of a recording (simulated, hand-held): remove_gravity, us per sample"
    )
    report.table(title, header, rows)
    report.figures["length"] = {"columns": header, "rows": rows}
    longest = [row for row in rows if row[1] == f"{lengths_s[-1] / 60:g} min"]
    peak = max(float(row[-1]) for row in longest)
    what = f"peak of {lengths_s[-1] / 60:g} min, bytes per sample"
    report.target(what, peak, ("<=", LIMIT_BYTES))


def _peak_bytes(log: ImuLog) -> int:
    """The peak memory of Python and numpy, results included."""
    gc.collect()
    tracemalloc.start()
    try:
        before, _ = tracemalloc.get_traced_memory()
        remove_gravity(log)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    return peak - before


def shortcuts(families: Sequence[Family], rounds: int, report: Report) -> None:
    """Time a stationary scene, a moving one, and orientation without the heading."""
    still, moving = _on_a_tripod(), simulate_motion("handheld-brisk", 1).imu
    scenes = {"on a tripod, 5 min": still, "hand-held": moving}
    contenders = {n: ours(remove_gravity, [log]) for n, log in scenes.items()}
    found = time_rounds(contenders, rounds, "hand-held")
    rows = [[n, f"{t.us:.3f}", f"{t.ratio.median:.2f}"] for n, t in found.items()]
    title = f"Stationary recordings are decimated: {DEFAULT_METHOD}, us per sample"
    report.table(title, ["scene", "us", "of hand-held"], rows)
    with_field = [
        recording.imu
        for family in families
        for recording in family.recordings
        if recording.imu.magnetic_field_ut is not None and family.rate == NATIVE
    ]
    rows = []
    for method in HEADING_METHODS if with_field else ():
        slow = method in SLOW_METHODS
        logs = [head(with_field[0], SLOW_SAMPLES)] if slow else with_field
        timing = time_rounds(
            {
                name: replace(ours(_oriented(method, heading=wanted), logs), slow=slow)
                for name, wanted in (("without", False), ("with", True))
            },
            rounds,
            "with",
        )
        saved = f"{1.0 - timing['without'].ratio.median:.0%}"
        rows.append([method, *(f"{timing[n].us:.3f}" for n in timing), saved])
    if rows:
        header = ["method", "without heading", "with", "saved"]
        title = "No magnetometer work without heading=True, us per sample"
        report.table(title, header, rows)


def _oriented(method: str, *, heading: bool) -> Callable[[ImuLog], object]:
    return lambda log: estimate_orientation(log, method, heading=heading)


def _on_a_tripod(rate_hz: float = 200.0) -> ImuLog:
    """Return five minutes of a sensor with bias, gain error and white noise."""
    rng, shape = np.random.default_rng(7), (round(300.0 * rate_hz), 3)
    force = np.tile([0.0, 0.1, 0.995], (shape[0], 1)) * STANDARD_GRAVITY_MPS2
    return ImuLog(
        np.arange(shape[0]) / rate_hz,
        1.02 * force + 0.035 * rng.standard_normal(shape),
        np.array([0.004, -0.003, 0.005]) + 0.003 * rng.standard_normal(shape),
        source="on a tripod",
    )
