"""Whether a gyro rotates gravity as the accelerometer shows it.

One is the other's witness: with other axes, another scale or another clock of the gyro,
less velocity may be left in windows that neither gravity nor the sensors' errors explain.
"""

import dataclasses
import itertools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import are_gaps

# Gyros are compared in windows, by the velocity that nothing explains: neither gravity, nor
# the errors of the sensors, nor a vehicle that moves along its own axes, nor an arm.
WINDOW_S, SHORTEST_WINDOW_S = 8.0, 2.0
# Windows may have so much more invalid than the one that has least.
FEW_WINDOWS, MORE_FILLED = 8, 0.01
STEP_S = 0.08
# What spins turns too far in such a step.
SPINNING_RMS_RADPS, SHORT_STEP_S = 6.0, 0.02
RESIDUALS = 32
VELOCITY_SIGMA_MPS = 1.0
GYRO_BIAS_SIGMA_RADPS, LARGEST_BIAS_STEP_RADPS = 0.05, 0.15
GRAVITY_SIGMA_MPS2 = 0.03 * STANDARD_GRAVITY_MPS2
VEHICLE_SIGMA_MPS, ARM_SIGMA_M = 8.0, 0.7
# Velocities below this are vibration, hands and noise, and no evidence.
VELOCITY_FLOOR_MPS = 0.3
# What another clock explains falsely, as of a running hand, leaves far more than this, while
# a right one may leave little; so a clock is told from smaller ones.
CLOCK_FLOOR_MPS = 0.1
# The accelerometer bears witness to a gyro that turns gravity by so much.
LEAST_TURN_RAD = 0.1
# The least evidence against a gyro as it is, less that of one window. Right recordings with
# optical truth and simulated rides, in parts of 10 s to the whole, show in 20 s -0.6 for
# other axes and -1.1 for other clocks; for other scales -1.5, as what swings keeps the force
# in place, and what rotates fast averages the acceleration of a car. None is 57 times as fast.
AXES_IN_DOUBT, CLOCK_IN_DOUBT, OF_ONE_WINDOW = -0.6, -0.95, 0.8
SCALE_IN_DOUBT, DOUBLED_IN_DOUBT, DEGREES_IN_DOUBT = -1.8, -0.9, -0.45
# Where a turn of gravity is not shown at all, a higher rate needs less.
UNSEEN_IN_DOUBT = -0.8
# Axes whose evidence is this near may be the ones.
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
# Right recordings, whole and in parts of 10 to 60 s, reach 43 degrees, one window in
# eight left out: a car that brakes.
SURELY_UNSEEN_RAD, CHANCE_WINDOWS = np.radians(46.0), 8


