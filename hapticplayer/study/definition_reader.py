"""Reads and checks `study.json`."""

from collections.abc import Iterable, Iterator
from typing import Any

from msgspec import Struct

from hapticplayer.errors import Message, StudyError, UsageError, message_of
from hapticplayer.rendering import (
    FEEDBACKS,
    Parameter,
    ParameterKind,
    condition_named,
)
from hapticplayer.structures import check_schema, convert, decode, missing, unknown
from hapticplayer.study.definition import (
    GIVE_STUDY,
    MAX_CONDITIONS,
    SCHEMA,
    VERSION,
    Definition,
    OrderMethod,
    Question,
    QuestionKind,
    StudyFeedback,
    Text,
    TrialKind,
    refuse,
)

DEFINITION = "study.json"


def parse_definition(content: bytes, path: str) -> Definition:
    """Return the definition in a JSON text; `path` is for messages."""
    value = decode(content, dict[str, Any], path, StudyError)
    other = Message("is not the definition of a study"), GIVE_STUDY
    check_schema(value, (SCHEMA, VERSION), path, other, StudyError)
    made = convert(value, Definition, path, StudyError)
    _check_texts(made, path)
    _check_keys(made, path)
    _check_feedbacks(made, path)
    _check_questions(made, path)
    _check_used(made, path)
    if made.order.no_sequence_twice_in_a_row:
        _check_constraint(made, path)
    return made


def _check_texts(made: Definition, path: str) -> None:
    """Refuse texts that lack a language of the study."""
    known = set(made.languages)
    for field, text in _texts(made):
        if not field.endswith("published") and (lacking := known - text.keys()):
            refuse(path, field, *missing(min(lacking)))
        if foreign := text.keys() - known:
            refuse(path, field, *unknown(min(foreign), made.languages))


def _texts(part: Any, field: str = "") -> Iterator[tuple[str, Text]]:
    """Yield the field and value of every text."""
    if isinstance(part, dict):
        yield field, part
    elif isinstance(part, tuple):
        for number, one in enumerate(part):
            yield from _texts(one, f"{field}[{number}]")
    elif isinstance(part, Struct) and not isinstance(part, StudyFeedback):
        for name in part.__struct_fields__:
            place = f"{field}.{name}" if field else name
            yield from _texts(getattr(part, name), place)


def _check_keys(made: Definition, path: str) -> None:
    _differ(path, "languages", made.languages)
    _differ(path, "feedbacks", made.feedback_keys)
    for field in ("sequences", "factors", "sheet", "post_test"):
        _differ(path, field, (one.key for one in getattr(made, field)))


def _differ(path: str, field: str, keys: Iterable[str]) -> None:
    seen: set[str] = set()
    for key in keys:
        if key in seen:
            what = Message("duplicate key {key!r}", key=key)
            refuse(path, field, what, Message("rename one of them"))
        seen.add(key)


def _check_feedbacks(made: Definition, path: str) -> None:
    """Refuse parameters that a condition does not have, or values out of range."""
    for number, one in enumerate(made.chosen_feedbacks):
        field, found = f"feedbacks[{number}]", condition_named(one.condition)
        if one.key not in (None, one.condition) and condition_named(str(one.key)):
            what = Message("{key!r} is the name of another condition", key=str(one.key))
            refuse(path, f"{field}.key", what, Message("choose another key"))
        if found is None:  # a track of each sequence, which is looked for there
            if one.parameters:
                what = Message("{name!r} has no parameters", name=one.condition)
                known = ", ".join(c.name for c in FEEDBACKS if c.parameters)
                remedy = Message("choose one of {known}", known=known)
                refuse(path, f"{field}.condition", what, remedy)
            continue
        known_names = [parameter.name for parameter in found.parameters]
        for name, value in one.parameters.items():
            if name not in known_names:
                refuse(path, f"{field}.parameters", *unknown(name, known_names))
            _check_parameter(
                made, path, f"{field}.parameters.{name}", found.parameter(name), value
            )
        needs_other = any(p.kind is ParameterKind.CLIP for p in found.parameters)
        if needs_other and len(made.sequences) < 2:
            what = Message("needs a second sequence, whose force is felt")
            refuse(path, field, what, Message("add a sequence"))


