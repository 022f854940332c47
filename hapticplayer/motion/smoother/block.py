"""Orientation of one block, from all of it.

Strapdown integration at the full rate over windows of 1/16 s, then a least-squares
smoother on nodes 0.75 s apart that holds the velocity bounded and calibrates
gyro and accelerometer on the way (`calibrated`). The first solution, on windows twice
as long and about a rough vertical, tells how fast the sensor moves and how wrong its
gyro is; the second is about the first and uses both; more follow only while they
change much.
"""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.medians import median
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother import rest as at_rest
from hapticplayer.motion.smoother import standing, strapdown, travel
from hapticplayer.motion.smoother.calibrated import (
    BIASES_ONLY,
    CALIBRATION,
    FORCE_BIAS,
    FORCE_SCALE,
    GYRO_BIAS,
    GYRO_MATRIX,
    Problem,
    Solution,
    again,
    covariance,
    minimise,
)
from hapticplayer.motion.smoother.linearise import Knowledge, linearised, velocity_bound
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.rest import Rest
from hapticplayer.motion.smoother.strapdown import Samples
from hapticplayer.motion.smoother.travel import Travel
from hapticplayer.motion.smoother.uncertainty import Wide, tilt_variance

# Weight of a calibration that is not to be changed.
_CERTAIN = 1e12
# A still span that seems to be accelerated by more is none.
_SEEMS_MPS2 = 0.15
# Below this mean rate the gyro's matrix is not looked for.
_TURNING_RADPS = 0.05
# Share of the turn within a sample by which the vertical may be off.
_TURN_ERROR = 0.04
# Median turn within a sample that doubles the error of the rotation (found on hands at
# 15 Hz, where three times the error is best), what is as good as none, and the most that
# is added: what spins evenly loses little.
_LOSING_TURN_RAD, _NO_LOSS, _MOST_LOSS = 0.18, 1.01, 4.0
# Of what is steered coarse windows are enough until the bias moves by less.
_ROUGHLY_RADPS = 0.005
# With so much left of the velocity, most of it was the motion's and not the gyro's.
_MOTION = 0.75
# The nodes of what stands still are so much further apart.
_WIDER = 2.0
# Even a short log has so many windows.
_WINDOWS = 8
# Windows of so few samples are not worth a first look at their means.
_FEW = 2
# A window that may turn further is not seen through its means.
_MEAN_TURN_RAD = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """What was found about the sensor of a block.

    Attributes:
        gyro_bias_radps: (3,).
        gyro_matrix: (3, 3) the gyro reads (1 + matrix) times the angular rate.
        accelerometer_bias_mps2: (3,).
        force_scale: the accelerometer reads 1 + so much times the specific force.
        factor: upper Cholesky factor of the information, see `Solution`.
        time_constant_s: of the levelling that was used, at the nodes.
        driven: how far it was taken for something that drives, 0 to 1; see `travel`.
    """

    gyro_bias_radps: Floats
    gyro_matrix: Floats
    accelerometer_bias_mps2: Floats
    force_scale: float
    factor: Floats
    time_constant_s: Floats
    driven: float

    @property
    def force_scale_sigma(self) -> float:
        """Standard deviation of `force_scale`."""
        return math.sqrt(covariance(self.factor)[FORCE_SCALE, FORCE_SCALE])


