"""Whether a log is read as its clip shows it turning: axes, signs, unit of its rate.

Frames and gyro are compared in all 48 signed axes, the 24 rotations and their mirror
images. Gravity tells which of them a log has that is read rightly.
"""

import dataclasses
import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.agreement import edits, how_changed
from hapticplayer.capture.choices import (
    RATE_UNITS,
    LogQuestion,
    is_factor,
    kept_as,
    rate_unit_times,
)
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.log_checks import AS_IT_IS
from hapticplayer.capture.mounting import (
    AS_RECORDED,
    all_mountings,
    axes_matrix,
    axes_text,
    gravity_agrees,
    mean_up,
    signed_axes,
)
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.source import name_of
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import InputError, Message, Progress, UsageError
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.rotation_match import Gyro, Watched, fit_at
from hapticplayer.extras.frames.synchronizing import (
    refuse_without_gyro,
    synchronize_frames,
    usable,
)
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import UPRIGHT
from hapticplayer.motion.repair.rotation import windows_of

_SCALES = (1.0, 180.0 / math.pi, math.pi / 180.0)
# ratios of the unexplained rotation: right axes leave 10 to 24 times less than others
_CLEARLY_WORSE, _NEARLY_BEST = 1.5, 1.2
_MOST_ANSWERS = 3
_ACCEL, _RATE = "accel-axes", "rate-axes"
_TURNS_RADPS, _UNRELATED = 0.05, 0.5
_PART_S, _PARTS = 5.0, 3
_FEWEST_SAMPLES = 100
_MOST_OFF_S, _SAME_S = 1.0, 0.05  # of an offset that is known or given
_SURELY_WORSE = 2.0  # in few frames, and of a camera's own gyro

_AGREES = Message("the camera in the frames turns as the gyroscope does")
_CALM = Message(
    "the gyroscope's axes were not compared with the frames: the camera hardly turns"
)
_AT_SCALE = "the camera in the frames turns as the gyroscope would at {scale:.3g} times its rate"
_OTHERWISE = Message(
    "the camera in the frames does not turn as the gyroscope does, in any axes: a "
    "stabilised video, another offset, or the log of another clip"
)


class AxesFit(NamedTuple):
    """Axes (3, 3) from the log's to the camera's, and the share that they leave."""

    axes: Floats
    unexplained: float


def compared(
    clip: ClipInfo,
    recording: Recording,
    found: Synchronisation,
    progress: Progress,
    *,
    frames: FrameRotation | None = None,
) -> Synchronisation:
    """The result, with what the frames tell of the gyro's axes and unit.

    Args:
        clip: the video.
        recording: as it was read.
        found: how both were synchronised.
        progress: see `watching.watched`.
        frames: of the clip; None where the offset is known, given, or that of a method
            that was chosen, so that it is not questioned, and few frames are enough.

    Raises:
        LogQuestion: where other axes or units fit clearly better, with those that do.
        InputError: when the unit is wrong that the log states.
        UsageError: when the camera turns clearly, but not as the gyro in any axes.
    """
    is_settled = frames is None or found.method == "embedded"
    try:
        if frames is None:
            frames = look_where_it_turns(clip, recording, found, progress)
        usable(recording.imu, frames)
    except InputError as why:  # no gyro, or frames that tell too little
        return dataclasses.replace(found, seen=why.what)
    if is_settled:
        return _seen_at(recording, frames, found)
    scales = _SCALES[:1] if _is_unit_kept(recording) else _SCALES
    scale, clock = _scale_and_clock(recording.imu, frames, found, scales)
    if clock is None:
        if not _is_unit_kept(recording):
            _refuse_unrelated(recording, frames, found)
        return dataclasses.replace(found, seen=_unlike(frames))
    _ask_about_reading(recording, frames, clock, scale, _CLEARLY_WORSE)
    return dataclasses.replace(found, seen=_AGREES)


