"""Cumulative-link mixed model: ordered answers, with crossed random intercepts.

P(y <= j) = F(theta_j - x'beta - sum_k sigma_k u_k), u ~ N(0, 1), F of the logistic or normal
distribution (McCullagh 1980; Tutz and Hennevogl 1996). The random intercepts are integrated
out by Laplace's approximation, as clmm of R's `ordinal` does (Christensen 2019). No Python
library has ordered answers with random effects.
"""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

Indices = NDArray[np.intp]

_MOST_STEPS = 60
_CLOSE, _SAME = 1e-5, 1e-12
_STEP = 1e-4
_LEVEL = 1e-4
"""Largest slope of the likelihood that counts as its top."""
_FLAT = 1e-6
"""Least curvature of the likelihood; a parameter below it is not determined."""
_TINY = 1e-300


class LinkFunction(StrEnum):
    """Distribution of the latent answer."""

    LOGIT = "logit"
    PROBIT = "probit"


@dataclass(frozen=True, slots=True)
class OrderedAnswers:
    """Answers with what they depend on.

    Attributes:
        levels: (n,) from 0, each of which occurs.
        design: (n, b) columns of the fixed effects, without an intercept.
        groups: (n,) from 0, one for each random intercept; the first may have many.
        nested: how many of the first groups may have many: each lies within the next.
    """

    levels: Indices
    design: Floats
    groups: tuple[Indices, ...]
    nested: int = 1


@dataclass(frozen=True, slots=True)
class FittedModel:
    """Estimates of largest likelihood.

    Attributes:
        thresholds: (J - 1,).
        effects: (b,) on the latent scale; positive means higher answers.
        deviations: (K,) standard deviations of the random intercepts.
        covariance: (b, b) of `effects`; NaN where the data do not determine them.
        log_likelihood: of the answers.
    """

    thresholds: Floats
    effects: Floats
    deviations: Floats
    covariance: Floats
    log_likelihood: float

    @property
    def errors(self) -> Floats:
        """Standard errors (b,) of the effects."""
        return np.sqrt(np.diag(self.covariance))


def fit(
    answers: OrderedAnswers, link: LinkFunction = LinkFunction.LOGIT
) -> FittedModel:
    """The model of largest likelihood, by BFGS from the answers' own shares."""
    modes = np.zeros(sum(int(group.max()) + 1 for group in answers.groups))

    def cost(at: Floats) -> tuple[float, Floats]:
        parameters = _Parameters.of(at, answers)
        worth, slope = _laplace(parameters, answers, link, modes)
        return -worth, -parameters.chained(slope)

    start = _start(answers, link)
    options = {"gtol": _LEVEL}
    solved = scipy.optimize.minimize(
        cost, start, jac=True, method="BFGS", options=options
    )
    found = solved.x
    steps = _STEP * np.eye(len(found))
    bends = np.array([cost(found + row)[1] - cost(found - row)[1] for row in steps])
    best = _Parameters.of(found, answers)
    first = len(best.thresholds)
    effects = slice(first, first + len(best.effects))
    return FittedModel(
        best.thresholds,
        best.effects,
        np.abs(best.deviations),
        _inverse((bends + bends.T) / (4.0 * _STEP))[effects, effects],
        -float(solved.fun),
    )


def level_shares(model: FittedModel, shift: float, link: LinkFunction) -> Floats:
    """Probability (J,) of each level for a typical person and clip at a latent shift."""
    below = _distribution(model.thresholds - shift, link)
    return np.diff(below, prepend=0.0, append=1.0)


def _start(answers: OrderedAnswers, link: LinkFunction) -> Floats:
    """Thresholds from the shares of the levels, no effects, small deviations."""
    shares = np.cumsum(np.bincount(answers.levels))[:-1] / len(answers.levels)
    inverse = scipy.special.logit if link is LinkFunction.LOGIT else scipy.special.ndtri
    thresholds = inverse(shares)
    gaps = np.log(np.diff(thresholds))
    none = np.zeros(answers.design.shape[1])
    return np.concatenate(
        [thresholds[:1], gaps, none, np.full(len(answers.groups), 0.5)]
    )


