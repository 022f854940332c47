"""Reliability of a score: how far its items measure the same.

Sources: Cronbach L. J. (1951); McDonald R. P. (1999), omega of one factor, fitted by
least squares to the correlations (Harman and Jones, 1966).
"""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats

_LEAST_ITEMS = 3  # two items have one correlation, and any two loadings explain it


@dataclass(frozen=True, slots=True)
class Reliability:
    """Of a score; None where it is not defined.

    Attributes:
        n: rows that have an answer to each item.
        items: number of items.
        alpha: Cronbach's.
        omega: McDonald's, of one factor.
    """

    n: int
    items: int
    alpha: float | None
    omega: float | None


def reliability(answers: Floats) -> Reliability:
    """The reliability of items (n, k), in the direction of the score."""
    count, items = answers.shape
    if count < 2 or items < 2 or (answers.std(axis=0) == 0.0).any():
        return Reliability(count, items, None, None)
    covariance = np.cov(answers, rowvar=False)
    return Reliability(count, items, _alpha(covariance), _omega(covariance))


def _alpha(covariance: Floats) -> float | None:
    items, total = len(covariance), float(covariance.sum())
    if total <= 0.0:
        return None
    return items / (items - 1) * (1.0 - float(covariance.trace()) / total)


def _omega(covariance: Floats) -> float | None:
    """Share of the sum's variance that is the common factor's."""
    if len(covariance) < _LEAST_ITEMS:
        return None
    sd = np.sqrt(covariance.diagonal())
    loadings = _loadings(covariance / np.outer(sd, sd))
    common = float((sd * loadings).sum()) ** 2
    own = float((sd**2 * (1.0 - loadings**2)).sum())
    return common / (common + own)


def _loadings(correlation: Floats) -> Floats:
    """Loadings on one factor that explain the correlations best; at most 1."""
    from scipy.optimize import least_squares

    pairs = np.triu_indices(len(correlation), 1)
    values, vectors = np.linalg.eigh(correlation)
    start = vectors[:, -1] * np.sqrt(values[-1])
    start = np.clip(start * np.sign(start.sum() or 1.0), -0.99, 0.99)

    def left(loadings: Floats) -> Floats:
        return np.asarray((np.outer(loadings, loadings) - correlation)[pairs])

    found = least_squares(left, start, bounds=(-1.0, 1.0), xtol=1e-14, ftol=1e-14)
    return np.asarray(found.x, np.float64)
