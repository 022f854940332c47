"""Simulated answers from a known population.

A rating is a latent value, rounded and cut to 1..5:

    y = clip(round(m_fk + s_f u_pf + T e), 1, 5),   u_pf = sqrt(r) a_p + sqrt(1-r) b_pf

with the feedback f, the factor k, the participant p and independent standard normal
a, b, e. m_fk and s_f are solved so that the population has the wanted mean of each
factor and the wanted SD of QoE over participants (each the mean of S sequences); the
expectations are exact up to Gauss-Hermite quadrature. What the paper does not state was
chosen so that the median chi-squares of 15 participants come near its printed ones:
how alike a participant's answers are for all feedbacks (r), and how much they scatter
over sequences (T). The population gives 25.6, 26.3, 29.1, 5.8 and 22.9 for QoE, realism,
sensory, comfort and satisfaction (printed: 24.71, 24.03, 26.68, 8.79, 23.05).
"""

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import optimize, special

from hapticplayer.errors import UsageError
from hapticplayer.model.arrays import Floats
from hapticplayer.model.ranges import SIMULATED_PARTICIPANTS
from hapticplayer.study.analysis.friedman import chi_squares
from hapticplayer.study.analysis.power import Draw
from hapticplayer.study.analysis.scores import SCALE
from hapticplayer.study.answers import Answers, Participant, Rating
from hapticplayer.study.definition import QOE

SCATTER = 0.7
COMMON = 0.2
_PAPER_SEQUENCES = 4
_LATENT_RANGE = (-12.0, 18.0)
_SD_RANGE = (0.01, 6.0)
_NODES = 61
_MOST = 3.0


@dataclass(frozen=True, slots=True)
class PopulationEffect:
    """What a population says of each of F feedbacks in K factors.

    `rows` are the paper's conditions that they are rated like, `of_sequences` the names of
    the effects at each sequence where they differ.
    """

    name: str
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    factor_means: Floats  # (F, K)
    qoe_sds: Floats  # (F,), over participants, of their mean over the sequences
    rows: tuple[int, ...] = (0, 1, 2)
    of_sequences: tuple[str, ...] = ()


def paper_effect() -> PopulationEffect:
    """The paper's results (section 5, figures 7 and 8).

    The factors' means are printed with one decimal and add up to 0.1 more or less than
    the printed mean of QoE; the difference is shared among them, at most 0.025 each,
    so that both are met as printed.
    """
    factor_means = np.array(
        [[1.3, 1.1, 2.9, 2.1], [1.9, 2.4, 3.2, 2.8], [3.8, 3.9, 3.6, 4.1]]
    )
    qoe_means = np.array([7.5, 10.2, 15.3])
    factor_means += (qoe_means - factor_means.sum(axis=1))[:, None] / 4.0
    return PopulationEffect(
        "paper",
        ("none", "random", "realistic"),
        ("realism", "sensory", "comfort", "satisfaction"),
        factor_means,
        np.array([2.1, 1.6, 2.6]),
    )


def effect_named(name: str) -> PopulationEffect:
    """Return the paper's effect, none, or a share of the paper's such as "0.5".

    A share moves the feedbacks' means towards their common mean; spreads stay.
    """
    paper = paper_effect()
    if name == "paper":
        return paper
    try:
        share = 0.0 if name == "none" else float(name)
    except ValueError:
        share = np.nan
    if not 0.0 <= share <= _MOST:
        raise UsageError(
            "there is no effect {name!r}; there is paper, none, or a share of the "
            "paper's effect such as 0.5",
            name=name,
        )
    common = paper.factor_means.mean(axis=0)
    means = common + share * (paper.factor_means - common)
    low, high = SCALE
    if means.min() <= low or means.max() >= high:
        raise UsageError(
            "an effect of {share:g} times the paper's leaves the scale of {low} "
            "to {high}; choose a smaller one",
            share=share,
            low=low,
            high=high,
        )
    return PopulationEffect(name, paper.feedbacks, paper.factors, means, paper.qoe_sds)


