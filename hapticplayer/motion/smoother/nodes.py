"""From windows to nodes, and the frames that the nodes live in."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.strapdown import Windows

# A window that turns further needs the exact mean of its orientations: the mean of both
# ends is off by a twelfth of the squared turn.
FAST_WINDOW_TURN_RAD2 = 1.0
# Cosine of the angle up to which one frame serves all verticals.
MIN_SHARED_FRAME_COSINE = 0.5
# An impulse that is smaller has no direction: a node at 1 g has 7 m/s.
MIN_IMPULSE_MPS = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Nodes:
    """What happens between neighbouring nodes, in the almost inertial frame I.

    Frame I is the one in which the open-loop strapdown integration of the block
    starts: it does not rotate but for the gyro's errors.

    Attributes:
        per_node: windows between two nodes.
        start: orientation of each window's start in frame I, (windows,).
        at: orientation at the nodes in frame I, (K + 1,).
        duration_s: (K,).
        impulse_mps: (3, K) integral of the specific force.
        bias_turn_s: (3, 3, K) rotation of frame I per unit of gyro bias; the same
            matrix takes an accelerometer bias to an impulse.
        matrix_turn_rad: (3, 9, K) rotation per unit of each element of the gyro's
            error matrix (row by row); (3, 0, K) where not wanted.
        power_m2ps3: (K,) of the specific force about its mean in frame I.
        turned_rad: (K,) the angles of the windows, summed.
        lost_s: (K,) time in which the rotation is unknown.
        doubt_s: (K,) time in which the specific force is unknown.
    """

    per_node: int
    start: Pair
    at: Pair
    duration_s: Floats
    impulse_mps: Floats
    bias_turn_s: Floats
    matrix_turn_rad: Floats
    power_m2ps3: Floats
    turned_rad: Floats
    lost_s: Floats
    doubt_s: Floats


def gather(windows: Windows, per_node: int, *, with_matrix: bool = True) -> Nodes:
    """Return the nodes of some windows; the last interval may be shorter."""
    count = len(windows.duration_s)
    total = -(-count // per_node)
    ends = rot.unit(rot.cumulative(windows.rotation))
    start = rot.before(ends)
    R = rot.matrices(start)
    turn2 = rot.squared_norm(windows.turn_rad)
    rows = np.array(
        [
            *np.einsum("ijn,jn->in", R, windows.impulse_mps),
            windows.duration_s,
            windows.power_m2ps3,
            np.sqrt(turn2),
            windows.lost_s,
            windows.doubt_s,
        ]
    )
    sums = np.add.reduceat(rows, np.arange(0, count, per_node), axis=1)
    impulse, (duration, power, turned, lost, doubt) = sums[:3], sums[3:]
    mean_power = rot.squared_norm(impulse) / np.maximum(duration, 1e-9)
    if turn2.max() < FAST_WINDOW_TURN_RAD2:
        # the mean over a window, to second order, is that of its start and the next
        # one's; biases are small, so their leverage needs no more
        R[..., :-1] += R[..., 1:]
        R[..., :-1] *= 0.5
    else:
        R = np.einsum("ijn,jkn->ikn", R, rot.mean_matrices(windows.turn_rad))
    levers = _levers(R, windows, per_node, with_matrix=with_matrix)
    return Nodes(
        per_node=per_node,
        start=start,
        at=_at_nodes(ends, per_node),
        duration_s=duration,
        impulse_mps=impulse,
        bias_turn_s=levers[..., 0].T.reshape(3, 3, total),
        matrix_turn_rad=levers[..., 1:].reshape(total, 3, -1).transpose(1, 2, 0),
        power_m2ps3=np.maximum(power - mean_power, 0.0),
        turned_rad=turned,
        lost_s=lost,
        doubt_s=doubt,
    )


def _levers(
    mean: Floats, windows: Windows, per_node: int, *, with_matrix: bool
) -> Floats:
    """Return sums (K, 9, 1 or 4) of mean orientations times duration and turn."""
    by = [windows.duration_s[None]]
    if with_matrix:
        by.append(windows.turn_rad)
    rows = np.concatenate([mean.reshape(9, -1), *by])
    short = -rows.shape[1] % per_node
    if short:
        rows = np.concatenate([rows, np.zeros((len(rows), short))], axis=1)
    rows = rows.reshape(len(rows), -1, per_node)
    levers = np.matmul(rows[:9].swapaxes(0, 1), rows[9:].transpose(1, 2, 0))
    return np.asarray(levers)


def _at_nodes(ends: Pair, per_node: int) -> Pair:
    """Return the identity, then the orientation at the end of each interval."""
    tail = -1 if len(ends[0]) % per_node else len(ends[0])
    found = [
        np.concatenate([[first], part[per_node - 1 :: per_node], part[tail:]])
        for part, first in zip(ends, (1.0 + 0.0j, 0.0j), strict=True)
    ]
    return found[0], found[1]


def rough_vertical(nodes: Nodes, half_width_s: float) -> Floats:
    """Return unit verticals in frame I at the nodes (3, K + 1).

    The direction of the mean specific force over some seconds around each node.
    """
    count = len(nodes.duration_s)
    total, time_s = np.zeros((3, count + 1)), np.zeros(count + 1)
    np.cumsum(nodes.impulse_mps, axis=1, out=total[:, 1:])
    np.cumsum(nodes.duration_s, out=time_s[1:])
    first = np.searchsorted(time_s, time_s - half_width_s, side="left")
    last = np.searchsorted(time_s, time_s + half_width_s, side="right") - 1
    vectors = total[:, last] - total[:, first]
    norm = np.sqrt(rot.squared_norm(vectors))
    known = norm > MIN_IMPULSE_MPS
    if not known.any():
        return np.tile([[0.0], [0.0], [1.0]], len(norm))
    # without a direction, that of the node before, or of the first that has one
    chosen = np.maximum.accumulate(np.where(known, np.arange(len(norm)), -1))
    chosen[chosen < 0] = int(np.argmax(known))
    return np.asarray(vectors[:, chosen] / norm[chosen])


def level_frames(vertical: Floats) -> Pair:
    """Return the rotations from frame I to level frames at the nodes (K + 1,).

    Each takes its vertical to z by way of the first one, by the smallest rotation.
    Where the vertical wanders far from the first, this would end at a singular
    attitude; then it goes from node to node instead.
    """
    first = vertical[:, :1]
    to_z = rot.shortest(first, np.array([[0.0], [0.0], [1.0]]))
    if rot.dot(vertical, first).min() > MIN_SHARED_FRAME_COSINE:
        return rot.multiply(to_z, rot.shortest(vertical, first))
    steps = rot.shortest(vertical[:, 1:], vertical[:, :-1])
    steps = np.append(to_z[0], steps[0]), np.append(to_z[1], steps[1])
    return rot.unit(rot.cumulative(steps))


def vertical_of(tilt: Floats) -> Floats:
    """Return the unit vertical (3, n) of a tilt (2, n)."""
    vectors = np.empty((3, tilt.shape[1]))
    vectors[:2], vectors[2] = tilt, 1.0
    vectors /= np.sqrt(1.0 + rot.squared_norm(tilt))
    return vectors


def refined(values: Floats, count: int) -> Floats:
    """Return values (..., K + 1) for so many nodes, half as far apart."""
    out, last = np.empty((*values.shape[:-1], count)), count - 1
    out[..., :last:2], out[..., last] = values[..., :-1], values[..., -1]
    pairs = out[..., : last - 1 : 2], out[..., 2 : last + 1 : 2]
    np.multiply(0.5, pairs[0] + pairs[1], out=out[..., 1:last:2])
    return out


def window_starts(
    tilt: Floats,
    frames: Pair,
    windows: Windows,
    nodes: Nodes,
    rate_noise_rad_per_sqrt_s: float,
) -> Pair:
    """Return the orientation of each window's start, sensor to earth.

    Between nodes the correction is interpolated, not by time but by variance: a jump
    belongs into the gap that caused it.

    Args:
        tilt: (2, K + 1) in the level frames.
        frames: (K + 1,) from frame I to the level frames.
        windows: of the block.
        nodes: of the same.
        rate_noise_rad_per_sqrt_s: of the gyro; matters to gaps only.
    """
    z = np.zeros((3, tilt.shape[1]))
    z[2] = 1.0
    level = rot.multiply(rot.shortest(vertical_of(tilt), z), frames)
    share = _shares(windows, nodes, rate_noise_rad_per_sqrt_s)
    first, second = (
        (part[:-1, None] + share * (part[1:] - part[:-1])[:, None]).reshape(-1)
        for part in level
    )
    total = len(windows.duration_s)
    return rot.unit(rot.multiply((first[:total], second[:total]), nodes.start))


def _shares(windows: Windows, nodes: Nodes, rate_noise: float) -> Floats:
    """Return how far each window's start is from node to node, (1 or K, per node)."""
    if not windows.lost_s.any():
        return np.arange(nodes.per_node)[None] / nodes.per_node
    noise = rate_noise**2 * windows.duration_s + windows.lost_s**2
    total = len(nodes.duration_s) * nodes.per_node
    noise = np.append(noise, np.zeros(total - len(noise)))
    noise = noise.reshape(-1, nodes.per_node)
    before = np.cumsum(noise, axis=1) - noise
    return np.asarray(before / noise.sum(axis=1, keepdims=True))
