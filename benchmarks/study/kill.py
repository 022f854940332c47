"""SIGKILL at seeded moments of a scripted session: is an acknowledged answer ever lost?

The real program runs offscreen with a participant who presses its buttons; each answer
that it shows as kept (the next page is there) is acknowledged on its output. It is
killed, resumed until its session ends, and then another session begins.
"""

import argparse
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QTimer

from app.participant.application import StudySession
from app.participant.pages import QuestionsPage
from app.player.application import make_application
from benchmarks.common import ROOT, Report
from hapticplayer.clock import SystemClock
from hapticplayer.errors import StudyError
from hapticplayer.media.encode import write_clip
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.pages import AskedQuestion, PageKind
from hapticplayer.study.questions import kind_of
from hapticplayer.study.session_folder import SessionState, StoredSession
from hapticplayer.study.session_setup import load_study_sources
from hapticplayer.study.study_folder import Study, open_study
from tests.material.shaken import write_shaken_sequence

LATEST_S = 1.5  # after the session is about to be made or opened
NEVER_S = 600.0
KEYS = ("bike", "horse", "car-turning", "car-braking")


@dataclass
class Tally:
    """What was seen over all kills."""

    kills: int = 0
    acknowledged: int = 0
    lost: int = 0
    unreadable: int = 0
    not_resumed: int = 0
    torn: int = 0
    completed: int = 0
    problems: list[str] = field(default_factory=list)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--kills", type=int, help="(500)")
    parser.add_argument("--seed", type=int, default=2012)