def for_feedbacks(
    effect: PopulationEffect, like: Mapping[str, str]
) -> PopulationEffect:
    """Return the effect for other feedbacks, each rated like one of the effect's.

    Nobody has measured them: this is an assumption for planning and for trying out.

    Args:
        effect: of the paper's feedbacks.
        like: name in the effect, by name of the feedback.
    """
    if unknown := set(like.values()) - set(effect.feedbacks):
        raise UsageError(
            "a feedback cannot be rated like {name!r}; choose one of {known}",
            name=min(unknown),
            known=", ".join(effect.feedbacks),
        )
    rows = tuple(effect.feedbacks.index(name) for name in like.values())
    return replace(
        effect,
        feedbacks=tuple(like),
        factor_means=effect.factor_means[list(rows)],
        qoe_sds=effect.qoe_sds[list(rows)],
        rows=rows,
    )


def at_sequences(effect: PopulationEffect, shares: Sequence[float]) -> PopulationEffect:
    """The effect with a share of it at each sequence.

    Nobody has measured them: this is an assumption, as of `for_feedbacks`.
    """
    whole = {"paper": 1.0, "none": 0.0}.get(effect.name)
    whole = float(effect.name) if whole is None else whole
    names = [effect.name if one == 1.0 else f"{whole * one:g}" for one in shares]
    for name in names:
        effect_named(name)
    return replace(effect, of_sequences=tuple(names))


def drawn_ratings(
    effect: PopulationEffect, shape: tuple[int, int, int], rng: np.random.Generator
) -> Floats:
    """Return ratings (studies, participants, sequences, F, K); `shape` holds three."""
    studies, people, sequences = shape
    latent = [_latent(name) for name in effect.of_sequences or (effect.name,)]
    means = np.stack([one[list(effect.rows)] for one, _ in latent])  # (S or 1, F, K)
    sds = np.stack([one[list(effect.rows)] for _, one in latent])
    feedbacks, factors = effect.factor_means.shape
    common = rng.standard_normal((studies, people, 1))
    own = rng.standard_normal((studies, people, feedbacks))
    person = np.sqrt(COMMON) * common + np.sqrt(1.0 - COMMON) * own
    scatter = rng.standard_normal((studies, people, sequences, feedbacks, factors))
    scatter *= SCATTER
    scatter += (sds * person[:, :, None])[..., None] + means
    return np.asarray(np.clip(np.rint(scatter, out=scatter), *SCALE, out=scatter))


def drawn_measure(
    effect: PopulationEffect,
    measure: str,
    shape: tuple[int, int, int],
    rng: np.random.Generator,
) -> Floats:
    """QoE or a factor of drawn ratings: (studies, participants, sequences, F)."""
    if measure != QOE and measure not in effect.factors:
        known = ", ".join((QOE, *effect.factors))
        raise UsageError(
            "there is no measure {measure!r}; choose one of {known}",
            measure=measure,
            known=known,
        )

    ratings = drawn_ratings(effect, shape, rng)
    if measure == QOE:
        return np.asarray(ratings.sum(axis=4))
    return np.asarray(ratings[..., effect.factors.index(measure)])


def draw_effect(effect: PopulationEffect, measure: str, sequences: int) -> Draw:
    """Return draws of participants of a population with a known effect."""

    def draw(studies: int, people: int, rng: np.random.Generator) -> Floats:
        shape = studies, people, sequences
        return np.asarray(drawn_measure(effect, measure, shape, rng).mean(axis=2))

    return draw


@functools.cache
def _latent(name: str) -> tuple[Floats, Floats]:
    """Return m_fk (F, K) and s_f (F,) of an effect by name."""
    effect = effect_named(name)
    rows = [
        _solved(means, float(sd))
        for means, sd in zip(effect.factor_means, effect.qoe_sds, strict=True)
    ]
    return np.array([row[0] for row in rows]), np.array([row[1] for row in rows])


