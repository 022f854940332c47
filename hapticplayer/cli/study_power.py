"""The action `study power`, and what power is of: a population and its tests."""

import argparse
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.cli.common import refuse_idle, say, say_aside, shown_progress
from hapticplayer.cli.study_analysis import (
    add_effect,
    add_feedback,
    add_level,
    add_like,
    as_json,
    new_action,
    rated_like,
    say_assumed,
    shares_of,
)
from hapticplayer.errors import Progress, UsageError
from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.participants import (
    PopulationEffect,
    at_sequences,
    draw_effect,
    drawn_measure,
    effect_named,
    for_feedbacks,
)
from hapticplayer.study.analysis.cumulative_link import LinkFunction
from hapticplayer.study.analysis.model_power import (
    MODEL_STUDIES,
    LatentPopulation,
    find_model_power,
)
from hapticplayer.study.analysis.power import (
    RANK_STUDIES,
    Draw,
    Power,
    PowerGoal,
    draw_pilot,
    draw_rows,
    find_level_power,
    find_power,
    power_summary,
)
from hapticplayer.study.analysis.scores import Sample, sample_of, scores_of
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import chosen_text
from hapticplayer.study.definition import QOE, StudyFeedback

_MOST_SEQUENCES = 20
_FITTED = 1000
"""Simulated participants to whom the model of an effect is fitted."""


@dataclass(frozen=True, slots=True)
class Population:
    """Whom a planned study will ask.

    Attributes:
        text: where it is from.
        feedbacks: names.
        sequences: number of clips with each feedback.
        draw: simulated scores, for the rank tests.
        answers: returns answers (P, S, F), for the mixed model.
        is_item: whether they are steps of a single question.
        of_levels: levels, and draws of means at each (levels first), of factors in which
            sequences differ.
    """

    text: str
    feedbacks: tuple[str, ...]
    sequences: int
    draw: Draw
    answers: Callable[[], Floats]
    is_item: bool
    of_levels: tuple[tuple[tuple[str, ...], Draw], ...] = ()

    def power(
        self, goal: PowerGoal, link: LinkFunction | None, progress: Progress
    ) -> Power:
        """By rank tests, or by the mixed model with a link, without factors."""
        if link is None:
            return find_power(self.draw, self.feedbacks, goal, progress)
        if self.of_levels:
            say_aside(
                "--model tests feedbacks alone; leave it out for the power of the rank tests "
                "of the factors in which sequences differ"
            )
        model = LatentPopulation.of(self.answers(), link, is_item=self.is_item)
        of = self.feedbacks, self.sequences
        return find_model_power(model, *of, goal, progress)

    def level_powers(self, goal: PowerGoal, progress: Progress) -> Iterator[Power]:
        """By rank tests, of each factor in which sequences differ."""
        for levels, draw in self.of_levels:
            yield find_level_power(draw, self.feedbacks, levels, goal, progress)


def population_of_effect(
    name: str,
    measure: str,
    sequences: int,
    feedbacks: Sequence[StudyFeedback] = (),
    like: Sequence[str] = (),
    levels: Sequence[tuple[str, float]] = (),
) -> Population:
    """A population with a known effect; of the paper's feedbacks if none are named.

    `levels` has the level of each sequence in a factor, and its share of the effect.
    """
    effect = effect_named(name)
    if feedbacks:
        assumed = rated_like(feedbacks, like)
        effect = for_feedbacks(effect, assumed)
        say_assumed(assumed)
    if levels:
        effect = at_sequences(effect, [share for _, share in levels])

    def answers() -> Floats:
        shape, rng = (1, _FITTED, sequences), np.random.default_rng(_FITTED)
        return np.asarray(drawn_measure(effect, measure, shape, rng)[0])

    draw = draw_effect(effect, measure, sequences)
    names = [level for level, _ in levels]
    of_levels = (_drawn_levels(effect, measure, names),) if levels else ()
    of = effect.feedbacks, sequences, draw, answers, measure != QOE, of_levels
    text = "".join(
        f", {share:g} of it at {level}" for level, share in dict(levels).items()
    )
    return Population(f"effect {effect.name}{text}", *of)


def _drawn_levels(
    effect: PopulationEffect, measure: str, levels: Sequence[str]
) -> tuple[tuple[str, ...], Draw]:
    names = tuple(dict.fromkeys(levels))
    at = [np.flatnonzero(np.array(levels) == name) for name in names]

    def draw(studies: int, people: int, rng: np.random.Generator) -> Floats:
        shape = studies, people, len(levels)
        drawn = drawn_measure(effect, measure, shape, rng)
        means = [drawn[:, :, of].mean(axis=2) for of in at]
        return np.concatenate(means, axis=2)

    return names, draw


