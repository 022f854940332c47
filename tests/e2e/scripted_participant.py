"""`study run` with an operator and a participant who use its windows; see test_study_run.

Arguments: a JSON file with the answers to each step, then those of `hapticplayer`. Says,
as a line of JSON for each page, its step and what is on which screen.
"""

import json
import sys
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.__main__ import main
from app.experimenter.session_control import SessionControl
from app.participant.pages import QuestionsPage
from app.participant.window import ParticipantWindow
from app.player.application import make_application

LOOK_MS = 20
CONTINUE = ("agree", "next", "start", "resume")


class ScriptedParticipant:
    """Starts the session, answers, and closes the operator's window at the end."""

    def __init__(self, answers):
        self.answers = answers
        self.shown = -1
        self.timer = QTimer()
        self.timer.timeout.connect(self.act)
        self.timer.start(LOOK_MS)

    def act(self):
        windows = {type(one): one for one in QApplication.topLevelWidgets()}
        if {ParticipantWindow, SessionControl} <= set(windows):
            participant, operator = windows[ParticipantWindow], windows[SessionControl]
            if participant.shown_number < 0:
                self.start(operator.start)
            elif not participant.guard.isActive():
                self.use(participant, operator)

    def start(self, panel):
        panel.override.setChecked(True)
        if panel.start.isEnabled():
            panel.start.click()

    def use(self, participant, operator):
        page = participant.content
        if participant.shown_number != self.shown:
            self.shown = participant.shown_number
            self.say(participant, operator)
        if page is None:
            return
        if isinstance(page, QuestionsPage):
            self.answer(page)
            return
        for name in set(page.buttons) & set(CONTINUE):
            page.buttons[name].click()
        if not page.buttons:
            operator.close()

    def answer(self, page):
        given = self.answers.get(page.objectName(), {})
        for row in page.rows:
            value = given.get(row.asked.name)
            if isinstance(value, int) and row.take_digit(value):
                continue
            row.set_value(value)
        QTest.keyClick(page, Qt.Key.Key_Return)

    def say(self, participant, operator):
        page = participant.content
        content = {
            "step": page.objectName() if page else "clip",
            "participant": participant.geometry().getRect(),
            "is_fullscreen": participant.isFullScreen(),
            "operator": operator.geometry().getRect(),
            "screens": [s.geometry().getRect() for s in QApplication.screens()],
        }
        sys.stdout.write(f"{json.dumps(content)}\n")


if __name__ == "__main__":
    make_application()
    _participant = ScriptedParticipant(json.loads(Path(sys.argv[1]).read_text()))
    sys.exit(main(sys.argv[2:]))
