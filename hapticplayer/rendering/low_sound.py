"""The low part of a clip's sound, which a hand could feel too."""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

LOW_HZ = 1000
"""Samples per second: sound up to 400 Hz is left."""


@dataclass(frozen=True, slots=True, eq=False)
class LowSound:
    """Mono sound from media time 0.

    Attributes:
        samples: (n,) at LOW_HZ; 1 is full scale.
    """

    samples: NDArray[np.float32]

    def band(self, low_hz: float, high_hz: float) -> Floats:
        """Return the sound (n,) between two frequencies, zero phase."""
        from scipy.signal import butter, sosfiltfilt

        sections = butter(2, (low_hz, high_hz), "band", fs=LOW_HZ, output="sos")
        padding = min(len(self.samples) - 1, LOW_HZ)
        if padding < 1:
            return np.zeros(len(self.samples))
        return np.asarray(sosfiltfilt(sections, self.samples, padlen=padding), float)


def low_sound(samples: NDArray[np.floating], rate_hz: float) -> LowSound:
    """Return the low part of a sound.

    Args:
        samples: (n,) mono, from media time 0.
        rate_hz: of the samples, LOW_HZ or more.
    """
    from scipy.signal import resample_poly

    ratio = Fraction(LOW_HZ / rate_hz).limit_denominator(1000)
    low = resample_poly(samples, ratio.numerator, ratio.denominator)
    return LowSound(np.asarray(low, np.float32))
