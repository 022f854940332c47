"""The vertical as the slow part of the specific force: the trivial method.

It is right while the sensor hardly rotates and its acceleration averages out within
a few periods of the cutoff; it sees no gyroscope. Cost: 0.1 us a sample, 0.25 with
the orientation.
"""

import math

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations

# Chosen on recordings: lower is better on running people, higher on slow hands.
CUTOFF_HZ = 1.0
FILTER_ORDER = 2
# The filter has forgotten its past to 1e-3 after this many periods of the cutoff.
PADDING_PERIODS = 2.0
# A slow part below this is free fall or a dead sensor and has no direction.
MIN_SPECIFIC_FORCE_MPS2 = 0.5


def lowpass_vertical(
    specific_force_mps2: Floats, interval_s: float, cutoff_hz: float = CUTOFF_HZ
) -> Floats:
    """Return the unit vertical (N, 3) by a zero-phase low-pass of each component.

    A Butterworth filter of order 2, once forwards and once backwards: no delay, gain
    1 / (1 + (f / cutoff)^4) far below the Nyquist frequency, which is -6 dB at the
    cutoff and falls by 24 dB an octave. At both ends the recording is mirrored. Where
    the slow part vanishes (free fall) the last direction holds, before the first one
    that first one; up is the sensor's z axis where there is none at all.

    Args:
        specific_force_mps2: (N, 3), finite.
        interval_s: spacing of the samples.
        cutoff_hz: frequency of -6 dB; at or above Nyquist nothing is filtered.
    """
    for name, value in (("interval_s", interval_s), ("cutoff_hz", cutoff_hz)):
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(
                "{name} must be a positive number, got {value}", name=name, value=value
            )
    force = np.asarray(specific_force_mps2, dtype=np.float64)
    return _directions(_smoothed(force, interval_s, cutoff_hz))


def orientation_from_vertical(up: Floats) -> Floats:
    """Return orientations (N, 4), sensor to earth, with these verticals (N, 3).

    The heading starts at an arbitrary angle and is carried along without turning
    about the vertical (parallel transport): from sample to sample the orientation
    changes by the smallest rotation that fits. No formula of one vertical alone is
    continuous over the whole sphere. Where the vertical jumps to its opposite, the
    axis is one of the many across it.

    Args:
        up: unit vectors in the sensor frame.
    """
    columns = np.ascontiguousarray(np.asarray(up, dtype=np.float64).T)
    # the vertical before each sample; in front of the first one, earth's own
    previous = np.column_stack([[0.0, 0.0, 1.0], columns[:, :-1]])[:, : len(up)]
    q = rotations.unit(rotations.cumulative(rotations.shortest(columns, previous)))
    # rounding adds up over millions of products; the vertical is known, so put it back
    residual = rotations.shortest(columns, rotations.vertical(q))
    return rotations.to_wxyz(rotations.unit(rotations.multiply(q, residual)))


def _smoothed(
    specific_force_mps2: Floats, interval_s: float, cutoff_hz: float
) -> Floats:
    from scipy import signal

    if len(specific_force_mps2) < 2 or 2.0 * cutoff_hz * interval_s >= 1.0:
        return specific_force_mps2
    sections = signal.butter(FILTER_ORDER, cutoff_hz, fs=1.0 / interval_s, output="sos")
    wanted = math.ceil(PADDING_PERIODS / (cutoff_hz * interval_s))
    smooth: Floats = signal.sosfiltfilt(
        sections,
        specific_force_mps2,
        axis=0,
        padtype="even",
        padlen=min(wanted, len(specific_force_mps2) - 1),
    )
    return smooth


def _directions(vectors: Floats) -> Floats:
    """Return unit vectors; those too short take the direction of the last usable."""
    norm = np.linalg.norm(vectors, axis=1)
    usable = norm > MIN_SPECIFIC_FORCE_MPS2
    if not usable.any():
        return np.tile([0.0, 0.0, 1.0], (len(vectors), 1))
    last = np.maximum.accumulate(np.where(usable, np.arange(len(norm)), -1))
    last[last < 0] = int(np.argmax(usable))
    return np.asarray(vectors[last] / norm[last, None])
