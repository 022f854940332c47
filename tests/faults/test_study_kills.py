"""A session is killed at any moment: no answer that was accepted is lost.

`benchmarks.study kill` does the same to the window.
"""

import json
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.session_folder import SessionState
from tests.every_kind import with_every_kind

ROOT = Path(__file__).resolve().parents[2]
VICTIM = Path(__file__).with_name("study_victim.py")
KILLS = 40
NEVER = 100  # answers, more than a session takes


@contextmanager
def victim(folder):
    process = subprocess.Popen(
        [sys.executable, str(VICTIM), str(folder)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        text=True,
    )
    yield process
    process.stdin.close()
    assert process.wait(60) == 0
    process.stdout.close()


def run(process, code, answers, delay_s):
    """Run or resume a session that is killed a moment after so many answers.

    Returns:
        Its code if it came that far, the answers that it took, whether it ended.
    """
    taken, has_ended = [], False
    process.stdin.write(f"{code or '-'} {answers} {delay_s}\n")
    process.stdin.flush()
    for line in process.stdout:
        word, _, rest = line.strip().partition(" ")
        if word == "gone":
            break
        if word == "code":
            code = rest
        elif word == "ack":
            taken.append(rest)
        has_ended |= word == "end"
    return code, taken, has_ended


def kept(session):
    return {
        f"{session.code} {record.content['step']} {plain(record.content['values'])}"
        for record in session.records.intact
        if record.kind in ("answers", "answers-before")
    }


def plain(values):
    """Return the values as text, without what was left open."""
    given = {key: value for key, value in values.items() if value is not None}
    return json.dumps(given, sort_keys=True)


def unfinished(study):
    states = {code: study.session(code).state for code in study.codes()}
    found = [code for code, state in states.items() if state is SessionState.UNFINISHED]
    assert len(found) <= 1
    return found[0] if found else ""


def test_no_answer_that_was_accepted_is_lost(tmp_path):
    study, dice = create_study(tmp_path / "study"), np.random.default_rng(25)
    study = change_definition(study, with_every_kind(json.loads(study.content)))
    code, accepted, kills = "", set(), 0
    with victim(study.folder) as process:
        while kills < KILLS or code:
            answers = dice.integers(0, 4) if kills < KILLS else NEVER
            said, taken, has_ended = run(
                process, code, answers, dice.uniform(1e-4, 4e-3)
            )
            kills += not has_ended
            assert not code or said in ("", code)  # a session is always resumed
            accepted |= {f"{said} {text}" for text in taken}
            code = unfinished(study)
    sessions = [study.session(code) for code in study.codes()]
    assert accepted <= set().union(*map(kept, sessions))
    assert len(accepted) > KILLS
    assert {session.state for session in sessions} == {SessionState.COMPLETE}
