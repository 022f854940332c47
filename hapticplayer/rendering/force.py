"""F[k] = diag(s) M p[k], saturated in magnitude.

Source: Danieau et al. 2012, section on the rendering of the haptic effect: the
axes of the actor are aligned with the device by M and scaled by s.
"""

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model import (
    ClockMap,
    ForceTrack,
    Mapping,
    MotionTrack,
    Reconstruction,
)


def render_force(
    motion: MotionTrack,
    mapping: Mapping | None = None,
    *,
    clock: ClockMap | None = None,
) -> ForceTrack:
    """Return the force track (frame D, N) of a motion track (frame A, m/s^2).

    Samples that are not valid give no force. A vector longer than the limit is
    shortened and keeps its direction.

    Args:
        motion: gravity-free acceleration.
        mapping: axes, gain and limit; the house default if None.
        clock: IMU time to media time; identity if None.

    Raises:
        InputError: for an empty motion track.
    """
    mapping = mapping or Mapping()
    clock = clock or ClockMap()
    if not len(motion):
        raise InputError("the motion track is empty, so there is no force to render")
    force = mapping.gain_n_per_mps2 * motion.acceleration_mps2 @ mapping.axes.T
    force = np.where(motion.valid[:, None], force, 0.0)
    magnitude = np.linalg.norm(force, axis=1)
    over = magnitude > mapping.force_limit_n
    force[over] *= (mapping.force_limit_n / magnitude[over])[:, None]
    return ForceTrack(
        time_s=clock.rate * motion.time_s + clock.offset_s,
        force_n=force.astype(np.float32),
        reconstruction=Reconstruction.LINEAR,
        provenance={
            "feedback": "realistic",
            "gain_n_per_mps2": mapping.gain_n_per_mps2,
            "force_limit_n": mapping.force_limit_n,
            "saturated_share": float(np.mean(over)),
        },
    )
