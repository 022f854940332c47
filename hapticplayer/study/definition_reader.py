"""Reads and checks `study.json`."""

import re
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
    QOE,
    SCHEMA,
    VERSION,
    Definition,
    OrderMethod,
    Question,
    StudyFeedback,
    Text,
    TrialKind,
    When,
    refuse,
)
from hapticplayer.study.questions import OF_KINDS, Fault, kind_of

DEFINITION = "study.json"
_TO_BE_WORDED = re.compile(r"\s*\u2039.*\u203a\s*", re.DOTALL)
STEPS = ("consent", "demonstration", "end")
"""Of every session; the other ones are named after pages."""


def parse_definition(content: bytes, path: str) -> Definition:
    """Return the definition in a JSON text; `path` is for messages."""
    value = decode(content, dict[str, Any], path, StudyError)
    other = Message("is not the definition of a study"), GIVE_STUDY
    check_schema(value, (SCHEMA, VERSION), path, other, StudyError)
    made = convert(value, Definition, path, StudyError)
    for field, what, remedy in faults_of(made):
        refuse(path, field, what, remedy)
    return made


def to_be_worded(made: Definition) -> Iterator[str]:
    """The fields of texts that only say what is to be written there, in \u2039 \u203a."""
    for field, text in _texts(made):
        for language, words in text.items():
            if _TO_BE_WORDED.fullmatch(words):
                yield f"{field}.{language}"


def faults_of(made: Definition) -> Iterator[Fault]:
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
        for lacking in (
            () if field.endswith("published") else sorted(known - text.keys())
        ):
            yield field, *missing(lacking)
        for foreign in sorted(text.keys() - known):
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
            if name == "factors":
                continue
            place = f"{field}.{name}" if field else name
            yield from _texts(getattr(part, name), place)


def _key_faults(made: Definition) -> Iterator[Fault]:
    yield from _alike("languages", made.languages, "")
    yield from _alike("feedbacks", made.feedback_keys)
    yield from _alike("sequences", [one.key for one in made.sequences])
    yield from _alike("pages", [one.key for one in made.pages])
    taken: set[str] = set()
    for field, key in _data_keys(made):
        if key in taken:
            yield f"{field}.key", Message("duplicate key {key!r}", key=key), _RENAME
        taken.add(key)
        if key == QOE:
            what = Message("{key!r} is the name of the sum of questions", key=QOE)
            yield f"{field}.key", what, _OTHER
    named = [(f"pages[{n}].key", page.key) for n, page in enumerate(made.pages)]
    for field, key in named:
        if key in STEPS or key.startswith("trial-"):
            yield field, Message("{key!r} is the name of another step", key=key), _OTHER


def _data_keys(made: Definition) -> Iterator[tuple[str, str]]:
    """Yield the place and name of all that is a column of the data."""
    for field, _, asked in _questions(made):
        yield field, asked.key
    for number, page in enumerate(made.pages):
        for place, score in enumerate(page.scores):
            yield f"pages[{number}].scores[{place}]", score.key
    for number, rating in enumerate(made.while_watching):
        yield f"while_watching[{number}]", rating.key


def _alike(field: str, keys: Sequence[str], place: str = ".key") -> Iterator[Fault]:
    for number, key in enumerate(keys):
        if key in keys[:number]:
            what = Message("duplicate key {key!r}", key=key)
            yield f"{field}[{number}]{place}", what, _RENAME


