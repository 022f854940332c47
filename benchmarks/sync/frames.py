"""Synchronisation by the camera's rotation in its frames, beside three pats.

Films of 28 s of simulated rides, each with many logs that have another clock (offset up to
60 s, rate up to 80 ppm off), any of 24 mountings, 2 degrees of misalignment and noise of
their own; rolling shutters of 0 to 30 ms; handlebar, dashboard and the horse's head are in
the frames. Each film is also compared with logs of other rides, cut, mirrored, played at a
wrong frame rate, stabilised, and as a still: then any confident answer is a wrong one.
Errors are those at the middle of the clip. Thresholds were chosen on seeds from 101 to 110,
which may not be run here. Ctrl-C ends early and shows what was done until then.
"""

import argparse
import contextlib
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from benchmarks.common import DATA, Report, on_one_thread
from benchmarks.sync.frame_clips import (
    RATES_HZ,
    SCENES,
    Filmed,
    Logged,
    filmed,
    logged,
    ride_of,
    stabilised,
    still,
)
from benchmarks.sync.frame_tables import (
    METHODS,
    MIRRORED,
    Found,
    Outcome,
    write_budget,
    write_tables,
)
from hapticplayer.capture import read_recording
from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.sync.result import ClipSound, Synchronisation, SyncInput
from hapticplayer.capture.sync.synchronize import by_pats, joined_findings
from hapticplayer.errors import InputError
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.rotation_line import Line, fit_line
from hapticplayer.extras.frames.rotation_match import Gyro, fit_at
from hapticplayer.extras.frames.synchronizing import synchronize_frames, usable
from hapticplayer.extras.rides.film.sound import RATE_HZ as SOUND_RATE_HZ
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

Follow = Callable[[Path], FrameRotation]

BUILT_ON = range(101, 111)
LEAST_RMS_DEGPS = 1.0
SHORT_S = (8.0, 16.0)  # as little as people cut out: one bend of a road
SPOILT_FILMS = ("horse", "stroll")
# name, whether its frames can be trusted
REAL = (("karma.mp4", True), ("max-heromode.mp4", False))


def middle_error_s(film: Filmed, log: Logged, found: Synchronisation) -> float:
    middle_s = 0.5 * film.duration_s
    return found.media_s(_log_s(log, middle_s)) - middle_s


def _log_s(log: Logged, media_s: float) -> float:
    return (media_s - log.clock_map.offset_s) / log.clock_map.rate


def outcome(film: Filmed, log: Logged, frames: FrameRotation) -> Outcome:
    """Synchronise by frames, pats and both."""
    sound = ClipSound(film.audio.mean(axis=1), SOUND_RATE_HZ)
    start = time.process_time()
    by_frames = synchronize_frames(log.imu, frames)
    fit_s = time.process_time() - start
    pats = by_pats(SyncInput(log.imu, lambda: sound))
    both = joined_findings(pats, by_frames)
    found = dict(zip(METHODS, (by_frames, pats, both), strict=True))
    one = Outcome(
        film.scene,
        200 if log.imu.rate_hz > 100 else 30,
        {name: middle_error_s(film, log, result) for name, result in found.items()},
        {name: result.clock_map.confidence for name, result in found.items()},
        by_frames.drift_ppm - 1e6 * (log.clock_map.rate - 1.0),
        fit_s,
        window_error_s=window_errors_s(film, log, frames),
    )
    if by_frames.frames is not None:
        told_s = by_frames.frames.read_out_s
        one = replace(one, read_out_error_s=told_s - film.read_out_s)
    if (mounting := by_frames.mounting) is not None:
        is_right = mounting.axes == log.axes
        one = replace(one, mounting_ratio=mounting.ratio, mounting_is_right=is_right)
    return one


def window_errors_s(film: Filmed, log: Logged, frames: FrameRotation) -> Floats:
    """Return the errors of windows of 4 s in which the camera rotates enough.

    The rest of the clip tells gains and mounting; of the read-out time the truth is taken.
    """
    watched, gyro = usable(log.imu, frames), Gyro(log.imu)
    media_s = 0.5 * (watched.begin_s + watched.end_s)
    true_s = (media_s - log.clock_map.offset_s) / log.clock_map.rate - media_s
    line: Line = fit_line(watched, gyro, fit_at(watched, gyro, float(true_s.mean())))
    truth_s = np.interp(line.window_at_s, media_s, true_s)
    found_s = line.at(line.window_at_s) + line.window_error_s
    found_s -= line.row * film.read_out_s
    rate = film.ridden.trajectory.at(media_s).angular_rate_radps
    high = watched.high_passed(rate, np.ones(len(media_s), dtype=bool))
    near = np.abs(media_s[None, :] - line.window_at_s[:, None]) < 2.0
    rms = np.sqrt((near @ (high**2).sum(axis=1)) / near.sum(axis=1))
    return np.asarray((found_s - truth_s)[np.degrees(rms) >= LEAST_RMS_DEGPS])


def strangers(film: Filmed, number: int, rate_hz: int) -> Iterator[ImuLog]:
    """Yield logs that do not belong to a film: of the same scene and of another one."""
    further = 1 + number % (len(SCENES) - 1)
    other = SCENES[(SCENES.index(film.scene) + further) % len(SCENES)]
    yield logged(
        ride_of(film.scene, film.seed + 1000 + number), (number, 1), rate_hz
    ).imu
    yield logged(ride_of(other, film.seed), (number, 2), rate_hz).imu


