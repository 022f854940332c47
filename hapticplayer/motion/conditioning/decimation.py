"""Fewer samples without aliasing: a linear-phase FIR filter at the new rate.

Time stamps: those of `average` (the middles of windows of 1 / rate), and the kernel is
centred on them, so there is no delay. The result is Sampling.AVERAGED: a value stands
for the time around its stamp.

Frequency response, f in units of the new rate, whatever the old one: within 0.02 dB up
to 0.4, -6 dB at 0.5, below -59 dB from 0.6 on. What folds back (0.5 to 0.6) lands
between 0.4 and 0.5. The kernel is a Kaiser-windowed sinc that reaches 9.1 new samples
to each side, so a step rings for as long, by up to 9 % of its height.
"""

import dataclasses

import numpy as np
from numpy.typing import ArrayLike

from hapticplayer.model import ImuLog, MotionTrack, Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Mask

PASS_EDGE = 0.4
STOP_EDGE = 0.6
STOP_DB = 60.0
# Kaiser's formulas (Oppenheim and Schafer, section 7.6): shape and length
KAISER_BETA = 0.1102 * (STOP_DB - 8.7)
HALF_WIDTH = 0.5 * (STOP_DB - 7.95) / (2.285 * 2.0 * np.pi * (STOP_EDGE - PASS_EDGE))
TABLE_STEPS = 1024
BLOCK_WEIGHTS = 1 << 18
MAX_BRIDGE = 0.5
"""Invalid spans up to this many new samples are bridged by a line."""


def decimation_response(frequency_hz: ArrayLike, rate_hz: float) -> Floats:
    """Return the gain of decimating to `rate_hz` at each frequency; zero phase.

    That of the continuous kernel: at the old samples it is the same to -60 dB.
    """
    f = np.atleast_1d(np.asarray(frequency_hz, dtype=np.float64)) / rate_hz
    x = np.linspace(-HALF_WIDTH, HALF_WIDTH, 2 * round(HALF_WIDTH * TABLE_STEPS) + 1)
    weights = _kernel(x)
    weights /= weights.sum()
    return np.array([float(np.cos(2.0 * np.pi * one * x) @ weights) for one in f])


