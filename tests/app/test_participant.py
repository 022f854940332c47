"""A whole session in the real windows, by keys, by mouse, and interrupted."""

import json
import socket

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton
from sitting import KEYS, Person

from app.experimenter import session_control
from app.participant.pages import QuestionsPage, TextPage
from app.participant.questions import ButtonsRow, NumberRow
from hapticplayer.haptics.processes import Health
from hapticplayer.study.analysis.blocks import ReportTable
from hapticplayer.study.analysis.conduct_report import playback as reported
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition
from hapticplayer.study.journal import read_journal
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.study_folder import open_study
from tests.needed_extras import needs

CLIP_S = 2.0
EVERY_PAGE = (
    (PageKind.CONSENT, "consent"),
    (PageKind.QUESTIONS, "sheet"),
    (PageKind.DEMONSTRATION, "demonstration"),
    (PageKind.QUESTIONS, "post-test"),
    (PageKind.STOPPED, "end"),
    (PageKind.THANKS, "end"),
)


def test_twelve_conditions_by_keys_alone(make_study, sit, wait_for):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.to_trials()
    ends_s = [CLIP_S, *[0.2] * 11]
    for end_s in ends_s:
        person.trial(end_s=end_s)
    person.wait_page(PageKind.QUESTIONS, "post-test")
    rows = {row.asked.name: row for row in person.page.rows}
    QTest.keyClicks(rows["tiring"].box, "no 1 2 3")
    wait_for(lambda: not session.participant.guard.isActive())
    person.page.next.click()
    person.wait_page(PageKind.THANKS)
    answers = read_answers(session.study.folder)
    assert len(answers.ratings) == 48
    by_factor = {r.factor: r.value for r in answers.ratings}
    assert by_factor == {"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1}
    assert all(r.value is not None and r.is_valid for r in answers.ratings)
    who = answers.participants[0]
    assert (who.age, who.gender, who.handedness) == (28, "female", "left")
    assert who.used_device_before is True
    assert who.complete
    assert [a.text for a in answers.open_answers] == ["no 1 2 3"]
    records = session.study.session(who.code).records.intact
    played = [r.content["playback"] for r in records if r.kind == "trial"]
    for playback, end_s in zip(played, ends_s, strict=True):
        assert playback["media_s"] == pytest.approx(end_s, abs=0.1)
        assert playback["frames_shown"] > 0


@pytest.fixture
def mouse(qtbot):
    """Return what presses a widget of a window with the mouse."""
    return lambda _window, widget: qtbot.mouseClick(widget, Qt.MouseButton.LeftButton)


@pytest.fixture
def finger(application):
    """Return what taps a widget of a window."""
    device = QTest.createTouchDevice()

    def tap(window, widget):
        window.content.ensureWidgetVisible(widget)
        middle = QPoint(widget.width() // 2, widget.height() // 2)
        handle, at = window.windowHandle(), widget.mapTo(window, middle)
        QTest.touchEvent(handle, device).press(0, at, handle).commit()
        QTest.touchEvent(handle, device).release(0, at, handle).commit()

    return tap


@pytest.mark.parametrize("pointer", ["mouse", "finger"])
def test_by_mouse_or_touch_alone(make_study, sit, wait_for, request, pointer):
    session, by = sit(make_study()), request.getfixturevalue(pointer)
    person, window = Person(session, wait_for), session.participant

    def press(widget):
        wait_for(lambda: not window.guard.isActive())
        by(window, widget)

    press(person.page.buttons["agree"])
    person.wait_page(PageKind.QUESTIONS, "sheet")
    for row in person.page.rows:
        if isinstance(row, ButtonsRow):
            press(row.group.button(0))
        elif isinstance(row, NumberRow):
            plus = next(b for b in row.findChildren(QPushButton) if b.text() == "+")
            press(plus)
    press(person.page.next)
    person.wait_page(PageKind.DEMONSTRATION)
    press(person.page.buttons["next"])
    person.wait_page(PageKind.READY)
    press(person.page.buttons["start"])
    person.wait_page(PageKind.PLAYING)
    session.player.set_end(0.2)
    person.wait_page(PageKind.QUESTIONS)
    for row, answer in zip(person.page.rows, (1, 2, 4, 5), strict=True):
        press(row.group.button(answer - 1))
        assert row.value() == answer
    press(person.page.next)
    person.wait_page(PageKind.READY, "trial-02")
    ratings = read_answers(session.study.folder).ratings
    assert [r.value for r in ratings if r.value is not None] == [1, 2, 4, 5]


def test_enter_neither_consents_nor_skips_the_demonstration(make_study, sit, wait_for):
    person = Person(sit(make_study()), wait_for)
    for key in (Qt.Key.Key_Enter, Qt.Key.Key_Space):
        person.key(key)
    assert person.runner.page.kind is PageKind.CONSENT
    person.page.buttons["agree"].click()
    person.wait_page(PageKind.QUESTIONS, "sheet")
    person.answer_sheet()
    person.wait_page(PageKind.DEMONSTRATION)
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.PLAYING)
    person.session.player.set_end(0.2)
    person.wait_page(PageKind.DEMONSTRATION)
    person.key(Qt.Key.Key_Enter)  # who has felt it goes on
    person.wait_page(PageKind.READY, "trial-01")


def test_a_participant_reads_what_this_session_has(make_study, sit):
    session = sit(make_study())
    maker, plan = session.runner.maker, session.runner.plan
    pages = [maker.page(kind, step, 99) for kind, step in EVERY_PAGE]
    said = {page.kind: page.text for page in pages}
    assert f"about {session.runner.minutes} minutes" in said[PageKind.CONSENT]
    assert maker.word("feel") in said[PageKind.DEMONSTRATION]
    for last in (PageKind.THANKS, PageKind.STOPPED):
        assert plan.code in said[last]
    assert not any("{" in text for text in said.values())
    asked = pages[1].questions
    for one in asked:
        assert ("optional" in one.text) is not one.question.required


def test_letters_stay_as_large_when_an_answer_is_missing(make_study, sit, qtbot):
    session = sit(make_study(), size=(1280, 720))
    window, maker = session.participant, session.runner.maker
    window.show_page(maker.page(PageKind.QUESTIONS, "sheet", 99))
    qtbot.wait(50)
    page = window.content
    before_px = page.body.font().pixelSize()
    page.show_problem(page.rows[0].asked.name, maker.word("missing"))
    qtbot.wait(50)
    assert page.body.font().pixelSize() == before_px


def test_an_unanswered_question_is_named_and_nothing_goes_on(make_study, sit, wait_for):
    person = Person(sit(make_study()), wait_for)
    person.begin_trial()
    person.session.player.set_end(0.2)
    person.wait_page(PageKind.QUESTIONS)
    person.key(Qt.Key.Key_4)
    person.key(Qt.Key.Key_Enter)
    assert person.runner.page.kind is PageKind.QUESTIONS
    said = person.runner.maker.word("missing")
    shown = [said in row.title.text() for row in person.page.rows]
    assert shown == [False, True, False, False]
    assert person.page.rows[0].value() == 4


def test_escape_stops_the_clip_and_the_trial_begins_again(make_study, sit, wait_for):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.to_trials()
    for key in (Qt.Key.Key_Escape, Qt.Key.Key_Space):
        person.key(Qt.Key.Key_Enter)
        person.wait_page(PageKind.PLAYING)
        QTest.keyClick(session.participant.windowHandle(), key)
        person.wait_page(PageKind.PAUSED)
        assert set(person.page.buttons) == {"leave", "resume"}
        person.key(Qt.Key.Key_Enter)
        person.wait_page(PageKind.READY, "trial-01")
    records = read_journal(
        session.study.session_folder(person.runner.plan.code) / "answers.jsonl"
    ).intact
    reasons = [r.content["reasons"] for r in records if r.kind == "trial"]
    assert [first for first, *_ in reasons] == ["escape", "space"]


def test_a_participant_reads_why_the_pause_does_not_end(
    make_study, sit, wait_for, monkeypatch
):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.begin_trial()
    QTest.keyClick(session.participant.windowHandle(), Qt.Key.Key_Escape)
    person.wait_page(PageKind.PAUSED)
    output = session.player._outputs.leading
    monkeypatch.setattr(output, "is_near_middle", lambda: False)
    person.key(Qt.Key.Key_Enter)
    assert person.runner.page.kind is PageKind.PAUSED
    assert session.player.snapshot().is_stopped
    assert person.page.problem.isVisible()
    assert "centre" in person.page.problem.text()
    assert "centre" in session.control.messages.text()
    monkeypatch.undo()
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.READY, "trial-01")
    assert not session.player.snapshot().is_stopped


