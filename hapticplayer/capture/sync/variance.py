"""The paper's method: the time at which the variance of a stream crosses a threshold.

The paper gives neither window nor threshold. Here the variance of a vector is the trace
of its covariance, because the norm hides a tap across gravity; both streams have the same
centred window of 50 ms, but at least three samples of the log (100 ms at 30 Hz), because
windows of different length shift the crossing.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

_WINDOW_S = 0.05
_MIN_SAMPLES = 3
_CURVE_HZ = 1000
WHOLE = (4.0, None)
"""Standard deviations above the mean, of the whole recording: the literal reading."""
FIRST_10_S = (2.0, 10.0)
"""Of its first ten seconds: the kindest reading."""


def variance_shift(
    imu: ImuLog,
    audio: NDArray[np.floating],
    rate_hz: float,
    threshold: tuple[float, float | None] = WHOLE,
) -> float | None:
    """Return media time minus log time of the first crossings, None without one.

    Args:
        imu: the log.
        audio: (n,) mono, from media time 0.
        rate_hz: of the audio.
        threshold: in standard deviations above the mean, and of which first seconds.
    """
    window = max(_MIN_SAMPLES, round(_WINDOW_S * imu.rate_hz))
    accel = imu.specific_force_mps2
    felt = sum(_variance(axis - axis.mean(), window) for axis in accel.T)
    felt_s = _crossing(np.asarray(felt), imu.time_s, threshold)
    step = max(1, round(rate_hz / _CURVE_HZ))
    power = audio[: len(audio) // step * step].reshape(-1, step).astype(float) ** 2
    width = round(window / imu.rate_hz * rate_hz / step)
    heard = uniform_filter1d(power.mean(axis=1), width)
    heard_s = _crossing(heard, np.arange(len(heard)) * step / rate_hz, threshold)
    return None if felt_s is None or heard_s is None else heard_s - felt_s


def _variance(values: Floats, window: int) -> Floats:
    """Return the variance in the window around each of (n,) samples."""
    mean = uniform_filter1d(values, window)
    return np.asarray(uniform_filter1d(values**2, window) - mean**2)


def _crossing(
    variance: Floats, time_s: Floats, threshold: tuple[float, float | None]
) -> float | None:
    deviations, span_s = threshold
    first = np.ones(len(time_s), dtype=bool)
    if span_s is not None:
        first = time_s < time_s[0] + span_s
    limit = variance[first].mean() + deviations * variance[first].std()
    rises = (variance[1:] > limit) & (variance[:-1] <= limit) & first[1:]
    at = int(np.argmax(rises)) if rises.any() else None
    return None if at is None else float(time_s[at + 1])