class _Parameters(NamedTuple):
    """Thresholds (J - 1,) in order, effects (b,), deviations (K,) of either sign."""

    thresholds: Floats
    effects: Floats
    deviations: Floats

    @classmethod
    def of(cls, at: Floats, answers: OrderedAnswers) -> "_Parameters":
        """From the first threshold, logarithms of the gaps, effects and deviations."""
        cuts = int(answers.levels.max())
        free, effects, deviations = np.split(at, [cuts, cuts + answers.design.shape[1]])
        above = np.cumsum(np.exp(free[1:]))
        return cls(free[0] + np.append(0.0, above), effects, deviations)

    def chained(self, slope: Floats) -> Floats:
        """The slope by the parameters as one that `of` takes."""
        cuts = len(self.thresholds)
        from_here = np.cumsum(slope[:cuts][::-1])[::-1]
        gaps = np.diff(self.thresholds) * from_here[1:]
        return np.concatenate([from_here[:1], gaps, slope[cuts:]])


def _laplace(
    at: _Parameters, answers: OrderedAnswers, link: LinkFunction, modes: Floats
) -> tuple[float, Floats]:
    """Laplace's approximation of the likelihood, and its slope by all parameters.

    Args:
        at: parameters.
        answers: with their design.
        link: of the model.
        modes: (q,) where they are looked for; moved to where they are.
    """
    fixed = answers.design @ at.effects
    bounds = np.concatenate([[-np.inf], at.thresholds, [np.inf]])
    low, high = bounds[answers.levels] - fixed, bounds[answers.levels + 1] - fixed
    places = _Places.of(answers, at.deviations)

    def joint(u: Floats) -> tuple[float, _Derivatives, _Curvature, Floats]:
        shift = places.values(u)
        found = _Derivatives.of(low - shift, high - shift, link)
        curvature = _Curvature.of(places, found.bend)
        worth = float(found.log.sum() - 0.5 * u @ u)
        return worth, found, curvature, curvature.solve(places.sums(found.slope) - u)

    u = modes.copy()
    worth, found, curvature, step = joint(u)
    for _ in range(_MOST_STEPS):
        tried = joint(u + step)
        while tried[0] < worth - _SAME * abs(worth):
            step = step / 2.0
            tried = joint(u + step)
        u, last = u + step, step
        worth, found, curvature, step = tried
        if np.abs(last).max() < _CLOSE:
            break
    modes[:] = u
    slope = _slope(u, places, found, curvature, answers)
    return worth - 0.5 * curvature.log_determinant(), slope


def _slope(
    u: Floats,
    places: "_Places",
    found: "_Derivatives",
    curvature: "_Curvature",
    answers: OrderedAnswers,
) -> Floats:
    """Of Laplace's approximation, with the modes moving along.

    `spread` is the variance of each answer's shift; `pull` is how its curvature moves the
    modes.
    """
    shares = curvature.of_answers(places)
    spread = np.einsum("kn,k->n", shares, places.deviations)
    q = curvature.solve(places.sums(-spread * (found.bend_low + found.bend_high)))
    pull = places.values(q)
    by_low = found.low - 0.5 * (spread * found.bend_low + pull * found.slope_low)
    by_high = found.high - 0.5 * (spread * found.bend_high + pull * found.slope_high)
    cuts = int(answers.levels.max())
    thresholds = np.bincount(answers.levels, by_high, cuts + 1)[:-1]
    thresholds += np.bincount(answers.levels, by_low, cuts + 1)[1:]
    both = by_low + by_high
    deviations = [
        -(both * u[at] + found.bend * share + 0.5 * q[at] * found.slope).sum()
        for at, share in zip(places.at, shares, strict=True)
    ]
    return np.concatenate([thresholds, -both @ answers.design, deviations])


