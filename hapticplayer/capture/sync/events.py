"""Detects sudden onsets: in sound to the millisecond, in acceleration to a sample.

Each event has a rarity, the number of events per second of the same recording that are
at least as strong: this makes sound and acceleration, a quiet car and a storm comparable
without a threshold in any unit.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_toeplitz
from scipy.ndimage import maximum_filter1d, median_filter
from scipy.signal import butter, lfilter, sosfilt

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

CURVE_HZ = 1000
"""Rate of the onset curve of sound."""

_BAND_HZ = (80.0, 800.0)  # a hand on a housing; wind is below, most speech above
_BAND_RATE_HZ = 4000
_AFTER = 10  # ms of power of the event
_BEFORE = (2, 27)  # ms of power before it
_SEPARATION_S = 0.06
_MOST_PER_S = 3.0
_MOST = 6000
_AR_ORDER = 6
_BLOCK_S = 0.5
_AROUND_BLOCKS = 7
_WEIGHT = 0.5  # between strength (0) and contrast (1)


@dataclass(frozen=True, slots=True, eq=False)
class Events:
    """Sudden events, in the order of time.

    Attributes:
        time_s: (N,) onsets, on the stream's own clock.
        strength: (N,) in the stream's own measure.
        rarity_hz: (N,) events per second that are at least as strong.
    """

    time_s: Floats
    strength: Floats
    rarity_hz: Floats

    def __len__(self) -> int:
        return len(self.time_s)

    def within(self, begin_s: float, end_s: float) -> "Events":
        """Return the events of a span, with their rarity in the whole stream."""
        kept = (self.time_s >= begin_s) & (self.time_s <= end_s)
        return Events(self.time_s[kept], self.strength[kept], self.rarity_hz[kept])

    def rarest(self, most: int) -> "Events":
        kept = np.sort(np.argsort(self.rarity_hz, kind="stable")[:most])
        return Events(self.time_s[kept], self.strength[kept], self.rarity_hz[kept])


def sound_onsets(audio: NDArray[np.floating], rate_hz: float) -> Floats:
    """Return the onset strength of the sound at each millisecond (n,), 0 or more.

    Args:
        audio: (n,) mono.
        rate_hz: of the audio, 8000 or more.
    """
    power = _band_power(audio, rate_hz)
    total = np.concatenate([[0.0], np.cumsum(power)])
    at = np.arange(len(power))
    end = np.minimum(at + _AFTER, len(power))
    after = (total[end] - total[at]) / _AFTER
    near, far = (np.maximum(at - ms, 0) for ms in _BEFORE)
    before = (total[near] - total[far]) / (_BEFORE[1] - _BEFORE[0])
    floor = 0.3 * float(np.median(power)) + 1e-14
    rise = np.maximum(np.sqrt(after) - np.sqrt(before), 0.0)
    ratio = np.log((after + 1e-14) / (before + floor))
    curve = np.sqrt(rise) * np.maximum(ratio, 0.0)
    curve[: _BEFORE[1]] = 0.0
    return _against_surroundings(curve, CURVE_HZ)


def loudness(audio: NDArray[np.floating], rate_hz: float) -> Floats:
    """Return the RMS of each millisecond (n,) in the band of pats."""
    return np.sqrt(_band_power(audio, rate_hz))


def _against_surroundings(size: Floats, rate_hz: float) -> Floats:
    """Return values (n,) divided by a power of the background around them.

    The background is the median over 3.5 s of means over 0.5 s, which taps do not
    affect, and at least a fifth of the median background.
    """
    block = max(1, round(_BLOCK_S * rate_hz))
    count = len(size) // block
    if count < 2 * _AROUND_BLOCKS:
        return size
    means = size[: count * block].reshape(count, block).mean(axis=1)
    usual = median_filter(means, _AROUND_BLOCKS, mode="nearest")
    usual = np.maximum(usual, 0.2 * np.median(usual) + 1e-12)
    at = (np.arange(len(size)) + 0.5) / block - 0.5
    return np.asarray(size / np.interp(at, np.arange(count), usual) ** _WEIGHT)


def _band_power(audio: NDArray[np.floating], rate_hz: float) -> Floats:
    """Return the mean square of each millisecond in the band of pats."""
    step = max(1, int(rate_hz // _BAND_RATE_HZ))
    usable = audio[: len(audio) // step * step].reshape(-1, step)
    low = usable.mean(axis=1, dtype=np.float64)
    band_hz = rate_hz / step
    edges = [edge / (band_hz / 2.0) for edge in _BAND_HZ]
    square = sosfilt(butter(2, edges, "band", output="sos"), low) ** 2
    total = np.concatenate([[0.0], np.cumsum(square)])
    marks = np.arange(0.0, len(square), band_hz / CURVE_HZ)
    if band_hz % CURVE_HZ == 0:
        sums = np.diff(total[marks.astype(int)])
    else:
        sums = np.diff(np.interp(marks, np.arange(len(total)), total))
    return np.asarray(sums * CURVE_HZ / band_hz)


def sound_events(curve: Floats) -> Events:
    peaks = _peaks(curve, round(_SEPARATION_S * CURVE_HZ))
    return _ranked(peaks / CURVE_HZ, curve[peaks], len(curve) / CURVE_HZ)


def shocks(imu: ImuLog) -> Floats:
    """Return the innovation of each sample (N,), normalised.

    Each axis is predicted from its own past (autoregression of order 6, which removes
    the regular motion of a walk), and scaled by the median of its error.
    """
    accel = imu.specific_force_mps2
    if len(accel) < 4 * _AR_ORDER:
        return np.zeros(len(accel))
    square = np.zeros(len(accel))
    for axis in range(3):
        signal = accel[:, axis] - accel[:, axis].mean()
        error = lfilter(innovation_filter(signal), [1.0], signal)
        square += (error / (1.4826 * np.median(np.abs(error)) + 1e-6)) ** 2
    square[: 2 * _AR_ORDER] = 0.0
    steps_s = np.diff(imu.time_s, prepend=imu.time_s[0])
    after_gap = np.flatnonzero(steps_s > 1.8 * np.median(steps_s))
    square[np.unique(after_gap[:, None] + np.arange(2)) % len(square)] *= 0.25
    return _against_surroundings(np.sqrt(square), imu.rate_hz)


def innovation_filter(signal: Floats) -> Floats:
    """Return the prediction-error filter (7,) of a signal.

    Autocorrelation method; the identity for a constant signal.
    """
    lags = [signal[: len(signal) - k] @ signal[k:] for k in range(_AR_ORDER + 1)]
    lags[0] = lags[0] * (1.0 + 1e-4) + 1e-12
    weights = solve_toeplitz(lags[:-1], lags[1:])
    return np.concatenate([[1.0], -weights])


def shock_events(imu: ImuLog, size: Floats) -> Events:
    """Return the events among the samples of a log, on its clock."""
    peaks = _peaks(size, max(1, round(_SEPARATION_S * imu.rate_hz)))
    duration_s = float(imu.time_s[-1] - imu.time_s[0]) or 1.0
    return _ranked(imu.time_s[peaks], size[peaks], duration_s)


def _peaks(curve: Floats, reach: int) -> NDArray[np.intp]:
    highest = maximum_filter1d(curve, 2 * reach + 1)
    return np.flatnonzero((curve == highest) & (curve > 0.0))


def _ranked(time_s: Floats, strength: Floats, duration_s: float) -> Events:
    """Return the strongest events with their rarity."""
    order = np.argsort(-strength, kind="stable")
    order = order[: int(min(_MOST, max(12.0, _MOST_PER_S * duration_s)))]
    rarity_hz = np.asarray(np.arange(1.0, len(order) + 1.0) / duration_s)
    back = np.argsort(time_s[order], kind="stable")
    kept = order[back]
    return Events(time_s[kept], strength[kept], rarity_hz[back])
