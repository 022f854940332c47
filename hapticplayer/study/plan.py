"""What is fixed before a participant sits down, written first and twice.

`session.json` holds it for people, the first record of the answers once more: either
of them may be damaged without harm.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message
from hapticplayer.study.codes import is_code
from hapticplayer.study.definition import Condition, OrderMethod
from hapticplayer.study.definition_reader import MAX_CONDITIONS, MAX_DELAY_S, MAX_GAIN
from hapticplayer.study.orders import Assignment
from hapticplayer.study.tree import Branch, parse

SCHEMA = "hapticplayer.session"
VERSION = 1


@dataclass(frozen=True, slots=True)
class Plan:
    """One participant's session as planned.

    Attributes:
        code: of the participant.
        study: id of the study.
        definition_sha256: of the definition, which lies beside the plan.
        program: name and version.
        created_utc: ISO 8601.
        language: of the pages.
        assignment: the order.
        clips: SHA-256 of each sequence's description, which holds those of its files.
    """

    code: str
    study: str
    definition_sha256: str
    program: str
    created_utc: str
    language: str
    assignment: Assignment
    clips: Mapping[str, str]


def describe_plan(plan: Plan) -> dict[str, Any]:
    """Return a plan as it is stored."""
    assignment = plan.assignment
    return {
        "schema": SCHEMA,
        "version": VERSION,
        "code": plan.code,
        "study": plan.study,
        "definition_sha256": plan.definition_sha256,
        "program": plan.program,
        "created_utc": plan.created_utc,
        "language": plan.language,
        "method": assignment.method.value,
        "seed": assignment.seed,
        "row": assignment.row,
        "order": [describe_condition(c) for c in assignment.conditions],
        "labels": list(assignment.labels),
        "clips": dict(plan.clips),
    }


def describe_condition(condition: Condition) -> dict[str, Any]:
    """Return a condition as it is stored."""
    return {
        "sequence": condition.sequence,
        "feedback": condition.feedback,
        "delay_s": condition.delay_s,
        "gain": condition.gain,
        "repeat": condition.repeat,
    }


def plan_file(plan: Plan) -> bytes:
    """Return the content of `session.json`."""
    described = describe_plan(plan)
    whole = {**described, "sha256": _digest(described)}
    return (json.dumps(whole, indent=2, ensure_ascii=False) + "\n").encode()


def parse_plan_file(content: bytes, where: str) -> Plan:
    """Return the plan in a `session.json`.

    Raises:
        StudyError: when it is damaged.
    """

    def read(root: Branch) -> Plan:
        described = dict(root.mapping())
        if described.pop("sha256", None) != _digest(described):
            root.refuse(
                Message("is damaged (its checksum differs)"),
                Message("copy the session again"),
            )
        return _plan(Branch(described, where))

    return parse(content, where, read)


def plan_of_record(content: Mapping[str, Any], where: str) -> Plan:
    """Return the plan in a record.

    Raises:
        StudyError: when it is none.
    """
    return _plan(Branch(dict(content), where))


def _digest(described: Mapping[str, Any]) -> str:
    text = json.dumps(described, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _plan(root: Branch) -> Plan:
    if root.get("schema").value != SCHEMA:
        root.refuse(Message("is no session"))
    if root.get("version").value != VERSION:
        root.refuse(
            Message("is of another version of the program"),
            Message("update hapticplayer"),
        )
    code = root.get("code").text()
    if not is_code(code):
        root.get("code").refuse(Message("is no participant's code"))
    return Plan(
        code=code,
        study=root.get("study").key(),
        definition_sha256=root.get("definition_sha256").text(),
        program=root.get("program").text(),
        created_utc=root.get("created_utc").text(),
        language=root.get("language").key(),
        assignment=_assignment(root),
        clips={name: entry.text() for name, entry in root.members("clips")},
    )


def _assignment(root: Branch) -> Assignment:
    return Assignment(
        conditions=tuple(read_condition(entry) for entry in root.each("order")),
        labels=tuple(entry.key() for entry in root.each("labels")),
        method=OrderMethod(root.get("method").one_of(OrderMethod)),
        row=root.get("row").whole(0, 10**6) if root.has("row") else None,
        seed=root.get("seed").whole(0, 2**53),
    )


def read_condition(entry: Branch) -> Condition:
    """Return a condition as it was stored.

    Raises:
        StudyError: which entry is wrong.
    """
    return Condition(
        entry.get("sequence").key(),
        entry.get("feedback").key(),
        entry.get("delay_s").number(-MAX_DELAY_S, MAX_DELAY_S),
        entry.get("gain").number(0.0, MAX_GAIN),
        entry.get("repeat").whole(1, MAX_CONDITIONS),
    )
