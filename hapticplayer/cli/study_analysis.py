"""The actions `study analyse` and `simulate`, and options that plans have, too."""

import argparse
import contextlib
import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.cli.common import (
    add_number,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import Message, UsageError, counted
from hapticplayer.installation import require
from hapticplayer.model import Feedback, ranges
from hapticplayer.rendering import condition_named
from hapticplayer.simulation.participants import (
    effect_named,
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
from hapticplayer.study.analysis.report import (
    analyse_study,
    write_report,
)
from hapticplayer.study.answers import collect_answers, read_answers
from hapticplayer.study.creation import new_definition
from hapticplayer.study.definition import Definition, StudyFeedback, TrialKind
from hapticplayer.study.definition_reader import DEFINITION
from hapticplayer.study.study_folder import Study, open_study

_SEED = 2012


def add_actions(actions: Any) -> None:
    """Add the actions to the sub-parsers of `study`."""
    _add_analyse(actions)
    _add_simulate(actions)


def _add_analyse(actions: Any) -> None:
    action = new_action(
        actions, "analyse", "statistics and figures of a study", analyse
    )
    action.formatter_class = argparse.RawDescriptionHelpFormatter
    action.epilog = "statistics of ratings:\n" + "\n".join(
        f"  {name:<20}  {one.title}" for name, one in STATISTICS.items()
    )
    action.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    action.add_argument(
        "-o",
        "--output",
        metavar="DIR",
        type=Path,
        help="write the report (HTML, PDF), figures and numbers into a new folder",
    )
    add_options_of_analysis(action)


def add_options_of_analysis(action: argparse.ArgumentParser) -> None:
    """Add the options that change the numbers, beside the seed."""
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


def options_of_analysis(options: argparse.Namespace) -> AnalysisOptions:
    return AnalysisOptions(
        MissingPolicy(options.missing),
        options.include_invalid,
        Resampling(options.seed),
    )


def _add_simulate(actions: Any) -> None:
    action = new_action(
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
    add_effect(action)
    add_like(action)
    add_level(action)


def add_effect(action: argparse.ArgumentParser) -> None:
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


def add_like(action: argparse.ArgumentParser) -> None:
    action.add_argument(
        "--like",
        action="append",
        default=[],
        metavar="KEY=F",
        help="the paper's condition (none, random, realistic) that a feedback is rated "
        "like; an assumption",
    )


def add_level(action: argparse.ArgumentParser) -> None:
    action.add_argument(
        "--level",
        action="append",
        default=[],
        metavar="LEVEL=SHARE",
        help="share of the effect at a level of a factor of the sequences, such as third=0.5; "
        "an assumption; may be repeated",
    )


def shares_of(given: Iterable[str]) -> dict[str, float]:
    """The shares of the effect, by level."""
    found = {}
    for text in given:
        level, _, share = text.partition("=")
        try:
            value = float(share)
        except ValueError:
            value = math.nan
        if level in found or not 0.0 <= value < math.inf:
            raise UsageError(
                "--level {text!r} has to be LEVEL=SHARE, such as third=0.5, each level once",
                text=text,
            )
        found[level] = value
    return found


def levels_with(
    definition: Definition, shares: Mapping[str, float]
) -> tuple[tuple[str, float], ...]:
    """Level and share of each sequence, of the factor that has those with a share."""
    if not shares:
        return ()
    factors = definition.sequence_factors.values()
    for levels in factors:
        if shares.keys() <= set(levels):
            return tuple((level, shares.get(level, 1.0)) for level in levels)
    known = ", ".join(sorted({level for levels in factors for level in levels}))
    raise UsageError(
        "--level: the levels of one factor of the sequences are needed; there is {known}",
        known=known or "none",
    )


def new_action(
    actions: Any, name: str, summary: str, run: Callable[[argparse.Namespace], int]
) -> argparse.ArgumentParser:
    action: argparse.ArgumentParser = actions.add_parser(
        name, help=summary, description=summary
    )
    add_number(action, "--seed", ranges.SEED, default=_SEED)
    action.add_argument("--json", action="store_true", help="print the result as JSON")
    action.set_defaults(run=lambda chosen, _open_window: run(chosen))
    return action


def analyse(options: argparse.Namespace) -> int:
    """Print the statistics of a study, and write its report where that is wanted."""
    if options.output is not None:
        require("study", Message("writing a report"))
        refuse_existing(options.output, FOLDER)
    choices = options_of_analysis(options)
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
    say(as_json(found.numbers) if options.json else _analysis_text(found))
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
    say(as_json(report) if options.json else text)
    if not options.json:
        say_assumed(like)
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
    like = rated_like(study.definition.chosen_feedbacks, options.like)
    shares = shares_of(options.level)
    answers = simulated_answers(
        options.participants,
        options.effect,
        seed=options.seed,
        sequences=design.sequences,
        like=None if set(like) == set(paper.feedbacks) == set(like.values()) else like,
        shares=[share for _, share in levels_with(study.definition, shares)],
    )
    origin = {"simulated": True, "effect": options.effect, "seed": options.seed}
    origin |= {"shares": shares} if shares else {}
    drawn = random_questions(study.definition, paper.factors)
    origin |= {"rated_like": like, "at_random": drawn}
    notices: list[str] = []
    raters = None
    if study.definition.while_watching:
        from hapticplayer.simulation.ratings import Raters  # few studies have them

        raters = Raters(study, like, np.random.default_rng(options.seed), notices)
    made = write_answers(study, answers, SystemClock(), origin=origin, raters=raters)
    for notice in notices:
        say_aside(notice)
    return like, origin, made


def rated_like(
    feedbacks: Iterable[StudyFeedback], given: Iterable[str]
) -> dict[str, str]:
    """Return the paper's condition that each feedback is rated like, by key."""
    like = {}
    for one in feedbacks:
        found = condition_named(one.condition)
        # a track of which nothing is known is some force
        like[one.name] = str(found.simulated_as if found else Feedback.RANDOM)
    named: dict[str, str] = {}
    for text in given:
        key, mark, name = text.partition("=")
        if not mark or key not in like or key in named:
            raise UsageError(
                f"--like {text!r} has to be KEY=NAME, each key once; the keys are "
                f"{', '.join(like)}"
            )
        named[key] = name
    return like | named


def say_assumed(like: Mapping[str, str]) -> None:
    assumed = [f"{key} like {name}" for key, name in like.items() if key != name]
    if assumed:
        say_aside(f"assumed, not measured: {', '.join(assumed)} (--like changes it)")


def as_json(report: dict[str, Any]) -> str:
    return json.dumps(report, ensure_ascii=False, allow_nan=False)


def _analysis_text(found: ReportParts) -> str:
    numbers = found.numbers
    people = counted(numbers["missing"]["participants"], "participant")
    lines = (line.replace("\n", "\n  ") for line in found.lines)
    notes = (f"note: {one}" for one in numbers["warnings"])
    return "\n".join([people, *(f"  {line}" for line in lines), *notes])


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
