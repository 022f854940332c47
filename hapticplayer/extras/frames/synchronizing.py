"""Synchronises by the camera's rotation, as its frames and as the log's gyro tell it."""

import dataclasses
import math
from collections.abc import Iterator, Sequence

import numpy as np

from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.mounting import all_mountings, axes_matrix
from hapticplayer.capture.sync.result import (
    ENOUGH_CONFIDENCE,
    FoundMounting,
    FrameEvidence,
    Rival,
    Synchronisation,
)
from hapticplayer.errors import InputError, Message, Progress
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.rotation_line import WINDOW_S, Line, fit_line
from hapticplayer.extras.frames.rotation_match import (
    Gyro,
    RotationFit,
    Watched,
    candidates,
    fit_at,
)
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.arrays import Floats

LONG_S = 120.0
"""Of longer clips parts are looked at."""

_PARTS, _PART_S = 4, 30.0
_LEAST_S = 5.0
_CHECKED_S = 6.0  # parts of this length are compared by themselves
_APART_S = 0.05  # nearer shifts are the same

# thresholds at which the confidence is a half; see benchmarks.sync frames
_MARGIN = 2.3  # of many windows: logs of other rides reach 2.4, right ones 4.4 or more
_EXPLAINED = 0.6
_SECOND_AXIS = 0.85  # logs of other rides in cars reach 0.75, right ones 0.93 or more
_ONE_AXIS_CHANCE = 4.0  # that another ride turns alike, over that of turns about two
_TELLING_S = 3.0  # one window of 4 s is enough
_KNOWN_S = 0.006  # SD of a window that tells the time
_SPREAD_S = 0.006
_DRIFT = 150e-6  # two quartzes differ by less; a frame rate that is wrong by 1000e-6

_READ_OUT_S, _READ_OUT_SD_S = 0.012, 0.010  # of rolling shutters, global ones included
_READ_OUT_ERROR_S = 0.005  # of what frames tell of it
_FLOOR_S = 0.003  # what simulated rides are wrong by beyond the fit

# an encoder chooses its vectors to save bits: only those of x264 and a HERO5 were seen
_COARSE_FLOOR_S = 0.006
_COARSE_CONFIDENCE = 0.8

_CUT = Message("a part of the clip fits another part of the log: was the video cut?")


LIVELIEST_S = 12.0
"""Of a clip whose log is placed to some ms already."""


def spans_to_watch(duration_s: float) -> Sequence[tuple[float, float]]:
    """Return begin and end of the parts of a clip to look at, from its start to its end."""
    if duration_s <= LONG_S:
        return [(0.0, duration_s)]
    apart_s = (duration_s - _PART_S) / (_PARTS - 1)
    return [(part * apart_s, part * apart_s + _PART_S) for part in range(_PARTS)]


def synchronize_frames(
    imu: ImuLog,
    frames: FrameRotation,
    *,
    is_own: bool = False,
    near_s: tuple[float, float] | None = None,
) -> Synchronisation:
    """Return the clock map of the log to the frames; confidence 0 if nothing fits.

    Args:
        imu: the log, with a gyro; its axes may be any.
        frames: rotation of the clip, from `rotation.rotation`.
        is_own: whether the log is known to be the clip's own.
        near_s: least and largest shift, log time less media time, that a clock which both
            share allows; they decide between places that fit about as well.
    """
    watched = usable(imu, frames)
    gyro = Gyro(imu)
    fits = candidates(watched, gyro)
    if not fits:
        return Synchronisation(ClockMap(confidence=0.0), "frames")
    line = fit_line(watched, gyro, fits[0])
    found = finding(fits, line, frames.kind, is_own=is_own)
    if near_s is not None and not found.is_confident:
        here = candidates(watched, gyro, near_s)
        if here and here[0].unexplained < _MARGIN * fits[0].unexplained:
            line = fit_line(watched, gyro, here[0])
            found = finding(here, line, frames.kind, is_own=is_own)
    if not found.is_confident:
        return found
    if _is_cut(frames, gyro, line):
        doubted = dataclasses.replace(found.clock_map, confidence=0.0)
        assert found.frames is not None
        seen = dataclasses.replace(found.frames, doubt=_CUT)
        return dataclasses.replace(found, clock_map=doubted, frames=seen)
    mounting = _mounting(watched, gyro, line.at(watched.begin_s))
    return dataclasses.replace(found, mounting=mounting)


def _is_cut(frames: FrameRotation, gyro: Gyro, line: Line) -> bool:
    """Whether a part of the clip fits elsewhere, where it would be accepted by itself.

    Only parts that fit worse than others are searched for.
    """
    parts = [Watched.of(part) for part in _parts(frames)]
    here = [fit_at(part, gyro, line.at(part.begin_s)) for part in parts]
    logged = [
        fit.used.sum() * part.step_s >= _LEAST_S
        for fit, part in zip(here, parts, strict=True)
    ]
    left = [fit.unexplained for fit in here]
    usual = float(np.median(np.compress(logged, left))) if any(logged) else 1.0
    return any(
        is_logged
        and fit.unexplained >= _MARGIN * usual
        and _is_elsewhere(part, gyro, fit)
        for part, fit, is_logged in zip(parts, here, logged, strict=True)
    )


