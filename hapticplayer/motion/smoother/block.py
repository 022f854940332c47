"""Orientation of one block, from all of it.

Strapdown integration at the full rate over windows of 1/16 s, then a least-squares
smoother on nodes 0.75 s apart that bounds the velocity and calibrates gyro and
accelerometer (`least_squares`). The first solution, on windows twice as long and about
a rough vertical, gives the velocity, the kind of motion and the gyro's bias; the second
is about the first and uses them; more follow only while they change much.
"""

from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.medians import median
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother import stationary, strapdown, vehicle
from hapticplayer.motion.smoother.gyro_trust import (
    GyroTrust,
    gyro_trust,
    with_gyro_trust,
)
from hapticplayer.motion.smoother.least_squares import (
    ACCEL_BIAS,
    ACCEL_SCALE,
    ALL_COLUMNS,
    BIAS_COLUMNS,
    GYRO_BIAS,
    GYRO_MATRIX,
    Problem,
    Solution,
    minimise,
    with_prior,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.problem import Knowledge, linearised, velocity_bound
from hapticplayer.motion.smoother.samples import InertialSamples, at_middles
from hapticplayer.motion.smoother.stationary import Flags, StillBins
from hapticplayer.motion.smoother.uncertainty import (
    NOISE_SHARE,
    BoundExcess,
    tilt_variance,
)
from hapticplayer.motion.smoother.vehicle import (
    BODY_VELOCITY_COLUMNS,
    Locomotion,
)

# Prior weight of a calibration that is not to be changed.
FIXED_WEIGHT = 1e12
# A still interval that is accelerated by more in the solution is not at rest.
REST_ACCEL_LIMIT_MPS2 = 0.15
# Below this mean rotation rate the gyro's matrix is not solved for.
MATRIX_RATE_RADPS = 0.05
# Error of the vertical per turn within a sample.
TURN_ERROR = 0.04
# Median turn within a sample that doubles the rotation error (at 15 Hz on hands three
# times the error is best), and the most and the least that is added: even rotation
# loses little.
LOSSY_TURN_RAD, MAX_TURN_LOSS, MIN_TURN_LOSS = 0.18, 4.0, 0.01
# A vehicle is solved for on coarse windows until the bias moves by less.
COARSE_BIAS_CHANGE_RADPS = 0.005
# A wider bias prior is kept if it lowers the RMS velocity to this share.
KEPT_VELOCITY_SHARE = 0.75
# Nodes of stationary recordings are so much further apart.
STATIONARY_NODE_FACTOR = 2.0
# A block has so many windows at least.
MIN_WINDOWS = 8
# Below this mean rotation rate the gyro is not judged: vehicles and cyclists stay below
# 0.23, hands, people on foot and heads on bikes above 0.36.
JUDGED_RATE_RADPS = 0.3
# Solutions with a gyro that is trusted less, each about the one before.
TRUST_SOLUTIONS = 2
# Windows of so few samples, or that turn further, need no first solution on means.
FEW_SAMPLES, MAX_COARSE_TURN_RAD = 2, 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """What was found about the sensor of a block.

    Attributes:
        gyro_bias_radps: (3,).
        accelerometer_bias_mps2: (3,).
        accelerometer_scale: the accelerometer reads so much times the specific force.
        accelerometer_scale_sigma: standard deviation of that.
        time_constant_s: of the levelling that was used, at the nodes.
        vehicle_weight: 0 to 1; see `vehicle`.
        gyro_noise_factor: the gyro is so many times noisier than usual; 1 or more.
    """

    gyro_bias_radps: Floats
    accelerometer_bias_mps2: Floats
    accelerometer_scale: float
    accelerometer_scale_sigma: float
    time_constant_s: Floats
    vehicle_weight: float
    gyro_noise_factor: float


@dataclass(frozen=True, slots=True, eq=False)
class Smoothed:
    """The result for one block.

    Attributes:
        quaternion_wxyz: (n, 4) sensor to earth at each sample.
        vertical: (n, 3) up in the sensor frame; for averaged samples its mean over
            their time.
        sigma_rad: (n,) standard deviation of the tilt, both axes together.
        at_rest: (n,) still samples that are not accelerated in the solution.
        calibration: of the sensor.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats
    at_rest: Flags
    calibration: Calibration


def smooth(
    samples: InertialSamples,
    bins: StillBins | None,
    p: SmootherParameters,
    *,
    with_sigma: bool = True,
) -> Smoothed:
    """Return the orientation of one block of at least two samples.

    Args:
        samples: of the block.
        bins: where it is still, or None.
        p: settings.
        with_sigma: whether the uncertainty is wanted; it is 0 otherwise.
    """
    count = len(samples)
    factor = stationary.decimation_of(bins, count, samples.interval_s)
    if bins is None or factor == 1 or not p.shortcuts:
        return _smoothed(samples, bins, p, with_sigma=with_sigma)
    sparse = replace(p, node_samples=1, node_s=STATIONARY_NODE_FACTOR * p.node_s)
    done = _smoothed(
        samples.averages(factor),
        bins.decimated(factor, count),
        sparse,
        with_sigma=with_sigma,
    )
    rows = np.concatenate(
        [
            stationary.with_one_sign(done.quaternion_wxyz),
            done.vertical,
            done.sigma_rad[:, None],
        ],
        axis=1,
    )
    rows = stationary.interpolated(rows, factor, count, averaged=samples.averaged)
    norm = np.linalg.norm(rows[:, :4], axis=1, keepdims=True)
    return replace(
        done,
        quaternion_wxyz=rows[:, :4] / norm,
        vertical=rows[:, 4:7].copy(),
        sigma_rad=rows[:, 7].copy(),
        at_rest=np.repeat(done.at_rest, factor)[:count],
    )


def _smoothed(
    samples: InertialSamples,
    bins: StillBins | None,
    p: SmootherParameters,
    *,
    with_sigma: bool,
) -> Smoothed:
    step_s = samples.interval_s
    per_window = max(1, round(1.0 / (p.window_hz * step_s)))
    per_window = min(per_window, max(1, len(samples) // MIN_WINDOWS))
    node_s = max(p.node_s, p.node_samples * step_s)
    # even, because the first solution has nodes twice as far apart
    per_node = 2 * max(1, round(0.5 * node_s / (per_window * step_s)))
    block = _Block(samples, (per_window, per_node), bins, p)
    while block.refine():
        pass
    block.judge_gyro()
    block.apply_time_constant()
    return block.result(with_sigma=with_sigma)


class _Block:
    """One block, and what has been found about it so far."""

    _frames: Pair
    _problem: Problem
    _solution: Solution

    def __init__(
        self,
        samples: InertialSamples,
        grid: tuple[int, int],
        bins: StillBins | None,
        p: SmootherParameters,
    ) -> None:
        self._bins, self._p = bins, p
        self._per_window, self._per_node = grid
        self._bias_prior = stationary.gyro_bias_prior(bins, p)
        self._calibration = np.zeros(ALL_COLUMNS)
        self._calibration[GYRO_BIAS] = self._bias_prior[0]
        # slow logs have few samples to a node: for them coarser windows save nothing
        self._fine = grid[0] <= FEW_SAMPLES or _turns_fast(samples, grid[0])
        if not self._fine:
            self._coarse = at_middles(
                samples.averages(2 * grid[0]), self._bias_prior[0]
            )
        self._samples = samples = at_middles(samples, self._bias_prior[0])
        self._integrate()
        nodes = self._nodes
        usual_radps = median(nodes.turned_rad / nodes.duration_s)
        self._p = p = _with_turn_loss(p, usual_radps * samples.interval_s)
        vertical = nd.rough_vertical(nodes, p.vertical_half_width_s)
        self._bound = np.full(vertical.shape[1], p.first_bound_mps)
        self._weight = np.zeros(len(nodes.duration_s))
        # with columns for a vehicle's velocity, which have no prior at first
        self._has_body_velocity, self._motion = True, Locomotion()
        self._solutions = 0
        self._trust: GyroTrust | None = None
        self._solve(vertical, BIAS_COLUMNS)
        self._retry_with_wider_bias()
        velocity_mps = self._solution.velocity_mps[:, vehicle.undisturbed(self._nodes)]
        self._motion = vehicle.locomotion_of(velocity_mps, self._turn_radps())
        self._has_body_velocity = self._motion.moving_weight > 0.0
        if self._has_body_velocity:
            prior = self._problem.prior, self._problem.prior_weight
            prior = vehicle.with_body_velocity(*prior, self._motion.body_sigma_mps)
            self._solution = with_prior(self._solution, *prior)

    def refine(self) -> bool:
        """Re-linearise and solve again; False if that would change little."""
        p, motion, solution = self._p, self._motion, self._solution
        bound = velocity_bound(solution.velocity_mps, self._nodes.duration_s, motion, p)
        moved_radps = float(np.abs(solution.calibration[GYRO_BIAS]).max())
        bias_moved = moved_radps > p.bias_change_of_radps(motion.heading_weight)
        weight = self._zero_velocity_weight()
        weights_change = self._changes_much(weight)
        is_vehicle = motion.heading_weight > 0.0
        limit = p.most_solutions(weights_change=weights_change, is_vehicle=is_vehicle)
        is_first = self._solutions == 1  # knew nothing of the velocity
        bound_moved = is_first or _mean_change(bound, self._bound) > p.bound_change
        again = self._solutions < limit and (
            bias_moved or bound_moved or weights_change
        )
        if not again and self._fine and not self._widen_bias_prior():
            return False
        # a solution for the bias leaves the bound as it is, so that the result does
        # not depend on whether there is one more
        if bound_moved or weights_change:
            self._bound = bound
        vertical = self._vertical()
        # the first solution of a vehicle is not worth an integration
        if (bias_moved or not self._fine) and not (is_first and is_vehicle):
            coarse = is_vehicle and moved_radps > COARSE_BIAS_CHANGE_RADPS
            fine = self._fine or not coarse or self._solutions >= limit - 1
            vertical = self._reintegrate(vertical, fine=fine)
            weight = self._zero_velocity_weight()
        self._weight = weight
        self._solve(vertical, self._columns())
        return True

    def judge_gyro(self) -> None:
        """Trust the gyro less where the recording shows that it is noisier.

        It shows in what moves and turns; elsewhere the gyro's errors do little.
        """
        motion, p = self._motion, self._p
        turns_little = self._turn_radps() < JUDGED_RATE_RADPS
        moves = vehicle.moves(self._solution.velocity_mps) and motion.moving_weight
        if turns_little or not moves or p.time_constant_s is not None:
            return
        body = slice(-BODY_VELOCITY_COLUMNS, None)  # there, because it moves
        trust = gyro_trust(self._problem, self._solution, body, p)
        if trust is None:
            return
        self._trust = trust
        self._bound = np.full_like(self._bound, trust.bound_mps(p))
        for _ in range(TRUST_SOLUTIONS):
            problem = self._linearised(self._vertical(), self._solved_columns)
            self._problem = with_gyro_trust(problem, trust, p)
            self._solution = minimise(self._problem)

    def apply_time_constant(self) -> None:
        """Use the time constant that a person chose, with the calibration found.

        Solved for together, too short a one would put the motion into the calibration.
        """
        bound_mps = self._p.fixed_bound_mps
        if bound_mps is None:
            return
        found = self._solution.calibration
        self._bound = np.full_like(self._bound, bound_mps)
        problem = self._linearised(self._vertical(), self._solved_columns)
        fixed = np.full(len(found), FIXED_WEIGHT)
        self._problem = replace(problem, prior=found, prior_weight=fixed)
        self._solution = minimise(self._problem)

    def result(self, *, with_sigma: bool) -> Smoothed:
        """Return the orientation at each sample, and its uncertainty."""
        solution, count = self._solution, len(self._samples)
        at_rest = self._at_rest()
        tilt = stationary.levelled_at_rest(self._problem, solution, at_rest)
        calibration = self._calibration_found()
        gyro_bias_radps = calibration.gyro_bias_radps
        start = nd.window_starts(
            *(tilt, self._frames, self._windows, self._nodes),
            self._p.rate_noise_rad_per_sqrt_s,
        )
        quaternion, vertical = strapdown.spread(
            start, self._windows, self._samples, gyro_bias_radps
        )
        per_node = self._per_window * self._per_node
        return Smoothed(
            quaternion_wxyz=quaternion,
            vertical=vertical,
            sigma_rad=self._sigma(gyro_bias_radps, tilt)
            if with_sigma
            else np.zeros(count),
            at_rest=np.repeat(at_rest, per_node)[:count],
            calibration=calibration,
        )

    def _calibration_found(self) -> Calibration:
        solution, columns = self._solution, self._solved_columns
        total = self._calibration.copy()
        total[:columns] += solution.calibration[:columns]
        unit = np.zeros((len(solution.calibration), 1))
        unit[ACCEL_SCALE] = 1.0
        variance = solution.covariance_times(unit)[ACCEL_SCALE, 0]
        return Calibration(
            gyro_bias_radps=total[GYRO_BIAS],
            accelerometer_bias_mps2=total[ACCEL_BIAS],
            accelerometer_scale=1.0 + float(total[ACCEL_SCALE]),
            accelerometer_scale_sigma=float(np.sqrt(variance)),
            time_constant_s=self._p.time_constant_of_s(self._bound),
            vehicle_weight=self._motion.vehicle_weight,
            gyro_noise_factor=self._trust.noise_factor if self._trust else 1.0,
        )

    def _sigma(self, gyro_bias_radps: Floats, tilt: Floats) -> Floats:
        """Return the standard deviation of the tilt at each sample, rad."""
        noise_share = NOISE_SHARE if self._trust is None else 1.0
        variance = tilt_variance(
            *(self._problem, self._solution, gyro_bias_radps, self._excess(), self._p),
            noise_share=noise_share,
        )
        per_node = self._per_window * self._per_node
        variance += _turning_variance(self._nodes.turned_rad / per_node)
        # at rest the accelerometer's bias is taken for tilt, so that nothing is felt
        variance += rot.squared_norm(tilt - self._solution.tilt)
        # two unrelated directions are 90 degrees apart
        sigma = np.sqrt(np.minimum(variance, 2.0))
        share = np.arange(per_node) / per_node
        at_samples = sigma[:-1, None] + share * np.diff(sigma)[:, None]
        return np.asarray(at_samples.reshape(-1)[: len(self._samples)])

    def _excess(self) -> BoundExcess:
        """Return by how much the bound is wider than one for the velocity found."""
        if not self._motion.moving_weight:
            return BoundExcess(np.ones_like(self._bound))
        found = velocity_bound(
            self._solution.velocity_mps, self._nodes.duration_s, Locomotion(), self._p
        )
        factor = np.maximum(self._bound / found, 1.0)
        return BoundExcess(factor, self._motion.vehicle_weight)

    def _integrate(self) -> None:
        """Integrate with the calibration so far."""
        fine = self._fine
        self._windows = strapdown.integrate(
            self._samples if fine else self._coarse,
            self._per_window if fine else 1,
            self._calibration[GYRO_BIAS],
            self._calibration[GYRO_MATRIX].reshape(3, 3),
        )
        self._nodes = nd.gather(self._windows, self._per_node, with_matrix=fine)
        count = len(self._nodes.duration_s)
        self._still = np.zeros(count, dtype=np.bool_)
        if self._bins is not None:
            per_node = self._per_window * self._per_node * (1 if fine else 2)
            edges = per_node * np.arange(count + 1)
            edges[-1] = len(self._samples)
            self._still = stationary.still_intervals(self._bins, edges)

    def _reintegrate(self, vertical: Floats, *, fine: bool) -> Floats:
        """Integrate with what was found; return the vertical in the new frame I."""
        total = self._calibration.copy()
        columns = self._solved_columns
        total[:columns] += self._solution.calibration[:columns]
        # the accelerometer is solved for in full each time
        total[ACCEL_BIAS] = total[ACCEL_SCALE] = 0.0
        self._calibration = total
        sensor = rot.rotate(rot.inverse(self._nodes.at), vertical)
        is_same, self._fine = self._fine == fine, fine
        self._integrate()
        at = self._nodes.at
        if is_same:
            return rot.rotate(at, sensor)
        last = len(at[0]) - 1
        shared = 2 * np.arange(sensor.shape[1])
        shared[-1] = last
        known = rot.rotate((at[0][shared], at[1][shared]), sensor)
        self._bound = nd.refined(self._bound, last + 1)
        vertical = nd.refined(known, last + 1)
        vertical /= np.sqrt(rot.squared_norm(vertical))
        return vertical

    def _retry_with_wider_bias(self) -> None:
        """Solve again with a wider prior of the gyro's bias, where it is an outlier.

        Kept if the RMS velocity drops by a quarter.
        """
        before, velocity_mps = dict(vars(self)), self._solution.velocity_mps
        if not self._widen_bias_prior():
            return
        self._solve(self._reintegrate(self._vertical(), fine=self._fine), BIAS_COLUMNS)
        self._solutions = 1
        left_mps = vehicle.rms_mps(self._solution.velocity_mps)
        if left_mps > KEPT_VELOCITY_SHARE * vehicle.rms_mps(velocity_mps):
            vars(self).update(before)

    def _widen_bias_prior(self) -> bool:
        """Widen the prior of the gyro's bias if an outlier is found; whether it was."""
        found = self._calibration[GYRO_BIAS] + self._solution.calibration[GYRO_BIAS]
        sigma = stationary.widened_bias_sigma(self._bins, found, self._p)
        if sigma <= self._bias_prior[1]:
            return False
        self._bias_prior = self._bias_prior[0], sigma
        return True

    def _vertical(self) -> Floats:
        """Return the vertical of the last solution in frame I, (3, K + 1)."""
        up = nd.vertical_of(self._solution.tilt)
        return rot.rotate(rot.inverse(self._frames), up)

    def _solve(self, vertical: Floats, columns: int) -> None:
        self._problem = self._linearised(vertical, columns)
        self._solution = minimise(self._problem)
        self._solved_columns = columns
        self._solved_s = self._nodes.duration_s
        self._solutions += 1

    def _linearised(self, vertical: Floats, columns: int) -> Problem:
        known = Knowledge(
            self._bound,
            self._weight,
            self._calibration[:columns],
            *self._bias_prior,
            self._has_body_velocity,
            self._motion.body_sigma_mps,
        )
        self._frames = nd.level_frames(vertical)
        return linearised(self._nodes, vertical, self._frames, known, self._p)

    def _columns(self) -> int:
        """Return how many columns of the calibration to solve for.

        Where little turns, the gyro's scale and alignment move nothing; coarse windows
        do not show them.
        """
        turns_little = self._p.shortcuts and self._turn_radps() < MATRIX_RATE_RADPS
        return BIAS_COLUMNS if turns_little or not self._fine else ALL_COLUMNS

    def _turn_radps(self) -> float:
        """Return the mean rotation rate."""
        nodes = self._nodes
        return float(nodes.turned_rad.sum() / nodes.duration_s.sum())

    def _apparent_mps2(self) -> Floats:
        return stationary.apparent_acceleration(
            self._solution.velocity_mps, self._solved_s, self._nodes.duration_s
        )

    def _at_rest(self) -> Flags:
        """Return which still intervals are not accelerated in the solution, (K,)."""
        if self._bins is None:
            return self._still
        return np.asarray(self._still & (self._apparent_mps2() < REST_ACCEL_LIMIT_MPS2))

    def _zero_velocity_weight(self) -> Floats:
        """Return the weights of the still intervals after this solution."""
        duration_s = self._nodes.duration_s
        if self._bins is None:
            return np.zeros(len(duration_s))
        return stationary.zero_velocity_weight(
            self._still, duration_s, self._apparent_mps2(), self._p
        )

    def _changes_much(self, weight: Floats) -> bool:
        """Return whether zero-velocity weights differ much from those solved with."""
        if self._bins is None:
            return False
        if self._solutions == 1:
            return bool(weight.any())
        used = weight > 0.0
        if not used.any():
            return False
        before = np.maximum(self._weight[used], 1e-12)
        return _mean_change(weight[used], before) > self._p.weight_change


def _turning_variance(turn_rad: Floats) -> Floats:
    """Return the variance by turns (K,) within a sample, at the nodes, rad^2."""
    at = np.empty(len(turn_rad) + 1)
    at[0], at[-1] = turn_rad[0], turn_rad[-1]
    at[1:-1] = 0.5 * (turn_rad[1:] + turn_rad[:-1])
    return np.asarray(np.square(TURN_ERROR * at))


def _mean_change(now: Floats, before: Floats) -> float:
    """Return the mean change of positive values either way, natural logarithm."""
    return float(np.abs(np.log(now / before)).sum()) / len(now)


def _turns_fast(samples: InertialSamples, per_window: int) -> bool:
    """Return whether means over two windows are too coarse for the rotation."""
    rate = samples.angular_rate_radps
    fastest = max(float(rate.max()), -float(rate.min()))
    turn_rad = 2 * per_window * fastest * samples.interval_s
    return bool(turn_rad > MAX_COARSE_TURN_RAD)


def _with_turn_loss(p: SmootherParameters, turn_rad: float) -> SmootherParameters:
    """Return the settings for a sensor that turns so far within the usual sample.

    The rotation lost there would pass for a velocity, and the bound would follow it.
    """
    loss = min((turn_rad / LOSSY_TURN_RAD) ** 4, MAX_TURN_LOSS)
    if loss < MIN_TURN_LOSS:
        return p
    return replace(p, rotation_error=p.rotation_error * (1.0 + loss))
