"""Motion suggested by frames alone, beside the truth, no force and random force.

Films of simulated rides (those of `benchmarks.sync frames`) and real clips with telemetry
of their own. Seeds 11 and 12 were used to build the estimate, all others and the real clips
were not. Per part and band: correlation, RMS error with the gain as it is and with the one
that fits the clip, the share of the clip in which the part is kept. Baselines have the truth's
RMS in the band: no force (error 1) and white noise below 0.5 Hz, as in the study (95 % of its
correlations are below the one shown). Errors are shares of the truth's RMS.
"""

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy import signal

from benchmarks.common import DATA, Report, on_one_thread, rms
from benchmarks.sync.frame_clips import SCENES, film_of
from hapticplayer.capture import read_recording
from hapticplayer.extras.frames.estimate import RATE_HZ, TOP_HZ, suggest_motion
from hapticplayer.extras.rides.catalogue import RIDES
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import remove_gravity
from hapticplayer.rendering import random_feedback

BUILT_ON = (11, 12)
SEEDS = range(11, 16)
GOPRO = DATA / "capture" / "gopro"
MOST_CPU_S = 30.0
DRAWS = 40
EDGE_S = 1.0
WORSE = 1.05  # error that no force would not make
KEPT = 0.2  # mean trust from which on a clip counts as one with the part


class Band(NamedTuple):
    """A part of the motion: its axis in frame A and in `trust`, and its limits."""

    part: str
    axis: int
    column: int
    low_hz: float
    high_hz: float
    is_judged: bool


BANDS = (
    Band("sway", 0, 0, 0.1, 0.5, is_judged=True),
    Band("sway", 0, 0, 0.5, 3.0, is_judged=False),
    Band("bounce", 2, 1, 0.5, 3.0, is_judged=True),
    Band("bounce", 2, 1, 3.0, 5.0, is_judged=False),
)


@dataclass(frozen=True, slots=True, eq=False)
class Clip:
    """A film with its truth: gravity-free acceleration (N, 3) in frame A."""

    name: str
    path: Path
    is_new: bool
    time_s: Floats
    acceleration_mps2: Floats


@dataclass(frozen=True, slots=True)
class Row:
    """One clip and band."""

    clip: str
    is_new: bool
    band: Band
    kept: float
    truth_mps2: float
    estimate_mps2: float
    correlation: float
    error: float
    fitted_error: float
    random_correlation: float
    random_error: float
    sigma_ratio: float

    @property
    def beats(self) -> bool:
        """Whether it is nearer to the truth than both baselines."""
        is_nearer = self.error < min(1.0, self.random_error)
        return is_nearer and self.correlation > self.random_correlation


def simulated(scenes: tuple[str, ...], seeds: range) -> Iterator[Clip]:
    """Yield films of rides with their exact motion."""
    for scene in scenes:
        for seed in seeds:
            path = film_of(scene, seed)
            ridden = RIDES[scene](np.random.default_rng([seed, 0]))
            time_s = np.arange(0.0, probe(path).duration_s, 1.0 / RATE_HZ)
            truth = ridden.trajectory.at(time_s).acceleration_mps2
            yield Clip(scene, path, seed not in BUILT_ON, time_s, truth)


def real(paths: list[Path]) -> Iterator[Clip]:
    """Yield real clips with what their own sensor says."""
    for path in paths:
        if not path.exists():
            print(f"without {path.name}, which is not on this machine")
            continue
        found = read_recording(path)
        motion = remove_gravity(found.imu)
        time_s = found.clock_map.rate * motion.time_s + found.clock_map.offset_s
        slow = signal.butter(4, 20.0, fs=found.imu.rate_hz, output="sos")
        smooth = signal.sosfiltfilt(slow, motion.acceleration_mps2, axis=0)
        yield Clip(path.name, path, is_new=True, time_s=time_s,
                   acceleration_mps2=smooth)  # fmt: skip


def rows(clip: Clip) -> list[Row]:
    """Compare what the frames suggest with the truth."""
    found = suggest_motion(clip.path)
    time_s = found.motion.time_s
    estimate = found.motion.acceleration_mps2
    truth = np.stack(
        [np.interp(time_s, clip.time_s, one) for one in clip.acceleration_mps2.T], 1
    )
    inside = (time_s > EDGE_S) & (time_s < probe(clip.path).duration_s - EDGE_S)
    made = []
    for band in BANDS:
        sos = signal.butter(
            2, (band.low_hz, band.high_hz), "band", fs=RATE_HZ, output="sos"
        )
        of_truth = signal.sosfiltfilt(sos, truth[:, band.axis])[inside]
        of_frames = signal.sosfiltfilt(sos, estimate[:, band.axis])[inside]
        trust = found.trust[inside, band.column]
        made.append(
            Row(
                clip.name,
                clip.is_new,
                band,
                float(trust.mean()),
                rms(of_truth),
                rms(of_frames),
                _correlation(of_frames, of_truth),
                rms(of_frames - of_truth) / rms(of_truth),
                _fitted_error(of_frames, of_truth),
                *_random(of_truth, sos, inside, time_s),
                rms((of_frames - of_truth)[trust > 0.5]
                    / found.sigma_mps2[inside, band.column][trust > 0.5])
                if (trust > 0.5).any() else np.nan,
            )
        )  # fmt: skip
    return made


