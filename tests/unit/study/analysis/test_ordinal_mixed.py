"""Cumulative-link mixed models against clmm of R's `ordinal` 2022.11-16 on published data.

R with `clmm.control(gradTol = 1e-7)`: its default stops 1 % early where people have two answers.
"""

import numpy as np
import pytest

from hapticplayer.study.analysis.cumulative_link import (
    LinkFunction,
    OrderedAnswers,
    fit,
)
from hapticplayer.study.analysis.ordinal_mixed import (
    compare,
    groups_of,
    ordered_answers,
)
from hapticplayer.study.analysis.scores import Sample

_BITTERNESS = (
    "23344455 12132354 23325544 32323253 23433333 32322454 11222323 22233334 12323244"
)
"""Randall 1989: nine judges of eight bottles; the last four were warm, each second pair had
contact with the skins."""
_SLEEP = (
    (7, 4, 2, 1, 14, 5, 1, 0, 6, 9, 18, 2, 4, 11, 14, 22),
    (7, 4, 1, 0, 11, 5, 2, 2, 13, 23, 3, 1, 9, 17, 13, 8),
)
"""Agresti 2002, table 11.4: people by time to sleep at first and later; placebo, treated."""


def _wine() -> OrderedAnswers:
    levels = np.array([int(one) - 1 for one in _BITTERNESS.replace(" ", "")])
    bottle = np.tile(np.arange(8), 9)
    design = np.stack([bottle >= 4, bottle // 2 % 2 == 1], axis=1).astype(np.float64)
    return OrderedAnswers(levels, design, (np.repeat(np.arange(9), 8), bottle))


def _sleep() -> OrderedAnswers:
    cells = np.repeat(np.arange(32), np.ravel(_SLEEP))
    treated, first, later = cells // 16, cells // 4 % 4, cells % 4
    people = np.tile(np.arange(len(cells)), 2)
    occasion, treated = np.repeat([0, 1], len(cells)), np.tile(treated, 2)
    design = np.stack([occasion, treated, occasion * treated], axis=1)
    return OrderedAnswers(
        np.concatenate([first, later]), design.astype(np.float64), (people,)
    )


def _preferences() -> OrderedAnswers:
    """Drawn: people who prefer different feedbacks; the model of R is
    y ~ f + (1 | p:f) + (1 | p) + (1 | s)."""
    rng = np.random.default_rng(11)
    latent = rng.logistic(size=(15, 4, 3)) + rng.normal(size=(15, 1, 1))
    latent += 1.2 * rng.normal(size=(15, 1, 3)) + 0.5 * rng.normal(size=(4, 1))
    cuts = [-1.5, -0.5, 0.5, 1.5]
    latent += np.array([0.0, 0.5, 1.5])
    found = ordered_answers(1.0 + np.searchsorted(cuts, latent))
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("answers", "link", "thresholds", "effects", "errors", "variances", "likelihood"),
    [
        (
            _wine(),
            LinkFunction.LOGIT,
            (-1.623667, 1.513365, 4.228527, 6.088773),
            (3.062997, 1.834885),
            (0.595376, 0.512529),
            (1.279461, 0.0),
            -81.565409,
        ),
        (
            _wine(),
            LinkFunction.PROBIT,
            (-0.926480, 0.889438, 2.467593, 3.536662),
            (1.800014, 1.048205),
            (0.326940, 0.285545),
            (0.439772, 0.0),
            -80.930607,
        ),
        (
            _sleep(),
            LinkFunction.LOGIT,
            (-3.401142, -1.444916, 0.549073),
            (-1.571837, -0.045869, -1.061319),
            (0.284848, 0.351026, 0.381216),
            (3.065142,),
            -598.000389,
        ),
        (
            _preferences(),
            LinkFunction.LOGIT,
            (-0.129396, 0.540934, 1.621915, 2.601942),
            (1.438607, 2.086154),
            (0.677544, 0.689373),
            (2.320963, 0.0, 0.0729506),
            -250.973407,
        ),
    ],
    ids=["wine-logit", "wine-probit", "sleep-logit", "preferences"],
)
def test_estimates_are_those_of_another_program(
    answers: OrderedAnswers,
    link: LinkFunction,
    thresholds: tuple[float, ...],
    effects: tuple[float, ...],
    errors: tuple[float, ...],
    variances: tuple[float, ...],
    likelihood: float,
) -> None:
    found = fit(answers, link)
    np.testing.assert_allclose(found.thresholds, thresholds, rtol=1e-3)
    np.testing.assert_allclose(found.effects, effects, rtol=1e-3, atol=1e-3)
    np.testing.assert_allclose(found.errors, errors, rtol=1e-3)
    np.testing.assert_allclose(found.deviations**2, variances, rtol=1e-3, atol=1e-3)
    assert found.log_likelihood == pytest.approx(likelihood, abs=1e-4)


def test_a_mirrored_scale_gives_mirrored_effects() -> None:
    answers = _wine()
    turned = OrderedAnswers(4 - answers.levels, answers.design, answers.groups)
    ahead, back = fit(answers), fit(turned)
    np.testing.assert_allclose(back.effects, -ahead.effects, rtol=1e-3)
    np.testing.assert_allclose(back.thresholds, -ahead.thresholds[::-1], rtol=1e-3)


def _sample(values: np.ndarray) -> Sample:
    people = tuple(f"P{i}" for i in range(len(values)))
    feedbacks = ("none", "random", "realistic")[: values.shape[2]]
    means = np.nan_to_num(values).mean(axis=1)
    unknown = (None,) * len(people)
    return Sample("comfort", feedbacks, people, means, (), {}, unknown, values, people)


def _simulated(shift: float, seed: int = 5) -> np.ndarray:
    rng = np.random.default_rng(seed)
    latent = rng.logistic(size=(15, 4, 3)) + rng.normal(size=(15, 1, 1))
    latent += shift * np.arange(3)
    return 1.0 + np.searchsorted([-1.5, -0.5, 0.5, 1.5], latent)


def test_pairs_are_differences_of_the_same_model() -> None:
    values = _simulated(1.0)
    values[3, 2, 1] = np.nan
    found = compare(_sample(values), LinkFunction.LOGIT)
    assert found is not None
    assert found["n"] == 179
    pairs = found["pairs"]
    assert pairs["none-realistic"]["estimate"] == pytest.approx(
        pairs["none-random"]["estimate"] + pairs["random-realistic"]["estimate"]
    )
    low, high = pairs["none-realistic"]["interval"]
    assert pairs["none-realistic"]["df"] == 28  # (15 people - 1) (3 feedbacks - 1)
    assert (high - low) / pairs["none-realistic"]["error"] == pytest.approx(
        2 * 2.0484, 1e-4
    )
    assert low < 2.0 < high
    assert found["p_all"] < 1e-3
    for shares in found["shares"].values():
        assert sum(shares) == pytest.approx(1.0)


def test_numbers_in_classes_keep_their_effects() -> None:
    """The differences of 4,800 logistic values, whatever is done to their scale."""
    rng = np.random.default_rng(4)
    latent = rng.logistic(size=(400, 4, 3)) + rng.normal(size=(400, 1, 1))
    latent += 0.7 * np.arange(3)
    made = [ordered_answers(one, is_item=False) for one in (latent, np.exp(latent))]
    for answers in made:
        assert answers is not None
        assert np.bincount(answers.levels).tolist() == [480] * 10
        np.testing.assert_allclose(fit(answers).effects, [0.7, 1.4], atol=0.12)


def test_a_feedback_without_effect_has_none() -> None:
    p_values = []
    for seed in range(4):
        found = compare(_sample(_simulated(0.0, seed)), LinkFunction.PROBIT)
        assert found is not None
        p_values.append(found["p_all"])
    assert min(p_values) > 0.01
    assert max(p_values) > 0.3


@pytest.mark.parametrize("link", LinkFunction)
def test_answers_at_the_end_of_the_scale_have_no_estimate(link: LinkFunction) -> None:
    values = _simulated(0.3)
    values[:, :, 2] = 5.0
    found = compare(_sample(values), link)
    assert found is not None
    assert found["pairs"]["none-realistic"]["estimate"] is None
    assert found["pairs"]["none-random"]["estimate"] is not None


@pytest.mark.parametrize(
    ("link", "estimates", "errors"),
    [
        (LinkFunction.LOGIT, (8.208665, 15.321028), (1.295739, 1.646501)),
        (LinkFunction.PROBIT, (4.196104, 7.952126), (0.538679, 0.703959)),
    ],
)
def test_large_differences_are_known_with_either_link(
    link: LinkFunction, estimates: tuple[float, ...], errors: tuple[float, ...]
) -> None:
    """Feedbacks that share no answer but overlap with a third one; golden numbers of clmm."""
    rng = np.random.default_rng(11)
    latent = rng.logistic(size=(15, 4, 3)) + rng.normal(size=(15, 1, 1))
    latent += rng.normal(size=(15, 1, 3)) + np.array([0.0, 6.5, 13.0])
    values = 1.0 + np.searchsorted(np.arange(-1.0, 15.0, 2.0), latent)
    assert values[:, :, 0].max() < values[:, :, 2].min()
    found = compare(_sample(values), link)
    assert found is not None
    pairs = [found["pairs"][f"none-{one}"] for one in ("random", "realistic")]
    estimated = [one["estimate"] for one in pairs]
    np.testing.assert_allclose(estimated, estimates, rtol=1e-3)
    np.testing.assert_allclose([one["error"] for one in pairs], errors, rtol=1e-3)


@pytest.mark.parametrize(
    "values",
    [
        np.full((6, 2, 3), 4.0),
        _simulated(1.0)[:2],
        np.full((6, 2, 3), np.nan),
    ],
    ids=["constant", "two-people", "none"],
)
def test_answers_that_no_model_fits_have_no_result(values: np.ndarray) -> None:
    assert ordered_answers(values) is None
    assert compare(_sample(values), LinkFunction.LOGIT) is None


def test_sites_have_intercepts_as_in_clmm():
    """Golden numbers: clmm(y ~ fb + (1|p:fb) + (1|p) + (1|s) + (1|site)) of R's ordinal."""
    rng = np.random.default_rng(8)
    people, sequences, feedbacks, count = 48, 4, 3, 6
    of = np.repeat(np.arange(count), people // count)
    latent = rng.logistic(size=(people, sequences, feedbacks))
    latent += 0.8 * rng.normal(size=(people, 1, 1))
    latent += 0.5 * rng.normal(size=(sequences, 1))
    latent += (0.9 * rng.normal(size=count))[of][:, None, None] + [0.0, 0.4, 1.1]
    values = 1.0 + np.searchsorted((-2.0, -0.7, 0.7, 2.0), latent)
    sites = [f"s{one}" for one in of]
    found = fit(ordered_answers(values, sites=sites), LinkFunction.LOGIT)
    names = list(groups_of(values, sites))
    assert names == ["participant", "sequence", "site"]
    assert found.effects == pytest.approx([0.036329, 0.836106], abs=1e-4)
    assert found.errors == pytest.approx([0.187912, 0.192414], abs=1e-4)
    assert found.deviations == pytest.approx([0.0, 0.74765, 0.75161, 0.64084], abs=1e-4)
