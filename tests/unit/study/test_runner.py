"""A session from consent to thanks, interrupted in every way, on a virtual clock."""

import errno
import os

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
from hapticplayer.study.study_folder import begin_session
from tests.unit.study.conftest import SHEET, VALUES


class FakeStage:
    """Plays nothing, and ends when it is told to."""

    def __init__(self):
        self.prepared = []
        self.playing = False
        self.ended = False
        self.halts = 0
        self.is_armed = True
        self.reasons = ()

    def prepare(self, condition: Condition):
        self.prepared.append(condition)

    def prepare_demonstration(self):
        self.prepared.append("demonstration")

    def begin(self):
        assert self.is_armed
        self.playing, self.ended = True, False

    def is_over(self):
        return self.ended

    def played(self, *reasons):
        found = (*reasons, *self.reasons)
        return PlaybackResult(not found, found, {"pictures_shown": 50})

    def halt(self):
        self.halts += 1
        self.playing = self.is_armed = False

    def rearm(self):
        self.is_armed = True


class Sitting:
    """A participant and an operator in front of a runner."""

    def __init__(self, study, clock, code=None, observer=None):
        self.study, self.clock, self.stage = study, clock, FakeStage()
        self.code = code or begin_session(study, "en", {}, clock).code
        self.runner = SessionRunner(study, self.code, self.stage, clock, observer)

    @property
    def kind(self):
        return self.runner.page.kind

    def to_trials(self):
        self.runner.consent(given=True)
        self.runner.answer(SHEET)
        self.runner.proceed()

    def play(self):
        self.runner.proceed()
        assert self.kind is PageKind.PLAYING
        self.clock.advance(60.0)
        self.stage.ended = True
        self.runner.poll()

    def trial(self, **values):
        self.play()
        self.clock.advance(7.0)
        self.runner.answer({**VALUES, **values})

    def records(self):
        return read_journal(self.study.session_folder(self.code) / "answers.jsonl")

    def again(self):
        """Crash, and open the session anew."""
        self.runner.close()
        return Sitting(self.study, self.clock, self.code)


@pytest.fixture
def sitting(study, manual_clock):
    made = Sitting(study, manual_clock)
    yield made
    made.runner.close()


def no_room(*_args):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def kinds(sitting):
    return [record.kind for record in sitting.records().intact]


def test_a_whole_session_goes_from_consent_to_thanks(sitting):
    seen = [sitting.kind]
    sitting.to_trials()
    for position in range(1, 13):
        page = sitting.runner.page
        assert (page.kind, page.position, page.count) == (PageKind.READY, position, 12)
        sitting.trial()
    seen.append(sitting.kind)
    page = sitting.runner.page
    assert [q.name for q in page.questions if "@" in q.name] == [
        f"label@{name}" for name in sitting.runner.plan.labels
    ]
    assert [q.heading for q in page.questions if q.heading] == [
        "Feedback 1",
        "Feedback 2",
        "Feedback 3",
    ]
    sitting.runner.answer({"tiring": "no"})
    assert seen == [PageKind.CONSENT, PageKind.QUESTIONS]
    assert sitting.kind is PageKind.THANKS
    assert sitting.runner.is_over
    session = sitting.study.session(sitting.code)
    assert session.state is SessionState.COMPLETE
    assert not session.records.damaged
    played = sitting.stage.prepared
    assert played == list(session.plan.order)
    assert {r.value for r in read_answers(sitting.study.folder).ratings} == {1, 2, 3, 5}


def test_pages_tell_neither_condition_nor_file(sitting):
    sitting.to_trials()
    told = []
    for _ in range(12):
        told.append(repr(sitting.runner.page))
        sitting.play()
        told.append(repr(sitting.runner.page))
        sitting.runner.answer(VALUES)
    for secret in ("bike", "horse", "car-", "realistic", "random", "none", "/"):
        assert not any(secret in text for text in told), secret


def test_an_answer_is_on_the_disk_before_the_next_page(sitting, monkeypatch):
    sitting.to_trials()
    sitting.play()
    number, seen = sitting.runner.page.number, []
    real = journals.os.fsync

    def fsync(descriptor):
        seen.append(sitting.runner.page.number)
        real(descriptor)

    monkeypatch.setattr(journals.os, "fsync", fsync)
    sitting.runner.answer(VALUES)
    assert seen == [number]
    assert sitting.runner.page.number > number


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
def test_what_is_no_answer_is_refused_and_nothing_is_kept(sitting, values):
    sitting.to_trials()
    sitting.play()
    before = sitting.records()
    with pytest.raises(StudyError):
        sitting.runner.answer(values)
    assert sitting.records() == before
    assert sitting.kind is PageKind.QUESTIONS


