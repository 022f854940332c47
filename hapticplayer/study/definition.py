"""What a study is, as values: all that `study.json` says, and what is allowed there."""

import enum
from itertools import product
from typing import Annotated, Literal, TypeVar

from msgspec import Meta, Struct

from hapticplayer.study.json_files import FILLED, KEY, MAX_ITEMS, MAX_TEXT

SCHEMA = "hapticplayer.study"
VERSION = 1
LIKERT = (1, 2, 3, 4, 5)
MAX_CONDITIONS = 400
MAX_ANSWER = 4000
_MAX_NUMBER = 1_000_000

Item = TypeVar("Item")
Key = Annotated[str, Meta(pattern=KEY)]
"""A short name that is safe in files and tables."""
Line = Annotated[str, Meta(pattern=FILLED, max_length=MAX_TEXT)]
Text = dict[str, Line]
"""A text in each language of the study."""
Several = Annotated[tuple[Item, ...], Meta(max_length=MAX_ITEMS)]
Some = Annotated[tuple[Item, ...], Meta(min_length=1, max_length=MAX_ITEMS)]
Share = Annotated[float, Meta(ge=0.0, le=1.0)]
Amount = Annotated[float, Meta(ge=0.0, le=1e6)]
Whole = Annotated[int, Meta(ge=-_MAX_NUMBER, le=_MAX_NUMBER)]
Seed = Annotated[int, Meta(ge=0, le=2**53)]


class TrialKind(enum.StrEnum):
    """What is asked after a clip."""

    RATING = "rating"
    """One question for each factor, on a five-point scale."""
    CONSISTENCY = "consistency"
    """Whether a force that was shifted or scaled went with the picture."""


class QuestionKind(enum.StrEnum):
    """How a question is answered."""

    LIKERT = "likert"
    NUMBER = "number"
    CHOICE = "choice"
    YES_NO = "yes-no"
    TEXT = "text"


class OrderMethod(enum.StrEnum):
    """How a participant's order of conditions is found."""

    RANDOM = "random"
    LATIN_SQUARE = "latin-square"
    WILLIAMS = "williams"
    LIST = "list"
    """From orders.csv in the study's folder."""


class JsonObject(Struct, frozen=True, forbid_unknown_fields=True):
    """An object in the file; a misspelt entry is refused."""


class StudySequence(JsonObject, frozen=True):
    """A sequence that is played.

    Attributes:
        key: in data and figures.
        title: for the operator and figures; participants never see it.
        folder: relative to the study's folder, or absolute; empty while unknown.
    """

    key: Key
    title: Text
    folder: Annotated[str, Meta(max_length=MAX_TEXT)]


class AnswerOption(JsonObject, frozen=True):
    """One of the answers that a question offers."""

    key: Key
    text: Text


class Question(JsonObject, frozen=True):
    """One question.

    Attributes:
        key: of its answer.
        kind: how it is answered.
        text: in the study's own words.
        published: the wording that a publication used, where somebody entered it.
        least: smallest number that is accepted.
        most: largest number, or longest text in characters.
        choices: of a CHOICE.
        for_each_feedback: asked once for "Feedback 1", "Feedback 2", ...
        required: whether it has to be answered.
    """

    key: Key
    kind: QuestionKind
    text: Text
    published: Text | None = None
    least: Whole | None = None
    most: Whole | None = None
    choices: Several[AnswerOption] = ()
    for_each_feedback: bool = False
    required: bool = True

    def __post_init__(self) -> None:
        """Refuse what does not fit its kind."""
        if self.kind is QuestionKind.CHOICE:
            keys = {choice.key for choice in self.choices}
            if not 2 <= len(keys) == len(self.choices):
                raise ValueError("'choices' needs two or more, each with its own 'key'")
        is_bounded = self.least is not None and self.most is not None
        if self.kind is QuestionKind.NUMBER and not (
            is_bounded and self.lowest <= self.highest
        ):
            raise ValueError("needs 'least' and 'most', the smaller one first")
        if self.kind is QuestionKind.TEXT and not 1 <= self.highest <= MAX_ANSWER:
            raise ValueError(f"'most' must be from 1 to {MAX_ANSWER}")

    @property
    def lowest(self) -> int:
        """The smallest number that is accepted."""
        return self.least or 0

    @property
    def highest(self) -> int:
        """The largest number, or most characters, that are accepted."""
        return MAX_ANSWER if self.most is None else self.most


class ForceLevel(JsonObject, frozen=True):
    """By how much the force of a consistency trial is changed."""

    delay_s: Annotated[float, Meta(ge=-5.0, le=5.0)] = 0.0
    gain: Annotated[float, Meta(ge=0.0, le=10.0)] = 1.0


