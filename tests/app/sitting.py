"""Somebody who sits in front of the participant's screen, for the tests of studies."""

import json
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.participant.application import StudySession
from hapticplayer.clock import SystemClock
from hapticplayer.study import session_setup
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_setup import load_study_sources

KEYS = ("bike", "horse", "car-turning", "car-braking")


@pytest.fixture
def make_study(sequence, tmp_path, monkeypatch):
    """Make a study whose four sequences are the short clip, without requirements."""
    monkeypatch.setattr(session_setup, "WIDTH", 64)  # else its clip takes 2 s
    monkeypatch.setattr(session_setup, "HEIGHT", 36)

    def make(**changes):
        study = create_study(
            tmp_path / "study", folders={key: Path(sequence) for key in KEYS}
        )
        content = json.loads(study.content)
        content["checks"].update(device=False, sound=False, disk_free_mb=1)
        content["checks"]["scheduling"] = ["fifo", "slice", "normal"]
        content["limits"] = {
            "dropped_share": 1.0,
            "sync_ms": 1e6,
            "missed_share": 1.0,
            "silence_s": 1e6,
        }
        content.update(changes)
        return change_definition(study, content)

    return make


@pytest.fixture
def sit(application, qtbot, wait_for):
    """Open the windows of a session, smaller than a screen."""
    made = []

    def open_windows(study, outputs=(), size=(1280, 720), observer=None, **begin):
        sources = load_study_sources(study)
        session = StudySession(
            study, sources, outputs, SystemClock(), audio=None, observer=observer
        )
        made.append(session)
        session.show(windowed=True)
        session.participant.resize(*size)
        session.participant.guard.setInterval(0)
        qtbot.waitExposed(session.participant)
        session.begin_session(begin.get("code", ""), begin.get("language", "en"))
        return session

    before = set(threading.enumerate())
    yield open_windows
    for session in made:
        session.close()
        for one in (session.control, session.participant):
            one.deleteLater()
    left = [t.name for t in threading.enumerate() if t not in before and t.is_alive()]
    assert not left, f"threads were left behind: {left}"


class Person:
    """Presses keys as somebody in front of the screen would."""

    def __init__(self, session, wait_for):
        self.session, self.wait_for = session, wait_for

    @property
    def page(self):
        return self.session.participant.content

    @property
    def runner(self):
        return self.session.runner

    def key(self, code):
        self.wait_for(lambda: not self.session.participant.guard.isActive())
        window = self.session.participant
        target = window.focusWidget() or window
        QTest.keyClick(target, code)

    def wait_page(self, kind, step=None):
        def is_there():
            page = self.runner.page
            shown = self.session.participant.shown_number == page.number
            return shown and page.kind is kind and step in (None, page.step)

        self.wait_for(is_there)

    def answer_sheet(self):
        age, gender, hand, used = self.page.rows
        age.box.setValue(28)
        for row, digit in ((gender, Qt.Key.Key_1), (hand, Qt.Key.Key_2)):
            row.focus()
            self.key(digit)
        used.focus()
        self.key(Qt.Key.Key_1)
        self.key(Qt.Key.Key_Enter)

    def pass_demonstration(self):
        """Answer what comes before, and leave the page of the device."""
        self.page.buttons["agree"].setFocus()  # nothing has the keyboard before
        self.key(Qt.Key.Key_Space)
        self.wait_page(PageKind.QUESTIONS, "sheet")
        self.answer_sheet()
        self.wait_page(PageKind.DEMONSTRATION)
        self.page.buttons["next"].setFocus()
        self.key(Qt.Key.Key_Enter)

    def to_trials(self):
        self.pass_demonstration()
        self.wait_page(PageKind.READY, "trial-01")

    def begin_trial(self):
        """Answer what comes before the trials, and start the first clip."""
        self.to_trials()
        self.key(Qt.Key.Key_Enter)
        self.wait_page(PageKind.PLAYING)
        return self

    def trial(self, digits=(3, 2, 5, 1), *, end_s=0.2):
        self.wait_page(PageKind.READY)
        self.key(Qt.Key.Key_Enter)
        self.wait_page(PageKind.PLAYING)
        self.session.player.set_end(min(end_s, self.session.player.snapshot().end_s))
        self.wait_page(PageKind.QUESTIONS)
        for digit in digits:
            self.key(Qt.Key(Qt.Key.Key_0 + digit))
        self.key(Qt.Key.Key_Enter)
