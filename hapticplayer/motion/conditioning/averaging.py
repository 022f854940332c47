"""Means over windows of equal length, as the paper's board took them.

Source: Danieau et al. 2012, section 3.2: an inertial unit read at 200 Hz and averaged
to 30 Hz.

Time stamps: the window k reaches from start + k / rate to start + (k + 1) / rate,
where start is the beginning of the first sample's interval; its mean carries the time
of its middle and the result is Sampling.AVERAGED. No delay remains.

Frequency response: a boxcar, |sin(pi f / rate) / (pi f / rate)|, zero phase at the
window's middle: -0.9 dB at a quarter of the rate, -3.9 dB at half of it, zeros at its
multiples. It aliases (content at 0.8 of the rate comes out at 0.2 with -12.6 dB);
`decimate` does not.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from hapticplayer.errors import Message
from hapticplayer.model import ImuLog, MotionTrack, Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Mask

MIN_COVERAGE = 0.5
EMPTY = timing.ROUNDING


def average_response(frequency_hz: ArrayLike, rate_hz: float) -> Floats:
    """Return the gain of averaging to `rate_hz` at each frequency; signed, zero phase.

    Exact where a sample is the mean over its own interval, as ImuLog defines it, and
    windows begin and end with samples.
    """
    return np.asarray(np.sinc(np.asarray(frequency_hz, dtype=np.float64) / rate_hz))


@dataclass(frozen=True, slots=True, eq=False)
class Windows:
    """Samples on the time axis, to be averaged over windows.

    Attributes:
        start_s: (N,) where a sample's interval begins.
        end_s: (N,) where it ends; intervals do not overlap.
        opens_s: (M,) where a window begins.
        closes_s: (M,) where it ends.
        valid: (N,) False where a sample must not be used.
    """

    start_s: Floats
    end_s: Floats
    opens_s: Floats
    closes_s: Floats
    valid: Mask

    @property
    def middle_s(self) -> Floats:
        """The time stamps (M,) of the means."""
        return 0.5 * (self.opens_s + self.closes_s)

    def share(self, mask: Mask) -> Floats:
        """Return the share (M,) of each window that the samples in `mask` cover."""
        weights = mask.astype(np.float64)
        return self._integral(weights, mask) / (self.closes_s - self.opens_s)

    def means(self, values: Floats) -> tuple[Floats, Floats]:
        """Return means (M, C) of values (N, C) and the valid share (M,).

        Each sample counts by its overlap with the window, exactly. Invalid samples
        count only where a window has no valid ones; empty windows are zero.
        """
        covered = self.share(self.valid)
        use_invalid = covered < EMPTY
        out = np.empty((len(covered), values.shape[1]))
        window_s = self.closes_s - self.opens_s
        everything = np.ones(len(self.valid), dtype=np.bool_)
        fallback = self.share(everything) if use_invalid.any() else covered
        base = np.where(use_invalid, fallback, covered) * window_s
        base = np.where(base < EMPTY * window_s, np.inf, base)
        for axis, column in enumerate(values.T):
            # around the mean: a running sum over hours keeps its digits
            mean = float(np.mean(column)) if len(column) else 0.0
            total = self._integral(column - mean, self.valid)
            if use_invalid.any():
                any_total = self._integral(column - mean, everything)
                total = np.where(use_invalid, any_total, total)
            out[:, axis] = np.where(np.isinf(base), 0.0, mean + total / base)
        return out, covered

    def _integral(self, column: Floats, mask: Mask) -> Floats:
        """Return the integral (M,) of the held values over each window."""
        area = np.where(mask, column, 0.0) * (self.end_s - self.start_s)
        running = np.concatenate(([0.0], np.cumsum(area)))
        knots_s = np.stack([self.start_s, self.end_s], axis=1).ravel()
        at_knots = np.stack([running[:-1], running[1:]], axis=1).ravel()
        return np.asarray(
            np.interp(self.closes_s, knots_s, at_knots)
            - np.interp(self.opens_s, knots_s, at_knots)
        )


def average(
    imu: ImuLog, rate_hz: float, *, min_coverage: float = MIN_COVERAGE
) -> ImuLog:
    """Return the log averaged to `rate_hz`; response and times as stated above.

    Rates need not divide: a sample that lies in two windows counts in each by its
    overlap. Windows without any sample (gaps) are left out, windows covered by valid
    samples to less than `min_coverage` are kept and marked as not valid.

    Args:
        imu: samples of any kind; INSTANT ones hold over the interval that ends at
            their time.
        rate_hz: windows per second.
        min_coverage: share of a window, 0 to 1.

    Raises:
        InputError: for a rate above the log's, or a log shorter than one window.
    """
    windows = _windows(imu.time_s, imu.valid, imu.sampling, rate_hz, imu.source)
    force, covered = windows.means(imu.specific_force_mps2)
    rate, _ = windows.means(imu.angular_rate_radps)
    field = imu.magnetic_field_ut
    if field is not None:
        field, _ = windows.means(field)
    keep, valid = _judge(windows, covered, min_coverage)
    return dataclasses.replace(
        imu,
        time_s=windows.middle_s[keep],
        specific_force_mps2=force[keep],
        angular_rate_radps=rate[keep],
        magnetic_field_ut=None if field is None else field[keep],
        sampling=Sampling.AVERAGED,
        valid=None if valid.all() else valid,
    )


def average_motion(
    track: MotionTrack,
    rate_hz: float,
    *,
    sampling: Sampling = Sampling.INSTANT,
    min_coverage: float = MIN_COVERAGE,
) -> MotionTrack:
    """Return the track averaged to `rate_hz`; response and times as stated above.

    Acceleration and gravity are window means (so gravity is a little shorter than 1 g
    where the sensor turns), the orientation is that at the window's middle, sigma the
    RMS over the window: errors of gravity are slow and do not average out.

    Args:
        track: gravity-free acceleration.
        rate_hz: windows per second.
        sampling: what a sample of the log was that the track comes from.
        min_coverage: share of a window, as in `average`.

    Raises:
        InputError: as `average`.
    """
    windows = _windows(
        track.time_s, track.valid, sampling, rate_hz, Message("motion track")
    )
    acceleration, covered = windows.means(track.acceleration_mps2)
    gravity, _ = windows.means(track.gravity_mps2)
    sigma = track.gravity_sigma_mps2
    if sigma is not None:
        variance, _ = windows.means(np.square(sigma)[:, None])
        sigma = np.sqrt(np.maximum(variance[:, 0], 0.0))
    keep, valid = _judge(windows, covered, min_coverage)
    time_s = windows.middle_s[keep]
    return MotionTrack(
        time_s=time_s,
        acceleration_mps2=acceleration[keep],
        gravity_mps2=gravity[keep],
        accelerometer_gain=track.accelerometer_gain,
        quaternion_wxyz=quat.interpolate(time_s, track.time_s, track.quaternion_wxyz),
        gravity_sigma_mps2=None if sigma is None else sigma[keep],
        valid=valid,
    )


def _windows(
    time_s: Floats,
    valid: Mask | None,
    sampling: Sampling,
    rate_hz: float,
    where: str,
) -> Windows:
    timing.check_lower_rate(rate_hz, 1.0 / timing.median_step_s(time_s), where)
    start_s, end_s = timing.intervals(time_s, sampling)
    opens_s, closes_s = timing.windows(start_s, end_s, rate_hz)
    usable = np.ones(len(time_s), dtype=np.bool_) if valid is None else valid
    return Windows(start_s, end_s, opens_s, closes_s, usable)


def _judge(windows: Windows, covered: Floats, min_coverage: float) -> tuple[Mask, Mask]:
    """Return which windows to keep (M,) and, of these, which are valid."""
    everything = np.ones(len(windows.valid), dtype=np.bool_)
    keep = windows.share(everything) > EMPTY
    return keep, covered[keep] >= min_coverage - EMPTY