def _is_elsewhere(part: Watched, gyro: Gyro, here: RotationFit) -> bool:
    """Whether a part of a clip clearly belongs to another part of the log."""
    best = next(iter(candidates(part, gyro)), here)
    if (
        abs(best.shift_s - here.shift_s) < _APART_S
        or best.unexplained >= here.unexplained
    ):
        return False
    if best.unexplained <= 1.0 - _EXPLAINED:
        return here.unexplained >= _MARGIN * best.unexplained
    agree_here, agree_there = (
        fit_line(part, gyro, fit).second_axis for fit in (here, best)
    )
    return agree_here < _SECOND_AXIS <= agree_there


def _parts(frames: FrameRotation) -> Iterator[FrameRotation]:
    """The frames of each 6 s, every 3 s, where that is enough."""
    first_s, last_s = float(frames.begin_s[0]), float(frames.end_s[-1]) - _CHECKED_S
    seen_s = (frames.end_s - frames.begin_s) * (frames.quality > 0.0)
    count = max(1, math.ceil((last_s - first_s) / (0.5 * _CHECKED_S)) + 1)
    for begin_s in np.linspace(first_s, max(first_s, last_s), count):
        end_s = begin_s + _CHECKED_S + 1e-6
        inside = (frames.begin_s >= begin_s - 1e-6) & (frames.end_s <= end_s)
        if float(seen_s[inside].sum()) >= _LEAST_S:
            yield frames.select(inside)


def find_mounting(imu: ImuLog, frames: FrameRotation, clock: ClockMap) -> FoundMounting:
    """Return which of the 24 mountings a log has whose clock is known."""
    watched = usable(imu, frames)
    log_s = (watched.begin_s - clock.offset_s) / clock.rate
    return _mounting(watched, Gyro(imu), log_s - watched.begin_s)


def _mounting(watched: Watched, gyro: Gyro, shifts_s: Floats) -> FoundMounting:
    left = {
        axes: fit_at(watched, gyro, shifts_s, axes_matrix(axes)).unexplained
        for axes in all_mountings()
    }
    best, second = sorted(left, key=lambda axes: left[axes])[:2]
    return FoundMounting(best, left[second] / max(left[best], 1e-6), second)


def usable(imu: ImuLog, frames: FrameRotation) -> Watched:
    """Return the frames' rotation, ready to be compared with the log's gyro."""
    refuse_without_gyro(imu)
    told_s = float((frames.end_s - frames.begin_s) @ (frames.quality > 0.0))
    if told_s < _LEAST_S:
        raise InputError(
            "the camera's rotation can be estimated in only {told_s:.2f} s of the video, "
            "at least {least_s:.0f} s are needed",
            remedy="film something with detail, or use the taps (--sync pats)",
            told_s=told_s,
            least_s=_LEAST_S,
        )
    return Watched.of(frames)


def refuse_without_gyro(imu: ImuLog) -> None:
    """Reject a log that tells of no rotation, before its clip is looked at."""
    if not imu.angular_rate_radps.any():
        raise InputError(
            "the log has no angular rate, which frames could be compared with",
            where=imu.source,
            remedy="use the taps (--sync pats), or enter the offset (--offset S)",
        )


def finding(
    fits: list[RotationFit], line: Line, kind: FeatureKind, *, is_own: bool = False
) -> Synchronisation:
    """The result of a line whose fit is the first of several.

    A log that is known to be the clip's own is not one of another ride.
    """
    read_out_s, read_out_sd_s = read_out(line)
    # rows that were read earlier than the middle show an earlier time
    shift_s = line.shift_s - line.row * read_out_s
    evidence = _evidence(fits, line, (read_out_s, read_out_sd_s), kind)
    weakest, doubt = min(
        _signs(evidence, line.least_drift, is_own=is_own), key=lambda sign: sign[0]
    )
    confidence = _confidence(weakest, is_coarse=evidence.is_coarse)
    if confidence < ENOUGH_CONFIDENCE:
        evidence = dataclasses.replace(evidence, doubt=doubt)
    floor_s = _COARSE_FLOOR_S if evidence.is_coarse else _FLOOR_S
    sigma_s = math.hypot(line.shift_sigma_s, line.row * read_out_sd_s, floor_s)
    return Synchronisation(
        line.clock_map(shift_s, confidence),
        "frames",
        margin=evidence.margin,
        rivals=tuple(Rival(-one.shift_s, 1.0 - one.unexplained) for one in fits[1:]),
        has_drift=True,
        offset_sigma_s=sigma_s,
        drift_sigma_ppm=1e6 * line.drift_sigma,
        frames=evidence,
    )


