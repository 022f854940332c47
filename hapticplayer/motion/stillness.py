"""Still spans of a recording, and what the sensors read there.

Accelerometers of action cameras are uncalibrated: norms at rest between 9.8 and
10.8 m/s^2 were measured. A scale error of 1 % leaves 0.1 m/s^2 of gravity in
every sample, so still spans set the gain before anything else. What the gyro reads
there is its bias.
"""

import functools
import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot

WINDOW_S = 1.0
# A tripod or a table stays below these, hands and rolling wheels do not
# (ADXL345: noise 0.1 m/s^2 per sample and axis; held cameras: above 0.03 rad/s).
STILL_ACCEL_STD_LIMIT_MPS2 = 0.2
STILL_RATE_STD_LIMIT_RADPS = 0.02
STILL_RATE_LIMIT_RADPS = 0.2  # allows a gyro bias of 11 deg/s
# Beyond this the norm is no scale error but a wrong unit or constant motion.
PLAUSIBLE_GAIN_RANGE = (0.85, 1.15)
_BINS_PER_WINDOW = 4  # to a window
# Within less a slow, even turn is too easily taken for a bias.
MIN_BIAS_SPAN_S = 3.0
# Random walk of a gyro's bias: 0.14 deg/s in ten minutes, as it warms up.
BIAS_WALK_RADPS_PER_SQRT_S = 1e-4


@dataclass(frozen=True, slots=True)
class AccelerometerGain:
    """Scale of the accelerometer and how it is known.

    Attributes:
        gain: multiply the specific force with it.
        still_s: total time of the still spans it comes from; 0 when assumed.
        reason: for the provenance, in words.
    """

    gain: float
    still_s: float
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class StillSpans:
    """Where a log of N samples is still, in B bins of a quarter of a second.

    Attributes:
        per_bin: samples of a bin; the remainder at the end belongs to none.
        bins: (B,) True for bins inside a still window of 1 s.
        force_mps2: (3, B) mean of each bin; 0 where the whole log is in motion.
        rate_radps: (3, B) the same.
        bin_s: length of a bin.
    """

    per_bin: int
    bins: NDArray[np.bool_]
    force_mps2: Floats
    rate_radps: Floats
    bin_s: float

    @property
    def still_s(self) -> float:
        return float(np.count_nonzero(self.bins)) * self.bin_s

    def confirmed(self, at_rest: NDArray[np.bool_]) -> "StillSpans":
        """Return the spans without the bins that are not all at rest, (N,)."""
        used = at_rest[: len(self.bins) * self.per_bin]
        kept = self.bins & used.reshape(-1, self.per_bin).all(axis=1)
        return replace(self, bins=kept)

    def mask(self, count: int) -> NDArray[np.bool_]:
        """Return True for the samples of still bins, (count,)."""
        mask = np.zeros(count, dtype=np.bool_)
        mask[: len(self.bins) * self.per_bin] = np.repeat(self.bins, self.per_bin)
        return mask


def find_still(imu: ImuLog, interval_s: float | None = None) -> StillSpans:
    """Return the spans of at least 1 s without motion.

    Args:
        imu: the log.
        interval_s: its median step, when it is known already.
    """
    if interval_s is None:
        interval_s = 1.0 / imu.rate_hz if len(imu) > 1 else WINDOW_S
    per_bin = max(1, round(WINDOW_S / (_BINS_PER_WINDOW * interval_s)))
    count = len(imu) // per_bin
    bin_s = per_bin * interval_s
    nothing = np.zeros((3, count))
    none = StillSpans(per_bin, np.zeros(count, np.bool_), nothing, nothing, bin_s)
    if count < _BINS_PER_WINDOW:
        return none
    used = count * per_bin
    rate = _spread(imu.angular_rate_radps[:used], count)
    calm = rate[1] < _BINS_PER_WINDOW * STILL_RATE_STD_LIMIT_RADPS**2
    if not may_be_still(calm):
        return none
    accel = _spread(imu.specific_force_mps2[:used], count)
    if not may_be_still(
        calm & (accel[1] < _BINS_PER_WINDOW * STILL_ACCEL_STD_LIMIT_MPS2**2)
    ):
        return none
    both = zip(rate, accel, strict=True)
    norm, deviation = _windows(*(np.stack(pair) for pair in both))
    ends_s = imu.time_s[per_bin - 1 : used : per_bin]
    span_s = (
        ends_s[_BINS_PER_WINDOW - 1 :]
        - imu.time_s[:used:per_bin][: count - _BINS_PER_WINDOW + 1]
    )
    starts = np.flatnonzero(
        (deviation[1] < STILL_ACCEL_STD_LIMIT_MPS2)
        & (deviation[0] < STILL_RATE_STD_LIMIT_RADPS)
        & (norm[0] < STILL_RATE_LIMIT_RADPS)
        & (norm[1] > 0.5 * STANDARD_GRAVITY_MPS2)
        & (span_s < 1.5 * WINDOW_S)  # a gap inside is no evidence of rest
    )
    edges = np.bincount(starts, minlength=count + 1)
    edges -= np.bincount(starts + _BINS_PER_WINDOW, minlength=count + 1)
    still = np.cumsum(edges[:-1]) > 0
    if imu.valid is not None:
        still &= imu.valid[:used].reshape(count, per_bin).all(axis=1)
    return StillSpans(per_bin, still, accel[0], rate[0], bin_s)


