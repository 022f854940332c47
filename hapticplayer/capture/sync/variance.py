"""The paper's way: the moment at which the variance of a stream crosses a threshold."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

_WINDOW_S = 0.05
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

    The paper gives neither window nor threshold; these are one reading of it.

    Args:
        imu: the log.
        audio: (n,) mono, from media time 0.
        rate_hz: of the audio.
        threshold: in standard deviations above the mean, and of which first seconds.
    """
    size = np.linalg.norm(imu.specific_force_mps2, axis=1)
    window = max(3, round(_WINDOW_S * imu.rate_hz))
    mean = uniform_filter1d(size, window)
    felt = _crossing(uniform_filter1d(size**2, window) - mean**2, imu.time_s, threshold)
    step = max(1, round(rate_hz / _CURVE_HZ))
    power = audio[: len(audio) // step * step].reshape(-1, step).astype(float) ** 2
    loud = uniform_filter1d(power.mean(axis=1), round(_WINDOW_S * _CURVE_HZ))
    heard = _crossing(loud, np.arange(len(loud)) * step / rate_hz, threshold)
    return None if felt is None or heard is None else heard - felt


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
