"""The state machine of a participant's session, without a window.

Every answer and event is on the disk before the next page is shown. The front end shows
`page` and polls.
"""

import enum
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from hapticplayer import __version__
from hapticplayer.clock import Clock
from hapticplayer.errors import InputError, Message, StudyError, message_of
from hapticplayer.storage import StorageError
from hapticplayer.study.definition import Condition, LiveRating, QuestionPage
from hapticplayer.study.journal import Journal
from hapticplayer.study.pages import Page, PageKind, PageMaker, check_answers
from hapticplayer.study.plan import describe
from hapticplayer.study.session_folder import ANSWERS, SessionState
from hapticplayer.study.stage import PlaybackResult, TrialStage
from hapticplayer.study.steps import (
    BEFORE,
    CONSENT,
    DEMONSTRATION,
    INTERVAL,
    answered_pages,
    answered_trials,
    attempts_of,
    pages_before,
    pages_of,
    position_of,
    steps_done,
    steps_of,
)
from hapticplayer.study.streams import Markers, Observer
from hapticplayer.study.study_folder import Study, save_consent

if TYPE_CHECKING:
    from hapticplayer.study.watching import Watching

END = "end"


class StepMode(enum.Enum):
    """Activity within a step."""

    AT_PAGE = enum.auto()
    BETWEEN = enum.auto()  # before each of two plays
    PLAYING = enum.auto()
    SHOWING = enum.auto()  # the demonstration or a replay
    ASKING = enum.auto()
    PAUSED = enum.auto()
    PROBLEM = enum.auto()


_IN_TRIAL = (StepMode.BETWEEN, StepMode.PLAYING)
_BETWEEN_S = 1.0  # a page that says which of two clips comes
_NOTE_LENGTH = 100_000
"""Of one record; a longer note has several."""
_AT_STEP = {CONSENT: PageKind.CONSENT, DEMONSTRATION: PageKind.DEMONSTRATION}
_IN_MODE = {
    StepMode.BETWEEN: PageKind.INTERVAL,
    StepMode.PLAYING: PageKind.PLAYING,
    StepMode.SHOWING: PageKind.PLAYING,
    StepMode.ASKING: PageKind.QUESTIONS,
    StepMode.PAUSED: PageKind.PAUSED,
    StepMode.PROBLEM: PageKind.PROBLEM,
}


