"""Power by studies that are simulated from the mixed model and tested by it.

The population is the model that fits the answers of a pilot study, or of many simulated
participants; its estimates are taken for the truth.
"""

from collections.abc import Callable
from itertools import combinations
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import Message, Progress, UsageError
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.cumulative_link import LinkFunction, fit
from hapticplayer.study.analysis.ordinal_mixed import (
    difference,
    likelihood_ratio,
    ordered_answers,
)
from hapticplayer.study.analysis.power import (
    ALL_PAIRS,
    Power,
    PowerGoal,
    needed_size,
)
from hapticplayer.study.analysis.statistic import holm

ALL_FEEDBACKS = "all feedbacks"
LEAST_SIZE, LEAST_PILOT = 4, 5
MODEL_STUDIES = 400
"""Studies that are simulated for each number, where nobody says how many."""


class LatentPopulation(NamedTuple):
    """What people answer: a latent value, cut into levels.

    Attributes:
        link: distribution of what is left of it.
        thresholds: between the levels.
        effects: of the feedbacks after the first one, against it.
        of_people: standard deviation of participants.
        of_clips: standard deviation of sequences.
        of_cells: standard deviation of participants with each feedback.
    """

    link: LinkFunction
    thresholds: Floats
    effects: Floats
    of_people: float
    of_clips: float
    of_cells: float = 0.0

    @classmethod
    def of(
        cls, values: Floats, link: LinkFunction, *, is_item: bool
    ) -> "LatentPopulation":
        """The population of answers (P, S, F), NaN where missing."""
        answers = ordered_answers(values, is_item=is_item)
        answered = ~np.isnan(values).all(axis=(1, 2))
        if answers is None or answered.sum() < LEAST_PILOT:
            raise UsageError(
                "the mixed model cannot be fitted: answers of at least {least} "
                "participants to all feedbacks are needed, and not all alike",
                least=LEAST_PILOT,
            )
        found = fit(answers, link)
        differences = (difference(found, 0, j) for j in range(1, values.shape[2]))
        if any(one["estimate"] is None for one in differences):
            raise UsageError(
                "the mixed model cannot be fitted: nearly all answers to a feedback are "
                "at an end of the scale; use the rank tests"
            )
        of_cells, of_people, of_clips = [
            *([0.0] * (2 - answers.nested)),
            *found.deviations.tolist(),
            0.0,
        ][:3]
        effects = found.effects
        return cls(link, found.thresholds, effects, of_people, of_clips, of_cells)

    def drawn(self, people: int, clips: int, rng: np.random.Generator) -> Floats:
        """Levels (P, S, F) of a study, from 0."""
        shape = (people, clips, 1 + len(self.effects))
        is_logit = self.link is LinkFunction.LOGIT
        latent = rng.logistic(size=shape) if is_logit else rng.normal(size=shape)
        latent += self.of_people * rng.normal(size=(people, 1, 1))
        latent += self.of_clips * rng.normal(size=(clips, 1))
        if self.of_cells:
            latent += self.of_cells * rng.normal(size=(people, 1, shape[2]))
        latent += np.array([0.0, *self.effects])
        return np.searchsorted(self.thresholds, latent).astype(np.float64)


def find_model_power(
    population: LatentPopulation,
    feedbacks: tuple[str, ...],
    sequences: int,
    goal: PowerGoal,
    progress: Progress = lambda _fraction, _step: None,
) -> Power:
    """The power of the mixed model at the numbers of participants that decide.

    Fits take long: numbers between two are tried only where the wanted power lies between.
    """
    pairs = [f"{a}-{b}" for a, b in combinations(feedbacks, 2)]
    names = (ALL_FEEDBACKS, *pairs, ALL_PAIRS)
    shares: dict[int, dict[str, float]] = {}

    def power_of(size: int) -> None:
        step = Message("simulating studies of {size} participants", size=size)
        before, tries = len(shares), _tries(goal.largest, len(names))

        def report(share: float) -> None:
            progress(min(0.95, (before + share) / tries), step)

        found = significant_shares(population, sequences, size, goal, report)
        shares[size] = dict(zip(names, found.tolist(), strict=True))

    for size in dict.fromkeys((goal.largest, LEAST_SIZE)):
        power_of(size)
    for name in names:
        low, high = LEAST_SIZE, goal.largest
        while high - low > 1 and shares[high][name] >= goal.power > shares[low][name]:
            middle = (low + high) // 2
            if middle not in shares:
                power_of(middle)
            is_enough = shares[middle][name] >= goal.power
            low, high = (low, middle) if is_enough else (middle, high)
    sizes = tuple(sorted(shares))
    curves = {name: tuple(shares[size][name] for size in sizes) for name in names}
    needed = {name: needed_size(row, sizes, goal.power) for name, row in curves.items()}
    tests = Message(
        "cumulative-link mixed model ({link}): likelihood ratio of all feedbacks, pairs "
        "by Wald's t with Holm",
        link=population.link.value,
    )
    return Power(goal, sizes, curves, needed, tests)


def _tries(largest: int, names: int) -> float:
    """How many numbers are tried at most, for the progress."""
    return 2.0 + names * float(np.log2(largest))


def significant_shares(
    population: LatentPopulation,
    sequences: int,
    people: int,
    goal: PowerGoal,
    report: Callable[[float], None],
) -> Floats:
    """Share of studies in which all feedbacks, each pair, and all pairs differ."""
    rng = np.random.default_rng([goal.seed, people])
    count = 1 + len(population.effects)
    hits = np.zeros(2 + count * (count - 1) // 2)
    for done in range(goal.studies):
        report(done / goal.studies)
        p_all, *p_pairs = _p_values(population, people, sequences, rng)
        differ = [p <= goal.alpha for p in (p_all, *p_pairs)]
        hits += [*differ, all(differ[1:])]
    return np.asarray(hits / goal.studies)


def _p_values(
    population: LatentPopulation,
    people: int,
    sequences: int,
    rng: np.random.Generator,
) -> list[float]:
    """Of all feedbacks, and of the pairs with Holm's correction; 1 without an estimate."""
    count = 1 + len(population.effects)
    pairs = list(combinations(range(count), 2))
    answers = ordered_answers(population.drawn(people, sequences, rng))
    if answers is None:
        return [1.0] * (1 + len(pairs))
    full, together = likelihood_ratio(answers, population.link)
    found = holm([difference(full, i, j)["p"] for i, j in pairs])
    return [together["p_all"], *(1.0 if p is None else p for p in found)]
