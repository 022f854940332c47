"""The plan of a session, which is fixed before it begins, and participants' codes.

The plan is stored twice, in `session.json` and in the first record of the journal, so
that one damaged copy does no harm.
"""

import hashlib
import json
import secrets
from collections import Counter
from collections.abc import Collection
from typing import Annotated, Any

import msgspec
from msgspec import Meta

from hapticplayer.clock import is_time
from hapticplayer.errors import Message, StudyError
from hapticplayer.storage import json_text
from hapticplayer.structures import convert, decode
from hapticplayer.study.definition import (
    Condition,
    Definition,
    JsonObject,
    Key,
    OrderMethod,
    Seed,
    refuse,
)
from hapticplayer.untrusted import ESCAPED

SCHEMA = "hapticplayer.session"
VERSION = 1
# without vowels (no words) and without letters that look alike
LETTERS = "CDFGHJKMNPQRTVWXY34679"
LENGTH = 6


class Plan(JsonObject, frozen=True, kw_only=True):
    """The plan of a session, with the entries of `session.json`.

    Attributes:
        code: of the participant.
        study: id of the study.
        definition_sha256: of the copy of the definition.
        program: name and version.
        created_utc: ISO 8601.
        language: of the pages.
        method, seed, row: of the order, see `orders.Assignment`.
        order: conditions in order of playback.
        labels: feedbacks in the order of their numbers.
        clips: SHA-256 of the description of each sequence, which holds those of files.
    """

    schema: str = SCHEMA
    version: int = VERSION
    code: str
    study: Key
    definition_sha256: str
    program: Annotated[str, Meta(max_length=200)]
    created_utc: str
    language: Key
    method: OrderMethod
    seed: Seed
    row: Annotated[int, Meta(ge=0, le=10**6)] | None
    order: tuple[Condition, ...]
    labels: tuple[Key, ...]
    clips: dict[str, str]

    def __post_init__(self) -> None:
        """Refuse an invalid code, and a time that reports could not show."""
        if not is_code(self.code):
            raise ValueError("'code' is not a participant's code")
        if not is_time(self.created_utc):
            raise ValueError("'created_utc' is not a time with its zone")


def describe(value: JsonObject) -> dict[str, Any]:
    described: dict[str, Any] = msgspec.to_builtins(value)
    return described


def plan_file(plan: Plan) -> bytes:
    """Return the content of `session.json`."""
    described = describe(plan)
    whole = {**described, "sha256": _digest(described)}
    return json_text(whole)


def parse_plan_file(content: bytes, path: str) -> Plan:
    """Return the plan in a `session.json`.

    Raises:
        StudyError: when it is damaged.
    """
    described = decode(content, dict[str, Any], path, StudyError)
    if described.get("schema") != SCHEMA:
        refuse(path, "", Message("is not a session"))
    if described.pop("sha256", None) != _digest(described):
        what = Message("is damaged (its checksum differs)")
        refuse(path, "", what, Message("copy the session again"))
    return plan_of_record(described, path)


def plan_of_record(content: Any, path: str) -> Plan:
    if isinstance(content, dict) and content.get("version") != VERSION:
        what = Message("was written by another version of the program")
        refuse(path, "", what, Message("update hapticplayer"))
    return convert(content, Plan, path, StudyError)


def check_plan(plan: Plan, definition: Definition, code: str, path: str) -> None:
    """Refuse a plan of another participant, or one that its definition does not allow."""
    if plan.code != code:
        what = Message("is the session of {code}", code=plan.code)
        refuse(path, "code", what, Message("copy the session again"))
    is_study = plan.study == definition.id
    is_order = Counter(plan.order) == Counter(definition.conditions)
    is_labelled = sorted(plan.labels) == sorted(definition.feedback_keys)
    is_asked = plan.language in definition.languages
    if not (is_study and is_order and is_labelled and is_asked):
        what = Message("does not fit the definition of its session")
        refuse(path, "", what, Message("copy the session again"))


def _digest(described: dict[str, Any]) -> str:
    text = json.dumps(described, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode(errors=ESCAPED)).hexdigest()


def new_code(taken: Collection[str]) -> str:
    while True:
        code = "".join(secrets.choice(LETTERS) for _ in range(LENGTH))
        if code not in taken:
            return code


def is_code(text: str) -> bool:
    return len(text) == LENGTH and all(letter in LETTERS for letter in text)


def checked_code(text: str) -> str:
    """Return a typed code in its stored form."""
    code = text.strip().upper()
    if not is_code(code):
        raise StudyError(
            "{text!r} is not a participant's code",
            remedy="a code has {length} letters, as `study status` lists them",
            text=text,
            length=LENGTH,
        )
    return code


def number_of(code: str) -> int:
    """Return a code as a number, as a seed for this participant."""
    number = 0
    for letter in code:
        number = number * len(LETTERS) + LETTERS.index(letter)
    return number
