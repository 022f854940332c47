"""Whether a log is read as its clip shows it turning: axes, signs, unit of its rate.

Frames and gyro are compared in all 48 signed axes, the 24 rotations and their mirror
images. Gravity tells which of them a log has that is read rightly.
"""

import dataclasses
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
from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.extras.frames.rotation_match import Gyro, Watched, fit_at
from hapticplayer.extras.frames.synchronizing import synchronize_frames, usable
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import UPRIGHT
from hapticplayer.motion.repair.rotation import SMALL_DIFFERENCE_RAD, coarse_windows

_SCALES = (1.0, 180.0 / math.pi, math.pi / 180.0)
# ratios of the unexplained rotation: right axes leave 10 to 24 times less than others
_CLEARLY_WORSE, _NEARLY_BEST = 1.5, 1.2
_MOST_ANSWERS = 3
_ACCEL, _RATE = "accel-axes", "rate-axes"
_TURNS_RADPS, _UNRELATED = 0.05, 0.5


class AxesFit(NamedTuple):
    """Axes (3, 3) from the log's to the camera's, and the share that they leave."""

    axes: Floats
    unexplained: float


def ask_about_reading(
    recording: Recording, frames: FrameRotation, found: Synchronisation
) -> None:
    """Ask for axes or unit of the gyro where the frames fit others clearly better.

    Args:
        recording: as it was read.
        frames: of its clip.
        found: how both were synchronised.

    Raises:
        LogQuestion: with the answers that fit.
        InputError: when the unit is wrong that the log states.
        UsageError: when the camera turns clearly, but not as the gyro in any axes.
    """
    imu, answers = recording.imu, recording.provenance.get("answers", {})
    try:
        usable(imu, frames)
    except InputError:  # no gyro, or frames that tell too little
        return
    if found.method == "embedded":
        return
    is_unit_kept = is_factor(answers.get("rate-unit", ""), RATE_UNITS)
    scales = _SCALES[:1] if is_unit_kept else _SCALES
    scale, clock = _scale_and_clock(imu, frames, found, scales)
    if clock is None:
        if not is_unit_kept:
            _refuse_unrelated(recording, frames, found)
        return
    fits: list[Message] = []
    if answers.get(_RATE) != AS_RECORDED:
        axes = _contradicting(_scaled(imu, scale), frames, clock)
        fits = _axes_answers(recording, axes) if axes else []
    if scale != 1.0:
        fits = _unit_answers(recording, scale, fits)
    if fits:
        raise LogQuestion(
            Message(
                "its gyroscope does not turn as the camera in the frames of the clip"
            ),
            fits,
            imu.source,
        )


def _refuse_unrelated(
    recording: Recording, frames: FrameRotation, found: Synchronisation
) -> None:
    """Ask where taps fit, but the frames turn clearly and otherwise than the gyro."""
    if not found.is_confident or _turn_rate_radps(frames) < _TURNS_RADPS:
        return
    best = axes_fits(recording.imu, frames, found.clock_map)[0]
    if best.unexplained < _UNRELATED:
        return
    raise UsageError(
        "{log}: the taps fit, but the gyro explains only {explained:.0%} of the camera's "
        "rotation in the frames, in any axes: is it the log of this clip, and the video "
        "not stabilised? To take the taps alone, say so (--sync pats)",
        log=name_of(recording.imu.source),
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
) -> tuple[float, ClockMap | None]:
    """The factor of the rates with which frames and gyro agree, and when; or None."""
    by_frames = _of_frames(found)
    if by_frames is not None:
        return 1.0, by_frames.clock_map
    for scale in scales:
        for sign in (1.0, -1.0):
            if scale == sign:  # as it is
                continue
            tried = synchronize_frames(_scaled(imu, sign * scale), frames)
            if tried.is_confident:
                return scale, tried.clock_map
    return 1.0, None


def _of_frames(found: Synchronisation) -> Synchronisation | None:
    """The result of the frames, where it can be believed."""
    for one in (found, found.second):
        if one is not None and one.method == "frames" and one.is_confident:
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


def _contradicting(imu: ImuLog, frames: FrameRotation, clock: ClockMap) -> list[Floats]:
    """Axes that fit clearly better than any mounting that gravity allows, or none."""
    fits, up = axes_fits(imu, frames, clock), mean_up(imu)
    usual = [fit.unexplained for fit in fits if _is_mounting(fit.axes, up)]
    best = max(fits[0].unexplained, 1e-6)
    if not usual or min(usual) < _CLEARLY_WORSE * best:
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
    windows = coarse_windows(imu)
    found: list[tuple[int, float, Message]] = []

    def add(change: Floats, relative: Floats, *, is_both: bool) -> None:
        evidence = windows.evidence(relative, SMALL_DIFFERENCE_RAD)
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
