"""What is given of a block, and what has been found about it so far: frozen values.

Each step takes a value and returns a new one: `prepare` the block, `integrate` its
samples, `solve` about a vertical, and `reintegrate` with the calibration found.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother import stationary, strapdown
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
)
from hapticplayer.motion.smoother.parameters import MIN_BOUNDED_S, SmootherParameters
from hapticplayer.motion.smoother.problem import Knowledge, linearised
from hapticplayer.motion.smoother.samples import InertialSamples, at_middles
from hapticplayer.motion.smoother.short_memory import Floor
from hapticplayer.motion.smoother.stationary import Flags, StillBins
from hapticplayer.motion.smoother.vehicle import Locomotion

# Below this mean rotation rate the gyro's matrix is not solved for.
MIN_MATRIX_RATE_RADPS = 0.05
# A still interval that is accelerated by more in the solution is not at rest.
REST_ACCEL_LIMIT_MPS2 = 0.15
# Median turn within a sample that doubles the rotation error (at 15 Hz on hands three
# times the error is best), and the most and the least that is added: even rotation
# loses little. Half of the turn costs 2 %.
DOUBLING_SAMPLE_TURN_RAD, MAX_ADDED_ERROR_RATIO, MIN_ADDED_ERROR_RATIO = 0.18, 4.0, 0.01
# A block has so many windows at least.
MIN_BLOCK_WINDOWS = 8
# Windows of so few samples, or that turn further, need no first solution on means;
# twice that turn costs 3 %.
FEW_WINDOW_SAMPLES, MAX_COARSE_WINDOW_TURN_RAD = 2, 2.0
# Before the first solution.
UNKNOWN_MOTION = Locomotion()


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """What is given of a block.

    Attributes:
        samples: as seen in their middles.
        coarse: means over two windows for the first solution; None where the full
            rate is needed at once.
        per_window: samples of a window.
        per_node: windows between two nodes, an even number.
        bins: where it is still, or None.
        bias_radps: (3,) expected of the gyro.
        p: settings.
        is_short: whether it does not show the velocity that a bound would follow.
    """

    samples: InertialSamples
    coarse: InertialSamples | None
    per_window: int
    per_node: int
    bins: StillBins | None
    bias_radps: Floats
    p: SmootherParameters
    is_short: bool

    @property
    def samples_per_node(self) -> int:
        """Samples between two nodes at the full rate."""
        return self.per_window * self.per_node


@dataclass(frozen=True, slots=True, eq=False)
class Integration:
    """One strapdown integration of a block.

    Attributes:
        applied: (ALL_COLUMNS,) calibration that it was made with.
        is_fine: whether at the full rate, else of the coarse samples.
        windows: of the samples.
        nodes: of the windows.
        still: (K,) which intervals between nodes are still.
    """

    applied: Floats
    is_fine: bool
    windows: strapdown.Windows
    nodes: nd.Nodes
    still: Flags

    @property
    def turn_radps(self) -> float:
        """The mean rotation rate."""
        nodes = self.nodes
        return float(nodes.turned_rad.sum() / nodes.duration_s.sum())


@dataclass(frozen=True, slots=True, eq=False)
class Mixture:
    """What the mean over models says beside its solution.

    Attributes:
        variance: (K + 1,) of both tilts together, rad^2.
        calibration_variance: (C,).
        time_constant_s: of the levelling, the mean.
        noisy_share: probability of a gyro that is noisier than usual.
    """

    variance: Floats
    calibration_variance: Floats
    time_constant_s: float
    noisy_share: float


@dataclass(frozen=True, slots=True, eq=False)
class BlockState:
    """What has been found about a block so far.

    Attributes:
        integration: that was solved.
        known: what the solution assumed.
        frames: (K + 1,) from frame I to the level frames of the problem.
        problem: the last one.
        solution: of it.
        motion: how the sensor moves along.
        solutions: how many there have been.
        floor: the plain estimate, None where the gyro is as usual.
        mixture: of a short block.
    """

    integration: Integration
    known: Knowledge
    frames: Pair
    problem: Problem
    solution: Solution
    motion: Locomotion = UNKNOWN_MOTION
    solutions: int = 1
    floor: Floor | None = None
    mixture: Mixture | None = None

    @property
    def vertical(self) -> Floats:
        """The vertical of the solution in frame I, (3, K + 1)."""
        up = nd.vertical_of(self.solution.tilt)
        return rot.rotate(rot.inverse(self.frames), up)

    @property
    def calibration(self) -> Floats:
        """What was found in all, (ALL_COLUMNS,)."""
        total, columns = self.integration.applied.copy(), len(self.known.applied)
        total[:columns] += self.solution.calibration[:columns]
        return total


class Start(NamedTuple):
    """What a solution starts from.

    Attributes:
        integration: of the block.
        vertical: (3, K + 1) in its frame I.
        bound_mps: (K + 1,) on the velocity.
    """

    integration: Integration
    vertical: Floats
    bound_mps: Floats


def prepare(
    samples: InertialSamples, bins: StillBins | None, p: SmootherParameters
) -> tuple[Block, Start]:
    """Return a block and what its first solution starts from."""
    step_s = samples.interval_s
    per_window = max(1, round(1.0 / (p.window_hz * step_s)))
    per_window = min(per_window, max(1, len(samples) // MIN_BLOCK_WINDOWS))
    is_short = float(samples.step_s.sum()) < MIN_BOUNDED_S
    node_s = p.node_s if is_short else max(p.node_s, p.node_samples * step_s)
    # even, because the first solution has nodes twice as far apart
    per_node = 2 * max(1, round(0.5 * node_s / (per_window * step_s)))
    bias_radps, _ = stationary.gyro_bias_prior(bins, p)
    # slow logs have few samples to a node: for them coarser windows save nothing
    is_fine = per_window <= FEW_WINDOW_SAMPLES or _turns_fast(samples, per_window)
    coarse = (
        None if is_fine else at_middles(samples.averages(2 * per_window), bias_radps)
    )
    samples = at_middles(samples, bias_radps)
    block = Block(samples, coarse, per_window, per_node, bins, bias_radps, p, is_short)
    applied = np.zeros(ALL_COLUMNS)
    applied[GYRO_BIAS] = bias_radps
    integration = integrate(block, applied, is_fine=is_fine)
    nodes = integration.nodes
    usual_radps = float(np.median(nodes.turned_rad / nodes.duration_s))
    block = replace(block, p=_with_turn_loss(p, usual_radps * step_s))
    vertical = nd.rough_vertical(nodes, p.vertical_half_width_s)
    bound_mps = np.full(vertical.shape[1], p.first_bound_mps)
    return block, Start(integration, vertical, bound_mps)


def integrate(block: Block, applied: Floats, *, is_fine: bool) -> Integration:
    """Return the integration with a calibration (ALL_COLUMNS,)."""
    samples, per_window, halves = block.samples, block.per_window, 1
    if not is_fine and block.coarse is not None:
        samples, per_window, halves = block.coarse, 1, 2
    windows = strapdown.integrate(
        *(samples, per_window, applied[GYRO_BIAS], applied[GYRO_MATRIX].reshape(3, 3))
    )
    nodes = nd.gather(windows, block.per_node, with_matrix=is_fine)
    count = len(nodes.duration_s)
    still = np.zeros(count, dtype=np.bool_)
    if block.bins is not None:
        edges = halves * block.samples_per_node * np.arange(count + 1)
        edges[-1] = len(block.samples)
        still = stationary.still_intervals(block.bins, edges)
    return Integration(applied, is_fine, windows, nodes, still)


def solve(
    start: Start,
    known: Knowledge,
    p: SmootherParameters,
    adjusted: Callable[[Problem], Problem] | None = None,
) -> BlockState:
    """Return the first solution about a vertical.

    Args:
        start: where it starts.
        known: what it assumes.
        p: settings.
        adjusted: returns the problem that is solved in place of the usual one.
    """
    frames = nd.level_frames(start.vertical)
    nodes = start.integration.nodes
    problem = linearised(nodes, start.vertical, frames, known, p)
    if adjusted is not None:
        problem = adjusted(problem)
    return BlockState(start.integration, known, frames, problem, minimise(problem))


def solve_again(
    state: BlockState,
    bound_mps: float,
    p: SmootherParameters,
    adjusted: Callable[[Problem], Problem],
) -> BlockState:
    """Return the solution about the last one with one bound on the velocity throughout.

    Args:
        state: the last one.
        bound_mps: of the velocity.
        p: settings.
        adjusted: as for `solve`.
    """
    bounds_mps = np.full_like(state.known.bound_mps, bound_mps)
    known = replace(state.known, bound_mps=bounds_mps)
    start = Start(state.integration, state.vertical, bounds_mps)
    found = solve(start, known, p, adjusted)
    return replace(found, motion=state.motion, solutions=state.solutions)


def reintegrate(
    block: Block, state: BlockState, bound_mps: Floats, *, is_fine: bool
) -> Start:
    """Integrate with what was found, and return where the next solution starts.

    Args:
        block: the block.
        state: what was found.
        bound_mps: (K + 1,) for the next solution, at the nodes of this one.
        is_fine: whether at the full rate.
    """
    applied = state.calibration
    # the accelerometer is solved for in full each time
    applied[ACCEL_BIAS] = applied[ACCEL_SCALE] = 0.0
    before = state.integration
    sensor = rot.rotate(rot.inverse(before.nodes.at), state.vertical)
    integration = integrate(block, applied, is_fine=is_fine)
    at = integration.nodes.at
    if is_fine == before.is_fine:
        return Start(integration, rot.rotate(at, sensor), bound_mps)
    last = len(at[0]) - 1
    shared = 2 * np.arange(sensor.shape[1])
    shared[-1] = last
    known = rot.rotate((at[0][shared], at[1][shared]), sensor)
    vertical = nd.refined(known, last + 1)
    vertical /= np.sqrt(rot.squared_norm(vertical))
    return Start(integration, vertical, nd.refined(bound_mps, last + 1))


def columns_to_solve(integration: Integration) -> int:
    """Return how many columns of the calibration to solve for.

    Where little turns, the gyro's scale and alignment move nothing; coarse windows
    do not show them.
    """
    turns_little = integration.turn_radps < MIN_MATRIX_RATE_RADPS
    return BIAS_COLUMNS if turns_little or not integration.is_fine else ALL_COLUMNS


def at_rest(block: Block, state: BlockState) -> Flags:
    """Return which still intervals are not accelerated in the solution, (K,)."""
    still = state.integration.still
    if block.bins is None:
        return still
    apparent_mps2 = _apparent_mps2(state, state.integration)
    return np.asarray(still & (apparent_mps2 < REST_ACCEL_LIMIT_MPS2))


def zero_velocity_weight(
    block: Block, state: BlockState, integration: Integration
) -> Floats:
    """Return the weights of still intervals of an integration, after a solution."""
    duration_s = integration.nodes.duration_s
    if block.bins is None:
        return np.zeros(len(duration_s))
    apparent_mps2 = _apparent_mps2(state, integration)
    return stationary.zero_velocity_weight(
        integration.still, duration_s, apparent_mps2, block.p
    )


def _apparent_mps2(state: BlockState, integration: Integration) -> Floats:
    return stationary.apparent_acceleration(
        state.solution.velocity_mps,
        state.problem.duration_s,
        integration.nodes.duration_s,
    )


def _turns_fast(samples: InertialSamples, per_window: int) -> bool:
    """Return whether means over two windows are too coarse for the rotation."""
    rate = samples.angular_rate_radps
    fastest = max(float(rate.max()), -float(rate.min()))
    turn_rad = 2 * per_window * fastest * samples.interval_s
    return bool(turn_rad > MAX_COARSE_WINDOW_TURN_RAD)


def _with_turn_loss(p: SmootherParameters, turn_rad: float) -> SmootherParameters:
    """Return the settings for a sensor that turns so far within the usual sample.

    The rotation lost there would pass for a velocity, and the bound would follow it.
    """
    loss = min((turn_rad / DOUBLING_SAMPLE_TURN_RAD) ** 4, MAX_ADDED_ERROR_RATIO)
    if loss < MIN_ADDED_ERROR_RATIO:
        return p
    return replace(p, rotation_error=p.rotation_error * (1.0 + loss))
