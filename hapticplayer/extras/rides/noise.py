"""Random motion with a known spectrum: what roads, engines and hands add to a path.

All of it is a displacement or angle at the knots of a trajectory, so that its
derivatives are exact there too.
"""

import numpy as np
from scipy.signal import bilinear, butter, sosfilt, sosfreqz

from hapticplayer.model.arrays import Floats

_SPECTRUM_POINTS = 1 << 16


class Shaker:
    """Makes independent random motions of one length from one generator."""

    def __init__(self, rng: np.random.Generator, count: int, rate_hz: float) -> None:
        """Prepare for motions of `count` samples at a rate."""
        self._rng = rng
        self._count = count
        self._rate_hz = rate_hz

    def shake(
        self, frequency_hz: float, *, damping: float, below_hz: float, rms_mps2: float
    ) -> Floats:
        """Return a displacement in m (N,) whose acceleration has the given RMS.

        A damped oscillator shaken by white noise below a corner: what a sprung mass
        does on a rough road. Its acceleration is flat from its resonance to the
        corner (4th order), its displacement stays bounded.
        """
        sections = np.vstack(
            [
                oscillator(frequency_hz, damping, self._rate_hz),
                butter(4, below_hz, fs=self._rate_hz, output="sos"),
            ]
        )
        return self._coloured(sections, rms_mps2, derivatives=2)

    def wander(self, frequency_hz: float, rms: float) -> Floats:
        """Return a smooth random value (N,) of the given RMS and bandwidth."""
        sections = np.vstack(
            [
                oscillator(frequency_hz, 0.8, self._rate_hz),
                butter(4, 3.0 * frequency_hz, fs=self._rate_hz, output="sos"),
            ]
        )
        return self._coloured(sections, rms, derivatives=0)

    def _coloured(self, sections: Floats, rms: float, derivatives: int) -> Floats:
        """Return filtered white noise with the RMS of its n-th derivative."""
        omega, response = sosfreqz(sections, worN=_SPECTRUM_POINTS)
        gain = np.abs(response) * (omega * self._rate_hz) ** derivatives
        unscaled_rms = np.sqrt(np.mean(gain**2))
        # the impulse response has died away after the 20 s that are thrown away
        warm_up = round(20.0 * self._rate_hz)
        noise = self._rng.standard_normal(warm_up + self._count)
        return np.asarray(sosfilt(sections, noise)[warm_up:] * (rms / unscaled_rms))


def oscillator(frequency_hz: float, damping: float, rate_hz: float) -> Floats:
    """Return the section (1, 6) of a damped oscillator with gain 1 at rest."""
    omega = 2.0 * np.pi * frequency_hz
    numerator, denominator = bilinear(
        [omega**2], [1.0, 2.0 * damping * omega, omega**2], fs=rate_hz
    )
    section = np.zeros((1, 6))
    section[0, 3 - len(numerator) : 3] = numerator
    section[0, 3:] = denominator
    return section


def settled(
    drive: Floats, *, frequency_hz: float, damping: float, rate_hz: float
) -> Floats:
    """Return how a sprung body follows a drive (N,) that starts at zero."""
    return np.asarray(sosfilt(oscillator(frequency_hz, damping, rate_hz), drive))
