"""Speed over the ground and climbing, in heights of the camera above it.

Points of a level ground lie at a distance that follows from how far below the horizon
they are, in units of the camera's height h: what the rotation leaves of their flow gives
the velocity divided by h. The horizon is where the direction of travel points, because
who rides or walks moves along the ground. What is fixed to the carrier (a dashboard, a
handlebar) does not move; it is found by cells that stay much slower than the rest.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.extras.frames.egomotion import AHEAD, egomotion, rotation_flow
from hapticplayer.extras.frames.watching import FEWEST, Seen, View
from hapticplayer.model.arrays import Floats

BIN_S = 0.5
"""Flow is gathered over spans of this length; memory grows by a bin of each."""

_BELOW = 0.06  # the horizon, at z = 1: nearer to it distances are not known
_LEAST_QUALITY = 0.1
_TRAVEL_MEMORY = 0.01  # share of the newest in the direction of travel
_CELL_MEMORY = 0.02  # and in the flow of each cell
_CARRIER_SHARE = 0.3  # of the speed, below which a cell belongs to the carrier
_SLOWEST = 0.02  # heights per frame, from which on carriers are looked for
_KNOWN = 0.01  # squared flow of unit speed, summed with memory
_GATHERED = 0.002  # for a running speed
_MOST_WEIGHT = 0.05  # of a cell
_MOST_FLOW = 0.5  # of a point, per frame
_FASTEST_SHARE, _SLOWER = 0.9, 0.3  # what is slower than the fastest is no ground
_FIXED_PX, _TURNED_PX = 0.5, 1.0  # what stays while the rotation would move it
_SOFT = 0.05  # distance from the direction of travel at which it loses meaning
_FEWEST_POINTS = 10
_SCALES_PX = (6.0, 4.0, 2.0, 1.0, 1.0, 0.7, 0.7)  # of the robust weight
_RIDGE = 1e-6
_SMOOTH_BINS = 2.0  # sigma over bins of the flow that makes the speed


class GroundMotion(NamedTuple):
    """From a frame to the next one.

    Attributes:
        begin_s: media time of the first frame.
        end_s: media time of the second one.
        turned_rad: about the vertical, to the left.
        sunk: (3,) heights by which the camera came down: by all points of the ground,
            and by either half of them.
        is_turn_known: whether enough is seen for the rotation.
        is_sunk_known: whether enough of the ground is seen, too.
    """

    begin_s: float
    end_s: float
    turned_rad: float
    sunk: Floats
    is_turn_known: bool
    is_sunk_known: bool


class Ground:
    """Takes what pairs of frames show, one after the other."""

    def __init__(self, view: View) -> None:
        self._view, self._travel = view, AHEAD
        self._flow, self._unit = np.zeros(view.cells), np.zeros(view.cells)
        self._per_frame = 0.0  # running speed
        self._bins: dict[int, tuple[Floats, Floats]] = {}

    def step(self, seen: Seen) -> GroundMotion:
        """Return how the camera moved over the ground."""
        times = (seen.begin_s, seen.end_s)
        if seen.found is None or seen.quality <= _LEAST_QUALITY:
            return GroundMotion(*times, 0.0, np.zeros(3), *(False, False))
        ahead, down = self._axes()
        height = (seen.before + seen.after) @ (0.5 * down[:2]) + down[2]
        aboard = self._is_aboard(seen.cell) & (height > _BELOW)
        rotation, travel = seen.found.rotation_rad, seen.found.travel
        if aboard.any() and int((~aboard).sum()) >= FEWEST:
            loose, px = ~aboard, self._view.px
            again = egomotion(seen.before[loose], seen.after[loose], self._travel, px)
            rotation, travel = again.rotation_rad, again.travel
        self._travel = self._travel + _TRAVEL_MEMORY * (travel - self._travel)
        points = self._points(seen, rotation, height)
        self._gather(points, ahead, seen)
        is_kept = ~aboard[points.chosen]
        sunk = self._sunk(points, is_kept, ahead, down)
        return GroundMotion(
            *times,
            -float(rotation @ down),
            np.zeros(3) if sunk is None else sunk,
            is_turn_known=True,
            is_sunk_known=sunk is not None,
        )

    def speeds(self) -> tuple[Floats, Floats]:
        """Return times (K,) and speeds (K,), heights per second, smoothed over seconds."""
        if not self._bins:
            return np.zeros(1), np.zeros(1)
        numbers = sorted(self._bins)
        flow, unit = (
            _smoothed(np.array([self._bins[n][i] for n in numbers])) for i in (0, 1)
        )
        pairs = zip(flow, unit, strict=True)
        speed = [_speed(flow, unit, _GATHERED) for flow, unit in pairs]
        return (np.array(numbers) + 0.5) * BIN_S, np.array(speed)

    def _axes(self) -> tuple[Floats, Floats]:
        """Return the level directions ahead and down (3,), for a camera held upright."""
        ahead = np.array([0.0, self._travel[1], self._travel[2]])
        ahead /= np.linalg.norm(ahead)
        return ahead, np.array([0.0, ahead[2], -ahead[1]])

    def _is_aboard(self, cell: NDArray[np.intp]) -> NDArray[np.bool_]:
        """Return which points (M,) lie in cells of the carrier."""
        if self._per_frame <= _SLOWEST:
            return np.zeros(len(cell), np.bool_)
        slow = self._flow < _CARRIER_SHARE * self._per_frame * self._unit
        return np.asarray((slow & (self._unit > _KNOWN))[cell])

    def _points(self, seen: Seen, rotation: Floats, height: Floats) -> "_Points":
        middle, flow = (seen.before + seen.after) / 2.0, seen.after - seen.before
        turned = rotation_flow(middle) @ rotation
        px = self._view.px
        fixed = np.hypot(*flow.T) < _FIXED_PX * px
        fixed &= np.hypot(*turned.T) > _TURNED_PX * px
        chosen = (height > _BELOW) & ~fixed
        flow = (flow - turned)[chosen]
        return _Points(chosen, middle[chosen], flow, height[chosen], seen.cell[chosen])

    def _gather(self, points: "_Points", ahead: Floats, seen: Seen) -> None:
        """Add the flow away from where the camera goes to its cells."""
        away = points.middle - ahead[:2] / ahead[2]
        distance = np.sqrt((away**2).sum(axis=1) + _SOFT**2)
        unit = points.height * distance
        flow = (points.flow * away).sum(axis=1) / distance * unit
        square = unit**2
        flow = np.clip(flow, -_MOST_FLOW * square, _MOST_FLOW * square)
        number = int(0.5 * (seen.begin_s + seen.end_s) / BIN_S)
        empty = (np.zeros(self._view.cells), np.zeros(self._view.cells))
        in_bin = self._bins.setdefault(number, empty)
        np.add.at(in_bin[0], points.cell, flow / (seen.end_s - seen.begin_s))
        np.add.at(in_bin[1], points.cell, square)
        self._flow *= 1.0 - _CELL_MEMORY
        self._unit *= 1.0 - _CELL_MEMORY
        np.add.at(self._flow, points.cell, flow)
        np.add.at(self._unit, points.cell, square)
        self._per_frame = _speed(self._flow, self._unit, _GATHERED)

    def _sunk(
        self,
        points: "_Points",
        is_kept: NDArray[np.bool_],
        ahead: Floats,
        down: Floats,
    ) -> Floats | None:
        """Return `GroundMotion.sunk`, None where too little of the ground is seen."""
        kept = np.flatnonzero(is_kept)
        if len(kept) < _FEWEST_POINTS:
            return None
        start, px = self._per_frame * ahead, self._view.px
        parts = (kept, kept[::2], kept[1::2])
        return np.array([down @ points.velocity(part, start, px) for part in parts])


class _Points(NamedTuple):
    """Points of the ground (M): what the rotation leaves of their flow, at z = 1."""

    chosen: NDArray[np.bool_]
    middle: Floats
    flow: Floats
    height: Floats
    cell: NDArray[np.intp]

    def velocity(self, part: NDArray[np.intp], start: Floats, px: float) -> Floats:
        """Fit the velocity (3,) in heights per frame to some of the points."""
        x, y = self.middle[part].T
        zero = np.zeros(len(part))
        across = np.stack([-np.ones(len(part)), zero, x], axis=1)
        along = np.stack([zero, -np.ones(len(part)), y], axis=1)
        jacobian = np.stack([across, along], axis=1) * self.height[part, None, None]
        flow, found = self.flow[part], start
        for scale in _SCALES_PX:
            left = flow - jacobian @ found
            weight = 1.0 / (1.0 + (left**2).sum(axis=1) / (scale * px) ** 2) ** 2
            weighted = (jacobian * weight[:, None, None]).reshape(-1, 3).T
            normal = weighted @ jacobian.reshape(-1, 3) + _RIDGE * np.eye(3)
            right = weighted @ flow.reshape(-1) + _RIDGE * start
            found = np.linalg.solve(normal, right)
        return np.asarray(found)


def _speed(flow: Floats, unit: Floats, least: float) -> float:
    """Return the speed that most cells agree on which are not much slower than others.

    Args:
        flow: (C,) of each cell, times that of unit speed, summed.
        unit: (C,) squared flow of unit speed, summed.
        least: of `unit`, from which on a cell counts.
    """
    known = unit > least
    if not known.any():
        return 0.0
    ratio, weight = flow[known] / unit[known], np.minimum(unit[known], _MOST_WEIGHT)
    fastest = _quantile(ratio, weight, _FASTEST_SHARE)
    if fastest <= 0.0:
        return 0.0
    kept = ratio > _SLOWER * fastest
    return max(0.0, _quantile(ratio[kept], weight[kept], 0.5))


def _quantile(values: Floats, weight: Floats, share: float) -> float:
    order = np.argsort(values)
    total = np.cumsum(weight[order])
    return float(values[order][np.searchsorted(total, share * total[-1])])


def _smoothed(rows: Floats) -> Floats:
    from scipy.ndimage import gaussian_filter1d  # half a second, not for every command

    return np.asarray(gaussian_filter1d(rows, _SMOOTH_BINS, axis=0, mode="nearest"))