def test_somebody_may_leave_and_keeps_what_was_given(make_study, sit, wait_for):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.to_trials()
    person.trial()
    person.wait_page(PageKind.READY, "trial-02")
    QTest.keyClick(session.participant.windowHandle(), Qt.Key.Key_Escape)
    person.wait_page(PageKind.PAUSED)
    wait_for(lambda: not session.participant.guard.isActive())
    person.page.buttons["leave"].click()
    person.wait_page(PageKind.STOPPED)
    stored = session.study.session(person.runner.plan.code)
    assert stored.state is SessionState.STOPPED
    ratings = read_answers(session.study.folder).ratings
    assert sum(r.value is not None for r in ratings) == 4


def test_closing_in_the_middle_is_asked_once(make_study, sit, wait_for, monkeypatch):
    session, asked = sit(make_study()), []
    answers = iter([False, True])
    monkeypatch.setattr(
        session.control, "is_sure", lambda: asked.append(1) or next(answers)
    )
    session.control.close()
    assert session.control.isVisible()
    session.control.close()
    assert len(asked) == 2
    assert not session.control.isVisible()
    assert not session.participant.isVisible()
    stored = session.study.session(session.runner.plan.code)
    assert stored.state is SessionState.UNFINISHED


def test_the_participant_cannot_close_the_window(make_study, sit, wait_for):
    session = sit(make_study())
    session.participant.close()
    assert session.participant.isVisible()
    assert session.runner.page.kind is PageKind.PAUSED