class RotationWindows:
    """Parts of a recording, over which rotations by a gyro are compared.

    Args:
        time_s: (N,) increasing.
        specific_force_mps2: (N, 3) finite.
        angular_rate_radps: (N, 3) finite.
        number: of the parts at most; they overlap by half.
        valid: (N,) False where no sensor has read anything, or None; windows have few.
    """

    def __init__(
        self,
        time_s: Floats,
        specific_force_mps2: Floats,
        angular_rate_radps: Floats,
        number: int = FEW_WINDOWS,
        valid: NDArray[np.bool_] | None = None,
    ) -> None:
        interval_s = float(np.median(np.diff(time_s)))
        span_s = min(WINDOW_S, interval_s * (len(time_s) - 1))
        power = float(np.vdot(angular_rate_radps, angular_rate_radps)) / len(time_s)
        is_spinning = power > SPINNING_RMS_RADPS**2
        step_s = SHORT_STEP_S if is_spinning else STEP_S
        step = max(1, round(step_s / interval_s))
        length = round(span_s / interval_s) // step * step
        self.is_empty = span_s < SHORTEST_WINDOW_S or length < 2 * step
        if self.is_empty:
            return
        # where a sensor is stuck it bears no witness; single samples are filled in
        invalid = np.zeros(len(time_s)) if valid is None else ~valid
        before = np.append(0, np.cumsum(invalid))
        count = before[length + 1 :] - before[1:-length]
        possible = 1 + np.flatnonzero(count <= count.min() + MORE_FILLED * length)
        number = min(number, max(1, 2 * (len(possible) + length - 1) // length - 1))
        starts = possible[np.linspace(0, len(possible) - 1, number).astype(int)]
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
        self._angle = self._coarse(self._rate[self._rows])
        self._given = self._explained(self._angle)
        self.number = number

    def _explained(self, angle: Floats) -> "_Explained":
        return _explained(self._impulse, angle, self._step_s)

    def _delayed(self, delay_s: float) -> Floats:
        """The angles (B, K, 3) of a gyro whose times are so late."""
        rows = self._rows + round(delay_s / self._interval_s)
        values = self._rate[rows.clip(0, len(self._rate) - 1)]
        return self._coarse(values)

    def _coarse(self, values: Floats) -> Floats:
        weighted = values * self._held_s[..., None]
        windows, steps = self._step_s.shape[:2]
        return np.asarray(weighted.reshape(windows, steps, -1, 3).sum(axis=2))

    def evidence(self, changes: Floats) -> Floats:
        """The log likelihood ratios of the rate as it is and of others, (...).

        Args:
            changes: (..., 3, 3) that the rate is multiplied with.
        """
        if self.is_empty:
            return np.zeros(changes.shape[:-2])
        turned = np.swapaxes(changes, -1, -2)[..., None, :, :]
        return self._evidence(self._angle @ turned)

    def evidence_of_delays(self, delays_s: Floats) -> Floats:
        """The same of times of the rate that are late by delays (D,)."""
        angle = np.array([self._delayed(one) for one in delays_s])
        return self._evidence(angle, CLOCK_FLOOR_MPS)

    def _evidence(self, angle: Floats, floor_mps: float = VELOCITY_FLOOR_MPS) -> Floats:
        left, given = self._explained(angle).left_mps2, self._given.left_mps2
        return np.asarray(np.log((left + floor_mps**2) / (given + floor_mps**2)))

    def least(self, evidence: float) -> float:
        """What is asked for of so many windows."""
        return evidence - OF_ONE_WINDOW / self.number

    def rms_radps(self) -> float:
        """The RMS of the rate."""
        rate = self._angle / self._step_s
        return math.sqrt(float(np.square(rate).sum(axis=2).mean()))

    def most_evidence(self) -> float:
        """The most that there can be against the rate, if another one explained all."""
        return -math.log1p(float(self._given.left_mps2) / VELOCITY_FLOOR_MPS**2)

    def turn_rad(self) -> float:
        """The largest angle by which the rate, without its bias, turns a direction."""
        if self.is_empty:
            return 0.0
        still = self._explained(np.zeros_like(self._angle)).seen
        along = np.einsum("bki,bki->bk", _unit(still), _unit(self._given.seen))
        return float(np.arccos(along.clip(-1.0, 1.0)).max())

    def unseen_turns_rad(self) -> Floats:
        """The largest turn of gravity in each window which the rate does not show."""
        if self.is_empty or not self._is_whole.any():
            return np.zeros(1)
        seen = self._given.seen[self._is_whole]
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


def windows_of(imu: ImuLog, number: int = FEW_WINDOWS) -> RotationWindows:
    force, rate = imu.specific_force_mps2, imu.angular_rate_radps
    return RotationWindows(imu.time_s, force, rate, number, imu.valid)


def doubt_about(imu: ImuLog) -> Doubt | None:
    """What speaks clearly against the gyro of a log as it is, or None."""
    windows = windows_of(imu)
    if windows.is_empty or windows.most_evidence() > DEGREES_IN_DOUBT:
        return None
    scale = _of_scale(windows, is_unseen=unseen_turn_rad(imu) > 0.0)
    doubts = [scale, _of_clock(imu, windows), _of_axes(windows)]
    found = [one for one in doubts if one is not None]
    return min(found, key=_rank, default=None)


def _rank(doubt: Doubt) -> float:
    is_still = doubt.scale is not None and doubt.scale <= HARDLY_ROTATING
    return doubt.evidence + HARDLY_LIKELIER * is_still


def log_prior(rms_radps: float) -> float:
    """How likely a rate is without a look at gravity."""
    beyond = max(0.0, math.log(rms_radps / RUNNING_RMS_RADPS) / LOG_RMS_SIGMA)
    return -0.5 * beyond**2


def _of_scale(windows: RotationWindows, *, is_unseen: bool) -> Doubt | None:
    rms_radps = windows.rms_radps()
    if not rms_radps:
        return None

    def evidence(scales: Floats) -> Floats:
        seen = windows.evidence(scales[:, None, None] * np.eye(3))
        priors = [log_prior(rms_radps * scale) for scale in scales.tolist()]
        return np.asarray(seen + log_prior(rms_radps) - priors)

    scales = np.array(list(USUAL_SCALES))
    usual_least = {
        2.0: DOUBLED_IN_DOUBT,
        180.0 / math.pi: DEGREES_IN_DOUBT,
        **({2.0**power: UNSEEN_IN_DOUBT for power in range(1, 5)} if is_unseen else {}),
    }
    least = np.array(
        [windows.least(usual_least.get(one, SCALE_IN_DOUBT)) for one in USUAL_SCALES]
    )
    found = evidence(scales)
    found = np.where(found < least, found, 0.0)
    if not found.any():
        return None
    best = int(found.argmin())
    between = scales[best] * SCALES_BETWEEN
    fine = float(between[evidence(between).argmin()])
    usual = [
        scale
        for scale, off in USUAL_SCALES.items()
        if abs(math.log(scale / fine)) < off
    ]
    return Doubt(found[best], scale=usual[0] if usual else float(f"{fine:.2g}"))


def _of_clock(imu: ImuLog, windows: RotationWindows) -> Doubt | None:
    delays_s = np.concatenate([DELAYS_S, -DELAYS_S])
    best_s = delays_s[windows.evidence_of_delays(delays_s).argmin()]
    delays_s = best_s + DELAYS_BETWEEN_S
    windows = _reached(imu, float(np.abs(delays_s).max()))
    found = windows.evidence_of_delays(delays_s)
    best = int(found.argmin())
    doubt = Doubt(float(found[best]), delay_s=round(float(delays_s[best]), 2))
    return doubt if doubt.evidence < windows.least(CLOCK_IN_DOUBT) else None


def _reached(imu: ImuLog, delay_s: float) -> RotationWindows:
    """Windows that a gyro reaches, or most of them, if its times are off by so much."""
    begin_s, end_s = imu.time_s[[0, -1]]
    inside = (imu.time_s >= begin_s + delay_s) & (imu.time_s <= end_s - delay_s)
    if imu.valid is not None:
        inside &= imu.valid
    return windows_of(dataclasses.replace(imu, valid=inside))


def _of_axes(windows: RotationWindows) -> Doubt | None:
    doubt = likeliest_axes(windows)
    return doubt if doubt.evidence < windows.least(AXES_IN_DOUBT) else None


def likeliest_axes(windows: RotationWindows) -> Doubt:
    """The axes with which the gyro rotates as gravity does in the accelerometer's axes."""
    signs = [np.array(one)[:, None] for one in itertools.product((1, -1), repeat=3)]
    orders = map(np.array, itertools.permutations(np.eye(3)))
    changes = [sign * order for order in orders for sign in signs]
    seen = windows.evidence(np.array(changes)).tolist()
    best, *others = sorted(zip(seen, range(len(changes)), strict=True))
    gaps = [(value - best[0], changes[at]) for value, at in others if value < 0.0]
    near = tuple(one for one in gaps if one[0] < NEARLY_AS_LIKELY)
    return Doubt(best[0], changes[best[1]], near)


def turns_gravity(imu: ImuLog) -> bool:
    """Whether the rate turns gravity, so that the accelerometer bears witness to it."""
    return windows_of(imu).turn_rad() > LEAST_TURN_RAD


def unseen_turn_rad(imu: ImuLog) -> float:
    """The largest turn of gravity that the gyro of a log does not show, if it is sure."""
    turns_rad = np.sort(windows_of(imu, WINDOWS_FOR_GRAVITY).unseen_turns_rad())
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
    windows = windows_of(imu, WINDOWS_FOR_GRAVITY)
    return dead if windows.unseen_turns_rad().max() > TURNS_UNSEEN_RAD else []


class _Explained(NamedTuple):
    """What a rotation leaves of the velocity.

    Attributes:
        left_mps2: (...) mean square of the velocity that nothing explains.
        seen: (..., B, K, 3) specific force times duration in a frame that does not rotate.
    """

    left_mps2: Floats
    seen: Floats


def _explained(impulse: Floats, angle: Floats, step_s: Floats) -> _Explained:
    """Explain the velocity in windows by linear least squares.

    Each window has a velocity at its beginning, gravity of any direction, and a velocity
    along its own axes, as a vehicle that turns. All share a gyro bias and an arm at which
    the sensor turns. Gravity's norm and the others have priors.

    Args:
        impulse: (B, K, 3) specific force times duration of the steps.
        angle: (..., B, K, 3) of the steps, by the gyro.
        step_s: (B, K, 1).
    """
    bias = np.zeros((*angle.shape[:-3], 3))
    design, velocity, seen = _equations(impulse, angle, step_s)
    _, more = _solved(design, velocity, seen, bias)
    size = np.linalg.norm(more, axis=-1, keepdims=True)
    # a large one is not linear
    bias = more * np.minimum(1.0, LARGEST_BIAS_STEP_RADPS / (size + 1e-9))
    turns = angle - bias[..., None, None, :] * step_s
    design, velocity, seen = _equations(impulse, turns, step_s)
    left, _ = _solved(design, velocity, seen, bias)
    return _Explained(left, seen)


def _equations(
    impulse: Floats, turns: Floats, step_s: Floats
) -> tuple[Floats, Floats, Floats]:
    """The design (..., B, 3 R, 15), velocity (..., B, 3 R, 1), impulse seen (..., B, K, 3)."""
    steps, batch = impulse.shape[1], turns.shape[:-2]
    kept = np.linspace(0, steps - 1, min(RESIDUALS, steps)).astype(int)
    ends = quat.chained(quat.from_rotation_vector(turns))
    attitude = quat.multiply(ends, quat.from_rotation_vector(-0.5 * turns))
    seen = quat.rotate(attitude, impulse)
    axes = quat.rotate(
        attitude[..., None, :], np.eye(3)
    )  # (..., K, 3, 3), one in a row
    tilts = np.cumsum(axes * step_s[..., None], axis=-3)
    by_bias = np.cumsum(np.cross(tilts, seen[..., None, :]), axis=-3)[..., kept, :, :]
    rate = turns / step_s
    rate = 0.5 * (rate[..., kept, :] + rate[..., np.minimum(kept + 1, steps - 1), :])
    last = ends[..., kept, None, :]
    ahead = quat.rotate(last, np.eye(3))
    by_arm = quat.rotate(last, np.cross(rate[..., None, :], np.eye(3)))
    time_s = np.cumsum(step_s, axis=1)[:, kept, :, None]
    unit = np.broadcast_to(np.eye(3), ahead.shape)
    columns = [unit, time_s * unit, ahead, by_bias, by_arm]
    design = np.concatenate([one.swapaxes(-1, -2) for one in columns], axis=-1)
    velocity = np.cumsum(seen, axis=-2)[..., kept, :]
    rows = (*batch, 3 * len(kept))
    return design.reshape(*rows, 15), velocity.reshape(*rows, 1), seen


def _solved(
    design: Floats, velocity: Floats, seen: Floats, bias: Floats
) -> tuple[Floats, Floats]:
    """The mean square that is left, (...), and by how much the bias is larger."""
    own, shared, ahead = slice(9), slice(9, 15), np.arange(6, 9)
    transposed = design.swapaxes(-1, -2)
    normal, right = transposed @ design, transposed @ velocity
    normal[..., ahead, ahead] += (VELOCITY_SIGMA_MPS / VEHICLE_SIGMA_MPS) ** 2
    sigma = np.repeat([GYRO_BIAS_SIGMA_RADPS, ARM_SIGMA_M], 3)
    prior = (VELOCITY_SIGMA_MPS / sigma) ** 2
    known = np.concatenate([bias, np.zeros_like(bias)], axis=-1)[..., None]
    weight = (VELOCITY_SIGMA_MPS / GRAVITY_SIGMA_MPS2) ** 2
    gravity, x = seen.sum(axis=-2), np.zeros_like(right)
    for _ in range(3):  # the prior of the norm is linear along the last direction
        down = _unit(gravity)[..., None]
        a, b = normal.copy(), right.copy()
        a[..., 3:6, 3:6] += weight * down * down.swapaxes(-1, -2)
        b[..., 3:6, :] += weight * STANDARD_GRAVITY_MPS2 * down
        across = a[..., own, shared]
        solved = np.linalg.solve(
            a[..., own, own], np.concatenate([across, b[..., own, :]], axis=-1)
        )
        reduced = across.swapaxes(-1, -2) @ solved
        both = (a[..., shared, shared] - reduced[..., :6]).sum(axis=-3)
        alone = (b[..., shared, :] - reduced[..., 6:]).sum(axis=-3)
        found = np.linalg.solve(both + np.diag(prior), alone - prior[:, None] * known)[
            ..., None, :, :
        ]
        x[..., shared, :] = found
        x[..., own, :] = solved[..., 6:] - solved[..., :6] @ found
        gravity = x[..., 3:6, 0]
    by_norm = np.linalg.norm(gravity, axis=-1) - STANDARD_GRAVITY_MPS2
    by_speed = np.square(x[..., ahead, 0] / VEHICLE_SIGMA_MPS).sum(axis=-1)
    misfit = np.square(velocity - design @ x).sum(axis=(-1, -2))
    cost = (misfit + weight * by_norm**2 + by_speed).mean(axis=-1)
    return np.asarray(cost * 3.0 / design.shape[-2]), x[..., 0, 9:12, 0]


def _unit(vectors: Floats) -> Floats:
    norm = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.maximum(norm, 1e-9))
