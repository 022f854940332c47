"""When each sample of a GoPro sensor was taken, in media time.

Newer cameras timestamp the first sample of each payload (STMP, us). A straight line
through the stamps leaves a residual of 0.01 to 0.3 ms up to a minute; beyond that the
sensor's clock drifts with temperature (3.8 ms in two minutes), so the line is piecewise.
HERO5 to 7 have no stamps: a line through the sample counts against the packets' times is
accurate to 10 to 30 ms. Nominal rates are not used: a "200 Hz" sensor runs at 189 to
203 Hz.

Source: measured; gpmf-parser issues #63, #80, #189, #212.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.gopro_streams import GoproStream
from hapticplayer.errors import TelemetryError
from hapticplayer.model.arrays import Floats

ONE_LINE_S = 60.0
"""Up to this length one line is more accurate than the stamps."""

_RATE_TOLERANCE = 0.25
"""Stamps whose rate differs more from the packets' are ignored."""

_GAP_PACE = 1.2
"""Counts jitter by 5 %: a longer payload has lost samples."""

_MIN_UNSTAMPED_PAYLOADS = 4
"""With three, the rate is up to 4 % off (HERO7), with two 18 %."""

_OUTLIER_S = 0.02
"""Of a stamp from a line through its neighbours; of real ones 0.3 ms."""

_OFFSET_TOLERANCE_S = 2.0
"""Stamps that are farther from the packets' times are ignored."""


class TimeReference(NamedTuple):
    """Reference of the times of all sensors of a camera.

    Attributes:
        frame0_us: the camera's time of media time 0; None without timestamps.
        has_packet_times: whether the payloads' times come from a video container,
            so that the stamps can be checked against them.
        rate: of media time against the camera's.
    """

    frame0_us: float | None
    has_packet_times: bool
    rate: float = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class SampleTimes:
    """Media time of each sample.

    Attributes:
        time_s: (N,) strictly increasing.
        rate_hz: mean rate.
        is_stamped: whether from the camera's stamps, not from the packets' times.
    """

    time_s: Floats
    rate_hz: float
    is_stamped: bool


def sample_times(stream: GoproStream, clock: TimeReference) -> SampleTimes:
    """Return when the samples of a stream were taken.

    Raises:
        TelemetryError: when the times are not increasing.
    """
    stamp_us, frame0_us = stream.stamp_us, clock.frame0_us
    if frame0_us is not None and len(stamp_us) > 1 and np.isfinite(stamp_us).all():
        marks_s = (stamp_us - frame0_us) * 1e-6 * clock.rate
        marks_s = _without_outliers(stream.first_index.astype(np.float64), marks_s)
        if _are_plausible(stream, marks_s, clock.has_packet_times):
            return _from_stamps(stream, marks_s)
    return _from_packets(stream)


def _without_outliers(first: Floats, marks_s: Floats) -> Floats:
    """Stamps (P,) of samples (P,), with a line in place of single ones off their neighbours.

    At the ends only far ones are: samples may have been lost there.
    """
    if len(marks_s) < _MIN_UNSTAMPED_PAYLOADS or np.any(np.diff(first) <= 0.0):
        return marks_s
    pace = np.median(np.diff(marks_s) / np.diff(first))
    off_s = marks_s - pace * first
    around_s = np.stack([np.roll(off_s, 1), np.roll(off_s, -1)])
    around_s[:, 0], around_s[:, -1] = off_s[1:3], off_s[-3:-1]
    limit_s = np.full(len(off_s), _OUTLIER_S)
    limit_s[[0, -1]] = _OFFSET_TOLERANCE_S
    is_out = (np.abs(off_s - around_s) > limit_s).all(axis=0)
    is_out &= np.abs(np.diff(around_s, axis=0)[0]) < _OUTLIER_S
    return np.where(is_out, pace * first + around_s.mean(axis=0), marks_s)


def _are_plausible(
    stream: GoproStream, marks_s: Floats, has_packet_times: bool
) -> bool:
    if np.diff(marks_s).min() <= 0.0:
        return False
    span_s = stream.start_s[-1] - stream.start_s[0]
    pace = (marks_s[-1] - marks_s[0]) / span_s if span_s > 0.0 else 0.0
    off_s = float(np.abs(marks_s - stream.start_s).max())
    is_near = off_s < _OFFSET_TOLERANCE_S or not has_packet_times
    return is_near and abs(pace - 1.0) < _RATE_TOLERANCE


def _from_stamps(stream: GoproStream, marks_s: Floats) -> SampleTimes:
    first = stream.first_index.astype(np.float64)
    slope, offset = np.polyfit(first, marks_s, 1)
    index = stream.index.astype(np.float64)
    pace = np.diff(marks_s) / np.diff(first)
    is_gap = pace > _GAP_PACE * np.median(pace)
    if is_gap.any():
        # samples are missing there that the camera did not count
        steady = float(np.median(pace))
        time_s = np.repeat(marks_s, stream.counts) + steady * (
            index - np.repeat(first, stream.counts)
        )
    elif marks_s[-1] - marks_s[0] <= ONE_LINE_S:
        time_s = slope * index + offset
    else:
        time_s = np.interp(index, first, marks_s)
        # the last payload has no stamp at its end: extrapolate the mean rate
        is_last = index > first[-1]
        time_s[is_last] = marks_s[-1] + slope * (index[is_last] - first[-1])
    return _checked(time_s, slope, is_stamped=True)


def _from_packets(stream: GoproStream) -> SampleTimes:
    """Fit counts to packet times.

    All earlier samples had arrived by a packet's start. The first packet is no measure
    of the rate (sensors start up to 0.2 s early), and the end of the last is nominal (it
    would give 184 Hz instead of 199 for 12 s).
    """
    first = stream.first_index.astype(np.float64)
    if len(first) < _MIN_UNSTAMPED_PAYLOADS:
        raise TelemetryError(
            "its telemetry has no usable timestamps and too few payloads ({count}) to "
            "tell the rate of its sensors",
            remedy="record at least {least} s",
            count=len(first),
            least=_MIN_UNSTAMPED_PAYLOADS,
        )
    slope, offset = np.polyfit(first[1:], stream.start_s[1:], 1)
    return _checked(slope * stream.index + offset, slope, is_stamped=False)


def _checked(time_s: Floats, slope: float, *, is_stamped: bool) -> SampleTimes:
    is_sane = np.isfinite(time_s).all() and 1e-5 < slope < 10.0
    if not is_sane or (len(time_s) > 1 and np.diff(time_s).min() <= 0.0):
        raise TelemetryError("its time stamps run backwards, so it is damaged")
    return SampleTimes(time_s, float(1.0 / slope), is_stamped)
