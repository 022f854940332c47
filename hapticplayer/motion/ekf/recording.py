"""Orientation by the quaternion-based extended Kalman filter of Sabatini 2006.

A. M. Sabatini, "Quaternion-based extended Kalman filter for determining orientation
by inertial and magnetic sensing", IEEE Trans. Biomed. Eng. 53(7):1346-1356, 2006.

State: quaternion, accelerometer bias and, with a magnetometer, its bias. The angular
rate is the control input; its bias is no state, but captured once in a still start.
Specific force and field are measurements whose noise is infinite (they are skipped)
while they fail their gates. Cost: about 20 us a sample, 45 with a magnetometer.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from hapticplayer.errors import InputError
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.ekf import start
from hapticplayer.motion.ekf.parameters import EkfParameters
from hapticplayer.motion.ekf.quaternion_filter import QuaternionFilter

BLOCK = 4096


@dataclass(frozen=True, slots=True, eq=False)
class EkfResult:
    """The result of the filter.

    Attributes:
        quaternion_wxyz: (N, 4) sensor to earth (east, north, up) at the end of each
            sample's interval; the heading is arbitrary without a magnetometer.
        inclination_sigma_rad: (N,) RMS of the angle between estimated and true
            vertical that the filter expects.
        gyro_bias_radps: (3,) captured in the still start; zero without one.
        still_s: length of the still start; 0 when there is none.
        accelerometer_bias_mps2: (N, 3).
        magnetometer_bias_ut: (N, 3), or None without a magnetometer.
        accelerometer_skipped_share: share of samples that failed the gate, 0 to 1.
        magnetometer_skipped_share: the same, or None without a magnetometer.
    """

    quaternion_wxyz: Floats
    inclination_sigma_rad: Floats
    gyro_bias_radps: Floats
    still_s: float
    accelerometer_bias_mps2: Floats
    magnetometer_bias_ut: Floats | None
    accelerometer_skipped_share: float
    magnetometer_skipped_share: float | None


@dataclass(frozen=True, slots=True, eq=False)
class _Inputs:
    """Samples with their gates; `field_ok` is None without a magnetometer."""

    turns: Floats
    force_mps2: Floats
    force_ok: start.Mask
    field_ut: Floats | None
    field_ok: start.Mask | None


def run_ekf(
    specific_force_mps2: ArrayLike,
    angular_rate_radps: ArrayLike,
    magnetic_field_ut: ArrayLike | None,
    interval_s: float,
    parameters: EkfParameters | None = None,
) -> EkfResult:
    """Estimate the orientation of every sample, forwards in time.

    Args:
        specific_force_mps2: (N, 3) at the end of each interval, N >= 1, finite.
        angular_rate_radps: (N, 3) mean over the interval that ends there.
        magnetic_field_ut: (N, 3), or None: no heading and no work for it.
        interval_s: spacing of the samples.
        parameters: the defaults of EkfParameters where None.
    """
    p = parameters or EkfParameters()
    force, rate = _rows(specific_force_mps2), _rows(angular_rate_radps)
    field = None if magnetic_field_ut is None else _rows(magnetic_field_ut)
    if not len(force) or not np.isfinite(interval_s) or interval_s <= 0.0:
        raise InputError(
            "{count} samples {interval_s} s apart are not a recording",
            count=len(force),
            interval_s=interval_s,
        )
    if len(rate) != len(force) or (field is not None and len(field) != len(force)):
        raise InputError("force, rate and field must have as many samples")

    still = start.still_start(force, rate, interval_s, p)
    turns = quat.from_rotation_vector((rate - still.gyro_bias_radps) * interval_s)
    force_ok = start.accelerometer_gate(force, interval_s, p)
    earth_field, field_ok = None, None
    if field is not None:
        earth_field = start.reference_field(force, field, force_ok, p)
        field_ok = start.magnitude_gate(field, earth_field, p)
    q = start.start_orientation(force, turns, force_ok, still, p)
    w, x, y, z = q.tolist()
    kalman = QuaternionFilter((w, x, y, z), p, interval_s, earth_field)
    run = _FilterPass(kalman, _Inputs(turns, force, force_ok, field, field_ok))
    for first in range(0, len(force), BLOCK):
        run.block(first, min(first + BLOCK, len(force)))
    return run.result(still, interval_s)


class _FilterPass:
    """One pass of the filter over a recording, and what comes out of it."""

    def __init__(self, kalman: QuaternionFilter, inputs: _Inputs) -> None:
        count = len(inputs.force_mps2)
        self._kalman = kalman
        self._in = inputs
        self._q = np.empty((count, 4))
        self._variance = np.empty(count)
        self._bias = np.empty((count, len(kalman.bias)))
        self._has_heading = False
        self._fields_used = 0

    def block(self, first: int, last: int) -> None:
        """Filter the samples from `first` to before `last`."""
        kalman, force = self._kalman, self._in.force_mps2
        # lists: reading a single number out of an array costs more than using it
        turns = self._in.turns[first:last].tolist()
        force_ok = self._in.force_ok[first:last].tolist()
        field_ok = self._in.field_ok
        for k, turn, ok in zip(range(first, last), turns, force_ok, strict=True):
            if k:  # the start orientation belongs to the end of the first interval
                kalman.predict(turn)
            if ok:
                kalman.use_specific_force(force[k])
            if field_ok is not None and field_ok[k]:
                self._use_field(k)
            self._q[k] = kalman.q
            self._bias[k] = kalman.bias
            self._variance[k] = kalman.P[0, 0] + kalman.P[1, 1]

    def _use_field(self, k: int) -> None:
        assert self._in.field_ut is not None
        field_ut = self._in.field_ut[k]
        if not self._has_heading:
            turn = self._kalman.align_heading(field_ut)
            if turn is None:
                return
            self._has_heading = True
            self._q[:k] = quat.multiply(np.array(turn), self._q[:k])
        self._fields_used += self._kalman.use_field(field_ut)

    def result(self, still: start.StillStart, interval_s: float) -> EkfResult:
        """The filter's results."""
        count = len(self._q)
        no_field = self._in.field_ok is None
        return EkfResult(
            quaternion_wxyz=quat.normalized(self._q),
            inclination_sigma_rad=np.sqrt(self._variance),
            gyro_bias_radps=still.gyro_bias_radps,
            still_s=still.count * interval_s,
            accelerometer_bias_mps2=self._bias[:, :3],
            magnetometer_bias_ut=None if no_field else self._bias[:, 3:],
            accelerometer_skipped_share=1.0 - float(np.mean(self._in.force_ok)),
            magnetometer_skipped_share=(
                None if no_field else 1.0 - self._fields_used / count
            ),
        )


def _rows(values: ArrayLike) -> Floats:
    rows = np.ascontiguousarray(values, dtype=np.float64)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError(
            "samples have the shape {shape}, expected N x 3", shape=rows.shape
        )
    return rows
