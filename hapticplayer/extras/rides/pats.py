"""The three pats: taps that the sensor feels and the camera hears.

A tap pushes the camera, and sets its mount swinging: from rest the camera gains speed
the way it is hit, up to the first half of an oscillation; whoever holds it brings it back
a few millimetres later. The push is what an average over a frame shows, for the
oscillation cancels in it. Real ones were not at hand; frequency, strength and spacing lie
in the ranges of the synchronisation's reference clips (18 to 60 Hz, 10 to 35 m/s2, 0.3 to
0.6 s apart). The push has the speed that a tap of those clips leaves, its peak over its
angular frequency.
"""

from dataclasses import dataclass

import numpy as np

from hapticplayer.extras.rides.trajectory import smooth_step
from hapticplayer.model.arrays import Floats

_ONSET_S = 0.012
_RETURN_S = 0.12
"""A pushed camera is farthest away after this time."""
_RINGING = 0.6
"""How much of the speed is the mount's, which swings back; the hand keeps the rest."""
_FREQUENCY_HZ = (22.0, 38.0)
"""Above 45 Hz the knots of a trajectory (200 Hz) would blunt the tap."""


@dataclass(frozen=True, slots=True)
class Tap:
    """One tap."""

    time_s: float  # when it begins, media time
    # of a steady oscillation; the blow itself reaches 1.4 to 2 times it
    peak_mps2: float
    frequency_hz: float  # of the mount
    decay_s: float  # of the oscillation
    direction: tuple[float, float, float]  # unit vector, sensor frame

    @property
    def loudness(self) -> float:
        """Of its sound, 0 to 1."""
        return min(1.0, 0.35 + self.peak_mps2 / 40.0)


def three_pats(rng: np.random.Generator, first_s: float) -> tuple[Tap, ...]:
    """Return three pats by one hand: alike, not equal."""
    step_s, frequency_hz = rng.uniform(0.38, 0.55), rng.uniform(*_FREQUENCY_HZ)
    peak_mps2 = rng.uniform(14.0, 21.0)
    pats = []
    for number in range(3):
        aside = rng.normal(0.0, 0.25, 2)
        blow = np.array([aside[0], aside[1], -1.0])
        blow /= np.linalg.norm(blow)
        pats.append(
            Tap(
                time_s=first_s + number * step_s + float(rng.normal(0.0, 0.02)),
                peak_mps2=float(peak_mps2 * rng.uniform(0.75, 1.25)),
                frequency_hz=float(frequency_hz * rng.uniform(0.95, 1.05)),
                decay_s=float(rng.uniform(0.02, 0.035)),
                direction=(float(blow[0]), float(blow[1]), float(blow[2])),
            )
        )
    return tuple(pats)


def displacement(pats: tuple[Tap, ...], time_s: Floats) -> Floats:
    """The displacement (N, 3) by the pats, m, of a sensor that stands upright."""
    moved = np.zeros((len(time_s), 3))
    for pat in pats:
        since_s = np.clip(time_s - pat.time_s, 0.0, None)
        omega = 2.0 * np.pi * pat.frequency_hz
        swing = smooth_step(time_s, pat.time_s, _ONSET_S) * np.exp(
            -since_s / pat.decay_s
        )
        swing *= _RINGING * pat.peak_mps2 / omega**2 * np.sin(omega * since_s)
        push = smooth_step(time_s, pat.time_s, _ONSET_S) * since_s
        push *= pat.peak_mps2 / omega * np.exp(-since_s / _RETURN_S)
        # minus: from rest the camera gains speed the way it is hit, as long as it is hit
        moved += np.outer(push - swing, pat.direction)
    return moved
