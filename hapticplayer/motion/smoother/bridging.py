"""Samples that a logger dropped are put back by straight lines."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.motion.smoother.strapdown import Samples

# A step of a whole number of intervals has lost samples; a step of any other length
# is the logger's way.
_WHOLE = 0.15
# Of a logger that drops samples, at least this share of the steps is regular.
_REGULAR = 0.6
_NEAR = 0.1
# One that would have dropped more stamps packets, not samples.
_MOST = 2.0


def bridged(samples: Samples) -> tuple[Samples, NDArray[np.intp] | None]:
    """Return the samples with dropped ones put back, and the places of the others.

    The places are None where nothing was dropped.
    """
    if samples.step_s.max() < (2.0 - _WHOLE) * samples.interval_s:
        return samples, None
    steps = samples.step_s / samples.interval_s
    whole = np.round(steps)
    dropped = (whole >= 2.0) & (np.abs(steps - whole) < _WHOLE)
    if not dropped.any() or np.mean(np.abs(steps - 1.0) < _NEAR) < _REGULAR:
        return samples, None
    parts = np.where(dropped, whole, 1.0).astype(np.intp)
    if parts.sum() > _MOST * len(samples):
        return samples, None
    places = np.cumsum(parts) - 1
    count = int(places[-1]) + 1
    rows = np.interp(np.arange(count), places, np.arange(len(samples)))
    before = np.floor(rows).astype(np.intp)
    share = (rows - before)[:, None]
    after = np.minimum(before + 1, len(samples) - 1)

    def between(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(values[before] + share * (values[after] - values[before]))

    spread = np.repeat(1.0 / parts, parts)
    filled = Samples(
        np.repeat(samples.step_s, parts) * spread,
        between(samples.specific_force_mps2),
        between(samples.angular_rate_radps),
        samples.averaged,
        np.repeat(samples.lost_s, parts) * spread,
        np.repeat(samples.doubt_s, parts) * spread,
        samples.gain,
        samples.interval_s,
    )
    return filled, places