class _Places(NamedTuple):
    """Of each answer's random intercepts among all q of them, with their deviations.

    Attributes:
        at: (n,) for each group.
        deviations: of the groups.
        firsts: place of the first of each group, and q.
        nested: number of the groups that are diagonal, each within the next.
    """

    at: tuple[Indices, ...]
    deviations: Floats
    firsts: Indices
    nested: int

    @classmethod
    def of(cls, answers: OrderedAnswers, deviations: Floats) -> "_Places":
        sizes = [int(group.max()) + 1 for group in answers.groups]
        firsts = np.cumsum([0, *sizes])
        at = tuple(
            group + first for group, first in zip(answers.groups, firsts, strict=False)
        )
        return cls(at, deviations, firsts, answers.nested)

    @property
    def size(self) -> int:
        return int(self.firsts[-1])

    def local(self, group: int) -> Indices:
        """Of each answer in a group, from 0."""
        return np.asarray(self.at[group] - self.firsts[group], np.intp)

    def values(self, u: Floats) -> Floats:
        """The shift (n,) of each answer."""
        return np.asarray(self.deviations @ np.stack([u[at] for at in self.at]))

    def sums(self, values: Floats) -> Floats:
        """The transpose of `values`: (q,) from (n,)."""
        total = np.zeros(self.size)
        for at, deviation in zip(self.at, self.deviations, strict=True):
            total += deviation * np.bincount(at, values, self.size)
        return total


class _Level(NamedTuple):
    """A group that was eliminated: nothing couples two of its members.

    Attributes:
        own: (f,) diagonal.
        share: (f, r) cross part with the groups that are left, over it.
        parents: (f,) in the next level; None for the last one.
        to_parent: (f,) cross part with it over `own`.
    """

    own: Floats
    share: Floats
    parents: Indices | None = None
    to_parent: Floats | None = None


class _Curvature(NamedTuple):
    """The negative Hessian by the intercepts, solved by Schur's complement.

    It is diagonal among the members of a nested group: the work grows with the number of
    people, not its cube.

    Attributes:
        levels: of the nested groups.
        inverse: (r, r) of the complement.
        size: its log determinant.
    """

    levels: tuple[_Level, ...]
    inverse: Floats
    size: float

    @classmethod
    def of(cls, places: _Places, bend: Floats) -> "_Curvature":
        count, deviations = places.nested, places.deviations
        start = places.firsts[count]
        left = places.size - int(start)
        others = [at - start for at in places.at[count:]]
        rest = np.eye(left)
        for at, deviation in zip(others, deviations[count:], strict=True):
            for other, by in zip(others, deviations[count:], strict=True):
                pairs = np.bincount(at * left + other, bend, left**2)
                rest += deviation * by * pairs.reshape(left, left)
        levels: list[_Level] = []
        for group in range(count):
            here, size = places.local(group), int(np.diff(places.firsts)[group])
            scale = deviations[group]
            own = 1.0 + scale**2 * np.bincount(here, bend, size)
            cross = np.zeros((size, left))
            for at, deviation in zip(others, deviations[count:], strict=True):
                cells = np.bincount(here * left + at, bend, size * left)
                cross += scale * deviation * cells.reshape(size, left)
            if levels:
                below = levels[-1]
                assert below.parents is not None
                assert below.to_parent is not None
                moved = below.to_parent * below.own
                own -= np.bincount(below.parents, moved * below.to_parent, size)
                for column in range(left):
                    part = moved * below.share[:, column]
                    cross[:, column] -= np.bincount(below.parents, part, size)
            share = cross / own[:, None]
            rest -= cross.T @ share
            if group + 1 == count:
                levels.append(_Level(own, share))
                continue
            parents = np.zeros(size, np.intp)
            parents[here] = places.local(group + 1)
            coupled = scale * deviations[group + 1] * np.bincount(here, bend, size)
            levels.append(_Level(own, share, parents, coupled / own))
        inverse = np.asarray(np.linalg.inv(rest), np.float64)
        return cls(tuple(levels), inverse, float(np.linalg.slogdet(rest)[1]))

    def solve(self, right: Floats) -> Floats:
        """The inverse times (q,)."""
        sizes = [len(one.own) for one in self.levels]
        *parts, others = np.split(right.copy(), np.cumsum(sizes))
        for number, one in enumerate(self.levels):
            others -= parts[number] @ one.share
            if one.parents is not None and one.to_parent is not None:
                moved = parts[number] * one.to_parent
                parts[number + 1] -= np.bincount(one.parents, moved, sizes[number + 1])
        others = self.inverse @ others
        found: list[Floats] = []
        for one, part in zip(self.levels[::-1], parts[::-1], strict=True):
            solved = part / one.own - one.share @ others
            if one.parents is not None and one.to_parent is not None:
                solved -= one.to_parent * found[0][one.parents]
            found.insert(0, solved)
        return np.concatenate([*found, others])

    def log_determinant(self) -> float:
        return float(sum(np.log(one.own).sum() for one in self.levels) + self.size)

    def of_answers(self, places: _Places) -> Floats:
        """The inverse times each answer's scaled row, at its own places: (K, n)."""
        count, deviations = places.nested, places.deviations
        start, people = places.firsts[count], len(places.at[0])
        others = np.zeros((people, len(self.inverse)))
        rows = np.arange(people)
        for at, deviation in zip(places.at[count:], deviations[count:], strict=True):
            others[rows, at - start] += deviation
        parts = [np.full(people, deviation) for deviation in deviations[:count]]
        here = [places.local(group) for group in range(count)]
        for number, one in enumerate(self.levels):
            others -= parts[number][:, None] * one.share[here[number]]
            if one.to_parent is not None:
                parts[number + 1] -= parts[number] * one.to_parent[here[number]]
        others = others @ self.inverse
        found: list[Floats] = []
        for number in reversed(range(count)):
            one, at = self.levels[number], here[number]
            solved = parts[number] / one.own[at] - (one.share[at] * others).sum(axis=1)
            if one.to_parent is not None:
                solved -= one.to_parent[at] * found[0]
            found.insert(0, solved)
        return np.array(
            [*found, *(others[rows, at - start] for at in places.at[count:])]
        )


