"""The definition of a study: the structure of `study.json` and its allowed values."""

import enum
from collections.abc import Mapping
from itertools import product
from pathlib import Path
from typing import Annotated, Literal, NoReturn, TypeVar

from msgspec import Meta, Struct

from hapticplayer.errors import Message, StudyError
from hapticplayer.model import ranges
from hapticplayer.rendering import condition_named
from hapticplayer.rendering.condition import described
from hapticplayer.structures import FILLED, KEY, MAX_JSON_BYTES, MAX_TEXT
from hapticplayer.untrusted import read_regular

GIVE_STUDY = Message("give the folder of a study")
CORRECT = Message("correct it")
SCHEMA = "hapticplayer.study"
VERSION = 1
MAX_CONDITIONS = 400
QOE = "qoe"
"""The sum of questions; no question has this key."""
MAX_ANSWER = 4000
ANSWER_S = 10.0  # usual time for a question, with the pages around it
DEMONSTRATION_S = 300.0  # and consent, and getting to know the device
MAX_ITEMS = 2_000
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
Delay = Annotated[
    float, Meta(ge=ranges.FORCE_DELAY_S.least, le=ranges.FORCE_DELAY_S.largest)
]
Gain = Annotated[float, Meta(ge=ranges.FORCE_GAIN.least, le=ranges.FORCE_GAIN.largest)]
Seed = Annotated[int, Meta(ge=0, le=2**53)]


class TrialKind(enum.StrEnum):
    """What trials are for."""

    RATING = "rating"
    """Conditions are compared by the answers."""
    YES_NO = "yes-no"
    """A question about each level of a force, such as whether it matched the video."""
    TWO_INTERVAL = "two-interval"
    """In which of two plays of a clip something was: forced choice."""
    MAGNITUDE = "magnitude"
    """A number in proportion to what was felt of each level."""


class QuestionKind(enum.StrEnum):
    """The type of answer; see `questions.ANSWER_KINDS`."""

    SCALE = "scale"
    VISUAL = "visual"
    NUMBER = "number"
    YES_NO = "yes-no"
    CHOICE = "choice"
    CHOICES = "choices"
    PAIR = "pair"
    TEXT = "text"


class RatingKind(enum.StrEnum):
    """How somebody rates while a clip plays; see `rating_rules`."""

    SLIDER = "slider"
    NUMBER = "number"
    HELD_KEY = "held-key"


_JUDGED = {
    TrialKind.YES_NO: QuestionKind.YES_NO,
    TrialKind.TWO_INTERVAL: QuestionKind.CHOICE,
    TrialKind.MAGNITUDE: QuestionKind.NUMBER,
}


class When(enum.StrEnum):
    """When a page of questions is shown."""

    BEFORE = "before"
    BEFORE_CLIP = "before-clip"
    AFTER_CLIP = "after-clip"
    AFTER = "after"


OF_TRIALS = (When.BEFORE_CLIP, When.AFTER_CLIP)
"""When pages are shown once for each clip."""


class OrderMethod(enum.StrEnum):
    """How the order of conditions is made for a participant."""

    RANDOM = "random"
    LATIN_SQUARE = "latin-square"
    WILLIAMS = "williams"
    LIST = "list"
    """From orders.csv in the study's folder."""


class JsonObject(Struct, frozen=True, forbid_unknown_fields=True):
    """An object in the file; unknown entries are refused."""


class StudySequence(JsonObject, frozen=True):
    """A sequence of the study.

    Attributes:
        key: in data and figures.
        title: for the operator and figures; never shown to participants.
        folder: relative to the study's folder, or absolute; empty if not set yet.
        factors: its level of each factor in which sequences differ, such as viewpoint.
    """

    key: Key
    title: Text
    folder: Annotated[str, Meta(max_length=MAX_TEXT)]
    factors: dict[Key, Key] = {}


class AnswerOption(JsonObject, frozen=True):
    """One of the answers that a question offers; it may count as a number."""

    key: Key
    text: Text
    value: Whole | None = None


class PointLabel(JsonObject, frozen=True):
    """The label of a point of a scale."""

    at: Whole
    text: Text