def spoilt(frames: FrameRotation) -> dict[str, FrameRotation]:
    """The rotation that a cut, a mirrored and a wrongly timed clip would have shown."""
    begin_s, end_s = frames.begin_s, frames.end_s
    middle_s, removed_s = 0.5 * float(end_s[-1]), 5.0
    kept = (end_s <= middle_s) | (begin_s >= middle_s + removed_s)
    earlier_s = np.where(begin_s > middle_s, removed_s, 0.0)[kept]
    cut = replace(
        frames.select(kept),
        begin_s=begin_s[kept] - earlier_s,
        end_s=end_s[kept] - earlier_s,
    )
    turned = np.array([1.0, -1.0, -1.0])
    return {
        "cut": cut,
        MIRRORED: replace(
            frames,
            rotation_rad=turned * frames.rotation_rad,
            skew_rad=turned * frames.skew_rad,
        ),
        "30 Hz played at 25 Hz": replace(
            frames, begin_s=1.2 * begin_s, end_s=1.2 * end_s
        ),
        "29.97 Hz played at 30 Hz": replace(
            frames, begin_s=begin_s / 1.001, end_s=end_s / 1.001
        ),
    }


def run_film(
    film: Filmed, logs: int, found: Found, follow: Follow, *, with_films: bool
) -> None:
    """Compare one film with its logs and with others."""
    start = time.process_time()
    frames = follow(film.path)
    per_frame_s = (time.process_time() - start) / len(frames)
    found.cpu_s_per_minute.append(1800 * per_frame_s)
    bad = spoilt(frames)
    begin_s, end_s = SHORT_S
    short = frames.select((frames.begin_s >= begin_s) & (frames.end_s <= end_s))
    for number in range(logs):
        for rate_hz in RATES_HZ:
            log = logged(film.ridden, (film.seed, number), rate_hz)
            found.outcomes.append(outcome(film, log, frames))
            for other in strangers(film, number, rate_hz):
                found.note("log of another ride", other, frames)
                found.note("log of another ride, 8 s of the clip", other, short)
            kind = list(bad)[number % len(bad)]
            found.note(kind, log.imu, bad[kind])
    if with_films:
        log = logged(film.ridden, (film.seed, 0), RATES_HZ[0])
        rng = np.random.default_rng(film.seed)
        found.note("stabilised", log.imu, follow(stabilised(film)))
        found.note("still", log.imu, follow(still(film, rng)))


def real(follow: Follow, report: Report) -> None:
    """Synchronise real clips with their own gyro, whose offset is near zero."""
    rows = []
    for name, is_usable in REAL:
        path = DATA / "capture" / "gopro" / name
        if not path.exists():
            print(f"without {name}, which is not on this machine")
            continue
        imu = read_recording(path).imu
        try:
            found = synchronize_frames(imu, follow(path))
        except InputError as problem:
            print(f"{name}: {problem}")
            continue
        middle_s = 0.5 * probe(path).duration_s
        shift_s = found.media_s(middle_s) - middle_s
        explained = found.frames.explained if found.frames else 0.0
        confidence = found.clock_map.confidence
        rows.append([name, 1e3 * shift_s, 1e3 * found.offset_sigma_s, explained,
                     confidence])  # fmt: skip
        if not is_usable:
            what = f"{name} (stabilised): confidence"
            report.target(what, confidence, ("<=", 0.49))
    header = ["real clip", "offset ms", "sigma ms", "explained", "confidence"]
    report.table("Real clips against their own gyro", header, rows)
    report.figures["real"] = [dict(zip(header, row, strict=True)) for row in rows]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--clips", type=int, default=10,
                        help="logs per scene and rate (100 for the whole)")  # fmt: skip
    parser.add_argument("--films", type=int, default=2, help="they are spread over")
    parser.add_argument("--seed", type=int, default=11, help="of the first film")
    parser.add_argument("--scenes", nargs="*", choices=SCENES, default=None)
    kinds = [str(kind) for kind in FeatureKind]
    parser.add_argument("--features", choices=kinds, default=kinds[0])


def run(options: argparse.Namespace, report: Report) -> None:
    """Synchronise all clips."""
    on_one_thread()
    quick, first = options.quick, options.seed
    clips, films = (2, 1) if quick else (options.clips, options.films)
    scenes = tuple(options.scenes or (("horse",) if quick else SCENES))
    report.figures |= {"clips": clips, "films": films, "first_seed": first}
    follow = partial(rotation, kind=FeatureKind(options.features))
    report.figures["features"] = options.features
    found = Found()
    with contextlib.suppress(KeyboardInterrupt):  # what is done until then counts
        for number in range(films):
            logs = clips // films + (number < clips % films)
            for scene in scenes:
                film = filmed(scene, first + number)
                with_films = number == 0 and scene in SPOILT_FILMS
                run_film(film, logs, found, follow, with_films=with_films)
                film.path.unlink()
                print(f"film {number + 1} of {films}: {scene}", flush=True)
    report.figures["logs"] = len(found.outcomes)
    write_tables(found, report)
    write_budget(found.outcomes, report)
    real(follow, report)
