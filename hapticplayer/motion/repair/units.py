"""Tells a recording in g or deg/s from one in m/s^2 and rad/s.

Units are never changed silently: a clear case is refused with the factor to use,
an unclear one passes.
"""

import math

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats

PLAUSIBLE_NORM_MPS2 = (4.0, 40.0)
"""Norm of the specific force where it is calm: 1 g at rest, 1.8 g in a runner's hand."""

SURELY_G = (0.8, 1.25)

CALM_WINDOW_S = 0.5

# Angular rates are compared with how gravity turns in the sensor, in blocks.
BLOCK_S = 1.0
MAX_BLOCKS = 60
MAX_STEPS = 100
# A block tells the units apart when the mean force differs by this part of its norm.
TELLING = 0.1
MIN_TELLING_BLOCKS = 5
MIN_TELLING_SHARE = 0.2
AGREEMENT = 0.8
# Hands reach 7 rad/s RMS in fast rotation. Between the bounds nothing is doubtful.
SLOW_RMS_RADPS = 0.1
FAST_RMS_RADPS = 0.35
WILD_RMS_RADPS = 15.0
# Up to the wild bound the other unit must also explain the force as gravity alone.
EXPLAINED = 0.9


def check_force_unit(time_s: Floats, force: Floats, source: str = "") -> None:
    """Refuse a specific force whose calm parts cannot be gravity in m/s^2.

    Args:
        time_s: (N,) increasing.
        force: (N, 3) finite.
        source: for the error message.

    Raises:
        InputError: naming the factor where the unit is recognised.
    """
    norm = calm_norm(time_s, force)
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


def calm_norm(time_s: Floats, force: Floats) -> float:
    """Return the median norm over the calmer half of the windows of 0.5 s."""
    norm = np.sqrt(np.einsum("ij,ij->i", force, force))
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
    gravity = STANDARD_GRAVITY_MPS2
    if SURELY_G[0] <= norm <= SURELY_G[1]:
        return Message("it seems to be in g: multiply it by 9.80665")
    if low / gravity <= norm < low:
        return Message(
            "if it is in g, multiply it by 9.80665; if gravity was removed "
            "already, give the acceleration with gravity"
        )
    if low / gravity <= norm / 1000.0 < low:
        return Message("it seems to be in milli-g: multiply it by 0.00980665")
    if norm < low / gravity:
        return Message(
            "gravity seems to be removed already: give the acceleration with gravity"
        )
    return Message("give the specific force in m/s^2, about 9.8 at rest")


def check_rate_unit(
    time_s: Floats, force: Floats, rate: Floats, source: str = ""
) -> None:
    """Refuse an angular rate that gravity's turning shows to be in another unit.

    In a frame that the right angular rate keeps from turning, the mean specific
    force over a second is gravity plus a bounded change of velocity; a wrong unit
    smears gravity over all directions. Blocks across the recording vote between
    rad/s and the other unit; the cost does not grow with the length.

    Args:
        time_s: (N,) increasing.
        force: (N, 3) finite.
        rate: (N, 3) finite.
        source: for the error message.

    Raises:
        InputError: naming the factor.
    """
    rms = math.sqrt(float(np.einsum("ij,ij->", rate, rate)) / len(rate))
    if SLOW_RMS_RADPS <= rms <= FAST_RMS_RADPS:
        return
    is_degrees = rms > FAST_RMS_RADPS
    factor = np.pi / 180.0 if is_degrees else 180.0 / np.pi
    if not _explains_better(time_s, force, rate, factor, rms):
        return
    if is_degrees:
        raise InputError(
            "the angular rate turns gravity about 57 times too fast",
            where=source,
            remedy="it seems to be in deg/s: multiply it by 0.0174532925",
        )
    raise InputError(
        "the angular rate turns gravity about 57 times too slowly",
        where=source,
        remedy="it seems to have been converted twice: multiply it by 57.2957795",
    )


def _explains_better(
    time_s: Floats, force: Floats, rate: Floats, factor: float, rms: float
) -> bool:
    """Return whether `factor` times the rate explains the force, and 1 does not."""
    interval_s = float(np.median(np.diff(time_s)))
    length = max(2, round(BLOCK_S / interval_s))
    if len(time_s) < length + 1:
        return False
    starts = np.unique(np.linspace(1, len(time_s) - length, MAX_BLOCKS).astype(int))
    rows = starts[:, None] + np.arange(length)
    angle = rate[rows] * np.minimum(np.diff(time_s), interval_s)[rows - 1][..., None]
    given = _mean_force(force[rows], angle)
    other = _mean_force(force[rows], factor * angle)
    telling = np.abs(other - given) > TELLING
    count = int(np.count_nonzero(telling))
    if count < MIN_TELLING_BLOCKS or count < MIN_TELLING_SHARE * len(starts):
        return False
    wins = (other > given) & (other > (0.0 if rms > WILD_RMS_RADPS else EXPLAINED))
    return int(np.count_nonzero(wins & telling)) >= AGREEMENT * count


def _mean_force(force: Floats, angle: Floats) -> Floats:
    """Return |mean force| / mean |force| of blocks in a frame that does not turn.

    Args:
        force: (B, L, 3).
        angle: (B, L, 3) rotation vectors of the samples.
    """
    step = -(-force.shape[1] // MAX_STEPS)
    whole = force.shape[1] // step * step
    shape = (len(force), whole // step, step, 3)
    turns = quat.from_rotation_vector(angle[:, :whole].reshape(shape).sum(axis=2))
    coarse = force[:, :whole].reshape(shape).mean(axis=2)
    q = np.tile([1.0, 0.0, 0.0, 0.0], (len(force), 1))
    at = np.empty_like(turns)
    for k in range(coarse.shape[1]):
        at[:, k] = q = quat.multiply(q, turns[:, k])
    total = quat.rotate(at, coarse).sum(axis=1)
    norm = np.linalg.norm(coarse, axis=2).sum(axis=1)
    return np.asarray(np.linalg.norm(total, axis=1) / np.maximum(norm, 1e-300))
