"""What `hapticplayer study ACTION` does without a window."""

import argparse
import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from hapticplayer.clock import SystemClock
from hapticplayer.console.speech import complain, say, say_aside
from hapticplayer.errors import StudyError, UsageError
from hapticplayer.study.answers import collect_answers
from hapticplayer.study.creation import create_study, sequence_folder
from hapticplayer.study.merging import merge_sessions
from hapticplayer.study.reviews import keep_reviewed, text_digest
from hapticplayer.study.session_folder import State, StoredSession
from hapticplayer.study.steps import answered_trials
from hapticplayer.study.study_folder import (
    Study,
    delete_participant,
    drop,
    open_study,
)


def new(options: argparse.Namespace) -> int:
    """Make a study."""
    folders = {}
    for text in options.sequence:
        key, is_there, folder = text.partition("=")
        if not is_there or not folder:
            raise UsageError(f"--sequence {text!r} has to be KEY=FOLDER")
        folders[key] = Path(folder)
    study = create_study(options.study, options.template, folders)
    missing = _missing(study)
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
    return 0


def status(options: argparse.Namespace) -> int:
    """Say who took part, what is missing, and how balanced it is."""
    study = open_study(options.study)
    sessions, remarks = study.sessions()
    report = {
        "title": study.definition.title,
        "conditions": len(study.definition.conditions),
        "method": study.definition.order.method.value,
        "missing_sequences": _missing(study),
        "sessions": [_session(session) for session in sessions],
        "deleted": study.deleted_count(),
        "balance": _balance(study),
        "unreviewed_texts": len(_unreviewed(study)),
        "remarks": remarks,
    }
    say(json.dumps(report) if options.json else _status_text(report))
    for remark in remarks:
        say_aside(remark)
    return 0


def _session(session: StoredSession) -> dict[str, Any]:
    trials = list(answered_trials(session.records))
    last = {trial.position: trial for trial in trials}
    return {
        "code": session.code,
        "created_utc": session.plan.created_utc,
        "state": session.state.value,
        "answered": len(last),
        "planned": len(session.plan.assignment.conditions),
        "not_sound": sum(not trial.sound for trial in last.values()),
        "resumed": sum(r.kind == "resume" for r in session.records.intact),
        "damaged": len(session.records.damaged),
    }


def _balance(study: Study) -> dict[str, list[int]]:
    """Return the least and most often anything has been met."""
    balance = study.balance()
    return {
        "times_at_each_position": list(balance.times_at_each_position()),
        "times_after_each_other": list(balance.times_after_each_other()),
    }


def _status_text(report: dict[str, Any]) -> str:
    lines = [
        f"{report['title']}: {report['conditions']} conditions, {report['method']}"
    ]
    lines += [
        f"  {one['code']}  {one['state']:<11}{one['answered']}/{one['planned']}"
        f" answered, {one['not_sound']} not sound  {one['created_utc'][:16]}"
        for one in report["sessions"]
    ]
    lines.append(f"  {report['deleted']} deleted")
    place, pairs = report["balance"].values()
    lines.append(
        f"  balance    each condition {place[0]} to {place[1]} times at each position, "
        f"{pairs[0]} to {pairs[1]} times after each other"
    )
    if report["missing_sequences"]:
        lines.append(f"  missing    {', '.join(report['missing_sequences'])}")
    if report["unreviewed_texts"]:
        lines.append(
            f"  review     {report['unreviewed_texts']} answers in words to be read"
        )
    return "\n".join(lines)


def _missing(study: Study) -> list[str]:
    missing = []
    for sequence in study.definition.sequences:
        try:
            sequence_folder(study, sequence.key)
        except StudyError:
            missing.append(sequence.key)
    return missing


def review(options: argparse.Namespace) -> int:
    """Show the answers in words that nobody has read, or let some pass."""
    study = open_study(options.study)
    for text in options.passed:
        code, _, question = text.partition(":")
        _let_pass(study, code, question)
    left = _unreviewed(study)
    if options.json:
        say(json.dumps({"unreviewed": left}))
        return 0
    for one in left:
        say(f"{one['code']}:{one['question']}  {one['text']}")
    say_aside(f"{len(left)} answers in words have not been passed")
    return 0


def _unreviewed(study: Study) -> list[dict[str, str]]:
    return [
        {
            "code": answer.participant,
            "question": _name(answer.question, answer.feedback),
            "text": answer.text,
        }
        for answer in collect_answers(study).open_answers
        if not answer.reviewed
    ]


def _let_pass(study: Study, code: str, question: str) -> None:
    folder = study.session(code).folder
    digests = [
        text_digest(one["code"], one["question"], one["text"])
        for one in _unreviewed(study)
        if one["code"] == folder.name and question in ("", one["question"])
    ]
    if not digests:
        raise StudyError(f"{code}:{question} has no answer in words to pass")
    keep_reviewed(folder, digests)


def _name(question: str, feedback: str) -> str:
    return f"{question}@{feedback}" if feedback else question


def export(options: argparse.Namespace) -> int:
    """Write the data for other programs."""
    from hapticplayer.interchange.study_export import export_study

    report = export_study(open_study(options.study), options.output, options.format)
    say(
        json.dumps(report)
        if options.json
        else f"{options.output}: {report['participants']} participants, "
        f"{len(report['files'])} files"
    )
    for remark in report["remarks"]:
        say_aside(remark)
    return 0


def merge(options: argparse.Namespace) -> int:
    """Add the sessions of another machine; 1 where there were conflicts."""
    merged = merge_sessions(open_study(options.study), open_study(options.other))
    if options.json:
        say(json.dumps(asdict(merged)))
    else:
        say(f"{len(merged.added)} sessions added, {len(merged.same)} were here already")
    for remark in merged.remarks:
        say_aside(remark)
    for conflict in merged.conflicts:
        complain(conflict)
    return 1 if merged.conflicts else 0


def drop_session(options: argparse.Namespace) -> int:
    """End a session that will not go on."""
    study = open_study(options.study)
    if study.session(options.code).state is not State.UNFINISHED:
        raise StudyError(f"session {options.code.upper()} has ended already")
    drop(study, options.code, options.reason, SystemClock())
    say(f"{options.code.upper()} has ended; its place is free again")
    return 0


def delete(options: argparse.Namespace) -> int:
    """Remove every trace of a participant; 1 where reports still name the code."""
    study = open_study(options.study)
    left = delete_participant(study, options.code)
    say(f"one participant was deleted; {study.deleted_count()} in all")
    for name in left:
        complain(f"{name} still names the participant: make it anew or remove it")
    return 1 if left else 0


ACTIONS: dict[str, Callable[[argparse.Namespace], int]] = {
    "new": new,
    "status": status,
    "review": review,
    "export": export,
    "merge": merge,
    "drop": drop_session,
    "delete": delete,
}