@dataclass(frozen=True, slots=True, eq=False)
class Smoothed:
    """The result for one block.

    Attributes:
        quaternion_wxyz: (n, 4) sensor to earth at each sample.
        vertical: (n, 3) up in the sensor frame; for averaged samples its mean over
            their time.
        sigma_rad: (n,) standard deviation of the tilt, both axes together.
        at_rest: (n,) still samples that were found to be so.
        calibration: of the sensor.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats
    at_rest: NDArray[np.bool_]
    calibration: Calibration


def smooth(
    samples: Samples,
    rest: Rest | None,
    p: SmootherParameters,
    *,
    with_sigma: bool = True,
) -> Smoothed:
    """Return the orientation of one block of at least two samples.

    Args:
        samples: of the block.
        rest: where it stands still, or None.
        p: settings.
        with_sigma: whether the uncertainty is wanted; it is 0 otherwise.
    """
    count = len(samples)
    parts = standing.samples_of_a_part(rest, count, samples.interval_s)
    if rest is None or parts == 1 or not p.shortcuts:
        return _smoothed(samples, rest, p, with_sigma=with_sigma)
    still = standing.in_parts(rest, parts, count)
    few = replace(p, node_samples=1, node_s=_WIDER * p.node_s)
    done = _smoothed(
        strapdown.coarse(samples, parts), still, few, with_sigma=with_sigma
    )
    place = (parts, count)
    averaged = samples.averaged
    sigma = done.sigma_rad[:, None]
    return replace(
        done,
        quaternion_wxyz=standing.orientation(
            done.quaternion_wxyz, *place, averaged=averaged
        ),
        vertical=standing.at_samples(done.vertical, *place, averaged=averaged),
        sigma_rad=standing.at_samples(sigma, *place, averaged=averaged)[:, 0],
        at_rest=np.repeat(done.at_rest, parts)[:count],
    )


def _smoothed(
    samples: Samples, rest: Rest | None, p: SmootherParameters, *, with_sigma: bool
) -> Smoothed:
    step_s = samples.interval_s
    most = max(1, len(samples) // _WINDOWS)  # of a moment not all is one window
    per_window = min(max(1, round(1.0 / (p.window_hz * step_s))), most)
    node_s = max(p.node_s, p.node_samples * step_s)
    # even, because the first solution has nodes twice as far apart
    per_node = 2 * max(1, round(0.5 * node_s / (per_window * step_s)))
    block = _Block(samples, (per_window, per_node), rest, p)
    while block.improve():
        pass
    block.obey()
    return block.result(with_sigma=with_sigma)


class _Block:
    """One block, and what has been found about it so far."""

    def __init__(
        self,
        samples: Samples,
        grid: tuple[int, int],
        rest: Rest | None,
        p: SmootherParameters,
    ) -> None:
        self._samples, self._rest, self._p = samples, rest, p
        self._frames: Pair
        self._problem: Problem
        self._solution: Solution
        self._per_window, self._per_node = grid
        self._expected = at_rest.expected_bias(rest, p)
        self._calibration = np.zeros(CALIBRATION)
        self._calibration[GYRO_BIAS] = self._expected[0]
        # slow logs have few samples to a node: for them coarser windows save nothing
        self._fine = self._per_window <= _FEW or _spins(samples, self._per_window)
        if self._fine:
            self._open(samples, self._per_window)
        else:
            self._coarse = strapdown.coarse(samples, 2 * self._per_window)
            self._open(self._coarse, 1)
        nodes = self._nodes
        usual_radps = median(nodes.turned_rad / nodes.duration_s)
        self._p = p = _less_certain(p, usual_radps * samples.interval_s)
        vertical = nd.rough_vertical(nodes, p.rough_s)
        self._bound = np.full(vertical.shape[1], p.velocity_start_mps)
        self._trusted = np.zeros(len(self._nodes.duration_s))
        # solved with columns for a velocity u, of which nothing is expected at first
        self._may_travel, self._travel = True, Travel()
        self._solutions = 0
        self._solve(vertical, BIASES_ONLY)
        self._suspect()
        velocity_mps = self._solution.velocity_mps[:, travel.undisturbed(self._nodes)]
        self._travel = travel.travel_of(velocity_mps, self._turn_radps())
        self._may_travel = self._travel.going > 0.0
        if self._may_travel:
            known = self._problem.prior, self._problem.prior_weight
            known = travel.travel_prior(*known, self._travel.expected_mps)
            self._solution = again(self._solution, *known)

    def improve(self) -> bool:
        """Solve once more about what was found; False if that would change little."""
        p, solution = self._p, self._solution
        bound = velocity_bound(solution, self._nodes.duration_s, self._travel, p)
        moved_radps = max(map(abs, solution.calibration[GYRO_BIAS].tolist()))
        moved = moved_radps > p.rebias_of_radps(self._travel.steered)
        weight = self._rest_weight()
        unrest = self._unrest(weight)
        limit = p.most_solutions(unrest=unrest, steered=self._travel.steered > 0.0)
        # the first solution knows nothing of how fast it moves
        faster = self._solutions == 1 or _mean_change(bound, self._bound) > p.rebound
        again = self._solutions < limit and (moved or faster or unrest)
        if not again and self._fine and not self._expect_more():
            return False
        # a solution for the gyro's sake shall not move the bound: whether there is one
        # may hang by a hair, and the bound that is there was good enough
        if faster or unrest:
            self._bound = bound
        vertical = self._vertical()
        # the first solution of what is steered is not worth an integration
        is_first = self._solutions == 1 and self._travel.steered > 0.0
        if (moved or not self._fine) and not is_first:
            rough = self._travel.steered and moved_radps > _ROUGHLY_RADPS
            fine = self._fine or not rough or self._solutions >= limit - 1
            vertical = self._integrate(vertical, fine=fine)
            weight = self._rest_weight()
        self._trusted = weight
        self._solve(vertical, self._columns())
        return True

    def _expect_more(self) -> bool:
        """Expect a larger bias if one is found that was not; whether that is so."""
        found = self._calibration[GYRO_BIAS] + self._solution.calibration[GYRO_BIAS]
        sigma = at_rest.widened(self._rest, found, self._p)
        if sigma <= self._expected[1]:
            return False
        self._expected = self._expected[0], sigma
        return True

    def _suspect(self) -> None:
        """Look once more where the gyro is off by more than was expected.

        If much of the velocity was its, that is where to start from.
        """
        before = {**vars(self), "_calibration": self._calibration.copy()}
        velocity_mps = self._solution.velocity_mps
        if not self._expect_more():
            return
        self._solve(self._integrate(self._vertical(), fine=self._fine), BIASES_ONLY)
        self._solutions = 1
        left_mps = travel.rms_mps(self._solution.velocity_mps)
        if left_mps > _MOTION * travel.rms_mps(velocity_mps):
            vars(self).update(before)

    def obey(self) -> None:
        """Use the time constant that a person chose, with the calibration found.

        A time constant that is too short for the motion would find it in there.
        """
        velocity_mps = self._p.fixed_velocity_mps
        if velocity_mps is None:
            return
        found = self._solution.calibration
        vertical = self._vertical()
        self._bound = np.full_like(self._bound, velocity_mps)
        problem = self._linearised(vertical, self._solved_columns)
        self._problem = replace(
            problem, prior=found, prior_weight=np.full(len(found), _CERTAIN)
        )
        self._solution = minimise(self._problem)

    def result(self, *, with_sigma: bool) -> Smoothed:
        """Return the orientation at each sample, and how certain it is."""
        solution, count = self._solution, len(self._samples)
        believed = self._believed()
        settled = at_rest.settled(self._problem, solution, believed)
        total = self._calibration.copy()
        total[: self._solved_columns] += solution.calibration[: self._solved_columns]
        constant_s = self._p.time_constant_of_s(self._bound)
        per_node = self._per_window * self._per_node
        quaternion, vertical = self._at_samples(settled, total[GYRO_BIAS])
        return Smoothed(
            quaternion_wxyz=quaternion,
            vertical=vertical,
            sigma_rad=self._sigma(total[GYRO_BIAS], settled)
            if with_sigma
            else np.zeros(count),
            at_rest=np.zeros(count, np.bool_)
            if self._rest is None
            else np.repeat(believed, per_node)[:count],
            calibration=Calibration(
                gyro_bias_radps=total[GYRO_BIAS],
                gyro_matrix=total[GYRO_MATRIX].reshape(3, 3),
                accelerometer_bias_mps2=total[FORCE_BIAS],
                force_scale=float(total[FORCE_SCALE]),
                factor=solution.factor,
                time_constant_s=constant_s,
                driven=self._travel.driven,
            ),
        )

    def _at_samples(
        self, tilt: Floats, gyro_bias_radps: Floats
    ) -> tuple[Floats, Floats]:
        """Return orientation (n, 4) and vertical (n, 3) for a tilt at the nodes."""
        windows, nodes = self._windows, self._nodes
        share = nd.shares(windows, nodes, self._p.rate_noise_rad_per_sqrt_s)
        level = nd.levelled(tilt, self._frames)
        start = rot.unit(rot.multiply(nd.between(level, share, windows), nodes.start))
        return strapdown.spread(start, windows, self._samples, gyro_bias_radps)

    def _sigma(self, gyro_bias_radps: Floats, settled: Floats) -> Floats:
        """Return the standard deviation of the tilt at each sample, rad."""
        variance = tilt_variance(
            self._problem, self._solution, gyro_bias_radps, self._wide(), self._p
        )
        per_node = self._per_window * self._per_node
        variance += _turning_variance(self._nodes.turned_rad / per_node)
        # at rest nothing shall be felt, so that the sensor's bias is taken for tilt
        variance += rot.squared_norm(settled - self._solution.tilt)
        # two directions that know nothing of each other are 90 degrees apart
        sigma = np.sqrt(np.minimum(variance, 2.0))
        share = np.arange(per_node) / per_node
        # straight lines as one product, because numpy is slow along short axes
        lines = np.array([1.0 - share, share])
        at_samples = np.array([sigma[:-1], sigma[1:]]).T @ lines
        return np.asarray(at_samples.reshape(-1)[: len(self._samples)])

    def _wide(self) -> Wide:
        """Return by how much the bound is wider than one for the velocity found."""
        if not self._travel.going:
            return Wide(np.ones_like(self._bound))
        duration_s = self._nodes.duration_s
        found = velocity_bound(self._solution, duration_s, Travel(), self._p)
        return Wide(np.maximum(self._bound / found, 1.0), self._travel.driven)

    def _open(self, samples: Samples, per_window: int) -> None:
        """Integrate with the calibration so far."""
        matrix = self._calibration[GYRO_MATRIX].reshape(3, 3)
        bias = self._calibration[GYRO_BIAS]
        self._windows = strapdown.integrate(
            samples, per_window, bias, matrix, shortcuts=self._p.shortcuts
        )
        self._nodes = nd.gather(self._windows, self._per_node, with_scale=self._fine)
        per_node = self._per_window * self._per_node * (1 if self._fine else 2)
        count = len(self._nodes.duration_s)
        self._resting = np.zeros(count, dtype=np.bool_)
        if self._rest is not None:
            edges = per_node * np.arange(count + 1)
            edges[-1] = len(self._samples)
            self._resting = at_rest.resting(self._rest, edges)

    def _integrate(self, vertical: Floats, *, fine: bool) -> Floats:
        """Integrate anew with what was found; return the vertical in the new frame."""
        change = self._solution.calibration[: self._solved_columns]
        self._calibration[: len(change)] += change
        # of the accelerometer everything is solved for in full each time
        self._calibration[FORCE_BIAS] = self._calibration[FORCE_SCALE] = 0.0
        sensor = rot.rotate(rot.inverse(self._nodes.at), vertical)
        is_same, self._fine = self._fine == fine, fine
        self._open(*((self._samples, self._per_window) if fine else (self._coarse, 1)))
        at = self._nodes.at
        if is_same:
            return rot.rotate(at, sensor)
        last = len(at[0]) - 1
        shared = 2 * np.arange(sensor.shape[1])
        shared[-1] = last
        known = rot.rotate((at[0][shared], at[1][shared]), sensor)
        self._bound = nd.finer(self._bound, last + 1)
        vertical = nd.finer(known, last + 1)
        vertical /= np.sqrt(rot.squared_norm(vertical))
        return vertical

    def _vertical(self) -> Floats:
        """Return the vertical of the last solution in frame I, (3, K + 1)."""
        up = nd.up(self._solution.tilt)
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
            self._trusted,
            self._calibration[:columns],
            *self._expected,
            self._may_travel,
            self._travel.expected_mps,
        )
        self._frames = nd.level_frames(vertical)
        return linearised(self._nodes, vertical, self._frames, known, self._p)

    def _columns(self) -> int:
        """Return how much of the calibration is worth solving for.

        Where little turns, the gyro's scale and alignment move nothing; coarse windows
        do not tell them.
        """
        is_still = self._p.shortcuts and self._turn_radps() < _TURNING_RADPS
        if is_still or not self._fine:
            return BIASES_ONLY
        return CALIBRATION

    def _turn_radps(self) -> float:
        """Return the mean speed of rotation."""
        nodes = self._nodes
        return float(nodes.turned_rad.sum() / nodes.duration_s.sum())

    def _believed(self) -> NDArray[np.bool_]:
        """Return which still intervals do not seem to be accelerated, (K,)."""
        if self._rest is None:
            return self._resting
        seems = at_rest.seeming_acceleration(
            self._solution, self._solved_s, self._nodes.duration_s
        )
        return np.asarray(self._resting & (seems < _SEEMS_MPS2))

    def _rest_weight(self) -> Floats:
        """Return how far the still spans are to be believed after this solution."""
        duration_s = self._nodes.duration_s
        if self._rest is None:
            return np.zeros(len(duration_s))
        seems = at_rest.seeming_acceleration(self._solution, self._solved_s, duration_s)
        return at_rest.rest_weight(self._resting, duration_s, seems, self._p)

    def _unrest(self, weight: Floats) -> bool:
        """Return whether still spans would be believed otherwise than they were."""
        if self._rest is None:
            return False
        if self._solutions == 1:
            return bool(weight.any())
        changed = weight > 0.0
        if not changed.any():
            return False
        before = np.maximum(self._trusted[changed], 1e-12)
        return _mean_change(weight[changed], before) > self._p.retrust


def _turning_variance(turn_rad: Floats) -> Floats:
    """Return what turns within a sample add to the variance, at the nodes, rad^2."""
    at = np.empty(len(turn_rad) + 1)
    at[0], at[-1] = turn_rad[0], turn_rad[-1]
    at[1:-1] = 0.5 * (turn_rad[1:] + turn_rad[:-1])
    return np.asarray(np.square(_TURN_ERROR * at))


def _mean_change(now: Floats, before: Floats) -> float:
    """Return the mean change of positive values either way, natural logarithm."""
    return float(np.abs(np.log(now / before)).sum()) / len(now)


def _spins(samples: Samples, per_window: int) -> bool:
    """Return whether the sensor turns so fast that window means say little."""
    rate = samples.angular_rate_radps
    fastest = max(float(rate.max()), -float(rate.min()))
    return bool(2 * per_window * fastest * samples.interval_s > _MEAN_TURN_RAD)


def _less_certain(p: SmootherParameters, turn_rad: float) -> SmootherParameters:
    """Return the settings for a sensor that turns so far within the usual sample.

    What is lost of the rotation there would pass for a velocity, and the bound follow.
    """
    loss = 1.0 + min((turn_rad / _LOSING_TURN_RAD) ** 4, _MOST_LOSS)
    if loss < _NO_LOSS:
        return p
    return replace(p, rotation_error=p.rotation_error * loss)