class SessionRunner:
    """Runs a session, from its first unanswered step.

    Args:
        study: of the session.
        code: of the participant.
        stage: where clips are played.
        clock: of the machine.
        observer: receives events.

    Raises:
        StudyError: when the session has ended, is locked or cannot be written.
    """

    def __init__(
        self,
        study: Study,
        code: str,
        stage: TrialStage,
        clock: Clock,
        observer: Observer | None = None,
    ) -> None:
        session = study.session(code)
        if session.state is not SessionState.UNFINISHED:
            raise StudyError(
                "session {code} is {state}",
                remedy="start a new session",
                code=session.code,
                state=Message(session.state.value),
            )
        self.plan, self.definition = session.plan, session.definition
        self.study, self.stage = study, stage
        self.problem = ""
        self.last_trial: PlaybackResult | None = None
        self.watching: Watching | None = None  # while a clip is rated
        self._rest, self._ended_s = "", float("-inf")  # of the last clip
        self._clock, self._conditions = clock, session.plan.order
        self._markers = Markers(observer, session.plan.order)
        self.minutes = self.definition.expected_min(stage.clip_s)
        self.maker = PageMaker(self.definition, self.plan, self.minutes)
        self._steps = steps_of(self.definition, len(self._conditions))
        self._folder = session.folder
        self._journal = Journal(self._folder / ANSWERS, clock)
        records = study.session(code).records  # as they are now that it is locked
        self._done = steps_done(records, self.definition)
        self._answered = answered_pages(records, ("answers", BEFORE))
        self._attempts = {s: attempts_of(records, s) for s in self._steps}
        self._again = ""
        self._mode, self._before_pause = StepMode.AT_PAGE, StepMode.AT_PAGE
        self._before_problem = StepMode.AT_PAGE
        self._pending: list[Callable[[], None]] = []
        self._presented: tuple[Condition, ...] = ()
        self._ended: list[PlaybackResult] = []  # plays of this attempt
        self._is_complete: bool | None = None
        self._number = 0
        self._shown_s = clock.now_s()
        self._open(is_resumed=any(r.kind == "begin" for r in records.intact))

    def _open(self, *, is_resumed: bool) -> None:
        try:
            record = self._journal.append(
                "resume" if is_resumed else "begin",
                program=f"hapticplayer {__version__}",
                step=self.step,
            )
        except StudyError:
            self._journal.close()
            raise
        self._markers.record(record)
        of, pages = (self.step, self.attempt), pages_of(self.definition, self.step)
        if any((*of, page.key) in self._answered for page in pages):
            self._ask()  # the pages that are left, without the clip
        else:
            self._enter()

    # --- state ----------------------------------------------------------------

    @property
    def step(self) -> str:
        """Name of the current step; "end" after the last."""
        if self._is_complete is not None:
            return END
        left = (step for step in self._steps if step not in self._done)
        return self._again or next(left, END)

    @property
    def is_over(self) -> bool:
        return self._is_complete is not None

    @property
    def condition(self) -> Condition | None:
        """Condition of the current trial; None on other pages."""
        position = position_of(self.step)
        return self._conditions[position - 1] if position else None

    @property
    def attempt(self) -> int:
        """Number of the current or last attempt at the current trial."""
        return self._attempts.get(self.step, 0)

    @property
    def gap_s(self) -> float:
        """Time until the next clip may begin."""
        since_s = self._clock.now_s() - self._ended_s
        return max(0.0, self.definition.gap_s - since_s)

    @property
    def page(self) -> Page:
        of = self.step, self._number, self._asking, len(self._ended) + 1
        made = self.maker.page(self._kind(), *of)
        is_rest = self._rest and made.kind is PageKind.PAUSED
        return replace(made, text=self._rest) if is_rest else made

    @property
    def _asking(self) -> QuestionPage | None:
        """The page of questions of this step that is to be answered next."""
        pages_at = pages_before if self._is_before_clip else pages_of
        of = self.step, self.attempt + self._is_before_clip
        pages = pages_at(self.definition, self.step)
        return next((p for p in pages if (*of, p.key) not in self._answered), None)

    @property
    def _is_before_clip(self) -> bool:
        """Whether the clip of this step is still to be started."""
        return self.condition is not None and self._mode is StepMode.AT_PAGE

    def _kind(self) -> PageKind:
        if self._mode is StepMode.AT_PAGE:
            if self._is_complete is not None:
                return PageKind.THANKS if self._is_complete else PageKind.STOPPED
            is_ready = self.condition is not None and self._asking is None
            other = PageKind.READY if is_ready else PageKind.QUESTIONS
            return _AT_STEP.get(self.step, other)
        return _IN_MODE[self._mode]

    # --- actions of the participant ----------------------------------------------

    def consent(self, *, given: bool) -> None:
        """Store the decision; a refusal ends the session."""
        self._expect(PageKind.CONSENT)
        try:
            save_consent(
                self.study,
                self.plan.code,
                given=given,
                text=self.maker.text("consent"),
                language=self.plan.language,
            )
        except StorageError as problem:
            self._fail(problem, lambda: self.consent(given=given))
            return
        if given:
            self._pass_step()
        else:
            self._end(is_complete=False, reason="consent refused", by="participant")

    def answer(self, values: Mapping[str, Any]) -> None:
        """Store the answers of a page and continue.

        Raises:
            StudyError: for an answer that is missing or not allowed; nothing is stored and
                the page stays.
        """
        page, of, kind = self._expect(PageKind.QUESTIONS), self._step_name(), "answers"
        if self._is_before_clip:
            of, kind = of | {"attempt": self.attempt + 1}, BEFORE

        def answered() -> None:
            self._answered.add((self.step, of.get("attempt", 0), page.key))
            if kind == BEFORE:
                self._next_page()
            else:
                (self._ask if self._asking else self._complete_step)()

        self._store(
            kind,
            answered,
            **of,
            page=page.key,
            values=check_answers(page.questions, values),
            response_s=round(self._page_s, 3),
        )

    def proceed(self) -> None:
        """Start the trial, leave the page or end the pause."""
        if self._mode is StepMode.PAUSED:
            self.resume("participant")
        elif self.step == DEMONSTRATION:
            self._expect(PageKind.DEMONSTRATION)
            self._pass_step()
        else:
            self._expect(PageKind.READY)
            self.stage.check()
            if self.gap_s or self._is_held():
                return
            self._markers.check()
            self._attempts[self.step] += 1
            self._ended = []
            begin = self._announce if len(self._presented) > 1 else self._play
            self._store("trial-begin", begin, **self._step_name())

    def demonstrate(self) -> None:
        """Play the demonstration of the device."""
        self._expect(PageKind.DEMONSTRATION)
        if self._is_held():
            return
        self.stage.prepare_demonstration()
        self._store("demonstration", self._show)

    def replay(self, token: str) -> None:
        """Play a clip with one of the feedbacks again; see `Page.replays`."""
        self._expect(PageKind.QUESTIONS)
        if self._is_held():
            return
        number, _, place = token.partition(".")
        feedback = self.plan.labels[int(number) - 1]
        sequence = self.definition.sequences[int(place) - 1].key
        self.stage.prepare(Condition(sequence, feedback))
        self._store("replay", self._show, sequence=sequence, feedback=feedback)

    def halt(self, reason: str) -> None:
        """Stop the force at once, until `resume`.

        An interrupted trial has to be started again.
        """
        self.stage.halt()
        self._leave_clip(reason)

    def _leave_clip(self, reason: str) -> None:
        if self.is_over or self._mode in (StepMode.PAUSED, StepMode.PROBLEM):
            return
        if self._mode in _IN_TRIAL:
            self._finish_trial(lambda: self._pause(reason), reason)
        else:
            self._pause(reason)

    def leave(self) -> None:
        """End the session early; the answers so far are kept."""
        self.stop("left", by="participant")

    # --- actions of the operator -------------------------------------------------

    def pause(self) -> None:
        self.halt("paused")

    def resume(self, by: str = "operator") -> None:
        """Continue after a pause: a person re-arms the force."""
        if self._mode is StepMode.PAUSED:
            self.stage.rearm()
            self._store("go-on", self._after_pause, by=by)

    def repeat(self) -> None:
        """Repeat the current trial, or the last one if it has not started yet."""
        if self.is_over or self._mode is StepMode.PROBLEM:
            return
        if not (step := self._trial_to_repeat()):
            return
        if self._mode in _IN_TRIAL:
            self._interrupt("repeated")

        def again() -> None:
            self._again = step
            self._enter()

        self._store("repeat", again, step=step)

    def _interrupt(self, reason: str) -> None:
        self.stage.interrupt()
        self._leave_clip(reason)

    def _trial_to_repeat(self) -> str:
        if self._mode in (*_IN_TRIAL, StepMode.ASKING):
            return self.step
        played = [s for s in self._steps if position_of(s) and self._attempts[s]]
        return self.step if self.step in played else (played[-1] if played else "")

    def skip(self, reason: str) -> None:
        """Skip the current step, except consent."""
        if self.is_over or self.step == CONSENT or self._mode is StepMode.PROBLEM:
            return
        if not reason.strip():
            raise StudyError("skipping a step needs a reason")
        if self._mode in (*_IN_TRIAL, StepMode.SHOWING):
            self._interrupt("skipped")
        self._store("skip", self._complete_step, step=self.step, reason=reason.strip())

    def stop(self, reason: str, by: str = "operator") -> None:
        """End the session; the answers so far are kept.

        If that cannot be written, the session can be resumed.
        """
        self.retry()
        self.halt("stopped")
        if not self.is_over and self._mode is not StepMode.PROBLEM:
            self._end(is_complete=False, reason=reason, by=by)

    def note(self, text: str) -> None:
        whole = text.strip()
        for begin in range(0, 0 if self.is_over else len(whole), _NOTE_LENGTH):
            part = whole[begin : begin + _NOTE_LENGTH]
            self._store("note", lambda: None, text=part)

    def store_checks(self, checks: list[dict[str, Any]], *, overridden: bool) -> None:
        """Store the checks before the first trial."""
        self._store("checks", lambda: None, checks=checks, overridden=overridden)

    def retry(self) -> None:
        """Retry what could not be stored."""
        if self._pending:
            pending, self._pending = self._pending, []
            self.problem, self._mode = "", self._before_problem
            for store in pending:
                store()

    def close(self) -> None:
        """Close the journal; a session without an end can be resumed."""
        if self.watching is not None:
            self.watching.finish()
        self._journal.close()

    # --- polling and storing -------------------------------------------------------

    def poll(self) -> None:
        """Check whether a clip has ended."""
        if self._mode is StepMode.PLAYING:
            self._markers.first_frame(self.step, self.stage.first_frame_s)
        is_playing = self._mode in (*_IN_TRIAL, StepMode.SHOWING)
        if is_playing and self.stage.is_stopped:
            self.halt("force_stopped")
        elif self.watching is not None and (limit := self.watching.limit):
            self._rest_after(limit)
        elif self._mode is StepMode.PLAYING and self.stage.is_over():
            if len(self._ended) + 1 < len(self._presented):
                self._finish_trial(self._announce, kind=INTERVAL)
            else:
                self._finish_trial(self._ask)
        elif self._mode is StepMode.BETWEEN and self._page_s >= _BETWEEN_S:
            self._play()
        elif self._mode is StepMode.SHOWING and self.stage.is_over():
            self._enter()

    def _rest_after(self, limit: LiveRating) -> None:
        """End the clip at a rating that is too large, and offer a break."""

        def rest() -> None:
            self._mode = StepMode.ASKING
            self._rest = limit.rest[self.plan.language] if limit.rest else ""
            self._pause(f"limit:{limit.key}")

        self.stage.halt()
        self._finish_trial(rest)

    def _expect(self, kind: PageKind) -> Page:
        page = self.page
        if page.kind is not kind:
            raise StudyError(
                "the current page is {page}, not {expected}",
                page=page.kind.value,
                expected=kind.value,
            )
        return page

    def _store(self, kind: str, then: Callable[[], None], **content: Any) -> None:
        """Store a record, then continue."""
        try:
            record = self._journal.append(kind, **content)
        except StudyError as problem:
            self._fail(problem, lambda: self._store(kind, then, **content))
        else:
            self._markers.record(record)
            then()

    def _fail(self, problem: InputError, again: Callable[[], None]) -> None:
        """Show the problem until the operator has retried; nothing plays meanwhile."""
        self.stage.interrupt()
        self.problem = message_of(problem)
        self._pending.append(again)
        if self._mode is not StepMode.PROBLEM:
            self._before_problem, self._mode = self._mode, StepMode.PROBLEM
            self._next_page()

    def _enter(self) -> None:
        """Show the first page of the current step."""
        self._mode = StepMode.AT_PAGE
        if self.step == END and self._is_complete is None:
            self._end(is_complete=True, reason="", by="")
            return
        if self.condition is not None:
            self._presented = self._to_present(self.condition)
            self.stage.prepare(self._presented[0])
        self._markers.mark(f"{self.step} page", self._clock.now_s())
        self._next_page()

    def _is_held(self) -> bool:
        """Pause before a clip while the force is stopped; True if so."""
        if self.stage.is_stopped:
            self._pause("force_stopped")
        return self.stage.is_stopped

    @property
    def _page_s(self) -> float:
        """How long the page has been shown."""
        return self._clock.now_s() - self._shown_s

    def _next_page(self) -> None:
        self._number += 1
        self._shown_s = self._clock.now_s()

    def _step_name(self) -> dict[str, Any]:
        """What a record belongs to: a step, and a trial's attempt and condition."""
        if self.condition is None:
            return {"step": self.step}
        of = {"attempt": self.attempt, "condition": describe(self.condition)}
        return {"step": self.step, **of}

    def _play(self) -> None:
        self._mode = StepMode.PLAYING
        self.stage.begin()
        if self.definition.while_watching:
            from hapticplayer.study.watching import Watching

            trial, at = (position_of(self.step) or 0, self.attempt), self.stage.media_s
            ratings, folder = self.definition.while_watching, self._folder
            self.watching = Watching(ratings, folder, trial, self._clock, at)
        self._next_page()

    def _show(self) -> None:
        self._mode = StepMode.SHOWING
        self.stage.begin()
        self._next_page()

    def _to_present(self, condition: Condition) -> tuple[Condition, ...]:
        """What the coming attempt plays."""
        if self.definition.standard is None:
            return (condition,)
        from hapticplayer.study.intervals import presented  # few studies have it

        trials = answered_trials(self.study.session(self.plan.code).records)
        of = position_of(self.step) or 0, self.attempt + 1
        return presented(self.definition, self.plan, *of, trials)

    def _announce(self) -> None:
        """Say which of two clips comes, and load it."""
        self._mode = StepMode.BETWEEN
        self.stage.prepare(self._presented[len(self._ended)])
        self._next_page()

    def _finish_trial(
        self, then: Callable[[], None], *reasons: str, kind: str = "trial"
    ) -> None:
        """Store what was played; the last play of two has the reasons of both."""
        played = PlaybackResult(False, reasons, {})
        if self._mode is StepMode.PLAYING:
            rated = self.watching.finish() if self.watching else ()
            self.watching, self._ended_s = None, self._clock.now_s()
            played = self.stage.played(*reasons, *rated)
            self._markers.first_frame(self.step, self.stage.first_frame_s)
        self._ended.append(played)
        ended = self._ended if kind == "trial" else [played]
        found = tuple(dict.fromkeys(one for part in ended for one in part.reasons))
        self.last_trial = PlaybackResult(not found, found, played.playback)
        forces = [describe(one.level) for one in self._presented]
        self._store(
            kind,
            then,
            **self._step_name(),
            is_valid=not found,
            reasons=list(found),
            playback=dict(played.playback),
            **({"presented": forces} if len(forces) > 1 else {}),
        )

    def _ask(self) -> None:
        self._mode = StepMode.ASKING
        self._markers.mark(f"{self.step} questions", self._clock.now_s())
        self._next_page()

    def _pause(self, reason: str) -> None:
        self._before_pause = self._mode
        self._mode = StepMode.PAUSED
        self._next_page()
        self._store("pause", lambda: None, step=self.step, reason=reason)

    def _after_pause(self) -> None:
        """Return to the questions, or to the start of the trial."""
        self._rest = ""
        if self._before_pause is StepMode.ASKING:
            self._ask()
        else:
            self._enter()

    def _pass_step(self) -> None:
        self._store("passed", self._complete_step, step=self.step)

    def _complete_step(self) -> None:
        self._done.add(self.step)
        self._again = ""
        self._enter()

    def _end(self, *, is_complete: bool, reason: str, by: str) -> None:
        def ended() -> None:
            self._is_complete = is_complete
            self._mode = StepMode.AT_PAGE
            self._next_page()

        self._store("end", ended, complete=is_complete, reason=reason, by=by)
