"""A force track for a device that is weaker, or has fewer axes, than a Falcon.

Tracks are made for 3 axes and 4.5 N. A weaker device gets all of a track smaller by
one factor that only depends on the device, so that strong and gentle scenes keep their
relation, in place of cut peaks. Of the axes it has not, a device feels nothing; one
without any direction (a motor that shakes) is told the magnitude.
"""

from dataclasses import replace

import numpy as np

from hapticplayer.model import ForceTrack
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.rendering.demonstration import USUAL_CAP_N


def adapted(track: ForceTrack, capabilities: DeviceCapabilities) -> ForceTrack:
    """Return a track for this device; the same object where nothing has to change.

    Args:
        track: in frame D, N.
        capabilities: of the device; `axes` counts x, y, z in this order.
    """
    scale = min(1.0, capabilities.peak_force_n / USUAL_CAP_N)
    axes = capabilities.axes
    if scale == 1.0 and axes in (0, 3):
        return track  # without axes the driver takes the magnitude
    force_n = scale * track.force_n.astype(np.float64)
    if axes:
        force_n[:, axes:] = 0.0
    provenance = {**track.provenance, "device_scale": scale, "device_axes": axes}
    return replace(track, force_n=force_n.astype(np.float32), provenance=provenance)
