"""The extreme values that a clipped sensor repeats."""

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Mask

# No accelerometer has a range below 1.5 g and no gyro of this kind one below
# 250 deg/s (with 10 % of scale error): a rail that is found lies above.
MIN_FORCE_RAIL_MPS2 = 14.0
MIN_RATE_RAIL_RADPS = 3.9
SAME_READING = 1e-4
MIN_READINGS = 5
MIN_IN_A_ROW = 3
BAND = 5e-3
"""Share of a given full scale from which a reading counts as clipped (scale errors)
and of a rail that is searched for other readings."""
SAME_RANGE = 6e-3
"""Rails of one sensor's axes differ by less (0.5 % on a Nexus 5)."""


def sensor_rails(
    values: Floats, full_scale: float | None, minimum: float, trusted: Mask
) -> Floats:
    """Return the rails (C, 2) of a given full scale, or those found.

    Args:
        values: (N, C) readings of one sensor.
        full_scale: its range, or None to find it.
        minimum: smallest magnitude that a rail may have.
        trusted: (N,) samples to search.

    Raises:
        InputError: for a full scale that is not positive.
    """
    if full_scale is None:
        rails = find_rails(values[trusted], minimum)
        return rails * (1.0 - SAME_READING)  # readings differ by rounding
    timing.positive(full_scale, "the full scale", "give it in SI units, 19.6 for 2 g")
    rail = full_scale * (1.0 - BAND)
    return np.tile([-rail, rail], (values.shape[1], 1))


def find_rails(values: Floats, minimum: float) -> Floats:
    """Return the rails (C, 2), low and high, that the readings (N, C) reveal.

    One axis and side must show a pile of readings; others that end within 0.6 % of the
    same magnitude then end at their own extreme. Infinite where nothing is clipped.

    Args:
        values: readings of one sensor, as they came.
        minimum: smallest magnitude that a rail may have.
    """
    rails = np.tile([-np.inf, np.inf], (values.shape[1], 1))
    if not len(values):
        return rails
    extremes = np.stack([values.min(axis=0), values.max(axis=0)], axis=1)
    outward = np.array([-1.0, 1.0])
    sizes = extremes * outward
    piled = np.zeros(sizes.shape, dtype=np.bool_)
    for axis, side in np.argwhere(sizes >= minimum):
        piled[axis, side] = _is_pile(outward[side] * values[:, axis])
    if piled.any():
        scale = float(sizes[piled].max())
        # all sides that reach the range, whether they have a pile of their own or not
        reached = piled | (np.abs(sizes / scale - 1.0) < SAME_RANGE)
        rails[reached] = extremes[reached]
    return rails


def _is_pile(column: Floats) -> bool:
    """Return whether the upper end of (N,) is a pile of equal readings."""
    top = float(column.max())
    at_top = column >= top * (1.0 - SAME_READING)
    below = (column >= top * (1.0 - BAND)) & ~at_top
    count = int(at_top.sum())
    starts, ends = timing.runs(at_top)
    return (
        count >= MIN_READINGS
        and int((ends - starts).max()) >= MIN_IN_A_ROW
        and count > 2 * int(below.sum())
    )
