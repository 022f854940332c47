"""Synchronisation by three pats, beside the variance threshold, on clips of known truth.

What the method decides by was chosen on the seeds 5000 to 9059; the default seeds here
are others. Every clip is also synchronised with the log of another one: then any
confident answer is a wrong one. Run time is the fastest of three calls of
`synchronize`, CPU time on one thread.
"""

import argparse
import time
from concurrent.futures import Executor, ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np

from benchmarks.common import Report, on_one_thread, rms
from hapticplayer.capture import synchronize
from hapticplayer.capture.sync.variance import FIRST_10_S, WHOLE, variance_shift
from tests.material.sync_clips import PatClip, simulate_pats

HALF_FRAME_S, GROSS_S = 0.0167, 0.1
# kind, rate in Hz -> share within half a frame, share of right ones flagged
LIMITS = {
    ("easy", 200): (0.97, 0.05),
    ("easy", 30): (0.88, 0.05),
    ("hard", 200): (0.88, 0.20),
    ("hard", 30): (0.65, 0.20),
}
LONG_LIMITS_S = {200: 0.005, 30: 0.025}
MOST_WRONG, MOST_S = 0.01, 0.050


@dataclass(frozen=True)
class Outcome:
    """One clip: errors in s (nan: nothing found), and whether it is confident."""

    error_s: float
    end_error_s: float
    is_confident: bool
    run_s: float
    literal_s: float = np.nan
    kindest_s: float = np.nan
    mismatch_is_confident: bool = False


def error_s(clip: PatClip, offset_s: float, rate: float, at_s: float) -> float:
    """Return the error in media time of what was logged at a media time."""
    log_s = (at_s - clip.clock_map.offset_s) / clip.clock_map.rate
    return rate * log_s + offset_s - at_s


@lru_cache(maxsize=2)
def short_clip(seed: int, hard: bool, rate_hz: int) -> PatClip:
    """Return a clip of 60 s; the stranger of one is the next one."""
    return simulate_pats(seed, hard=hard, rate_hz=rate_hz)


def outcome(seed: int, *, hard: bool, rate_hz: int) -> Outcome:
    """Synchronise a 60 s clip with all methods, and with a stranger's log."""
    clip = short_clip(seed, hard, rate_hz)
    runs_s = []
    for _ in range(3):
        start = time.process_time()
        found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
        runs_s.append(time.process_time() - start)
    clock = found.clock_map
    middle_s = float(clip.pats_s[1])
    errors = [error_s(clip, clock.offset_s, clock.rate, at) for at in (middle_s, 60.0)]
    simple = []
    for threshold in (WHOLE, FIRST_10_S):
        shift_s = variance_shift(clip.imu, clip.audio, clip.audio_rate_hz, threshold)
        truth_s = error_s(clip, 0.0, 1.0, middle_s)
        simple.append(np.nan if shift_s is None else shift_s + truth_s)
    stranger = short_clip(seed + 1, hard, rate_hz).imu
    mistaken = synchronize(stranger, clip.audio, clip.audio_rate_hz)
    return Outcome(
        *errors, found.is_confident, min(runs_s), *simple, mistaken.is_confident
    )


def long_outcome(seed: int, *, rate_hz: int) -> Outcome:
    """Synchronise a clip of 600 s with pats at both ends."""
    clip = simulate_pats(
        seed, hard=False, rate_hz=rate_hz, duration_s=600.0, at_both_ends=True
    )
    start = time.process_time()
    found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
    run_s = time.process_time() - start
    clock, places_s = found.clock_map, (float(clip.pats_s[1]), 600.0)
    errors = [error_s(clip, clock.offset_s, clock.rate, at) for at in places_s]
    return Outcome(*errors, found.is_confident, run_s)


