"""What a study is, as values: all that `study.json` says."""

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product

SCHEMA = "hapticplayer.study"
VERSION = 1
LIKERT = (1, 2, 3, 4, 5)

Text = Mapping[str, str]
"""A text in each language of the study."""


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


@dataclass(frozen=True, slots=True)
class Sequence:
    """A sequence that is played.

    Attributes:
        key: in data and figures.
        title: for the operator and figures; participants never see it.
        folder: relative to the study's folder, or absolute; empty while unknown.
    """

    key: str
    title: Text
    folder: str


@dataclass(frozen=True, slots=True)
class Choice:
    """One of the answers that a question offers."""

    key: str
    text: Text


@dataclass(frozen=True, slots=True)
class Question:
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

    key: str
    kind: QuestionKind
    text: Text
    published: Text | None = None
    least: int = 0
    most: int = 0
    choices: tuple[Choice, ...] = ()
    for_each_feedback: bool = False
    required: bool = True


@dataclass(frozen=True, slots=True)
class Level:
    """By how much the force of a consistency trial is changed."""

    delay_s: float = 0.0
    gain: float = 1.0


@dataclass(frozen=True, slots=True)
class Condition:
    """What is played in one trial."""

    sequence: str
    feedback: str
    delay_s: float = 0.0
    gain: float = 1.0
    repeat: int = 1

    @property
    def key(self) -> str:
        """Name in records and tables."""
        made = f"{self.sequence}/{self.feedback}"
        if (self.delay_s, self.gain, self.repeat) != (0.0, 1.0, 1):
            made += f"/{1e3 * self.delay_s:+.0f}ms/x{self.gain:g}/{self.repeat}"
        return made


@dataclass(frozen=True, slots=True)
class Order:
    """How orders are made.

    Attributes:
        method: see OrderMethod.
        seed: of all that is random.
        no_sequence_twice_in_a_row: a constraint.
    """

    method: OrderMethod
    seed: int
    no_sequence_twice_in_a_row: bool = False


@dataclass(frozen=True, slots=True)
class Limits:
    """Beyond which a trial's playback is not sound.

    Attributes:
        dropped_share: of pictures.
        sync_ms: median of force against picture or sound.
        missed_share: of the periods of the force loop.
        silence_s: of sound that was missing.
    """

    dropped_share: float = 0.02
    sync_ms: float = 20.0
    missed_share: float = 0.01
    silence_s: float = 0.1


@dataclass(frozen=True, slots=True)
class Checks:
    """What has to be in order before the first trial.

    Attributes:
        device: whether one is required.
        sound: whether the operator has to confirm that sound is heard.
        disk_free_mb: least room.
        scheduling: classes of the force loop that are good enough.
    """

    device: bool = True
    sound: bool = True
    disk_free_mb: int = 1000
    scheduling: tuple[str, ...] = ("fifo", "slice")


@dataclass(frozen=True, slots=True)
class Definition:
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
        scale: what the ends of the five-point scale say.
        sheet: questions before the first trial.
        post_test: questions after the last.
        texts: of the pages, by name.
        words: on the participant's buttons, by name.
        use_published: show the published wording where there is one.
        operator_is_blind: the operator's screen does not tell the condition.
        lsl: offer markers and force to other programs on the machine.
        order, limits, checks: see there.
    """

    id: str
    title: str
    template: str
    languages: tuple[str, ...]
    trial: TrialKind
    sequences: tuple[Sequence, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[Question, ...]
    scale: tuple[Text, Text]
    sheet: tuple[Question, ...]
    post_test: tuple[Question, ...]
    texts: Mapping[str, Text]
    words: Mapping[str, Text]
    order: Order
    levels: tuple[Level, ...] = ()
    repeats: int = 1
    consistency: Question | None = None
    use_published: bool = False
    operator_is_blind: bool = True
    lsl: bool = False
    limits: Limits = field(default_factory=Limits)
    checks: Checks = field(default_factory=Checks)

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
