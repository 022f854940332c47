"""The sound layer: what a clip's sound tells of impacts that a slow log has smoothed.

A board that averages over 1/30 s loses what is faster than 15 Hz. At impacts that the
motion shows, the sound between 20 and 120 Hz is added to the upward force, with a peak of
0.1 N for each m/s^2 of the impact and at most 0.5 N. Elsewhere it is silent, so that wind,
speech and music are not felt. Measured by `python -m benchmarks.haptics sound_layer`.
"""

from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.errors import UsageError
from hapticplayer.model import ForceTrack, MotionTrack, Reconstruction, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.rendering.event import Material
from hapticplayer.rendering.low_sound import LOW_HZ, LowSound
from hapticplayer.rendering.shocks import find_shocks

BAND_HZ = (20.0, 120.0)
MOST_N = 0.5
N_PER_MPS2 = 0.1
BEFORE_S, RISE_S = 0.05, 0.02
AFTER_S, FALL_S = 0.10, 0.05

UP_AXIS = 1
"""Of frame D."""

FAST_HZ = 100.0
"""A log at this rate holds the shaking itself."""

SILENT = 1e-4
"""Of full scale: a quieter sound tells nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class SoundLayer:
    """A clip's sound and how much of it is felt: 1 as measured, never above 0.5 N."""

    sound: LowSound
    gain: float


def with_sound_layer(
    track: ForceTrack,
    motion: MotionTrack,
    layer: SoundLayer,
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N,
) -> ForceTrack:
    """Return a LINEAR track (frame D, N) with the layer on its upward force.

    It has entries every millisecond at impacts, and is the track's own elsewhere.

    Args:
        track: LINEAR, of the motion.
        motion: in media time.
        layer: sound from media time 0, and its gain.
        force_limit_n: magnitude.

    Raises:
        UsageError: for a motion that holds the shaking itself.
    """
    if track.reconstruction is not Reconstruction.LINEAR:
        raise UsageError("a sound layer needs a track of straight lines")
    rate_hz = 1.0 / float(np.median(np.diff(motion.time_s)))
    if motion.sampling is not Sampling.AVERAGED or rate_hz >= FAST_HZ:
        raise UsageError(
            "the sound layer is for logs of means at less than {fast_hz:g} Hz; this one "
            "holds the shaking itself",
            fast_hz=FAST_HZ,
        )
    wave_n = layer_force(motion, layer)
    grid_s = np.arange(len(wave_n)) / LOW_HZ
    is_felt = wave_n != 0.0
    is_felt[1:] |= wave_n[:-1] != 0.0  # each stretch begins and ends at zero
    is_felt[:-1] |= wave_n[1:] != 0.0
    is_felt &= (grid_s > track.time_s[0]) & (grid_s < track.time_s[-1])
    time_s = np.union1d(track.time_s, grid_s[is_felt])
    force = track.at(time_s)
    own = np.searchsorted(time_s, track.time_s)
    force[own] = track.force_n
    more_n = np.interp(time_s, grid_s, wave_n, 0.0, 0.0)
    force[:, UP_AXIS] += more_n
    length = np.linalg.norm(force, axis=1)
    over = (more_n != 0.0) & (length > force_limit_n)
    force[over] *= (force_limit_n / length[over])[:, None]
    described = {"gain": layer.gain, "band_hz": list(BAND_HZ), "limit_n": MOST_N}
    return replace(
        track,
        time_s=time_s,
        force_n=force.astype(np.float32),
        provenance={**track.provenance, "sound_layer": described},
    )


def layer_force(motion: MotionTrack, layer: SoundLayer) -> Floats:
    """Return the layer (n,) in N at the times of the sound's samples."""
    band = layer.sound.band(*BAND_HZ)
    force = np.zeros(len(band))
    for shock in find_shocks(Material(motion, None, None)):
        first = max(0, round((shock.start_s - BEFORE_S) * LOW_HZ))
        part = band[first : max(first, round((shock.end_s + AFTER_S) * LOW_HZ))].copy()
        since_s = np.arange(len(part)) / LOW_HZ
        part *= np.minimum(1.0, since_s / RISE_S)
        part *= np.minimum(1.0, since_s[::-1] / FALL_S)
        loudest = float(np.abs(part).max(initial=0.0))
        if loudest > SILENT:
            peak_n = min(MOST_N, N_PER_MPS2 * shock.size_mps2)
            force[first : first + len(part)] += layer.gain * peak_n / loudest * part
    return np.clip(force, -MOST_N, MOST_N)


def gain_of(track: ForceTrack) -> float:
    """Return the gain of a track's sound layer; 0 without one."""
    return float(track.provenance.get("sound_layer", {}).get("gain", 0.0))
