"""What is known of a sensor from elsewhere: a prior that helps short recordings."""

import dataclasses
import functools

import numpy as np
import pytest

from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.motion import SmootherParameters, analyse, remove_gravity

# as of the phones in the recordings with optical truth
GYRO_BIAS_RADPS = np.array([0.05, -0.03, 0.06])
CLIP_S = 10.0


@functools.cache
def ride(scene: str):
    made = simulate_motion(scene, 1, sensor="camera")
    rate = made.imu.angular_rate_radps + GYRO_BIAS_RADPS
    return dataclasses.replace(made.imu, angular_rate_radps=rate), made.vertical


def between(log: ImuLog, start_s: float, end_s: float) -> slice:
    first, last = np.searchsorted(log.time_s, [start_s, end_s]).tolist()
    return slice(first, last)


def error_mps2(log: ImuLog, up, calibration: SensorCalibration | None = None) -> float:
    known = SmootherParameters(calibration=calibration)
    apart = remove_gravity(log, parameters=known).gravity_mps2 / STANDARD_GRAVITY_MPS2
    miss = np.linalg.norm(apart - up, axis=1)
    miss = miss[np.isfinite(miss)]
    return float(9.81 * np.sqrt(np.mean(np.square(miss))))


def clip_errors_mps2(log: ImuLog, up, counted=None) -> tuple[float, float]:
    """Return the mean error of clips of 10 s alone, and with the other half's calibration."""
    begin_s, end_s = float(log.time_s[0]), float(log.time_s[-1])
    middle_s = 0.5 * (begin_s + end_s)
    halves = [between(log, begin_s, middle_s), between(log, middle_s, end_s)]
    known = [
        found.for_another_recording()
        for half in halves[::-1]
        if (found := analyse(log.part(half)).calibration) is not None
    ]
    alone, calibrated = [], []
    truth = up if counted is None else np.where(counted[:, None], up, np.nan)
    for start_s in np.arange(begin_s, end_s - CLIP_S, CLIP_S):
        clip = between(log, start_s, start_s + CLIP_S)
        if start_s < middle_s < start_s + CLIP_S or np.isnan(truth[clip]).all():
            continue
        of_other = known[int(start_s >= middle_s)]
        alone.append(error_mps2(log.part(clip), truth[clip]))
        calibrated.append(error_mps2(log.part(clip), truth[clip], of_other))
    return float(np.mean(alone)), float(np.mean(calibrated))


@pytest.mark.parametrize("scene", ["handheld-brisk", "walk", "bicycle"])
def test_a_calibration_halves_the_error_of_ten_seconds(scene):
    alone, calibrated = clip_errors_mps2(*ride(scene))
    assert calibrated < 0.6 * alone


def test_ten_seconds_of_a_phone_need_what_the_rest_tells(optical):
    """Its bias of 4 deg/s left 0.9 m/s^2 where a drift was taken for a velocity."""
    phone = next(one for one in optical("tyrex native") if "FrontPocket" in one.name)
    alone, calibrated = clip_errors_mps2(phone.log, phone.up, phone.counted)
    whole = remove_gravity(phone.log).gravity_mps2 / STANDARD_GRAVITY_MPS2
    miss = 9.81 * np.linalg.norm(whole - phone.up, axis=1)[phone.counted]
    assert alone < 0.5
    assert calibrated < 0.35
    assert np.sqrt(np.mean(np.square(miss))) < 0.30


def test_a_calibration_of_another_sensor_is_overruled():
    """It is a prior: a minute and a half of a walk knows better."""
    log, up = ride("walk")
    wrong = SensorCalibration((-0.05, 0.03, 0.0), (0.001,) * 3)
    known = SmootherParameters(calibration=wrong.for_another_recording())
    summary = analyse(log, parameters=known).summary
    found, right = summary["gyro_bias_radps"], analyse(log).summary["gyro_bias_radps"]
    assert summary["calibration_overruled"] == 1
    assert np.linalg.norm(np.subtract(found, right)) < 0.01
    assert error_mps2(log, up, wrong.for_another_recording()) < 2.0 * error_mps2(
        log, up
    )


@pytest.mark.parametrize(
    "wrong",
    [
        {"accelerometer_bias_mps2": (0.0, 0.0, 2.4)},
        {"accelerometer_scale": 1.2, "accelerometer_scale_sigma": 0.005},
    ],
)
def test_one_g_at_rest_overrules_a_calibration(wrong):
    log, _ = ride("handheld-brisk")
    count = round(5.0 * log.rate_hz)
    at_rest = ImuLog(
        np.arange(count) / log.rate_hz,
        np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (count, 1)),
        np.tile(GYRO_BIAS_RADPS, (count, 1)),
    )
    known = SensorCalibration(**{"accelerometer_bias_sigma_mps2": (0.05,) * 3, **wrong})
    given = SmootherParameters(calibration=known.for_another_recording())
    found, plain = analyse(at_rest, parameters=given), analyse(at_rest)
    assert found.summary["calibration_overruled"] == 1
    assert (found.track.gravity_mps2 == plain.track.gravity_mps2).all()
    right = SmootherParameters(
        calibration=SensorCalibration(accelerometer_bias_sigma_mps2=(0.05,) * 3)
    )
    assert not analyse(at_rest, parameters=right).summary["calibration_overruled"]


@pytest.mark.parametrize("still_s", [2.0, 4.0])
def test_stillness_in_one_block_calibrates_the_others(still_s):
    """From 3 s on; a shorter span may be a slow turn."""
    log, up = ride("handheld-brisk")
    count = round(still_s * log.rate_hz)
    still = ImuLog(
        log.time_s[0] + np.arange(-count, 0) / log.rate_hz,
        np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (count, 1)),
        np.tile(GYRO_BIAS_RADPS, (count, 1)),
    )
    both = ImuLog(
        *(
            np.concatenate([getattr(one, name) for one in (still, log)])
            for name in ("time_s", "specific_force_mps2", "angular_rate_radps")
        )
    )
    blocks = SmootherParameters(block_s=10.0, margin_s=2.0)
    track = remove_gravity(both, parameters=blocks)
    late = both.time_s > both.time_s[0] + 30.0
    late[:count] = False
    miss = track.gravity_mps2[count:] - STANDARD_GRAVITY_MPS2 * up
    error = float(np.sqrt(np.mean(np.square(miss[late[count:]]).sum(axis=1))))
    assert (error < 0.1) == (still_s > 3.0)