def test_refused_consent_ends_the_session_without_answers(sitting):
    sitting.runner.consent(given=False)
    assert sitting.kind is PageKind.STOPPED
    assert kinds(sitting) == ["plan", "begin", "end"]
    assert read_answers(sitting.study.folder).participants == ()


def test_how_long_an_answer_took_is_kept(sitting):
    sitting.to_trials()
    sitting.trial()
    last = [r for r in sitting.records().intact if r.kind == "answers"][-1]
    assert last.content["response_s"] == pytest.approx(7.0)
    assert last.content["attempt"] == 1


def test_pausing_a_clip_makes_it_begin_again(sitting):
    sitting.to_trials()
    sitting.runner.proceed()
    sitting.runner.pause()
    assert sitting.kind is PageKind.PAUSED
    assert not sitting.stage.is_armed
    sitting.runner.resume()
    assert sitting.kind is PageKind.READY
    assert sitting.runner.page.position == 1
    sitting.trial()
    trials = [r.content for r in sitting.records().intact if r.kind == "trial"]
    assert [(t["attempt"], t["sound"], t["reasons"]) for t in trials] == [
        (1, False, ["paused"]),
        (2, True, []),
    ]


def test_pausing_at_the_questions_comes_back_to_them(sitting):
    sitting.to_trials()
    sitting.play()
    sitting.runner.pause()
    sitting.runner.resume()
    assert sitting.kind is PageKind.QUESTIONS
    sitting.runner.answer(VALUES)
    assert sitting.runner.page.position == 2


def test_a_repeated_trial_counts_with_its_last_answers(sitting):
    sitting.to_trials()
    sitting.stage.reasons = ("pictures_dropped",)
    sitting.trial(realism=1)
    assert sitting.runner.last_trial.reasons == ("pictures_dropped",)
    sitting.stage.reasons = ()
    sitting.runner.repeat()
    assert sitting.runner.page.position == 1
    sitting.trial(realism=5)
    assert sitting.runner.page.position == 2
    ratings = read_answers(sitting.study.folder).ratings
    realism = [r for r in ratings if r.factor == "realism" and r.value is not None]
    assert [(r.value, r.sound) for r in realism] == [(5, True)]


def test_a_trial_that_was_not_sound_is_marked(sitting):
    sitting.to_trials()
    sitting.stage.reasons = ("sync:sound",)
    sitting.trial()
    ratings = read_answers(sitting.study.folder).ratings
    assert sum(not r.sound for r in ratings) == 4


def test_skipping_needs_a_reason_and_leaves_the_rating_missing(sitting):
    sitting.to_trials()
    with pytest.raises(StudyError, match="reason"):
        sitting.runner.skip(" ")
    sitting.runner.skip("device too hot")
    assert sitting.runner.page.position == 2
    assert "skip" in kinds(sitting)


def test_stopping_keeps_what_was_answered(sitting):
    sitting.to_trials()
    for _ in range(5):
        sitting.trial()
    sitting.runner.proceed()
    sitting.runner.leave()
    assert sitting.kind is PageKind.STOPPED
    assert sitting.study.session(sitting.code).state is SessionState.STOPPED
    ratings = read_answers(sitting.study.folder).ratings
    assert sum(r.value is not None for r in ratings) == 20
    assert sitting.stage.halts


def test_after_a_crash_the_next_planned_trial_comes(sitting):
    sitting.to_trials()
    for _ in range(4):
        sitting.trial()
    sitting.play()  # crashed while the questions of the fifth were open
    back = sitting.again()
    assert back.kind is PageKind.READY
    assert back.runner.page.position == 5
    back.trial()
    assert back.runner.page.position == 6
    record = next(r for r in back.records().intact if r.kind == "resume")
    assert record.content["step"] == "trial-05"
    answers = [r for r in back.records().intact if r.kind == "answers"]
    assert answers[-1].content["attempt"] == 2
    back.runner.close()


def test_a_session_that_is_over_is_not_resumed(sitting):
    sitting.runner.consent(given=False)
    with pytest.raises(StudyError, match="stopped"):
        sitting.again()


@pytest.mark.parametrize("call", ["write", "fsync"])
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EROFS, errno.EIO])
def test_a_full_disk_stops_the_session_before_an_answer_counts(
    sitting, monkeypatch, call, number
):
    sitting.to_trials()
    sitting.play()
    with monkeypatch.context() as patch:

        def refuse(*_args):
            raise OSError(number, os.strerror(number))

        patch.setattr(journals.os, call, refuse)
        sitting.runner.answer(VALUES)
        assert sitting.kind is PageKind.PROBLEM
        assert os.strerror(number) in sitting.runner.problem
        sitting.runner.retry()
        assert sitting.kind is PageKind.PROBLEM
    sitting.runner.retry()
    assert sitting.kind is PageKind.READY
    assert sitting.runner.page.position == 2
    ratings = read_answers(sitting.study.folder).ratings
    assert sum(r.value is not None for r in ratings) == 4


