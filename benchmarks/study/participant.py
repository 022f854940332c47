"""The real program offscreen, with a participant who presses its buttons; to be killed.

Run by `kill`. Each answer that the program shows as kept (the next page is there) is
acknowledged on stdout: `ack STEP ATTEMPT VALUES`.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

from PySide6.QtCore import QTimer

from app.participant.application import StudySession
from app.participant.pages import QuestionsPage
from app.player.application import make_application
from hapticplayer.clock import SystemClock
from hapticplayer.study.definition import QuestionKind
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_setup import load_material
from hapticplayer.study.study_folder import open_study

STEP_MS, CLIP_S = 3, 0.03
BUTTONS = {
    PageKind.CONSENT: "agree",
    PageKind.DEMONSTRATION: "next",
    PageKind.READY: "start",
    PageKind.PAUSED: "go_on",
}


class Participant:
    """Answers every page with numbers that tell it, so that none can be mixed up."""

    def __init__(self, session: StudySession) -> None:
        self.session = session
        self.given: tuple[int, str] | None = None
        self.timer = QTimer()
        self.timer.timeout.connect(self.act)
        self.timer.start(STEP_MS)

    def act(self) -> None:
        """Do what is due on the page that is shown."""
        runner, window = self.session.runner, self.session.participant
        if runner is None:
            return
        page = runner.page
        if self.given is not None and page.number != self.given[0]:
            say(f"ack {self.given[1]}")
            self.given = None
        if page.kind is PageKind.PLAYING:
            self.session.player.set_end(CLIP_S)
        elif page.kind in (PageKind.THANKS, PageKind.STOPPED):
            say("end")
            self.timer.stop()
            QTimer.singleShot(0, self.session.close)
            QTimer.singleShot(50, make_application().quit)
        elif window.shown_number == page.number and window.content is not None:
            window.guard.stop()  # a person would wait for it
            self.press(page.kind, page.number)

    def press(self, kind: PageKind, number: int) -> None:
        """Press the button of a page, after answering its questions."""
        content, runner = self.session.participant.content, self.session.runner
        assert runner is not None
        if not isinstance(content, QuestionsPage):
            if kind in BUTTONS and content is not None:
                content.buttons[BUTTONS[kind]].click()
            return
        for row in content.rows:
            row.set_value(answer_to(row.asked.kind, number))
        values = json.dumps({row.asked.name: row.value() for row in content.rows})
        self.given = (number, f"{runner.step} {runner.attempt} {values}")
        content.next.click()


def answer_to(kind: QuestionKind, number: int) -> Any:
    """Return an answer that fits."""
    return {
        QuestionKind.LIKERT: 1 + number % 5,
        QuestionKind.NUMBER: 20 + number,
        QuestionKind.CHOICE: "right",
        QuestionKind.YES_NO: number % 2 == 0,
        QuestionKind.TEXT: f"page {number}",
    }[kind]


def say(text: str) -> None:
    """Print a line for the benchmark, at once."""
    os.write(1, f"{text}\n".encode())


def take_part(folder: Path, code: str) -> None:
    """Run or resume one session."""
    application = make_application()
    study = open_study(folder)
    material = load_material(study)
    session = StudySession(study, material, "none", SystemClock(), audio=None)
    session.show(windowed=True)
    say("begin")
    session.begin_session(code, "en")
    assert session.runner is not None
    say(f"code {session.runner.plan.code}")
    _participant = Participant(session)
    application.exec()


def main() -> None:
    """Run a program for each line `CODE` on stdin, a new session for an empty one.

    Importing takes longer than a session: it is done once, each program is a fork.
    """
    for line in sys.stdin:
        child = os.fork()
        if not child:
            take_part(Path(sys.argv[1]), line.strip())
            os._exit(0)
        say(f"pid {child}")
        os.waitpid(child, 0)
        say("gone")


if __name__ == "__main__":
    main()
