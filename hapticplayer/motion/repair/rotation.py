"""Whether a gyro rotates gravity as the accelerometer shows it.

One is the other's witness: with other axes, another scale or another clock of the gyro,
less velocity may be left in windows that neither gravity nor the sensors' errors explain.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import are_gaps

Flags = NDArray[np.bool_]

# Gyros are compared in windows, by the velocity that neither gravity nor the errors of the
# sensors explain.
WINDOW_S = 8.0
SHORTEST_WINDOW_S = 2.0
MAX_WINDOWS = 24
STEP_S = 0.02
RESIDUALS = 32
VELOCITY_SIGMA_MPS = 1.0
GYRO_BIAS_SIGMA_RADPS = 0.05
GRAVITY_SIGMA_MPS2 = 0.03 * STANDARD_GRAVITY_MPS2
# Velocities below this are vibration and noise, and no evidence.
VELOCITY_FLOOR_MPS = 0.1
# A window is used where two units rotate the specific force at least this far apart; other
# axes, scales and clocks differ less than another unit.
LEAST_DIFFERENCE_RAD, SMALL_DIFFERENCE_RAD = 0.1, 0.03
# Signs that explain a rate so much better than another unit are what is wrong.
SURELY_AXES = 1.0
FEW_WINDOWS, COARSE_STEP_S = 8, 0.04
# The least evidence against a gyro as it is, less that of one window. Right recordings
# with optical truth and simulated rides, in parts of 20 s, show -0.95 for other axes, -0.9
# for other clocks and -1.7 for other scales: what swings keeps the force in place, as if it
# did not rotate, and what rotates fast averages the acceleration of a car.
# Nothing doubles a rate but a range that was mistaken: -0.4.
AXES_IN_DOUBT, CLOCK_IN_DOUBT, SCALE_IN_DOUBT, OF_ONE_WINDOW = -0.8, -0.8, -2.0, 1.0
DOUBLED_IN_DOUBT = -0.8
# Axes whose evidence is this near may be the ones: in parts of 30 s the right ones are
# among them in 96 % of the reversed gyros that are asked about.
NEARLY_AS_LIKELY = 0.55
# Rates of an eighth or less rotate hardly at all, which explains more than wrong axes do
# where a phone swings.
HARDLY_ROTATING, HARDLY_LIKELIER = 0.125, 2.0
# Above the RMS in a runner's pocket a rate is the less likely the higher it is.
RUNNING_RMS_RADPS, LOG_RMS_SIGMA = 3.0, 0.6
# Ranges of gyros are powers of two apart, and degrees are taken for radians.
# With those, how far the likeliest scale may be off, as a logarithm.
USUAL_SCALES = {
    **{2.0**power: 0.15 for power in (-4, -3, -2, -1, 1, 2, 3, 4)},
    math.pi / 180.0: 0.5,
    180.0 / math.pi: 0.5,
}
SCALES_BETWEEN = np.exp2(np.arange(-4, 5) / 8.0)
DELAYS_S = np.arange(0.1, 2.05, 0.1)
DELAYS_BETWEEN_S = np.arange(-0.1, 0.11, 0.02)
# Gravity is the mean over a second that is as long as the shorter means of the log are,
# which are nearly 1 g; what a car accelerates meanwhile tilts it by at most 11 degrees.
MEAN_S, OFF_1_G, NEAR_GRAVITY = 1.0, 0.04, 0.02
SHORTER_PERCENT = 25.0
TURNS_UNSEEN_RAD, WINDOWS_FOR_GRAVITY = np.radians(25.0), 200
# Right recordings, whole and in parts of 10 to 60 s, reach 37 degrees, one window in
# eight left out: a car that brakes.
SURELY_UNSEEN_RAD, CHANCE_WINDOWS = np.radians(40.0), 8


class RotationWindows:
    """Parts of a recording, over which rotations by a gyro are compared.

    Args:
        time_s: (N,) increasing.
        specific_force_mps2: (N, 3) finite.
        angular_rate_radps: (N, 3) finite.
        number: of the parts at most.
        step_s: over which the rate is taken for even.
        valid: (N,) False where no sensor has read anything, or None.
    """

    def __init__(
        self,
        time_s: Floats,
        specific_force_mps2: Floats,
        angular_rate_radps: Floats,
        number: int = MAX_WINDOWS,
        step_s: float = STEP_S,
        valid: Flags | None = None,
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
        self._rows = starts[:, None] + np.arange(length)
        # a gap counts as one interval
        held_s = np.diff(time_s)[self._rows - 1]
        is_gap = are_gaps(held_s, interval_s)
        self._is_whole = ~is_gap.any(axis=1)
        if valid is not None:
            self._is_whole &= valid[self._rows].all(axis=1)
        held_s[is_gap] = interval_s
        self._held_s, self._interval_s = held_s, interval_s
        self._rate = angular_rate_radps
        self._step_s = held_s.reshape(number, -1, step).sum(axis=2)[..., None]
        self._impulse = self._coarse(specific_force_mps2[self._rows])
        self._angle = self._coarse(angular_rate_radps[self._rows])
        self._given = self._rotated(np.eye(3))

    def _rotated(self, change: Floats, delay_s: float = 0.0) -> tuple[Floats, Floats]:
        """The impulse in a frame that does not rotate, and the velocity left, (B,)."""
        angle = self._delayed(delay_s) if delay_s else self._angle
        attitude = _attitude(angle @ change.T)
        seen = quat.rotate(attitude, self._impulse)
        return seen, _unexplained_mps2(seen, attitude, self._step_s)

    def _delayed(self, delay_s: float) -> Floats:
        """The angles (B, K, 3) of a gyro whose times are so late."""
        rows = self._rows + round(delay_s / self._interval_s)
        values = self._rate[rows.clip(0, len(self._rate) - 1)]
        return self._coarse(values)

    def _coarse(self, values: Floats) -> Floats:
        weighted = values * self._held_s[..., None]
        windows, steps = self._step_s.shape[:2]
        return np.asarray(weighted.reshape(windows, steps, -1, 3).sum(axis=2))

    def evidence(
        self, change: Floats, least_difference_rad: float, delay_s: float = 0.0
    ) -> float:
        """The log likelihood ratio of the rate and of another one, the median.

        It is 0 where the two are alike in all windows.
        """
        ratios = self.log_ratios(change, least_difference_rad, delay_s)
        return float(np.median(ratios)) if len(ratios) else 0.0

    def log_ratios(
        self, change: Floats, least_difference_rad: float, delay_s: float = 0.0
    ) -> Floats:
        """The log likelihood ratios of the rate and of another one.

        Args:
            change: (3, 3) that the rate is multiplied with.
            least_difference_rad: windows are used where the two differ so much.
            delay_s: by which the times of the rate are late.
        """
        if self.is_empty:
            return np.zeros(0)
        (seen, left), (other, other_left) = self._given, self._rotated(change, delay_s)
        apart = np.linalg.norm(seen - other, axis=2).mean(axis=1)
        size = np.linalg.norm(self._impulse, axis=2).mean(axis=1)
        used = apart > least_difference_rad * size
        return np.asarray(np.log(other_left[used] / left[used]))

    def rms_radps(self) -> float:
        """The RMS of the rate."""
        rate = self._angle / self._step_s
        return math.sqrt(float(np.square(rate).sum(axis=2).mean()))

    def most_evidence(self) -> float:
        """The most that there can be against the rate, if another one explained all."""
        return float(np.log(VELOCITY_FLOOR_MPS**2 / self._given[1].max()))

    def unseen_turns_rad(self) -> Floats:
        """The largest turn of gravity in each window which the rate does not show."""
        if self.is_empty or not self._is_whole.any():
            return np.zeros(1)
        seen = self._given[0][self._is_whole]
        step_s = float(np.median(self._step_s))
        count = max(1, round(MEAN_S / step_s))
        whole = seen.shape[1] // count * count
        means = seen[:, :whole].reshape(len(seen), -1, count, 3).mean(axis=2) / step_s
        norm = np.linalg.norm(means, axis=2)
        usual = float(np.percentile(norm, SHORTER_PERCENT))
        if abs(usual / STANDARD_GRAVITY_MPS2 - 1.0) > OFF_1_G:
            return np.zeros(1)
        is_gravity = np.abs(norm / usual - 1.0) < NEAR_GRAVITY
        unit = np.where(is_gravity[..., None], means / norm[..., None], np.nan)
        cosines = np.einsum("bik,bjk->bij", unit, unit)
        least = np.where(np.isfinite(cosines), cosines, 1.0).min(axis=(1, 2))
        return np.asarray(np.arccos(least.clip(-1.0, 1.0)))


class Doubt(NamedTuple):
    """What explains both sensors better than the gyro as it is.

    Attributes:
        evidence: log likelihood ratio of the gyro as given to this; below 0 it is wrong.
        change: (3, 3) signed permutation that the rate is to be multiplied with, or None.
        gaps: by how much less likely others are, with them, the likeliest first.
        scale: that the rate is to be multiplied with, or None.
        delay_s: by which its times are late.
    """

    evidence: float
    change: Floats | None = None
    gaps: tuple[tuple[float, Floats], ...] = ()
    scale: float | None = None
    delay_s: float = 0.0


def coarse_windows(imu: ImuLog, number: int = FEW_WINDOWS) -> RotationWindows:
    """Windows of a log with long steps, in which large differences are seen."""
    return RotationWindows(
        imu.time_s,
        imu.specific_force_mps2,
        imu.angular_rate_radps,
        number,
        COARSE_STEP_S,
        imu.valid,
    )


def doubt_about(imu: ImuLog) -> Doubt | None:
    """What speaks clearly against the gyro of a log as it is, or None."""
    windows = coarse_windows(imu)
    if windows.is_empty or windows.most_evidence() > AXES_IN_DOUBT:
        return None
    doubts = [_of_scale(windows), _of_clock(windows), _of_axes(windows)]
    found = [one for one in doubts if one is not None]
    return min(found, key=_rank, default=None)


def _rank(doubt: Doubt) -> float:
    is_still = doubt.scale is not None and doubt.scale <= HARDLY_ROTATING
    return doubt.evidence + HARDLY_LIKELIER * is_still


def _are_enough(windows: RotationWindows, doubt: Doubt, least: float) -> bool:
    change = np.eye(3) if doubt.change is None else doubt.change
    change = change * (doubt.scale or 1.0)
    used = len(windows.log_ratios(change, SMALL_DIFFERENCE_RAD, doubt.delay_s))
    return bool(used) and doubt.evidence < least - OF_ONE_WINDOW / used


def log_prior(rms_radps: float) -> float:
    """How likely a rate is without a look at gravity."""
    beyond = max(0.0, math.log(rms_radps / RUNNING_RMS_RADPS) / LOG_RMS_SIGMA)
    return -0.5 * beyond**2


def _of_scale(windows: RotationWindows) -> Doubt | None:
    rms_radps = windows.rms_radps()
    if not rms_radps:
        return None

    def evidence(scale: float) -> float:
        seen = windows.evidence(scale * np.eye(3), SMALL_DIFFERENCE_RAD)
        return seen + log_prior(rms_radps) - log_prior(scale * rms_radps)

    clear = []
    for scale in USUAL_SCALES:
        doubt = Doubt(evidence(scale), scale=scale)
        least = DOUBLED_IN_DOUBT if scale == 2.0 else SCALE_IN_DOUBT
        if _are_enough(windows, doubt, least):
            clear.append(doubt)
    if not clear:
        return None
    best = min(clear, key=lambda one: one.evidence)
    assert best.scale
    fine = min(best.scale * SCALES_BETWEEN, key=evidence)
    usual = [
        scale
        for scale, off in USUAL_SCALES.items()
        if abs(math.log(scale / fine)) < off
    ]
    return best._replace(scale=usual[0] if usual else float(f"{fine:.2g}"))


def _of_clock(windows: RotationWindows) -> Doubt | None:
    def evidence(delay_s: float) -> float:
        return windows.evidence(np.eye(3), SMALL_DIFFERENCE_RAD, delay_s)

    best_s = min((*DELAYS_S, *-DELAYS_S), key=evidence)
    best_s = float(min(best_s + DELAYS_BETWEEN_S, key=evidence))
    doubt = Doubt(evidence(best_s), delay_s=round(best_s, 2))
    is_clear = _are_enough(windows, doubt, CLOCK_IN_DOUBT)
    return doubt if is_clear else None


def _of_axes(windows: RotationWindows) -> Doubt | None:
    if _explains(windows):  # a tenth of the time
        return None
    doubt = likeliest_axes(windows)
    is_clear = _are_enough(windows, doubt, AXES_IN_DOUBT)
    return doubt if is_clear else None


def likeliest_axes(windows: RotationWindows) -> Doubt:
    """The axes with which the gyro rotates as gravity does in the accelerometer's axes."""
    signs = [np.array(one)[:, None] for one in itertools.product((1, -1), repeat=3)]
    changes = [
        sign * np.array(order)
        for order in itertools.permutations(np.eye(3))
        for sign in signs
    ]
    seen = [windows.evidence(one, SMALL_DIFFERENCE_RAD) for one in changes]
    best, *others = sorted(zip(seen, range(len(changes)), strict=True))
    gaps = [(value - best[0], changes[at]) for value, at in others if value < 0.0]
    near = tuple(one for one in gaps if one[0] < NEARLY_AS_LIKELY)
    return Doubt(best[0], changes[best[1]], near)


