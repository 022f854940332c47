"""The action `study preregister`."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec

from hapticplayer import storage
from hapticplayer.cli.common import say, shown_progress
from hapticplayer.cli.study_analysis import (
    add_effect,
    add_level,
    add_like,
    add_options_of_analysis,
    as_json,
    levels_with,
    new_action,
    options_of_analysis,
    shares_of,
)
from hapticplayer.cli.study_power import (
    Population,
    add_goal,
    goal_of,
    population_of_effect,
    population_of_pilot,
)
from hapticplayer.errors import Message, UsageError
from hapticplayer.installation import require
from hapticplayer.simulation.participants import paper_effect
from hapticplayer.study.analysis.pdf import write_pdf
from hapticplayer.study.analysis.power import Power, power_summary
from hapticplayer.study.analysis.preregistered import (
    plan_document,
    planned_analysis,
    planned_power,
)
from hapticplayer.study.analysis.scores import shown_at
from hapticplayer.study.analysis.typesetting import page
from hapticplayer.study.definition import QOE
from hapticplayer.study.definition_reader import to_be_worded
from hapticplayer.study.preregistration import (
    PLAN_FILE,
    Intentions,
    PlannedPower,
    check_hypotheses,
    write_plan,
)
from hapticplayer.study.score_answers import RatedAnswers
from hapticplayer.study.study_folder import Study, open_study
from hapticplayer.study.watched import compared_keys

_STOP = (
    "Data collection ends when this number of participants has completed a session; the "
    "data are not analysed before."
)


def add_actions(actions: Any) -> None:
    """Add the action to the sub-parsers of `study`."""
    text = "write the plan of a study before its data"
    action = new_action(actions, "preregister", text, preregister)
    action.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    action.add_argument(
        "--hypothesis",
        action="append",
        default=[],
        metavar="TEXT",
        help='such as "qoe: realistic > none", which `analyse` tests, or any sentence; '
        "may be repeated",
    )
    action.add_argument(
        "--participants",
        type=int,
        metavar="N",
        help="planned number (default: the smallest with --power for all pairs)",
    )
    action.add_argument("--stop-rule", default=_STOP, metavar="TEXT")
    action.add_argument(
        "--exclude",
        action="append",
        default=[],
        metavar="RULE",
        help="why participants or trials will be left out, in the words of `study drop "
        "--reason`; may be repeated",
    )
    action.add_argument(
        "--pilot", type=Path, metavar="STUDY", help="whose participants power is of"
    )
    action.add_argument(
        "--without-power", default="", metavar="WHY", help="state no power"
    )
    add_effect(action)
    add_like(action)
    add_level(action)
    add_goal(action)
    add_options_of_analysis(action)


def preregister(options: argparse.Namespace) -> int:
    """Write the plan into the study's folder, as JSON, HTML and PDF."""
    require("study", Message("writing a plan"))
    study = open_study(options.study)
    definition = study.definition
    storage.refuse_existing(study.folder / PLAN_FILE)
    if lacking := list(to_be_worded(definition)):
        raise UsageError(
            "{count} texts of the study are still to be written, the first is {first}; "
            "complete the definition first",
            count=len(lacking),
            first=lacking[0],
        )
    rated = RatedAnswers(definition)
    live = compared_keys(definition)
    measures = (*((QOE,) if rated.qoe else ()), *rated.ranges, *live)
    check_hypotheses(options.hypothesis, measures, definition)
    participants, power = _planned(study, options, measures)
    rules = options.stop_rule, options.exclude
    intended = Intentions(options.hypothesis, participants, power, *rules)
    has_factors = bool(definition.sequence_factors)
    analysis = planned_analysis(options_of_analysis(options), has_factors=has_factors)
    plan = write_plan(study, intended, analysis)
    blocks = tuple(plan_document(plan, definition))
    target = (study.folder / PLAN_FILE).with_suffix
    html = page(definition.title, "", blocks, {})
    storage.replace_file(target(".html"), html.encode(), storage.PRIVATE_FILE)
    write_pdf(target(".pdf"), definition.title, "", blocks, {})
    target(".pdf").chmod(storage.PRIVATE_FILE)
    if options.json:
        say(as_json(msgspec.to_builtins(plan)))
    else:
        say(
            f"{target('.pdf')}: {participants} participants, SHA-256 {plan.sha256}\n"
            "Give it to a registry before the first session; `study analyse` states each "
            "deviation."
        )
    return 0


def _planned(
    study: Study, options: argparse.Namespace, measures: tuple[str, ...]
) -> tuple[int, PlannedPower | str]:
    """The number of participants, and its power or why there is none."""
    if options.without_power:
        if options.participants is None:
            raise UsageError("--without-power needs --participants")
        return options.participants, options.without_power
    population = _population(study, options, measures)
    goal, link = goal_of(options)
    if options.participants is not None:
        goal = replace(goal, largest=options.participants)
    with shown_progress() as progress:
        found: Power = population.power(goal, link, progress)
        of_levels = () if link else tuple(population.level_powers(goal, progress))
    needed = options.participants or found.needed["all pairs"]
    if needed is None:
        raise UsageError(
            "{largest} participants are too few for a power of {power}; choose the number "
            "by --participants, or raise --largest",
            largest=goal.largest,
            power=f"{goal.power:g}",
        )
    of = population.text, options.measure
    summaries = [power_summary(one) for one in (found, *of_levels)]
    return needed, planned_power(*of, summaries, needed)


def _population(
    study: Study, options: argparse.Namespace, measures: tuple[str, ...]
) -> Population:
    if options.pilot is not None:
        return population_of_pilot(options.pilot, options.measure)
    known = (QOE, *paper_effect().factors)
    if options.measure not in measures or options.measure not in known:
        raise UsageError(
            "no effect on {measure!r} is known for this study; give --pilot STUDY, "
            "--measure with one of {known}, or --without-power WHY",
            measure=options.measure,
            known=", ".join(one for one in known if one in measures) or "none",
        )
    definition = study.definition
    of = options.effect, options.measure, len(definition.sequences)
    feedbacks = sorted(definition.chosen_feedbacks, key=lambda one: shown_at(one.name))
    levels = levels_with(definition, shares_of(options.level))
    return population_of_effect(*of, feedbacks, options.like, levels)
