"""What is fixed before a participant sits down, written first and twice.

`session.json` holds it for people, the first record of the answers once more: either
of them may be damaged without harm.
"""

import hashlib
import json
import secrets
from collections.abc import Collection
from typing import Annotated, Any

import msgspec
from msgspec import Meta

from hapticplayer.errors import Message, StudyError
from hapticplayer.study import json_files
from hapticplayer.study.definition import Condition, JsonObject, Key, OrderMethod, Seed

SCHEMA = "hapticplayer.session"
VERSION = 1
# without vowels (no words) and without what looks alike
LETTERS = "CDFGHJKMNPQRTVWXY34679"
LENGTH = 6


class Plan(JsonObject, frozen=True, kw_only=True):
    """One participant's session as planned, as `session.json` holds it.

    Attributes:
        code: of the participant.
        study: id of the study.
        definition_sha256: of the definition, which lies beside the plan.
        program: name and version.
        created_utc: ISO 8601.
        language: of the pages.
        method, seed, row: how the order was made, see `orders.Assignment`.
        order: conditions as they are played.
        labels: feedbacks in the order in which they are called 1, 2, ...
        clips: SHA-256 of each sequence's description, which holds those of its files.
    """

    schema: str = SCHEMA
    version: int = VERSION
    code: str
    study: Key
    definition_sha256: str
    program: str
    created_utc: str
    language: Key
    method: OrderMethod
    seed: Seed
    row: Annotated[int, Meta(ge=0, le=10**6)] | None
    order: tuple[Condition, ...]
    labels: tuple[Key, ...]
    clips: dict[str, str]

    def __post_init__(self) -> None:
        """Refuse another code than the program makes."""
        if not is_code(self.code):
            raise ValueError("'code' is no participant's code")


def describe(value: Plan | Condition) -> dict[str, Any]:
    """Return a plan or a condition as it is stored."""
    described: dict[str, Any] = msgspec.to_builtins(value)
    return described


def plan_file(plan: Plan) -> bytes:
    """Return the content of `session.json`."""
    described = describe(plan)
    whole = {**described, "sha256": _digest(described)}
    return (json.dumps(whole, indent=2, ensure_ascii=False) + "\n").encode()


def parse_plan_file(content: bytes, path: str) -> Plan:
    """Return the plan in a `session.json`.

    Raises:
        StudyError: when it is damaged.
    """
    described = json_files.parse(content, path)
    if not isinstance(described, dict) or described.get("schema") != SCHEMA:
        json_files.refuse(path, "", Message("is no session"))
    if described.pop("sha256", None) != _digest(described):
        what = Message("is damaged (its checksum differs)")
        json_files.refuse(path, "", what, Message("copy the session again"))
    return plan_of_record(described, path)


def plan_of_record(content: Any, path: str) -> Plan:
    """Return the plan in a record.

    Raises:
        StudyError: when it is none.
    """
    if isinstance(content, dict) and content.get("version") != VERSION:
        what = Message("is of another version of the program")
        json_files.refuse(path, "", what, Message("update hapticplayer"))
    return json_files.convert(content, Plan, path)


def _digest(described: dict[str, Any]) -> str:
    text = json.dumps(described, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()


def new_code(taken: Collection[str]) -> str:
    """Return a code that nobody has."""
    while True:
        code = "".join(secrets.choice(LETTERS) for _ in range(LENGTH))
        if code not in taken:
            return code


def is_code(text: str) -> bool:
    """Whether a text could be a code."""
    return len(text) == LENGTH and all(letter in LETTERS for letter in text)


def checked_code(text: str) -> str:
    """Return a code as it is stored, however it was typed.

    Raises:
        StudyError: where it is none.
    """
    code = text.strip().upper()
    if not is_code(code):
        raise StudyError(
            "{text!r} is no participant's code",
            remedy="a code has {length} letters, as `study status` lists them",
            text=text,
            length=LENGTH,
        )
    return code


def number_of(code: str) -> int:
    """Return the code as a number, to seed what is random for this participant."""
    number = 0
    for letter in code:
        number = number * len(LETTERS) + LETTERS.index(letter)
    return number
