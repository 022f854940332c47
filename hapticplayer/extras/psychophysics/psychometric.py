"""Psychometric curves of yes-no judgements, fitted by maximum likelihood.

The perceived change x has normal noise and matches the video while it lies between a
lower and an upper criterion: F(x) = Phi((x - lower) / spread) - Phi((x - upper)
/ spread) (Schneider and Bavelier 2003; Yarrow et al. 2011). If changes of only one
sign were tested, one criterion remains (cumulative normal); so it is in two-interval
trials, where x is the difference of both plays. A share `lapse` of the
answers is random: p = lapse / 2 + (1 - lapse) F; otherwise a few such answers would
flatten the flanks (Wichmann and Hill 2001, I).

All fits of a bootstrap are vectorised: the best point of a grid, then Fisher scoring with
Levenberg-Marquardt damping.
"""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray
from scipy import special

from hapticplayer.model.arrays import Floats

MOST_LAPSES = 0.1
_STEPS, _CLOSE = 60, 1e-9
_NARROWEST = 0.1  # smallest spread, as a share of the smallest step between levels
_Z_LIMIT = 38.0  # beyond, the normal density is zero in doubles
_LEAST_P = 1e-12
_LAPSE_START = -2.0  # logit of the share of MOST_LAPSES


class CurveShape(StrEnum):
    """Shape of a curve: which criteria the levels can show."""

    WINDOW = "window"
    """Both: levels on either side of no change."""
    RISING = "rising"
    """The lower one: only changes below none."""
    FALLING = "falling"
    """The upper one: only changes above none."""
    FROM_HALF = "from half"
    """None: of two plays that do not differ either is chosen by half, F(x) = Phi(|x| /
    spread); the sign of the change is that which was asked for."""

    @property
    def least_levels(self) -> int:
        """Smallest number of levels that determines the curve."""
        return {CurveShape.WINDOW: 4, CurveShape.FROM_HALF: 2}.get(self, 3)


@dataclass(frozen=True, slots=True)
class Fits:
    """Fitted curves, N of them.

    Attributes:
        shape: of all.
        lower: criterion (N,), -inf for a FALLING curve, 0 for one FROM_HALF.
        upper: criterion (N,), inf for one that only rises.
        spread: standard deviation of the noise (N,), in units of the levels.
        lapse: share of answers at random (N,).
        likelihood: natural logarithm (N,), without the binomial coefficients.
        is_steep: whether the spread is at its lower bound (N,).
    """

    shape: CurveShape
    lower: Floats
    upper: Floats
    spread: Floats
    lapse: Floats
    likelihood: Floats
    is_steep: NDArray[np.bool_]

    def shares(self, levels: Floats) -> Floats:
        """Return the probabilities (N, L) of yes at levels (L,)."""
        levels = _as_asked(levels, self.shape)
        below = _z(levels, self.lower, self.spread)
        above = _z(levels, self.upper, self.spread)
        inside = special.ndtr(below) - special.ndtr(above)
        lapse = self.lapse[:, None]
        return np.asarray(lapse / 2.0 + (1.0 - lapse) * inside)


def shape_of(levels: Floats) -> CurveShape:
    """Return the shape that levels (L,) can show; 0 is no change."""
    if levels.min() < 0.0 < levels.max():
        return CurveShape.WINDOW
    return CurveShape.RISING if levels.min() < 0.0 else CurveShape.FALLING


def fit(levels: Floats, yes: Floats, asked: Floats, shape: CurveShape) -> Fits:
    """Fit curves to counts.

    Args:
        levels: (L,) in ascending order, 0 is no change; -inf is allowed.
        yes: answers (N, L) that were yes.
        asked: answers (N, L).
        shape: of the curves.
    """
    space = _Space(levels, shape)
    theta = space.start(yes, asked)
    found, jacobian = space.curve(theta)
    likelihood = _likelihood(found, yes, asked)
    damping = np.full(len(yes), 1e-3)
    for _ in range(_STEPS):
        step = _step(found, jacobian, yes, asked, damping)
        tried = space.inside(theta + step)
        new, new_jacobian = space.curve(tried)
        gained = _likelihood(new, yes, asked) - likelihood
        better = gained > 0.0
        theta[better], found[better] = tried[better], new[better]
        jacobian[better] = new_jacobian[better]
        likelihood[better] += gained[better]
        damping = np.where(better, damping / 10.0, damping * 10.0).clip(1e-9, 1e9)
        if not (gained > _CLOSE).any() and (damping[~better] > 1e3).all():
            break
    return space.fits(theta, likelihood)


def deviance(yes: Floats, asked: Floats, fits: Fits) -> Floats:
    """Return the deviance (N,): twice the log likelihood ratio to the shares."""
    own = yes / np.maximum(asked, 1.0)
    left = 2.0 * (_likelihood(own, yes, asked) - fits.likelihood)
    return np.maximum(left, 0.0)


