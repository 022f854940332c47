"""Sessions that answer by themselves and die meanwhile; see test_study_kills.

Each line `CODE ANSWERS DELAY_S` on stdin (code "-" for a new session) is run in a fork
that the kernel kills so long after so many answers. It says its code, `ack STEP VALUES`
for each answer that was accepted, and `end`.
"""

import json
import os
import signal
import sys
from pathlib import Path

import numpy as np

from hapticplayer.clock import SystemClock
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_folder import open_study
from tests.every_kind import drawn
from tests.unit.study.test_runner import RunningSession


def say(text: str) -> None:
    os.write(1, f"{text}\n".encode())


def answer(running: RunningSession) -> None:
    """Answer a page with values that tell which it is."""
    page, runner = running.runner.page, running.runner
    values = drawn(page, np.random.default_rng([os.getpid(), page.number]))
    answered = f"{runner.step} {json.dumps(values, sort_keys=True)}"
    runner.answer(values)
    say(f"ack {answered}")


def run(folder: Path, code: str, answers: int, delay_s: float) -> None:
    """Run or resume a session. The default action of SIGALRM ends a process at once."""
    running, given = RunningSession(open_study(folder), SystemClock(), code), 0
    say(f"code {running.code}")
    while running.kind is not PageKind.THANKS:
        if given >= answers and not signal.getitimer(signal.ITIMER_REAL)[0]:
            signal.setitimer(signal.ITIMER_REAL, delay_s)
        if running.kind is PageKind.CONSENT:
            running.runner.consent(given=True)
        elif running.kind is PageKind.QUESTIONS:
            answer(running)
            given += 1
        elif running.kind is PageKind.PLAYING:
            running.stage.ended = True
            running.runner.poll()
        else:
            running.runner.stage.rearm()
            running.runner.proceed()
    say("end")


if __name__ == "__main__":
    for line in sys.stdin:
        code, answers, delay_s = line.split()
        child = os.fork()
        if not child:
            run(Path(sys.argv[1]), code.strip("-"), int(answers), float(delay_s))
            os._exit(0)
        os.waitpid(child, 0)
        say("gone")
