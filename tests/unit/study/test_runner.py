"""A session from consent to thanks, interrupted in every way, on a virtual clock."""

import errno
import os
from collections import defaultdict

import pytest

from hapticplayer.errors import StudyError
from hapticplayer.study import journal as journals
from hapticplayer.study.answers import read_answers
from hapticplayer.study.definition import Condition
from hapticplayer.study.journal import read_journal
from hapticplayer.study.pages import PageKind
from hapticplayer.study.runner import SessionRunner
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.stage import PlaybackResult
from hapticplayer.study.study_data import markers_of
from hapticplayer.study.study_folder import begin_session
from tests.unit.study.conftest import SHEET, VALUES


class FakeStage:
    """Plays nothing, and ends when it is reported to."""

    def __init__(self):
        self.prepared = []
        self.playing = False
        self.ended = False
        self.halts = self.interrupts = 0
        self.is_stopped = False
        self.reasons, self.figures = (), {}
        self.clock, self.first_frame_s = None, None
        self.clip_s = defaultdict(lambda: 10.0)

    def check(self):
        """Everything is there."""

    def prepare(self, condition: Condition):
        self.prepared.append(condition)

    def prepare_demonstration(self):
        self.prepared.append("demonstration")

    def begin(self):
        assert not self.is_stopped
        self.first_frame_s = round(self.clock.now_s() + 0.012, 6)
        self.playing, self.ended = True, False

    def media_s(self, monotonic_s):
        since_s = monotonic_s - self.first_frame_s
        return since_s if self.playing and since_s >= 0.0 else None

    def is_over(self):
        return self.ended

    def played(self, *reasons):
        found = (*reasons, *self.reasons)
        figures = {"frames_shown": 50, "first_frame_mono_s": self.first_frame_s}
        return PlaybackResult(not found, found, {**figures, **self.figures})

    def halt(self):
        self.halts += 1
        self.playing, self.is_stopped = False, True

    def interrupt(self):
        self.interrupts += 1
        self.playing = False

    def rearm(self):
        self.is_stopped = False


class Heard:
    """An observer that keeps what it is told."""

    def __init__(self):
        self.markers, self.problem = [], ""

    def marker(self, text, monotonic_s):
        self.markers.append((text, monotonic_s))

    def check(self):
        if self.problem:
            raise StudyError(self.problem)


class RunningSession:
    """A participant and an operator in front of a runner."""

    def __init__(self, study, clock, code=None):
        self.study, self.clock, self.stage = study, clock, FakeStage()
        self.heard = Heard()
        self.stage.clock = clock
        self.code = code or begin_session(study, "en", {}, clock).code
        self.runner = SessionRunner(study, self.code, self.stage, clock, self.heard)

    @property
    def kind(self):
        return self.runner.page.kind

    def to_demonstration(self):
        self.runner.consent(given=True)
        self.runner.answer(SHEET)

    def to_trials(self):
        self.to_demonstration()
        self.runner.proceed()

    def end_clip(self):
        self.stage.ended = True
        self.runner.poll()

    def play(self):
        self.clock.advance(self.runner.gap_s)
        self.runner.proceed()
        assert self.kind is PageKind.PLAYING
        self.clock.advance(60.0)
        self.end_clip()

    def trial(self, **values):
        self.play()
        self.clock.advance(7.0)
        self.runner.answer({**VALUES, **values})

    def records(self):
        return read_journal(self.study.session_folder(self.code) / "answers.jsonl")

    def contents(self, kind):
        return [one.content for one in self.records().intact if one.kind == kind]

    def again(self):
        """Crash, and open the session again."""
        self.runner.close()
        return RunningSession(self.study, self.clock, self.code)


@pytest.fixture
def running(study, manual_clock):
    made = RunningSession(study, manual_clock)
    yield made
    made.runner.close()


def no_room(*_args):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def kinds(running):
    return [record.kind for record in running.records().intact]


def test_a_whole_session_goes_from_consent_to_thanks(running):
    seen = [running.kind]
    running.to_trials()
    for position in range(1, 13):
        page = running.runner.page
        assert (page.kind, page.position, page.count) == (PageKind.READY, position, 12)
        running.trial()
    seen.append(running.kind)
    page = running.runner.page
    assert [q.name for q in page.questions if "@" in q.name] == [
        f"label@{name}" for name in running.runner.plan.labels
    ]
    headings = ["Feedback 1", "Feedback 2", "Feedback 3"]
    assert [q.heading for q in page.questions if q.heading] == headings
    running.runner.answer({"tiring": "no"})
    assert seen == [PageKind.CONSENT, PageKind.QUESTIONS]
    assert running.kind is PageKind.THANKS
    assert running.runner.is_over
    session = running.study.session(running.code)
    assert session.state is SessionState.COMPLETE
    assert not session.records.damaged
    played = running.stage.prepared
    assert played == list(session.plan.order)
    assert {r.value for r in read_answers(running.study.folder).ratings} == {1, 2, 3, 5}


