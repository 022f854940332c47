"""The answers of a study as values, for analysis and export."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

from hapticplayer.errors import Message, Progress
from hapticplayer.study.conduct import Conduct, conduct_of
from hapticplayer.study.definition import (
    OF_TRIALS,
    Condition,
    Definition,
    FeedbackLevel,
    Question,
    QuestionKind,
    Staircase,
    TrialKind,
    When,
)
from hapticplayer.study.intervals import compared, judged
from hapticplayer.study.live_ratings import RatingTrack
from hapticplayer.study.preregistration import Registered, read_registered
from hapticplayer.study.reviewing import read_reviewed, text_digest
from hapticplayer.study.score_answers import RatedAnswers, ScoreAnswers, collect_scores
from hapticplayer.study.scoring import Limits, PageScores, Scoring
from hapticplayer.study.session_folder import SessionState, StoredSession
from hapticplayer.study.sites import known_site
from hapticplayer.study.steps import (
    AnsweredTrial,
    answered_trials,
    page_values,
    trial_step,
)
from hapticplayer.study.study_folder import Study, open_study
from hapticplayer.study.trial_forces import measure_trial_forces
from hapticplayer.study.watched import (
    Course,
    compared_figures,
    courses,
    ranges_of_figures,
    tracks_of,
)


@dataclass(frozen=True, slots=True)
class Rating:
    """One factor of one condition, rated by one participant.

    Attributes:
        participant: code.
        sequence: key of the sequence in the definition.
        feedback: "realistic", "none", "random", or another of the definition's.
        factor: "realism", "sensory", "comfort", "satisfaction", or the definition's own
            question or score.
        value: on its scale; None where it is missing.
        is_valid: whether the playback that was rated was without a fault.
    """

    participant: str
    sequence: str
    feedback: str
    factor: str
    value: float | None
    is_valid: bool


@dataclass(frozen=True, slots=True)
class Judgement:
    """What one participant said of a force in a trial other than of ratings.

    Attributes:
        participant: code.
        sequence: key of the sequence.
        delay_s: delay of the force against the video, s.
        gain: of the force, 1 as recorded.
        answer: yes or no, a number, or whether this force was chosen and not the
            standard; None where it is missing.
        is_valid: whether the playback that was judged was without a fault.
        feedback: key.
        position: of the trial, from 1; 0 where it was not played.
    """

    participant: str
    sequence: str
    delay_s: float
    gain: float
    answer: bool | float | None
    is_valid: bool
    feedback: str = ""
    position: int = 0


@dataclass(frozen=True, slots=True)
class TextAnswer:
    """A text answer; it may name a person until someone has reviewed it.

    Attributes:
        participant: code.
        question: key of the question in the definition.
        feedback: that the answer is about; empty where it is about all.
        text: as written.
        reviewed: whether a person has approved it for export.
        sequence: of the clip that it is about; empty where it is about all.
        trial: position of that clip; None where it is about all.
    """

    participant: str
    question: str
    feedback: str
    text: str
    reviewed: bool
    sequence: str = ""
    trial: int | None = None

    @property
    def name(self) -> str:
        """Of the answer in its session."""
        of = self.feedback if self.trial is None else trial_step(self.trial)
        return "@".join(filter(None, (self.question, of)))


class AnswersTo(NamedTuple):
    """All answers to a question other than ratings and texts.

    Attributes:
        question: of the definition.
        text: its wording.
        feedback: that it is about; empty where it is about all.
        values: of those who answered.
    """

    question: Question
    text: str
    feedback: str
    values: tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Participant:
    """A participant; None for questions without an answer.

    Attributes:
        code: made by the program.
        age: years.
        gender: the definition's word for it.
        handedness: the definition's word for it.
        used_device_before: whether the participant had used such a device.
        complete: whether the session was completed.
        simulated: whether the session was simulated.
        site: where the session took place; empty if that was not said.
        values: answers to the questions before and after the clips and their scores, by
            name.
    """

    code: str
    age: int | None
    gender: str | None
    handedness: str | None
    used_device_before: bool | None
    complete: bool = True
    simulated: bool = False
    site: str = ""
    values: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Answers:
    """All answers of a study; names are keys in the order of the definition.

    `participants` are those with at least one answered trial; `ratings` has an entry for
    each of their planned conditions, with the value None where the answer is missing.

    Attributes:
        participants: in order of their sessions.
        ratings: by participant, then in order of the definition.
        sequences: keys.
        feedbacks: keys.
        factors: keys of what is compared: scores, and questions after a clip whose
            answers are numbers and part of no score.
        open_answers: text answers.
        judgements: answers of trials other than of ratings.
        repeated: ratings that were replaced by those of a repeated trial.
        notices: one sentence for each thing that could not be read or was left out.
        conduct: of the study.
        ranges: least and most of factors, by key; 1 to 5 for others.
        qoe: the factors that are summed; None for all.
        items: the factors that are single questions with steps; None for all.
        others: answers that are counted.
        scores: of scales.
        registered: the plan that was written before, and what differs from it.
        trial, standard, staircase: of the definition.
        courses: ratings over the time of the clips; read where forces are.
        sequence_factors: the level of each of `sequences`, by factor.
    """

    participants: tuple[Participant, ...]
    ratings: tuple[Rating, ...]
    sequences: tuple[str, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    open_answers: tuple[TextAnswer, ...] = ()
    judgements: tuple[Judgement, ...] = ()
    repeated: int = 0
    notices: tuple[str, ...] = ()
    conduct: Conduct = field(default_factory=Conduct)
    ranges: Mapping[str, Limits] = field(default_factory=dict)
    qoe: tuple[str, ...] | None = None
    items: tuple[str, ...] | None = None
    others: tuple[AnswersTo, ...] = ()
    scores: tuple[ScoreAnswers, ...] = ()
    registered: Registered | None = None
    trial: TrialKind = TrialKind.RATING
    standard: FeedbackLevel | None = None
    staircase: Staircase | None = None
    courses: tuple[Course, ...] = ()
    sequence_factors: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def simulated_mark(participants: Sequence[Participant]) -> str:
    """The mark of each page and figure; empty if nobody is simulated."""
    simulated = sum(one.simulated for one in participants)
    if not simulated:
        return ""
    if simulated == len(participants):
        return "simulated data"
    return f"partly simulated data: {simulated} of {len(participants)} participants"


def read_answers(study_folder: str | Path, progress: Progress | None = None) -> Answers:
    """Return all answers of the study in a folder.

    The last answers to a repeated trial count. Trials that are damaged or not part of
    the definition are left out and listed in `notices`.

    Args:
        study_folder: with its definition.
        progress: called while the records of the device are read, for the measured force;
            they are large, and not read for None.
    """
    return collect_answers(open_study(study_folder), progress)


def collect_answers(study: Study, progress: Progress | None = None) -> Answers:
    """Return all answers of an opened study, see `read_answers`."""
    sessions, notices = study.sessions()
    notices += _session_notices(sessions)
    registered = read_registered(study, sessions)
    sessions = [s for s in sessions if any(answered_trials(s.records))]
    definition = study.definition
    rated = RatedAnswers(definition)
    collected = [_SessionAnswers(one, definition, rated, notices) for one in sessions]
    trial_forces = {}
    for number, session in enumerate(sessions if progress else ()):
        assert progress is not None
        step = Message("reading records of {code}", code=session.code)
        progress(number / len(sessions), step)
        trial_forces[session.code] = measure_trial_forces(session, notices)
    figures = ranges_of_figures(definition, [r for c in collected for r in c.figures()])
    tracks = [one.valid_tracks() for one in collected]
    factors = (*rated.ranges, *figures)
    return Answers(
        participants=tuple(one.participant() for one in collected),
        ratings=tuple(
            r for one in collected for r in one.ratings() if r.factor in factors
        ),
        sequences=tuple(s.key for s in definition.sequences),
        feedbacks=definition.feedback_keys,
        factors=factors,
        open_answers=tuple(a for one in collected for a in one.open_answers()),
        judgements=tuple(j for one in collected for j in one.judgements()),
        repeated=sum(one.repeated for one in collected) * len(factors),
        courses=tuple(courses(study, tracks, notices)) if progress else (),
        notices=tuple(notices),
        conduct=conduct_of(definition, sessions, trial_forces),
        ranges={**rated.ranges, **figures},
        qoe=rated.qoe,
        items=rated.items,
        others=tuple(_others(definition, collected)),
        scores=tuple(collect_scores(definition, [one.numbers for one in collected])),
        registered=registered,
        trial=definition.trial,
        standard=definition.standard,
        staircase=definition.staircase,
        sequence_factors=definition.sequence_factors,
    )


def _others(
    definition: Definition, collected: Sequence["_SessionAnswers"]
) -> Iterator[AnswersTo]:
    """Yield the answers that are counted, in the order of the definition."""
    keys = {*RatedAnswers(definition).ranges}
    keys |= {key for page in definition.pages for key in PageScores(page).items}
    if definition.judgement is not None:
        keys.add(definition.judgement.key)
    language, feedbacks = definition.languages[0], definition.feedback_keys
    for when in When:
        for asked in definition.questions_at(when):
            if asked.key in keys or asked.kind is QuestionKind.TEXT:
                continue
            of_each = asked.for_each_feedback or when in OF_TRIALS
            for feedback in feedbacks if of_each else ("",):
                values = [v for one in collected for v in one.given(asked, feedback)]
                text = definition.wording(asked, language)
                yield AnswersTo(asked, text, feedback, tuple(values))


def _session_notices(sessions: list[StoredSession]) -> Iterator[str]:
    """Yield how many sessions are empty, unfinished or simulated."""
    answered = [s for s in sessions if any(answered_trials(s.records))]
    if empty := len(sessions) - len(answered):
        yield Message(
            "{empty} of {count} sessions have no answers",
            empty=empty,
            count=len(sessions),
        )
    if early := sum(s.state is not SessionState.COMPLETE for s in answered):
        yield Message(
            "{early} of {count} sessions have answers but were not completed",
            early=early,
            count=len(sessions),
        )
    if scripted := sum(one.is_simulated for one in sessions):
        yield Message(
            "{scripted} of {count} sessions are simulated",
            scripted=scripted,
            count=len(sessions),
        )


class _SessionAnswers:
    """Collects the answers of one session.

    Args:
        session: as stored.
        definition: the current one of the study, which gives names and order.
        rated: of that definition.
        notices: list to which a sentence is added for each trial that is left out.

    Attributes:
        repeated: number of trials that were answered again.
    """

    def __init__(
        self,
        session: StoredSession,
        definition: Definition,
        rated: RatedAnswers,
        notices: list[str],
    ) -> None:
        self._session, self._definition = session, definition
        self._rated, self._notices = rated, notices
        self._tracks = tracks_of(session, notices)
        self._values: dict[str, Any] = {}
        for page in session.definition.pages:
            if page.when not in OF_TRIALS:
                self._values |= page_values(session.records, page.key)
        self._trials: dict[Condition, AnsweredTrial] = {}
        self.repeated = 0
        known = set(definition.conditions)
        for trial in answered_trials(session.records):
            if trial.condition in known:
                before = self._trials.get(trial.condition)
                self.repeated += before is not None
                if before is None or trial.pages >= before.pages:
                    self._trials[trial.condition] = trial
            else:
                notices.append(
                    Message(
                        "session {code}: {key} was left out; it is not in the definition",
                        code=session.code,
                        key=trial.condition.key,
                    )
                )

    def participant(self) -> Participant:
        """Return the participant."""
        sheet = self._values
        return Participant(
            code=self._session.code,
            age=_of_type(sheet.get("age"), int),
            gender=_of_type(sheet.get("gender"), str),
            handedness=_of_type(sheet.get("handedness"), str),
            used_device_before=_of_type(sheet.get("used_device_before"), bool),
            complete=self._session.state is SessionState.COMPLETE,
            simulated=self._session.is_simulated,
            site=known_site(self._session.folder, self._notices),
            values=Scoring(self._definition, When.BEFORE, When.AFTER).completed(sheet),
        )

    def given(self, asked: Question, feedback: str) -> Iterator[Any]:
        """Yield the answers to a question, of the trials with a feedback if given."""
        name = f"{asked.key}@{feedback}" if asked.for_each_feedback else asked.key
        found = [self._values.get(name)]
        found += [
            trial.values.get(asked.key)
            for condition, trial in self._trials.items()
            if condition.feedback == feedback and trial.is_valid
        ]
        yield from (one for one in found if one is not None)

    def ratings(self) -> Iterator[Rating]:
        """Yield a rating for each condition and factor."""
        for condition in self._definition.conditions:
            trial = self._trials.get(condition)
            is_valid = trial.is_valid if trial else True
            numbers = self._rated.of(trial.values if trial else {})
            for key, value in {**numbers, **self._figures(trial)}.items():
                of = condition.sequence, condition.feedback, key
                yield Rating(self._session.code, *of, value, is_valid)

    def _figures(self, trial: AnsweredTrial | None) -> dict[str, float | None]:
        place = (trial.position, trial.attempt) if trial else (0, 0)
        return compared_figures(self._definition, self._tracks, *place)

    def figures(self) -> Iterator[dict[str, float | None]]:
        """Yield the ratings while the clip of each trial played."""
        yield from map(self._figures, self._trials.values())

    def valid_tracks(self) -> dict[Condition, dict[str, RatingTrack]]:
        """The ratings over time of trials that count, by condition and key."""
        return {
            condition: {
                key: track
                for (position, attempt, key), track in self._tracks.items()
                if (position, attempt) == (trial.position, trial.attempt)
            }
            for condition, trial in self._trials.items()
            if trial.is_valid
        }

    def numbers(self, page: PageScores, feedback: str) -> dict[str, float | None]:
        """What the answers to a page count as; after clips the mean of valid ones."""
        if not feedback:
            return page.numbers(self._values)
        rows = [
            page.numbers(trial.values)
            for condition, trial in self._trials.items()
            if condition.feedback == feedback and trial.is_valid
        ]
        found: dict[str, float | None] = {}
        for key in page.numbers({}):
            given = [one for row in rows if (one := row[key]) is not None]
            found[key] = sum(given) / len(given) if given else None
        return found

    def judgements(self) -> Iterator[Judgement]:
        """Yield a judgement for each condition."""
        if self._definition.judgement is None:
            return
        for condition in self._definition.conditions:
            trial = self._trials.get(condition)
            force = trial and compared(self._definition, trial)
            force = force or condition.level
            yield Judgement(
                self._session.code,
                condition.sequence,
                force.delay_s,
                force.gain,
                judged(self._definition, trial) if trial else None,
                trial.is_valid if trial else True,
                condition.feedback,
                trial.position if trial else 0,
            )

    def open_answers(self) -> Iterator[TextAnswer]:
        """Yield the text answers of all pages."""
        reviewed = read_reviewed(self._session.folder)
        code, asked = self._session.code, self._session.definition
        words = {
            q.key
            for page in asked.pages
            for q in page.questions
            if q.kind is QuestionKind.TEXT
        }
        for made in self._texts(words):
            is_approved = text_digest(code, made.name, made.text) in reviewed
            yield replace(made, reviewed=is_approved)

    def _texts(self, words: set[str]) -> Iterator[TextAnswer]:
        code = self._session.code
        for name, value in self._values.items():
            question, _, feedback = name.partition("@")
            if question in words and isinstance(value, str) and value.strip():
                yield TextAnswer(code, question, feedback, value, reviewed=False)
        for of, trial in self._trials.items():
            for question in words & trial.values.keys():
                value = trial.values[question]
                if isinstance(value, str) and value.strip():
                    place = of.sequence, trial.position
                    yield TextAnswer(code, question, of.feedback, value, False, *place)


def _of_type(value: Any, kind: Any) -> Any:
    """Return a value if it has the expected type (files can be edited), else None."""
    is_right = isinstance(value, kind) and isinstance(value, bool) == (kind is bool)
    return value if is_right else None
