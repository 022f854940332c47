"""Reads and checks `study.json`."""

from collections.abc import Iterator, Sequence
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
    CORRECT,
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
Fault = tuple[str, Message, Message]
"""The field, what is wrong there, and what to do."""


def parse_definition(content: bytes, path: str) -> Definition:
    """Return the definition in a JSON text; `path` is for messages."""
    value = decode(content, dict[str, Any], path, StudyError)
    other = Message("is not the definition of a study"), GIVE_STUDY
    check_schema(value, (SCHEMA, VERSION), path, other, StudyError)
    made = convert(value, Definition, path, StudyError)
    for field, what, remedy in faults_of(made):
        refuse(path, field, what, remedy)
    return made


def faults_of(made: Definition) -> Iterator[Fault]:
    """The contradictions in a definition."""
    yield from _text_faults(made)
    yield from _key_faults(made)
    yield from _feedback_faults(made)
    yield from _question_faults(made)
    yield from _unused(made)
    if made.order.no_sequence_twice_in_a_row:
        yield from _constraint_faults(made)


def _text_faults(made: Definition) -> Iterator[Fault]:
    """Texts that lack a language of the study, or have another one."""
    known = set(made.languages)
    for field, text in _texts(made):
        for lacking in () if field.endswith("published") else known - text.keys():
            yield field, *missing(lacking)
        for foreign in text.keys() - known:
            yield field, *unknown(foreign, made.languages)


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


def _key_faults(made: Definition) -> Iterator[Fault]:
    yield from _alike("languages", made.languages, "")
    yield from _alike("feedbacks", made.feedback_keys)
    for field in ("sequences", "factors", "sheet", "post_test"):
        yield from _alike(field, [one.key for one in getattr(made, field)])


def _alike(field: str, keys: Sequence[str], place: str = ".key") -> Iterator[Fault]:
    for number, key in enumerate(keys):
        if key in keys[:number]:
            what = Message("duplicate key {key!r}", key=key)
            remedy = Message("rename one of them")
            yield f"{field}[{number}]{place}", what, remedy


def _feedback_faults(made: Definition) -> Iterator[Fault]:
    """Parameters that a condition does not have, or values out of range."""
    for number, one in enumerate(made.chosen_feedbacks):
        field, found = f"feedbacks[{number}]", condition_named(one.condition)
        if one.key not in (None, one.condition) and condition_named(str(one.key)):
            what = Message("{key!r} is the name of another condition", key=str(one.key))
            yield f"{field}.key", what, Message("choose another key")
        if found is None:  # a track of each sequence, which is looked for there
            if one.parameters:
                what = Message("{name!r} has no parameters", name=one.condition)
                known = ", ".join(c.name for c in FEEDBACKS if c.parameters)
                remedy = Message("choose one of {known}", known=known)
                yield f"{field}.condition", what, remedy
            continue
        known_names = [parameter.name for parameter in found.parameters]
        for name, value in one.parameters.items():
            if name not in known_names:
                yield f"{field}.parameters", *unknown(name, known_names)
                continue
            place = f"{field}.parameters.{name}"
            yield from _parameter_faults(made, place, found.parameter(name), value)
        needs_other = any(p.kind is ParameterKind.CLIP for p in found.parameters)
        if needs_other and len(made.sequences) < 2:
            what = Message("needs a second sequence, whose force is felt")
            yield field, what, Message("add a sequence")


def _parameter_faults(
    made: Definition, field: str, parameter: Parameter, value: object
) -> Iterator[Fault]:
    try:
        parameter.check(value)
    except UsageError as problem:
        yield field, message_of(problem), CORRECT
        return
    keys = [sequence.key for sequence in made.sequences]
    if parameter.kind is ParameterKind.CLIP and value and value not in keys:
        what = Message("{value!r} is not a sequence of this study", value=str(value))
        yield field, what, Message("choose one of {known}", known=", ".join(keys))


def _question_faults(made: Definition) -> Iterator[Fault]:
    """Combinations of entries that do not make a study."""
    count = len(made.conditions)
    if not 2 <= count <= MAX_CONDITIONS:
        what = Message(
            "must have 2 to {most} conditions, has {count}",
            count=count,
            most=MAX_CONDITIONS,
        )
        yield "", what, CORRECT
    if not made.trial_questions:
        page = "factors" if made.trial is TrialKind.RATING else "consistency"
        what = Message("has no question after a clip")
        yield "", what, Message("add a question to {page!r}", page=page)
    for number, question in enumerate(made.factors):
        if question.kind is not QuestionKind.LIKERT:
            what = Message("{value!r} is not allowed", value=question.kind.value)
            known = Message("choose one of {known}", known=QuestionKind.LIKERT.value)
            yield f"factors[{number}].kind", what, known
    asked = made.consistency
    if asked is not None and asked.kind is not QuestionKind.YES_NO:
        yield "consistency", Message("must be a yes-no question"), CORRECT


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


def _unused(made: Definition) -> Iterator[Fault]:
    """Entries that would change nothing: their author expects them to."""
    for name, unused in _OF_OTHER_TRIALS[made.trial].items():
        if getattr(made, name) != unused:
            what = Message("is not used in {kind} trials", kind=made.trial.value)
            yield name, what, _REMOVE
    if len(set(made.levels)) < len(made.levels):
        yield "levels", Message("holds a level twice"), Message("use 'repeats'")
    for field, question in _questions(made):
        for name in ("least", "most", "choices"):
            if getattr(question, name) and name not in _USED.get(question.kind, ()):
                kind = question.kind.value
                what = Message("is not used in {kind} questions", kind=kind)
                yield f"{field}.{name}", what, _REMOVE
        if question.for_each_feedback and not field.startswith("post_test"):
            what = Message("is only used after the last trial")
            yield f"{field}.for_each_feedback", what, _REMOVE
    if made.use_published and not any(one.published for _, one in _questions(made)):
        what = Message("no question has a published wording")
        yield "use_published", what, Message("enter one, or set it to false")


def _questions(made: Definition) -> Iterator[tuple[str, Question]]:
    """Yield each question with its place."""
    for name in ("sheet", "factors", "post_test"):
        for number, one in enumerate(getattr(made, name)):
            yield f"{name}[{number}]", one
    if made.consistency is not None:
        yield "consistency", made.consistency


def _constraint_faults(made: Definition) -> Iterator[Fault]:
    if made.order.method is OrderMethod.WILLIAMS:
        what = Message(
            "a Williams design contains every pair of neighbours, also of one sequence"
        )
        remedy = Message("remove the constraint or choose random or latin-square")
        yield "order", what, remedy
    if len(made.sequences) < 2:
        what = Message("a single sequence always follows itself")
        yield "order", what, Message("remove the constraint")