def _feedback_faults(made: Definition) -> Iterator[Fault]:
    """Parameters that a condition does not have, or values out of range."""
    for number, one in enumerate(made.chosen_feedbacks):
        field, found = f"feedbacks[{number}]", condition_named(one.condition)
        if one.key not in (None, one.condition) and condition_named(str(one.key)):
            what = Message("{key!r} is the name of another condition", key=str(one.key))
            yield f"{field}.key", what, _OTHER
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
    count = made.most_conditions
    if count <= MAX_CONDITIONS**2:  # else to list them would take for ever
        count = len(made.conditions)
    if not 2 <= count <= MAX_CONDITIONS:
        what = Message(
            "must have 2 to {most} conditions, has {count}",
            count=count,
            most=MAX_CONDITIONS,
        )
        yield "", what, CORRECT
    after_clip = made.questions_at(When.AFTER_CLIP)
    if not after_clip:
        what = Message("has no question after a clip")
        yield "pages", what, Message("add a page that is shown after each clip")
    if made.trial is not TrialKind.RATING:
        from hapticplayer.study.intervals import faults_of_trials

        yield from faults_of_trials(made)
    for field, when, asked in _questions(made):
        for name, what, remedy in kind_of(asked).faults():
            yield f"{field}.{name}", what, remedy
        yield from _unused_in(field, when, asked)
    yield from _faults_of_scores(made)
    if made.sequence_factors:
        from hapticplayer.study import sequence_factors  # few studies have them

        yield from sequence_factors.faults(made)
    if made.while_watching:
        from hapticplayer.study import rating_rules  # few studies have them

        yield from rating_rules.faults(made)


def _faults_of_scores(made: Definition) -> Iterator[Fault]:
    scored = [(i, page) for i, page in enumerate(made.pages) if page.scores]
    if not scored:
        return
    from hapticplayer.study.scoring import faults_of_scores  # few studies have scores

    for number, page in scored:
        for name, what, remedy in faults_of_scores(page):
            yield f"pages[{number}].{name}", what, remedy


_RENAME, _OTHER = Message("rename one of them"), Message("choose another key")
_REMOVE = Message("remove it")


def _unused_in(field: str, when: When, asked: Question) -> Iterator[Fault]:
    """Entries of a question that would change nothing."""
    uses = kind_of(asked).uses
    for name in OF_KINDS:
        given = getattr(asked, name)
        if given not in (None, (), "", False) and name not in uses:
            what = Message("is not used in {kind} questions", kind=asked.kind.value)
            yield f"{field}.{name}", what, _REMOVE
    if asked.for_each_feedback and when is not When.AFTER:
        what = Message("is only used after the last trial")
        yield f"{field}.for_each_feedback", what, _REMOVE
    if asked.in_qoe and when is not When.AFTER_CLIP:
        what = Message("is only used after a clip")
        yield f"{field}.in_qoe", what, _REMOVE


def _unused(made: Definition) -> Iterator[Fault]:
    """Entries that would change nothing: their author expects them to."""
    is_of_two = made.trial is TrialKind.TWO_INTERVAL
    has_levels = made.trial is not TrialKind.RATING and made.staircase is None
    for name, unused, is_used in (
        ("levels", (), has_levels),
        ("repeats", 1, has_levels),
        ("standard", None, is_of_two),
        ("staircase", None, is_of_two),
    ):
        if getattr(made, name) != unused and not is_used:
            kind = "staircase" if made.staircase and is_of_two else made.trial.value
            what = Message("is not used in {kind} trials", kind=kind)
            yield name, what, _REMOVE
    for name in () if made.lsl else ("needed_streams", "lab_recorder"):
        if getattr(made, name):
            yield name, Message("is only used with LSL"), Message("set 'lsl' to true")
    if len(set(made.levels)) < len(made.levels):
        yield "levels", Message("holds a level twice"), Message("use 'repeats'")
    for number, page in enumerate(made.pages):
        if page.replays and page.when is not When.AFTER:
            what = Message("is only used after the last trial")
            yield f"pages[{number}].replays", what, _REMOVE
    asked_all = [asked for _, _, asked in _questions(made)]
    if made.use_published and not any(one.published for one in asked_all):
        what = Message("no question has a published wording")
        yield "use_published", what, Message("enter one, or set it to false")


def _questions(made: Definition) -> Iterator[tuple[str, When, Question]]:
    """Yield each question with its place and its page's."""
    for number, page in enumerate(made.pages):
        for place, asked in enumerate(page.questions):
            yield f"pages[{number}].questions[{place}]", page.when, asked


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
