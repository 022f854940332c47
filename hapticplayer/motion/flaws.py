"""Gaps, missing and clipped samples of a log."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import are_gaps
from hapticplayer.motion.saturation import (
    ACCELEROMETER,
    GYROSCOPE,
    SensorRange,
    find_rails,
    on_rails,
)

Flags = NDArray[np.bool_]

# Straight lines bridge a gap of a few samples; one of this length is unknown.
_UNKNOWN_GAP_S = 0.3
# Share of a clipped sample that counts as unknown: its direction is known.
_CLIPPED_RATE_LOST_SHARE = 0.3
_CLIPPED_FORCE_DOUBT_SHARE = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Flaws:
    """The flaws of a log.

    Attributes:
        interval_s: the median step.
        gap_s: (N,) time before each sample that no sample covers; 0 without a gap.
        missing: (N,) samples that were filled in.
        force_clipped: (N,) on a rail of the accelerometer.
        rate_clipped: (N,) on a rail of the gyro.
        flawless: whether there are none.
    """

    interval_s: float
    gap_s: Floats
    missing: Flags
    force_clipped: Flags
    rate_clipped: Flags
    flawless: bool = field(init=False)

    def __post_init__(self) -> None:
        found = (self.missing, self.force_clipped, self.rate_clipped)
        flawed = self.gap_s.max() > 0.0 or any(flags.any() for flags in found)
        object.__setattr__(self, "flawless", not flawed)

    @property
    def valid(self) -> Flags:
        """Samples that are not missing, clipped or at a gap."""
        if self.flawless:
            return np.ones(len(self.gap_s), np.bool_)
        flawed = self.missing | self.force_clipped | self.rate_clipped
        gap = self.gap_s > 0.0
        flawed |= gap
        flawed[:-1] |= gap[1:]
        return ~flawed

    @property
    def beyond_bridging(self) -> Flags:
        """Samples after a gap that is too long for a straight line, (N,)."""
        return np.asarray(self.gap_s > _UNKNOWN_GAP_S)

    @property
    def _unbridged_gap_s(self) -> Floats:
        return np.asarray(
            self.gap_s * np.minimum(self.gap_s / _UNKNOWN_GAP_S, 1.0) ** 2
        )

    def lost_s(self, step_s: Floats) -> Floats:
        """Return the time in which the rotation is unknown, (N,)."""
        if self.flawless:
            return self.gap_s
        missing = _unbridged(self.missing, step_s)
        clipped = _CLIPPED_RATE_LOST_SHARE * self.rate_clipped
        lost = step_s * np.maximum(missing, clipped)
        return np.asarray(self._unbridged_gap_s + lost)

    def doubt_s(self, step_s: Floats) -> Floats:
        """Return the time in which the specific force is unknown, (N,)."""
        if self.flawless:
            return self.gap_s
        missing = _unbridged(self.missing, step_s)
        clipped = _CLIPPED_FORCE_DOUBT_SHARE * self.force_clipped
        lost = step_s * np.maximum(missing, clipped)
        return np.asarray(self._unbridged_gap_s + lost)

    @property
    def saturated_share(self) -> float:
        """Share of samples on a rail of either sensor, 0 to 1."""
        return float(np.mean(self.force_clipped | self.rate_clipped))


def find_flaws(imu: ImuLog) -> Flaws:
    """Return the flaws of a log of at least two samples."""
    steps = imu.time_s[1:] - imu.time_s[:-1]
    interval_s = float(np.median(steps))
    gap_s = np.zeros(len(imu))
    wide = are_gaps(steps, interval_s)
    gap_s[1:][wide] = steps[wide] - interval_s
    return Flaws(
        interval_s,
        gap_s,
        np.zeros(len(imu), np.bool_) if imu.valid is None else ~imu.valid,
        _clipped(imu.specific_force_mps2, ACCELEROMETER),
        _clipped(imu.angular_rate_radps, GYROSCOPE),
    )


def _clipped(values: Floats, sensor: SensorRange) -> Flags:
    rails = find_rails(values, sensor)
    if rails is None:
        return np.zeros(len(values), np.bool_)
    x, y, z = on_rails(values, rails).T
    return np.asarray(x | y | z)


def _unbridged(missing: Flags, step_s: Floats) -> Floats:
    """Return how unknown filled-in samples are, 0 to 1, by the length of their gap."""
    out = np.zeros(len(missing))
    edges = np.flatnonzero(np.diff(missing, prepend=False, append=False))
    end_s = np.concatenate([[0.0], np.cumsum(step_s)])
    length_s = end_s[edges[1::2]] - end_s[edges[::2]]
    share = np.minimum(length_s / _UNKNOWN_GAP_S, 1.0)
    out[missing] = np.repeat(share, edges[1::2] - edges[::2])
    return out
