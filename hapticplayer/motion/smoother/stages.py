"""The stages of the smoother, compiled where that is possible (see `compiled`)."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother import calibrated, compiled, linearise, strapdown
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother.calibrated import Problem, Solution
from hapticplayer.motion.smoother.linearise import Knowledge
from hapticplayer.motion.smoother.nodes import AnyNodes, Nodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.strapdown import (
    AnyWindows,
    Correction,
    Samples,
    Windows,
)


def opened(
    samples: Samples,
    grid: tuple[int, int],
    correction: Correction,
    *,
    with_scale: bool,
    shortcuts: bool,
) -> tuple[AnyWindows, AnyNodes]:
    """Return windows and nodes; see `strapdown.integrate` and `nodes.gather`.

    Args:
        samples: of one block.
        grid: samples of a window, windows between nodes.
        correction: of the gyro.
        with_scale: whether the gyro's matrix will be asked for.
        shortcuts: see SmootherParameters.
    """
    fast = compiled.fast()
    if fast is not None:
        windows = fast.integrate(samples, grid[0], *correction, shortcuts=shortcuts)
        return windows, fast.gather(windows, grid[1], with_scale=with_scale)
    windows = strapdown.integrate(samples, grid[0], *correction, shortcuts=shortcuts)
    return windows, nd.gather(windows, grid[1], with_scale=with_scale)


def coarse(samples: Samples, per_window: int) -> Samples:
    """Return means over windows; see `strapdown.coarse`."""
    fast = compiled.fast()
    found: Samples = (strapdown if fast is None else fast).coarse(samples, per_window)
    return found


def linearised(
    nodes: AnyNodes, vertical: Floats, known: Knowledge, p: SmootherParameters
) -> tuple[Pair, Problem]:
    """Return level frames about verticals (3, K + 1), and the problem in them."""
    fast = compiled.fast()
    if fast is not None and isinstance(nodes, fast.PackedNodes):
        found: tuple[Pair, Problem] = fast.linearised(nodes, vertical, known, p)
        return found
    assert isinstance(nodes, Nodes)
    frames = nd.level_frames(vertical)
    return frames, linearise.linearised(nodes, vertical, frames, known, p)


def minimise(problem: Problem) -> Solution:
    """Return tilt, velocity and calibration of least squares."""
    fast = compiled.fast()
    found: Solution = (calibrated if fast is None else fast).minimise(problem)
    return found


def tilt_variances(problem: Problem, chosen: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt at some nodes, for a known calibration."""
    fast = compiled.fast()
    if fast is not None:
        return np.asarray(fast.tilt_variances(problem, chosen))
    right = np.zeros((len(chosen), 2 * len(problem.bound_weight)))
    rows = np.arange(len(chosen))
    right[rows, 2 * chosen] = 1.0
    calibrated.solve_band(calibrated.horizontal_band(problem), right)
    return np.asarray(right[rows, 2 * chosen])


def rotated(rotation: Pair, vector: Floats, *, inverse: bool = False) -> Floats:
    """Return vectors (3, n) turned by rotations (n,), or back."""
    fast = compiled.fast()
    if fast is not None:
        return np.asarray(fast.rotate(rotation, vector, inverse=inverse))
    return rot.rotate(rot.inverse(rotation) if inverse else rotation, vector)


def at_samples(
    tilt: Floats,
    frames: Pair,
    strapped: tuple[AnyWindows, AnyNodes],
    samples: Samples,
    bias_radps: Floats,
    rate_noise_rad_per_sqrt_s: float,
) -> tuple[Floats, Floats]:
    """Return orientation (n, 4) and vertical (n, 3) at the samples.

    Args:
        tilt: (2, K + 1) in the level frames.
        frames: (K + 1,).
        strapped: windows and nodes.
        samples: of one block.
        bias_radps: (3,) of the gyro; matters to averaged samples only.
        rate_noise_rad_per_sqrt_s: of the gyro; matters to holes only.
    """
    windows, nodes = strapped
    share = nd.shares(windows, nodes, rate_noise_rad_per_sqrt_s)
    fast = compiled.fast()
    if fast is not None and isinstance(windows, fast.PackedWindows):
        strapped_down: tuple[Floats, Floats] = fast.spread(
            tilt, frames, share, strapped, samples, bias_radps
        )
        return strapped_down
    assert isinstance(windows, Windows)
    assert isinstance(nodes, Nodes)
    level = nd.levelled(tilt, frames)
    start = rot.unit(rot.multiply(nd.between(level, share, windows), nodes.start))
    return strapdown.spread(start, windows, samples, bias_radps)
