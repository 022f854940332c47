"""Reads and checks `study.json`."""

from pathlib import Path

from hapticplayer.errors import Message
from hapticplayer.study.definition import (
    SCHEMA,
    VERSION,
    Checks,
    Choice,
    Definition,
    Level,
    Limits,
    Order,
    OrderMethod,
    Question,
    QuestionKind,
    Sequence,
    Text,
    TrialKind,
)
from hapticplayer.study.tree import Branch, keys_differ, parse, read_file

DEFINITION = "study.json"
PAGE_TEXTS = (
    "consent",
    "demonstration",
    "ready",
    "questions",
    "post_test",
    "thanks",
    "retention",
)
WORDS = (
    "agree",
    "decline",
    "next",
    "start",
    "feel",
    "yes",
    "no",
    "feedback",
    "clip",
    "missing",
    "paused",
    "go_on",
    "leave",
    "stopped",
    "problem",
)
MAX_CONDITIONS = 400
MAX_DELAY_S = 5.0
MAX_GAIN = 10.0
MAX_ANSWER = 4000
MAX_AGE_OR_NUMBER = 1_000_000
_ENTRIES = [
    "schema",
    "version",
    "id",
    "title",
    "template",
    "languages",
    "trial",
    "sequences",
    "feedbacks",
    "factors",
    "scale",
    "sheet",
    "post_test",
    "texts",
    "words",
    "order",
    "levels",
    "repeats",
    "consistency",
    "use_published",
    "operator_is_blind",
    "lsl",
    "limits",
    "checks",
]


def read_definition(folder: Path) -> Definition:
    """Return the definition of the study in a folder.

    Raises:
        StudyError: what is wrong, in which entry, and what to do.
    """
    path = folder / DEFINITION
    return parse_definition(read_file(path), str(path))


def parse_definition(content: bytes, where: str) -> Definition:
    """Return the definition that a JSON text holds; `where` is for messages.

    Raises:
        StudyError: as `read_definition`.
    """
    return parse(content, where, _study)


def _study(root: Branch) -> Definition:
    if not root.has("schema") or root.get("schema").value != SCHEMA:
        root.refuse(
            Message("describes no study"), Message("give the folder of a study")
        )
    version = root.get("version").value
    if version != VERSION:
        root.refuse(
            Message(
                "has version {found}, this program reads {version}",
                found=version,
                version=VERSION,
            ),
            Message("update hapticplayer"),
        )
    root.only(*_ENTRIES)
    languages = tuple(entry.key() for entry in root.each("languages", least=1))
    keys_differ(root.get("languages"), languages)
    trial = TrialKind(root.get("trial").one_of(TrialKind))
    made = Definition(
        id=root.get("id").key(),
        title=root.get("title").text(),
        template=root.get("template").text(),
        languages=languages,
        trial=trial,
        sequences=_sequences(root, languages),
        feedbacks=_keys(root, "feedbacks"),
        factors=_questions(root, "factors", languages, (QuestionKind.LIKERT,)),
        scale=_scale(root.get("scale"), languages),
        sheet=_questions(root, "sheet", languages),
        post_test=_questions(root, "post_test", languages),
        texts=_texts(root, "texts", PAGE_TEXTS, languages),
        words=_texts(root, "words", WORDS, languages),
        order=_order(root.get("order")),
        levels=tuple(_level(entry) for entry in root.each("levels"))
        if root.has("levels")
        else (),
        repeats=root.get("repeats").whole(1, 100) if root.has("repeats") else 1,
        consistency=_question(root.get("consistency"), languages)
        if root.has("consistency")
        else None,
        use_published=root.get("use_published").flag(),
        operator_is_blind=root.get("operator_is_blind").flag(),
        lsl=root.has("lsl") and root.get("lsl").flag(),
        limits=_limits(root.get("limits")),
        checks=_checks(root.get("checks")),
    )
    _check_whole(root, made)
    return made


def _check_whole(root: Branch, made: Definition) -> None:
    """Refuse what is right in each entry and wrong together."""
    count = len(made.conditions)
    if not 2 <= count <= MAX_CONDITIONS:
        root.refuse(
            Message(
                "makes {count} conditions; 2 to {most} go",
                count=count,
                most=MAX_CONDITIONS,
            )
        )
    if not made.trial_questions:
        missing = "factors" if made.trial is TrialKind.RATING else "consistency"
        root.refuse(
            Message("asks nothing after a clip"),
            Message("add a question to {page!r}", page=missing),
        )
    if made.trial is TrialKind.CONSISTENCY:
        question = made.trial_questions[0]
        if question.kind is not QuestionKind.YES_NO:
            root.get("consistency").refuse(Message("is no yes-no question"))
    for question in made.sheet:
        if question.for_each_feedback:
            root.get("sheet").refuse(
                Message("asks about feedbacks before any was felt")
            )
    if made.order.no_sequence_twice_in_a_row:
        _check_constraint(root.get("order"), made)


def _check_constraint(order: Branch, made: Definition) -> None:
    if made.order.method is OrderMethod.WILLIAMS:
        order.refuse(
            Message(
                "a Williams design has every pair of neighbours, also those of one "
                "sequence"
            ),
            Message("drop the constraint or choose random or latin-square"),
        )
    if len(made.sequences) < 2:
        order.refuse(
            Message("one sequence cannot but follow itself"),
            Message("drop the constraint"),
        )


