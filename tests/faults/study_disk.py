"""A session on a disk of its own that fills up or may not be written; see test_study_disk.

Runs in a mount namespace of its own: `python study_disk.py full|read-only FOLDER`.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

from hapticplayer.clock import ManualClock
from hapticplayer.errors import StudyError
from hapticplayer.study.creation import create_study
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_folder import begin_session, open_study
from tests.unit.study.conftest import VALUES
from tests.unit.study.test_runner import Sitting

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


def sit_until_stopped(sitting: Sitting) -> int:
    """Answer trial after trial; return how many answers were accepted."""
    for accepted in range(MOST_TRIALS):
        sitting.runner.proceed()
        if sitting.kind is PageKind.PLAYING:
            sitting.stage.ended = True
            sitting.runner.poll()
        if sitting.kind is PageKind.QUESTIONS:
            sitting.runner.answer(VALUES)
        if sitting.kind is PageKind.PROBLEM:
            return accepted
    return MOST_TRIALS


def full(disk: Path) -> dict:
    """Fill the disk in the middle of a session, then make room again."""
    mount(disk, f"size={SIZE}")
    study = create_study(disk / "study")
    sitting = Sitting(study, ManualClock())
    sitting.to_trials()
    sitting.trial()
    filler = fill(disk)
    accepted = 1 + sit_until_stopped(sitting)
    told = {
        "kind": sitting.kind.value,
        "problem": sitting.runner.problem,
        "accepted": accepted,
        "kept": count(sitting),
        "halts": sitting.stage.halts,
    }
    filler.unlink()
    sitting.runner.retry()
    told["after"] = sitting.kind.value
    sitting.runner.stage.rearm()
    while sitting.kind is not PageKind.THANKS:
        finish(sitting)
    return {**told, "kept_in_the_end": count(sitting)}


def finish(sitting: Sitting) -> None:
    """Do what the page asks for."""
    if sitting.kind is PageKind.READY:
        sitting.runner.proceed()
    elif sitting.kind is PageKind.PLAYING:
        sitting.stage.ended = True
        sitting.runner.poll()
    elif sitting.runner.condition is not None:
        sitting.runner.answer(VALUES)
    else:
        sitting.runner.answer({"tiring": "no"})


def count(sitting: Sitting) -> int:
    """Return for how many trials answers are on the disk, read anew."""
    intact = sitting.records().intact
    steps = {r.content["step"] for r in intact if r.kind == "answers"}
    return sum(step.startswith("trial-") for step in steps)


def read_only(disk: Path) -> dict:
    """Begin a session, and go on with one, where nothing may be written."""
    mount(disk, f"size={SIZE}")
    study = create_study(disk / "study")
    sitting = Sitting(study, ManualClock())
    sitting.to_trials()
    sitting.trial()
    sitting.runner.close()
    mount(disk, "remount,ro")
    study = open_study(disk / "study")
    attempts = {
        "begin": lambda: begin_session(study, "en", {}, ManualClock()),
        "resume": lambda: Sitting(study, ManualClock(), sitting.code),
    }
    told = {}
    for name, attempt in attempts.items():
        try:
            attempt()
        except StudyError as problem:
            told[name] = str(problem)
    return {**told, "kept": count(sitting), "sessions": len(study.codes())}


if __name__ == "__main__":
    scenarios = {"full": full, "read-only": read_only}
    found = scenarios[sys.argv[1]](Path(sys.argv[2]))
    sys.stdout.write(json.dumps(found) + "\n")
