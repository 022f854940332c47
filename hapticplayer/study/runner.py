"""One participant's session as a state machine, without a window.

Whatever was answered or happened is on the disk before the next page is there. The
front end shows `page` and polls; nobody else decides what comes next.
"""

import enum
from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.clock import Clock
from hapticplayer.errors import Message, StudyError, message_of
from hapticplayer.study.definition import Condition
from hapticplayer.study.journal import Journal
from hapticplayer.study.pages import Page, PageKind, PageMaker, check_answers
from hapticplayer.study.plan import describe
from hapticplayer.study.session_folder import ANSWERS, SessionState
from hapticplayer.study.stage import PlaybackResult, TrialStage
from hapticplayer.study.steps import (
    CONSENT,
    DEMONSTRATION,
    POST_TEST,
    SHEET,
    attempts_of,
    position_of,
    steps_done,
    steps_of,
)
from hapticplayer.study.study_folder import Study, save_consent

END = "end"


class StepMode(enum.Enum):
    """What is going on at a step."""

    AT_PAGE = enum.auto()
    PLAYING = enum.auto()
    SHOWING = enum.auto()  # the demonstration, or a clip once more
    ASKING = enum.auto()
    PAUSED = enum.auto()
    PROBLEM = enum.auto()


_AT_STEP = {
    CONSENT: PageKind.CONSENT,
    SHEET: PageKind.QUESTIONS,
    DEMONSTRATION: PageKind.DEMONSTRATION,
    POST_TEST: PageKind.QUESTIONS,
}
_IN_MODE = {
    StepMode.PLAYING: PageKind.PLAYING,
    StepMode.SHOWING: PageKind.PLAYING,
    StepMode.ASKING: PageKind.QUESTIONS,
    StepMode.PAUSED: PageKind.PAUSED,
    StepMode.PROBLEM: PageKind.PROBLEM,
}


class Observer(Protocol):
    """Told of what happens, for other programs: no answers, no codes."""

    def marker(self, text: str, monotonic_s: float) -> None:
        """Note that something happened."""
        ...

    def force(
        self, monotonic_s: NDArray[np.float64], force_n: NDArray[np.float32]
    ) -> None:
        """Note forces (N, 3) that were sent to the device, with their times (N,), s."""
        ...