@pytest.mark.parametrize("at", ["trial-begin", "trial", "answers"])
def test_once_the_disk_has_room_again_the_force_is_back(sitting, monkeypatch, at):
    sitting.to_trials()
    if at != "trial-begin":
        sitting.play() if at == "answers" else sitting.runner.proceed()
    with monkeypatch.context() as patch:
        patch.setattr(journals, "_write_whole", no_room)
        if at == "answers":
            sitting.runner.answer(VALUES)
        elif at == "trial":
            sitting.stage.ended = True
            sitting.runner.poll()
        else:
            sitting.runner.proceed()
        assert sitting.kind is PageKind.PROBLEM
        assert not sitting.stage.is_armed
    sitting.runner.retry()
    assert sitting.stage.is_armed
    assert (
        sitting.kind
        is {
            "trial-begin": PageKind.PLAYING,
            "trial": PageKind.QUESTIONS,
            "answers": PageKind.READY,
        }[at]
    )


def test_a_note_while_nothing_can_be_saved_takes_no_answer_away(sitting, monkeypatch):
    sitting.to_trials()
    sitting.play()
    with monkeypatch.context() as patch:
        patch.setattr(journals, "_write_whole", no_room)
        sitting.runner.answer(VALUES)
        sitting.runner.note("the disk is full")
        sitting.runner.retry()
        sitting.runner.note("still")
        assert sitting.kind is PageKind.PROBLEM
    sitting.runner.retry()
    assert sitting.kind is PageKind.READY
    assert sitting.runner.page.position == 2
    assert kinds(sitting)[-3:] == ["answers", "note", "note"]


def test_half_a_character_in_a_text_does_not_stop_the_session(sitting):
    sitting.runner.note("a\ud83d b")
    assert sitting.records().intact[-1].content["text"] == "a? b"
    assert sitting.records().damaged == ()


def test_a_folder_that_is_removed_stops_the_participant(sitting):
    sitting.to_trials()
    sitting.play()
    sitting.study.folder.rename(sitting.study.folder.with_name("gone"))
    sitting.runner.answer(VALUES)
    assert sitting.kind is PageKind.PROBLEM
    sitting.runner.stop("disk gone")
    assert not sitting.runner.is_over


def test_consent_that_cannot_be_kept_is_no_consent(sitting):
    consents = sitting.study.folder / "consents"
    consents.rmdir()
    consents.write_text("in the way")
    sitting.runner.consent(given=True)
    assert sitting.kind is PageKind.PROBLEM
    assert "passed" not in kinds(sitting)
    consents.unlink()
    sitting.runner.retry()
    assert sitting.kind is PageKind.QUESTIONS
    assert (consents / f"{sitting.code}.json").is_file()


def test_the_demonstration_and_replays_come_back_to_their_page(sitting):
    sitting.runner.consent(given=True)
    sitting.runner.answer(SHEET)
    sitting.runner.demonstrate()
    assert sitting.kind is PageKind.PLAYING
    sitting.stage.ended = True
    sitting.runner.poll()
    assert sitting.kind is PageKind.DEMONSTRATION
    sitting.runner.proceed()
    for _ in range(12):
        sitting.trial()
    replays = sitting.runner.page.replays
    assert [name for name, _ in replays] == ["Feedback 1", "Feedback 2", "Feedback 3"]
    assert [len(clips) for _, clips in replays] == [4, 4, 4]
    sitting.runner.replay("2.3")
    played = sitting.stage.prepared[-1]
    assert played.sequence == "car-turning"
    assert played.feedback == sitting.runner.plan.labels[1]
    sitting.stage.ended = True
    sitting.runner.poll()
    assert sitting.kind is PageKind.QUESTIONS


def test_an_observer_hears_markers_but_no_answers_and_no_code(study, manual_clock):
    class Heard:
        def __init__(self):
            self.markers = []

        def marker(self, text, monotonic_s):
            self.markers.append((text, monotonic_s))

    heard = Heard()
    sitting = Sitting(study, manual_clock, observer=heard)
    sitting.to_trials()
    sitting.trial()
    sitting.runner.close()
    texts = [text for text, _ in heard.markers]
    begins = [text for text in texts if text.startswith("trial-01 begin")]
    assert len(begins) == 1
    assert "trial-01 end" in texts
    assert not any(sitting.code in text for text in texts)
    times = [at for _, at in heard.markers]
    assert times == sorted(times)


def test_the_operator_s_notes_and_checks_are_kept(sitting):
    sitting.runner.store_checks([{"check": "disk", "ok": True}], overridden=False)
    sitting.runner.note(" window was open ")
    found = {r.kind: r.content for r in sitting.records().intact}
    assert found["note"] == {"text": "window was open"}
    assert found["checks"]["checks"][0]["check"] == "disk"