class Question(JsonObject, frozen=True):
    """One question.

    Attributes:
        key: of its answer, in data and figures.
        kind: how it is answered.
        text: the study's own wording.
        help: a line below it.
        published: the wording of a publication, if entered.
        least: smallest number, or first point of a SCALE.
        most: largest number, last point of a SCALE, or length of a text in characters.
        unit: of a number, in the data.
        labels: of points of a SCALE or a VISUAL scale; both ends of a PAIR.
        choices: of CHOICE and CHOICES.
        for_each_feedback: asked once for "Feedback 1", "Feedback 2", ...
        in_qoe: whether it is part of the sum "qoe".
        required: whether an answer is required.
    """

    key: Key
    kind: QuestionKind
    text: Text
    help: Text | None = None
    published: Text | None = None
    least: Whole | None = None
    most: Whole | None = None
    unit: Annotated[str, Meta(max_length=40)] = ""
    labels: Several[PointLabel] = ()
    choices: Several[AnswerOption] = ()
    for_each_feedback: bool = False
    in_qoe: bool = False
    required: bool = True


class ScoreRule(enum.StrEnum):
    """What is made of several answers first."""

    SUM = "sum"
    MEAN = "mean"


class Score(JsonObject, frozen=True):
    """A number that follows from the answers of a page; `scoring` computes it.

    Attributes:
        key: in data and figures.
        text: what it is, in English.
        of: questions of the page, or scores before it; what is named twice counts twice.
        by: what is made of them.
        reversed: those of `of` that count from the other end of their range.
        polynomial: c0, c1, c2 ...: the score is c0 + c1 x + c2 x^2 ... of the sum or mean x.
        least_answered: of a mean, how many of `of` have to be answered; all if not given.
    """

    key: Key
    text: Line
    of: Some[Key]
    by: ScoreRule
    reversed: Several[Key] = ()
    polynomial: Annotated[tuple[float, ...], Meta(min_length=1, max_length=8)] = (
        0.0,
        1.0,
    )
    least_answered: Annotated[int, Meta(ge=1, le=MAX_ITEMS)] | None = None


class QuestionPage(JsonObject, frozen=True):
    """Questions that are shown together.

    Attributes:
        key: of its answers in the records.
        when: it is shown.
        questions: in this order.
        text: above them.
        replays: whether all clips may be played again there.
        scale: name of the scale that the questions are from; see `scales`.
        scores: of the answers, in this order.
        one_by_one: whether the questions are shown one after the other.
    """

    key: Key
    when: When
    questions: Some[Question]
    text: Text | None = None
    replays: bool = False
    scale: Key | None = None
    scores: Several[Score] = ()
    one_by_one: bool = False


class LiveRating(JsonObject, frozen=True):
    """What a participant rates while a clip plays.

    Attributes:
        key: in data and figures.
        kind: see RatingKind.
        text: what is rated.
        least, most: of a slider or number.
        labels: of points of a slider.
        by: what moves a slider; see `rating_rules.MOVERS`.
        hold: the key that is held.
        every_s: between two numbers, in the time of the clip.
        spoken: whether the number is said aloud and the operator enters it.
        stop_at: the clip ends when the rating is as large.
        rest: the text of the break after that.
    """

    key: Key
    kind: RatingKind
    text: Text
    least: Whole | None = None
    most: Whole | None = None
    labels: Several[PointLabel] = ()
    by: Several[str] = ()
    hold: str | None = None
    every_s: Annotated[float, Meta(ge=5.0, le=3600.0)] | None = None
    spoken: bool = False
    stop_at: Whole | None = None
    rest: Text | None = None


class StudyFeedback(JsonObject, frozen=True):
    """A feedback condition with parameters.

    Attributes:
        condition: see `rendering.FEEDBACKS`, or the name of a track of each sequence.
        parameters: of the condition.
        key: in data and figures, the name of the condition if not given.
    """

    condition: Key
    parameters: dict[str, float | str] = {}
    key: Key | None = None

    @property
    def name(self) -> str:
        """Name in records and tables."""
        return self.key or self.condition

    @property
    def text(self) -> str:
        """What it is, in English, for tables."""
        found = condition_named(self.condition)
        if found is None:
            return f"track {self.condition} of each sequence"
        given = described(self.parameters)
        return f"{found.text.lower()}: {found.meaning}" + f" ({given})" * bool(given)


class ForceLevel(JsonObject, frozen=True):
    """Delay and gain of a force."""

    delay_s: Delay = 0.0
    gain: Gain = 1.0


class FeedbackLevel(JsonObject, frozen=True):
    """A feedback with delay and gain of its force."""

    feedback: Key
    delay_s: Delay = 0.0
    gain: Gain = 1.0