class SessionRunner:
    """Runs one session, from where it stands.

    Args:
        study: of the session.
        code: of the participant.
        stage: where clips are played.
        clock: of the machine.
        observer: told of beginnings and ends.

    Raises:
        StudyError: when the session is over, open elsewhere or cannot be written.
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
                remedy="begin a new one",
                code=session.code,
                state=Message(session.state.value),
            )
        self.plan, self.definition = session.plan, session.definition
        self.study, self.stage = study, stage
        self.problem = ""
        self.last_trial: PlaybackResult | None = None
        self._clock, self._observer = clock, observer
        self._conditions = session.plan.order
        self.maker = PageMaker(self.definition, self.plan)
        self._steps = steps_of(self.definition, len(self._conditions))
        self._journal = Journal(session.folder / ANSWERS, clock)
        records = self._journal.found
        self._done = steps_done(records)
        self._attempts = {s: attempts_of(records, s) for s in self._steps}
        self._again = ""
        self._mode, self._before_pause = StepMode.AT_PAGE, StepMode.AT_PAGE
        self._before_problem = StepMode.AT_PAGE
        self._pending: Callable[[], None] | None = None
        self._is_complete: bool | None = None
        self._number = 0
        self._shown_s = clock.now_s()
        self._open(is_resumed=any(r.kind == "begin" for r in records.intact))

    def _open(self, *, is_resumed: bool) -> None:
        try:
            self._journal.append(
                "resume" if is_resumed else "begin",
                program=f"hapticplayer {__version__}",
                step=self.step,
            )
        except StudyError:
            self._journal.close()
            raise
        self._enter()

    # --- where we are ----------------------------------------------------------

    @property
    def step(self) -> str:
        """Name of the present step; "end" after the last."""
        if self._is_complete is not None:
            return END
        left = (step for step in self._steps if step not in self._done)
        return self._again or next(left, END)

    @property
    def is_over(self) -> bool:
        """Whether there is nothing more to do."""
        return self._is_complete is not None

    @property
    def condition(self) -> Condition | None:
        """What the present trial plays; None on other pages."""
        position = position_of(self.step)
        return self._conditions[position - 1] if position else None

    @property
    def trials(self) -> int:
        """How many trials there are."""
        return len(self._conditions)

    @property
    def attempt(self) -> int:
        """Which attempt at the present trial is running or was the last."""
        return self._attempts.get(self.step, 0)

    @property
    def page(self) -> Page:
        """What the participant is to see now."""
        return self.maker.page(self._kind(), self.step, self._number)

    def _kind(self) -> PageKind:
        if self._mode is StepMode.AT_PAGE:
            if self._is_complete is not None:
                return PageKind.THANKS if self._is_complete else PageKind.STOPPED
            return _AT_STEP.get(self.step, PageKind.READY)
        return _IN_MODE[self._mode]

    # --- what the participant does -----------------------------------------------

    def consent(self, *, given: bool) -> None:
        """Keep the decision; a refusal ends the session."""
        self._expect(PageKind.CONSENT)
        try:
            save_consent(
                self.study,
                self.plan.code,
                given=given,
                text=self.maker.text("consent"),
                language=self.plan.language,
            )
        except StudyError as problem:
            self._fail(problem, lambda: self.consent(given=given))
            return
        if given:
            self._pass_step()
        else:
            self._end(is_complete=False, reason="consent refused", by="participant")

    def answer(self, values: Mapping[str, Any]) -> None:
        """Keep the answers of a page and go on.

        Raises:
            StudyError: for an answer that is missing or impossible; nothing is kept
                then, and the page stays.
        """
        page = self._expect(PageKind.QUESTIONS)
        checked = check_answers(page.questions, values)
        content: dict[str, Any] = {
            "step": self.step,
            "values": checked,
            "response_s": round(self._clock.now_s() - self._shown_s, 3),
        }
        if self.condition is not None:
            content["attempt"] = self.attempt
            content["condition"] = describe(self.condition)
        self._keep("answers", self._complete_step, **content)

    def go_on(self) -> None:
        """Press the one button of a page: start a trial, pass a page, end a pause."""
        if self._mode is StepMode.PAUSED:
            self.resume("participant")
        elif self.step == DEMONSTRATION:
            self._expect(PageKind.DEMONSTRATION)
            self._pass_step()
        else:
            self._expect(PageKind.READY)
            self._attempts[self.step] += 1
            self._keep("trial-begin", self._play, **self._trial_name())

    def feel(self) -> None:
        """Play the demonstration of the device."""
        self._expect(PageKind.DEMONSTRATION)
        self.stage.prepare_demonstration()
        self._keep("demonstration", self._show)

    def replay(self, token: str) -> None:
        """Play a clip with one of the feedbacks once more; see `Page.replays`."""
        self._expect(PageKind.QUESTIONS)
        number, _, place = token.partition(".")
        feedback = self.plan.labels[int(number) - 1]
        sequence = self.definition.sequences[int(place) - 1].key
        self.stage.prepare(Condition(sequence, feedback))
        self._keep("replay", self._show, sequence=sequence, feedback=feedback)

    def halt(self, reason: str) -> None:
        """Take the force away at once; an interrupted trial has to be begun again."""
        self.stage.halt()
        if self.is_over or self._mode in (StepMode.PAUSED, StepMode.PROBLEM):
            return
        if self._mode is StepMode.PLAYING:
            self._finish_trial(lambda: self._pause(reason), reason)
        else:
            self._pause(reason)

    def leave(self) -> None:
        """Stop taking part; the answers given so far are kept."""
        self.stop("left", by="participant")

    # --- what the operator does --------------------------------------------------

    def pause(self) -> None:
        """Let the participant rest."""
        self.halt("paused")

    def resume(self, by: str = "operator") -> None:
        """Go on after a pause."""
        if self._mode is StepMode.PAUSED:
            self.stage.rearm()
            self._keep("go-on", self._after_pause, by=by)

    def repeat(self) -> None:
        """Play the present trial again, or the last one where none has begun yet."""
        if self.is_over or self._mode is StepMode.PROBLEM:
            return
        step = self._trial_to_repeat()
        if not step:
            return
        if self._mode is StepMode.PLAYING:
            self.halt("repeated")
        self.stage.rearm()

        def again() -> None:
            self._again = step
            self._enter()

        self._keep("repeat", again, step=step)

    def _trial_to_repeat(self) -> str:
        if self._mode in (StepMode.PLAYING, StepMode.ASKING):
            return self.step
        played = [s for s in self._steps if position_of(s) and self._attempts[s]]
        return self.step if self.step in played else (played[-1] if played else "")

    def skip(self, reason: str) -> None:
        """Leave the present step out; consent cannot be."""
        if self.is_over or self.step == CONSENT or self._mode is StepMode.PROBLEM:
            return
        if not reason.strip():
            raise StudyError("a step is skipped only with a reason")
        if self._mode in (StepMode.PLAYING, StepMode.SHOWING):
            self.halt("skipped")
        self.stage.rearm()
        self._keep("skip", self._complete_step, step=self.step, reason=reason.strip())

    def stop(self, reason: str, by: str = "operator") -> None:
        """End the session for good; the answers given so far are kept.

        Where nothing can be written it stays without an end, and can be resumed.
        """
        self.retry()
        self.halt("stopped")
        if not self.is_over and self._mode is not StepMode.PROBLEM:
            self._end(is_complete=False, reason=reason, by=by)

    def note(self, text: str) -> None:
        """Keep a remark of the operator."""
        if text.strip() and not self.is_over:
            self._keep("note", lambda: None, text=text.strip())

    def keep_checks(self, checks: list[dict[str, Any]], *, overridden: bool) -> None:
        """Keep what was looked at before the first trial."""
        self._keep("checks", lambda: None, checks=checks, overridden=overridden)

    def retry(self) -> None:
        """Try to keep what could not be kept, once the reason is gone."""
        if self._pending is not None:
            pending, self._pending = self._pending, None
            self.problem, self._mode = "", self._before_problem
            self.stage.rearm()
            pending()

    def close(self) -> None:
        """Let go of the session; one that has no end can be resumed."""
        self._journal.close()

    # --- what happens by itself ----------------------------------------------------

    def poll(self) -> None:
        """Look whether a clip has ended."""
        if self._mode is StepMode.PLAYING and self.stage.is_over():
            self._finish_trial(self._ask)
        elif self._mode is StepMode.SHOWING and self.stage.is_over():
            self._enter()

    def _expect(self, kind: PageKind) -> Page:
        page = self.page
        if page.kind is not kind:
            raise StudyError(
                "this is the page {page}, not {expected}",
                page=page.kind.value,
                expected=kind.value,
            )
        return page

    def _keep(self, kind: str, then: Callable[[], None], **content: Any) -> None:
        """Keep a record, and only then do what follows."""
        try:
            self._journal.append(kind, **content)
        except StudyError as problem:
            self._fail(problem, lambda: self._keep(kind, then, **content))
        else:
            then()

    def _fail(self, problem: StudyError, again: Callable[[], None]) -> None:
        """Stop the participant with a message until an operator has helped."""
        self.stage.halt()
        self.problem = message_of(problem)
        if self._mode is StepMode.PROBLEM and self._pending is not None:
            self._pending = _both(self._pending, again)
            return
        self._pending = again
        self._before_problem, self._mode = self._mode, StepMode.PROBLEM
        self._turn_page()

    def _enter(self) -> None:
        """Come to the first page of the present step."""
        self._mode = StepMode.AT_PAGE
        if self.step == END and self._is_complete is None:
            self._end(is_complete=True, reason="", by="")
            return
        if self.condition is not None:
            self.stage.prepare(self.condition)
        self._mark(f"{self.step} page")
        self._turn_page()

    def _turn_page(self) -> None:
        self._number += 1
        self._shown_s = self._clock.now_s()

    def _trial_name(self) -> dict[str, Any]:
        assert self.condition is not None
        return {
            "step": self.step,
            "attempt": self.attempt,
            "condition": describe(self.condition),
        }

    def _play(self) -> None:
        self._mode = StepMode.PLAYING
        self.stage.begin()
        assert self.condition is not None
        self._mark(f"{self.step} begin {self.condition.key}")
        self._turn_page()

    def _show(self) -> None:
        self._mode = StepMode.SHOWING
        self.stage.begin()
        self._turn_page()

    def _finish_trial(self, then: Callable[[], None], *reasons: str) -> None:
        played = self.last_trial = self.stage.played(*reasons)
        self._mark(f"{self.step} end")
        self._keep(
            "trial",
            then,
            **self._trial_name(),
            sound=played.sound,
            reasons=list(played.reasons),
            playback=dict(played.playback),
        )

    def _ask(self) -> None:
        self._mode = StepMode.ASKING
        self._mark(f"{self.step} questions")
        self._turn_page()

    def _pause(self, reason: str) -> None:
        self._before_pause = self._mode
        self._mode = StepMode.PAUSED
        self._turn_page()
        self._keep("pause", lambda: None, step=self.step, reason=reason)

    def _after_pause(self) -> None:
        """Come back to the questions, or to where a clip can be begun again."""
        if self._before_pause is StepMode.ASKING:
            self._ask()
        else:
            self._enter()

    def _pass_step(self) -> None:
        self._keep("passed", self._complete_step, step=self.step)

    def _complete_step(self) -> None:
        self._done.add(self.step)
        self._again = ""
        self._enter()

    def _end(self, *, is_complete: bool, reason: str, by: str) -> None:
        def ended() -> None:
            self._is_complete = is_complete
            self._mode = StepMode.AT_PAGE
            self._mark("session end")
            self._turn_page()

        self._keep("end", ended, complete=is_complete, reason=reason, by=by)

    def _mark(self, text: str) -> None:
        if self._observer is not None:
            self._observer.marker(text, self._clock.now_s())


def _both(first: Callable[[], None], second: Callable[[], None]) -> Callable[[], None]:
    def call() -> None:
        first()
        second()

    return call
