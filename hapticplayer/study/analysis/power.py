"""Power analysis by simulated studies.

Power is the share of simulated studies in which a test is significant. Pairs are tested as
`analyse` tests them, by the signed-rank test with Holm's correction, feedbacks together by
Friedman's test: both exact to MOST_EXACT participants, beyond by approximations corrected
for ties.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from scipy import stats

from hapticplayer.errors import Message, Progress, UsageError
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.friedman import can_be_counted, chi_squares, exact_p
from hapticplayer.study.analysis.rank_tests import signed_rank_p
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.sequence_factor_tests import level_contrasts
from hapticplayer.study.analysis.statistic import holm_of_columns

FRIEDMAN, ALL_PAIRS = "friedman", "all pairs"
MOST_PARTICIPANTS, MOST_STUDIES = 300, 100_000
RANK_STUDIES = 2000
MOST_EXACT = 20
"""Above this number the normal approximation decides otherwise in 0 to 2 % of studies."""
_BLOCK = 100
_EACH_UP_TO, _STEP = 30, 5

TESTS = Message(
    "pairs: Wilcoxon with Holm; friedman: Friedman's test; both exact to {most} "
    "participants, then approximations",
    most=MOST_EXACT,
)

LEVEL_TESTS = Message(
    "levels, and differences of feedbacks at two levels: Wilcoxon with Holm over all, exact "
    "to {most} participants, then an approximation",
    most=MOST_EXACT,
)

Draw = Callable[[int, int, np.random.Generator], Floats]
"""Returns simulated scores (studies, participants, F), or as many of something else."""


@dataclass(frozen=True, slots=True)
class PowerGoal:
    """The question to the power analysis.

    Attributes:
        alpha: significance level.
        power: wanted share of significant studies.
        largest: highest number of participants to try.
        studies: simulated studies for each number.
        seed: of the simulation.
    """

    alpha: float = 0.05
    power: float = 0.8
    largest: int = 60
    studies: int = RANK_STUDIES
    seed: int = 2012

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        if not 0.0 < self.alpha < 1.0 or not 0.0 < self.power < 1.0:
            raise UsageError("alpha and power must be between 0 and 1")
        if not 3 <= self.largest <= MOST_PARTICIPANTS:
            raise UsageError(
                "the largest number of participants must be between 3 and {most}",
                most=MOST_PARTICIPANTS,
            )
        if not _BLOCK <= self.studies <= MOST_STUDIES:
            raise UsageError(
                "the number of simulated studies must be between {least} and {most}",
                least=_BLOCK,
                most=MOST_STUDIES,
            )


@dataclass(frozen=True, slots=True)
class Power:
    """The result of a power analysis.

    Attributes:
        goal: the question.
        participants: numbers (N,) that were tried.
        curves: power (N,) by test: "friedman", the pairs, "all pairs".
        needed: smallest sufficient number by test; None if even the largest is too
            small.
        tests: that were simulated, in words.
    """

    goal: PowerGoal
    participants: tuple[int, ...]
    curves: dict[str, tuple[float, ...]]
    needed: dict[str, int | None]
    tests: Message = TESTS

    @property
    def standard_error(self) -> float:
        wanted = self.goal.power
        return float(np.sqrt(wanted * (1.0 - wanted) / self.goal.studies))


def draw_pilot(pilot: Sample) -> Draw:
    """Return draws with replacement from the participants of a pilot study."""
    return draw_rows(pilot.values)


def draw_rows(values: Floats) -> Draw:
    """Return draws with replacement from (P, C)."""
    if len(values) < 5:
        raise UsageError("a pilot study must have at least five complete participants")

    def draw(studies: int, people: int, rng: np.random.Generator) -> Floats:
        return values[rng.integers(len(values), size=(studies, people))]

    return draw


def find_power(
    draw: Draw,
    feedbacks: tuple[str, ...],
    goal: PowerGoal,
    progress: Progress = lambda _fraction, _step: None,
) -> Power:
    """Return the power for each number of participants.

    Args:
        draw: returns simulated scores.
        feedbacks: names.
        goal: the question.
        progress: called with the fraction done and the step; raises to cancel.
    """
    pairs = list(combinations(range(len(feedbacks)), 2))
    names = [FRIEDMAN, *(f"{feedbacks[i]}-{feedbacks[j]}" for i, j in pairs), ALL_PAIRS]

    def significant(values: Floats) -> Floats:
        return _significant(values, pairs, goal.alpha)

    return _simulated(draw, names, significant, goal, TESTS, progress)


def find_level_power(
    draw: Draw,
    feedbacks: tuple[str, ...],
    levels: tuple[str, ...],
    goal: PowerGoal,
    progress: Progress = lambda _fraction, _step: None,
) -> Power:
    """The power of the tests of a factor in which sequences differ.

    Args:
        draw: returns simulated means over the sequences of a level
            (studies, participants, L * F), levels first.
        feedbacks: names.
        levels: names.
        goal: the question.
        progress: called with the fraction done and the step; raises to cancel.
    """
    contrasts = level_contrasts(feedbacks, levels)
    weights = np.stack(list(contrasts.values()))

    def significant(values: Floats) -> Floats:
        p = np.stack([_pair_p(values @ one) for one in weights])
        return np.asarray((holm_of_columns(p) <= goal.alpha).sum(axis=1), np.float64)

    of = list(contrasts), significant, goal, LEVEL_TESTS
    return _simulated(draw, *of, progress)


def _simulated(
    draw: Draw,
    names: list[str],
    significant: Callable[[Floats], Floats],
    goal: PowerGoal,
    tests: Message,
    progress: Progress,
) -> Power:
    """The power of tests by name; `significant` counts studies (D, P, C) by test."""
    sizes = _sizes(goal.largest)
    hits = np.zeros((len(names), len(sizes)))
    rng = np.random.default_rng(goal.seed)
    for begin in range(0, goal.studies, _BLOCK):
        progress(
            begin / goal.studies,
            Message(
                "simulated {begin} of {studies} studies",
                begin=begin,
                studies=goal.studies,
            ),
        )
        count = min(_BLOCK, goal.studies - begin)
        values = draw(count, goal.largest, rng)
        for place, size in enumerate(sizes):
            hits[:, place] += significant(values[:, :size])
    shares = hits / goal.studies
    curves = {
        name: tuple(row.tolist()) for name, row in zip(names, shares, strict=True)
    }
    needed = {name: needed_size(row, sizes, goal.power) for name, row in curves.items()}
    return Power(goal, sizes, curves, needed, tests)


def power_summary(found: Power) -> dict[str, Any]:
    """Return the result as JSON."""
    goal = found.goal
    return {
        "needed": found.needed,
        "alpha": goal.alpha,
        "power": goal.power,
        "standard_error": found.standard_error,
        "studies": goal.studies,
        "seed": goal.seed,
        "tests": found.tests,
        "participants": list(found.participants),
        "curves": {name: list(row) for name, row in found.curves.items()},
    }


def _sizes(largest: int) -> tuple[int, ...]:
    each = range(3, min(largest, _EACH_UP_TO) + 1)
    return (*each, *range(_EACH_UP_TO + _STEP, largest + 1, _STEP))


def _significant(values: Floats, pairs: list[tuple[int, int]], alpha: float) -> Floats:
    """Return the number of studies (D, n, F) in which each test is significant."""
    values = np.round(values, 9)
    omnibus = _friedman_p(values) <= alpha
    p = np.stack([_pair_p(values[:, :, j] - values[:, :, i]) for i, j in pairs])
    significant = holm_of_columns(p) <= alpha
    rows = np.stack([omnibus, *significant, significant.all(axis=0)])
    return np.asarray(rows.sum(axis=1), np.float64)


def _friedman_p(values: Floats) -> Floats:
    """Return p of Friedman's test of each study (D, n, F); 1 where all is tied."""
    _, people, feedbacks = values.shape
    if people <= MOST_EXACT and can_be_counted(people, feedbacks):
        ranks = stats.rankdata(values, axis=2)
        return np.array([exact_p(one, Resampling(), "power")[0] for one in ranks])
    chi2 = np.nan_to_num(chi_squares(values))
    return np.asarray(stats.chi2.sf(chi2, feedbacks - 1), np.float64)


def _pair_p(differences: Floats) -> Floats:
    """Return p of the signed-rank test of each row (D, n); 1 without differences."""
    differences = np.round(differences, 9)
    if differences.shape[1] <= MOST_EXACT:
        return signed_rank_p(differences)
    with np.errstate(invalid="ignore"):
        found = stats.wilcoxon(differences, axis=1, method="asymptotic")
    return np.asarray(np.nan_to_num(found.pvalue, nan=1.0), np.float64)


def needed_size(
    row: tuple[float, ...], sizes: tuple[int, ...], wanted: float
) -> int | None:
    """The smallest number from which on the power is as wanted."""
    needed = None
    for share, size in zip(reversed(row), reversed(sizes), strict=True):
        if share < wanted:
            break
        needed = size
    return needed