class Staircase(JsonObject, frozen=True):
    """Levels that follow from the answers, see `intervals`.

    Attributes:
        changes: what is added to the standard.
        correct: so many correct answers in a row make the change smaller.
        start: first change; none is larger.
        steps: between changes: the first until the first reversal, and so on; the last
            is the smallest change, too.
        trials: of each sequence and feedback.
    """

    changes: Literal["delay_s", "gain"]
    correct: Annotated[int, Meta(ge=2, le=3)]
    start: Amount
    steps: Some[Amount]
    trials: Annotated[int, Meta(ge=2, le=MAX_CONDITIONS)]


class Condition(JsonObject, frozen=True):
    """What is played in a trial."""

    sequence: Key
    feedback: Key
    delay_s: Delay = 0.0
    gain: Gain = 1.0
    repeat: Annotated[int, Meta(ge=1, le=MAX_CONDITIONS)] = 1

    @property
    def level(self) -> FeedbackLevel:
        return FeedbackLevel(self.feedback, self.delay_s, self.gain)

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
        seed: of all random orders.
        no_sequence_twice_in_a_row: whether no sequence may follow itself.
    """

    method: OrderMethod
    seed: Seed
    no_sequence_twice_in_a_row: bool = False


class PlaybackLimits(JsonObject, frozen=True):
    """Limits of a valid playback; beyond them a trial is marked as invalid.

    Attributes:
        dropped_share: share of frames.
        sync_ms: median offset between force and video or sound.
        missed_share: share of the periods of the haptic loop.
        silence_s: duration of audio dropouts.
    """

    dropped_share: Share = 0.02
    sync_ms: Amount = 20.0
    missed_share: Share = 0.01
    silence_s: Amount = 0.1


class Checks(JsonObject, frozen=True):
    """Requirements that are checked before the first trial.

    Attributes:
        device: whether a device is required.
        sound: whether the operator has to confirm audible sound.
        disk_free_mb: minimum free space.
        scheduling: accepted scheduling classes of the haptic loop.
    """

    device: bool = True
    sound: bool = True
    disk_free_mb: Annotated[int, Meta(ge=0, le=10**9)] = 1000
    scheduling: Some[Literal["fifo", "slice", "normal"]] = ("fifo", "slice")


class PageTexts(JsonObject, frozen=True):
    """Texts of the pages, and how long data are kept; `PageMaker` fills {blanks}."""

    consent: Text
    demonstration: Text
    ready: Text
    thanks: Text
    retention: Text


class ButtonWords(JsonObject, frozen=True):
    """Labels of the participant's buttons, and short messages."""

    agree: Text
    decline: Text
    next: Text
    start: Text
    feel: Text
    yes: Text
    no: Text
    feedback: Text
    clip: Text
    optional: Text
    missing: Text
    centre: Text
    paused: Text
    resume: Text
    leave: Text
    stopped: Text
    problem: Text


