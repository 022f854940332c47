"""Force tracks from motion, and for devices that are weaker than a Falcon.

Source: Danieau et al. 2012, section on the rendering of the haptic effect: the axes of
the actor are aligned with the device by M and scaled by s, F[k] = diag(s) M p[k]; here
with one scale for all axes, and saturated in magnitude.
"""

from dataclasses import replace

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Mapping, MotionTrack, Reconstruction
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.rendering.window_means import dense_motion

_ROWS = 1 << 16  # at a time: all rows of an hour at 1 kHz take 0.3 GB more


def render_force(motion: MotionTrack, mapping: Mapping | None = None) -> ForceTrack:
    """Return the force track (frame D, N) of a motion track (frame A, m/s^2).

    Samples that are not valid give no force. A vector longer than the limit is
    shortened and keeps its direction. Between averaged samples there are further
    entries, see `window_means`.

    Args:
        motion: gravity-free acceleration, in media time.
        mapping: axes, gain and limit; the default mapping if None.

    Raises:
        InputError: for an empty motion track.
    """
    mapping = mapping or Mapping()
    if not len(motion):
        raise InputError("the motion track is empty, so there is no force to render")
    time_s, acceleration, valid = dense_motion(motion)
    is_dense = len(time_s) > len(motion)
    force_n, saturated = np.empty((len(time_s), 3), np.float32), 0
    for start in range(0, len(time_s), _ROWS):
        rows = slice(start, start + _ROWS)
        force = mapping.gain_n_per_mps2 * acceleration[rows] @ mapping.axes.T
        force[~valid[rows]] = 0.0
        magnitude = np.linalg.norm(force, axis=1)
        over = magnitude > mapping.force_limit_n
        force[over] *= (mapping.force_limit_n / magnitude[over])[:, None]
        force_n[rows] = force
        saturated += int(np.count_nonzero(over))
    force_n.setflags(write=False)  # then the track takes it instead of a copy
    return ForceTrack(
        time_s=time_s,
        force_n=force_n,
        reconstruction=Reconstruction.LINEAR,
        provenance={
            "feedback": "realistic",
            "gain_n_per_mps2": mapping.gain_n_per_mps2,
            "force_limit_n": mapping.force_limit_n,
            "saturated_share": saturated / len(time_s),
            "reconstruction": "integral-spline" if is_dense else "linear",
        },
    )


def adapted(track: ForceTrack, capabilities: DeviceCapabilities) -> ForceTrack:
    """Return a track for this device; the same object where nothing has to change.

    Tracks are made for 3 axes and 4.5 N. A weaker device gets all of a track scaled by
    one factor that depends on the device alone, so that strong and gentle scenes keep
    their relation and no peak is cut. Forces along axes that it lacks are dropped; the
    driver of a device without direction (a motor that vibrates) takes the magnitude.

    Args:
        track: in frame D, N.
        capabilities: of the device; `axes` counts x, y, z in this order.
    """
    scale = min(1.0, capabilities.peak_force_n / DEFAULT_FORCE_LIMIT_N)
    axes = capabilities.axes
    if scale == 1.0 and axes in (0, 3):
        return track
    force_n = scale * track.force_n.astype(np.float64)
    if axes:
        force_n[:, axes:] = 0.0
    provenance = {**track.provenance, "device_scale": scale, "device_axes": axes}
    return replace(track, force_n=force_n.astype(np.float32), provenance=provenance)
