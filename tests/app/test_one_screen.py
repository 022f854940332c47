"""One screen: the operator's panel first, and a way back to it that nobody stumbles on."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMainWindow
from shiboken6 import isValid
from sitting import Person

from app.experimenter.study.results import StudyResults
from app.participant import application as running
from app.participant.application import StudySession
from app.participant.window import WAY_BACK
from hapticplayer.clock import SystemClock
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_setup import load_study_sources

CHORD = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def session(make_study, application, monkeypatch):
    monkeypatch.setattr(running, "participant_screen", lambda operator: operator)
    study = make_study()
    made = StudySession(study, load_study_sources(study), (), SystemClock(), audio=None)
    made.participant.guard.setInterval(0)
    made.show(windowed=False)
    yield made
    made.close()


def test_the_panel_is_seen_until_the_session_starts(session, wait_for):
    assert session.control.isVisible()
    assert not session.participant.isVisible()
    assert WAY_BACK in session.start_panel.one_screen.text()
    session.begin_session("", "en")
    participant = session.participant
    wait_for(lambda: participant.isVisible() and participant.isFullScreen())
    assert participant.geometry() == session.control.screen().geometry()


def test_three_keys_bring_the_panel_back_and_pause_the_clip(session, wait_for):
    session.begin_session("", "en")
    person = Person(session, wait_for)
    person.begin_trial()
    QTest.keyClick(session.participant.windowHandle(), Qt.Key.Key_F10, CHORD)
    wait_for(lambda: not session.participant.isVisible())
    assert session.runner.page.kind is PageKind.PAUSED
    button = session.control.buttons["page"]
    assert button.isVisible()
    assert session.control.invalid.text() == "Invalid trials: 0 of 0"
    button.click()
    wait_for(session.participant.isVisible)
    assert not button.isVisible()
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.READY)


def test_after_the_last_page_the_panel_tells_the_next_step(session, wait_for):
    session.begin_session("", "en")
    buttons = session.control.buttons
    person = Person(session, wait_for)
    assert not buttons["results"].isVisibleTo(session.control)
    session.runner.stop("time is up")
    person.wait_page(PageKind.STOPPED)
    QTest.keyClick(session.participant.windowHandle(), Qt.Key.Key_F10, CHORD)
    wait_for(lambda: not session.participant.isVisible())
    assert session.control.invalid.text() == "Invalid trials: 0 of 0"
    assert session.control.invalid.isVisible()
    assert not buttons["end"].isVisible()
    buttons["results"].click()
    (results,) = session.control.findChildren(StudyResults)
    wait_for(results.buttons["analyse"].isEnabled)
    assert results.sessions.rowCount() == 1
    results.buttons["analyse"].click()
    (report,) = session.control.findChildren(QMainWindow)
    buttons["close"].click()
    assert not isValid(report) or not report.isVisible()
    assert not isValid(results) or not results.isVisible()
    assert not session.control.isVisible()


@pytest.mark.parametrize(
    "key", [Qt.Key.Key_F10, Qt.Key.Key_F11, Qt.Key.Key_Escape, Qt.Key.Key_Super_L]
)
def test_single_keys_leave_the_participant_where_they_are(session, key):
    session.begin_session("", "en")
    QTest.keyClick(session.participant.windowHandle(), key)
    assert session.participant.isVisible()


def test_the_keys_do_nothing_with_two_screens(make_study, sit):
    session = sit(make_study())
    QTest.keyClick(session.participant.windowHandle(), Qt.Key.Key_F10, CHORD)
    assert session.participant.isVisible()
    assert not session.control.buttons["page"].isVisible()
