"""A session on a disk of its own that fills up or may not be written; see test_study_disk.

Runs in a mount namespace of its own: `python study_disk.py full|read-only FOLDER`.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

from hapticplayer.clock import ManualClock
from hapticplayer.errors import InputError
from hapticplayer.study.creation import create_study
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_folder import begin_session, open_study
from tests.unit.study.conftest import VALUES
from tests.unit.study.test_runner import RunningSession

MOST_TRIALS = 12
SIZE = "256k"


def mount(folder: Path, options: str) -> None:
    """Put a small disk there, or change the one that is."""
    command = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(folder)]
    subprocess.run(command, check=True)


def fill(disk: Path) -> Path:
    """Leave no free block."""
    filler = disk / "filler"
    descriptor = os.open(filler, os.O_WRONLY | os.O_CREAT)
    try:
        while os.write(descriptor, bytes(4096)):
            pass
    except OSError:
        pass
    finally:
        os.close(descriptor)
    return filler


def answer_until_stopped(running: RunningSession) -> int:
    """Answer trial after trial; return how many answers were accepted."""
    for accepted in range(MOST_TRIALS):
        running.runner.proceed()
        if running.kind is PageKind.PLAYING:
            running.stage.ended = True
            running.runner.poll()
        if running.kind is PageKind.QUESTIONS:
            running.runner.answer(VALUES)
        if running.kind is PageKind.PROBLEM:
            return accepted
    return MOST_TRIALS


def full(disk: Path) -> dict:
    """Fill the disk in the middle of a session, then make room again."""
    mount(disk, f"size={SIZE}")
    study = create_study(disk / "study")
    running = RunningSession(study, ManualClock())
    running.to_trials()
    running.trial()
    filler = fill(disk)
    accepted = 1 + answer_until_stopped(running)
    found = {
        "kind": running.kind.value,
        "problem": running.runner.problem,
        "accepted": accepted,
        "kept": count(running),
        "interrupts": running.stage.interrupts,
    }
    filler.unlink()
    running.runner.retry()
    found["after"] = running.kind.value
    while running.kind is not PageKind.THANKS:
        finish(running)
    return {**found, "kept_in_the_end": count(running)}


def finish(running: RunningSession) -> None:
    """Do what the page asks for."""
    if running.kind is PageKind.READY:
        running.runner.proceed()
    elif running.kind is PageKind.PLAYING:
        running.stage.ended = True
        running.runner.poll()
    elif running.runner.condition is not None:
        running.runner.answer(VALUES)
    else:
        running.runner.answer({"tiring": "no"})


def count(running: RunningSession) -> int:
    """Return for how many trials answers are on the disk, read again."""
    intact = running.records().intact
    steps = {r.content["step"] for r in intact if r.kind == "answers"}
    return sum(step.startswith("trial-") for step in steps)


def read_only(disk: Path) -> dict:
    """Begin a session, and go on with one, where nothing may be written."""
    mount(disk, f"size={SIZE}")
    study = create_study(disk / "study")
    running = RunningSession(study, ManualClock())
    running.to_trials()
    running.trial()
    running.runner.close()
    mount(disk, "remount,ro")
    study = open_study(disk / "study")
    attempts = {
        "begin": lambda: begin_session(study, "en", {}, ManualClock()),
        "resume": lambda: RunningSession(study, ManualClock(), running.code),
    }
    found = {}
    for name, attempt in attempts.items():
        try:
            attempt()
        except InputError as problem:
            found[name] = str(problem)
    return {**found, "kept": count(running), "sessions": len(study.codes())}


if __name__ == "__main__":
    scenarios = {"full": full, "read-only": read_only}
    found = scenarios[sys.argv[1]](Path(sys.argv[2]))
    sys.stdout.write(json.dumps(found) + "\n")