def test_pages_tell_neither_condition_nor_file(running):
    running.to_trials()
    reported = []
    for _ in range(12):
        reported.append(repr(running.runner.page))
        running.play()
        reported.append(repr(running.runner.page))
        running.runner.answer(VALUES)
    for secret in ("bike", "horse", "car-", "realistic", "random", "none", "/"):
        assert not any(secret in text for text in reported), secret


def test_an_answer_is_on_the_disk_before_the_next_page(running, monkeypatch):
    running.to_trials()
    running.play()
    number, seen = running.runner.page.number, []
    real = journals.os.fsync

    def fsync(descriptor):
        seen.append(running.runner.page.number)
        real(descriptor)

    monkeypatch.setattr(journals.os, "fsync", fsync)
    running.runner.answer(VALUES)
    assert seen == [number]
    assert running.runner.page.number > number


@pytest.mark.parametrize(
    "values",
    [
        {},
        {**VALUES, "realism": 0},
        {**VALUES, "realism": 6},
        {**VALUES, "realism": True},
        {**VALUES, "realism": "3"},
        {**VALUES, "mood": 3},
    ],
)
def test_an_invalid_answer_is_refused_and_not_kept(running, values):
    running.to_trials()
    running.play()
    before = running.records()
    with pytest.raises(StudyError):
        running.runner.answer(values)
    assert running.records() == before
    assert running.kind is PageKind.QUESTIONS


def test_refused_consent_ends_the_session_without_answers(running):
    running.runner.consent(given=False)
    assert running.kind is PageKind.STOPPED
    assert kinds(running) == ["plan", "begin", "end"]
    assert read_answers(running.study.folder).participants == ()


def test_how_long_an_answer_took_is_kept(running):
    running.to_trials()
    running.trial()
    last = running.contents("answers")[-1]
    assert (last["response_s"], last["attempt"]) == (pytest.approx(7.0), 1)


def test_pausing_a_clip_makes_it_begin_again(running):
    running.to_trials()
    running.runner.proceed()
    running.runner.pause()
    assert running.kind is PageKind.PAUSED
    assert running.stage.is_stopped
    running.runner.resume()
    assert not running.stage.is_stopped
    assert running.kind is PageKind.READY
    assert running.runner.page.position == 1
    running.trial()
    trials = running.contents("trial")
    assert [(t["attempt"], t["is_valid"], t["reasons"]) for t in trials] == [
        (1, False, ["paused"]),
        (2, True, []),
    ]


def test_a_repeated_trial_counts_with_its_last_answers(running):
    running.to_trials()
    running.stage.reasons = ("frames_dropped",)
    running.trial(realism=1)
    assert running.runner.last_trial.reasons == ("frames_dropped",)
    running.stage.reasons = ()
    running.runner.repeat()
    assert running.runner.page.position == 1
    running.trial(realism=5)
    assert running.runner.page.position == 2
    ratings = read_answers(running.study.folder).ratings
    realism = [r for r in ratings if r.factor == "realism" and r.value is not None]
    assert [(r.value, r.is_valid) for r in realism] == [(5, True)]


def test_a_trial_that_was_not_valid_is_marked(running):
    running.to_trials()
    running.stage.reasons = ("sync:sound",)
    running.trial()
    ratings = read_answers(running.study.folder).ratings
    assert sum(not r.is_valid for r in ratings) == 4


def test_skipping_needs_a_reason_and_leaves_the_rating_missing(running):
    running.to_trials()
    with pytest.raises(StudyError, match="reason"):
        running.runner.skip(" ")
    running.runner.skip("device too hot")
    assert running.runner.page.position == 2
    assert "skip" in kinds(running)


ACTIONS = {
    "repeat": lambda runner: runner.repeat(),
    "skip": lambda runner: runner.skip("too hot"),
    "retry": lambda runner: runner.retry(),
    "note": lambda runner: runner.note("a stop"),
    "pause": lambda runner: runner.pause(),
    "poll": lambda runner: runner.poll(),
    "stop": lambda runner: runner.halt("operator"),
}


