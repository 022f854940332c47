"""The stages of the smoother by compiled loops: what `stages` calls where they exist.

Each takes and returns what its counterpart in numpy does; records that the loops share
come along in PackedWindows and PackedNodes.
"""

import functools
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother import jit, kernels, means_kernel, solver_kernel
from hapticplayer.motion.smoother.calibrated import (
    Problem,
    Solution,
    inseparable,
    with_best_calibration,
)
from hapticplayer.motion.smoother.linearise import (
    DOUBTFUL_MPS2,
    LOST_RADPS,
    Knowledge,
    expected,
)
from hapticplayer.motion.smoother.nodes import AnyNodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.strapdown import (
    CHUNK,
    AnyWindows,
    Samples,
    calm_chunks,
)
from hapticplayer.motion.smoother.travel import TRAVEL


@dataclass(frozen=True, slots=True, eq=False)
class PackedWindows(AnyWindows):
    """Windows as the records that the loops share; see `kernels.integrate`."""

    orientations: NDArray[Any]
    rotations: NDArray[Any]
    rows: NDArray[Any]


@dataclass(frozen=True, slots=True, eq=False)
class PackedNodes(AnyNodes):
    """Nodes as the records that the loops share; see `kernels.gather`."""

    starts: NDArray[Any]
    ends: NDArray[Any]
    rows: NDArray[Any]
    levers: Floats


# The axes of the sensor, and no bias.
_UNCHANGED = np.eye(4, 3)


def _ready(values: Floats) -> Floats:
    return np.ascontiguousarray(values, dtype=np.float64)


def _records(table: NDArray[Any], row: np.dtype[Any]) -> NDArray[Any]:
    """Return the rows of a contiguous table (n, columns) as records in its memory."""
    return np.frombuffer(table, row)


