"""How much errors of a force count at each frequency.

    |W(f)|^2 = (w^2 + (f/f_1)^2) / (1 + (f/f_1)^2) / (1 + (f/f_2)^4)

A constant error counts w, one of 0.5 to 10 Hz counts 1; above 15 Hz a grip does not move.
Nobody has measured w for forces on a hand; 0.03 to 1 change an optimised washout little.
"""

import numpy as np

from hapticplayer.model.arrays import Floats

CORNERS_HZ = 0.5, 15.0
CONSTANT_WEIGHT = 0.3


def weight(frequency_hz: Floats, constant_weight: float = CONSTANT_WEIGHT) -> Floats:
    """Return |W|, (M,), at frequencies (M,)."""
    low, high = (np.square(frequency_hz / corner) for corner in CORNERS_HZ)
    square = (constant_weight**2 + low) / (1.0 + low) / (1.0 + high * high)
    return np.asarray(np.sqrt(square))


def weighted(force_n: Floats, rate_hz: float) -> Floats:
    """Return W applied to forces (..., N) in N, as if they repeated without end."""
    from scipy import fft  # playing does not need it

    count = force_n.shape[-1]
    by_frequency = weight(fft.rfftfreq(count, 1.0 / rate_hz))
    return np.asarray(fft.irfft(by_frequency * fft.rfft(force_n), count))


def magnitude_rms_n(force_n: Floats) -> float:
    """Return the RMS of the magnitude of forces (3, N), N."""
    return float(np.sqrt(np.square(force_n).sum(axis=0).mean()))
