"""A plain estimate of the vertical with a short memory, and when it is preferred.

The mean of the specific force in the almost inertial frame I over a few seconds, before
and after each node alike. A constant error of the gyro cancels in it to first order, and
nothing is calibrated, so that it is never far off: a floor under the smoother. Its own
error is the acceleration that lasts as long. How large that is shows where twice the
memory gives another vertical.
"""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.nodes import MIN_IMPULSE_MPS, Nodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.problem import mean_square

# Deviation of the Gaussian that the specific force is weighted with; that of
# offlineVQF's filter is about twice as long.
SHORT_MEMORY_S = 1.5
# An interval without rotation for this share is a gap (a gyro on its rail is better than
# none), and what a memory may hold of gaps.
GAP_SHARE, MAX_SHARE_OF_GAPS = 0.9, 0.2
# Half of the preference is reached where the squared distance is that of
# `SmootherParameters.floor_sigmas`; this power of it makes the change steep.
PREFERENCE_EXPONENT = 4
# Deviation over the difference between both memories, and the least of it.
SIGMA_RATIO, SIGMA_FLOOR_RAD = 2.0, 0.012
# The cosine of a tilt that is still one.
MIN_COSINE = 0.1


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """The plain estimate beside a solution of the smoother, at the nodes.

    Attributes:
        noise_factor: the gyro is so many times noisier than usual.
        tilt: (2, K + 1) in the level frames of the solution.
        variance: (K + 1,) of both tilts together, rad^2.
        weight: (K + 1,) of it, from 0 (the smoother's) to 1.
    """

    noise_factor: float
    tilt: Floats
    variance: Floats
    weight: Floats

    def mixed(self, smoothed: Floats, plain: Floats | float) -> Floats:
        """Return values (..., K + 1) between those of both estimates."""
        return np.asarray(smoothed + self.weight * (plain - smoothed))


def floor_under(
    tilt: Floats,
    nodes: Nodes,
    frames: Pair,
    noise_factor: float,
    p: SmootherParameters,
) -> Floor:
    """Return the plain estimate; it is preferred where the smoother is too far away.

    That is where their distance, over some time, is `floor_sigmas` times as large as
    the plain estimate's own error.

    Args:
        tilt: (2, K + 1) of the smoother.
        nodes: of the block.
        frames: (K + 1,) from frame I to the level frames of the tilt.
        noise_factor: see `Floor`.
        p: settings.
    """
    plain = _tilt(nodes, frames, SHORT_MEMORY_S)
    change = _tilt(nodes, frames, 2.0 * SHORT_MEMORY_S) - plain
    own, apart = (
        mean_square(one, nodes.duration_s, p.bound_half_width_s)
        for one in (change, plain - tilt)
    )
    allowed = p.floor_sigmas**2 * own / np.maximum(apart, 1e-12)
    gaps = (nodes.lost_s > GAP_SHARE * nodes.duration_s).astype(np.float64)
    share = _mean(gaps, nodes, SHORT_MEMORY_S)
    known = np.maximum(1.0 - share / MAX_SHARE_OF_GAPS, 0.0)
    return Floor(
        noise_factor,
        plain,
        variance=SIGMA_RATIO**2 * own + SIGMA_FLOOR_RAD**2,
        weight=known / (1.0 + allowed**PREFERENCE_EXPONENT),
    )


def _tilt(nodes: Nodes, frames: Pair, memory_s: float) -> Floats:
    """Return the tilt (2, K + 1) of the mean specific force over a memory."""
    level = rot.rotate(frames, _mean(nodes.impulse_mps, nodes, memory_s))
    least = MIN_COSINE * np.sqrt(rot.squared_norm(level)) + MIN_IMPULSE_MPS
    return np.asarray(level[:2] / np.maximum(level[2], least))


def _mean(values: Floats, nodes: Nodes, memory_s: float) -> Floats:
    """Return values of the intervals (..., K) at the nodes (..., K + 1), smoothed.

    Mirrored at both ends, so that no single interval counts for all beyond.
    """
    padded = np.concatenate([values[..., :1], values, values[..., -1:]], axis=-1)
    at_nodes = 0.5 * (padded[..., 1:] + padded[..., :-1])
    width = memory_s / float(np.median(nodes.duration_s))
    return np.asarray(gaussian_filter1d(at_nodes, width, mode="mirror"))
