"""Measures the lag of a camera's own motion against its frames.

Clock and axes are nearly known here, so that only shifts of some ms have to be compared.
"""

import dataclasses
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.clock_lag import CORI, FRAMES, ClockLag, unstamped
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.sync.result import Synchronisation, SyncInput
from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.extras.frames.rotation_line import Line, fit_line
from hapticplayer.extras.frames.rotation_match import Gyro, RotationFit, fit_at
from hapticplayer.extras.frames.synchronizing import (
    find_mounting,
    finding,
    refuse_without_gyro,
    spans_to_watch,
    synchronize_frames,
    usable,
)
from hapticplayer.model import ClockMap, ImuLog

MOST_LAG_S = 0.05
"""Cameras are 10 to 30 ms off; a larger one is not believed."""

_LEAST_EXPLAINED = 0.9
_MOST_SIGMA_S = 0.002
_REACH_S, _STEP_S = 0.06, 0.004
_MUCH = 0.5  # of the rotation in frames
_MARGIN_S = 0.5  # of the log around the parts that are looked at

Spans = Sequence[tuple[float, float]]


class OwnFit(NamedTuple):
    """The best fit near the camera's own clock."""

    fit: RotationFit
    line: Line


def fit_own_clock(imu: ImuLog, frames: FrameRotation) -> OwnFit | None:
    """Return shift and drift near zero; None where the best is at no small shift.

    Args:
        imu: motion with the camera's axes.
        frames: the camera's rotation from frame to frame.

    Raises:
        InputError: when the frames or the log tell of no rotation at all.
    """
    spans_s = spans_to_watch(float(frames.end_s[-1])) if len(frames) else []
    frames = _within(frames, spans_s)
    watched = usable(imu, frames)
    gyro = Gyro(_near(imu, spans_s))
    count = round(_REACH_S / _STEP_S)
    fits = [
        fit_at(watched, gyro, _STEP_S * step, np.eye(3))
        for step in range(-count, count + 1)
    ]
    best = min(fits, key=lambda fit: fit.unexplained)
    if best is fits[0] or best is fits[-1]:
        return None
    line = fit_line(watched, gyro, best)
    best = fit_at(watched, gyro, line.at(watched.begin_s), np.eye(3))
    return OwnFit(best, line) if abs(line.shift_s) <= MOST_LAG_S else None


def sigma_of_windows_s(line: Line) -> float:
    """Return the SD of a line's shift as its windows differ, without any floor."""
    trust = 1.0 / line.window_sigma_s**2
    square = float(trust @ line.window_error_s**2) / max(1, len(trust) - 1)
    return float(np.sqrt(max(1.0, square) / trust.sum()))


def clock_by_rotation(
    imu: ImuLog, rotation: FrameRotation
) -> tuple[ClockMap, ClockLag] | None:
    """The gyro's clock by a rotation that the camera recorded; None where it is unsure."""
    try:
        found = fit_own_clock(imu, rotation)
    except InputError:  # too short, or no rotation
        return None
    if found is None:
        return None
    sigma_s = sigma_of_windows_s(found.line)
    is_sure = found.fit.unexplained <= 1.0 - _LEAST_EXPLAINED
    if not is_sure or sigma_s > _MOST_SIGMA_S:
        return None
    clock = found.line.clock_map(found.line.shift_s, 1.0)
    return clock, ClockLag(CORI, found.line.shift_s, sigma_s)


def with_lag_by_frames(
    imu: ImuLog, own: ClockMap, look: Callable[[], FrameRotation]
) -> Synchronisation:
    """Return the clock of a camera without timestamps as the frames correct it.

    Where they cannot tell, it stays as it is, and `lag` says why.
    """
    found, why = _compared(imu, look)
    if found is None or not found.is_confident:
        lag = unstamped(why or _doubt(found))
        return Synchronisation(own, "embedded", offset_sigma_s=lag.sigma_s, lag=lag)
    clock = dataclasses.replace(found.clock_map, confidence=own.confidence)
    lag = lag_by_frames(found)
    return dataclasses.replace(found, clock_map=clock, method="embedded", lag=lag)


