"""Cumulative-link mixed model: ordered answers, with crossed random intercepts.

P(y <= j) = F(theta_j - x'beta - sum_k sigma_k u_k), u ~ N(0, 1), F of the logistic or normal
distribution (McCullagh 1980; Tutz and Hennevogl 1996). The random intercepts are integrated
out by Laplace's approximation, as clmm of R's `ordinal` does (Christensen 2019). No Python
library has ordered answers with random effects.
"""

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any, NamedTuple

import numpy as np
import scipy

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.random_intercepts import Curvature, Indices, Places

_MOST_STEPS = 60
_CLOSE, _SAME = 3e-4, 1e-12  # a step below the first leaves its square
_STEP = 1e-4
_LEAST_START, _WEIGHT = 0.2, 0.25
_LEVEL = 1e-4
"""Largest slope of the likelihood that counts as its top."""
_FLAT = 1e-6
"""Least curvature of the likelihood; a parameter below it is not determined."""
_TINY = 1e-300


class LinkFunction(StrEnum):
    """Distribution of the latent answer."""

    LOGIT = "logit"
    PROBIT = "probit"

    @property
    def spread(self) -> float:
        """Standard deviation of the distribution."""
        return math.pi / math.sqrt(3.0) if self is LinkFunction.LOGIT else 1.0


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

    @property
    def degrees(self) -> float:
        """Of freedom of the effects, as between the cells of the last nested group.

        So are feedbacks between those of a person; without cells they are infinite.
        """
        if self.nested < 2:
            return np.inf
        both = self.groups[self.nested - 2 : self.nested]
        cells, people = (int(one.max()) + 1 for one in both)
        left: int = cells - people - self.design.shape[1]
        return max(1, left)


@dataclass(frozen=True, slots=True)
class Estimates:
    """Parameters of largest likelihood.

    Attributes:
        thresholds: (J - 1,).
        effects: (b,) on the latent scale; positive means higher answers.
        deviations: (K,) standard deviations of the random intercepts.
        log_likelihood: of the answers.
        inverse: (p, p) roughly that of its curvature, by the free parameters; for `start`.
    """

    thresholds: Floats
    effects: Floats
    deviations: Floats
    log_likelihood: float
    inverse: Floats

    def with_effects(self, design: Floats) -> "Estimates":
        """Where to look for the effects (b,) of a design, if they were left out."""
        apart = design - design.mean(axis=0)
        own = np.linalg.inv(_WEIGHT * apart.T @ apart + np.eye(apart.shape[1]))
        cuts, count = len(self.thresholds), len(own)
        whole = np.zeros([len(self.inverse) + count] * 2)
        old = np.delete(np.arange(len(whole)), np.s_[cuts : cuts + count])
        whole[np.ix_(old, old)] = self.inverse
        whole[cuts : cuts + count, cuts : cuts + count] = own
        return replace(self, effects=np.zeros(count), inverse=whole)

    def at_cut(self, cut: int) -> "Estimates":
        """Where to look for those of the answers above and below one threshold."""
        kept = np.append(0, np.arange(len(self.thresholds), len(self.inverse)))
        inverse = self.inverse[np.ix_(kept, kept)]
        return replace(self, thresholds=self.thresholds[[cut]], inverse=inverse)


@dataclass(frozen=True, slots=True)
class FittedModel(Estimates):
    """Estimates with what is known of them.

    Attributes:
        covariance: (b, b) of `effects`; NaN where the data do not determine them.
        degrees: of freedom of the effects.
        link: of the model.
    """

    covariance: Floats
    degrees: float
    link: LinkFunction

    @property
    def errors(self) -> Floats:
        """Standard errors (b,) of the effects."""
        return np.sqrt(np.diag(self.covariance))


def fit(
    answers: OrderedAnswers,
    link: LinkFunction = LinkFunction.LOGIT,
    start: Estimates | None = None,
) -> FittedModel:
    """The model of largest likelihood, with its curvature by differences of slopes."""
    likelihood = _Likelihood(answers, link)
    found = likelihood.top(start)
    slope = likelihood(found.x)[1]
    steps = _STEP * np.eye(len(found.x))
    bends = np.array([likelihood(found.x + row)[1] - slope for row in steps])
    best = likelihood.estimates(found)
    first = len(best.thresholds)
    effects = slice(first, first + len(best.effects))
    covariance = _inverse((bends + bends.T) / (2.0 * _STEP))[effects, effects]
    return FittedModel(
        best.thresholds,
        best.effects,
        best.deviations,
        best.log_likelihood,
        best.inverse,
        covariance,
        answers.degrees,
        link,
    )