def read_out(line: Line) -> tuple[float, float]:
    """Return the read-out time and its sigma: what frames tell, and what is usual."""
    found = 1.0 / (line.read_out_sigma_s**2 + _READ_OUT_ERROR_S**2)
    usual = 1.0 / _READ_OUT_SD_S**2
    mean_s = (found * line.read_out_s + usual * _READ_OUT_S) / (found + usual)
    return mean_s, 1.0 / math.sqrt(found + usual)


def _evidence(
    fits: list[RotationFit],
    line: Line,
    read_out_s: tuple[float, float],
    kind: FeatureKind,
) -> FrameEvidence:
    best = fits[0].unexplained
    rival = fits[1].unexplained if len(fits) > 1 else 1.0
    telling = line.window_sigma_s < _KNOWN_S
    return FrameEvidence(
        line.middle_s,
        max(0.0, 1.0 - best),
        rival / max(best, 1e-6),
        line.second_axis,
        WINDOW_S * float(telling.sum()),
        line.spread_s,
        *read_out_s,
        str(kind),
    )


def _signs(
    evidence: FrameEvidence, drift: float, *, is_own: bool
) -> Iterator[tuple[float, Message]]:
    """Yield the signs, each 0 at its threshold, and what it makes doubtful."""
    is_alike = evidence.second_axis < _SECOND_AXIS and not is_own
    yield (
        math.log2(evidence.margin / (_MARGIN if is_own else _needed_margin(evidence))),
        Message(
            "frames and gyro agree about one axis only, as those of another ride can"
            if is_alike
            else "other offsets fit nearly as well"
        ),
    )
    yield (
        (evidence.explained - _EXPLAINED) / 0.1,
        Message("is it the log of this clip, and the video not stabilised?"),
    )
    yield (
        math.log2(max(evidence.telling_s, 1e-3) / _TELLING_S),
        Message("the camera turns too little to show the time"),
    )
    yield (
        math.log2(_SPREAD_S / max(evidence.spread_s, 1e-6)),
        Message("parts of the clip give different offsets"),
    )
    yield (
        math.log2(_DRIFT / max(drift, 1e-9)),
        Message(
            "the clocks differ by {ppm:.0f} ppm or more: is the video played at the "
            "frame rate it was recorded with?",
            ppm=1e6 * drift,
        ),
    )


def _needed_margin(evidence: FrameEvidence) -> float:
    """Return the margin at which the confidence is a half.

    Logs of other rides fit the better, the fewer windows tell of a turn; more so where all
    turns are about one axis.
    """
    windows = max(1.0, evidence.telling_s / WINDOW_S)
    chance = 1.0 if evidence.second_axis >= _SECOND_AXIS else _ONE_AXIS_CHANCE
    return _MARGIN * (1.0 + chance / windows)


def _confidence(weakest: float, *, is_coarse: bool) -> float:
    """Return 0 to 1: a half where the weakest sign is at its threshold.

    Less where the features are coarse.
    """
    most = _COARSE_CONFIDENCE if is_coarse else 1.0
    return most / (1.0 + math.exp(-3.0 * min(max(weakest, -10.0), 10.0)))


def watch(
    clip: ClipInfo, progress: Progress, near: ImuLog | None = None
) -> FrameRotation:
    """Follow the frames of a clip, of a long one parts.

    Where the log is placed to some ms, its liveliest part is enough.
    """
    spans_s = spans_to_watch(clip.duration_s)
    if near is not None and clip.duration_s > LIVELIEST_S:
        spans_s = [liveliest_s(near, clip.duration_s)]
    return rotation(clip.path, spans_s=spans_s, progress=progress)


def liveliest_s(imu: ImuLog, duration_s: float) -> tuple[float, float]:
    """Begin and end of the part of a clip in which a log in media time turns most."""
    begins_s = np.arange(0.0, duration_s - LIVELIEST_S, 1.0)
    square = np.square(imu.angular_rate_radps).sum(axis=1)
    summed = np.concatenate([[0.0], np.cumsum(square)])
    turns = [
        np.diff(summed[np.searchsorted(imu.time_s, [at_s, at_s + LIVELIEST_S])])[0]
        for at_s in begins_s
    ]
    begin_s = float(begins_s[int(np.argmax(turns))])
    return begin_s, begin_s + LIVELIEST_S


def mounting_of(
    clip: ClipInfo, imu: ImuLog, clock_map: ClockMap, progress: Progress
) -> FoundMounting:
    """The mounting of a log that is synchronised with a clip."""
    refuse_without_gyro(imu)
    return find_mounting(imu, watch(clip, progress), clock_map)