def of_signs(windows: RotationWindows) -> float:
    """The log likelihood ratio of the rate to that with the likeliest signs."""
    flips = [-np.eye(3), *(np.eye(3) - 2.0 * np.diag(axis) for axis in np.eye(3))]
    return min(windows.evidence(flip, SMALL_DIFFERENCE_RAD) for flip in flips)


def _explains(windows: RotationWindows) -> bool:
    """Whether the rate explains more than no rotation would, and than any other sign."""
    nothing = windows.evidence(np.zeros((3, 3)), SMALL_DIFFERENCE_RAD)
    return nothing > SURELY_AXES and of_signs(windows) >= 0.0


def turns_gravity(imu: ImuLog) -> bool:
    """Whether the rate turns gravity, so that the accelerometer bears witness to it."""
    windows = coarse_windows(imu)
    return len(windows.log_ratios(np.zeros((3, 3)), SMALL_DIFFERENCE_RAD)) > 0


def unseen_turn_rad(imu: ImuLog) -> float:
    """The largest turn of gravity that the gyro of a log does not show, if it is sure."""
    turns_rad = np.sort(coarse_windows(imu, WINDOWS_FOR_GRAVITY).unseen_turns_rad())
    turn_rad = float(turns_rad[-1 - len(turns_rad) // CHANCE_WINDOWS])
    return turn_rad if turn_rad > SURELY_UNSEEN_RAD else 0.0


def dead_axes(imu: ImuLog, doubt: Doubt | None) -> list[int]:
    """Axes about which the gyro reads 0 throughout although gravity turns about them.

    Args:
        imu: the log.
        doubt: about its gyro; one about axes counts as well.
    """
    dead = np.flatnonzero(~imu.angular_rate_radps.any(axis=0)).tolist()
    if not dead or (doubt is not None and doubt.change is not None):
        return dead
    windows = coarse_windows(imu, WINDOWS_FOR_GRAVITY)
    return dead if windows.unseen_turns_rad().max() > TURNS_UNSEEN_RAD else []


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
    axes = quat.rotate(attitude[:, :, None], np.eye(3))  # (B, K, 3, 3), one in a row
    tilts = np.cumsum(axes * step_s[..., None], axis=1)
    by_bias = np.cumsum(np.cross(tilts, impulse[:, :, None]), axis=1)
    windows, steps = impulse.shape[:2]
    kept = np.linspace(0, steps - 1, min(RESIDUALS, steps)).astype(int)
    velocity = np.cumsum(impulse, axis=1)[:, kept].reshape(windows, -1)
    time_s = np.cumsum(step_s, axis=1)[:, kept, :, None]
    unit = np.broadcast_to(np.eye(3), (windows, len(kept), 3, 3))
    bias = by_bias[:, kept].swapaxes(2, 3)
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