class Definition(JsonObject, frozen=True):
    """A study.

    Attributes:
        id: made by the program; only sessions of the same id are merged.
        title: for people.
        template: name of the template.
        languages: of all texts; the first one is the default.
        trial: kind of the trials.
        sequences, feedbacks: their combinations are the conditions, with `levels`; a
            feedback without parameters may be given by its name alone.
        levels: of the force, for trials other than of ratings.
        repeats: how often each of these is played.
        standard: of two-interval trials: what the other force is compared with.
        staircase: of two-interval trials, in place of levels and repeats.
        pages: of questions, in this order within each `When`.
        texts: of the pages.
        words: labels of buttons.
        use_published: show the published wording where there is one.
        operator_is_blind: hide the condition from the operator.
        while_watching: what is rated while a clip plays.
        gap_s: least time from the end of a clip to the beginning of the next one.
        lsl: offer markers and force as LSL streams.
        needed_streams: LSL streams of other programs without which no trial begins.
        lab_recorder: start and stop LabRecorder; no trial begins unless it records.
        order, limits, checks: see there.
    """

    id: Key
    title: Line
    template: Line
    languages: Some[Key]
    trial: TrialKind
    sequences: Some[StudySequence]
    feedbacks: Some[Key | StudyFeedback]
    pages: Some[QuestionPage]
    texts: PageTexts
    words: ButtonWords
    order: Order
    use_published: bool
    operator_is_blind: bool
    limits: PlaybackLimits
    checks: Checks
    levels: Several[ForceLevel] = ()
    repeats: Annotated[int, Meta(ge=1, le=100)] = 1
    standard: FeedbackLevel | None = None
    staircase: Staircase | None = None
    while_watching: Several[LiveRating] = ()
    gap_s: Annotated[float, Meta(ge=0.0, le=3600.0)] = 0.0
    lsl: bool = False
    needed_streams: Several[Line] = ()
    lab_recorder: bool = False
    schema: str = SCHEMA
    version: int = VERSION

    @property
    def chosen_feedbacks(self) -> tuple[StudyFeedback, ...]:
        """The feedbacks, those without parameters too."""
        return tuple(
            StudyFeedback(one) if isinstance(one, str) else one
            for one in self.feedbacks
        )

    @property
    def feedback_keys(self) -> tuple[str, ...]:
        return tuple(one.name for one in self.chosen_feedbacks)

    @property
    def sequence_factors(self) -> dict[str, tuple[str, ...]]:
        """The level of each sequence, by factor."""
        names = dict.fromkeys(name for one in self.sequences for name in one.factors)
        return {
            name: tuple(one.factors.get(name, "") for one in self.sequences)
            for name in names
        }

    def levels_of(self, sequence: str) -> tuple[str, ...]:
        """The levels of a sequence, in the order of `sequence_factors`."""
        of = (one.factors for one in self.sequences if one.key == sequence)
        levels = next(of, {})
        return tuple(levels.get(name, "") for name in self.sequence_factors)

    @property
    def most_conditions(self) -> int:
        """How many there are at most, without listing them."""
        repeats = self.staircase.trials if self.staircase else self.repeats
        of_each = max(1, len(self.levels)) * repeats
        return len(self.sequences) * len(self.feedbacks) * of_each

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """All conditions, in the order of the definition."""
        as_it_is = (TrialKind.RATING, TrialKind.TWO_INTERVAL)
        levels = self.levels or (ForceLevel(),) * (self.trial in as_it_is)
        repeats = self.staircase.trials if self.staircase else self.repeats
        of = self.sequences, self.feedback_keys, levels, range(repeats)
        found = (
            Condition(sequence.key, feedback, level.delay_s, level.gain, 1 + repeat)
            for sequence, feedback, level, repeat in product(*of)
        )
        return tuple(
            one for one in found if self.staircase or one.level != self.standard
        )

    def pages_at(self, when: When) -> tuple[QuestionPage, ...]:
        return tuple(page for page in self.pages if page.when is when)

    def questions_at(self, *when: When) -> tuple[Question, ...]:
        """The questions of these pages, in the order in which they are asked."""
        return tuple(q for at in when for p in self.pages_at(at) for q in p.questions)

    @property
    def judgement(self) -> Question | None:
        """The question that is analysed in trials other than of ratings."""
        asked, kind = self.questions_at(When.AFTER_CLIP), _JUDGED.get(self.trial)
        return next((q for q in asked if q.kind is kind), None)

    def expected_min(self, clip_s: Mapping[str, float]) -> int:
        """About how long a session takes, in steps of 5 minutes."""
        trials = self.conditions
        asked = len(self.questions_at(When.BEFORE, When.AFTER))
        asked += len(trials) * len(self.questions_at(*OF_TRIALS))
        played_s = sum(clip_s[trial.sequence] for trial in trials)
        played_s *= 2 if self.trial is TrialKind.TWO_INTERVAL else 1
        all_s = played_s + asked * ANSWER_S + DEMONSTRATION_S
        all_s += self.gap_s * (len(trials) - 1)
        return 5 * max(1, round(all_s / 300.0))

    def wording(self, question: Question, language: str) -> str:
        if self.use_published and question.published:
            return question.published.get(language) or question.text[language]
        return question.text[language]


def read_file(path: Path, max_bytes: int = MAX_JSON_BYTES) -> bytes:
    """The content of a small file of a study; raises StudyError."""
    return read_regular(path, max_bytes, StudyError, GIVE_STUDY)


def refuse(path: str, field: str, what: Message, remedy: Message = CORRECT) -> NoReturn:
    """Raise StudyError for a place in a file, such as `sequences[2].key`."""
    raise StudyError(what, where=f"{path}, {field}" if field else path, remedy=remedy)
