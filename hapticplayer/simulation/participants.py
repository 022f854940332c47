"""Answers of participants who never sat there, with the paper's means and spreads."""

import numpy as np

from hapticplayer.errors import UsageError
from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.effects import (
    Effect,
    drawn_ratings,
    effect_named,
)
from hapticplayer.study.analysis.friedman import chi_squares
from hapticplayer.study.analysis.scores import SCALE
from hapticplayer.study.answers import Answers, Participant, Rating

SEQUENCES = ("bike", "horse", "car-turning", "car-braking")
PAPER_W = (0.824, 0.801, 0.889, 0.293, 0.768)
"""Kendall's W of QoE and the factors: the printed chi-squares over n (k - 1) = 30; the one
of realism is misprinted as "24.0.3" and read as 24.03."""
MOST_PARTICIPANTS = 200

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
) -> Answers:
    """Return the answers of simulated participants.

    For the effect "paper" the sample itself has the reported means and SDs (to the
    printed decimal) and agreements near the reported ones: the draws from the
    population that are nearest to the paper's W and SDs are taken, single ratings are
    moved by one until means and SDs fit, and the one that is then nearest to the W is
    kept. Any other effect (see `effects.effect_named`) is one draw from its population,
    whose sample scatters as samples do. The same seed gives the same answers.

    Raises:
        UsageError: for an unknown effect or a number of participants out of range.
    """
    if not 0 < participants <= MOST_PARTICIPANTS:
        raise UsageError(
            "participants: 1 to {most} can be simulated", most=MOST_PARTICIPANTS
        )
    population = effect_named(effect)
    rng = np.random.default_rng([seed, participants])
    shape = (participants, len(sequences))
    if effect == "paper":
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


def _draws(shape: tuple[int, int], effect: Effect) -> int:
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


def _matched(ratings: Floats, effect: Effect, rng: np.random.Generator) -> Floats:
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
    effect: Effect,
    ratings: Floats,
) -> list[Rating]:
    names = [[person.code for person in people], sequences]
    axes = [*names, effect.feedbacks, effect.factors]
    found = []
    for cell, value in np.ndenumerate(ratings):
        code, sequence, feedback, factor = (
            axis[place] for axis, place in zip(axes, cell, strict=True)
        )
        found.append(Rating(code, sequence, feedback, factor, int(value), sound=True))
    return found