class _Space:
    """Free parameters of curves: position, log window, log spread, logit of the lapse.

    Position is the lower criterion of a window or of a rising curve, and the upper one
    of a falling curve; only a window has the second parameter.
    """

    def __init__(self, levels: Floats, shape: CurveShape) -> None:
        self.levels = levels = _as_asked(levels, shape)
        self.shape = shape
        known = levels[np.isfinite(levels)]
        self._range, gap = float(np.ptp(known)), float(np.diff(np.sort(known)).min())
        self._low, self._high = known[0] - self._range, known[-1] + self._range
        self._narrowest = _NARROWEST * gap
        self._known = known
        self._has_window = shape is CurveShape.WINDOW
        self._has_position = shape is not CurveShape.FROM_HALF

    def start(self, yes: Floats, asked: Floats) -> Floats:
        """Return the best point (N, K) of a grid for each row of counts."""
        grid = self._grid()
        p = self.curve(grid)[0].clip(_LEAST_P, 1.0 - _LEAST_P)
        scored = yes @ np.log(p).T + (asked - yes) @ np.log1p(-p).T
        return np.asarray(grid[np.argmax(scored, axis=1)])

    def curve(self, theta: Floats) -> tuple[Floats, Floats]:
        """Return probabilities (N, L) and their derivatives (N, L, K)."""
        lower, upper, spread, lapse = self._unpacked(theta)
        below, above = (
            _z(self.levels, lower, spread),
            _z(self.levels, upper, spread),
        )
        at_lower, at_upper = _density(below), _density(above)
        inside = special.ndtr(below) - special.ndtr(above)
        keep, s = (1.0 - lapse)[:, None], spread[:, None]
        parts = [keep * (at_upper - at_lower) / s] if self._has_position else []
        if self._has_window:
            parts.append(keep * at_upper * (upper - lower)[:, None] / s)
        parts.append(keep * (above * at_upper - below * at_lower))
        slope = lapse * (1.0 - lapse / MOST_LAPSES)
        parts.append(slope[:, None] * (0.5 - inside))
        return lapse[:, None] / 2.0 + keep * inside, np.stack(parts, axis=2)

    def inside(self, theta: Floats) -> Floats:
        """Return parameters (N, K) clipped to their bounds."""
        narrowest = np.log(self._narrowest)
        bounds = [(self._low, self._high)] if self._has_position else []
        if self._has_window:
            bounds.append((narrowest, np.log(3.0 * self._range)))
        bounds += [(narrowest, np.log(2.0 * self._range)), (-15.0, 15.0)]
        low, high = np.transpose(bounds)
        return np.clip(theta, low, high)

    def fits(self, theta: Floats, likelihood: Floats) -> Fits:
        """Return the curves with parameters (N, K)."""
        lower, upper, spread, lapse = self._unpacked(theta)
        is_steep = spread <= self._narrowest * (1.0 + 1e-6)
        return Fits(self.shape, lower, upper, spread, lapse, likelihood, is_steep)

    def _unpacked(self, theta: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        position, spread = theta[:, 0], np.exp(theta[:, -2])
        lapse = MOST_LAPSES * special.expit(theta[:, -1])
        infinite = np.full_like(position, np.inf)
        match self.shape:
            case CurveShape.WINDOW:
                return position, position + np.exp(theta[:, 1]), spread, lapse
            case CurveShape.RISING:
                return position, infinite, spread, lapse
            case CurveShape.FALLING:
                return -infinite, position, spread, lapse
            case CurveShape.FROM_HALF:
                return np.zeros_like(spread), infinite, spread, lapse

    def _grid(self) -> Floats:
        known = np.sort(self._known)
        outside = self._range / 10.0
        edges = np.concatenate(
            [
                [known[0] - outside],
                (known[1:] + known[:-1]) / 2.0,
                [known[-1] + outside],
            ]
        )
        spreads = np.log(self._range * np.array([0.03, 0.08, 0.2, 0.5]))
        rows: list[tuple[float, ...]]
        if not self._has_position:
            rows = [(s, _LAPSE_START) for s in spreads]
        elif not self._has_window:
            rows = [(e, s, _LAPSE_START) for e in edges for s in spreads]
        else:
            rows = [
                (a, np.log(b - a), s, _LAPSE_START)
                for i, a in enumerate(edges)
                for b in edges[i + 1 :]
                for s in spreads
            ]
        return self.inside(np.array(rows))


def _as_asked(levels: Floats, shape: CurveShape) -> Floats:
    return np.abs(levels) if shape is CurveShape.FROM_HALF else levels


def _z(levels: Floats, criterion: Floats, spread: Floats) -> Floats:
    apart = (levels[None, :] - criterion[:, None]) / spread[:, None]
    return np.asarray(np.clip(apart, -_Z_LIMIT, _Z_LIMIT))


def _density(z: Floats) -> Floats:
    return np.asarray(np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi))


def _likelihood(p: Floats, yes: Floats, asked: Floats) -> Floats:
    total = special.xlogy(yes, np.maximum(p, _LEAST_P))
    total += special.xlog1py(asked - yes, -np.minimum(p, 1.0 - _LEAST_P))
    return np.asarray(total.sum(axis=1))


def _step(
    p: Floats, jacobian: Floats, yes: Floats, asked: Floats, damping: Floats
) -> Floats:
    """Return a damped step (N, K) of Fisher scoring."""
    p = p.clip(_LEAST_P, 1.0 - _LEAST_P)
    weight = 1.0 / (p * (1.0 - p))
    score = np.einsum("nl,nlk->nk", weight * (yes - asked * p), jacobian)
    weighted = (asked * weight)[:, :, None] * jacobian
    information = np.einsum("nlj,nlk->njk", weighted, jacobian)
    size = np.einsum("nkk->nk", information)
    ridge = damping[:, None] * size + 1e-9 * (1.0 + size.max(axis=1))[:, None]
    information += ridge[:, :, None] * np.eye(jacobian.shape[2])
    return np.asarray(np.linalg.solve(information, score[:, :, None])[:, :, 0])