def run(options: argparse.Namespace, report: Report) -> None:
    """Kill the program so often, then let it end its session."""
    kills, tally = options.kills or (25 if options.quick else 500), Tally()
    rng = np.random.default_rng(options.seed)
    begin_s = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        study = make_study(Path(folder))
        with contextlib.closing(Program(study)) as program:
            sessions = _Sessions(program, study, tally)
            while tally.kills < kills:
                sessions.go_on(float(rng.uniform(0.0, LATEST_S)))
            if sessions.code:
                sessions.go_on(NEVER_S)
            tally.not_resumed += bool(sessions.code)
    rows = list(vars(tally).items())
    report.table("Kills", ["", "n"], [row for row in rows if row[0] != "problems"])
    for problem in tally.problems:
        print(problem)
    report.target("answers acknowledged", tally.acknowledged, (">=", kills // 2))
    for name in ("lost", "unreadable", "not_resumed"):
        report.target(f"sessions or answers {name}", getattr(tally, name), ("<=", 0))
    seconds = time.monotonic() - begin_s
    report.figures |= {"seed": options.seed, "seconds": seconds, **vars(tally)}


def make_study(folder: Path) -> Study:
    """Make a study whose four sequences are one clip of a second."""
    clip = folder / "clip.mp4"
    frames = (np.full((36, 64, 3), 5 * i, np.uint8) for i in range(25))
    write_clip(clip, frames, frame_rate_hz=25)
    target = write_shaken_sequence(clip, folder / "sequence")
    study = create_study(folder / "study", folders=dict.fromkeys(KEYS, target))
    content = json.loads(study.content)
    content["checks"].update(device=False, sound=False, disk_free_mb=1)
    return change_definition(study, content)


class Program:
    """The program under test; each run is a process that can be killed."""

    def __init__(self, study: Study) -> None:
        self._forks = subprocess.Popen(
            [sys.executable, "-m", "benchmarks.study.kill", str(study.folder)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
            cwd=ROOT,
            text=True,
        )

    def run(self, code: str, kill_after_s: float) -> tuple[str, list[str], bool]:
        """Run a session, and kill the program some time after it is ready.

        Returns:
            The code of the session, what was acknowledged, and whether the session
            came to its end before the program was killed.
        """
        assert self._forks.stdin is not None
        assert self._forks.stdout is not None
        self._forks.stdin.write(f"{code}\n")
        self._forks.stdin.flush()
        said, acknowledged, has_ended, pid = "", [], False, 0
        timer = threading.Timer(kill_after_s, lambda: os.kill(pid, signal.SIGKILL))
        for line in self._forks.stdout:
            word, _, rest = line.strip().partition(" ")
            if word == "pid":
                pid = int(rest)
            elif word == "begin":
                timer.start()
            elif word == "code":
                said = rest
            elif word == "ack":
                acknowledged.append(rest)
            elif word == "end":
                timer.cancel()
                has_ended = True
            elif word == "gone":
                break
        timer.cancel()
        return said, acknowledged, has_ended

    def close(self) -> None:
        """Let the program end."""
        assert self._forks.stdin is not None
        assert self._forks.stdout is not None
        self._forks.stdin.close()
        self._forks.wait()
        self._forks.stdout.close()


class _Sessions:
    """Session after session of one program; `code` is the one that is open."""

    def __init__(self, program: Program, study: Study, tally: Tally) -> None:
        self.program, self.study, self.tally = program, study, tally
        self.code = ""
        self.acknowledged: list[str] = []

    def go_on(self, kill_after_s: float) -> None:
        """Run the program until it is killed, and check what is on the disk."""
        tally = self.tally
        said, new, has_ended = self.program.run(self.code, kill_after_s)
        self.acknowledged += new
        tally.acknowledged += len(new)
        tally.kills += not has_ended
        tally.not_resumed += bool(self.code) and said not in ("", self.code)
        self.code = said or self.code or unfinished(self.study)
        if not self.code:
            return  # killed before there was a session
        state = check(self.study, self.code, self.acknowledged, tally)
        if state is not SessionState.UNFINISHED:
            tally.completed += 1
            self.code, self.acknowledged = "", []


def unfinished(study: Study) -> str:
    """Return the session that was just begun, if there is one."""
    sessions, notices = study.sessions()
    assert not notices, notices
    left = [s.code for s in sessions if s.state is SessionState.UNFINISHED]
    assert len(left) <= 1
    return left[0] if left else ""


def check(
    study: Study, code: str, acknowledged: list[str], tally: Tally
) -> SessionState:
    """Compare what was acknowledged with what is on the disk."""
    try:
        session = study.session(code)
    except StudyError as problem:
        tally.unreadable += 1
        tally.problems.append(str(problem))
        return SessionState.STOPPED
    kept = kept_answers(session)
    tally.torn = max(tally.torn, len(session.records.damaged))
    for text in acknowledged:
        step, attempt, values = text.split(" ", 2)
        missing = f"{code}: {text}"
        wanted = (step, int(attempt), _plain(json.loads(values)))
        if wanted not in kept and missing not in tally.problems:
            tally.lost += 1
            tally.problems.append(missing)
    return session.state


def kept_answers(session: StoredSession) -> set[tuple[str, int, str]]:
    """Return (step, attempt, values) of all answers on the disk."""
    return {
        (
            str(record.content["step"]),
            int(record.content.get("attempt", 0)),
            _plain(record.content["values"]),
        )
        for record in session.records.intact
        if record.kind == "answers"
    }


def _plain(values: dict[str, Any]) -> str:
    return json.dumps(values, sort_keys=True)


# --- the program under test -------------------------------------------------------

STEP_MS, CLIP_S = 3, 0.03
BUTTONS = {
    PageKind.CONSENT: "agree",
    PageKind.DEMONSTRATION: "next",
    PageKind.READY: "start",
    PageKind.PAUSED: "resume",
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
            row.set_value(answer_to(row.asked, number))
        values = json.dumps({row.asked.name: row.value() for row in content.rows})
        self.given = (number, f"{runner.step} {runner.attempt} {values}")
        content.next.click()


def answer_to(asked: AskedQuestion, number: int) -> Any:
    """Return an answer that fits."""
    rng = np.random.default_rng([os.getpid(), number])
    return kind_of(asked.question).drawn(rng)


def say(text: str) -> None:
    """Print a line for the benchmark, at once."""
    os.write(1, f"{text}\n".encode())


def take_part(folder: Path, code: str) -> None:
    """Run or resume one session."""
    application = make_application()
    study = open_study(folder)
    sources = load_study_sources(study)
    session = StudySession(study, sources, (), SystemClock(), audio=None)
    session.show(windowed=True)
    say("begin")
    session.begin_session(code, "en")
    assert session.runner is not None
    say(f"code {session.runner.plan.code}")
    _participant = Participant(session)
    application.exec()


def be_the_program(folder: str) -> None:
    """Run a program for each line `CODE` on stdin, a new session for an empty one.

    Importing takes longer than a session: it is done once, each program is a fork.
    """
    for line in sys.stdin:
        child = os.fork()
        if not child:
            take_part(Path(folder), line.strip())
            os._exit(0)
        say(f"pid {child}")
        os.waitpid(child, 0)
        say("gone")


if __name__ == "__main__":
    be_the_program(sys.argv[1])