def test_the_operator_repeats_skips_and_notes(make_study, sit, wait_for):
    session = sit(make_study())
    person, control = Person(session, wait_for), session.control
    person.to_trials()
    person.trial()
    person.wait_page(PageKind.READY, "trial-02")
    control.buttons["repeat"].click()
    person.wait_page(PageKind.READY, "trial-01")
    person.trial((1, 1, 1, 1))
    person.wait_page(PageKind.READY, "trial-02")
    control.note.setText("phone rang")
    QTest.keyClick(control.note, Qt.Key.Key_Return)
    wait_for(lambda: "trial 2 of 12" in control.where.text())
    assert "was valid" in control.played.text()
    ratings = read_answers(session.study.folder).ratings
    assert [r.value for r in ratings if r.value is not None] == [1] * 4
    kinds = [
        r.kind for r in session.study.session(person.runner.plan.code).records.intact
    ]
    assert kinds.count("note") == 1
    assert kinds.count("repeat") == 1


def test_a_skip_skips_the_step_that_was_asked_about(
    make_study, sit, wait_for, monkeypatch
):
    session = sit(make_study())
    person, control = Person(session, wait_for), session.control
    person.page.buttons["agree"].setFocus()
    person.key(Qt.Key.Key_Space)
    person.wait_page(PageKind.QUESTIONS, "sheet")

    def ask(*_):
        person.answer_sheet()  # meanwhile
        return "tired"

    monkeypatch.setattr(session_control, "ask_text", ask)
    control.buttons["skip"].click()
    assert "Nothing was skipped" in control.messages.text()
    person.wait_page(PageKind.DEMONSTRATION)
    monkeypatch.setattr(session_control, "ask_text", lambda *_: "known already")
    control.buttons["skip"].click()
    person.wait_page(PageKind.READY, "trial-01")


def test_no_trial_begins_without_the_device_that_was_lost(make_study, sit, wait_for):
    checks = {"device": True, "sound": False, "disk_free_mb": 1}
    study = make_study(checks={**checks, "scheduling": ["fifo", "slice", "normal"]})
    session = sit(study, outputs=["simulated"])
    person, player = Person(session, wait_for), session.player
    person.to_trials()
    player.set_outputs(["simulated"], takes_faults=True)
    wait_for(lambda: player.snapshot().leading.health is Health.READY)
    player.inject("unplug")
    wait_for(lambda: player.snapshot().leading.health is Health.FAILED)
    person.key(Qt.Key.Key_Enter)
    wait_for(lambda: "was lost" in session.control.messages.text())
    assert "resume it" in session.control.messages.text()
    assert session.runner.page.kind is PageKind.READY
    assert "please wait" in person.page.problem.text().lower()
    records = study.session(session.runner.plan.code).records.intact
    assert "trial-begin" not in [record.kind for record in records]


@needs("rigs")
def test_a_faulty_second_output_is_in_record_and_report(make_study, sit, wait_for):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as unused:
        unused.bind(("127.0.0.1", 0))
        rig = f"rig:outsim,127.0.0.1:{unused.getsockname()[1]}"
    feedbacks = ["realistic"]
    session = sit(make_study(feedbacks=feedbacks), ("simulated", rig))
    person = Person(session, wait_for)
    person.to_trials()
    person.trial(end_s=1.0)
    person.wait_page(PageKind.READY, "trial-02")
    wait_for(lambda: rig in session.control.played.text())
    assert "an output did not play (rig:" in session.control.played.text()
    session.runner.stop("time is up")
    told = f"Invalid trials: 1 of 1 \u2013 an output did not play ({rig}) (trial 1)"
    wait_for(lambda: session.control.invalid.text() == told)
    said = "nobody listens at 127.0.0.1:"
    trial = session.runner.last_trial
    assert trial.playback["output_faults"][rig].startswith(said)
    blocks = reported(read_answers(session.study.folder), feedbacks)
    tables = {one.title: one.rows for one in blocks if isinstance(one, ReportTable)}
    assert (f"output fault: {rig}", "1") in tables[
        "Reasons why a playback was not valid"
    ]
    ((output, what, count),) = tables["What kept outputs from playing"]
    assert (output, count) == (rig, "1")
    assert what.startswith(said)