def lag_by_frames(found: Synchronisation) -> ClockLag:
    """Return the lag that a result of the frames means for a camera's own motion."""
    assert found.frames is not None
    clock, media_s = found.clock_map, found.frames.middle_s
    log_s = (media_s - clock.offset_s) / clock.rate
    return ClockLag(FRAMES, log_s - media_s, found.offset_sigma_s)


def _compared(
    imu: ImuLog, look: Callable[[], FrameRotation]
) -> tuple[Synchronisation | None, Message | str]:
    """Return the result of the frames, or why there is none."""
    try:
        frames = look()
        fitted = fit_own_clock(imu, frames)
    except InputError as problem:
        if not problem.remedy:
            return None, problem.what
        return None, Message(
            "{what}; {remedy}", what=problem.what, remedy=problem.remedy
        )
    if fitted is None:
        return None, Message("their rotation is not that of the gyro")
    found = finding([fitted.fit], fitted.line, frames.kind, is_own=True)
    if not found.is_confident:
        return found, ""
    near = _near(imu, spans_to_watch(float(frames.end_s[-1])))
    mounting = find_mounting(near, frames, found.clock_map)
    return dataclasses.replace(found, mounting=mounting), ""


def _doubt(found: Synchronisation | None) -> Message:
    assert found is not None
    assert found.frames is not None
    if found.frames.explained > _MUCH:
        return Message("the camera rotates too slowly to show the time")
    return Message(
        "the gyro explains {explained:.0%} of their rotation (video stabilised, or a "
        "calm camera)",
        explained=max(0.0, found.frames.explained),
    )


def _within(frames: FrameRotation, spans_s: Spans) -> FrameRotation:
    """Return the intervals inside of parts of the clip."""
    inside = np.zeros(len(frames), dtype=bool)
    for begin_s, end_s in spans_s:
        inside |= (frames.begin_s >= begin_s) & (frames.end_s <= end_s)
    return frames.select(inside)


def _near(imu: ImuLog, spans_s: Spans) -> ImuLog:
    """Return the samples around parts of the clip; an integral of hours takes memory."""
    near = np.zeros(len(imu), dtype=bool)
    for begin_s, end_s in spans_s:
        near |= (imu.time_s >= begin_s - _MARGIN_S) & (imu.time_s <= end_s + _MARGIN_S)
    if near.all() or near.sum() < 2:
        return imu
    return ImuLog(
        imu.time_s[near],
        imu.specific_force_mps2[near],
        imu.angular_rate_radps[near],
        sampling=imu.sampling,
        source=imu.source,
    )


def by_frames(inputs: SyncInput) -> Synchronisation:
    """Compare the camera's rotation in the frames with the log's gyro."""
    if inputs.look is None:
        raise UsageError("the method frames needs a clip")
    refuse_without_gyro(inputs.imu)
    is_own = inputs.own is not None
    frames = inputs.look()
    near_s = _shifts_near(inputs, frames)
    found = synchronize_frames(inputs.imu, frames, is_own=is_own, near_s=near_s)
    lag = inputs.lag
    if lag is None or lag.is_measured or not found.is_confident:
        return found
    lag = lag_by_frames(found)
    return dataclasses.replace(found, lag=lag if abs(lag.lag_s) < MOST_LAG_S else None)


def _shifts_near(
    inputs: SyncInput, frames: FrameRotation
) -> tuple[float, float] | None:
    """Log less media time in the middle of the frames, as far as the own clock is known."""
    own, reach_s = inputs.own, inputs.near_s
    if own is None or reach_s is None or not len(frames):
        return None
    media_s = 0.5 * float(frames.begin_s[0] + frames.end_s[-1])
    shift_s = (media_s - own.offset_s) / own.rate - media_s
    return shift_s - reach_s, shift_s + reach_s
