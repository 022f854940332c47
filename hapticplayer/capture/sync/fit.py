"""Estimates a shift below one sample, from the waveform of pats in a log.

A pat is a damped sine that begins when it is heard. A logger stores means over its own
windows (33 ms for the paper's board), so a whole pat may be in one or two values; their
ratio still depends on the onset, and three pats give three estimates. For each shift the
window means of damped sines are compared with the log, both whitened by the log's
prediction filter; frequency, decay and the amplitude per axis are free.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter
from scipy.special import logsumexp

from hapticplayer.capture.sync.events import innovation_filter
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

SOUND_LATE_S = 0.001
"""Mean delay of a detected onset in the sound."""

FREQUENCIES_HZ = np.array([14.0, 20.0, 27.0, 35.0, 45.0, 60.0, 80.0])
DECAYS_S = np.array([0.012, 0.025, 0.05])
_STEPS_PER_WINDOW = 16  # of the shifts, but at least 1 ms
_BEFORE, _AFTER = 3, 7  # samples around a pat at 30 Hz
_AFTER_S = 0.1
_MISFIT = 0.2  # of a pat's amplitude: deviation from a damped sine
_SOUND_SIGMA_S = 0.0015


@dataclass(frozen=True, slots=True)
class Fit:
    """A shift estimated from the waveforms.

    Attributes:
        shift_s: media time minus log time.
        sigma_s: SD of its error according to the fit.
    """

    shift_s: float
    sigma_s: float


@dataclass(frozen=True, slots=True, eq=False)
class Whitener:
    """Prediction filters of the three axes, and the SD of their residuals."""

    filters: Floats
    sigma_mps2: Floats

    @classmethod
    def of(cls, imu: ImuLog) -> "Whitener":
        """Estimate them from a log."""
        accel = imu.specific_force_mps2 - imu.specific_force_mps2.mean(axis=0)
        filters = np.stack([innovation_filter(accel[:, axis]) for axis in range(3)])
        left = [lfilter(filters[axis], [1.0], accel[:, axis]) for axis in range(3)]
        sigma = [1.4826 * np.median(np.abs(axis)) + 1e-3 for axis in left]
        return cls(filters, np.array(sigma))


def fit_shift(
    imu: ImuLog,
    whitener: Whitener,
    pats_s: Floats,
    shift_s: float,
    reach_s: float,
) -> Fit:
    """Return the shift at which the waveforms fit best.

    Args:
        imu: the log.
        whitener: of the log.
        pats_s: (K,) media times at which the pats are heard.
        shift_s: centre of the search.
        reach_s: half its width.
    """
    step_s = max(0.001, 1.0 / (_STEPS_PER_WINDOW * imu.rate_hz))
    offsets_s = step_s * np.arange(
        -round(reach_s / step_s), round(reach_s / step_s) + 1
    )
    total = np.zeros(len(offsets_s))
    for pat_s in pats_s:
        felt_s = pat_s - SOUND_LATE_S - (shift_s + offsets_s)
        total += _fitness(imu, whitener, felt_s)
    posterior = np.exp(total - total.max())
    posterior /= posterior.sum()
    mean_s = float(posterior @ offsets_s)
    spread_s = float(np.sqrt(posterior @ (offsets_s - mean_s) ** 2))
    return Fit(shift_s + mean_s, float(np.hypot(spread_s, _SOUND_SIGMA_S)))


def _fitness(imu: ImuLog, whitener: Whitener, felt_s: Floats) -> Floats:
    """Return the log likelihood of one pat beginning at each log time (S,)."""
    step_s = 1.0 / imu.rate_hz
    middle = int(np.searchsorted(imu.time_s, np.median(felt_s)))
    margin = int(np.ceil(float(np.ptp(felt_s)) / 2 / step_s))
    after = max(_AFTER, round(_AFTER_S / step_s))
    order = whitener.filters.shape[1] - 1
    first = max(0, middle - _BEFORE - margin)
    last = min(len(imu), middle + after + margin)
    if last - first < _BEFORE + 2 or first < order:
        return np.zeros(len(felt_s))
    waves = window_means(imu.time_s[first:last], felt_s, step_s)  # (S, form, n)
    total = np.zeros(waves.shape[:2])
    for axis in range(3):
        accel = imu.specific_force_mps2[first - order : last, axis]
        mean = float(np.median(accel))
        filter_ = whitener.filters[axis]
        seen = lfilter(filter_, [1.0], accel - mean)[order:]
        shape = lfilter(filter_, [1.0], waves, axis=-1)
        power = (shape**2).sum(axis=-1) + 1e-12
        explained = (shape @ seen) ** 2 / power
        energy = float(seen @ seen)
        variance = whitener.sigma_mps2[axis] ** 2 + _MISFIT**2 * energy / after
        total += 0.5 * (explained - energy) / variance
    return np.asarray(logsumexp(total, axis=1))


def window_means(time_s: Floats, felt_s: Floats, window_s: float) -> Floats:
    """Return the windows' means of damped sines (S, forms, n)."""
    inner_s = (time_s[1:] + time_s[:-1]) / 2
    edges_s = np.concatenate(
        [[inner_s[0] - window_s], inner_s, [inner_s[-1] + window_s]]
    )
    since_s = edges_s[None, None, :] - felt_s[:, None, None]
    hz, decay_s = (
        grid.ravel()[None, :, None] for grid in np.meshgrid(FREQUENCIES_HZ, DECAYS_S)
    )
    integral = _integral(since_s, 2 * np.pi * hz, 1.0 / decay_s)
    return np.asarray(np.diff(integral, axis=-1) / np.diff(edges_s))


def _integral(
    time_s: Floats, omega: NDArray[np.float64], decay: NDArray[np.float64]
) -> Floats:
    """Integrate exp(-decay t) sin(omega t) from 0 to a time, 0 before."""
    t = np.maximum(time_s, 0.0)
    turn = omega * t
    falling = np.exp(-decay * t) * (omega * np.cos(turn) + decay * np.sin(turn))
    return np.asarray((omega - falling) / (omega**2 + decay**2))