def test_a_blind_operator_is_told_neither_condition_nor_force(
    make_study, sit, wait_for
):
    session = sit(make_study())
    Person(session, wait_for).to_trials()
    wait_for(lambda: "trial 1" in session.control.where.text())
    texts = " ".join(label.text() for label in session.control.findChildren(QLabel))
    assert not any(key in texts for key in (*KEYS, "realistic", "random"))
    assert not session.control.plots.isVisible()


def test_an_operator_who_may_see_is_told(make_study, sit, wait_for):
    session = sit(make_study(operator_is_blind=False))
    Person(session, wait_for).to_trials()
    condition = session.runner.condition.key
    wait_for(lambda: condition in session.control.where.text())
    assert session.control.plots.isVisible()


def test_a_session_is_resumed_in_new_windows(make_study, sit, wait_for):
    study = make_study()
    session = sit(study)
    person = Person(session, wait_for)
    person.to_trials()
    person.trial()
    person.wait_page(PageKind.READY, "trial-02")
    code = person.runner.plan.code
    session.close()
    back = sit(open_study(study.folder), code=code)
    person = Person(back, wait_for)
    person.wait_page(PageKind.READY, "trial-02")
    person.trial()
    person.wait_page(PageKind.READY, "trial-03")


def test_a_missing_disk_stops_the_participant_until_it_is_back(
    make_study, sit, wait_for
):
    session = sit(make_study(), outputs=["simulated"])
    person = Person(session, wait_for)
    person.begin_trial()
    session.player.set_end(0.2)
    person.wait_page(PageKind.QUESTIONS)
    folder = session.study.folder
    folder.rename(folder.with_name("unplugged"))
    for digit in (Qt.Key.Key_1, Qt.Key.Key_2, Qt.Key.Key_3, Qt.Key.Key_4):
        person.key(digit)
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.PROBLEM)
    assert not session.player.snapshot().is_playing
    wait_for(session.control.buttons["retry"].isVisible)
    assert "could not be saved" in session.control.messages.text()
    folder.with_name("unplugged").rename(folder)
    session.control.buttons["retry"].click()
    person.wait_page(PageKind.READY, "trial-02")
    ratings = read_answers(folder).ratings
    assert sum(r.value is not None for r in ratings) == 4
    assert not session.player.snapshot().is_stopped


def test_a_page_has_its_height_before_it_is_painted_again(make_study, sit):
    session = sit(make_study(), size=(1280, 720))
    window, maker = session.participant, session.runner.maker
    window.show_page(maker.page(PageKind.QUESTIONS, "post-test", 99))
    page = window.content
    page.settle()
    assert page.needed_px(page.viewport().width()) > page.viewport().height()
    assert page.body.height() >= page.body.heightForWidth(page.body.width())
    for row in page.rows:
        assert row.height() >= row.heightForWidth(row.width())


def test_a_very_long_question_can_be_scrolled_to(make_study, sit, wait_for):
    study = make_study()
    content = json.loads(study.content)
    for factor in content["pages"][1]["questions"]:
        factor["text"] = dict.fromkeys(content["languages"], "How was it really? " * 40)
    session = sit(change_definition(study, content), size=(800, 480))
    window = session.participant
    window.show_page(session.runner.maker.page(PageKind.QUESTIONS, "trial-01", 99))
    page = window.content
    assert isinstance(page, QuestionsPage)
    page.next.setFocus()
    page.ensureWidgetVisible(page.next)
    wait_for(lambda: page.verticalScrollBar().maximum() > 0)
    assert page.needed_px(page.viewport().width()) > page.viewport().height()


def test_pages_hold_no_secret_in_any_widget(make_study, sit, wait_for):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.to_trials()
    window = session.participant
    for kind, step in (
        (PageKind.READY, "trial-01"),
        (PageKind.QUESTIONS, "trial-01"),
        (PageKind.QUESTIONS, "post-test"),
    ):
        window.show_page(session.runner.maker.page(kind, step, 99))
        assert isinstance(window.content, TextPage | QuestionsPage)
        texts = [window.windowTitle(), window.surface.accessibleName()]
        for kind_of_widget in (QLabel, QPushButton):
            for widget in window.content.findChildren(kind_of_widget):
                texts += [widget.text(), widget.toolTip(), widget.accessibleName()]
        for secret in ("realistic", "random", "bike", "horse", "car", "clip.mp4"):
            assert not any(secret in text for text in texts), secret