def look_where_it_turns(
    clip: ClipInfo, recording: Recording, found: Synchronisation, progress: Progress
) -> FrameRotation:
    """Follow the parts of a clip in which its gyro rotates most about two axes."""
    refuse_without_gyro(recording.imu)
    imu, clock = recording.imu, found.clock_map
    count = max(1, int(clip.duration_s / _PART_S))
    edges_s = np.linspace(0.0, clip.duration_s, count + 1)
    rows = np.searchsorted(imu.time_s, (edges_s - clock.offset_s) / clock.rate)
    turns = []
    for part, (begin, end) in enumerate(itertools.pairwise(rows)):
        rate = imu.angular_rate_radps[begin:end]
        second = np.linalg.eigvalsh(np.cov(rate.T))[1] if len(rate) > 1 else 0.0
        turns.append((float(second), part))
    parts = sorted(part for _, part in sorted(turns)[-_PARTS:])
    spans_s = [(float(edges_s[part]), float(edges_s[part + 1])) for part in parts]
    return rotation(clip.path, spans_s=spans_s, progress=progress)


def _seen_at(
    recording: Recording, frames: FrameRotation, found: Synchronisation
) -> Synchronisation:
    """What frames tell where the offset is not in question."""
    is_own = found.method == "embedded"
    near = _around(recording.imu, found.clock_map, frames)
    is_unit_sure = is_own and "rate_unit" not in recording.provenance
    is_axes_only = is_unit_sure or _is_unit_kept(recording) or _unlike(frames) is _CALM
    scales = _SCALES[:1] if is_axes_only else _SCALES
    scale, clock = _scale_and_clock(near, frames, found, scales, is_settled=True)
    if clock is not None and _apart_s(clock, found) < _MOST_OFF_S:
        if scale != 1.0 and "rate_unit" not in recording.provenance:
            return _seen_otherwise(found, Message(_AT_SCALE, scale=scale))
        _ask_about_reading(recording, frames, clock, scale, _SURELY_WORSE)
        if is_own or _apart_s(clock, found) < _SAME_S:
            return dataclasses.replace(found, seen=_AGREES)
        return _seen_otherwise(found, _at_offset(clock, found))
    seen = _unlike(frames)
    if is_own or seen is _CALM:
        return dataclasses.replace(found, seen=seen)
    elsewhere = synchronize_frames(recording.imu, frames)
    if elsewhere.is_confident:
        seen = _at_offset(elsewhere.clock_map, found)
    return _seen_otherwise(found, seen)


def _apart_s(clock: ClockMap, found: Synchronisation) -> float:
    return abs(clock.offset_at(found.middle_s) - found.offset_s)


def _at_offset(clock: ClockMap, found: Synchronisation) -> Message:
    return Message(
        "the frames show an offset of {offset_s:.3f} s (--offset {offset_s:.3f})",
        offset_s=clock.offset_at(found.middle_s),
    )


def _seen_otherwise(found: Synchronisation, seen: Message) -> Synchronisation:
    return dataclasses.replace(found, seen=seen, is_seen_otherwise=True)


def _unlike(frames: FrameRotation) -> Message:
    """Why no axes fit."""
    return _CALM if _turn_rate_radps(frames) < _TURNS_RADPS else _OTHERWISE


def _around(imu: ImuLog, clock: ClockMap, frames: FrameRotation) -> ImuLog:
    """The samples around the frames that were followed."""
    media_s = clock.rate * imu.time_s + clock.offset_s
    ended = frames.end_s.searchsorted(media_s - _MOST_OFF_S)
    near = frames.begin_s.searchsorted(media_s + _MOST_OFF_S) > ended
    if near.all() or np.count_nonzero(near) < _FEWEST_SAMPLES:
        return imu
    parts = (imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps)
    time_s, force, rate = (values[near] for values in parts)
    return ImuLog(time_s, force, rate, sampling=imu.sampling, source=imu.source)


def _is_unit_kept(recording: Recording) -> bool:
    answers = recording.provenance.get("answers", {})
    return is_factor(answers.get("rate-unit", ""), RATE_UNITS)