def _check_parameter(
    made: Definition, path: str, field: str, parameter: Parameter, value: object
) -> None:
    try:
        parameter.check(value)
    except UsageError as problem:
        refuse(path, field, message_of(problem))
    keys = [sequence.key for sequence in made.sequences]
    if parameter.kind is ParameterKind.CLIP and value and value not in keys:
        what = Message("{value!r} is not a sequence of this study", value=str(value))
        refuse(
            path, field, what, Message("choose one of {known}", known=", ".join(keys))
        )


def _check_questions(made: Definition, path: str) -> None:
    """Refuse combinations of entries that do not make a study."""
    count = len(made.conditions)
    if not 2 <= count <= MAX_CONDITIONS:
        what = Message(
            "must have 2 to {most} conditions, has {count}",
            count=count,
            most=MAX_CONDITIONS,
        )
        refuse(path, "", what)
    if not made.trial_questions:
        page = "factors" if made.trial is TrialKind.RATING else "consistency"
        what = Message("has no question after a clip")
        refuse(path, "", what, Message("add a question to {page!r}", page=page))
    for number, question in enumerate(made.factors):
        if question.kind is not QuestionKind.LIKERT:
            what = Message("{value!r} is not allowed", value=question.kind.value)
            known = Message("choose one of {known}", known=QuestionKind.LIKERT.value)
            refuse(path, f"factors[{number}].kind", what, known)
    asked = made.consistency
    if asked is not None and asked.kind is not QuestionKind.YES_NO:
        refuse(path, "consistency", Message("must be a yes-no question"))


_REMOVE = Message("remove it")
_OF_OTHER_TRIALS: dict[TrialKind, dict[str, Any]] = {
    TrialKind.RATING: {"levels": (), "repeats": 1, "consistency": None},
    TrialKind.CONSISTENCY: {"factors": ()},
}
_USED = {
    QuestionKind.NUMBER: ("least", "most"),
    QuestionKind.TEXT: ("most",),
    QuestionKind.CHOICE: ("choices",),
}
"""Which of these a kind of question uses."""


def _check_used(made: Definition, path: str) -> None:
    """Refuse entries that would change nothing: their author expects them to."""
    for name, unused in _OF_OTHER_TRIALS[made.trial].items():
        if getattr(made, name) != unused:
            what = Message("is not used in {kind} trials", kind=made.trial.value)
            refuse(path, name, what, _REMOVE)
    if len(set(made.levels)) < len(made.levels):
        what = Message("holds a level twice")
        refuse(path, "levels", what, Message("use 'repeats'"))
    for field, question in _questions(made):
        for name in ("least", "most", "choices"):
            if getattr(question, name) and name not in _USED.get(question.kind, ()):
                kind = question.kind.value
                what = Message("is not used in {kind} questions", kind=kind)
                refuse(path, f"{field}.{name}", what, _REMOVE)
    for field, question in _questions(made):
        if question.for_each_feedback and not field.startswith("post_test"):
            what = Message("is only used after the last trial")
            refuse(path, f"{field}.for_each_feedback", what, _REMOVE)
    if made.use_published and not any(one.published for _, one in _questions(made)):
        what = Message("no question has a published wording")
        refuse(path, "use_published", what, Message("enter one, or set it to false"))


def _questions(made: Definition) -> Iterator[tuple[str, Question]]:
    """Yield each question with its place."""
    for name in ("sheet", "factors", "post_test"):
        for number, one in enumerate(getattr(made, name)):
            yield f"{name}[{number}]", one
    if made.consistency is not None:
        yield "consistency", made.consistency


def _check_constraint(made: Definition, path: str) -> None:
    if made.order.method is OrderMethod.WILLIAMS:
        refuse(
            path,
            "order",
            Message(
                "a Williams design contains every pair of neighbours, also of one sequence"
            ),
            Message("remove the constraint or choose random or latin-square"),
        )
    if len(made.sequences) < 2:
        what = Message("a single sequence always follows itself")
        refuse(path, "order", what, Message("remove the constraint"))
