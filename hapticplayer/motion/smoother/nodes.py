"""From windows to nodes a quarter of a second apart, and the frames they live in."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.strapdown import Windows

# A window that turns further needs the exact mean of its orientations.
_SLOW_RAD2 = 1.0
# Cosine of the angle up to which one frame serves all verticals.
_NEAR_FIRST = 0.5
# An impulse that is smaller has no direction.
_NOWHERE_MPS = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Nodes:
    """What happens between neighbouring nodes, in the almost inertial frame I.

    Frame I is the one in which the open-loop strapdown integration of the block
    starts: it stands still but for the gyro's errors.

    Attributes:
        per_node: windows between two nodes.
        at: orientation at the nodes in frame I, (K + 1,).
        duration_s: (K,).
        impulse_mps: (3, K) integral of the specific force.
        turned_rad: (K,) the angles of the windows, summed.
        lost_s: (K,) time without any knowledge of the rotation.
        doubt_s: (K,) time without trust in the specific force.
        start: orientation of each window's start in frame I, (windows,).
        bias_turn_s: (3, 3, K) rotation of frame I per unit of gyro bias; the same
            matrix takes an accelerometer bias to an impulse.
        scale_turn_rad: (3, 9, K) rotation per unit of each element of the gyro's
            error matrix (row by row).
        power_m2ps3: (K,) of the specific force about its mean in frame I.
    """

    per_node: int
    at: Pair
    duration_s: Floats
    impulse_mps: Floats
    turned_rad: Floats
    lost_s: Floats
    doubt_s: Floats
    start: Pair
    bias_turn_s: Floats
    scale_turn_rad: Floats
    power_m2ps3: Floats


def gather(windows: Windows, per_node: int, *, with_scale: bool = True) -> Nodes:
    """Return the nodes of some windows; the last interval may be shorter."""
    count = len(windows.duration_s)
    total = -(-count // per_node)
    ends = rot.unit(rot.cumulative(windows.rotation))
    start = rot.before(ends)

    def by_node(values: Floats) -> Floats:
        short = per_node * total - count
        if short:
            shape = (*values.shape[:-1], short)
            values = np.concatenate([values, np.zeros(shape)], axis=-1)
        return values.reshape(*values.shape[:-1], total, per_node)

    R = rot.matrices(start)
    impulse = by_node(np.einsum("ijn,jn->in", R, windows.impulse_mps)).sum(axis=-1)
    if rot.squared_norm(windows.turn_rad).max() < _SLOW_RAD2:
        # the mean over a window, to second order, is that of its start and the next
        # one's; biases are small, so their leverage needs no more
        R[..., :-1] += R[..., 1:]
        R[..., :-1] *= 0.5
    else:
        R = np.einsum("ijn,jkn->ikn", R, rot.mean_matrices(windows.turn_rad))
    middle = by_node(R.reshape(9, count)).swapaxes(0, 1)  # (K, 9, per node)
    length = by_node(windows.duration_s)
    # all leverages in one batched product: columns duration and turn x, y, z
    by = [length[None], by_node(windows.turn_rad)] if with_scale else [length[None]]
    both = np.matmul(middle, np.concatenate(by).transpose(1, 2, 0))
    duration = length.sum(axis=-1)
    power = by_node(windows.power_m2ps3).sum(axis=-1)
    mean_power = rot.squared_norm(impulse) / np.maximum(duration, 1e-9)
    turned = by_node(np.sqrt(rot.squared_norm(windows.turn_rad))).sum(axis=-1)
    return Nodes(
        per_node=per_node,
        start=start,
        at=_at_nodes(ends, per_node),
        duration_s=duration,
        impulse_mps=impulse,
        bias_turn_s=both[..., 0].T.reshape(3, 3, total),
        scale_turn_rad=both[..., 1:].reshape(total, 3, -1).transpose(1, 2, 0),
        power_m2ps3=np.maximum(power - mean_power, 0.0),
        turned_rad=turned,
        lost_s=by_node(windows.lost_s).sum(axis=-1),
        doubt_s=by_node(windows.doubt_s).sum(axis=-1),
    )


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
    return _directions(total[:, last] - total[:, first])


def _directions(vectors: Floats) -> Floats:
    """Return unit vectors; where there is none, the one before (or after)."""
    norm = np.sqrt(rot.squared_norm(vectors))
    if norm.min() > _NOWHERE_MPS:
        return np.asarray(vectors / norm)
    known = norm > _NOWHERE_MPS
    if not known.any():
        return np.tile([[0.0], [0.0], [1.0]], len(norm))
    last = np.maximum.accumulate(np.where(known, np.arange(len(norm)), -1))
    last = np.where(last < 0, int(np.argmax(known)), last)
    return np.asarray(vectors[:, last] / norm[last])


def level_frames(vertical: Floats) -> Pair:
    """Return the rotations from frame I to level frames at the nodes (K + 1,).

    Each takes its vertical to z by way of the first one, by the smallest rotation.
    Where the vertical wanders far from the first, this would end at a singular
    attitude; then it goes from node to node instead.
    """
    z = np.zeros((3, 1))
    z[2] = 1.0
    first = vertical[:, :1]
    to_z = rot.shortest(first, z)
    if rot.dot(vertical, first).min() > _NEAR_FIRST:
        return rot.multiply(to_z, rot.shortest(vertical, first))
    steps = rot.shortest(vertical[:, 1:], vertical[:, :-1])
    steps = np.append(to_z[0], steps[0]), np.append(to_z[1], steps[1])
    return rot.unit(rot.cumulative(steps))


def up(tilt: Floats) -> Floats:
    """Return the unit vertical (3, n) of a tilt (2, n)."""
    vectors = np.empty((3, tilt.shape[1]))
    vectors[:2], vectors[2] = tilt, 1.0
    vectors /= np.sqrt(1.0 + rot.squared_norm(tilt))
    return vectors


def levelled(tilt: Floats, frames: Pair) -> Pair:
    """Return the orientations of frame I over the earth for a tilt (2, K + 1)."""
    z = np.zeros((3, tilt.shape[1]))
    z[2] = 1.0
    return rot.unit(rot.multiply(rot.shortest(up(tilt), z), frames))


def finer(values: Floats, count: int) -> Floats:
    """Return values (..., K + 1) for so many nodes, half as far apart."""
    out, last = np.empty((*values.shape[:-1], count)), count - 1
    out[..., :last:2], out[..., last] = values[..., :-1], values[..., -1]
    pairs = out[..., : last - 1 : 2], out[..., 2 : last + 1 : 2]
    np.multiply(0.5, pairs[0] + pairs[1], out=out[..., 1:last:2])
    return out


def shares(windows: Windows, nodes: Nodes, rate_noise_rad_per_sqrt_s: float) -> Floats:
    """Return how far each window's start is from node to node, (1 or K, per node).

    Not by time but by variance: a jump belongs into the hole that hid it.
    """
    if not windows.lost_s.any():
        return np.arange(nodes.per_node)[None] / nodes.per_node
    noise = rate_noise_rad_per_sqrt_s**2 * windows.duration_s + windows.lost_s**2
    total = len(nodes.duration_s) * nodes.per_node
    noise = np.append(noise, np.zeros(total - len(noise)))
    noise = noise.reshape(-1, nodes.per_node)
    before = np.cumsum(noise, axis=1) - noise
    return np.asarray(before / noise.sum(axis=1, keepdims=True))


def between(level: Pair, share: Floats, windows: Windows) -> Pair:
    """Return the orientations at nodes (K + 1,), interpolated to windows' starts."""
    first, second = (
        (part[:-1, None] + share * (part[1:] - part[:-1])[:, None]).reshape(-1)
        for part in level
    )
    total = len(windows.duration_s)
    return first[:total], second[:total]
