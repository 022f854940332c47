"""Work in a process of its own: its result, its refusals, its end from outside."""

import os
import signal
import subprocess
import sys

import pytest

from app.bridge.jobs import in_child
from hapticplayer import storage
from hapticplayer.errors import Cancelled, HapticPlayerError, InputError
from hapticplayer.linux import SWITCH

pytestmark = pytest.mark.usefixtures("real_children")


def repeated(words, *, progress, times=1):
    progress(0.5, "half")
    return words * times, os.getpid()


def refusing(*, progress):
    raise InputError("is odd", where="here", remedy="make it even")


def dying(*, progress):
    os.kill(os.getpid(), signal.SIGKILL)


def interrupted(*, progress):
    os.kill(os.getpid(), signal.SIGINT)
    progress(1.0, "still here")
    return "done"


def writing(target, *, progress):
    with storage.folder_written_aside(target) as aside:
        (aside / "part").write_text("half")
        while True:
            progress(0.5, "writing")


def test_the_result_comes_from_a_process_of_lower_priority(real_children):
    steps = []
    words, pid = in_child(
        repeated, "a", progress=lambda *step: steps.append(step), times=3
    )
    assert words == "aaa"
    assert pid != os.getpid()
    assert real_children == [pid]
    assert (0.5, "half") in steps


def test_a_child_is_as_urgent_without_the_idle_class(real_children, monkeypatch):
    monkeypatch.setenv(SWITCH, "idle")
    assert in_child(repeated, "a", progress=lambda *_: None)[0] == "a"
    assert real_children == []


def test_a_refusal_is_raised_here_with_its_words():
    with pytest.raises(InputError, match="here: is odd; make it even"):
        in_child(refusing, progress=lambda *_: None)


def test_a_child_that_is_killed_is_an_error_with_words():
    with pytest.raises(HapticPlayerError, match=r"was killed.*-9"):
        in_child(dying, progress=lambda *_: None)


def test_a_child_leaves_ctrl_c_to_the_window():
    assert in_child(interrupted, progress=lambda *_: None) == "done"


FIRST = """
import os, signal
from app.bridge.jobs import in_child

def interrupted(*, progress):
    os.kill(os.getpid(), signal.SIGINT)
    return "done"

if __name__ == "__main__":
    assert in_child(interrupted, progress=lambda *_: None) == "done"
"""


def test_the_first_child_of_a_program_does_so_too(tmp_path):
    script = tmp_path / "first.py"
    script.write_text(FIRST)
    ended = subprocess.run(
        [sys.executable, script],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (ended.returncode, ended.stderr) == (0, "")
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, [])


def test_a_cancelled_child_tidies_up_before_it_ends(tmp_path):
    def stop(fraction, step):
        if step == "writing":
            raise Cancelled

    with pytest.raises(Cancelled):
        in_child(writing, tmp_path / "sequence", progress=stop)
    assert list(tmp_path.iterdir()) == []
