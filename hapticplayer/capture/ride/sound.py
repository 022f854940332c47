"""The sound of a ride: wind and tyres that grow with speed, and thumps of the kerb."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfilt

from hapticplayer.capture.scenes import Scene

RATE_HZ = 48_000

_WIND_GAIN = 0.05
_TYRE_GAIN = 0.025
_THUMP_GAIN = 0.7
_TOP_SPEED_MPS = 5.0


def ride_sound(scene: Scene, rng: np.random.Generator) -> NDArray[np.float32]:
    """Return stereo sound (n, 2) float32; thumps begin exactly at the wheel hits."""
    time_s = np.arange(round(scene.duration_s * RATE_HZ)) / RATE_HZ
    pace = np.interp(time_s, scene.route_time_s, scene.speed_mps) / _TOP_SPEED_MPS
    wind = _noise(rng, len(time_s), 80.0, 900.0) * (_WIND_GAIN * pace**2)[:, None]
    tyres = _noise(rng, len(time_s), 300.0, 4500.0) * (_TYRE_GAIN * pace)[:, None]
    still = 0.002 * _noise(rng, len(time_s), 200.0, 3000.0)
    sound = wind + tyres + still
    for hit_s, strength in scene.wheel_hits:
        _add_thump(sound, hit_s, _THUMP_GAIN * strength, rng)
    return np.clip(sound, -1.0, 1.0).astype(np.float32)


def _noise(
    rng: np.random.Generator, count: int, low_hz: float, high_hz: float
) -> NDArray[np.float64]:
    """Return stereo noise of unit RMS in a band, half of it common to both sides."""
    sides = rng.standard_normal((count, 2)) + rng.standard_normal((count, 1))
    band = butter(2, (low_hz, high_hz), "bandpass", fs=RATE_HZ, output="sos")
    filtered = sosfilt(band, sides, axis=0)
    return np.asarray(filtered / np.sqrt(np.mean(filtered**2)))


def _add_thump(
    sound: NDArray[np.float64],
    hit_s: float,
    gain: float,
    rng: np.random.Generator,
) -> None:
    """Add a dull blow with a short rattle, from the sample at `hit_s` on."""
    first = round(hit_s * RATE_HZ)
    count = min(len(sound) - first, round(0.4 * RATE_HZ))
    since_s = np.arange(count) / RATE_HZ
    attack = 1.0 - np.exp(-since_s / 0.0008)
    blow = np.cos(2.0 * np.pi * 72.0 * since_s) * np.exp(-since_s / 0.055)
    rattle = (
        _noise(rng, count, 700.0, 3500.0) * (0.16 * np.exp(-since_s / 0.04))[:, None]
    )
    sound[first : first + count] += gain * attack[:, None] * (blow[:, None] + rattle)