def decimate_even(
    values: Floats, rate_hz: float, new_rate_hz: float, position: Floats
) -> Floats:
    """Return low-passed values (M, C) at any positions between even samples.

    Beyond its ends the signal is continued by odd reflection (a straight line stays
    one). A constant comes out as itself.

    Args:
        values: (N, C), evenly spaced.
        rate_hz: their rate.
        new_rate_hz: rate that sets the response, at most `rate_hz`.
        position: (M,) in samples from the first one, fractions allowed.

    Raises:
        InputError: for a new rate above the old one.
    """
    timing.check_lower_rate(new_rate_hz, rate_hz, "")
    ratio = new_rate_hz / rate_hz
    # half a sample more than the kernel reaches: positions lie between samples
    reach = int(np.ceil(HALF_WIDTH / ratio + 0.5))
    padded = timing.continued(values, reach)
    out = np.empty((len(position), values.shape[1]))
    taps = np.arange(-reach, reach + 1)
    block = max(1, BLOCK_WEIGHTS // len(taps))
    for begin in range(0, len(position), block):
        part = position[begin : begin + block]
        nearest = np.clip(np.rint(part), 0, len(values) - 1).astype(np.int64)
        offset = taps - (part - nearest)[:, None]
        weights = _tabulated_kernel(offset * ratio)
        weights /= weights.sum(axis=1, keepdims=True)
        rows = padded[nearest[:, None] + (taps + reach)]
        out[begin : begin + block] = np.einsum("mk,mkc->mc", weights, rows)
    return out


def decimate(imu: ImuLog, rate_hz: float) -> ImuLog:
    """Return the log at `rate_hz`, anti-aliased; response and times as stated above.

    Uneven time stamps are resampled by themselves first. Gaps are left out and what is
    not valid is filtered by itself and stays marked; only spans shorter than half a
    new sample are bridged.

    Raises:
        InputError: for a rate above the log's, or a log shorter than one new sample.
    """
    columns = [imu.specific_force_mps2, imu.angular_rate_radps]
    if imu.magnetic_field_ut is not None:
        columns.append(imu.magnetic_field_ut)
    time_s, values, valid = _decimated(
        imu.time_s, np.hstack(columns), imu.valid, imu.sampling, rate_hz
    )
    return dataclasses.replace(
        imu,
        time_s=time_s,
        specific_force_mps2=values[:, :3],
        angular_rate_radps=values[:, 3:6],
        magnetic_field_ut=values[:, 6:] if len(columns) > 2 else None,
        sampling=Sampling.AVERAGED,
        valid=None if valid.all() else valid,
    )


def decimate_motion(
    track: MotionTrack, rate_hz: float, *, sampling: Sampling = Sampling.INSTANT
) -> MotionTrack:
    """Return the track at `rate_hz`, anti-aliased; gaps and times as `decimate`.

    Acceleration and gravity are filtered; orientation and sigma are read at the new
    times.

    Args:
        track: gravity-free acceleration.
        rate_hz: samples per second.
        sampling: what a sample of the log was that the track comes from.

    Raises:
        InputError: as `decimate`.
    """
    columns = np.hstack([track.acceleration_mps2, track.gravity_mps2])
    time_s, values, valid = _decimated(
        track.time_s, columns, track.valid, sampling, rate_hz
    )
    sigma = track.gravity_sigma_mps2
    return MotionTrack(
        time_s=time_s,
        acceleration_mps2=values[:, :3],
        gravity_mps2=values[:, 3:],
        accelerometer_gain=track.accelerometer_gain,
        quaternion_wxyz=quat.interpolate(time_s, track.time_s, track.quaternion_wxyz),
        gravity_sigma_mps2=None
        if sigma is None
        else np.interp(time_s, track.time_s, sigma),
        valid=valid,
    )


def _decimated(
    time_s: Floats,
    values: Floats,
    valid: Mask | None,
    sampling: Sampling,
    rate_hz: float,
) -> tuple[Floats, Floats, Mask]:
    """Return new times (M,), values (M, C) and validity (M,)."""
    step_s = timing.median_step_s(time_s)
    timing.check_lower_rate(rate_hz, 1.0 / step_s, "")
    start_s, end_s = timing.intervals(time_s, sampling)
    opens_s, closes_s = timing.windows(start_s, end_s, rate_hz)
    new_s = 0.5 * (opens_s + closes_s)
    is_instant = sampling is Sampling.INSTANT
    centre_s = 0.5 * (start_s + end_s) if is_instant else time_s
    usable = np.ones(len(time_s), dtype=np.bool_) if valid is None else valid
    values, usable = timing.bridge(time_s, values, usable, MAX_BRIDGE / rate_hz)
    out = np.full((len(new_s), values.shape[1]), np.nan)
    new_valid = np.zeros(len(new_s), dtype=np.bool_)
    for part in timing.stretches(time_s, usable, step_s):
        here = slice(*np.searchsorted(new_s, (start_s[part][0], end_s[part][-1])))
        if here.start < here.stop:
            even_s, even = timing.even(centre_s[part], values[part], step_s)
            out[here] = _at(new_s[here], even_s, even, rate_hz, step_s)
            new_valid[here] = usable[part][0]
    keep = np.isfinite(out[:, 0])  # the rest fell into gaps
    return new_s[keep], out[keep], new_valid[keep]


def _at(
    new_s: Floats, even_s: Floats, values: Floats, rate_hz: float, step_s: float
) -> Floats:
    """Return the decimated signal of one even stretch at its new times."""
    if len(even_s) > 1:
        step_s = float(even_s[-1] - even_s[0]) / (len(even_s) - 1)
    position = (new_s - even_s[0]) / step_s
    return decimate_even(values, 1.0 / step_s, min(rate_hz, 1.0 / step_s), position)


def _kernel(x: Floats) -> Floats:
    """Return the kernel at distances x in new samples."""
    inside = np.sqrt(np.maximum(1.0 - np.square(x / HALF_WIDTH), 0.0))
    window = np.i0(KAISER_BETA * inside) / np.i0(KAISER_BETA)
    return np.asarray(np.where(np.abs(x) <= HALF_WIDTH, np.sinc(x) * window, 0.0))


_TABLE_X = np.linspace(0.0, HALF_WIDTH, round(HALF_WIDTH * TABLE_STEPS) + 1)
_TABLE = _kernel(_TABLE_X)


def _tabulated_kernel(x: Floats) -> Floats:
    """Return the kernel by lines between table entries: exact to 1e-6, and fast."""
    return np.interp(np.abs(x), _TABLE_X, _TABLE, right=0.0)
