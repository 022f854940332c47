"""The clock of a GoPro's gyro against its frames, by the camera's own orientation.

From the HERO8 on, CORI holds the orientation of the camera at each frame. Its changes
are those of the gyro, so both tell the gyro's lag without any look at the frames,
which the camera may have stabilised. On a MAX, CORI followed by IORI (the orientation
of the image in the camera) is what the stabilised frames show, at the same frame.

Source: gpmf-parser README (CORI, IORI); order and signs of the components measured on
HERO8, HERO9 and MAX, where the gyro explains 96 to 99.96 % of the changes.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.capture.frames import FrameRotation, frame_function, has_frames
from hapticplayer.capture.gopro_streams import GoproStream, GpmfPayload, collect
from hapticplayer.capture.gopro_timing import TimeReference
from hapticplayer.errors import TelemetryError
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats

_EVEN = 0.002  # frames are even; where stamps are not, samples were repeated or lost


def clock_by_cori(
    payloads: Sequence[GpmfPayload], imu: ImuLog, clock: TimeReference
) -> tuple[ClockMap, ClockLag] | None:
    """Return the gyro's clock against the frames; None where CORI does not tell it.

    Args:
        payloads: of the recording.
        imu: its motion, in frame A.
        clock: the camera's.
    """
    rotation = camera_rotation(payloads, clock)
    if rotation is None:
        return None
    if not has_frames():  # they compare rotations
        return None
    found: tuple[ClockMap, ClockLag] | None = frame_function("own-clock")(imu, rotation)
    return found


def camera_rotation(
    payloads: Sequence[GpmfPayload], clock: TimeReference
) -> FrameRotation | None:
    """Return the camera's rotation from frame to frame by CORI, in frame A."""
    if clock.frame0_us is None:
        return None
    try:
        stream = collect(payloads, "CORI")
    except TelemetryError:
        return None
    if stream is None or not _is_usable(stream):
        return None
    time_s, is_even = _times(
        stream, 1e-6 * clock.rate * (stream.stamp_us - clock.frame0_us)
    )
    w, a, b, c = stream.values.T
    # stored as w, x, z, y of the rotation from the earth to the camera
    orientation = quat.normalized(np.stack([w, -a, -c, b], axis=1))
    changes = quat.multiply(quat.conjugate(orientation[:-1]), orientation[1:])
    nothing = np.zeros((len(changes), 3))
    return FrameRotation(
        begin_s=time_s[:-1],
        end_s=time_s[1:],
        rotation_rad=quat.to_rotation_vector(changes),
        quality=(is_even[:-1] & is_even[1:]).astype(float),
        row=nothing,
        skew_rad=nothing,
    )


def _is_usable(stream: GoproStream) -> bool:
    stamps_us = stream.stamp_us
    return bool(
        stream.values.shape[1] == 4
        and np.isfinite(stream.values).all()
        and np.linalg.norm(stream.values, axis=1).min() > 0.5
        and len(stamps_us) > 1
        and np.isfinite(stamps_us).all()
        and np.diff(stamps_us).min() > 0.0
    )


def _times(stream: GoproStream, marks_s: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Return the time of each sample, and whether its payload is evenly stamped.

    A HERO8 and a HERO9 write one sample too many somewhere, and its stamps show it.
    """
    steps_s = np.diff(marks_s) / stream.counts[:-1]
    usual_s = float(np.median(steps_s))
    steps_s = np.append(steps_s, usual_s)
    within = np.arange(len(stream.values)) - np.repeat(
        np.cumsum(stream.counts) - stream.counts, stream.counts
    )
    time_s = np.repeat(marks_s, stream.counts) + within * np.repeat(
        steps_s, stream.counts
    )
    is_even = np.abs(steps_s / usual_s - 1.0) < _EVEN
    return time_s, np.repeat(is_even, stream.counts)