def population_of_pilot(pilot: Path, measure: str) -> Population:
    """The participants of a pilot study stand for all others."""
    scores = scores_of(read_answers(pilot))
    if measure not in scores.measures:
        known = ", ".join(scores.measures)
        raise UsageError(
            "there is no measure {measure!r}; choose one of {known}",
            measure=measure,
            known=known,
        )
    sample = sample_of(scores, measure)
    return Population(
        f"{len(sample.values)} participants of {pilot.name}",
        sample.feedbacks,
        len(scores.sequences),
        draw_pilot(sample),
        lambda: sample.by_condition,
        sample.is_item,
        tuple(_pilot_levels(sample, factor) for factor in sample.sequence_factors),
    )


def _pilot_levels(sample: Sample, factor: str) -> tuple[tuple[str, ...], Draw]:
    levels = sample.by_level(factor)
    values = np.concatenate(list(levels.values()), axis=1)
    values = values[~np.isnan(values).any(axis=1)]
    return tuple(levels), draw_rows(values)


def add_actions(actions: Any) -> None:
    """Add the action to the sub-parsers of `study`."""
    action = new_action(actions, "power", "how many participants a design needs", power)
    action.add_argument(
        "study",
        metavar="NAME",
        type=Path,
        nargs="?",
        help="a pilot study whose participants stand for the others (default: the "
        "population of --effect)",
    )
    add_effect(action)
    add_feedback(action, "of the design (default: none, random, realistic)")
    add_like(action)
    add_level(action)
    action.add_argument("--sequences", type=int, default=4, metavar="N")
    add_goal(action)


def add_goal(action: argparse.ArgumentParser) -> None:
    """Add the options of what is wanted, and of the tests."""
    action.add_argument(
        "--measure", default="qoe", help="qoe (default) or the key of a factor"
    )
    action.add_argument("--alpha", type=float, default=0.05)
    action.add_argument("--power", type=float, default=0.8, metavar="SHARE")
    action.add_argument(
        "--largest", type=int, default=60, metavar="N", help="participants to try"
    )
    action.add_argument(
        "--studies",
        type=int,
        metavar="N",
        help=f"to simulate (default: 2000, with --model {MODEL_STUDIES})",
    )
    action.add_argument(
        "--model",
        choices=[link.value for link in LinkFunction],
        help="simulate and test by the cumulative-link mixed model with this link, "
        "in place of the rank tests; takes some minutes",
    )


def goal_of(options: argparse.Namespace) -> tuple[PowerGoal, LinkFunction | None]:
    link = LinkFunction(options.model) if options.model else None
    studies = options.studies or (MODEL_STUDIES if link else RANK_STUDIES)
    of = options.alpha, options.power, options.largest, studies, options.seed
    return PowerGoal(*of), link


def power(options: argparse.Namespace) -> int:
    """Tell how many participants a design needs."""
    goal, link = goal_of(options)
    population = _population(options)
    if link is not None:
        refuse_idle(options, "with --model", "--level")
    with shown_progress() as progress:
        found = population.power(goal, link, progress)
        of_levels = () if link else tuple(population.level_powers(goal, progress))
    source = population.text
    report = {"population": source, "measure": options.measure, **power_summary(found)}
    if of_levels:
        report["levels"] = [power_summary(one) for one in of_levels]
    texts = [_power_text(one, options.measure, source) for one in (found, *of_levels)]
    say(as_json(report) if options.json else "\n".join(texts))
    return 0


def _population(options: argparse.Namespace) -> Population:
    if options.study is not None:
        for_a_plan = ("--sequences", "--effect", "--feedback", "--like", "--level")
        refuse_idle(options, f"with the answers of {options.study.name}", *for_a_plan)
        return population_of_pilot(options.study, options.measure)
    if not 1 <= options.sequences <= _MOST_SEQUENCES:
        raise UsageError(f"--sequences: 1 to {_MOST_SEQUENCES} can be simulated")
    if not options.feedback:
        refuse_idle(options, "without --feedback", "--like")
    feedbacks = [chosen_text(text) for text in options.feedback]
    of = options.effect, options.measure, options.sequences
    levels = _levels(shares_of(options.level), options.sequences)
    return population_of_effect(*of, feedbacks, options.like, levels)


def _levels(shares: dict[str, float], sequences: int) -> tuple[tuple[str, float], ...]:
    """Level and share of each sequence, equally many for each level."""
    names = tuple(shares.items())
    if not names:
        return ()
    if len(names) < 2 or sequences % len(names):
        raise UsageError(
            "--level: name all levels, such as first=1 and third=0.5; {sequences} sequences "
            "have to be a multiple of their number",
            sequences=sequences,
        )
    return names * (sequences // len(names))


def _power_text(found: Power, measure: str, source: str) -> str:
    goal = found.goal
    lines = [
        (
            f"{measure}, {source}: participants for a power of {goal.power:g} at "
            f"alpha {goal.alpha:g} ({goal.studies} simulated studies, power known "
            f"within {2.0 * found.standard_error:.3f})"
        )
    ]
    width = max(20, *(2 + len(name) for name in found.needed))
    for name, needed in found.needed.items():
        text = f"{needed}" if needed is not None else f"more than {goal.largest}"
        lines.append(f"  {name:<{width}}{text}")
    return "\n".join([*lines, f"tests: {found.tests}"])
