"""The orientation estimators by name."""

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.motion import grid
from hapticplayer.motion.ekf import EkfParameters
from hapticplayer.motion.flaws import Flaws
from hapticplayer.motion.smoother import (
    InertialSamples,
    SmoothedRecording,
    SmootherParameters,
    smooth_recording,
    window_mean,
)
from hapticplayer.motion.stillness import StillSpans

Parameters = SmootherParameters | EkfParameters
P = TypeVar("P", SmootherParameters, EkfParameters)

_SMOOTHER, _EKF = SmootherParameters(), EkfParameters()


@dataclass(frozen=True, slots=True, eq=False)
class Estimate:
    """The orientation at the times of a log, by one of the methods.

    Attributes:
        quaternion_wxyz: (N, 4) unit, sensor to earth; for averaged samples in the
            middle of their windows.
        vertical: (N, 3) the earth's up direction in the sensor frame; for averaged
            samples its mean over the window, which is shorter than 1 while it turns.
        sigma_rad: (N,) RMS of the angle between estimated and true vertical, or None
            where the method has none.
        at_rest: (N,) still samples that the estimate confirms, or None where the
            method does not check.
        found: returns parameters and calibration for the provenance: plain numbers,
            lists and texts.
        calibration: of the sensor, or None where the method has none to keep.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats | None = None
    at_rest: NDArray[np.bool_] | None = None
    found: Callable[[], Mapping[str, Any]] = dict
    calibration: SensorCalibration | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Task:
    """What a method is given.

    Attributes:
        imu: the log.
        gain: of the accelerometer; the specific force is to be multiplied with it.
        still: where the recording is still.
        flaws: gaps, missing and clipped samples.
        parameters: of the method, or None for its defaults.
        heading: whether the heading is wanted, from the magnetometer.
        sigma: whether the uncertainty is.
    """

    imu: ImuLog
    gain: float
    still: StillSpans
    flaws: Flaws
    parameters: Parameters | None = None
    heading: bool = False
    sigma: bool = True

    @property
    def specific_force_mps2(self) -> Floats:
        """The specific force times the gain, (N, 3)."""
        if self.gain == 1.0:
            return self.imu.specific_force_mps2
        return self.gain * self.imu.specific_force_mps2


Method = Callable[[Task], Estimate]

# Clipped peaks look like a scale error: two phones that run had one of 17 %.
MAX_SATURATED_SHARE = 0.01

_CHOSEN = "chosen by a person"


def smoother(task: Task) -> Estimate:
    """The non-causal smoother; see `hapticplayer.motion.smoother`."""
    if task.heading:
        raise UsageError(
            "the smoother has no heading; choose one of ekf, vqf, offline-vqf for it"
        )
    parameters = _of_type(task.parameters, _SMOOTHER)
    is_chosen = parameters.time_constant_s is not None
    samples = _samples(task)
    done = smooth_recording(samples, task.still, parameters, with_sigma=task.sigma)
    return Estimate(
        quaternion_wxyz=done.quaternion_wxyz,
        vertical=done.vertical,
        sigma_rad=done.sigma_rad if task.sigma else None,
        at_rest=done.at_rest,
        found=functools.partial(_found, done, is_chosen),
        calibration=_calibration(done, task, is_chosen=is_chosen),
    )


def _calibration(
    done: SmoothedRecording, task: Task, *, is_chosen: bool
) -> SensorCalibration | None:
    """Return the calibration without what clipping has spoiled.

    None with a chosen time constant, for which it is held fixed: its sigma is not known.
    """
    if is_chosen:
        return None
    found = done.calibration(task.gain)
    if task.flaws.saturated_share < MAX_SATURATED_SHARE:
        return found
    return SensorCalibration(found.gyro_bias_radps, found.gyro_bias_sigma_radps)


def _found(done: SmoothedRecording, is_chosen: bool) -> dict[str, Any]:
    """Return calibration and time constant of the smoother, for people."""
    vehicle_weight = float(done.mean("vehicle_weight"))
    noise_factor = max(block.gyro_noise_factor for block in done.blocks)
    return {
        "time_constant_s": [round(value, 2) for value in done.time_constant_s],
        "time_constant_from": _CHOSEN
        if is_chosen
        else _reason(vehicle_weight, noise_factor),
        "driven": round(vehicle_weight, 3),
        "gyro_noise_factor": noise_factor,
        "gyro_scale": _rounded(done.mean("gyro_scale")),
        "gyro_bias_radps": _rounded(done.mean("gyro_bias_radps")),
        "accelerometer_bias_mps2": _rounded(done.mean("accelerometer_bias_mps2")),
        "accelerometer_scale": round(float(done.mean("accelerometer_scale")), 5),
        "accelerometer_scale_sigma": round(
            float(done.mean("accelerometer_scale_sigma")), 5
        ),
        "blocks": len(done.blocks),
        "calibration_overruled": done.overruled,
    }


def _reason(vehicle_weight: float, noise_factor: float) -> str:
    """The origin of the time constant, for people."""
    if noise_factor > 1.0:
        return "the gyro's noise: it is larger than that of a calibrated gyro"
    if vehicle_weight < 0.5:
        return "how fast the recording moves"
    return "a vehicle: its turns are wide"


def _samples(task: Task) -> InertialSamples:
    imu, flaws = task.imu, task.flaws
    step = np.empty(len(imu))
    step[0] = flaws.interval_s
    np.subtract(imu.time_s[1:], imu.time_s[:-1], out=step[1:])
    if not flaws.flawless:
        step[flaws.beyond_bridging] = flaws.interval_s
    return InertialSamples(
        step,
        imu.specific_force_mps2,
        imu.angular_rate_radps,
        imu.sampling is Sampling.AVERAGED,
        flaws.lost_s(step),
        flaws.doubt_s(step),
        flaws.interval_s,
        task.gain,
    )


def _piecewise(method: Method) -> Method:
    """Return a method that restarts after each gap of more than a minute."""

    @functools.wraps(method)
    def run(task: Task) -> Estimate:
        parts = grid.pieces(task.imu)
        if len(parts) == 1:
            return method(task)
        done = [method(replace(task, imu=task.imu.part(part))) for part in parts]
        longest = max(done, key=lambda one: len(one.vertical))
        sigmas = [one.sigma_rad for one in done if one.sigma_rad is not None]
        return Estimate(
            quaternion_wxyz=np.concatenate([one.quaternion_wxyz for one in done]),
            vertical=np.concatenate([one.vertical for one in done]),
            sigma_rad=np.concatenate(sigmas) if len(sigmas) == len(done) else None,
            found=lambda: {**longest.found(), "pieces": len(done)},
        )

    return run


@_piecewise
def kalman(task: Task) -> Estimate:
    """The quaternion Kalman filter of Sabatini 2006; see `hapticplayer.motion.ekf`."""
    from hapticplayer.motion.ekf.recording import run_ekf

    parameters = _of_type(task.parameters, _EKF)
    task, log = _even(task)
    field = log.magnetic_field_ut if task.heading else None
    done = run_ekf(
        log.specific_force_mps2,
        log.angular_rate_radps,
        field,
        log.interval_s,
        parameters,
    )
    sigma = np.interp(task.imu.time_s, log.time_s, done.inclination_sigma_rad)
    found = {
        "gyro_bias_radps": _rounded(done.gyro_bias_radps),
        "gyro_bias_from": f"{done.still_s:.1f} s of a still start"
        if done.still_s
        else "assumed: the recording does not start still",
        "accelerometer_bias_mps2": _rounded(done.accelerometer_bias_mps2[-1]),
        "accelerometer_skipped_share": round(done.accelerometer_skipped_share, 4),
    }
    return _back(task, log, done.quaternion_wxyz, sigma, found)


@_piecewise
def vqf(task: Task) -> Estimate:
    """The causal filter VQF (Laidig and Seel 2023, doi:10.1016/j.inffus.2022.10.014)."""
    import vqf as package

    _no_parameters(task)
    task, log = _even(task)
    runner = package.VQF(log.interval_s)
    if task.heading:
        result = runner.updateBatch(
            np.array(log.angular_rate_radps),
            np.array(log.specific_force_mps2),
            np.array(log.magnetic_field_ut),
        )
        return _back(task, log, np.asarray(result["quat9D"]))
    result = runner.updateBatch(
        np.array(log.angular_rate_radps), np.array(log.specific_force_mps2)
    )
    return _back(task, log, np.asarray(result["quat6D"]))


@_piecewise
def offline_vqf(task: Task) -> Estimate:
    """Offline VQF (same paper): forwards and backwards."""
    import vqf as package

    _no_parameters(task)
    task, log = _even(task)
    field = np.array(log.magnetic_field_ut) if task.heading else None
    result = package.offlineVQF(
        np.array(log.angular_rate_radps),
        np.array(log.specific_force_mps2),
        field,
        log.interval_s,
    )
    return _back(task, log, np.asarray(result["quat9D" if task.heading else "quat6D"]))


@_piecewise
def low_pass(task: Task) -> Estimate:
    """The slow part of the specific force; see `hapticplayer.motion.lowpass`."""
    from hapticplayer.motion.lowpass import (
        lowpass_vertical,
        orientation_from_vertical,
    )

    if task.heading:
        raise UsageError("the low-pass has no heading; choose one of ekf, vqf")
    _no_parameters(task)
    task, log = _even(task)
    up = lowpass_vertical(log.specific_force_mps2, log.interval_s)
    q = orientation_from_vertical(up)
    # a filtered value has no half window to be turned back
    q = _at_times(task, log, q)
    return Estimate(q, quat.vertical(q))


class GravityMethod(NamedTuple):
    """One way to estimate the orientation: an entry of `METHODS`."""

    name: str
    text: Message
    estimate: Method


_METHODS = (
    GravityMethod(
        "smoother",
        Message("a smoother over the whole recording, with the sensor's errors"),
        smoother,
    ),
    GravityMethod(
        "ekf", Message("the quaternion Kalman filter of Sabatini 2006"), kalman
    ),
    GravityMethod("vqf", Message("the causal filter of Laidig and Seel 2023"), vqf),
    GravityMethod(
        "offline-vqf", Message("the same, forwards and backwards"), offline_vqf
    ),
    GravityMethod(
        "lowpass", Message("the slow part of the specific force is gravity"), low_pass
    ),
)
METHODS: dict[str, GravityMethod] = {one.name: one for one in _METHODS}
"""Orientation estimators by name."""


def _even(task: Task) -> tuple[Task, grid.EvenLog]:
    """Return the task without long gaps, and its log on an even grid."""
    if task.heading and task.imu.magnetic_field_ut is None:
        raise UsageError("the recording has no magnetometer to find the heading with")
    task = replace(task, imu=grid.with_gaps_closed(task.imu))
    even = grid.even(task.imu, task.specific_force_mps2, with_field=task.heading)
    return task, even


def _back(
    task: Task,
    log: grid.EvenLog,
    q: Floats,
    sigma_rad: Floats | None = None,
    found: dict[str, object] | None = None,
) -> Estimate:
    """Return an answer for the ends of even intervals at the times of the log."""
    turn = log.interval_s * log.angular_rate_radps
    averaged = task.imu.sampling is Sampling.AVERAGED
    if averaged:
        # the filter's answer belongs to the end of the window, half of one later
        q = quat.multiply(q, quat.from_rotation_vector(-0.5 * turn))
    q = _at_times(task, log, q)
    vertical = quat.vertical(q)
    if averaged:
        same = log.time_s is task.imu.time_s
        turned = turn if same else grid.columns(task.imu.time_s, log.time_s, turn)
        vertical = np.ascontiguousarray(window_mean(vertical.T, turned.T).T)
    return Estimate(q, vertical, sigma_rad, found=lambda: found or {})


def _at_times(task: Task, log: grid.EvenLog, q: Floats) -> Floats:
    if log.time_s is task.imu.time_s:
        return quat.normalized(q)
    return quat.interpolate(task.imu.time_s, log.time_s, q)


def _of_type(given: Parameters | None, default: P) -> P:
    """Return the parameters of a method, its defaults where none are given."""
    if given is None:
        return default
    if not isinstance(given, type(default)):
        raise UsageError(
            "this method takes {expected}, not {given}",
            expected=type(default).__name__,
            given=type(given).__name__,
        )
    return given


def _no_parameters(task: Task) -> None:
    if task.parameters is not None:
        raise UsageError("this method takes no parameters")


def _rounded(values: Floats) -> list[float]:
    return [round(float(value), 6) for value in values]