def estimate(
    answers: OrderedAnswers, link: LinkFunction, start: Estimates | None = None
) -> Estimates:
    """What `fit` finds, without its errors."""
    likelihood = _Likelihood(answers, link)
    return likelihood.estimates(likelihood.top(start))


class _Likelihood:
    """The negative logarithm of the likelihood, and its slope, of free parameters."""

    def __init__(self, answers: OrderedAnswers, link: LinkFunction) -> None:
        self._answers, self._link = answers, link
        self._places = Places.of(answers.groups, answers.nested)
        self._modes = np.zeros(self._places.size)

    def __call__(self, at: Floats) -> tuple[float, Floats]:
        parameters = _Parameters.of(at, self._answers)
        places = self._places._replace(deviations=parameters.deviations)
        of = self._answers, self._link, self._modes
        worth, slope = _laplace(parameters, places, *of)
        return -worth, -parameters.chained(slope)

    def top(self, start: Estimates | None) -> Any:
        """Where it is least, by BFGS from estimates or the answers' own shares."""
        options: dict[str, Any] = {"gtol": _LEVEL}
        if start is not None:
            options["hess_inv0"] = (start.inverse + start.inverse.T) / 2.0
        begin = _start(self._answers, self._link, start)
        return scipy.optimize.minimize(
            self, begin, jac=True, method="BFGS", options=options
        )

    def estimates(self, found: Any) -> Estimates:
        best = _Parameters.of(found.x, self._answers)
        deviations, worth = np.abs(best.deviations), -float(found.fun)
        return Estimates(
            best.thresholds, best.effects, deviations, worth, found.hess_inv
        )


def level_shares(model: FittedModel, shift: float) -> Floats:
    """Probability (J,) of each level for a typical person and clip at a latent shift."""
    below = _distribution(model.thresholds - shift, model.link)
    return np.diff(below, prepend=0.0, append=1.0)


def _start(answers: OrderedAnswers, link: LinkFunction, of: Estimates | None) -> Floats:
    """Free parameters of estimates; else by the shares of the levels, without effects.

    No deviation is near zero, where the likelihood has no slope by it.
    """
    if of is not None:
        deviations = np.maximum(of.deviations, _LEAST_START)
        gaps = np.log(np.diff(of.thresholds))
        return np.concatenate([of.thresholds[:1], gaps, of.effects, deviations])
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
    at: _Parameters,
    places: Places,
    answers: OrderedAnswers,
    link: LinkFunction,
    modes: Floats,
) -> tuple[float, Floats]:
    """Laplace's approximation of the likelihood, and its slope by all parameters.

    Args:
        at: parameters.
        places: of the random intercepts, with their deviations.
        answers: with their design.
        link: of the model.
        modes: (q,) where they are looked for; moved to where they are.
    """
    fixed = answers.design @ at.effects
    bounds = np.concatenate([[-np.inf], at.thresholds, [np.inf]])
    low, high = bounds[answers.levels] - fixed, bounds[answers.levels + 1] - fixed

    def joint(u: Floats) -> tuple[float, _Derivatives, Curvature, Floats]:
        shift = places.values(u)
        found = _Derivatives.of(low - shift, high - shift, link)
        curvature = Curvature.of(places, found.bend)
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
    shift = places.values(u)
    bends = found.bends(low - shift, high - shift, link)
    slope = _slope(u, places, found, bends, curvature, answers)
    return worth - 0.5 * curvature.log_determinant(), slope


