"""Run time per sample beside offlineVQF in the same rounds, by length, and memory."""

import ctypes
import gc
import json
import math
import re
import resource
import statistics
import subprocess
import sys
import time
import tracemalloc
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from motion_accuracy import REFERENCE
from motion_data import AVERAGED, NATIVE, Family
from motion_document import Document

from hapticplayer.model import ImuLog
from hapticplayer.motion import (
    DEFAULT_METHOD,
    METHODS,
    estimate_orientation,
    remove_gravity,
)
from hapticplayer.simulation.rides.motion_scenes import simulate_motion

ROUNDS = 5
LIMITS_RATIO = {NATIVE: 0.3, AVERAGED: 1.0}
LIMIT_BYTES = 400.0
LENGTHS_S = (60.0, 600.0, 3600.0, 36000.0)
LENGTH_SENSORS = {"200 Hz": "camera", "30 Hz": "paper-board"}
# so many samples at least to a timing, by repeating it: a millisecond is too short
MIN_SAMPLES = 30_000
# slower methods than ten microseconds a sample are timed on this many samples
SLOW_METHODS, SLOW_SAMPLES = ("ekf",), 2000
_US = 1e6
_FROM = "from the second length on"


@dataclass(frozen=True, slots=True)
class Contender:
    """Something to be timed.

    Attributes:
        run: does it once.
        samples: how many samples it processes.
        slow: not to be repeated for the sake of the clock.
    """

    run: Callable[[], object]
    samples: int
    slow: bool = False

    def us_per_sample(self) -> float:
        """Do it, as often as a timing needs, and return what it took."""
        times = 1 if self.slow else max(1, round(MIN_SAMPLES / self.samples))
        begin_s = time.perf_counter()
        for _ in range(times):
            self.run()
        return _US * (time.perf_counter() - begin_s) / (times * self.samples)


@dataclass(frozen=True, slots=True)
class Timing:
    """Medians over rounds.

    Attributes:
        us: microseconds per sample.
        ratio: to the reference of the same round; NaN without one.
        us_spread: smallest and largest.
    """

    us: float
    ratio: float
    us_spread: tuple[float, float]


def time_rounds(
    contenders: Mapping[str, Contender], rounds: int = ROUNDS, reference: str = ""
) -> dict[str, Timing]:
    """Time contenders in turn, round after round, after one round that warms up.

    Each round begins with another one, so that no one always follows the same.
    """
    for contender in contenders.values():
        contender.run()
    names = list(contenders)
    us: dict[str, list[float]] = {name: [] for name in names}
    for number in range(rounds):
        gc.collect()
        first = number * len(names) // rounds
        for name in names[first:] + names[:first]:
            us[name].append(contenders[name].us_per_sample())
    beside = us.get(reference, [math.nan] * rounds)
    return {
        name: Timing(
            statistics.median(found),
            statistics.median(a / b for a, b in zip(found, beside, strict=True)),
            (min(found), max(found)),
        )
        for name, found in us.items()
    }


def package_offline_vqf(logs: Sequence[ImuLog], **parameters: float) -> Contender:
    """Return offlineVQF as its package gives it; the arrays it wants are ready."""
    from vqf import offlineVQF

    ready = [
        (
            np.array(log.angular_rate_radps),
            np.array(log.specific_force_mps2),
            log.rate_hz,
        )
        for log in logs
    ]
    given = dict(parameters) or None

    def run() -> None:
        for rate, force, rate_hz in ready:
            offlineVQF(rate, force, None, 1.0 / rate_hz, given)

    return Contender(run, sum(len(log) for log in logs))


def ours(call: Callable[..., object], method: str, logs: Sequence[ImuLog]) -> Contender:
    """Return one of our two functions with a method."""
    if method in SLOW_METHODS:
        logs = [head(logs[0], SLOW_SAMPLES)]

    def run() -> None:
        for log in logs:
            call(log, method)

    return Contender(run, sum(len(log) for log in logs), method in SLOW_METHODS)


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


def by_family(
    families: Sequence[Family], rounds: int, document: Document
) -> dict[str, Any]:
    """Print and return the run time of every method on every family."""
    found: dict[str, dict[str, Timing]] = {}
    for family in families:
        logs = [recording.imu for recording in family.recordings]
        contenders = {REFERENCE: package_offline_vqf(logs)}
        for label, call in (
            ("estimate_orientation", estimate_orientation),
            ("remove_gravity", remove_gravity),
        ):
            contenders[label] = ours(call, DEFAULT_METHOD, logs)
        for method in METHODS:
            if method != DEFAULT_METHOD:
                contenders[method] = ours(remove_gravity, method, logs)
        found[family.key] = time_rounds(contenders, rounds, REFERENCE)
    others = [name for name in METHODS if name != DEFAULT_METHOD]
    header = ["recordings", REFERENCE, "orientation", "ratio", "gravity", "ratio"]
    document.table(
        "time",
        f"Run time, us per sample, one thread, medians of {rounds} interleaved rounds: "
        f"{REFERENCE}, {DEFAULT_METHOD} by both functions, the others by "
        "remove_gravity",
        [*header, "limit", "", *others],
        [_time_row(family, found[family.key], others) for family in families],
    )
    return {
        key: {
            name: {"us_per_sample": t.us, "ratio": t.ratio, "us_spread": t.us_spread}
            for name, t in held.items()
        }
        for key, held in found.items()
    }


