"""Gravity removal, p[k] = a[k] - |g| n_g[k].

Source: Danieau et al. 2012, "A Framework for Enhancing Video Viewing Experience
with Haptic Effects of Motion", equation 1.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from hapticplayer.errors import InputError, Message, entry_named
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.model.motion import DEFAULT_METHOD
from hapticplayer.motion.even_clock import even_clock, jitter_text
from hapticplayer.motion.flaws import find_flaws
from hapticplayer.motion.methods import (
    METHODS,
    Estimate,
    Parameters,
    Task,
)
from hapticplayer.motion.stillness import (
    WINDOW_S,
    StillSpans,
    estimate_accelerometer_gain,
    find_still,
)

MIN_SAMPLES = 2
MIN_SPAN_S = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class GravityRemoval:
    """A motion track and how it was computed.

    Attributes:
        track: the gravity-free motion.
        summary: plain numbers, lists and texts, for provenance and for people.
        calibration: of the sensor, or None where the method has none to keep.
    """

    track: MotionTrack
    summary: Mapping[str, Any]
    calibration: SensorCalibration | None = None


def estimate_orientation(
    imu: ImuLog,
    method: str = DEFAULT_METHOD,
    *,
    parameters: Parameters | None = None,
    heading: bool = False,
) -> Floats:
    """Return the orientation (N, 4), wxyz, sensor to earth, at the log's times.

    For averaged samples it is the orientation at the middle of each window.

    Args:
        imu: samples in frame A; see ImuLog.
        method: one of METHODS.
        parameters: of the method; None for its defaults.
        heading: whether to use the magnetometer; without, the heading starts at an
            arbitrary angle and drifts.

    Raises:
        UsageError: for a method that does not exist or knows no heading, and for
            parameters of another one.
        InputError: for fewer than two samples, or less than a millisecond of them.
    """
    task = replace(_task(imu, parameters), heading=heading, sigma=False)
    return _estimate(task, method).quaternion_wxyz


def remove_gravity(
    imu: ImuLog,
    method: str = DEFAULT_METHOD,
    *,
    parameters: Parameters | None = None,
) -> MotionTrack:
    """Return the gravity-free acceleration of a log, in frame A.

    The accelerometer's gain is corrected where the recording is still for at least
    one second, else it is 1. Stamps that jitter about an even clock are replaced by it
    for the computation (`even_clock`); the track has the log's own times.

    Args:
        imu: samples in frame A; see ImuLog.
        method: one of METHODS.
        parameters: of the method; None for its defaults.

    Raises:
        UsageError: for a method that does not exist, and for parameters of another.
        InputError: for fewer than two samples, or less than a millisecond of them.
    """
    return _removed(_task(imu, parameters), method, imu.time_s)[0]


def analyse(
    imu: ImuLog,
    method: str = DEFAULT_METHOD,
    *,
    parameters: Parameters | None = None,
) -> GravityRemoval:
    """Remove gravity like `remove_gravity` and summarise how.

    The summary holds `method`, `accelerometer_gain` and where it comes from,
    `still_s`, `leak_at_rest_mps2` (RMS over still spans of what is left there, the
    norm of its mean over each second; None without one), `saturated_share`,
    `invalid_share`, `gravity_sigma_mps2` (median; None if unknown), `clock` (a
    sentence where an even clock was used, else None) and what the method itself
    reports.
    """
    task = _task(imu, parameters)
    track, estimate = _removed(task, method, imu.time_s)
    still = _at_rest(task, estimate)
    gain = estimate_accelerometer_gain(imu, still)
    sigma = track.gravity_sigma_mps2
    summary = {
        "method": method,
        "accelerometer_gain": gain.gain,
        "accelerometer_gain_from": gain.reason,
        "still_s": round(gain.still_s, 3),
        "leak_at_rest_mps2": _leak_mps2(track, still),
        "saturated_share": task.flaws.saturated_share,
        "invalid_share": 1.0 - float(np.mean(track.valid)),
        "gravity_sigma_mps2": None if sigma is None else float(np.median(sigma)),
        "clock": None if task.imu is imu else jitter_text(imu.time_s, task.imu.time_s),
        **estimate.found(),
    }
    return GravityRemoval(track, summary, estimate.calibration)


def _task(imu: ImuLog, parameters: Parameters | None) -> Task:
    if len(imu) < MIN_SAMPLES:
        raise InputError(
            "{count} motion samples are too few; at least {least} are needed",
            where=imu.source,
            count=len(imu),
            least=MIN_SAMPLES,
        )
    span_s = float(imu.time_s[-1] - imu.time_s[0])
    if span_s < MIN_SPAN_S:
        raise InputError(
            "{count} motion samples within {span_ms:.3g} ms are not a recording of motion",
            where=imu.source,
            remedy="give their times in seconds",
            count=len(imu),
            span_ms=1000.0 * span_s,
        )
    clock_s = even_clock(imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps)
    if clock_s is not None:
        imu = replace(imu, time_s=clock_s)
    flaws = find_flaws(imu)
    still = find_still(imu, flaws.interval_s)
    gain = estimate_accelerometer_gain(imu, still).gain
    return Task(imu, gain, still, flaws, parameters)


def _estimate(task: Task, method: str) -> Estimate:
    return entry_named(METHODS, method, Message("method")).estimate(task)


def _removed(task: Task, method: str, time_s: Floats) -> tuple[MotionTrack, Estimate]:
    estimate = _estimate(task, method)
    gain = task.gain
    if estimate.at_rest is not None and gain != 1.0:
        # spans that are accelerated in the solution do not count for the scale
        gain = estimate_accelerometer_gain(task.imu, _at_rest(task, estimate)).gain
    # in place: fresh memory is what long recordings spend most time on
    gravity, sigma = estimate.vertical, estimate.sigma_rad
    gravity *= STANDARD_GRAVITY_MPS2
    acceleration = gain * task.imu.specific_force_mps2
    acceleration -= gravity
    if sigma is not None:
        sigma *= STANDARD_GRAVITY_MPS2
        sigma.setflags(write=False)
    valid = task.flaws.valid
    for fresh in (gravity, acceleration, valid, estimate.quaternion_wxyz):
        fresh.setflags(write=False)  # or the track would copy it
    track = MotionTrack(
        time_s=time_s,
        acceleration_mps2=acceleration,
        gravity_mps2=gravity,
        accelerometer_gain=gain,
        quaternion_wxyz=estimate.quaternion_wxyz,
        gravity_sigma_mps2=sigma,
        valid=valid,
        sampling=task.imu.sampling,
    )
    return track, estimate


def _at_rest(task: Task, estimate: Estimate) -> StillSpans:
    if estimate.at_rest is None:
        return task.still
    return task.still.confirmed(estimate.at_rest)


def _leak_mps2(track: MotionTrack, still: StillSpans) -> float | None:
    """Return the RMS of what is left per second of the still spans."""
    if not still.bins.any() or still.still_s < WINDOW_S - still.bin_s:
        return None
    mask = still.mask(len(track))
    left = track.acceleration_mps2[mask]
    per_second = max(1, round(still.per_bin / still.bin_s))
    starts = np.arange(0, len(left), per_second)
    counts = np.diff(np.append(starts, len(left)))
    means = np.add.reduceat(left, starts, axis=0) / counts[:, None]
    return float(np.sqrt(np.average(np.square(means).sum(axis=1), weights=counts)))
