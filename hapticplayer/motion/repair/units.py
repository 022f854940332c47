"""Tells a recording in g from one in m/s^2.

Units are never changed silently: it is refused with the factor to use.
"""

import math

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    EARTH_FIELD_UT,
    PLAUSIBLE_NORM_MPS2,
    SURELY_G,
)

CALM_WINDOW_S = 0.5
NEAR_GAL = math.sqrt(1000.0 / (100.0 * STANDARD_GRAVITY_MPS2))
"""Gravity is 981 cm/s^2 and 1000 mg."""


def check_force_unit(
    time_s: Floats, specific_force_mps2: Floats, source: str = ""
) -> None:
    """Refuse a specific force whose calm parts cannot be gravity in m/s^2.

    Args:
        time_s: (N,) increasing.
        specific_force_mps2: (N, 3) finite, in the unit to check.
        source: for the error message.
    """
    norm = calm_norm(time_s, specific_force_mps2)
    low, high = PLAUSIBLE_NORM_MPS2
    if low <= norm <= high:
        return
    raise InputError(
        "the norm of the specific force is {norm:.3g} where it is calmest, "
        "but gravity is {gravity:.3g} m/s^2",
        where=source,
        remedy=_force_remedy(norm),
        norm=norm,
        gravity=STANDARD_GRAVITY_MPS2,
    )


def calm_norm(time_s: Floats, specific_force_mps2: Floats) -> float:
    """Return the median norm over the calmer half of the windows of 0.5 s."""
    norm = np.sqrt(np.einsum("ij,ij->i", specific_force_mps2, specific_force_mps2))
    interval_s = float(np.median(np.diff(time_s)))
    count = max(2, round(CALM_WINDOW_S / interval_s))
    windows = len(norm) // count
    if windows < 2:
        return float(np.median(norm))
    blocks = norm[: windows * count].reshape(windows, count)
    # relative, so that free fall does not count as calmer than rest
    spread = blocks.std(axis=1) / np.maximum(blocks.mean(axis=1), 1e-300)
    calm = spread <= np.median(spread)
    return float(np.median(blocks[calm]))


def _force_remedy(norm: float) -> str:
    low = PLAUSIBLE_NORM_MPS2[0]
    if EARTH_FIELD_UT[0] <= norm <= EARTH_FIELD_UT[1]:
        return Message(
            "if these are a magnetometer's readings, give those of the accelerometer; "
            "else give the specific force in m/s^2, about 9.8 at rest"
        )
    gravity = STANDARD_GRAVITY_MPS2
    if SURELY_G[0] <= norm <= SURELY_G[1]:
        return Message("it seems to be in g: multiply it by 9.80665")
    if low / gravity <= norm < low:
        return Message(
            "if it is in g, multiply it by 9.80665; if gravity was removed "
            "already, give the acceleration with gravity"
        )
    if low / gravity <= norm / 1000.0 < low:
        is_gal = 1.0 / NEAR_GAL < norm / (100.0 * gravity) < NEAR_GAL
        return Message(
            "it seems to be in {unit}: multiply it by {factor:.6g}",
            unit="cm/s^2" if is_gal else "milli-g",
            factor=0.01 if is_gal else gravity / 1000.0,
        )
    if norm < low / gravity:
        return Message(
            "gravity seems to be removed already: give the acceleration with gravity"
        )
    return Message("give the specific force in m/s^2, about 9.8 at rest")
