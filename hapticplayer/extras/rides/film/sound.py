"""The sound of a ride: wind and tyres that grow with speed, engine, hooves, thumps."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfilt

from hapticplayer.extras.rides.scenes import Scene, Vehicle
from hapticplayer.model.arrays import Floats

RATE_HZ = 48_000


@dataclass(frozen=True, slots=True)
class Loudness:
    """How loud each part is; 1 is full scale.

    Wind grows with the square of the speed and tyres with it, up to `top_speed_mps`;
    steps are of hooves or feet, stones are cobbles.
    """

    wind: float = 0.0
    tyres: float = 0.0
    engine: float = 0.0
    steps: float = 0.0
    stones: float = 0.0
    step_hz: float = 0.0
    top_speed_mps: float = 5.0


_LOUDNESS: dict[Vehicle, Loudness] = {
    "bicycle": Loudness(wind=0.05, tyres=0.025, stones=0.26),
    "horse": Loudness(
        wind=0.03, tyres=0.004, steps=0.30, step_hz=62.0, top_speed_mps=6.0
    ),
    "car": Loudness(wind=0.018, tyres=0.035, engine=0.09, top_speed_mps=14.0),
    "foot": Loudness(wind=0.004, steps=0.10, step_hz=95.0),
    "tripod": Loudness(wind=0.004),
}
_THUMP_GAIN, _THUMP_HZ = 0.7, 72.0
_PAT_GAIN, _PAT_HZ = 0.8, 170.0
_STONE_HZ, _TYRES_ON_COBBLES, _EDGE_S = 120.0, 2.0, 0.3
_IDLE_HZ, _HZ_PER_MPS = 25.0, 5.5
_GEARS_MPS = (4.5, 8.5, 13.5)
"""Speeds at which the driver changes up."""

_HARMONICS = ((0.5, 0.35), (1.0, 1.0), (1.5, 0.25), (2.0, 0.55), (3.0, 0.3), (4.0, 0.2))
"""Of the firing frequency, with their shares."""


def ride_sound(scene: Scene, rng: np.random.Generator) -> NDArray[np.float32]:
    """Return stereo sound (n, 2) float32; thumps begin exactly at the wheel hits.

    So do the pats, and the steps where feet or hooves land.
    """
    loud = _LOUDNESS[scene.vehicle]
    time_s = np.arange(round(scene.duration_s * RATE_HZ)) / RATE_HZ
    speed = np.interp(time_s, scene.route_time_s, scene.speed_mps)
    pace = speed / loud.top_speed_mps
    wind = _noise(rng, len(time_s), 80.0, 900.0) * (loud.wind * pace**2)[:, None]
    rolling = loud.tyres * pace
    if scene.cobbles_s is not None:
        first_s, last_s = scene.cobbles_s
        edges_s = [first_s, first_s + _EDGE_S, last_s, last_s + _EDGE_S]
        rolling *= np.interp(time_s, edges_s, [1.0, *[_TYRES_ON_COBBLES] * 2, 1.0])
    tyres = _noise(rng, len(time_s), 300.0, 4500.0) * rolling[:, None]
    still = 0.002 * _noise(rng, len(time_s), 200.0, 3000.0)
    sound = wind + tyres + still
    for hit_s, strength in scene.wheel_hits:
        _add_thump(sound, hit_s, (_THUMP_GAIN * strength, _THUMP_HZ), rng)
    for stone_s, strength in scene.stones:
        pitch_hz = _STONE_HZ * float(rng.uniform(0.8, 1.3))
        _add_thump(sound, stone_s, (loud.stones * strength, pitch_hz), rng)
    if loud.engine:
        sound += _engine(scene, time_s, loud.engine)[:, None]
    for step_s, strength in scene.footfalls:
        pitch_hz = loud.step_hz * float(rng.uniform(0.85, 1.2))
        _add_thump(sound, step_s, (loud.steps * strength, pitch_hz), rng)
    for pat in scene.pats:
        _add_thump(sound, pat.time_s, (_PAT_GAIN * pat.loudness, _PAT_HZ), rng)
    return np.clip(sound, -1.0, 1.0).astype(np.float32)


def _engine(scene: Scene, time_s: Floats, gain: float) -> Floats:
    """Return the engine's hum: its pitch follows speed and gear, its level the load."""
    coarse_s = np.arange(time_s[0], time_s[-1], 0.01)
    speed = np.interp(coarse_s, scene.route_time_s, scene.speed_mps)
    thrust = np.clip(np.gradient(speed, coarse_s), -1.0, 3.0)
    gear = 1.0 + sum(np.clip((speed - up) / 0.5, 0.0, 1.0) for up in _GEARS_MPS)
    pitch = _IDLE_HZ + _HZ_PER_MPS * speed * 2.0 / (1.0 + gear)
    level = gain * (0.3 + 0.12 * np.maximum(thrust, 0.0) + 0.02 * speed)
    pitch_hz = np.interp(time_s, coarse_s, pitch)
    phase = 2.0 * np.pi * np.cumsum(pitch_hz) / RATE_HZ
    hum = sum(share * np.sin(order * phase + order) for order, share in _HARMONICS)
    return np.asarray(hum * np.interp(time_s, coarse_s, level))


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
    tone: tuple[float, float],
    rng: np.random.Generator,
) -> None:
    """Add a dull blow with a short rattle, from the sample at `hit_s` on.

    `tone` is its gain and its pitch in Hz; what lies outside of the clip is not heard.
    """
    gain, pitch_hz = tone
    first = round(hit_s * RATE_HZ)
    count = min(len(sound) - first, round(0.4 * RATE_HZ))
    if first < 0 or count <= 0:
        return
    since_s = np.arange(count) / RATE_HZ
    attack = 1.0 - np.exp(-since_s / 0.0008)
    decay_s = 0.055 * _THUMP_HZ / pitch_hz
    blow = np.cos(2.0 * np.pi * pitch_hz * since_s) * np.exp(-since_s / decay_s)
    rattle = (
        _noise(rng, count, 700.0, 3500.0) * (0.16 * np.exp(-since_s / 0.04))[:, None]
    )
    sound[first : first + count] += gain * attack[:, None] * (blow[:, None] + rattle)
