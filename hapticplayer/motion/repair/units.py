"""Tells a recording in g or deg/s from one in m/s^2 and rad/s.

Units are never changed silently: a clear case is refused with the factor to use,
an unclear one passes with a note.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    EARTH_FIELD_UT,
    PLAUSIBLE_NORM_MPS2,
    SURELY_G,
    are_gaps,
)

CALM_WINDOW_S = 0.5

# Two units of the angular rate are compared in windows, by the velocity that neither
# gravity nor the errors of the sensors explain.
WINDOW_S = 8.0
SHORTEST_WINDOW_S = 2.0
MAX_WINDOWS = 24
STEP_S = 0.02
RESIDUALS = 32
VELOCITY_SIGMA_MPS = 1.0
GYRO_BIAS_SIGMA_RADPS = 0.05
GRAVITY_SIGMA_MPS2 = 0.03 * STANDARD_GRAVITY_MPS2
# Velocities below this are vibration and noise, and no evidence for a unit.
VELOCITY_FLOOR_MPS = 0.1
# A window is used where the two units rotate the specific force at least this far apart.
LEAST_DIFFERENCE_RAD = 0.1
# Other axes differ less than another unit. Recordings with optical truth give -0.2 for
# wrong axes at worst, one window alone (parts of 10 s) -0.95; reversed gyros -1.2 to -7.9.
AXES_DIFFERENCE_RAD, AXES_IN_DOUBT = 0.03, -0.8
MAX_WINDOWS_FOR_AXES, STEP_FOR_AXES_S = 8, 0.04
# Signs that explain a rate so much better than another unit are what is wrong.
SURELY_AXES = 1.0
# Prior log odds of the given unit: most logs are right, but above the RMS in a runner's
# pocket a rate is the less likely the higher it is.
LABEL_LOG_ODDS = 1.0
RUNNING_RMS_RADPS, LOG_RMS_SIGMA = 3.0, 0.6
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
        return Message("it seems to be in milli-g: multiply it by 0.00980665")
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
    did not rotate, so that a small ratio gives a note only. The windows of one
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
    evidence = windows.evidence(factor * np.eye(3), LEAST_DIFFERENCE_RAD)
    log_odds = LABEL_LOG_ODDS + evidence + _log_prior(rms) - _log_prior(factor * rms)
    if log_odds > 0.0:
        return None
    may_rest = is_degrees and factor * rms < REST_RMS_RADPS
    is_slight = log_odds > REFUSED_LOG_ODDS or evidence > -MIN_EVIDENCE
    are_signs_wrong = _of_signs(windows) < log_odds - SURELY_AXES
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
        )
    raise InputError(
        "the angular rate is about 57 times too low for how the direction of "
        "gravity changes",
        where=source,
        remedy="it seems to have been converted twice: multiply it by 57.2957795",
    )


def _log_prior(rms_radps: float) -> float:
    beyond = max(0.0, math.log(rms_radps / RUNNING_RMS_RADPS) / LOG_RMS_SIGMA)
    return -0.5 * beyond**2


class RotationWindows:
    """Parts of a recording, over which rotations by a gyro are compared.

    Args:
        time_s: (N,) increasing.
        specific_force_mps2: (N, 3) finite.
        angular_rate_radps: (N, 3) finite.
        number: of the parts at most.
        step_s: over which the rate is taken for even.
    """

    def __init__(
        self,
        time_s: Floats,
        specific_force_mps2: Floats,
        angular_rate_radps: Floats,
        number: int = MAX_WINDOWS,
        step_s: float = STEP_S,
    ) -> None:
        interval_s = float(np.median(np.diff(time_s)))
        span_s = min(WINDOW_S, interval_s * (len(time_s) - 1))
        step = max(1, round(step_s / interval_s))
        length = round(span_s / interval_s) // step * step
        self.is_empty = span_s < SHORTEST_WINDOW_S or length < 2 * step
        if self.is_empty:
            return
        number = min(number, (len(time_s) - 1) // length)
        starts = np.linspace(1, len(time_s) - length, number).astype(int)
        rows = starts[:, None] + np.arange(length)
        # a gap counts as one interval
        held_s = np.diff(time_s)[rows - 1]
        held_s[are_gaps(held_s, interval_s)] = interval_s

        def coarse(values: Floats) -> Floats:
            weighted = values[rows] * held_s[..., None]
            return np.asarray(weighted.reshape(number, -1, step, 3).sum(axis=2))

        self._step_s = held_s.reshape(number, -1, step).sum(axis=2)[..., None]
        self._impulse = coarse(specific_force_mps2)
        self._angle = coarse(angular_rate_radps)
        self._given = self._rotated(np.eye(3))

    def _rotated(self, change: Floats) -> tuple[Floats, Floats]:
        """Return the impulse in a frame that does not rotate, and the velocity left, (B,)."""
        attitude = _attitude(self._angle @ change.T)
        seen = quat.rotate(attitude, self._impulse)
        return seen, _unexplained_mps2(seen, attitude, self._step_s)

    def evidence(self, change: Floats, least_difference_rad: float) -> float:
        """Return the log likelihood ratio of the rate and of another one, the median.

        It is 0 where the two are alike in all windows.
        """
        ratios = self.log_ratios(change, least_difference_rad)
        return float(np.median(ratios)) if len(ratios) else 0.0

    def log_ratios(self, change: Floats, least_difference_rad: float) -> Floats:
        """Return the log likelihood ratios of the rate and of another one.

        Args:
            change: (3, 3) that the rate is multiplied with.
            least_difference_rad: windows are used where the two differ so much.
        """
        if self.is_empty:
            return np.zeros(0)
        (seen, left), (other, other_left) = self._given, self._rotated(change)
        apart = np.linalg.norm(seen - other, axis=2).mean(axis=1)
        size = np.linalg.norm(self._impulse, axis=2).mean(axis=1)
        used = apart > least_difference_rad * size
        return np.asarray(np.log(other_left[used] / left[used]))


class RateAxes(NamedTuple):
    """Axes of the gyro in those of the accelerometer.

    Attributes:
        change: (3, 3) signed permutation that the rate is to be multiplied with.
        evidence: log likelihood ratio of the rate as given to that; below 0 it is wrong.
    """

    change: Floats
    evidence: float


def likeliest_axes(windows: RotationWindows) -> RateAxes:
    """The axes with which the gyro rotates as gravity does in the accelerometer's axes."""
    found = RateAxes(np.eye(3), 0.0)
    for order in itertools.permutations(np.eye(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            change = np.array(signs)[:, None] * order
            evidence = windows.evidence(change, AXES_DIFFERENCE_RAD)
            if evidence < found.evidence:
                found = RateAxes(change, evidence)
    return found


def _of_signs(windows: RotationWindows) -> float:
    """Return the log likelihood ratio of the rate to that with the likeliest signs."""
    flips = [-np.eye(3), *(np.eye(3) - 2.0 * np.diag(axis) for axis in np.eye(3))]
    return min(windows.evidence(flip, AXES_DIFFERENCE_RAD) for flip in flips)


def _explains(windows: RotationWindows) -> bool:
    """Whether the rate explains more than no rotation would, and than any other sign."""
    nothing = windows.evidence(np.zeros((3, 3)), AXES_DIFFERENCE_RAD)
    return nothing > SURELY_AXES and _of_signs(windows) >= 0.0


def axes_in_doubt(
    time_s: Floats, specific_force_mps2: Floats, angular_rate_radps: Floats
) -> Floats | None:
    """The change (3, 3) of the rate's axes without which both sensors disagree, or None."""
    windows = RotationWindows(
        time_s,
        specific_force_mps2,
        angular_rate_radps,
        MAX_WINDOWS_FOR_AXES,
        STEP_FOR_AXES_S,
    )
    if _explains(windows):  # a tenth of the time
        return None
    found = likeliest_axes(windows)
    if found.evidence > AXES_IN_DOUBT:
        return None
    used = len(windows.log_ratios(found.change, AXES_DIFFERENCE_RAD))
    return found.change if found.evidence < AXES_IN_DOUBT - 1.0 / used else None


def _attitude(angle: Floats) -> Floats:
    """Return the attitude (B, K, 4) in the middles of the steps, from the first on."""
    turns = quat.from_rotation_vector(angle)
    middles = quat.from_rotation_vector(-0.5 * angle)
    return quat.multiply(quat.chained(turns), middles)


def _unexplained_mps2(impulse: Floats, attitude: Floats, step_s: Floats) -> Floats:
    """Return the mean square of the velocity that windows leave unexplained, (B,).

    Linear least squares: the velocity is one at the beginning, plus gravity of any
    direction times the time, plus what a constant gyro bias adds; gravity's norm and
    the bias have priors.

    Args:
        impulse: (B, K, 3) specific force times duration of the steps, in a frame that
            does not rotate.
        attitude: (B, K, 4) of the sensor in it.
        step_s: (B, K, 1).
    """
    axes = [quat.rotate(attitude, np.eye(3)[axis]) for axis in range(3)]
    tilts = [np.cumsum(axis * step_s, axis=1) for axis in axes]
    by_bias = [np.cumsum(np.cross(tilt, impulse), axis=1) for tilt in tilts]
    windows, steps = impulse.shape[:2]
    kept = np.linspace(0, steps - 1, min(RESIDUALS, steps)).astype(int)
    velocity = np.cumsum(impulse, axis=1)[:, kept].reshape(windows, -1)
    time_s = np.cumsum(step_s, axis=1)[:, kept, :, None]
    unit = np.broadcast_to(np.eye(3), (windows, len(kept), 3, 3))
    bias = np.stack(by_bias, axis=-1)[:, kept]
    design = np.concatenate([unit, time_s * unit, bias], axis=-1)
    design = design.reshape(windows, -1, 9)
    normal = np.einsum("bik,bil->bkl", design, design)
    right = np.einsum("bik,bi->bk", design, velocity)
    normal[:, range(6, 9), range(6, 9)] += (
        VELOCITY_SIGMA_MPS / GYRO_BIAS_SIGMA_RADPS
    ) ** 2
    weight = (VELOCITY_SIGMA_MPS / GRAVITY_SIGMA_MPS2) ** 2
    gravity, x = impulse.sum(axis=1), np.zeros((windows, 9))
    for _ in range(3):  # the prior of the norm is linear along the last direction
        down = gravity / np.maximum(np.linalg.norm(gravity, axis=1), 1e-9)[:, None]
        a, b = normal.copy(), right.copy()
        a[:, 3:6, 3:6] += weight * down[:, :, None] * down[:, None, :]
        b[:, 3:6] += weight * STANDARD_GRAVITY_MPS2 * down
        x = np.linalg.solve(a, b[..., None])[..., 0]
        gravity = x[:, 3:6]
    misfit = velocity - np.einsum("bik,bk->bi", design, x)
    by_norm = np.linalg.norm(gravity, axis=1) - STANDARD_GRAVITY_MPS2
    cost = np.square(misfit).sum(axis=1) + weight * by_norm**2
    return np.asarray(cost / len(kept) + VELOCITY_FLOOR_MPS**2)
