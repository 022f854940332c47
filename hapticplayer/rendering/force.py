"""Force tracks from motion, and for devices that are weaker than a Falcon.

Source: Danieau et al. 2012, section on the rendering of the haptic effect: the axes of
the actor are aligned with the device by M and scaled by s, F[k] = diag(s) M p[k]; here
with one scale for all axes unless said otherwise, and saturated in magnitude. Above a
soft knee k the magnitude n becomes k + (L - k) tanh((n - k) / (L - k)), L the limit: the
slope is 1 at the knee and the direction stays.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model import (
    Feedback,
    ForceTrack,
    ImuLog,
    Mapping,
    MotionTrack,
    Reconstruction,
    RigTrack,
)
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.rendering.lever_arm import at_point
from hapticplayer.rendering.window_means import dense_motion

FIT_QUANTILE = 0.995
FIT_FORCE_N = 3.5
FIT_GAIN_RANGE_N_PER_MPS2 = (0.2, 1.6)

_ROWS = 1 << 16  # at a time: all rows of an hour at 1 kHz take 0.3 GB more


def render_force(
    motion: MotionTrack, mapping: Mapping | None = None, imu: ImuLog | None = None
) -> ForceTrack:
    """Return the force track (frame D, N) of a motion track (frame A, m/s^2).

    Samples that are not valid give no force. A vector longer than the limit is
    shortened and keeps its direction. Between averaged samples there are further
    entries, see `window_means`.

    Args:
        motion: gravity-free acceleration, in media time.
        mapping: axes, gain and limit; the default mapping if None.
        imu: in media time; a lever arm needs its angular rate.

    Raises:
        InputError: for an empty motion track, or a lever arm without angular rate.
    """
    mapping = mapping or Mapping()
    time_s, acceleration, valid = _rendered_motion(motion, mapping, imu)
    is_dense, moves = len(time_s) > len(motion), mapping.moves_point
    force_n, shortened = np.empty((len(time_s), 3), np.float32), 0
    for start in range(0, len(time_s), _ROWS):
        rows = slice(start, start + _ROWS)
        force, is_shortened = mapped(acceleration[rows], mapping)
        force[~valid[rows]] = 0.0
        force_n[rows] = force
        shortened += int(np.count_nonzero(is_shortened & valid[rows]))
    force_n.setflags(write=False)  # then the track takes it instead of a copy
    return ForceTrack(
        time_s=time_s,
        force_n=force_n,
        reconstruction=Reconstruction.LINEAR,
        provenance={
            "feedback": (
                Feedback.ESTIMATED if motion.is_estimated else Feedback.REALISTIC
            ).value,
            "gain_n_per_mps2": mapping.gains_n_per_mps2.tolist()
            if isinstance(mapping.gain_n_per_mps2, tuple)
            else mapping.gain_n_per_mps2,
            "force_limit_n": mapping.force_limit_n,
            **_described_shortening(mapping, shortened / len(time_s)),
            **({"lever_arm_m": list(mapping.lever_arm_m)} if moves else {}),
            "reconstruction": "integral-spline" if is_dense else "linear",
        },
    )


def mapped(
    acceleration_mps2: Floats, mapping: Mapping
) -> tuple[Floats, NDArray[np.bool_]]:
    """Return the force (N, 3), frame D, of accelerations (N, 3), frame A.

    And (N,) where it was shortened: above the knee, or the limit.
    """
    force = mapping.gains_n_per_mps2 * (acceleration_mps2 @ mapping.axes.T)
    magnitude = np.linalg.norm(force, axis=1)
    over = magnitude > (mapping.soft_knee_n or mapping.force_limit_n)
    limited = _limited(magnitude[over], mapping)
    force[over] *= (limited / magnitude[over])[:, None]
    return force, over


def fit_gain(
    motion: MotionTrack,
    mapping: Mapping,
    duration_s: float,
    imu: ImuLog | None = None,
) -> float:
    """Return the gain at which 99.5 % of the force is at most 3.5 N, from 0.2 to 1.6.

    Magnitudes at the valid entries of the track while the clip plays, before limit and
    knee. A motion without force gets the largest gain.

    Args:
        motion: gravity-free acceleration, in media time.
        mapping: its axes and lever arm; its gain is not used.
        duration_s: of the clip.
        imu: in media time; a lever arm needs its angular rate.
    """
    time_s, acceleration, valid = _rendered_motion(motion, mapping, imu)
    chosen = valid & (time_s >= 0.0) & (time_s <= duration_s)
    if not chosen.any():
        raise InputError("there is no valid motion in the clip to fit a gain to")
    magnitude = np.linalg.norm(acceleration[chosen], axis=1)
    high_mps2 = float(np.quantile(magnitude, FIT_QUANTILE))
    least, largest = FIT_GAIN_RANGE_N_PER_MPS2
    return min(max(FIT_FORCE_N / max(high_mps2, 1e-9), least), largest)


def _rendered_motion(
    motion: MotionTrack, mapping: Mapping, imu: ImuLog | None
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    if not len(motion):
        raise InputError("the motion track is empty, so there is no force to render")
    if mapping.moves_point:
        if imu is None:
            raise InputError("a lever arm needs the angular rate of the recording")
        motion = at_point(motion, imu, mapping.lever_arm_m)
    return dense_motion(motion)


def _limited(magnitude_n: Floats, mapping: Mapping) -> Floats:
    """Return magnitudes above the knee, or above the limit, as they are rendered."""
    limit_n, knee_n = mapping.force_limit_n, mapping.soft_knee_n
    if knee_n is None:
        return np.full_like(magnitude_n, limit_n)
    rest_n = limit_n - knee_n
    return np.asarray(knee_n + rest_n * np.tanh((magnitude_n - knee_n) / rest_n))


def _described_shortening(mapping: Mapping, share: float) -> dict[str, float]:
    if mapping.soft_knee_n is None:
        return {"saturated_share": share}
    return {
        "saturated_share": 0.0,
        "soft_knee_n": mapping.soft_knee_n,
        "compressed_share": share,
    }


def device_gain(capabilities: DeviceCapabilities) -> Floats:
    """Return by what a device's force differs from that of a track, (3,) per axis.

    Tracks are made for 3 axes and 4.5 N. A weaker device gets all of a track scaled by
    one factor that depends on the device alone, so that strong and gentle scenes keep
    their relation and no peak is cut. Forces along axes that it lacks are dropped; the
    driver of a device without direction (a motor that vibrates) takes the magnitude.

    Args:
        capabilities: its `axes` count x, y, z in this order, from `first_axis` on.
    """
    gain = np.full(3, min(1.0, capabilities.peak_force_n / DEFAULT_FORCE_LIMIT_N))
    if capabilities.axes:
        first = capabilities.first_axis
        gain[:first] = gain[first + capabilities.axes :] = 0.0
    return gain


def adapted(
    track: ForceTrack | RigTrack, capabilities: DeviceCapabilities, gain: float = 1.0
) -> ForceTrack | RigTrack:
    """Return a track for this device with a person's gain; the same object for 1."""
    if isinstance(track, RigTrack):
        return replace(track, motion=gain * track.motion) if gain != 1.0 else track
    factors = gain * device_gain(capabilities)
    if np.all(factors == 1.0):
        return track
    provenance = {
        **track.provenance,
        "device_scale": float(factors.max()),
        "device_axes": capabilities.axes,
    }
    force_n = (factors * track.force_n).astype(np.float32)
    return replace(track, force_n=force_n, provenance=provenance)