def _slope(
    u: Floats,
    places: Places,
    found: "_Derivatives",
    bends: tuple[Floats, Floats],
    curvature: Curvature,
    answers: OrderedAnswers,
) -> Floats:
    """Of Laplace's approximation, with the modes moving along.

    `bends` are those of `found`; `spread` is the variance of each answer's shift, `pull`
    how its curvature moves the modes.
    """
    bend_low, bend_high = bends
    shares = curvature.of_answers(places)
    spread = np.einsum("kn,k->n", shares, places.deviations)
    q = curvature.solve(places.sums(-spread * (bend_low + bend_high)))
    pull = places.values(q)
    by_low = found.low - 0.5 * (spread * bend_low + pull * found.slope_low)
    by_high = found.high - 0.5 * (spread * bend_high + pull * found.slope_high)
    cuts = int(answers.levels.max())
    thresholds = np.bincount(answers.levels, by_high, cuts + 1)[:-1]
    thresholds += np.bincount(answers.levels, by_low, cuts + 1)[1:]
    both = by_low + by_high
    deviations = [
        -(both * u[at] + found.bend * share + 0.5 * q[at] * found.slope).sum()
        for at, share in zip(places.at, shares, strict=True)
    ]
    return np.concatenate([thresholds, -both @ answers.design, deviations])


class _Derivatives(NamedTuple):
    """Of log P(low < x <= high) (n,), by both ends.

    Attributes:
        share: the probability.
        low: by the lower end.
        high: by the higher end.
        low_low, high_high: second ones; the mixed one is their product, negated.
    """

    share: Floats
    low: Floats
    high: Floats
    low_low: Floats
    high_high: Floats

    @property
    def log(self) -> Floats:
        return np.log(self.share)

    @property
    def slope(self) -> Floats:
        """By a shift."""
        return -(self.low + self.high)

    @property
    def slope_low(self) -> Floats:
        """Of the slope, by the lower end."""
        return self.low * self.high - self.low_low

    @property
    def slope_high(self) -> Floats:
        """Of the slope, by the higher end."""
        return self.low * self.high - self.high_high

    @property
    def bend(self) -> Floats:
        """The negative second one by a shift; rounding far off must not make it negative."""
        return np.maximum(self.slope_low + self.slope_high, 0.0)

    @classmethod
    def of(cls, low: Floats, high: Floats, link: LinkFunction) -> "_Derivatives":
        flipped = low + high > 0.0  # differences of small tails are exact
        below = _distribution(np.where(flipped, -high, low), link)
        above = _distribution(np.where(flipped, -low, high), link)
        share = np.maximum(above - below, _TINY)
        (low1, low2), (high1, high2) = _densities(low, link), _densities(high, link)
        a, b = -low1 / share, high1 / share
        return cls(share, a, b, -low2 / share - a**2, high2 / share - b**2)

    def bends(
        self, low: Floats, high: Floats, link: LinkFunction
    ) -> tuple[Floats, Floats]:
        """The slopes of the bend by both ends."""
        a, b, aa, bb = self.low, self.high, self.low_low, self.high_high
        ab = -a * b
        aaa = -_bent_density(low, link) / self.share - a * (a**2 + 3.0 * aa)
        bbb = _bent_density(high, link) / self.share - b * (b**2 + 3.0 * bb)
        aab, abb = -aa * b - a * ab, -ab * b - a * bb
        return -(aaa + 2.0 * aab + abb), -(aab + 2.0 * abb + bbb)


def _distribution(x: Floats, link: LinkFunction) -> Floats:
    function = scipy.special.expit if link is LinkFunction.LOGIT else scipy.special.ndtr
    return np.asarray(function(x), np.float64)


def _densities(x: Floats, link: LinkFunction) -> tuple[Floats, Floats]:
    """The density and its slope."""
    if link is LinkFunction.LOGIT:
        turn = -np.tanh(0.5 * x)
        density = 0.25 * (1.0 - turn**2)
        return density, density * turn
    density = np.exp(-0.5 * x**2) / np.sqrt(2.0 * np.pi)
    return density, -_finite(x) * density


def _bent_density(x: Floats, link: LinkFunction) -> Floats:
    """The second derivative of the density."""
    density, slope = _densities(x, link)
    if link is LinkFunction.LOGIT:
        turn = -np.tanh(0.5 * x)
        return density * (turn**2 - 2.0 * density)
    return -density - _finite(x) * slope


def _finite(x: Floats) -> Floats:
    return np.where(np.isfinite(x), x, 0.0)


def _inverse(information: Floats) -> Floats:
    """Covariance of the parameters that the answers determine, NaN for the others."""
    known = np.diag(information) > _FLAT
    covariance = np.full_like(information, np.nan)
    inner = information[np.ix_(known, known)]
    covariance[np.ix_(known, known)] = np.linalg.pinv(inner, hermitian=True)
    return covariance