def _ask_about_reading(
    recording: Recording,
    frames: FrameRotation,
    clock: ClockMap,
    scale: float,
    worse: float,
) -> None:
    """Ask for axes and unit of the gyro with which it rotates as the frames.

    Args:
        recording: as it was read.
        frames: of its clip.
        clock: with which both agree.
        scale: of the rates with which they do.
        worse: how much more rotation the usual axes must leave unexplained.
    """
    answers = recording.provenance.get("answers", {})
    fits: list[Message] = []
    if answers.get(_RATE) != AS_RECORDED:
        imu = _scaled(recording.imu, scale)
        axes = _contradicting(imu, frames, clock, worse)
        fits = _axes_answers(recording, axes) if axes else []
    if scale != 1.0:
        fits = _unit_answers(recording, scale, fits)
    if fits:
        raise LogQuestion(
            Message(
                "its gyroscope does not turn as the camera in the frames of the clip"
            ),
            fits,
            recording.imu.source,
        )


def _refuse_unrelated(
    recording: Recording, frames: FrameRotation, found: Synchronisation
) -> None:
    """Ask where taps fit, but the frames turn clearly and otherwise than the gyro."""
    if not found.is_confident or _unlike(frames) is _CALM:
        return
    best = axes_fits(recording.imu, frames, found.clock_map)[0]
    if best.unexplained < _UNRELATED:
        return
    raise UsageError(
        "{log}: the taps fit, but the gyro explains only {explained:.0%} of the camera's "
        "rotation in the frames, in any axes: is it the log of this clip, and the video "
        "not stabilised? To take the taps alone, say so (--sync pats), or give their "
        "offset (--offset {offset_s:.3f})",
        log=name_of(recording.imu.source),
        offset_s=found.clock_map.offset_at(found.middle_s),
        explained=max(0.0, 1.0 - best.unexplained),
    )


def _turn_rate_radps(frames: FrameRotation) -> float:
    """RMS of what frames and gyro are compared by."""
    watched = Watched.of(frames)
    known = watched.weight > 0.0
    if not known.any():
        return 0.0
    high = watched.high_passed(watched.rotation_rad, known)[known]
    return float(np.sqrt(np.square(high).sum(axis=1).mean())) / watched.step_s


def _scale_and_clock(
    imu: ImuLog,
    frames: FrameRotation,
    found: Synchronisation,
    scales: Sequence[float],
    *,
    is_settled: bool = False,
) -> tuple[float, ClockMap | None]:
    """The factor of the rates with which frames and gyro agree, and when; or None."""
    by_frames = _of_frames(found)
    if by_frames is not None:
        return 1.0, by_frames.clock_map
    for scale in scales:
        for sign in (1.0, -1.0):
            if scale == sign and not is_settled:  # it was tried
                continue
            log = _scaled(imu, sign * scale)
            tried = synchronize_frames(log, frames, is_own=is_settled)
            if tried.is_confident:
                return scale, tried.clock_map
    return 1.0, None


def _of_frames(found: Synchronisation) -> Synchronisation | None:
    """The result of the frames, where it can be believed."""
    for one in (found, found.second):
        if one is not None and one.frames is not None and one.is_confident:
            return one
    return None


def _scaled(imu: ImuLog, scale: float) -> ImuLog:
    """The log with other rates; one of another sign is a mirror image."""
    return dataclasses.replace(imu, angular_rate_radps=scale * imu.angular_rate_radps)


def axes_fits(imu: ImuLog, frames: FrameRotation, clock: ClockMap) -> list[AxesFit]:
    """All 48 signed axes, the one with which frames and gyro agree best first."""
    watched, gyro = usable(imu, frames), Gyro(imu)
    shifts_s = (watched.begin_s - clock.offset_s) / clock.rate - watched.begin_s
    turns = [axes_matrix(text) for text in all_mountings()]
    fits = (
        AxesFit(axes, fit_at(watched, gyro, shifts_s, axes).unexplained)
        for axes in (*turns, *(-turn for turn in turns))
    )
    return sorted(fits, key=lambda fit: fit.unexplained)