def summary(outcomes: list[Outcome]) -> dict[str, Any]:
    """Return the figures of one kind of clip."""
    errors = np.array([one.error_s for one in outcomes])
    sure = np.array([one.is_confident for one in outcomes])
    gross = ~(np.abs(errors) <= GROSS_S)
    near = errors[~gross]

    def within(name: str) -> float:
        values = np.array([getattr(one, name) for one in outcomes])
        return float(np.mean(np.abs(values) <= HALF_FRAME_S))

    return {
        "within_half_frame": within("error_s"),
        "within_at_60_s": within("end_error_s"),
        "variance_literal": within("literal_s"),
        "variance_kindest": within("kindest_s"),
        "gross": int(gross.sum()),
        "bias_ms": float(1e3 * near.mean()),
        "sd_ms": float(1e3 * near.std()),
        "p95_abs_ms": float(1e3 * np.percentile(np.abs(near), 95)),
        "wrong_unflagged": float(np.mean(gross & sure)),
        "right_flagged": float(np.mean(~sure[~gross])),
        "strangers_unflagged": float(
            np.mean([one.mismatch_is_confident for one in outcomes])
        ),
        "run_ms": float(1e3 * np.median([one.run_s for one in outcomes])),
    }


def short_rows(seeds: range, pool: Executor, only: str, report: Report) -> None:
    """Run the kinds of 60 s clips."""
    rows: dict[str, dict[str, Any]] = {}
    for (kind, rate_hz), (share, flagged) in LIMITS.items():
        name = f"{kind} {rate_hz} Hz"
        if only not in name:
            continue
        work = partial(outcome, hard=kind == "hard", rate_hz=rate_hz)
        found = rows[name] = summary(list(pool.map(work, seeds, chunksize=10)))
        for key, limit in (
            ("within_half_frame", (">=", share)),
            ("wrong_unflagged", ("<=", MOST_WRONG)),
            ("right_flagged", ("<=", flagged)),
            ("run_ms", ("<=", 1e3 * MOST_S)),
        ):
            report.target(f"{name}: {key}", found[key], limit)
    if rows:
        header = ["60 s clips", *next(iter(rows.values()))]
        cells = [[name, *found.values()] for name, found in rows.items()]
        report.table(f"{len(seeds)} clips of 60 s each", header, cells)
    report.figures["60 s"] = rows


def long_rows(seeds: range, pool: Executor, only: str, report: Report) -> None:
    """Run the rates of 600 s clips."""
    rows: dict[str, dict[str, Any]] = {}
    for rate_hz, limit_s in LONG_LIMITS_S.items():
        name = f"easy {rate_hz} Hz"
        if only not in name:
            continue
        found = list(pool.map(partial(long_outcome, rate_hz=rate_hz), seeds))
        errors_ms = 1e3 * np.array([one.end_error_s for one in found])
        rows[name] = {
            "end_rms_ms": rms(errors_ms),
            "end_worst_ms": float(np.abs(errors_ms).max()),
            "flagged": float(np.mean([not one.is_confident for one in found])),
            "run_ms": float(1e3 * np.median([one.run_s for one in found])),
        }
        limit = ("<=", 1e3 * limit_s)
        what = f"{name}, 600 s: error at the end, ms RMS"
        report.target(what, rows[name]["end_rms_ms"], limit)
    if rows:
        header = ["600 s clips", *next(iter(rows.values()))]
        cells = [[name, *found.values()] for name, found in rows.items()]
        report.table(f"{len(seeds)} clips of 600 s each", header, cells)
    report.figures["600 s"] = rows


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--clips", type=int, help="of 60 s, each kind (200)")
    parser.add_argument("--long", type=int, help="of 600 s, each rate (50)")
    parser.add_argument("--seed", type=int, default=100_000)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--only", default="", help="such as 'hard 30 Hz'")


def run(options: argparse.Namespace, report: Report) -> None:
    """Synchronise all clips."""
    on_one_thread()
    quick, first = options.quick, options.seed
    clips = (20 if quick else 200) if options.clips is None else options.clips
    long = (2 if quick else 50) if options.long is None else options.long
    report.figures |= {"clips": clips, "long": long, "first_seed": first}
    with ProcessPoolExecutor(options.workers) as pool:
        if clips:
            short_rows(range(first, first + clips), pool, options.only, report)
        if long:
            long_rows(range(first, first + long), pool, options.only, report)