def integrate(
    samples: Samples,
    per_window: int,
    bias_radps: Floats,
    matrix: Floats,
    *,
    shortcuts: bool = True,
) -> PackedWindows:
    """Return the windows of some samples; see `strapdown.integrate`."""
    total = -(-len(samples) // per_window)
    chunk = max(1, CHUNK // per_window)
    calm = np.zeros(-(-total // chunk), dtype=np.bool_)
    if shortcuts and not samples.averaged:
        calm = calm_chunks(samples, per_window, bias_radps)
    calibration = _UNCHANGED.copy()
    if matrix.any():
        calibration[:3] = np.linalg.inv(np.eye(3) + matrix)
    calibration[3] = bias_radps
    orientations = np.empty((total, per_window), jit.PAIR)
    rotations, rows = np.empty(total, jit.PAIR), np.empty(total, jit.WINDOW)
    kernels.integrate(
        _ready(samples.step_s),
        _records(_ready(samples.specific_force_mps2), jit.XYZ),
        _records(_ready(samples.angular_rate_radps), jit.XYZ),
        _ready(samples.lost_s),
        _ready(samples.doubt_s),
        _records(calibration, jit.XYZ),
        samples.gain,
        samples.averaged,
        calm,
        chunk,
        orientations,
        rotations,
        rows,
    )
    return PackedWindows(
        duration_s=rows["duration"],
        lost_s=rows["lost"],
        orientations=orientations,
        rotations=rotations,
        rows=rows,
    )


def coarse(samples: Samples, per_window: int) -> Samples:
    """Return means over windows; see `strapdown.coarse`."""
    if per_window == 1:
        return samples
    total = -(-len(samples) // per_window)
    spent = np.empty((3, total))
    force, rate = np.empty((total, 3)), np.empty((total, 3))
    means_kernel.coarse(
        _ready(samples.step_s),
        _records(_ready(samples.specific_force_mps2), jit.XYZ),
        _records(_ready(samples.angular_rate_radps), jit.XYZ),
        _ready(samples.lost_s),
        _ready(samples.doubt_s),
        per_window,
        spent,
        _records(force, jit.XYZ),
        _records(rate, jit.XYZ),
    )
    return Samples(
        step_s=spent[0],
        specific_force_mps2=force,
        angular_rate_radps=rate,
        averaged=True,
        lost_s=spent[1],
        doubt_s=spent[2],
        gain=samples.gain,
        usual_step_s=per_window * samples.interval_s,
    )


def gather(
    windows: PackedWindows, per_node: int, *, with_scale: bool = True
) -> PackedNodes:
    """Return the nodes of some windows; see `nodes.gather`."""
    total = len(windows.rows)
    count = -(-total // per_node)
    starts, ends = np.empty(total, jit.PAIR), np.empty(count + 1, jit.PAIR)
    rows = np.zeros(count, jit.NODE)
    levers = np.zeros((count, 3, 3, 4 if with_scale else 1))
    kernels.gather(
        *(windows.rotations, windows.rows, per_node),
        *(starts, ends, rows, levers, _UNCHANGED[:3].copy()),
    )
    return PackedNodes(
        per_node=per_node,
        at=(ends["first"], ends["second"]),
        duration_s=rows["duration"].copy(),
        impulse_mps=rows.view(np.float64).reshape(count, -1).T[:3],
        turned_rad=rows["turned"],
        lost_s=rows["lost"],
        doubt_s=rows["doubt"],
        starts=starts,
        ends=ends,
        rows=rows,
        levers=levers,
    )


def linearised(
    nodes: PackedNodes, vertical: Floats, known: Knowledge, p: SmootherParameters
) -> tuple[Pair, Problem]:
    """Return level frames and the problem in them; see `linearise.linearised`."""
    count, columns = len(nodes.rows), 1 + len(known.applied)
    columns += TRAVEL if known.may_travel else 0
    frames, rows = np.empty(count + 1, jit.PAIR), np.zeros((count, 5, columns))
    weights, bound_weight = np.empty((2, count)), np.zeros(count + 1)
    noises = _noises(
        p.rate_noise_rad_per_sqrt_s,
        p.rotation_error,
        p.force_noise_mps_per_sqrt_s,
        p.force_error,
    )
    kernels.linearise(
        _records(_ready(vertical.T), jit.XYZ),
        nodes.rows,
        nodes.levers,
        nodes.ends,
        _ready(known.bound_mps),
        noises,
        1 + len(known.applied),
        frames,
        rows,
        weights,
        bound_weight,
    )
    prior, prior_weight = expected(known, p)
    problem = Problem(
        duration_s=nodes.duration_s,
        rows=rows,
        tilt_weight=weights[0],
        velocity_weight=weights[1],
        bound_weight=bound_weight,
        rest_weight=known.rest_weight,
        prior=prior,
        prior_weight=prior_weight,
    )
    return (frames["first"], frames["second"]), problem


@functools.lru_cache
def _noises(
    rate_rad_per_sqrt_s: float,
    rotation_error: float,
    force_mps_per_sqrt_s: float,
    force_error: float,
) -> NDArray[Any]:
    """Return what `kernels.linearise` knows of noises, (1,)."""
    deviations = (
        *(rate_rad_per_sqrt_s, rotation_error, LOST_RADPS),
        *(force_mps_per_sqrt_s, force_error, DOUBTFUL_MPS2),
    )
    squared = [STANDARD_GRAVITY_MPS2, *(one * one for one in deviations)]
    return np.array(squared).view(jit.NOISE)


def minimise(problem: Problem) -> Solution:
    """Return tilt, velocity and calibration; see `calibrated.minimise`."""
    count, _, columns = problem.rows.shape
    rows, left = problem.rows.reshape(count, -1), np.empty((count, 5 * columns))
    nodes = np.empty((2 * count + 5, 2 * columns))
    band = np.empty(2 * count + 5, jit.BAND)
    if not solver_kernel.solve(rows, left, columns, *_weights(problem), band, nodes):
        raise inseparable()
    # each interval has five rows, and each node tilt x, y and velocity x, y
    normal = rows.reshape(-1, columns).T.dot(left.reshape(-1, columns))
    states = nodes[:-3].reshape(-1, columns)
    return with_best_calibration(states, normal, problem.prior, problem.prior_weight)


def _weights(problem: Problem) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Return durations and weights as `solver_kernel` takes them."""
    return (
        _ready(problem.duration_s),
        _ready(problem.tilt_weight),
        _ready(problem.velocity_weight),
        _ready(problem.rest_weight),
        _ready(problem.bound_weight),
    )


def tilt_variances(problem: Problem, chosen: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt at some nodes; see `uncertainty`."""
    band = np.empty(2 * len(problem.bound_weight) + 3, jit.BAND)
    variances = np.empty(len(chosen))
    if not solver_kernel.tilt_variances(*_weights(problem), chosen, band, variances):
        raise inseparable()
    return variances


def rotate(rotation: Pair, vector: Floats, *, inverse: bool = False) -> Floats:
    """Return vectors (3, n) turned by rotations (n,) or back; see `rotations`."""
    out = np.empty((vector.shape[1], 3))
    kernels.rotate(*rotation, vector, inverse, _records(out, jit.XYZ))
    return out.T


def mean_square(vectors: Floats, duration_s: Floats, half_width_s: float) -> Floats:
    """Return the mean over the nodes within some time; see `linearise.mean_square`."""
    out = np.empty(vectors.shape[1])
    scratch = np.zeros(len(out) + 1, jit.SUMS)
    means_kernel.mean_square(vectors, _ready(duration_s), half_width_s, scratch, out)
    return out


def spread(
    tilt: Floats,
    frames: Pair,
    share: Floats,
    strapped: tuple[PackedWindows, PackedNodes],
    samples: Samples,
    bias_radps: Floats,
) -> tuple[Floats, Floats]:
    """Return orientation (n, 4) and vertical (n, 3); see `stages.at_samples`."""
    windows, nodes = strapped
    count = len(samples)
    orientation, vertical = np.empty((count, 4)), np.empty((count, 3))
    level = np.empty(len(frames[0]), jit.PAIR)
    level["first"], level["second"] = frames
    kernels.spread(
        _ready(tilt),
        level,
        share,
        nodes.starts,
        windows.orientations,
        windows.rotations,
        _ready(samples.lost_s),
        _ready(samples.step_s),
        _records(_ready(samples.angular_rate_radps), jit.XYZ),
        _ready(bias_radps).view(jit.XYZ),
        samples.averaged,
        np.empty(len(nodes.starts) + len(level), jit.PAIR),
        _records(orientation, jit.PAIR),
        _records(vertical, jit.XYZ),
    )
    orientation.setflags(write=False)
    return orientation, vertical
