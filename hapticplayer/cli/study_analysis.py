"""The actions `study analyse`, `simulate` and `power`."""

import argparse
import contextlib
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from hapticplayer.cli.common import (
    add_number,
    refuse_idle,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import Message, UsageError
from hapticplayer.installation import require
from hapticplayer.model import Feedback, ranges
from hapticplayer.rendering import condition_named
from hapticplayer.simulation.participants import (
    draw_effect,
    effect_named,
    for_feedbacks,
    paper_effect,
    simulated_answers,
)
from hapticplayer.simulation.sessions import random_questions, write_answers
from hapticplayer.storage import (
    FOLDER,
    PRIVATE_FOLDER,
    StorageError,
    folder_written_aside,
    refuse_existing,
    write_private,
)
from hapticplayer.study.analysis import (
    AnalysisOptions,
    MissingPolicy,
    Resampling,
)
from hapticplayer.study.analysis.analysis import STATISTICS
from hapticplayer.study.analysis.parts import ReportParts
from hapticplayer.study.analysis.power import (
    TESTS,
    Draw,
    Power,
    PowerGoal,
    draw_pilot,
    find_power,
    power_summary,
)
from hapticplayer.study.analysis.report import (
    analyse_study,
    write_report,
)
from hapticplayer.study.analysis.scores import sample_of, scores_of
from hapticplayer.study.answers import collect_answers, read_answers
from hapticplayer.study.creation import chosen_text, new_definition
from hapticplayer.study.definition import StudyFeedback, TrialKind
from hapticplayer.study.definition_reader import DEFINITION
from hapticplayer.study.study_folder import Study, open_study

_SEED = 2012


def add_actions(actions: Any) -> None:
    """Add the actions to the sub-parsers of `study`."""
    _add_analyse(actions)
    _add_simulate(actions)
    _add_power(actions)


def _add_analyse(actions: Any) -> None:
    action = _action(actions, "analyse", "statistics and figures of a study", analyse)
    action.formatter_class = argparse.RawDescriptionHelpFormatter
    action.epilog = "statistics of ratings:\n" + "\n".join(
        f"  {name:<20}  {one.title}" for name, one in STATISTICS.items()
    )
    action.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    action.add_argument(
        "--output",
        metavar="DIR",
        type=Path,
        help="write the report (HTML, PDF), figures and numbers into a new folder",
    )
    action.add_argument(
        "--missing",
        choices=[policy.value for policy in MissingPolicy],
        default=MissingPolicy.PAIRED.value,
        help="where answers are missing: leave their sequence out for all feedbacks of "
        "this participant (default), or leave the participant out",
    )
    action.add_argument(
        "--include-invalid",
        action="store_true",
        help="also count trials whose playback was not valid",
    )


def _add_simulate(actions: Any) -> None:
    action = _action(
        actions, "simulate", "add simulated participants to a study", simulate
    )
    action.add_argument(
        "study",
        metavar="NAME",
        type=Path,
        help="folder of the study; made from the template qoe2012 if it is missing",
    )
    most = ranges.SIMULATED_PARTICIPANTS
    add_number(action, "--participants", most, default=15, metavar="N")
    _add_effect(action)
    _add_like(action)


def _add_power(actions: Any) -> None:
    action = _action(actions, "power", "how many participants a design needs", power)
    action.add_argument(
        "study",
        metavar="NAME",
        type=Path,
        nargs="?",
        help="a pilot study whose participants stand for the others (default: the "
        "population of --effect)",
    )
    _add_effect(action)
    add_feedback(action, "of the design (default: none, random, realistic)")
    _add_like(action)
    action.add_argument(
        "--measure", default="qoe", help="qoe (default) or the key of a factor"
    )
    action.add_argument("--sequences", type=int, default=4, metavar="N")
    action.add_argument("--alpha", type=float, default=0.05)
    action.add_argument("--power", type=float, default=0.8, metavar="SHARE")
    action.add_argument(
        "--largest", type=int, default=60, metavar="N", help="participants to try"
    )
    action.add_argument(
        "--studies", type=int, default=2000, metavar="N", help="to simulate"
    )


def _add_effect(action: argparse.ArgumentParser) -> None:
    action.add_argument(
        "--effect",
        default="paper",
        metavar="E",
        help="paper (default), none, or a share of the paper's effect such as 0.5",
    )


def add_feedback(action: argparse.ArgumentParser, text: str) -> None:
    """Add the option that names feedback conditions."""
    action.add_argument(
        "--feedback",
        action="append",
        default=[],
        metavar="[KEY=]F",
        help=f"feedback {text}, such as late=delayed:delay_s=0.3; may be repeated",
    )


def _add_like(action: argparse.ArgumentParser) -> None:
    action.add_argument(
        "--like",
        action="append",
        default=[],
        metavar="KEY=F",
        help="the paper's condition (none, random, realistic) that a feedback is rated "
        "like; an assumption",
    )


def _action(
    actions: Any, name: str, summary: str, run: Callable[[argparse.Namespace], int]
) -> argparse.ArgumentParser:
    action: argparse.ArgumentParser = actions.add_parser(
        name, help=summary, description=summary
    )
    add_number(action, "--seed", ranges.SEED, default=_SEED)
    action.add_argument("--json", action="store_true", help="print the result as JSON")
    action.set_defaults(run=lambda chosen, _open_window: run(chosen))
    return action


_MOST_SEQUENCES = 20


def analyse(options: argparse.Namespace) -> int:
    """Print the statistics of a study, and write its report where that is wanted."""
    if options.output is not None:
        require("study", Message("writing a report"))
        refuse_existing(options.output, FOLDER)
    choices = AnalysisOptions(
        MissingPolicy(options.missing),
        options.include_invalid,
        Resampling(options.seed),
    )
    with shown_progress() as progress:
        found = analyse_study(
            read_answers(options.study, lambda f, step: progress(0.3 * f, step)),
            choices,
            lambda f, step: progress(0.3 + 0.3 * f, step),
        )
        if options.output is not None:
            write_report(
                found,
                options.output,
                found.answers.conduct.title,
                lambda f, step: progress(0.6 + 0.4 * f, step),
            )
    say(_json(found.numbers) if options.json else _analysis_text(found))
    if options.output is not None and not options.json:
        say(f"\nreport: {options.output / 'report.html'}")
    return 0


def simulate(options: argparse.Namespace) -> int:
    """Add simulated participants to a study, as sessions that are marked as such."""
    effect_named(options.effect)
    with _to_be_filled(options.study) as study:
        like, origin, codes = _simulated(study, options)
    report = {"study": str(options.study), **origin, "participants": codes}
    text = f"{options.study}: {len(codes)} simulated participants, marked as such"
    say(_json(report) if options.json else text)
    if not options.json:
        _say_assumed(like)
        if origin["at_random"]:
            say_aside(f"answered at random: {', '.join(origin['at_random'])}")
    return 0


def _simulated(
    study: Study, options: argparse.Namespace
) -> tuple[dict[str, str], dict[str, Any], list[str]]:
    """Write the sessions; what feedbacks are rated like, their origin, their codes."""
    design, paper = collect_answers(study), paper_effect()
    if study.definition.trial is not TrialKind.RATING:
        raise UsageError("only rating studies can be simulated")
    like = _rated_like(study.definition.chosen_feedbacks, options.like)
    answers = simulated_answers(
        options.participants,
        options.effect,
        seed=options.seed,
        sequences=design.sequences,
        like=None if set(like) == set(paper.feedbacks) == set(like.values()) else like,
    )
    origin = {"simulated": True, "effect": options.effect, "seed": options.seed}
    drawn = random_questions(study.definition, paper.factors)
    origin |= {"rated_like": like, "at_random": drawn}
    return like, origin, write_answers(study, answers, SystemClock(), origin=origin)


def _rated_like(
    feedbacks: Iterable[StudyFeedback], given: Iterable[str]
) -> dict[str, str]:
    """Return the paper's condition that each feedback is rated like, by key."""
    like = {}
    for one in feedbacks:
        found = condition_named(one.condition)
        # a track of which nothing is known is some force
        like[one.name] = str(found.simulated_as if found else Feedback.RANDOM)
    for text in given:
        key, mark, name = text.partition("=")
        if not mark or key not in like:
            raise UsageError(
                f"--like {text!r} has to be KEY=NAME; the keys are {', '.join(like)}"
            )
        like[key] = name
    return like


def _say_assumed(like: Mapping[str, str]) -> None:
    assumed = [f"{key} like {name}" for key, name in like.items() if key != name]
    if assumed:
        say_aside(f"assumed, not measured: {', '.join(assumed)} (--like changes it)")


def power(options: argparse.Namespace) -> int:
    """Tell how many participants a design needs."""
    goal = PowerGoal(
        options.alpha, options.power, options.largest, options.studies, options.seed
    )
    draw, feedbacks, source = _population(options)
    with shown_progress() as progress:
        found = find_power(draw, feedbacks, goal, progress)
    report = {"population": source, "measure": options.measure, **power_summary(found)}
    say(_json(report) if options.json else _power_text(found, options.measure, source))
    return 0


def _population(options: argparse.Namespace) -> tuple[Draw, tuple[str, ...], str]:
    if options.study is None:
        if not 1 <= options.sequences <= _MOST_SEQUENCES:
            raise UsageError(f"--sequences: 1 to {_MOST_SEQUENCES} can be simulated")
        effect = effect_named(options.effect)
        if options.feedback:
            feedbacks = [chosen_text(text) for text in options.feedback]
            like = _rated_like(feedbacks, options.like)
            effect = for_feedbacks(effect, like)
            _say_assumed(like)
        else:
            refuse_idle(options, "without --feedback", "--like")
        draw = draw_effect(effect, options.measure, options.sequences)
        return draw, effect.feedbacks, f"effect {effect.name}"
    for_a_plan = ("--sequences", "--effect", "--feedback", "--like")
    refuse_idle(options, f"with the answers of {options.study.name}", *for_a_plan)
    scores = scores_of(read_answers(options.study))
    if options.measure not in scores.measures:
        known = ", ".join(scores.measures)
        raise UsageError(
            "there is no measure {measure!r}; choose one of {known}",
            measure=options.measure,
            known=known,
        )
    pilot = sample_of(scores, options.measure)
    source = f"{len(pilot.values)} participants of {options.study.name}"
    return draw_pilot(pilot), pilot.feedbacks, source


def _json(report: dict[str, Any]) -> str:
    return json.dumps(report, ensure_ascii=False, allow_nan=False)


def _analysis_text(found: ReportParts) -> str:
    numbers = found.numbers
    people = f"{numbers['missing']['participants']} participants"
    lines = (line.replace("\n", "\n  ") for line in found.lines)
    notes = (f"note: {one}" for one in numbers["warnings"])
    return "\n".join([people, *(f"  {line}" for line in lines), *notes])


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
        text = f"{needed}" if needed is not None else f"more than {goal.largest}"
        lines.append(f"  {name:<20}{text}")
    return "\n".join([*lines, f"tests: {TESTS}"])


@contextlib.contextmanager
def _to_be_filled(folder: Path) -> Iterator[Study]:
    """A study; one that is missing, or an empty folder, becomes one when it is filled."""
    is_empty = folder.is_dir() and not any(folder.iterdir())
    if folder.exists() and not is_empty:
        try:
            yield open_study(folder)
        except OSError as problem:
            raise StorageError.of(problem, folder) from problem
        return
    if is_empty:
        folder.rmdir()
    try:
        with folder_written_aside(folder, PRIVATE_FOLDER) as aside:
            write_private(aside / DEFINITION, new_definition())
            yield open_study(aside)
    except BaseException:
        if is_empty:
            folder.mkdir(exist_ok=True)
        raise
