"""A definition that is being edited: all that is wrong with it, and where it is kept."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple, get_args, get_origin, get_type_hints

from msgspec import Struct

from hapticplayer import storage
from hapticplayer.errors import InputError, Message, StudyError
from hapticplayer.sequence.library import read_entry
from hapticplayer.structures import convert, decode, meant
from hapticplayer.study.creation import change_definition, definition_text
from hapticplayer.study.definition import (
    CORRECT,
    Definition,
    OrderMethod,
    read_file,
    refuse,
)
from hapticplayer.study.definition_reader import faults_of, to_be_worded
from hapticplayer.study.order_list import read_orders
from hapticplayer.study.orders import ORDERS, rows_of
from hapticplayer.study.sequence_folders import refuse_estimates
from hapticplayer.study.study_folder import open_study

DRAFT = "study-draft.json"
USUAL_CLIP_S = 60.0
"""Of a sequence that has no recording yet."""


class DefinitionProblem(NamedTuple):
    """Something that is wrong or missing.

    Attributes:
        field: such as `sequences[2].folder`, "" for the whole.
        what: is wrong.
        remedy: what to do.
        is_fatal: whether the definition cannot be kept like this; else no participant
            can be run yet.
    """

    field: str
    what: Message
    remedy: Message
    is_fatal: bool = True


def problems_of(content: dict[str, Any], folder: Path) -> list[DefinitionProblem]:
    """All that is wrong with a definition, by its fields.

    Args:
        content: of `study.json`.
        folder: of the study, which those of its sequences are relative to.
    """
    if found := list(_structural(content, Definition, "")):
        return found
    made = convert(content, Definition, "", StudyError)
    if found := [DefinitionProblem(*fault) for fault in faults_of(made)]:
        return found
    try:
        refuse_estimates(made, "", folder)
    except StudyError as problem:
        return [_problem(problem)]
    return [*_missing(made, folder), *_order_problems(made, folder)]


def _structural(value: Any, kind: Any, field: str) -> Iterator[DefinitionProblem]:
    """Yield the fields that do not have their type, each as far inside as it can be."""
    try:
        convert(value, kind, "", StudyError)
    except StudyError as problem:
        parts = list(_parts(value, meant(kind, value), field))
        inner = [found for part in parts for found in _structural(*part)]
        place = problem.where.removeprefix(", ")
        between = "." if field and place and not place.startswith("[") else ""
        yield from inner or [_problem(problem, f"{field}{between}{place}")]


def _parts(value: Any, kind: Any, field: str) -> Iterator[tuple[Any, Any, str]]:
    """Yield value, type and field of what a value is made of."""
    of = get_args(kind)
    if isinstance(value, dict) and isinstance(kind, type) and issubclass(kind, Struct):
        hints = get_type_hints(kind, include_extras=True)
        named = [(name, hints[name]) for name in value if name in hints]
    elif isinstance(value, dict) and get_origin(kind) is dict:
        named = [(name, of[1]) for name in value]
    elif isinstance(value, list) and get_origin(kind) is tuple:
        for number, one in enumerate(value):
            yield one, of[0], f"{field}[{number}]"
        return
    else:
        return
    for name, hint in named:
        yield value[name], hint, f"{field}.{name}" if field else name


def _problem(problem: InputError, field: str | None = None) -> DefinitionProblem:
    where = problem.where.removeprefix(", ") if field is None else field
    return DefinitionProblem(where, Message(problem.what), Message(problem.remedy))


def _missing(made: Definition, folder: Path) -> Iterator[DefinitionProblem]:
    """Yield texts to be worded, and sequences without a recording that can be played."""
    for field in to_be_worded(made):
        what, remedy = Message("is to be worded"), Message("enter the wording")
        yield DefinitionProblem(field, what, remedy, is_fatal=False)
    for number, one in enumerate(made.sequences):
        field = f"sequences[{number}].folder"
        if not one.folder:
            what, remedy = Message("there is none yet"), Message("choose one")
            yield DefinitionProblem(field, what, remedy, is_fatal=False)
        elif problem := read_entry(folder / one.folder).problem:
            yield DefinitionProblem(
                field, Message(problem), Message("choose another one"), False
            )


def _order_problems(made: Definition, folder: Path) -> Iterator[DefinitionProblem]:
    try:
        if made.order.method is OrderMethod.LIST:
            if not read_orders(folder / ORDERS, made):
                refuse(ORDERS, "", Message("holds no order"))
        elif made.order.method is not OrderMethod.RANDOM:
            rows_of(made)
    except StudyError as problem:
        where = problem.where.removeprefix(f"{folder}/")
        what = Message("{file}: {what}", file=where, what=problem.what)
        remedy = Message(problem.remedy or CORRECT)
        yield DefinitionProblem(
            "order.method", what if where else problem.what, remedy, is_fatal=False
        )


def clip_seconds(content: dict[str, Any], folder: Path) -> dict[str, float]:
    """The durations of the sequences, by key."""
    return {
        one["key"]: (one["folder"] and read_entry(folder / one["folder"]).duration_s)
        or USUAL_CLIP_S
        for one in content["sequences"]
    }


class Draft:
    """What a study is edited as.

    A definition without fatal problems is in `study.json`; another one lies in a draft
    beside it, until it has none.

    Attributes:
        study: as it is kept.
        content: of the definition, of the draft if there is one.
        is_restored: whether there was a draft.
    """

    def __init__(self, folder: Path) -> None:
        self.study = open_study(folder)
        self._path = self.study.folder / DRAFT
        self.is_restored = self._path.exists()
        content = read_file(self._path) if self.is_restored else self.study.content
        where = str(self._path)
        self.content = decode(content, dict[str, Any], where, StudyError, "remove it")

    def keep(self, content: dict[str, Any]) -> list[DefinitionProblem]:
        """Keep a definition, and return what is wrong with it."""
        self.content = content
        found = problems_of(content, self.study.folder)
        text = definition_text(content)
        if any(one.is_fatal for one in found):
            storage.replace_file(self._path, text, storage.PRIVATE_FILE)
            return found
        if text != self.study.content:
            self.study = change_definition(self.study, content)
        self._path.unlink(missing_ok=True)
        return found

    def complete(self) -> dict[str, Any]:
        """The content of `study.json`, without what only the draft has."""
        return decode(self.study.content, dict[str, Any], "", StudyError)
