"""`study run` with an operator and a participant who use its windows; see test_study_run.

Arguments: a JSON file with the answers to each step, then those of `hapticplayer`. Says,
as a line of JSON for each page, its step and what is on which screen. With an answer to
"stop" a clip is stopped by Escape while its force is felt; the session goes on only after
all else that a person might press. Both times are said.
"""

import json
import sys
from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.__main__ import main
from app.experimenter.session_control import SessionControl
from app.participant.pages import QuestionsPage
from app.participant.window import ParticipantWindow
from app.player.application import make_application
from hapticplayer.clock import SystemClock

LOOK_MS = 20
FELT_N = 0.3
HELD_LOOKS = 40  # before a session that was stopped goes on
CONTINUE = ("agree", "next", "start", "resume")


class ScriptedParticipant:
    """Starts the session, answers, and closes the operator's window at the end."""

    def __init__(self, answers):
        self.answers = answers
        self.shown = -1
        self.may_stop, self.looks = "stop" in answers, 0
        self.runner, follow = None, ParticipantWindow.follow

        def followed(window, runner):
            self.runner = runner
            follow(window, runner)

        ParticipantWindow.follow = followed
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
            self.shown, self.looks = participant.shown_number, 0
            self.say(participant, operator)
        self.looks += 1
        if page is None:
            if self.may_stop and self.is_felt():
                self.may_stop = False
                self.tell("stopped")
                QTest.keyClick(participant.windowHandle(), Qt.Key.Key_Escape)
            return
        if isinstance(page, QuestionsPage):
            self.answer(page)
            return
        if "resume" in page.buttons and self.looks < HELD_LOOKS:
            self.try_keys(participant, operator)
            return
        for name in set(page.buttons) & set(CONTINUE):
            if name == "resume":
                self.tell("resumed")
            page.buttons[name].click()
        if not page.buttons:
            operator.close()

    def is_felt(self):
        leading = self.runner.stage.player.snapshot().leading
        return (
            leading.tick is not None and np.abs(leading.tick["force_n"]).max() > FELT_N
        )

    def try_keys(self, participant, operator):
        """Press what might bring the force back, but for Resume."""
        for window in (participant, operator):
            for key in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_MediaPlay):
                QTest.keyClick(window, key)
            QTest.keyClick(window, Qt.Key.Key_R, Qt.KeyboardModifier.ControlModifier)

    def tell(self, what):
        sys.stdout.write(f"{json.dumps({what: SystemClock().now_s()})}\n")

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
