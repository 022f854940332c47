"""Two screens: the clip on the one that was chosen, the operator on the other."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from sitting import Person

from app.participant.application import StudySession
from app.player.extras import SCREEN
from hapticplayer.clock import SystemClock
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_setup import load_study_sources


def screens():
    return {screen.name(): screen for screen in QGuiApplication.screens()}


def test_fullscreen_goes_to_the_screen_that_was_chosen_and_back(playing, wait_for):
    left, right = screens()["left"], screens()["right"]
    before = playing.geometry()
    menu = playing.extras.menus.screens
    menu.fill()
    choices = {action.data(): action for action in menu.menu.actions()}
    assert {"", "left", "right"} == set(choices)
    choices["right"].trigger()
    assert playing.settings.text(SCREEN) == "right"
    assert playing.screen() is left
    playing.toggle_fullscreen()
    wait_for(lambda: playing.geometry() == right.geometry())
    wait_for(lambda: playing.surface.size() == right.geometry().size())
    playing.toggle_fullscreen()
    wait_for(lambda: playing.geometry() == before)


def test_a_screen_that_is_gone_leaves_the_window_where_it_is(playing, wait_for):
    playing.fullscreen.screen_name = "a screen of yesterday"
    playing.toggle_fullscreen()
    wait_for(lambda: playing.geometry() == screens()["left"].geometry())


@pytest.fixture
def session(make_study, application):
    study = make_study()
    made = StudySession(study, load_study_sources(study), (), SystemClock(), audio=None)
    made.participant.guard.setInterval(0)
    made.show(windowed=False)
    yield made
    made.close()


def test_the_participants_screen_shows_only_the_clip(session, wait_for):
    mine = session.control.screen()
    (theirs,) = set(QGuiApplication.screens()) - {mine}
    session.begin_session("", "en")
    participant = session.participant
    wait_for(lambda: participant.geometry() == theirs.geometry())
    assert participant.isFullScreen()
    assert mine.geometry().contains(session.control.geometry().center())
    person = Person(session, wait_for)
    person.begin_trial()
    assert participant.cursor().shape() == Qt.CursorShape.BlankCursor
    assert session.surface.isVisible()
    wait_for(lambda: session.surface.size() == theirs.geometry().size())
    wait_for(lambda: session.control.mirror.is_clip)
    assert session.control.mirror.screen() is mine


def test_escape_on_either_screen_stops_the_force(session, wait_for):
    session.begin_session("", "en")
    person = Person(session, wait_for)
    person.to_trials()
    for window in (session.participant, session.control):
        person.key(Qt.Key.Key_Enter)
        person.wait_page(PageKind.PLAYING)
        stopped = session.player.snapshot().phase
        QTest.keyClick(window.windowHandle(), Qt.Key.Key_Escape)
        person.wait_page(PageKind.PAUSED)
        assert session.player.snapshot().phase != stopped
        person.key(Qt.Key.Key_Enter)
        person.wait_page(PageKind.READY)
