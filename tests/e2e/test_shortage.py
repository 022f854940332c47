"""Outputs that cannot be written, small limits, Ctrl-C while modules are loaded."""

import resource
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.doctor import ROOT
from tests.e2e.command import command_line, refused

INTERRUPTING = """
import os, signal, sys
from app.__main__ import command

module = sys.argv.pop(1)

def interrupt(event, about):
    if event == "import" and about[0] == module:
        os.kill(os.getpid(), signal.SIGINT)

sys.addaudithook(interrupt)
sys.exit(command())
"""


@pytest.fixture
def log(still_log, tmp_path):
    path = tmp_path / "log.csv"
    write_imu_csv(path, still_log)
    return path


def run(words, before=None, **streams):
    """Run a command in a process that has called `before`."""
    return subprocess.run(
        words,
        stdin=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
        cwd=ROOT,
        timeout=300,
        preexec_fn=before,
        **{"stdout": subprocess.DEVNULL, **streams},
    )


@pytest.mark.parametrize("words", [["--help"], ["device", "list"], ["process"]])
def test_a_full_or_closed_output_is_said_in_one_sentence(log, words):
    words = command_line(*words, *([log] if words == ["process"] else []))
    with Path("/dev/full").open("w") as full:
        sentence = refused(run(words, stdout=full))
    assert "the output cannot be written (No space left on device)" in sentence
    closed = run(["sh", "-c", 'exec "$@" >&-', "sh", *words])
    assert "the standard output is closed" in refused(closed)


def test_small_limits_are_said_in_one_sentence(log):
    for kind, limits in (
        (resource.RLIMIT_AS, [n << 20 for n in (25, 50, 75, 100, 150, 200, 300, 400, 600, 900)]),
        (resource.RLIMIT_NOFILE, [5, 6, 7, 8, 10, 12, 16, 24, 32, 48]),
    ):  # fmt: skip
        for limit in limits:
            done = run(
                command_line("process", log),
                lambda kind=kind, limit=limit: resource.setrlimit(kind, (limit, limit)),
            )
            sentence = refused(done)
            assert "limited to" in sentence
            assert done.stderr.count("\n") == 1


def test_a_short_log_fits_in_3_gb_of_address_space(log):
    limit = 3_000_000 << 10
    done = run(
        command_line("process", log),
        lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "module", ["argparse", "hapticplayer.cli", "numpy", "hapticplayer.cli.common",
               "hapticplayer.cli.plots", "scipy"]
)  # fmt: skip
def test_ctrl_c_while_modules_are_loaded_has_status_130(log, module):
    words = [sys.executable, "-c", INTERRUPTING, module, "process", log]
    done = run(words, lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
    assert done.returncode == 130
    assert done.stderr.count("hapticplayer: interrupted") == 1
    assert "Traceback" not in done.stderr
