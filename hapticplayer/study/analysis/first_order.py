"""The first-order model of incongruence: a rating follows the mismatch with a lag.

rating = offset + low pass (lag) of (g_x |m_x| + g_z |m_z|), with the mismatch m between the
force of the recorded motion and the force that was played, lateral (x) and longitudinal
(z), as Kolff et al. modelled ratings of motion incongruence in a driving simulator.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import TAILS, Resampling
from hapticplayer.study.definition import RatingKind
from hapticplayer.study.watched import COURSE_HZ, Course

LAGS_S = np.geomspace(0.1, 30.0, 80)
RESAMPLES = 199
_AXES = (0, 2)
_LEAST_PEOPLE = 3
_LEAST_SHARE = 0.5
"""Of the participants, who have to have rated a moment."""
_TINY = 1e-12


class FirstOrderModel(NamedTuple):
    """The model of the mean rating of all conditions.

    Attributes:
        lag_s: time constant.
        gain: of both axes, units of the scale for each newton.
        lateral: share of the lateral axis in it; None without a gain.
        explained: share of the variance of the mean rating.
    """

    lag_s: float
    gain: float
    lateral: float | None
    explained: float


def low_pass(values: Floats, lag_s: float) -> Floats:
    """A first-order low pass of (T, ...) at the rate of courses, at rest before."""
    kept = float(np.exp(-1.0 / (COURSE_HZ * lag_s)))
    filtered = scipy.signal.lfilter([1.0 - kept], [1.0, -kept], values, axis=0)
    return np.asarray(filtered, np.float64)


def first_order(
    courses: Sequence[Course], rng: np.random.Generator
) -> dict[str, Any] | None:
    """The model with intervals by bootstrap over participants; None where none fits."""
    known = [one for one in courses if one.mismatch_n is not None]
    people = len(known[0].values) if known else 0
    if people < _LEAST_PEOPLE:
        return None
    fitted = _LagSearch(known)
    model = fitted.model(np.ones(people))
    if model is None:
        return None
    drawn = [
        fitted.model(weights)
        for weights in rng.multinomial(
            people, np.full(people, 1.0 / people), RESAMPLES
        ).astype(np.float64)
    ]
    rows = np.array([one[:2] for one in drawn if one is not None])
    low, high = np.quantile(rows, TAILS, axis=0)
    return {
        **model._asdict(),
        "lag_interval": [float(low[0]), float(high[0])],
        "gain_interval": [float(low[1]), float(high[1])],
        "conditions": len(known),
        "participants": people,
    }


def first_order_models(
    courses: Sequence[Course], resampling: Resampling
) -> dict[str, dict[str, Any]]:
    """The model of each slider that depends on the force, by key."""
    sliders: dict[str, list[Course]] = {}
    for one in courses:
        if one.rating.kind is RatingKind.SLIDER:
            sliders.setdefault(one.rating.key, []).append(one)
    found = {
        key: first_order(each, resampling.generator(f"first-order/{key}"))
        for key, each in sliders.items()
    }
    return {key: model for key, model in found.items() if model is not None}


class _LagSearch:
    """The filtered mismatches of all conditions one after the other, for each lag."""

    def __init__(self, courses: Sequence[Course]) -> None:
        values = np.concatenate([one.values for one in courses], axis=1)
        is_known = ~np.isnan(values)
        used = is_known.mean(axis=0) >= _LEAST_SHARE
        self._is_known = is_known[:, used]
        self._values = np.where(is_known, values, 0.0)[:, used]
        parts = [np.abs(one.mismatch_n[:, _AXES]) for one in courses]  # type: ignore[index]
        filtered = [
            np.concatenate([low_pass(part, lag_s) for part in parts])[used]
            for lag_s in LAGS_S
        ]
        self._filtered = np.array(filtered)  # (lags, T, axes)

    def model(self, weights: Floats) -> FirstOrderModel | None:
        """Of participants with weights: the lag of least squares, refined by a parabola."""
        counts = weights @ self._is_known
        used = counts > 0.0
        mean = (weights @ self._values)[used] / counts[used]
        about = mean - mean.mean() if len(mean) else mean
        total = float(about @ about)
        if not total > 0.0:
            return None
        gains, left = _gains(self._filtered[:, used], about)
        best = int(left.argmin())
        gain = float(gains[best].sum())
        return FirstOrderModel(
            _vertex(left, best),
            gain,
            float(gains[best, 0] / gain) if gain > 0.0 else None,
            1.0 - float(left[best]) / total,
        )


def _gains(filtered: Floats, about: Floats) -> tuple[Floats, Floats]:
    """For each lag, two gains of at least 0, and the sum of squares that is left."""
    centred = filtered - filtered.mean(axis=1, keepdims=True)
    inner = np.einsum("ltj,ltk->ljk", centred, centred)
    with_rating = np.einsum("ltk,t->lk", centred, about)
    own = np.maximum(np.einsum("lkk->lk", inner), _TINY)
    cross = inner[:, 0, 1]
    size = np.maximum(own[:, 0] * own[:, 1] - cross**2, _TINY)
    both = with_rating * own[:, ::-1] - with_rating[:, ::-1] * cross[:, None]
    both /= size[:, None]
    alone = np.maximum(with_rating / own, 0.0)
    is_lateral = with_rating[:, 0] * alone[:, 0] >= with_rating[:, 1] * alone[:, 1]
    single = alone * np.stack([is_lateral, ~is_lateral], axis=1)
    gains = np.where((both >= 0.0).all(axis=1)[:, None], both, single)
    fitted = np.einsum("lj,ljk,lk->l", gains, inner, gains)
    left = about @ about - 2.0 * (gains * with_rating).sum(axis=1) + fitted
    return gains, np.maximum(left, 0.0)


def _vertex(left: Floats, best: int) -> float:
    """The lag of the least of a parabola over the logarithms of three lags."""
    if not 0 < best < len(left) - 1:
        return float(LAGS_S[best])
    before, at, after = left[best - 1 : best + 2]
    bend = before - 2.0 * at + after
    step = 0.5 * (before - after) / bend if bend > 0.0 else 0.0
    return float(LAGS_S[best] * (LAGS_S[1] / LAGS_S[0]) ** step)
