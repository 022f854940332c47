"""Orientation of one block, from all of it.

Strapdown integration at the full rate over windows of 1/16 s, then a least-squares
smoother on nodes 0.75 s apart that bounds the velocity and calibrates gyro and
accelerometer (`least_squares`). The first solution, on windows twice as long and about
a rough vertical, gives the velocity, the kind of motion and the gyro's bias; the second
is about the first and uses them; more follow only while they change much.
"""

import functools
from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother import stationary, strapdown, vehicle
from hapticplayer.motion.smoother.evidence import (
    WIDE_GYRO_SCALE_SIGMA,
    gyro_noise_factor,
    shows_scale_error,
)
from hapticplayer.motion.smoother.least_squares import (
    ACCEL_BIAS,
    ACCEL_SCALE,
    BIAS_COLUMNS,
    GYRO_BIAS,
    GYRO_SCALE,
    with_prior,
)
from hapticplayer.motion.smoother.mixture import (
    MIN_WEIGHT,
    NOISY_GYRO_FACTOR,
    mixed,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.problem import Knowledge, velocity_bound
from hapticplayer.motion.smoother.samples import InertialSamples
from hapticplayer.motion.smoother.short_memory import SHORT_MEMORY_S, floor_under
from hapticplayer.motion.smoother.state import (
    Block,
    BlockState,
    Start,
    at_rest,
    columns_to_solve,
    prepare,
    reintegrate,
    solve,
    solve_again,
    zero_velocity_weight,
)
from hapticplayer.motion.smoother.stationary import Flags, StillBins
from hapticplayer.motion.smoother.uncertainty import sigma_rad
from hapticplayer.motion.smoother.vehicle import BODY_VELOCITY_COLUMNS

# Prior weight of a calibration that is not to be changed: a sigma of 1e-6.
FIXED_CALIBRATION_WEIGHT = 1e12
# A vehicle is solved for on coarse windows until the bias moves by less.
COARSE_BIAS_CHANGE_RADPS = 0.005
# A wider bias prior is kept if it lowers the RMS velocity to this share; kept always it
# costs 5 %.
KEPT_RMS_VELOCITY_RATIO = 0.75
# Nodes of stationary recordings are so much further apart.
STATIONARY_NODE_SPACING_RATIO = 2.0
# Below this mean rotation rate the gyro is not judged: vehicles and cyclists stay below
# 0.23, hands, people on foot and heads on bikes above 0.36. Half of it costs 2 %, twice
# of it 7 %.
MIN_JUDGED_RATE_RADPS = 0.3
# Solutions for the gyro's scale, each about the one before, at most; a change that calls
# for no other; and the largest scale error that is accepted: no data sheet allows more.
SCALE_SOLUTIONS, SETTLED_GYRO_SCALE_CHANGE, MAX_GYRO_SCALE_ERROR = 4, 0.003, 0.15


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """What was found about the sensor of a block.

    Attributes:
        gyro_bias_radps: (3,).
        gyro_bias_sigma_radps: (3,) standard deviation of that.
        accelerometer_bias_mps2: (3,).
        accelerometer_bias_sigma_mps2: (3,) standard deviation of that.
        accelerometer_scale: the accelerometer reads so much times the specific force.
        accelerometer_scale_sigma: standard deviation of that.
        time_constant_s: of the levelling that was used, at the nodes.
        vehicle_weight: 0 to 1; see `vehicle`.
        gyro_noise_factor: the gyro is so many times noisier than usual; 1 or more.
        gyro_scale: (3,) the gyro reads so many times the rate.
    """

    gyro_bias_radps: Floats
    gyro_bias_sigma_radps: Floats
    accelerometer_bias_mps2: Floats
    accelerometer_bias_sigma_mps2: Floats
    accelerometer_scale: float
    accelerometer_scale_sigma: float
    time_constant_s: Floats
    vehicle_weight: float
    gyro_noise_factor: float
    gyro_scale: Floats


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
    if bins is None or factor == 1:
        return _smoothed(samples, bins, p, with_sigma=with_sigma)
    sparse = replace(p, node_samples=1, node_s=STATIONARY_NODE_SPACING_RATIO * p.node_s)
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
    block, start = prepare(samples, bins, p)
    state = _with_motion(_first(block, start))
    while (found := _next(block, state)) is not None:
        state = found
    state = _with_gyro_scale(block, state)
    if block.is_short and block.p.time_constant_s is None:
        state = _with_plain_share(block, mixed(block, state))
    else:
        state = _with_time_constant(_with_floor(block, state), block.p)
    return _result(block, state, with_sigma=with_sigma)


def _first(block: Block, start: Start) -> BlockState:
    """Return the first solution, which knows nothing of the velocity.

    An outlier of the gyro's bias gets a wider prior, kept if the RMS velocity drops by
    a quarter.
    """
    known = Knowledge(
        bound_mps=start.bound_mps,
        zero_velocity_weight=np.zeros(len(start.bound_mps) - 1),
        applied=start.integration.applied[:BIAS_COLUMNS],
        bias_radps=block.bias_radps,
        bias_sigma_radps=stationary.gyro_bias_prior(block.bins, block.p)[1],
        gyro_scale_sigma=block.p.gyro_matrix_sigma,
        # with columns for a vehicle's velocity, which have no prior at first
        has_body_velocity=True,
        body_sigma_mps=0.0,
    )
    state = solve(start, known, block.p)
    sigma_radps = _widened_bias_sigma(block, state)
    if sigma_radps is None:
        return state
    is_fine = start.integration.is_fine
    start = reintegrate(block, state, start.bound_mps, is_fine=is_fine)
    known = replace(
        known,
        applied=start.integration.applied[:BIAS_COLUMNS],
        bias_sigma_radps=sigma_radps,
    )
    wider = solve(start, known, block.p)
    before_mps = vehicle.rms_mps(state.solution.velocity_mps)
    left_mps = vehicle.rms_mps(wider.solution.velocity_mps)
    return state if left_mps > KEPT_RMS_VELOCITY_RATIO * before_mps else wider


def _widened_bias_sigma(block: Block, state: BlockState) -> Floats | None:
    """Return a wider prior sigma of the gyro's bias if that is an outlier, else None."""
    found = state.calibration[GYRO_BIAS]
    sigma = stationary.widened_bias_sigma(block.bins, found, block.p)
    return sigma if np.any(sigma > state.known.bias_sigma_radps) else None


def _with_motion(state: BlockState) -> BlockState:
    """Return the first solution with what it tells of the kind of motion."""
    integration = state.integration
    undisturbed = vehicle.undisturbed(integration.nodes)
    velocity_mps = state.solution.velocity_mps[:, undisturbed]
    motion = vehicle.locomotion_of(velocity_mps, integration.turn_radps)
    has_body_velocity, solution = motion.moving_weight > 0.0, state.solution
    if has_body_velocity:
        prior = state.problem.prior, state.problem.prior_weight
        prior = vehicle.with_body_velocity(*prior, motion.body_sigma_mps)
        solution = with_prior(solution, *prior)
    known = replace(
        state.known,
        has_body_velocity=has_body_velocity,
        body_sigma_mps=motion.body_sigma_mps,
    )
    return replace(state, known=known, motion=motion, solution=solution)


def _next(block: Block, state: BlockState) -> BlockState | None:
    """Return another solution about the last; None if it would change little."""
    p, motion, solution, known = block.p, state.motion, state.solution, state.known
    integration = state.integration
    duration_s, is_fine = integration.nodes.duration_s, integration.is_fine
    bound_mps = velocity_bound(solution.velocity_mps, duration_s, motion, p)
    moved_radps = float(np.abs(solution.calibration[GYRO_BIAS]).max())
    bias_moved = moved_radps > p.bias_change_of_radps(motion.heading_weight)
    weight = zero_velocity_weight(block, state, integration)
    weights_change = _changes_much(block, state, weight)
    is_vehicle = motion.heading_weight > 0.0
    limit = p.most_solutions(weights_change=weights_change, is_vehicle=is_vehicle)
    is_first = state.solutions == 1  # knew nothing of the velocity
    bound_moved = is_first or _mean_change(bound_mps, known.bound_mps) > p.bound_change
    again = state.solutions < limit and (bias_moved or bound_moved or weights_change)
    bias_sigma_radps = known.bias_sigma_radps
    if not again and is_fine:
        wider_radps = _widened_bias_sigma(block, state)
        if wider_radps is None:
            return None
        bias_sigma_radps = wider_radps
    # a solution for the bias leaves the bound as it is, so that the result does
    # not depend on whether there is one more
    if not (bound_moved or weights_change):
        bound_mps = known.bound_mps
    # the first solution of a vehicle is not worth an integration
    if (bias_moved or not is_fine) and not (is_first and is_vehicle):
        coarse = is_vehicle and moved_radps > COARSE_BIAS_CHANGE_RADPS
        is_fine = is_fine or not coarse or state.solutions >= limit - 1
        start = reintegrate(block, state, bound_mps, is_fine=is_fine)
        weight = zero_velocity_weight(block, state, start.integration)
    else:
        start = Start(integration, state.vertical, bound_mps)
    columns = columns_to_solve(start.integration)
    known = replace(
        known,
        bound_mps=start.bound_mps,
        zero_velocity_weight=weight,
        applied=start.integration.applied[:columns],
        bias_sigma_radps=bias_sigma_radps,
    )
    found = solve(start, known, p)
    return replace(found, motion=motion, solutions=state.solutions + 1)


def _changes_much(block: Block, state: BlockState, weight: Floats) -> bool:
    """Return whether zero-velocity weights differ much from those solved with."""
    if block.bins is None:
        return False
    if state.solutions == 1:
        return bool(weight.any())
    used = weight > 0.0
    if not used.any():
        return False
    before = np.maximum(state.known.zero_velocity_weight[used], 1e-12)
    return _mean_change(weight[used], before) > block.p.weight_change


def _mean_change(now: Floats, before: Floats) -> float:
    """Return the mean change of positive values either way, natural logarithm."""
    return float(np.abs(np.log(now / before)).sum()) / len(now)


def _with_gyro_scale(block: Block, state: BlockState) -> BlockState:
    """Re-solve with a wide prior of the gyro's scale where the evidence asks for it.

    Kept if the RMS velocity drops by a quarter: a bias that changes and a rail look
    like a wrong scale, too, but it explains little of them.
    """
    if not shows_scale_error(state.problem, state.solution, block.p):
        return state
    known = replace(state.known, gyro_scale_sigma=WIDE_GYRO_SCALE_SIGMA)
    found = replace(state, known=known)
    for _ in range(SCALE_SOLUTIONS):
        last, found = found, _solved_again(block, found)
        moved = np.abs(found.calibration[GYRO_SCALE] - last.calibration[GYRO_SCALE])
        if moved.max() < SETTLED_GYRO_SCALE_CHANGE:
            break
    before_mps, left_mps = (
        vehicle.rms_mps(one.solution.velocity_mps) for one in (state, found)
    )
    is_possible = np.abs(found.calibration[GYRO_SCALE]).max() < MAX_GYRO_SCALE_ERROR
    explains = left_mps < KEPT_RMS_VELOCITY_RATIO * before_mps
    return found if is_possible and explains else state


def _solved_again(block: Block, state: BlockState) -> BlockState:
    """Return the next solution, integrated with the calibration of the last."""
    duration_s, p = state.integration.nodes.duration_s, block.p
    velocity_mps = state.solution.velocity_mps
    bound_mps = velocity_bound(velocity_mps, duration_s, state.motion, p)
    start = reintegrate(block, state, bound_mps, is_fine=True)
    known = replace(
        state.known,
        bound_mps=bound_mps,
        zero_velocity_weight=zero_velocity_weight(block, state, start.integration),
        applied=start.integration.applied[: len(state.known.applied)],
    )
    found = solve(start, known, p)
    return replace(found, motion=state.motion, solutions=state.solutions + 1)


def _with_floor(block: Block, state: BlockState) -> BlockState:
    """Put the plain estimate under the solution where the gyro is noisier than usual.

    It shows in what moves and turns; elsewhere the gyro's errors do little.
    """
    motion, solution, p = state.motion, state.solution, block.p
    turns_little = state.integration.turn_radps < MIN_JUDGED_RATE_RADPS
    moves = vehicle.moves(solution.velocity_mps) and motion.moving_weight
    if turns_little or not moves or p.time_constant_s is not None:
        return state
    body = slice(-BODY_VELOCITY_COLUMNS, None)  # there, because it moves
    factor = gyro_noise_factor(state.problem, solution, body, p)
    if factor == 1.0:
        return state
    return _floored(block, state, factor, 1.0)


def _with_plain_share(block: Block, state: BlockState) -> BlockState:
    """Put the plain estimate under a mixture as far as the gyro is noisy."""
    if state.mixture is None or state.mixture.noisy_share < MIN_WEIGHT:
        return state
    share = state.mixture.noisy_share
    return _floored(block, state, NOISY_GYRO_FACTOR if share > 0.5 else 1.0, share)


def _floored(
    block: Block, state: BlockState, noise_factor: float, share: float
) -> BlockState:
    """Return the solution with a share of the plain estimate under it."""
    nodes, tilt = state.integration.nodes, state.solution.tilt
    floor = floor_under(tilt, nodes, state.frames, noise_factor, block.p)
    # at rest the smoother's is level
    resting = np.concatenate([[False], at_rest(block, state), [False]])
    weight = np.where(resting[1:] | resting[:-1], 0.0, share * floor.weight)
    return replace(state, floor=replace(floor, weight=weight))


def _with_time_constant(state: BlockState, p: SmootherParameters) -> BlockState:
    """Use the time constant that a person chose, with the calibration found.

    Solved for together, too short a one would put the motion into the calibration.
    """
    bound_mps = p.fixed_bound_mps
    if bound_mps is None:
        return state
    found = state.solution.calibration
    fixed = np.full(len(found), FIXED_CALIBRATION_WEIGHT)
    adjusted = functools.partial(replace, prior=found, prior_weight=fixed)
    return solve_again(state, bound_mps, p, adjusted)


def _result(block: Block, state: BlockState, *, with_sigma: bool) -> Smoothed:
    """Return the orientation at each sample, and its uncertainty."""
    count, resting, floor = len(block.samples), at_rest(block, state), state.floor
    levelled = stationary.levelled_at_rest(state.problem, state.solution, resting)
    tilt = levelled if floor is None else floor.mixed(levelled, floor.tilt)
    calibration = _calibration(state, block.p)
    gyro_bias_radps = calibration.gyro_bias_radps
    windows, nodes = state.integration.windows, state.integration.nodes
    rate_noise = block.p.rate_noise_rad_per_sqrt_s
    start = nd.window_starts(tilt, state.frames, windows, nodes, rate_noise)
    quaternion, vertical = strapdown.spread(
        start, windows, block.samples, gyro_bias_radps
    )
    return Smoothed(
        quaternion_wxyz=quaternion,
        vertical=vertical,
        sigma_rad=sigma_rad(block, state, gyro_bias_radps, levelled)
        if with_sigma
        else np.zeros(count),
        at_rest=np.repeat(resting, block.samples_per_node)[:count],
        calibration=calibration,
    )


def _calibration(state: BlockState, p: SmootherParameters) -> Calibration:
    total, solution = state.calibration, state.solution
    unit = np.eye(len(solution.calibration), BIAS_COLUMNS)
    time_constant_s, noise_factor = p.time_constant_of_s(state.known.bound_mps), 1.0
    if state.mixture is not None:
        sigma = np.sqrt(state.mixture.calibration_variance[:BIAS_COLUMNS])
        time_constant_s = np.full_like(time_constant_s, state.mixture.time_constant_s)
    else:
        sigma = np.sqrt(np.diag(solution.covariance_times(unit)))
    if state.floor is not None:
        time_constant_s = state.floor.mixed(time_constant_s, SHORT_MEMORY_S)
        noise_factor = state.floor.noise_factor
    return Calibration(
        gyro_bias_radps=total[GYRO_BIAS],
        gyro_bias_sigma_radps=sigma[GYRO_BIAS],
        accelerometer_bias_mps2=total[ACCEL_BIAS],
        accelerometer_bias_sigma_mps2=sigma[ACCEL_BIAS],
        accelerometer_scale=1.0 + float(total[ACCEL_SCALE]),
        accelerometer_scale_sigma=float(sigma[ACCEL_SCALE]),
        time_constant_s=time_constant_s,
        vehicle_weight=state.motion.vehicle_weight,
        gyro_noise_factor=noise_factor,
        gyro_scale=1.0 + total[GYRO_SCALE],
    )
