"""What the quaternion Kalman filter needs before its first step.

Gates, gyro bias of a still start, reference field and start orientation. All of it
is computed for the whole recording at once.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations
from hapticplayer.motion.ekf.parameters import EkfParameters
from hapticplayer.motion.lowpass import orientation_from_vertical

Mask = NDArray[np.bool_]

# Below this a vector has no direction worth the name.
MIN_SPECIFIC_FORCE_MPS2 = 0.05
MIN_FIELD_UT = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class StillStart:
    """The span at the start of a recording in which the sensor does not move.

    Attributes:
        first: index of its first sample.
        count: number of samples; 0 when there is no such span.
        gyro_bias_radps: (3,) its mean angular rate; zero without a span.
        specific_force_mps2: (3,) its mean specific force; zero without a span.
    """

    first: int
    count: int
    gyro_bias_radps: Floats
    specific_force_mps2: Floats


@dataclass(frozen=True, slots=True)
class Field:
    """The earth's magnetic field: norm in uT and dip below the horizon in rad."""

    magnitude_ut: float
    dip_rad: float


def accelerometer_gate(
    specific_force_mps2: Floats, interval_s: float, p: EkfParameters
) -> Mask:
    """Return (N,) True where the specific force may be taken for gravity.

    The norm has to be within the gate of g on average over the window that ends at
    the sample, and at the sample itself.
    """
    off = np.abs(np.linalg.norm(specific_force_mps2, axis=1) - p.gravity_mps2)
    count = max(1, round(p.accelerometer_gate_window_s / interval_s))
    total = np.concatenate([np.zeros(1), np.cumsum(off)])
    ends = np.arange(1, len(off) + 1)
    starts = np.maximum(ends - count, 0)
    mean = (total[ends] - total[starts]) / (ends - starts)
    gate: Mask = (mean < p.accelerometer_gate_mps2) & (off < p.accelerometer_gate_mps2)
    return gate


def magnitude_gate(magnetic_field_ut: Floats, field: Field, p: EkfParameters) -> Mask:
    """Return (N,) True where the norm of the field is that of the earth's field."""
    norm = np.linalg.norm(magnetic_field_ut, axis=1)
    near = np.abs(norm - field.magnitude_ut) < p.magnetometer_gate_ut
    return np.asarray(near & (norm > MIN_FIELD_UT))


def still_start(
    specific_force_mps2: Floats,
    angular_rate_radps: Floats,
    interval_s: float,
    p: EkfParameters,
) -> StillStart:
    """Return the first still span that begins within the search time.

    Windows of `still_window_s` in which force and rate stay within their limits are
    still; the span is the first unbroken run of such windows.
    """
    longest = math.ceil((p.still_search_s + p.still_longest_s) / interval_s)
    specific_force_mps2 = specific_force_mps2[:longest]
    angular_rate_radps = angular_rate_radps[:longest]
    nothing = StillStart(0, 0, np.zeros(3), np.zeros(3))
    count = max(2, round(p.still_window_s / interval_s))
    if len(angular_rate_radps) < count:
        return nothing
    rate_mean, rate_sigma = _windows(angular_rate_radps, count)
    force_mean, accel_sigma = _windows(specific_force_mps2, count)
    still = (
        (rate_sigma < p.still_rate_sigma_radps)
        & (accel_sigma < p.still_accel_sigma_mps2)
        & (np.linalg.norm(rate_mean, axis=1) < p.max_gyro_bias_radps)
        # floating weightlessly shows no vertical, and any slow spin passes
        & (np.linalg.norm(force_mean, axis=1) > 0.5 * p.gravity_mps2)
    )
    searched = still[: int(p.still_search_s / interval_s) + 1]
    if not searched.any():
        return nothing
    first = int(np.argmax(searched))
    moving = np.flatnonzero(~still[first:])
    windows = int(moving[0]) if len(moving) else len(still) - first
    last = first + windows + count - 1
    return StillStart(
        first,
        last - first,
        angular_rate_radps[first:last].mean(axis=0),
        specific_force_mps2[first:last].mean(axis=0),
    )


def reference_field(
    specific_force_mps2: Floats,
    magnetic_field_ut: Floats,
    usable: Mask,
    p: EkfParameters,
) -> Field:
    """Return the earth's field: as given, or the median of the recording.

    The median bears a magnet that is near for less than half of the time, even at
    the start. The dip is measured against the specific force where it is `usable`.
    """
    norm = np.linalg.norm(magnetic_field_ut, axis=1)
    magnitude_ut, dip_rad = p.field_magnitude_ut, p.field_dip_rad
    if magnitude_ut is None:
        magnitude_ut = float(np.median(norm))
    if dip_rad is None:
        usable = usable & (norm > MIN_FIELD_UT)
        force = specific_force_mps2[usable]
        length = np.linalg.norm(force, axis=1) * norm[usable]
        down = -np.sum(force * magnetic_field_ut[usable], axis=1) / length
        dip_rad = float(np.median(np.arcsin(np.clip(down, -1, 1)))) if len(down) else 0
    return Field(magnitude_ut, dip_rad)


def start_orientation(
    specific_force_mps2: Floats,
    turns: Floats,
    usable: Mask,
    still: StillStart,
    p: EkfParameters,
) -> Floats:
    """Return the orientation (4,) of the first sample, with arbitrary heading.

    The vertical comes from the still start or else from the first specific force
    that passes the gate; where none does, from the one with the norm nearest to g;
    without any force the sensor is taken to stand upright. The rotation from the
    first sample to there is taken back.

    Args:
        specific_force_mps2: (N, 3).
        turns: (N, 4), contiguous: the rotation during each sample's interval.
        usable: (N,) the accelerometer's gate.
        still: the still start.
        p: for the value of g.
    """
    if still.count:
        first, force = still.first, still.specific_force_mps2
    else:
        off = np.abs(np.linalg.norm(specific_force_mps2, axis=1) - p.gravity_mps2)
        first = int(np.argmax(usable) if usable.any() else np.argmin(off))
        force = specific_force_mps2[first]
    norm = float(np.linalg.norm(force))
    up = force / norm if norm > MIN_SPECIFIC_FORCE_MPS2 else np.array([0.0, 0.0, 1.0])
    q = orientation_from_vertical(up[None])[0]
    if first:
        a, b = turns[1 : first + 1].view(np.complex128).T
        turned = rotations.to_wxyz(rotations.cumulative((a, b)))[-1]
        q = quat.multiply(q, quat.conjugate(turned))
    return quat.normalized(q)


def _windows(values: Floats, count: int) -> tuple[Floats, Floats]:
    """Return mean (M, 3) and norm of the deviation (M,) of sliding windows."""
    offset = values.mean(axis=0)
    centred = values - offset  # cancellation would eat the variance
    sums = np.cumsum(np.vstack([np.zeros(3), centred]), axis=0)
    squares = np.cumsum(np.vstack([np.zeros(3), np.square(centred)]), axis=0)
    mean = (sums[count:] - sums[:-count]) / count
    variance = (squares[count:] - squares[:-count]) / count - np.square(mean)
    return mean + offset, np.sqrt(np.maximum(variance, 0.0).sum(axis=1))
