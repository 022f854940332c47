"""The command `study`: make one, run participants, keep and hand on its data."""

import argparse
import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from hapticplayer.cli import (
    OpenWindow,
    study_analysis,
    study_power,
    study_preregister,
    study_scales,
)
from hapticplayer.cli.common import (
    add_outputs,
    complain,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import StudyError, UsageError, counted
from hapticplayer.storage import FOLDER, refuse_existing
from hapticplayer.study.creation import create_study, template_names
from hapticplayer.study.definition_reader import to_be_worded
from hapticplayer.study.merging import account_of, copies_in, merge_copies
from hapticplayer.study.overview import (
    approve_texts,
    missing_sequences,
    study_overview,
    unreviewed_texts,
)
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.sites import pack_study, signature_of
from hapticplayer.study.study_export import export_study, study_exporters
from hapticplayer.study.study_folder import (
    delete_participant,
    drop_session,
    open_study,
)

Run = Callable[[argparse.Namespace], int]


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the actions of the command and their options."""
    command.set_defaults(run=lambda *_: command.error("an action is needed"))
    actions = command.add_subparsers(title="actions", metavar="ACTION")
    _add_new(actions)
    _add_run(actions)
    _add_status(actions)
    _add_review(actions)
    _add_export(actions)
    _add_pack(actions)
    _add_merge(actions)
    _add_drop(actions)
    _add_delete(actions)
    study_scales.add_actions(actions)
    study_analysis.add_actions(actions)
    study_power.add_actions(actions)
    study_preregister.add_actions(actions)


def add_action(actions: Any, name: str, summary: str, run: Run | None = None) -> Any:
    """Add an action whose first argument is the study's folder, and return it."""
    action = actions.add_parser(name, help=summary, description=summary)
    action.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    if run is not None:
        action.set_defaults(run=lambda chosen, _open_window: run(chosen))
    return action


def _add_new(actions: Any) -> None:
    action = add_action(actions, "new", "make a study of a template", new)
    action.add_argument(
        "--template",
        default="qoe2012",
        metavar="T",
        help=f"{', '.join(template_names())} (default: qoe2012)",
    )
    action.add_argument(
        "--sequence",
        action="append",
        default=[],
        metavar="KEY=FOLDER",
        help="folder of a sequence of the study; may be repeated",
    )
    study_analysis.add_feedback(action, "in place of the template's")
    _add_json(action)


def _add_run(actions: Any) -> None:
    action = add_action(actions, "run", "run a participant in the window")
    action.set_defaults(run=_run)
    action.add_argument(
        "--language", metavar="L", help="language of the participant's pages"
    )
    action.add_argument("--resume", metavar="CODE", help="resume a session")
    add_outputs(action)
    action.add_argument(
        "--windowed",
        action="store_true",
        help="participant's pages in a window, for trying a study out",
    )
    action.add_argument(
        "--lsl",
        action="store_true",
        help="offer markers and force as LSL streams to programs on this machine",
    )


def _add_status(actions: Any) -> None:
    _add_json(
        add_action(
            actions,
            "status",
            "who took part, what is missing, how balanced it is",
            status,
        )
    )


def _add_review(actions: Any) -> None:
    action = add_action(
        actions,
        "review",
        "read answers in words before they are exported",
        review,
    )
    action.add_argument(
        "--pass",
        dest="passed",
        action="append",
        default=[],
        metavar="CODE[:QUESTION]",
        help="allow these to be exported: they identify no one",
    )
    _add_json(action)


def _add_export(actions: Any) -> None:
    action = add_action(actions, "export", "write the data for other programs", export)
    action.add_argument("-o", "--output", required=True, metavar="DIR", type=Path)
    action.add_argument(
        "--format",
        default="csv",
        choices=list(study_exporters()),
        help="; ".join(f"{name}: {one.text}" for name, one in study_exporters().items())
        + " (default: csv)",
    )
    _add_json(action)


def _add_merge(actions: Any) -> None:
    action = add_action(actions, "merge", "add the sessions of other machines", merge)
    action.add_argument(
        "others",
        metavar="[SITE=]FOLDER",
        nargs="+",
        help="copies of the study, or a folder of copies (the names of its folders are "
        "those of the sites), with the name of the site where each was run",
    )
    _add_json(action)


def _add_pack(actions: Any) -> None:
    summary = "a signed copy with all sequences, for other sites to run"
    action = add_action(actions, "pack", summary, pack)
    action.add_argument("-o", "--output", required=True, metavar="DIR", type=Path)
    _add_json(action)


def _add_drop(actions: Any) -> None:
    action = add_action(
        actions, "drop", "close a session that will not be resumed", close_session
    )
    action.add_argument("code", metavar="CODE")
    action.add_argument("--reason", required=True)


def _add_delete(actions: Any) -> None:
    action = add_action(
        actions,
        "delete-participant",
        "remove every trace of a participant; a count stays",
        delete,
    )
    action.add_argument("code", metavar="CODE")


def _add_json(action: Any) -> None:
    action.add_argument("--json", action="store_true", help="print a report as JSON")


def _run(chosen: argparse.Namespace, open_window: OpenWindow | None) -> int:
    if open_window is None:
        raise UsageError("a study is run in a window, and there is no display")
    return open_window(chosen)


def new(options: argparse.Namespace) -> int:
    """Make a study."""
    folders = {}
    for text in options.sequence:
        key, is_there, folder = text.partition("=")
        if not is_there or not folder or key in folders:
            raise UsageError(f"--sequence {text!r} has to be KEY=FOLDER, each key once")
        folders[key] = Path(folder)
    study = create_study(options.study, options.template, folders, options.feedback)
    missing = missing_sequences(study)
    report = {
        "study": str(options.study),
        "id": study.definition.id,
        "conditions": len(study.definition.conditions),
        "missing": missing,
    }
    if options.json:
        say(json.dumps(report))
    else:
        say(f"{options.study}: {report['conditions']} conditions; edit study.json")
    if missing:
        say_aside(f"no folder is known yet of the sequences {', '.join(missing)}")
    if texts := list(to_be_worded(study.definition)):
        say_aside(
            f"{len(texts)} texts are to be written in study.json, the first is {texts[0]}"
        )
    return 0


def status(options: argparse.Namespace) -> int:
    """Say who took part, what is missing, and how balanced it is."""
    study, found = open_study(options.study), study_overview(options.study)
    report = {
        "title": study.definition.title,
        "conditions": len(study.definition.conditions),
        "method": study.definition.order.method.value,
        "missing_sequences": list(found.missing),
        "to_be_worded": list(to_be_worded(study.definition)),
        "sessions": [
            {**asdict(one), "state": one.state.value, "invalid": len(one.invalid)}
            for one in found.sessions
        ],
        "deleted": found.deleted,
        "balance": {
            "times_at_each_position": list(found.balance.times_at_each_position()),
            "times_after_each_other": list(found.balance.times_after_each_other()),
        },
        "unreviewed_texts": len(found.unreviewed),
        "remarks": list(found.notices),
    }
    say(json.dumps(report) if options.json else _status_text(report))
    for notice in found.notices:
        say_aside(notice)
    return 0


def _status_text(report: dict[str, Any]) -> str:
    lines = [
        f"{report['title']}: {report['conditions']} conditions, {report['method']}"
    ]
    lines += [
        f"  {one['code']}  {one['state']:<11}{one['answered']}/{one['planned']}"
        f" answered, {one['invalid']} not valid  {one['created_utc'][:16]}"
        + "  simulated"
        * one["simulated"]
        for one in report["sessions"]
    ]
    if simulated := sum(one["simulated"] for one in report["sessions"]):
        count = len(report["sessions"])
        lines.append(f"  {simulated} of {count} sessions are simulated")
    lines.append(f"  {report['deleted']} deleted")
    place, pairs = report["balance"].values()
    lines.append(
        f"  balance    each condition {place[0]} to {place[1]} times at each position, "
        f"{pairs[0]} to {pairs[1]} times after each other"
    )
    if report["missing_sequences"]:
        lines.append(f"  missing    {', '.join(report['missing_sequences'])}")
    if texts := report["to_be_worded"]:
        lines.append(
            f"  wording    {len(texts)} texts are to be written: {texts[0]} ..."
        )
    if report["unreviewed_texts"]:
        lines.append(
            f"  review     {report['unreviewed_texts']} answers in words to be read"
        )
    return "\n".join(lines)


def review(options: argparse.Namespace) -> int:
    """Show the unreviewed free-text answers, or pass some."""
    study = open_study(options.study)
    for text in options.passed:
        code, _, question = text.partition(":")
        approve_texts(study, code, question)
    left = unreviewed_texts(study)
    if options.json:
        say(json.dumps({"unreviewed": [one._asdict() for one in left]}))
        return 0
    for one in left:
        say(f"{one.code}:{one.question}  {one.text}")
    say_aside(f"{len(left)} answers in words have not been passed")
    return 0


def export(options: argparse.Namespace) -> int:
    """Write the data for other programs."""
    report = export_study(open_study(options.study), options.output, options.format)
    say(
        json.dumps(report)
        if options.json
        else f"{options.output}: {counted(report['participants'], 'participant')}, "
        f"{counted(len(report['files']), 'file')}"
        + (f"; {report['left_out']}" if report["left_out"] else "")
    )
    for notice in report["remarks"]:
        say_aside(notice)
    return 0


def pack(options: argparse.Namespace) -> int:
    """Write a signed copy of a study for other sites."""
    refuse_existing(options.output, FOLDER)
    with shown_progress() as progress:
        made = pack_study(open_study(options.study), options.output, progress)
    report = {"files": len(made.files), "manifest_sha256": signature_of(made)}
    said = f"{options.output}: {len(made.files)} files, {report['manifest_sha256']}"
    say(json.dumps(report) if options.json else said)
    return 0


def merge(options: argparse.Namespace) -> int:
    """Add the sessions of other machines; 1 where there were conflicts."""
    copies: list[tuple[str, Path]] = []
    for text in options.others:
        site, mark, folder = text.partition("=")
        is_site = bool(mark) and not Path(text).exists()
        found_there = copies_in(Path(folder if is_site else text))
        copies += [(site if is_site else name, one) for name, one in found_there]
    others = [(site, open_study(folder)) for site, folder in copies]
    with shown_progress() as progress:
        found = merge_copies(open_study(options.study), others, progress)
    if options.json:
        say(json.dumps([{**asdict(one), "site": one.site._asdict()} for one in found]))
    for one in found:
        if not options.json:
            lead = f"{one.site.site}: " if one.site.site else ""
            say(lead + "\n  ".join(account_of(one)))
        for notice in one.notices:
            say_aside(notice)
        for conflict in one.conflicts:
            complain(conflict)
    return 1 if any(one.conflicts for one in found) else 0


def close_session(options: argparse.Namespace) -> int:
    """Close a session that will not be resumed."""
    study = open_study(options.study)
    if study.session(options.code).state is not SessionState.UNFINISHED:
        raise StudyError(f"session {options.code.upper()} has ended already")
    drop_session(study, options.code, options.reason, SystemClock())
    say(f"{options.code.upper()} has ended; its place is free again")
    return 0


def delete(options: argparse.Namespace) -> int:
    """Remove every trace of a participant; 1 where reports still name the code."""
    study = open_study(options.study)
    left = delete_participant(study, options.code)
    say(f"one participant was deleted; {study.deleted_count()} in all")
    for name in left:
        complain(f"{name} still names the participant: write it again or remove it")
    return 1 if left else 0
