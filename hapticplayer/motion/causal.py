"""Gravity removal while the samples come: nothing of what follows is known.

The orientation is that of VQF (Laidig and Seel 2023, doi:10.1016/j.inffus.2022.10.014),
sample by sample: it has a smaller error than the Kalman filter at rest and in turns
(`python -m benchmarks.motion causal`). It begins when the sensor has been at rest, which
gives the gyro's bias and the scale of the accelerometer. About 30 us a sample.
"""

import math
from collections import deque
from typing import NamedTuple

import numpy as np
import vqf

from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_GYRO_BIAS_RADPS,
)
from hapticplayer.motion.stillness import (
    PLAUSIBLE_GAIN_RANGE,
    STILL_ACCEL_STD_LIMIT_MPS2,
    STILL_RATE_STD_LIMIT_RADPS,
)

REST_S = 1.5
"""At rest before the first acceleration."""
BRIDGED_S = 1.0
"""A longer gap begins anew: too much may have happened. So does a clock that goes back
by more."""
_LEAST_SAMPLES = 15
_STEADY_STEPS = 1.5


class _Sample(NamedTuple):
    time_s: float
    force_mps2: Floats
    rate_radps: Floats


class CausalFilter:
    """Removes gravity from one sample after the other.

    Attributes:
        rest_s: for how long the sensor has been at rest, up to REST_S, before it begins.
        up: of the last sample, (3,) in the axes of the sensor.
        skipped: samples that were not usable: not finite, beyond any sensor, not in order.
    """

    def __init__(self) -> None:
        self.skipped, self.up = 0, np.array([0.0, 0.0, 1.0])
        self._restart()

    def _restart(self) -> None:
        self.rest_s = 0.0
        self._rest: deque[_Sample] = deque()
        self._last: _Sample | None = None
        self._filter: vqf.VQF | None = None

    @property
    def is_ready(self) -> bool:
        """Whether it has begun."""
        return self._filter is not None

    def add(
        self, time_s: float, force_mps2: Floats, rate_radps: Floats
    ) -> Floats | None:
        """Return the linear acceleration, (3,) in the axes of the sensor.

        None for a sample that is not usable, and until the sensor has been at rest.

        Raises:
            InputError: when what it reads at rest is not gravity.
        """
        sample, before = _Sample(time_s, force_mps2, rate_radps), self._last
        step_s = time_s - before.time_s if before else math.inf
        is_anew = before is not None and abs(step_s) > BRIDGED_S
        if not (_is_plausible(sample) and (step_s > 0.0 or is_anew)):
            self.skipped += 1
            return None
        if is_anew:
            self._restart()
        self._last = sample
        if self._filter is not None and before is not None:
            return self._removed(sample, before)
        self._wait_for_rest(sample)
        return None

    def _removed(self, sample: _Sample, before: _Sample) -> Floats:
        assert self._filter is not None
        steps = (sample.time_s - before.time_s) / self._period_s
        rate = sample.rate_radps
        if steps > _STEADY_STEPS:  # it turned between the two
            rate = 0.5 * (rate + before.rate_radps)
        force = self._gain * sample.force_mps2
        # the filter knows one period only: what was turned through counts
        self._filter.update(steps * (rate - self._bias), force)
        w, x, y, z = self._filter.getQuat6D().tolist()
        up = (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))
        self.up = np.array(up)
        return np.asarray(force - STANDARD_GRAVITY_MPS2 * self.up)

    def _wait_for_rest(self, sample: _Sample) -> None:
        rest = self._rest
        rest.append(sample)
        while len(rest) > 1 and sample.time_s - rest[1].time_s >= REST_S:
            rest.popleft()
        force = np.array([one.force_mps2 for one in rest])
        rate = np.array([one.rate_radps for one in rest])
        if not _is_still(force, rate):
            rest.clear()
        self.rest_s = sample.time_s - rest[0].time_s if rest else 0.0
        if self.rest_s >= REST_S and len(rest) >= _LEAST_SAMPLES:
            self._begin(force, rate)

    def _begin(self, force: Floats, rate: Floats) -> None:
        norm_mps2 = float(np.linalg.norm(force.mean(axis=0)))
        gain = STANDARD_GRAVITY_MPS2 / max(norm_mps2, 1e-9)
        least, largest = PLAUSIBLE_GAIN_RANGE
        if not least <= gain <= largest:
            raise InputError(
                "the accelerometer reads {norm_mps2:.3g} m/s2 at rest, gravity is 9.8",
                remedy=Message(
                    "choose its acceleration with gravity, or another unit (accel-unit)"
                ),
                norm_mps2=norm_mps2,
            )
        self._gain, self._bias = gain, rate.mean(axis=0)
        times = [one.time_s for one in self._rest]
        self._period_s = float(np.median(np.diff(times)))
        self._filter = vqf.VQF(self._period_s)
        for one_rate, one_force in zip(rate, force, strict=True):
            self._filter.update(one_rate - self._bias, gain * one_force)


def _is_plausible(sample: _Sample) -> bool:
    """Whether it may be a sample; also False for what is not finite."""
    return bool(
        math.isfinite(sample.time_s)
        and np.abs(sample.force_mps2).max() <= MAX_ACCELERATION_MPS2
        and np.abs(sample.rate_radps).max() <= MAX_ANGULAR_RATE_RADPS
    )


def _is_still(force: Floats, rate: Floats) -> bool:
    return bool(
        np.linalg.norm(force.std(axis=0)) < STILL_ACCEL_STD_LIMIT_MPS2
        and np.linalg.norm(rate.std(axis=0)) < STILL_RATE_STD_LIMIT_RADPS
        and np.linalg.norm(rate.mean(axis=0)) < MAX_GYRO_BIAS_RADPS
    )
