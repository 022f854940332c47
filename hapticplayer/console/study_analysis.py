"""Analyses studies, simulates participants, and tells how many a design needs."""

import argparse
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol

from hapticplayer.console.speech import interruptible, say, shown_progress
from hapticplayer.errors import UsageError
from hapticplayer.sequence import files
from hapticplayer.simulation.effects import draw_effect, effect_named, paper_effect
from hapticplayer.simulation.participants import (
    WriteSession,
    simulated_answers,
    write_simulated,
)
from hapticplayer.study.analysis import Analysis, Choices, MissingPolicy, Resampling
from hapticplayer.study.analysis.consistency import ConsistencyAnalysis
from hapticplayer.study.analysis.power import (
    Draw,
    Goal,
    Power,
    draw_pilot,
    find_power,
    power_summary,
)
from hapticplayer.study.analysis.report import (
    StudyAnalysis,
    analyse_study,
    parts_of,
    write_report,
)
from hapticplayer.study.analysis.scores import sample_of, scores_of
from hapticplayer.study.analysis.statistic import number, p_value
from hapticplayer.study.answers import Answers

_MOST_SEQUENCES = 20


class StudyStore(Protocol):
    """What these commands need of the folders of studies."""

    def read(self, folder: Path) -> Answers:
        """Return all answers of a study."""

    def design(self, folder: Path) -> Answers:
        """Return a study's design without answers; a missing study is made."""

    def writer(self, folder: Path, origin: Mapping[str, Any]) -> WriteSession:
        """Return what adds scripted sessions, marked by their origin."""


def analyse(options: argparse.Namespace, store: StudyStore) -> int:
    """Print the statistics of a study, and write its report where that is wanted."""
    if options.output is not None:
        files.refuse_existing(options.output)
    choices = Choices(
        MissingPolicy(options.missing), options.with_unsound, Resampling(options.seed)
    )
    with interruptible(), shown_progress() as progress:
        found = analyse_study(
            store.read(options.study), choices, lambda f, step: progress(0.5 * f, step)
        )
        if options.output is not None:
            title = f"Study {options.study.resolve().name}"
            write_report(
                found,
                options.output,
                title,
                lambda f, step: progress(0.5 + 0.5 * f, step),
            )
    numbers = parts_of(found).numbers
    say(_json(numbers) if options.json else _analysis_text(found, numbers))
    if options.output is not None and not options.json:
        say(f"\nreport: {options.output / 'report.html'}")
    return 0


def simulate(options: argparse.Namespace, store: StudyStore) -> int:
    """Add simulated participants to a study, as sessions that are marked as such."""
    effect_named(options.effect)
    design, paper = store.design(options.study), paper_effect()
    if set(design.feedbacks) != set(paper.feedbacks) or set(design.factors) != set(
        paper.factors
    ):
        raise UsageError(
            "only studies with the paper's feedbacks and factors can be simulated "
            f"({', '.join(paper.feedbacks)}; {', '.join(paper.factors)})"
        )
    answers = simulated_answers(
        options.participants,
        options.effect,
        seed=options.seed,
        sequences=design.sequences,
    )
    origin = {"simulated": True, "effect": options.effect, "seed": options.seed}
    with interruptible():
        codes = write_simulated(answers, store.writer(options.study, origin))
    report = {"study": str(options.study), **origin, "participants": codes}
    told = f"{options.study}: {len(codes)} simulated participants, marked as such"
    say(_json(report) if options.json else told)
    return 0


def power(options: argparse.Namespace, store: StudyStore) -> int:
    """Tell how many participants a design needs."""
    goal = Goal(
        options.alpha, options.power, options.largest, options.studies, options.seed
    )
    draw, feedbacks, source = _population(options, store)
    with interruptible(), shown_progress() as progress:
        found = find_power(draw, feedbacks, goal, progress)
    report = {"population": source, "measure": options.measure, **power_summary(found)}
    say(_json(report) if options.json else _power_text(found, options.measure, source))
    return 0


def _population(
    options: argparse.Namespace, store: StudyStore
) -> tuple[Draw, tuple[str, ...], str]:
    if options.study is None:
        if not 1 <= options.sequences <= _MOST_SEQUENCES:
            raise UsageError(f"--sequences: 1 to {_MOST_SEQUENCES} can be simulated")
        effect = effect_named(options.effect)
        draw = draw_effect(effect, options.measure, options.sequences)
        return draw, effect.feedbacks, f"effect {effect.name}"
    scores = scores_of(store.read(options.study))
    if options.measure not in scores.measures:
        known = ", ".join(scores.measures)
        raise UsageError(f"there is no measure {options.measure!r}; there is {known}")
    pilot = sample_of(scores, options.measure)
    source = f"{len(pilot.values)} participants of {options.study.name}"
    return draw_pilot(pilot), pilot.feedbacks, source


def _json(report: dict[str, Any]) -> str:
    return json.dumps(report, ensure_ascii=False, allow_nan=False)


def _analysis_text(found: StudyAnalysis, report: dict[str, Any]) -> str:
    lines = (
        _curve_lines(found)
        if isinstance(found, ConsistencyAnalysis)
        else _test_lines(found)
    )
    people = f"{report['missing']['participants']} participants"
    return "\n".join([people, *lines, *(f"note: {n}" for n in report["warnings"])])


def _curve_lines(found: ConsistencyAnalysis) -> list[str]:
    return [
        f"  {axis} {sequence}: "
        + ", ".join(f"{name} {number(v)}" for name, v in curve.values.items())
        for axis, one in found.axes.items()
        for sequence, curve in one.curves.items()
        if curve is not None
    ]


def _test_lines(found: Analysis) -> list[str]:
    lines = []
    for name, one in found.measures.items():
        means = ", ".join(
            f"{key} {number(part.mean)} (SD {number(part.sd)})"
            for key, part in one.feedbacks.items()
        )
        test = found.found["friedman"][name]
        lines.append(
            f"  {name:<13}{means}\n{'':15}Friedman chi2 {number(test['chi2'])}, "
            f"p {p_value(test['p'])}, exact {p_value(test['p_exact'])}, "
            f"Holm {p_value(test['p_holm'])}, W {number(test['kendall_w'], 3)}"
        )
        lines += [
            f"{'':15}{pair}: Wilcoxon Holm {p_value(part['p_holm'])}, "
            f"r {number(part['rank_biserial'])}"
            for pair, part in found.found["wilcoxon"][name].items()
        ]
    return lines


def _power_text(found: Power, measure: str, source: str) -> str:
    goal = found.goal
    lines = [
        (
            f"{measure}, {source}: participants for a power of {goal.power:g} at "
            f"alpha {goal.alpha:g} ({goal.studies} simulated studies, power known "
            f"within {2.0 * found.standard_error:.3f})"
        )
    ]
    for name, needed in found.needed.items():
        told = f"{needed}" if needed is not None else f"more than {goal.largest}"
        lines.append(f"  {name:<20}{told}")
    return "\n".join(lines)
