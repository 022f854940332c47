"""Isolated spikes: found, told apart from real impacts, and replaced.

A Hampel test (local median and median absolute deviation, MAD; Hampel 1974, Pearson
2002) finds samples that stand out. Standing out is not enough: a tap on the camera
does so too. A spike is a fault of the sampling, and these facts tell it from motion:

- It is short: one sample, or `max_run`. A sensor's own low-pass spreads what is real
  over several samples and lets it ring.
- It is alone: the samples around it (`flank` on each side) go on as if nothing had
  happened. Taps recorded at 286 Hz ring for ten samples.
- It is on one axis. What several axes of accelerometer and gyro show at the same
  moment is motion, unless all of them drop towards zero: that is a reading that was
  skipped or scaled twice (stock firmware of the SparkFun Ultimate IMU divides the old
  gyro value by 14.375 once more).

In doubt the sample stays. In averaged samples a real impact may fill a single one, so
only drops towards zero are removed there: remove spikes first, average then.

Frequency response: not linear. Samples that are no spikes come out bit for bit; a
removed one is read from a straight line between its neighbours in time. Time stamps
stay as they are.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import frozen
from hapticplayer.motion.conditioning.spike_search import (
    DEFAULT_LIMITS,
    SpikeLimits,
    find_spikes,
    replace_samples,
)
from hapticplayer.motion.conditioning.timing import Mask


@dataclass(frozen=True, slots=True, eq=False)
class SpikeReport:
    """What was removed, and what stood out but was left.

    Attributes:
        force: (N, 3) True where the specific force was replaced.
        rate: (N, 3) the same for the angular rate.
        field: (N, 3) the same for the magnetic field; all False without one.
        kept: (N,) True where a run short enough for a spike was left as motion.
    """

    force: Mask
    rate: Mask
    field: Mask
    kept: Mask

    def __post_init__(self) -> None:
        for name, shape in (
            ("force", (None, 3)),
            ("rate", (None, 3)),
            ("field", (None, 3)),
            ("kept", (None,)),
        ):
            masked = frozen(getattr(self, name), shape, name, np.bool_)
            object.__setattr__(self, name, masked)

    @property
    def removed_samples(self) -> int:
        """Number of samples of which at least one axis was replaced."""
        return int(np.sum((self.force | self.rate | self.field).any(axis=1)))

    def __str__(self) -> str:
        parts = [
            f"{int(mask.any(axis=1).sum())} {name}"
            for name, mask in (
                ("accelerometer", self.force),
                ("gyro", self.rate),
                ("magnetometer", self.field),
            )
        ]
        return (
            f"spikes removed from {', '.join(parts)} samples; "
            f"{int(self.kept.sum())} samples stood out and were left as motion"
        )


def remove_spikes(
    imu: ImuLog, limits: SpikeLimits = DEFAULT_LIMITS
) -> tuple[ImuLog, SpikeReport]:
    """Return the log without isolated spikes, and what was done.

    Replaced samples are as good as their neighbours, so `valid` stays as it is; the
    report holds the mask for whoever wants to be stricter. Samples that are not valid
    are neither judged nor used.
    """
    motion = np.hstack([imu.specific_force_mps2, imu.angular_rate_radps])
    floors = np.repeat([limits.force_floor_mps2, limits.rate_floor_radps], 3)
    trusted = np.ones(len(imu), dtype=np.bool_) if imu.valid is None else imu.valid
    only_drops = imu.sampling is Sampling.AVERAGED
    spikes, kept = find_spikes(
        imu.time_s, motion, floors, limits, trusted=trusted, only_drops=only_drops
    )
    motion = replace_samples(imu.time_s, motion, spikes, trusted)
    field, field_spikes = imu.magnetic_field_ut, np.zeros((len(imu), 3), np.bool_)
    if field is not None:
        # a magnet does not come and go within one sample: no axis vouches for another
        floor = np.array([limits.field_floor_ut])
        for axis in range(3):
            field_spikes[:, axis] = find_spikes(
                imu.time_s,
                field[:, axis : axis + 1],
                floor,
                limits,
                trusted=trusted,
                only_drops=only_drops,
            )[0][:, 0]
        field = replace_samples(imu.time_s, field, field_spikes, trusted)
    log = dataclasses.replace(
        imu,
        specific_force_mps2=motion[:, :3],
        angular_rate_radps=motion[:, 3:],
        magnetic_field_ut=field,
    )
    return log, SpikeReport(spikes[:, :3], spikes[:, 3:], field_spikes, kept)