def _text(branch: Branch, languages: tuple[str, ...]) -> Text:
    branch.only(*languages)
    return {language: branch.get(language).text() for language in languages}


def _texts(
    root: Branch, entry: str, names: tuple[str, ...], languages: tuple[str, ...]
) -> dict[str, Text]:
    found = root.get(entry)
    found.only(*names)
    return {name: _text(found.get(name), languages) for name in names}


def _keys(root: Branch, name: str) -> tuple[str, ...]:
    found = tuple(entry.key() for entry in root.each(name, least=1))
    keys_differ(root.get(name), found)
    return found


def _sequences(root: Branch, languages: tuple[str, ...]) -> tuple[Sequence, ...]:
    found = []
    for entry in root.each("sequences", least=1):
        entry.only("key", "title", "folder")
        folder = entry.get("folder")
        if not isinstance(folder.value, str):
            folder.refuse(
                Message("is no text"),
                Message("give the folder of a sequence, or nothing"),
            )
        title = _text(entry.get("title"), languages)
        found.append(Sequence(entry.get("key").key(), title, folder.value))
    keys_differ(root.get("sequences"), (s.key for s in found))
    return tuple(found)


def _questions(
    root: Branch,
    name: str,
    languages: tuple[str, ...],
    kinds: tuple[QuestionKind, ...] = tuple(QuestionKind),
) -> tuple[Question, ...]:
    found = tuple(_question(entry, languages, kinds) for entry in root.each(name))
    keys_differ(root.get(name), (question.key for question in found))
    return found


def _question(
    entry: Branch,
    languages: tuple[str, ...],
    kinds: tuple[QuestionKind, ...] = tuple(QuestionKind),
) -> Question:
    entry.only(
        *[
            "key",
            "kind",
            "text",
            "published",
            "least",
            "most",
            "choices",
            "for_each_feedback",
            "required",
        ]
    )
    kind = QuestionKind(entry.get("kind").one_of(kinds))
    choices = _choices(entry, languages) if kind is QuestionKind.CHOICE else ()
    least, most = 0, MAX_ANSWER
    if kind is QuestionKind.NUMBER:
        least = entry.get("least").whole(-MAX_AGE_OR_NUMBER, MAX_AGE_OR_NUMBER)
        most = entry.get("most").whole(least, MAX_AGE_OR_NUMBER)
    elif kind is QuestionKind.TEXT and entry.has("most"):
        most = entry.get("most").whole(1, MAX_ANSWER)
    return Question(
        key=entry.get("key").key(),
        kind=kind,
        text=_text(entry.get("text"), languages),
        published=_published(entry, languages),
        least=least,
        most=most,
        choices=choices,
        for_each_feedback=entry.has("for_each_feedback")
        and entry.get("for_each_feedback").flag(),
        required=not entry.has("required") or entry.get("required").flag(),
    )


def _published(entry: Branch, languages: tuple[str, ...]) -> Text | None:
    if not entry.has("published"):
        return None
    entry.get("published").only(*languages)
    found = {name: text.text() for name, text in entry.members("published")}
    return found or None


def _choices(entry: Branch, languages: tuple[str, ...]) -> tuple[Choice, ...]:
    found = []
    for choice in entry.each("choices", least=2):
        choice.only("key", "text")
        text = _text(choice.get("text"), languages)
        found.append(Choice(choice.get("key").key(), text))
    keys_differ(entry.get("choices"), (choice.key for choice in found))
    return tuple(found)


def _scale(entry: Branch, languages: tuple[str, ...]) -> tuple[Text, Text]:
    entry.only("lowest", "highest")
    lowest, highest = entry.get("lowest"), entry.get("highest")
    return _text(lowest, languages), _text(highest, languages)


def _order(entry: Branch) -> Order:
    entry.only("method", "seed", "no_sequence_twice_in_a_row")
    return Order(
        OrderMethod(entry.get("method").one_of(OrderMethod)),
        entry.get("seed").whole(0, 2**53),
        entry.get("no_sequence_twice_in_a_row").flag(),
    )


def _level(entry: Branch) -> Level:
    entry.only("delay_s", "gain")
    delay_s = entry.get("delay_s").number(-MAX_DELAY_S, MAX_DELAY_S)
    return Level(delay_s, entry.get("gain").number(0.0, MAX_GAIN))


def _limits(entry: Branch) -> Limits:
    entry.only("dropped_share", "sync_ms", "missed_share", "silence_s")
    return Limits(
        entry.get("dropped_share").number(0.0, 1.0),
        entry.get("sync_ms").number(0.0, 1e6),
        entry.get("missed_share").number(0.0, 1.0),
        entry.get("silence_s").number(0.0, 1e6),
    )


def _checks(entry: Branch) -> Checks:
    entry.only("device", "sound", "disk_free_mb", "scheduling")
    return Checks(
        entry.get("device").flag(),
        entry.get("sound").flag(),
        entry.get("disk_free_mb").whole(0, 10**9),
        tuple(
            word.one_of(("fifo", "slice", "normal"))
            for word in entry.each("scheduling", least=1)
        ),
    )