class _Derivatives(NamedTuple):
    """Of log P(low < x <= high) (n,), by both ends.

    Attributes:
        log: the logarithm.
        low: by the lower end.
        high: by the higher end.
        slope_low, slope_high: of the slope by a shift.
        bend_low, bend_high: of the bend by a shift.
    """

    log: Floats
    low: Floats
    high: Floats
    slope_low: Floats
    slope_high: Floats
    bend_low: Floats
    bend_high: Floats

    @property
    def slope(self) -> Floats:
        """By a shift."""
        return -(self.low + self.high)

    @property
    def bend(self) -> Floats:
        """The negative second one by a shift."""
        return self.slope_low + self.slope_high

    @classmethod
    def of(cls, low: Floats, high: Floats, link: LinkFunction) -> "_Derivatives":
        flipped = low + high > 0.0  # differences of small tails are exact
        below = _distribution(np.where(flipped, -high, low), link)
        above = _distribution(np.where(flipped, -low, high), link)
        share = np.maximum(above - below, _TINY)
        low1, low2, low3 = (one / share for one in _densities(low, link))
        high1, high2, high3 = (one / share for one in _densities(high, link))
        a, b, ab = -low1, high1, low1 * high1
        aa, bb = -low2 - a**2, high2 - b**2
        aaa = -low3 + low2 * a - 2.0 * a * aa
        bbb = high3 - high2 * b - 2.0 * b * bb
        aab, abb = -aa * b - a * ab, -ab * b - a * bb
        return cls(
            np.log(share),
            a,
            b,
            -(aa + ab),
            -(ab + bb),
            -(aaa + 2.0 * aab + abb),
            -(aab + 2.0 * abb + bbb),
        )


def _distribution(x: Floats, link: LinkFunction) -> Floats:
    function = scipy.special.expit if link is LinkFunction.LOGIT else scipy.special.ndtr
    return np.asarray(function(x), np.float64)


def _densities(x: Floats, link: LinkFunction) -> tuple[Floats, Floats, Floats]:
    """The density, its slope, and the slope of that."""
    if link is LinkFunction.LOGIT:
        density = scipy.special.expit(x) * scipy.special.expit(-x)
        turn = -np.tanh(0.5 * x)
        return density, density * turn, density * (turn**2 - 2.0 * density)
    density = np.exp(-0.5 * x**2) / np.sqrt(2.0 * np.pi)
    finite = np.where(np.isfinite(x), x, 0.0)
    return density, -finite * density, (finite**2 - 1.0) * density


def _inverse(information: Floats) -> Floats:
    """Covariance of the parameters that the answers determine, NaN for the others."""
    known = np.diag(information) > _FLAT
    covariance = np.full_like(information, np.nan)
    inner = information[np.ix_(known, known)]
    covariance[np.ix_(known, known)] = np.linalg.pinv(inner, hermitian=True)
    return covariance
