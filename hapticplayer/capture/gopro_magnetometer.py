"""The magnetic field of the GoPros that have a compass (Fusion, MAX).

MAGN has three components in uT, or four on the MAX: one of another kind before x, y
and z, and not to be trusted before its firmware 2. It is used only where the stream
says which axes it has, because nothing else does (Fusion's do not follow from its
gyro either: no signed permutation explains 15 s of turning better than 1.3 uT).

Source: gopro/gpmf-parser, README (Fusion, MAX); measured.
"""

from collections.abc import Sequence

import numpy as np

from hapticplayer.capture.gopro_axes import frame_a_from_stored, has_own_axes
from hapticplayer.capture.gopro_streams import Payload, collect
from hapticplayer.capture.gopro_timing import sample_times
from hapticplayer.errors import TelemetryError
from hapticplayer.model.arrays import Floats

_REACH_S = 1.0


def magnetic_field(
    payloads: Sequence[Payload],
    time_s: Floats,
    frame0_us: float | None,
    *,
    has_packet_times: bool,
) -> tuple[Floats | None, tuple[str, ...]]:
    """Return the field at the times of the log, and notes.

    A broken compass is no reason to refuse the motion: it is left out, and said.

    Args:
        payloads: of the camera.
        time_s: (N,) of the log.
        frame0_us: the camera's time of the first picture.
        has_packet_times: whether the packets' times were measured.

    Returns:
        (N, 3) uT in frame A, NaN where there was none near; or None.
    """
    try:
        stream = collect(payloads, "MAGN")
        if stream is None or len(stream.values) < 2:
            return None, ()
        components = stream.values.shape[1]
        if components not in {3, 4} or not has_own_axes(stream.first):
            return None, (
                "The compass is left out: the file does not say which axes it has.",
            )
        times = sample_times(stream, frame0_us, has_packet_times=has_packet_times)
        rotation = frame_a_from_stored(stream.first, "")
    except TelemetryError as error:
        return None, (f"The compass is left out: {error.what}.",)
    xyz = stream.values[:, -3:]
    values = np.where(np.isfinite(xyz), xyz, np.nan) @ rotation.T
    columns = [np.interp(time_s, times.time_s, column) for column in values.T]
    field = np.stack(columns, axis=1)
    outside = (time_s < times.time_s[0] - _REACH_S) | (
        time_s > times.time_s[-1] + _REACH_S
    )
    field[outside] = np.nan
    return field, ()
