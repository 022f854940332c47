"""What a microphone in a housing hears of the housing's own shaking, and what covers it.

A part is the acceleration itself above 20 to 60 Hz, the rest is rattling: noise through
two resonances of 50 to 250 Hz, as strong as the jerk above a threshold. Shares,
resonances and threshold are drawn for each recording. These are assumptions: no recording
with fast motion and sound of a bicycle was at hand.
"""

from collections.abc import Callable

import numpy as np
from scipy.signal import butter, iirpeak, lfilter, sosfilt

from hapticplayer.extras.events.inputs import LOW_HZ, LowSound, low_sound
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model.arrays import Floats
from tests.material.sync_clips import AUDIO_RATE_HZ, speech, wind

COVERS: dict[str, Callable[[np.random.Generator, int], Floats]] = {
    "wind": wind,
    "speech": speech,
}
"""What may be heard besides."""

_RMS = 0.1


def contact_sound(
    trajectory: Trajectory, duration_s: float, rng: np.random.Generator
) -> Floats:
    """Return the sound (n,) at LOW_HZ, mono, with an RMS of 0.1."""
    time_s = np.arange(round(duration_s * LOW_HZ)) / LOW_HZ
    acceleration = trajectory.at(time_s).acceleration_mps2
    towards = rng.standard_normal(3) + np.array([0.0, 0.0, 2.0])
    corner = butter(2, rng.uniform(20.0, 60.0), "high", fs=LOW_HZ, output="sos")
    direct = sosfilt(corner, acceleration @ towards)
    jerk = np.linalg.norm(np.gradient(acceleration, time_s, axis=0), axis=1)
    loose = np.maximum(jerk - np.quantile(jerk, rng.uniform(0.3, 0.8)), 0.0)
    hits = loose * rng.standard_normal(len(time_s))
    rattle = np.zeros(len(time_s))
    for _ in range(2):
        numerator, denominator = iirpeak(
            rng.uniform(50.0, 250.0), rng.uniform(2.0, 6.0), fs=LOW_HZ
        )
        rattle += _unit(lfilter(numerator, denominator, hits))
    share = rng.uniform(0.2, 0.8)
    return _RMS * _unit(share * _unit(direct) + (1.0 - share) * _unit(rattle))


def covered(sound: Floats, cover: str, db: float, rng: np.random.Generator) -> LowSound:
    """Return a sound (n,) at LOW_HZ with wind or speech, `db` above or below it."""
    more = COVERS[cover](rng, len(sound) * AUDIO_RATE_HZ // LOW_HZ)
    low = np.asarray(low_sound(more, AUDIO_RATE_HZ).samples, float)[: len(sound)]
    level = float(np.std(sound)) * 10.0 ** (db / 20.0)
    return LowSound(np.asarray(sound + level * _unit(low), np.float32))


def _unit(values: Floats) -> Floats:
    return np.asarray(values / max(float(np.std(values)), 1e-12))