@pytest.mark.parametrize("action", ACTIONS)
@pytest.mark.parametrize("when", ["ready", "playing", "asking"])
def test_after_a_stop_only_resuming_lets_a_trial_play(running, when, action):
    running.to_trials()
    running.trial()
    if when != "ready":
        running.play() if when == "asking" else running.runner.proceed()
    running.runner.halt("escape")
    ACTIONS[action](running.runner)
    if running.kind is PageKind.READY:
        running.runner.proceed()
    assert running.kind is PageKind.PAUSED
    assert running.stage.is_stopped
    assert not running.stage.playing
    running.runner.resume("participant")
    assert not running.stage.is_stopped
    if running.kind is PageKind.QUESTIONS:
        running.runner.answer(VALUES)
    running.trial()


def test_a_grip_button_in_a_trial_pauses_the_session(running):
    running.to_trials()
    running.runner.proceed()
    running.stage.is_stopped = True
    running.runner.poll()
    assert running.kind is PageKind.PAUSED
    assert "force_stopped" in running.contents("trial")[0]["reasons"]


def test_a_replay_or_demonstration_waits_for_the_re_arming(running):
    running.to_demonstration()
    running.runner.halt("escape")
    running.runner.resume()
    running.stage.is_stopped = True
    running.runner.demonstrate()
    assert running.kind is PageKind.PAUSED
    running.runner.resume()
    running.runner.demonstrate()
    assert running.kind is PageKind.PLAYING


def test_stopping_keeps_what_was_answered(running):
    running.to_trials()
    for _ in range(5):
        running.trial()
    running.runner.proceed()
    running.runner.leave()
    assert running.kind is PageKind.STOPPED
    assert running.study.session(running.code).state is SessionState.STOPPED
    ratings = read_answers(running.study.folder).ratings
    assert sum(r.value is not None for r in ratings) == 20
    assert running.stage.halts


def test_after_a_crash_the_next_planned_trial_comes(running):
    running.to_trials()
    for _ in range(4):
        running.trial()
    running.play()  # crashed while the questions of the fifth were open
    back = running.again()
    assert back.kind is PageKind.READY
    assert back.runner.page.position == 5
    back.trial()
    assert back.runner.page.position == 6
    assert back.contents("resume")[0]["step"] == "trial-05"
    assert back.contents("answers")[-1]["attempt"] == 2
    back.runner.close()


def test_a_session_that_is_over_is_not_resumed(running):
    running.runner.consent(given=False)
    with pytest.raises(StudyError, match="stopped"):
        running.again()


@pytest.mark.parametrize("call", ["write", "fsync"])
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EROFS, errno.EIO])
def test_a_full_disk_stops_the_session_before_an_answer_counts(
    running, monkeypatch, call, number
):
    running.to_trials()
    running.play()
    with monkeypatch.context() as patch:

        def refuse(*_args):
            raise OSError(number, os.strerror(number))

        patch.setattr(journals.os, call, refuse)
        running.runner.answer(VALUES)
        assert running.kind is PageKind.PROBLEM
        is_full = number == errno.ENOSPC
        reason = "is full" if is_full else os.strerror(number)
        assert reason in running.runner.problem
        running.runner.retry()
        assert running.kind is PageKind.PROBLEM
    running.runner.retry()
    assert running.kind is PageKind.READY
    assert running.runner.page.position == 2
    ratings = read_answers(running.study.folder).ratings
    assert sum(r.value is not None for r in ratings) == 4


@pytest.mark.parametrize(
    ("at", "page"),
    [
        ("trial-begin", PageKind.PLAYING),
        ("trial", PageKind.QUESTIONS),
        ("answers", PageKind.READY),
    ],
)
def test_once_the_disk_has_room_again_the_force_is_back(running, monkeypatch, at, page):
    running.to_trials()
    if at != "trial-begin":
        running.play() if at == "answers" else running.runner.proceed()
    with monkeypatch.context() as patch:
        patch.setattr(journals, "write_whole", no_room)
        if at == "answers":
            running.runner.answer(VALUES)
        elif at == "trial":
            running.end_clip()
        else:
            running.runner.proceed()
        assert running.kind is PageKind.PROBLEM
        assert not running.stage.playing
    running.runner.retry()
    assert not running.stage.is_stopped
    assert running.kind is page


