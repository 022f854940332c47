"""Tells a recording in g or deg/s from one in m/s^2 and rad/s.

Units are never changed silently: a clear case is refused with the factor to use,
an unclear one passes with a note.
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
from hapticplayer.motion.repair.rotation import (
    SURELY_AXES,
    RotationWindows,
    log_prior,
    of_signs,
)

CALM_WINDOW_S = 0.5
NEAR_GAL = math.sqrt(1000.0 / (100.0 * STANDARD_GRAVITY_MPS2))
"""Gravity is 981 cm/s^2 and 1000 mg."""

LABEL_LOG_ODDS = 1.0  # most logs are right
REFUSED_LOG_ODDS = -2.5
MIN_EVIDENCE = 0.5
# Below this rate in the other unit the sensor may be at rest, and the rate be its bias.
REST_RMS_RADPS = 0.02
# Lower rates may have been converted twice, higher ones be in deg/s.
SLOW_RMS_RADPS = 0.1


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


def check_rate_unit(
    time_s: Floats,
    specific_force_mps2: Floats,
    angular_rate_radps: Floats,
    source: str = "",
    *,
    is_known: bool = False,
) -> Message | None:
    """Refuse an angular rate whose other unit is far more likely.

    RotationWindows in which the units rotate the specific force differently are compared by
    a likelihood ratio: the unit whose rotation leaves the smaller velocity is more
    likely. Swinging keeps the specific force along one axis of the sensor, as if it
    did not rotate, so that a small ratio against a rate says nothing; one against a rate
    that may be too low gives a note. The windows of one
    recording share its kind of motion and count as one. The cost does not grow with
    the length.

    Args:
        time_s: (N,) increasing.
        specific_force_mps2: (N, 3) finite.
        angular_rate_radps: (N, 3) finite, in the unit to check.
        source: for the error message.
        is_known: a person has given the unit, so that nothing is refused.

    Returns:
        A note where the unit is in doubt, else None.
    """
    rms = math.sqrt(
        float(np.einsum("ij,ij->", angular_rate_radps, angular_rate_radps))
        / len(angular_rate_radps)
    )
    if rms == 0.0:
        return None
    is_degrees = rms > SLOW_RMS_RADPS
    factor = np.pi / 180.0 if is_degrees else 180.0 / np.pi
    windows = RotationWindows(time_s, specific_force_mps2, angular_rate_radps)
    evidence = float(windows.evidence(factor * np.eye(3)))
    log_odds = LABEL_LOG_ODDS + evidence + log_prior(rms) - log_prior(factor * rms)
    is_slight = log_odds > REFUSED_LOG_ODDS or evidence > -MIN_EVIDENCE
    is_swing = is_degrees and is_slight and log_odds > evidence
    if log_odds > 0.0 or is_swing:
        return None
    may_rest = is_degrees and factor * rms < REST_RMS_RADPS
    are_signs_wrong = of_signs(windows) < log_odds - SURELY_AXES
    if is_slight or may_rest or is_known or are_signs_wrong:
        return Message(
            "the motion does not clearly agree with the unit of the angular rate; it "
            "was taken as it is"
        )
    if is_degrees:
        raise InputError(
            "the angular rate is about 57 times too high for how the direction of "
            "gravity changes",
            where=source,
            remedy="it seems to be in deg/s: multiply it by 0.0174532925",
            times=factor,
        )
    raise InputError(
        "the angular rate is about 57 times too low for how the direction of "
        "gravity changes",
        where=source,
        remedy="it seems to have been converted twice: multiply it by 57.2957795",
        times=factor,
    )