def mean_rate(still: StillSpans, chosen: NDArray[np.bool_]) -> tuple[Floats, float]:
    """Return the mean rate (3,) over some bins, (B,), and its sigma by their scatter."""
    rate = still.rate_radps[:, chosen]
    mean = rate.mean(axis=1)
    scatter = math.sqrt(float(np.square(rate - mean[:, None]).mean()))
    # a hand-held sensor does not turn the same way for longer than a second
    return mean, scatter / math.sqrt(len(rate.T) * still.bin_s)


def nearest_still_bias(
    still: StillSpans, edges_s: Floats, start_s: float, end_s: float
) -> tuple[Floats, float] | None:
    """Return the gyro's bias (3,) in the still span nearest to a part, and its sigma.

    Args:
        still: of the whole log.
        edges_s: (B + 1,) times of the bins' edges.
        start_s: of the part.
        end_s: of the part.

    Returns:
        None where no span of 3 s is still.
    """
    change = np.diff(still.bins.astype(np.int8), prepend=0, append=0)
    first, last = np.flatnonzero(change > 0), np.flatnonzero(change < 0)
    is_long = (last - first) * still.bin_s > MIN_BIAS_SPAN_S - 0.5 * still.bin_s
    first, last = first[is_long], last[is_long]
    if not len(first):
        return None
    away_s = np.maximum(start_s - edges_s[last], edges_s[first] - end_s)
    nearest = int(np.argmin(away_s))
    chosen = np.zeros(len(still.bins), np.bool_)
    chosen[first[nearest] : last[nearest]] = True
    mean, sigma = mean_rate(still, chosen)
    walk = BIAS_WALK_RADPS_PER_SQRT_S * math.sqrt(max(float(away_s[nearest]), 0.0))
    return mean, math.hypot(sigma, walk)


def estimate_accelerometer_gain(
    imu: ImuLog, still: StillSpans | None = None
) -> AccelerometerGain:
    """Return the gain that makes the norm of the specific force 1 g at rest.

    Args:
        imu: the log; needs no particular rate.
        still: from `find_still`, when it is known already.

    Returns:
        gain = |g| / median norm over the still spans, or 1 where there is none or
        where the result would be outside 0.85 to 1.15.
    """
    still = find_still(imu) if still is None else still
    if not still.bins.any() or still.still_s < WINDOW_S - still.bin_s:
        return AccelerometerGain(1.0, 0.0, "assumed: the recording has no still span")
    force = still.force_mps2[:, still.bins]
    gain = STANDARD_GRAVITY_MPS2 / float(np.median(np.sqrt(rot.squared_norm(force))))
    if not PLAUSIBLE_GAIN_RANGE[0] <= gain <= PLAUSIBLE_GAIN_RANGE[1]:
        reason = f"assumed: still spans would give {gain:.3f}, which is not plausible"
        return AccelerometerGain(1.0, 0.0, reason)
    return AccelerometerGain(
        gain, still.still_s, f"from {still.still_s:.1f} s of still spans"
    )


def _windows(means: Floats, inside: Floats) -> tuple[Floats, Floats]:
    """Return norm of the mean and deviation of 4 neighbours among bins, (2, B - 3).

    Args:
        means: (2, 3, B) of both sensors.
        inside: (2, B) variance inside the bins.
    """
    overall = means.mean(axis=2, keepdims=True)
    centred = means - overall  # or the variance cancels
    both = np.concatenate([centred, np.square(centred), inside[:, None]], axis=1)
    running = _running_mean(both)
    mean, squared, within = running[:, :3], running[:, 3:6], running[:, 6]
    between = np.abs(squared - np.square(mean)).sum(axis=1)
    mean = mean + overall
    return np.sqrt(np.square(mean).sum(axis=1)), np.sqrt(within + between)


def _spread(values: Floats, count: int) -> tuple[Floats, Floats]:
    """Return means (3, count) and variances (count,), over all axes, of the bins."""
    rows = values.reshape(count, -1)
    per_bin = rows.shape[1] // 3
    # as a product, because numpy is slow along axes of three
    means = rows @ _averaging(per_bin)
    variances = np.vecdot(rows, rows)
    variances /= per_bin
    variances -= np.vecdot(means, means)
    return means.T, np.maximum(variances, 0.0, out=variances)


@functools.cache
def _averaging(count: int) -> Floats:
    """Return the matrix (3 count, 3) that takes so many vectors to their mean."""
    return np.tile(np.eye(3) / count, (count, 1))


def may_be_still(calm: NDArray[np.bool_]) -> bool:
    """Whether any window has only bins that are calm enough for it to be still.

    What varies inside the bins is part of what varies in the window, so most of a
    recording in motion needs no closer look.
    """
    return bool((calm[:-3] & calm[1:-2] & calm[2:-1] & calm[3:]).any())


def _running_mean(values: Floats) -> Floats:
    """Return the means of 4 neighbours along the last axis."""
    total = np.zeros((*values.shape[:-1], values.shape[-1] + 1))
    np.cumsum(values, axis=-1, out=total[..., 1:])
    return (
        np.asarray(total[..., _BINS_PER_WINDOW:] - total[..., :-_BINS_PER_WINDOW])
        / _BINS_PER_WINDOW
    )