def test_a_note_while_nothing_can_be_saved_takes_no_answer_away(running, monkeypatch):
    running.to_trials()
    running.play()
    with monkeypatch.context() as patch:
        patch.setattr(journals, "write_whole", no_room)
        running.runner.answer(VALUES)
        running.runner.note("the disk is full")
        running.runner.retry()
        running.runner.note("still")
        assert running.kind is PageKind.PROBLEM
    running.runner.retry()
    assert running.kind is PageKind.READY
    assert running.runner.page.position == 2
    assert kinds(running)[-3:] == ["answers", "note", "note"]


def test_half_a_character_in_a_text_does_not_stop_the_session(running):
    running.runner.note("a\ud83d b")
    assert running.records().intact[-1].content["text"] == "a? b"
    assert running.records().damaged == ()


def test_a_note_of_any_length_is_kept_whole(running):
    text = "\x07" + "\u20ac" * 1_100_000
    running.runner.note(text)
    assert "".join(one["text"] for one in running.contents("note")) == text
    with pytest.raises(StudyError, match=r"too long .* 1024 KB"):
        running.runner._journal.append("note", text=text)
    running.runner.note("after")
    assert running.records().intact[-1].content["text"] == "after"


def test_a_folder_that_is_removed_stops_the_participant(running):
    running.to_trials()
    running.play()
    running.study.folder.rename(running.study.folder.with_name("gone"))
    running.runner.answer(VALUES)
    assert running.kind is PageKind.PROBLEM
    running.runner.stop("disk gone")
    assert not running.runner.is_over


def test_consent_that_cannot_be_kept_is_no_consent(running):
    consents = running.study.folder / "consents"
    consents.rmdir()
    consents.write_text("in the way")
    running.runner.consent(given=True)
    assert running.kind is PageKind.PROBLEM
    assert "passed" not in kinds(running)
    consents.unlink()
    running.runner.retry()
    assert running.kind is PageKind.QUESTIONS
    assert (consents / f"{running.code}.json").is_file()


def test_the_demonstration_and_replays_come_back_to_their_page(running):
    running.to_demonstration()
    running.runner.demonstrate()
    assert running.kind is PageKind.PLAYING
    running.end_clip()
    assert running.kind is PageKind.DEMONSTRATION
    running.runner.proceed()
    for _ in range(12):
        running.trial()
    replays = running.runner.page.replays
    assert [name for name, _ in replays] == ["Feedback 1", "Feedback 2", "Feedback 3"]
    assert [len(clips) for _, clips in replays] == [4, 4, 4]
    running.runner.replay("2.3")
    played = running.stage.prepared[-1]
    assert played.sequence == "car-turning"
    assert played.feedback == running.runner.plan.labels[1]
    running.end_clip()
    assert running.kind is PageKind.QUESTIONS


def test_an_observer_hears_markers_but_no_answers_and_no_code(running):
    running.to_trials()
    running.trial()
    texts = [text for text, _ in running.heard.markers]
    begins = [text for text in texts if text.startswith("trial-01 begin")]
    assert len(begins) == 1
    assert f"trial-01 end {running.runner.plan.order[0].key}" in texts
    assert not any(running.code in text for text in texts)
    times = [at for _, at in running.heard.markers]
    assert times == sorted(times)


def test_live_markers_are_those_of_the_records(running):
    running.to_trials()
    running.trial()
    running.runner.pause()
    running.runner.resume()
    running.trial()
    running.runner.stop("ill")
    stored = markers_of(running.study.session(running.code))
    pages = (" page", " questions")  # no record is written for these
    live = [
        (text, at) for text, at in running.heard.markers if not text.endswith(pages)
    ]
    assert live == [(one.text, one.monotonic_s) for one in stored]
    key = running.runner.plan.order[0].key
    (begin, begin_s), (first, first_s), *_ = live
    assert (begin, first) == (f"trial-01 begin {key}", f"trial-01 first frame {key}")
    assert begin_s <= first_s


def test_the_operator_s_notes_and_checks_are_kept(running):
    running.runner.store_checks([{"check": "disk", "ok": True}], overridden=False)
    running.runner.note(" window was open ")
    found = {r.kind: r.content for r in running.records().intact}
    assert found["note"] == {"text": "window was open"}
    assert found["checks"]["checks"][0]["check"] == "disk"


def test_a_trial_that_is_not_recorded_elsewhere_does_not_begin(running):
    running.to_trials()
    running.heard.problem = "LabRecorder was closed"
    with pytest.raises(StudyError, match="LabRecorder was closed"):
        running.runner.proceed()
    assert (running.kind, running.contents("trial-begin")) == (PageKind.READY, [])
    running.heard.problem = ""
    running.play()
    assert len(running.contents("trial-begin")) == 1
