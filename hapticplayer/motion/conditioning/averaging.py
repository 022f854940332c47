"""Means over windows of equal length, as the paper's board took them.

Source: Danieau et al. 2012, section 3.2: an inertial unit read at 200 Hz and averaged
to 30 Hz.

Time stamps: the window k reaches from start + k / rate to start + (k + 1) / rate,
where start is the beginning of the first sample's interval; its mean carries the time
of its middle and the result is Sampling.AVERAGED. No delay remains.

Frequency response: a boxcar, sin(pi f / rate) / (pi f / rate), zero phase at the
window's middle: -0.9 dB at a quarter of the rate, -3.9 dB at half of it, zeros at its
multiples. It aliases: content at 0.8 of the rate comes out at 0.2 with -12.6 dB.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Mask

# Windows covered by valid samples to a smaller share are not valid.
MIN_COVERAGE = 0.5
# Share of a window that rounding of the time stamps may cost.
ROUNDING = 1e-6
RATE_TOLERANCE = 1e-3


def average(imu: ImuLog, rate_hz: float) -> ImuLog:
    """Return the log averaged to `rate_hz`; response and times as stated above.

    Rates need not divide: a sample that lies in two windows counts in each by its
    overlap. Windows without any sample (gaps) are left out; windows that valid samples
    cover to less than a half are kept and marked as not valid.

    Args:
        imu: samples of any kind; INSTANT ones hold over the interval that ends at
            their time.
        rate_hz: windows per second.
    """
    rate_now_hz = 1.0 / timing.median_step_s(imu.time_s)
    _check_rate(rate_hz, rate_now_hz, imu.source)
    start_s, end_s = _intervals(imu.time_s, imu.sampling)
    usable = np.ones(len(imu), dtype=np.bool_) if imu.valid is None else imu.valid
    windows = _AveragingWindows(
        start_s, end_s, *_windows(start_s, end_s, rate_hz), usable
    )
    force, covered = windows.means(imu.specific_force_mps2)
    rate, _ = windows.means(imu.angular_rate_radps)
    field = imu.magnetic_field_ut
    if field is not None:
        field, _ = windows.means(field)
    keep = windows.share(np.ones(len(imu), dtype=np.bool_)) > ROUNDING
    valid = covered[keep] >= MIN_COVERAGE - ROUNDING
    return dataclasses.replace(
        imu,
        time_s=0.5 * (windows.opens_s + windows.closes_s)[keep],
        specific_force_mps2=force[keep],
        angular_rate_radps=rate[keep],
        magnetic_field_ut=None if field is None else field[keep],
        sampling=Sampling.AVERAGED,
        valid=None if valid.all() else valid,
    )


@dataclass(frozen=True, slots=True, eq=False)
class _AveragingWindows:
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
        use_invalid = covered < ROUNDING
        out = np.empty((len(covered), values.shape[1]))
        window_s = self.closes_s - self.opens_s
        everything = np.ones(len(self.valid), dtype=np.bool_)
        fallback = self.share(everything) if use_invalid.any() else covered
        base = np.where(use_invalid, fallback, covered) * window_s
        base = np.where(base < ROUNDING * window_s, np.inf, base)
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


def _intervals(time_s: Floats, sampling: Sampling) -> tuple[Floats, Floats]:
    """Return start and end, (N,) each in s, of the time each sample stands for.

    INSTANT: from the sample before to its own time. AVERAGED: between the midpoints
    to its neighbours. At a gap and at the ends of the recording a sample covers one
    median step, so that the intervals never overlap and a gap stays uncovered.
    """
    step_s = timing.median_step_s(time_s)
    gap = timing.gaps(time_s, step_s)
    # shared edges are the same float on both sides: no sliver between the samples
    if sampling is Sampling.INSTANT:
        start_s = np.where(gap, time_s[1:] - step_s, time_s[:-1])
        return np.concatenate(([time_s[0] - step_s], start_s)), time_s
    middle_s = 0.5 * (time_s[1:] + time_s[:-1])
    half_s = 0.5 * step_s
    start_s = np.where(gap, time_s[1:] - half_s, middle_s)
    end_s = np.where(gap, time_s[:-1] + half_s, middle_s)
    return (
        np.concatenate(([time_s[0] - half_s], start_s)),
        np.concatenate((end_s, [time_s[-1] + half_s])),
    )


def _windows(start_s: Floats, end_s: Floats, rate_hz: float) -> tuple[Floats, Floats]:
    """Return opening and closing times (M,) of the windows that hold samples.

    Window k reaches from start_s[0] + k / rate to start_s[0] + (k + 1) / rate; only
    full ones before the last sample's end count. What lies in a gap is left out, so
    that hours of silence don't become millions of windows.

    Args:
        start_s: (N,) where each sample's interval begins, in order.
        end_s: (N,) where it ends.
        rate_hz: windows per second.
    """
    origin_s, total_s = float(start_s[0]), float(end_s[-1] - start_s[0])
    # a few ulps of the time stamps must not cost the last window
    count = int(np.floor(total_s * rate_hz + ROUNDING))
    if count < 1:
        raise InputError(
            "{total_s:.4g} s of samples are less than one window of {window_s:.4g} s",
            remedy="give a higher rate or a longer recording",
            total_s=total_s,
            window_s=1.0 / rate_hz,
        )
    closed = np.flatnonzero(start_s[1:] > end_s[:-1])  # before a gap
    begins = start_s[np.concatenate(([0], closed + 1))] - origin_s
    ends = end_s[np.concatenate((closed, [len(end_s) - 1]))] - origin_s
    first = np.floor(begins * rate_hz + ROUNDING).astype(np.int64)
    stop = np.ceil(ends * rate_hz - ROUNDING).astype(np.int64)
    lengths = np.maximum(stop - first, 0)
    offsets = np.repeat(first - np.cumsum(lengths) + lengths, lengths)
    number = np.unique(offsets + np.arange(len(offsets)))
    number = number[number < count]
    return origin_s + number / rate_hz, origin_s + (number + 1) / rate_hz


def _check_rate(rate_hz: float, input_rate_hz: float, where: str) -> None:
    """Raise InputError unless 0 < rate_hz <= input_rate_hz."""
    timing.positive(
        rate_hz, Message("the rate"), Message("give a rate in Hz, such as 30")
    )
    if rate_hz > input_rate_hz * (1.0 + RATE_TOLERANCE):
        raise InputError(
            "{rate_hz:g} Hz is above the rate of the samples, {input_rate_hz:.4g} Hz",
            where=where,
            remedy="give a lower rate; samples can be merged, not made up",
            rate_hz=rate_hz,
            input_rate_hz=input_rate_hz,
        )