def _contradicting(
    imu: ImuLog, frames: FrameRotation, clock: ClockMap, worse: float
) -> list[Floats]:
    """Axes that fit clearly better than any mounting that gravity allows, or none."""
    fits, up = axes_fits(imu, frames, clock), mean_up(imu)
    usual = [fit.unexplained for fit in fits if _is_mounting(fit.axes, up)]
    best = max(fits[0].unexplained, 1e-6)
    if not usual or min(usual) < worse * best:
        return []
    return [fit.axes for fit in fits if fit.unexplained < _NEARLY_BEST * best]


def _is_mounting(axes: Floats, up: tuple[float, float, float] | None) -> bool:
    return bool(np.linalg.det(axes) > 0.0) and gravity_agrees(up, axes_text(axes))


def _axes_answers(recording: Recording, shown: Sequence[Floats]) -> list[Message]:
    """What leads to the axes that the frames show: the fewest mistakes, then gravity."""
    provenance, imu = recording.provenance, recording.imu
    answers: dict[str, str] = provenance.get("answers", {})
    axes_given = answers.get("axes") or provenance.get("axes") or AS_RECORDED
    stored, up = axes_matrix(str(axes_given)), mean_up(imu)
    mountings = [axes_matrix(text) for text in all_mountings()]
    allowed = [one for one in mountings if _is_mounting(one, up)] or mountings
    windows = windows_of(imu)
    found: list[tuple[int, float, Message]] = []

    def add(change: Floats, relative: Floats, *, is_both: bool) -> None:
        evidence = float(windows.evidence(relative))
        accel, rate = (
            axes_text(stored.T @ change @ stored @ _given(answers, key))
            for key in (_ACCEL, _RATE)
        )
        text = _answer(accel, rate, how_changed(change), is_both=is_both)
        found.append((edits(change), evidence, text))

    for axes in shown:
        change = min((one.T @ axes for one in allowed), key=edits)
        add(change, change, is_both=False)
        if np.linalg.det(axes) < 0.0 and (up is None or (axes @ up)[2] >= UPRIGHT):
            # mirrored alike, both rotate against each other
            add(axes, -np.eye(3), is_both=True)
    found.sort(key=lambda one: one[:2])
    fits = [answer for *_, answer in found[:_MOST_ANSWERS]]
    if _RATE not in answers:
        keep = Message("rate-axes={axes} to keep both as they are", axes=AS_RECORDED)
        fits.append(keep)
    return fits


def _given(answers: dict[str, str], key: str) -> Floats:
    """The axes (3, 3) that a person has given a sensor."""
    given = signed_axes(answers.get(key, AS_RECORDED))
    assert given is not None
    return given


def _answer(accel: str, rate: str, how: Message, *, is_both: bool) -> Message:
    if not is_both:
        return Message("rate-axes={axes} if the gyroscope is {how}", axes=rate, how=how)
    return Message(
        "accel-axes={accel} rate-axes={rate} if both sensors are {how}",
        accel=accel,
        rate=rate,
        how=how,
    )


def _unit_answers(
    recording: Recording, scale: float, axes: Sequence[Message]
) -> list[Message]:
    """The unit in which the rates are that many times as large, with each of the axes.

    Raises:
        InputError: when the log states its unit.
    """
    unit = str(recording.provenance.get("rate_unit", ""))
    if not unit:
        raise InputError(
            "the angular rate is not that of the camera in the frames of the clip, but "
            "would be if it were {scale:.3g} times as large",
            where=recording.imu.source,
            remedy="multiply it by {scale:.9g} in the log, or take the taps alone "
            "(--sync pats)",
            scale=scale,
        )
    answer = f"rate-unit={rate_unit_times(scale, unit)}"
    both = [Message("{unit} {axes}", unit=answer, axes=one) for one in axes]
    return [
        *(both or [Message("{answer}", answer=answer)]),
        kept_as("rate-unit", unit, RATE_UNITS, AS_IT_IS),
    ]