def _solved(factor_means: Floats, qoe_sd: float) -> tuple[Floats, float]:
    def surplus(spread: float) -> float:
        latent = _latent_means(factor_means, spread)
        return _qoe_sd(latent, spread) - qoe_sd

    spread = float(optimize.brentq(surplus, *_SD_RANGE, xtol=1e-10))
    return _latent_means(factor_means, spread), spread


def _latent_means(factor_means: Floats, spread: float) -> Floats:
    # rounding turns a normal latent value into steps at 1.5 .. 4.5
    total = np.hypot(spread, SCATTER)

    def surplus(latent: float, wanted: float) -> float:
        return float(1.0 + special.ndtr((latent - _steps()) / total).sum() - wanted)

    return np.array(
        [
            optimize.brentq(surplus, *_LATENT_RANGE, args=(mean,), xtol=1e-12)
            for mean in factor_means
        ]
    )


def _qoe_sd(latent: Floats, spread: float) -> float:
    """Return the SD over participants of QoE averaged over the paper's sequences."""
    nodes, weights = special.roots_hermitenorm(_NODES)
    weights = weights / weights.sum()
    person = latent[:, None] + spread * nodes[:, None, None]
    above = special.ndtr((person - _steps()) / SCATTER)  # (u, factor, step)
    mean = 1.0 + above.sum(axis=2)
    # E y^2 = 1 + sum_j (2j + 1) P(y > j)
    square = 1.0 + (above * (2.0 * np.floor(_steps()) + 1.0)).sum(axis=2)
    scatter = (square - mean**2).sum(axis=1) / _PAPER_SEQUENCES
    qoe = mean.sum(axis=1)
    between = (qoe - float(weights @ qoe)) ** 2
    return float(np.sqrt(weights @ (between + scatter)))


def _steps() -> Floats:
    low, high = SCALE
    return np.arange(low + 0.5, high, dtype=np.float64)


SEQUENCES = ("bike", "horse", "car-turning", "car-braking")
PAPER_W = (0.824, 0.801, 0.889, 0.293, 0.768)
"""Kendall's W of QoE and the factors: the printed chi-squares over n (k - 1) = 30; the one
of realism is misprinted as "24.0.3" and read as 24.03."""

_DRAWS, _MATCHED = 1000, 100
_MOST_VALUES = 5_000_000  # of all draws: fewer for many participants
_SD_TOLERANCE = 0.02  # of SDs that are printed with one decimal
_STEPS_EACH = 150  # participant, to come near an SD that may be out of reach


def simulated_answers(
    participants: int,
    effect: str = "paper",
    *,
    seed: int,
    sequences: tuple[str, ...] = SEQUENCES,
    like: Mapping[str, str] | None = None,
    shares: Sequence[float] = (),
) -> Answers:
    """Return the answers of simulated participants.

    For the effect "paper" the sample itself has the reported means and SDs (to the
    printed decimal) and agreements near the reported ones: the draws from the
    population that are nearest to the paper's W and SDs are taken, single ratings are
    moved by one until means and SDs fit, and the one that is then nearest to the W is
    kept. Any other effect (see `effect_named`) is one draw from its population,
    whose sample scatters as samples do, and so is one with other feedbacks, `like`
    (see `for_feedbacks`), or `shares` of the effect (see `at_sequences`). The same seed
    gives the same answers.
    """
    SIMULATED_PARTICIPANTS.parse("participants", str(participants))
    population = effect_named(effect)
    if like is not None:
        population = for_feedbacks(population, like)
    if shares:
        population = at_sequences(population, shares)
    rng = np.random.default_rng([seed, participants])
    shape = (participants, len(sequences))
    if effect == "paper" and like is None and not shares:
        drawn = drawn_ratings(population, (_draws(shape, population), *shape), rng)
        order = np.argsort(_distance(drawn, population.qoe_sds))[:_MATCHED]
        matched = np.stack([_matched(drawn[i], population, rng) for i in order])
        ratings = matched[np.argmin(_distance(matched))]
    else:
        ratings = drawn_ratings(population, (1, *shape), rng)[0]
    people = tuple(_person(number, rng) for number in range(1, participants + 1))
    return Answers(
        people,
        tuple(_ratings(people, sequences, population, ratings)),
        sequences,
        population.feedbacks,
        population.factors,
    )