def _correlation(values: Floats, truth: Floats) -> float:
    return float(np.corrcoef(values, truth)[0, 1]) if values.any() else 0.0


def _fitted_error(values: Floats, truth: Floats) -> float:
    """Return the error with the gain that fits this clip, which may not be negative."""
    gain = max(0.0, float(values @ truth) / max(float(values @ values), 1e-12))
    return rms(gain * values - truth) / rms(truth)


def _random(
    truth: Floats, sos: Floats, inside: Floats, time_s: Floats
) -> tuple[float, float]:
    """Return the correlation that 95 % of random forces stay below, and their error."""
    flat = ForceTrack(time_s, np.ones((len(time_s), 3), np.float32))
    found = []
    for seed in range(DRAWS):
        noise = random_feedback(flat, seed).at(time_s)[:, 0]
        noise = signal.sosfiltfilt(sos, noise)[inside]
        noise *= rms(truth) / max(rms(noise), 1e-12)
        found.append((_correlation(noise, truth), rms(noise - truth) / rms(truth)))
    correlations, errors = np.array(found).T
    return float(np.quantile(correlations, 0.95)), float(np.median(errors))


def _kind(row: Row) -> str:
    """Return the scene, the same of both cars, or the name of a real clip."""
    return "car" if row.clip.startswith("car-") else row.clip


def _mean(rows: list[Row], name: str) -> float:
    return float(np.mean([getattr(row, name) for row in rows]))


def _tables(found: list[Row], report: Report) -> None:
    new = [row for row in found if row.is_new]
    _by_clip(new, report)
    for band in BANDS:
        _judge(band, [row for row in new if row.band == band], report)
    columns = ["clip", "new", "part", "Hz", "kept", "truth", "estimate", "r", "error",
               "fitted", "random r", "random error", "error / sigma"]  # fmt: skip
    cells = [
        [row.clip, row.is_new, row.band.part, f"{row.band.low_hz:g}-{row.band.high_hz:g}",
         row.kept, row.truth_mps2, row.estimate_mps2, row.correlation, row.error,
         row.fitted_error, row.random_correlation, row.random_error, row.sigma_ratio]
        for row in found
    ]  # fmt: skip
    report.table("All clips", columns, cells)
    report.figures |= {"columns": columns, "rows": cells}


def _by_clip(found: list[Row], report: Report) -> None:
    """Show a column for each scene and each real clip."""
    kinds = list(dict.fromkeys(_kind(row) for row in found))
    lines, kept = [], []
    for band in (one for one in BANDS if one.is_judged):
        own = [
            [row for row in found if _kind(row) == kind and row.band == band]
            for kind in kinds
        ]
        cells = [
            f"{_mean(rows, 'correlation'):.2f}, {_mean(rows, 'error'):.2f}"
            for rows in own
        ]
        lines.append([f"{band.part}: r, error", *cells])
        kept.append([f"{100.0 * _mean(rows, 'kept'):.0f}" for rows in own])
    shares = [f"{sway}, {bounce}" for sway, bounce in zip(*kept, strict=True)]
    lines.append(["kept, %: sway, bounce", *shares])
    report.table("Clips not used to build it", ["", *kinds], lines, mark="estimate")


def _judge(band: Band, found: list[Row], report: Report) -> None:
    with_part = [row for row in found if row.kept >= KEPT]
    won = sum(row.beats for row in with_part)
    what = f"{band.part} {band.low_hz:g}-{band.high_hz:g} Hz"
    print(f"{what}: {won} of {len(with_part)} clips that have it beat both baselines")
    if band.is_judged and found:
        error, worse = _mean(found, "error"), sum(row.error > WORSE for row in found)
        report.target(f"{what}: mean error, new clips", error, ("<=", 0.9))
        text = f"{what}: new clips with an error above {WORSE:g}"
        report.target(text, worse, ("<=", 0))


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "--real",
        type=Path,
        action="append",
        default=[GOPRO / "karma.mp4"],
        help="a further clip with telemetry (GoPro's sample max-heromode.mp4)",
    )


def run(chosen: argparse.Namespace, report: Report) -> None:
    """Compare all clips."""
    on_one_thread()
    seeds = range(13, 14) if chosen.quick else SEEDS
    scenes = ("bike", "horse") if chosen.quick else SCENES
    found, start, seconds = [], time.process_time(), 0.0
    cpu_s = 0.0
    for clip in (*simulated(scenes, seeds), *real(chosen.real)):
        start = time.process_time()
        found += rows(clip)
        cpu_s += time.process_time() - start
        seconds += probe(clip.path).duration_s
        print(f"{clip.name} {clip.path.name}", flush=True)
    _tables(found, report)
    what = f"CPU s per minute of small films, below {TOP_HZ:g} Hz"
    report.target(what, 60.0 * cpu_s / seconds, ("<=", MOST_CPU_S))