class Condition(JsonObject, frozen=True):
    """What is played in one trial."""

    sequence: Key
    feedback: Key
    delay_s: Annotated[float, Meta(ge=-5.0, le=5.0)] = 0.0
    gain: Annotated[float, Meta(ge=0.0, le=10.0)] = 1.0
    repeat: Annotated[int, Meta(ge=1, le=MAX_CONDITIONS)] = 1

    @property
    def key(self) -> str:
        """Name in records and tables."""
        made = f"{self.sequence}/{self.feedback}"
        if (self.delay_s, self.gain, self.repeat) != (0.0, 1.0, 1):
            made += f"/{1e3 * self.delay_s:+.0f}ms/x{self.gain:g}/{self.repeat}"
        return made


class Order(JsonObject, frozen=True):
    """How orders are made.

    Attributes:
        method: see OrderMethod.
        seed: of all that is random.
        no_sequence_twice_in_a_row: a constraint.
    """

    method: OrderMethod
    seed: Seed
    no_sequence_twice_in_a_row: bool = False


class PlaybackLimits(JsonObject, frozen=True):
    """Beyond which a trial's playback is not sound.

    Attributes:
        dropped_share: of pictures.
        sync_ms: median of force against picture or sound.
        missed_share: of the periods of the force loop.
        silence_s: of sound that was missing.
    """

    dropped_share: Share = 0.02
    sync_ms: Amount = 20.0
    missed_share: Share = 0.01
    silence_s: Amount = 0.1


class Checks(JsonObject, frozen=True):
    """What has to be in order before the first trial.

    Attributes:
        device: whether one is required.
        sound: whether the operator has to confirm that sound is heard.
        disk_free_mb: least room.
        scheduling: classes of the force loop that are good enough.
    """

    device: bool = True
    sound: bool = True
    disk_free_mb: Annotated[int, Meta(ge=0, le=10**9)] = 1000
    scheduling: Some[Literal["fifo", "slice", "normal"]] = ("fifo", "slice")


class Scale(JsonObject, frozen=True):
    """What the ends of the five-point scale say."""

    lowest: Text
    highest: Text


class PageTexts(JsonObject, frozen=True):
    """What the pages say; how long data are kept."""

    consent: Text
    demonstration: Text
    ready: Text
    questions: Text
    post_test: Text
    thanks: Text
    retention: Text


class ButtonWords(JsonObject, frozen=True):
    """What the participant's buttons and short messages say."""

    agree: Text
    decline: Text
    next: Text
    start: Text
    feel: Text
    yes: Text
    no: Text
    feedback: Text
    clip: Text
    missing: Text
    paused: Text
    go_on: Text
    leave: Text
    stopped: Text
    problem: Text


class Definition(JsonObject, frozen=True):
    """A study.

    Attributes:
        id: made by the program; sessions of another study are not merged.
        title: for people.
        template: what it was made of.
        languages: keys of all texts; the first one is the default.
        trial: what is asked after a clip.
        sequences, feedbacks: make the conditions, together with `levels`.
        levels: of consistency trials.
        repeats: how often each consistency trial is played.
        factors: questions after a rating trial, a LIKERT each.
        consistency: the question after a consistency trial, YES_NO.
        scale: its ends.
        sheet: questions before the first trial.
        post_test: questions after the last.
        texts: of the pages.
        words: on the participant's buttons.
        use_published: show the published wording where there is one.
        operator_is_blind: the operator's screen does not tell the condition.
        lsl: offer markers and force to other programs on the machine.
        order, limits, checks: see there.
    """

    id: Key
    title: Line
    template: Line
    languages: Some[Key]
    trial: TrialKind
    sequences: Some[StudySequence]
    feedbacks: Some[Key]
    factors: Several[Question]
    scale: Scale
    sheet: Several[Question]
    post_test: Several[Question]
    texts: PageTexts
    words: ButtonWords
    order: Order
    use_published: bool
    operator_is_blind: bool
    limits: PlaybackLimits
    checks: Checks
    levels: Several[ForceLevel] = ()
    repeats: Annotated[int, Meta(ge=1, le=100)] = 1
    consistency: Question | None = None
    lsl: bool = False
    schema: str = SCHEMA
    version: int = VERSION

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """All that each participant is to feel, in the definition's order."""
        if self.trial is TrialKind.RATING:
            pairs = product(self.sequences, self.feedbacks)
            return tuple(Condition(s.key, feedback) for s, feedback in pairs)
        return tuple(
            Condition(s.key, feedback, level.delay_s, level.gain, 1 + repeat)
            for s, feedback, level, repeat in product(
                self.sequences, self.feedbacks, self.levels, range(self.repeats)
            )
        )

    @property
    def trial_questions(self) -> tuple[Question, ...]:
        """What is asked after each clip."""
        if self.trial is TrialKind.RATING:
            return self.factors
        return (self.consistency,) if self.consistency else ()

    def wording(self, question: Question, language: str) -> str:
        """Return a question's words as a participant reads them."""
        if self.use_published and question.published:
            return question.published.get(language) or question.text[language]
        return question.text[language]