def _time_row(
    family: Family, held: Mapping[str, Timing], others: Sequence[str]
) -> list[Any]:
    cells: list[Any] = [family.key, f"{held[REFERENCE].us:.3f}"]
    for call in ("estimate_orientation", "remove_gravity"):
        cells += [f"{held[call].us:.3f}", f"{held[call].ratio:.2f}"]
    limit = LIMITS_RATIO[family.rate]
    holds = held["remove_gravity"].ratio <= limit
    cells += [limit, "holds" if holds else "MISSED"]
    return [*cells, *(f"{held[name].us:.2f}" for name in others)]


def by_length(
    lengths_s: Sequence[float], rounds: int, document: Document
) -> dict[str, Any]:
    """Print and return time and peak memory of `remove_gravity` over the length."""
    rows, figures = [], {}
    for rate, sensor in LENGTH_SENSORS.items():
        longest = simulate_motion(
            "handheld-brisk", 1, duration_s=lengths_s[-1], sensor=sensor
        ).imu
        held = []
        for length_s in lengths_s:
            log = head(longest, round(length_s * longest.rate_hz))
            timing = time_rounds(
                {
                    REFERENCE: package_offline_vqf([log]),
                    DEFAULT_METHOD: ours(remove_gravity, DEFAULT_METHOD, [log]),
                },
                rounds,
                REFERENCE,
            )
            bytes_each = _peak_bytes(log) / len(log)
            user_us = _user_us(log)
            held.append((len(log), timing[DEFAULT_METHOD], user_us, bytes_each))
            us = [f"{timing[name].us:.3f}" for name in (DEFAULT_METHOD, REFERENCE)]
            us.insert(1, f"{user_us:.3f}")
            ratio = f"{timing[DEFAULT_METHOD].ratio:.2f}"
            size = [rate, f"{length_s / 60:g} min", len(log)]
            rows.append([*size, *us, ratio, f"{bytes_each:.0f}"])
        figures[rate] = _length_figures(lengths_s, held)
    header = ["rate", "length", "samples", DEFAULT_METHOD, "without the kernel"]
    header += [REFERENCE, "ratio"]
    document.table(
        "length",
        "Length of a recording (simulated, hand-held): remove_gravity, us per sample, "
        f"and what it holds at most (limit {LIMIT_BYTES:.0f} bytes per sample)",
        [*header, "peak B/sample"],
        rows,
    )
    for rate, found in figures.items():
        print(
            f"{rate}: time grows as length^{found['exponent']:.2f} {_FROM}; without the "
            f"kernel, which clears fresh memory, as length^{found['user_exponent']:.2f}"
        )
    return figures


def _length_figures(
    lengths_s: Sequence[float], held: Sequence[tuple[int, Timing, float, float]]
) -> dict[str, Any]:
    """Return them with the exponents of time over length, fixed costs left out."""
    counts, timings, user_us, bytes_each = zip(*held, strict=True)
    us = [timing.us for timing in timings]
    return {
        "length_s": list(lengths_s),
        "us_per_sample": us,
        "user_us_per_sample": list(user_us),
        "ratio": [timing.ratio for timing in timings],
        "peak_bytes_per_sample": list(bytes_each),
        "exponent": _exponent(counts, us),
        "user_exponent": _exponent(counts, user_us),
    }


def _exponent(counts: Sequence[int], us: Sequence[float]) -> float:
    first = 1 if len(counts) > 2 else 0
    spent = np.log(np.multiply(counts, us)[first:])
    return float(np.polyfit(np.log(counts[first:]), spent, 1)[0])


def _user_us(log: ImuLog) -> float:
    """Return the processor's time outside the kernel, the median of three."""
    times = max(1, round(10 * MIN_SAMPLES / len(log)))  # it counts in milliseconds
    spent = []
    for _ in range(3):
        before_s = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        for _ in range(times):
            remove_gravity(log)
        after_s = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        spent.append((after_s - before_s) / (times * len(log)))
    return _US * statistics.median(spent)


def _peak_bytes(log: ImuLog) -> int:
    """Return what Python and numpy hold at most at once, results included."""
    gc.collect()
    tracemalloc.start()
    try:
        before, _ = tracemalloc.get_traced_memory()
        remove_gravity(log)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    return peak - before


def resident(length_s: float) -> dict[str, float]:
    """Print and return the peak of a process, as the system counts it."""
    command = [sys.executable, str(Path(__file__).resolve()), str(length_s)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    figures: dict[str, float] = json.loads(done.stdout)
    holds = figures["bytes_per_sample"] <= LIMIT_BYTES
    print(
        f"\nPeak of a process beyond the input, {length_s / 60:g} min at 200 Hz: "
        f"{figures['bytes_per_sample']:.0f} bytes per sample, results included "
        f"(limit {LIMIT_BYTES:.0f}: {'holds' if holds else 'MISSED'})"
    )
    return figures


def _measure_resident(length_s: float) -> dict[str, float]:
    """Run in a process of its own: peak resident size over what the input takes."""
    log = simulate_motion("handheld-brisk", 1, duration_s=length_s).imu
    remove_gravity(head(log, 2000))  # imports are no part of it
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)  # what was freed is not in use
    Path("/proc/self/clear_refs").write_text("5")  # forget the peak so far
    before = _status_bytes("VmRSS")
    track = remove_gravity(log)
    peak = _status_bytes("VmHWM")
    return {"samples": len(track), "bytes_per_sample": (peak - before) / len(track)}


def _status_bytes(name: str) -> int:
    text = Path("/proc/self/status").read_text()
    found = re.search(rf"{name}:\s+(\d+) kB", text)
    assert found is not None
    return 1024 * int(found[1])


if __name__ == "__main__":
    print(json.dumps(_measure_resident(float(sys.argv[1]))))