def _draws(shape: tuple[int, int], effect: PopulationEffect) -> int:
    each = shape[0] * shape[1] * effect.factor_means.size
    return max(10, min(_DRAWS, _MOST_VALUES // each))


def _distance(drawn: Floats, qoe_sds: Floats | None = None) -> Floats:
    """Return how far studies (D, P, S, F, K) are from the paper's W, and from its SDs."""
    people, feedbacks = drawn.shape[1], drawn.shape[3]
    by_factor = np.moveaxis(drawn.mean(axis=2), 3, 0)  # (K, D, P, F)
    measures = np.concatenate([by_factor.sum(axis=0, keepdims=True), by_factor])
    chi2 = chi_squares(np.round(measures, 9))
    w = np.nan_to_num(chi2) / (people * (feedbacks - 1))
    distance = ((w - np.array(PAPER_W)[:, None]) ** 2).sum(axis=0)
    if qoe_sds is not None and people > 1:
        apart = measures[0].std(axis=1, ddof=1) / qoe_sds - 1.0
        distance += (apart**2).sum(axis=1)
    return np.asarray(distance)


def _matched(
    ratings: Floats, effect: PopulationEffect, rng: np.random.Generator
) -> Floats:
    """Move single ratings (P, S, F, K) until means and SDs are the effect's."""
    for place, (means, sd) in enumerate(
        zip(effect.factor_means, effect.qoe_sds, strict=True)
    ):
        part = ratings[:, :, place]
        for factor, mean in enumerate(means):
            _match_mean(part[:, :, factor], float(mean), rng)
        if len(part) > 1:
            _match_sd(part, float(sd), rng)
    return ratings


def _match_mean(values: Floats, mean: float, rng: np.random.Generator) -> None:
    """Move values (P, S) by one until their sum is the nearest to the mean."""
    while left := round(mean * values.size) - round(values.sum()):
        step = np.sign(left)
        room = np.argwhere(values < SCALE[1] if step > 0 else values > SCALE[0])
        values[tuple(rng.choice(room))] += step


def _match_sd(part: Floats, sd: float, rng: np.random.Generator) -> None:
    """Move a step from one participant to another until QoE (P, S, K) has its SD.

    Both steps are of one factor, whose mean stays.
    """
    people, sequences, factors = part.shape
    for _ in range(_STEPS_EACH * people):
        qoe = part.sum(axis=(1, 2))
        left = sd - float(qoe.std(ddof=1)) / sequences
        if abs(left) < _SD_TOLERANCE:
            return
        giver, taker = rng.choice(people, 2, replace=False)
        if (qoe[giver] < qoe[taker]) != (left > 0.0) or qoe[giver] == qoe[taker]:
            continue
        factor = rng.integers(factors)
        from_, to = rng.integers(sequences, size=2)
        if part[giver, from_, factor] > SCALE[0] and part[taker, to, factor] < SCALE[1]:
            part[giver, from_, factor] -= 1
            part[taker, to, factor] += 1


def _person(number: int, rng: np.random.Generator) -> Participant:
    return Participant(
        code=f"S{number:03d}",
        age=int(rng.integers(20, 45)),
        gender=str(rng.choice(["female", "male"])),
        handedness=str(rng.choice(["right", "left"], p=[0.9, 0.1])),
        used_device_before=bool(rng.random() < 0.4),
    )


def _ratings(
    people: tuple[Participant, ...],
    sequences: tuple[str, ...],
    effect: PopulationEffect,
    ratings: Floats,
) -> list[Rating]:
    names = [[person.code for person in people], sequences]
    axes = [*names, effect.feedbacks, effect.factors]
    found = []
    for cell, value in np.ndenumerate(ratings):
        code, sequence, feedback, factor = (
            axis[place] for axis, place in zip(axes, cell, strict=True)
        )
        found.append(
            Rating(code, sequence, feedback, factor, int(value), is_valid=True)
        )
    return found
