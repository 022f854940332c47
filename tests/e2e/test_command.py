"""The command as a process: it ends at once, and in good order."""

import subprocess
import sys

import pytest

BEGIN = """
import atexit, sys
from app import __main__ as program

class Late:
    def __del__(self):
        print("taken apart")

late = Late()

def main():
    atexit.register(print, "tidied")
    {body}

program.main = main
sys.exit(program.command())
"""


def end(body):
    return subprocess.run(
        [sys.executable, "-c", BEGIN.format(body=body)],
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("status", [0, 3])
def test_a_command_tidies_before_it_ends(status):
    done = end(f"print('said', end=''); return {status}")
    assert (done.returncode, done.stdout) == (status, "saidtidied\n")
    assert done.stderr == ""


def test_an_exception_is_reported_as_python_does():
    done = end("raise KeyError('lost')")
    assert done.returncode == 1
    assert "KeyError: 'lost'" in done.stderr
    assert end("raise SystemExit(2)").returncode == 2


def test_a_command_waits_for_its_threads():
    thread = "threading.Timer(0.2, print, ['done']).start()"
    done = end(f"import threading; {thread}; return 0")
    assert (done.returncode, done.stdout) == (0, "done\ntidied\n")


def test_nobody_reads_what_it_says():
    done = end("sys.stdout.close(); return 4")
    assert done.returncode == 4
