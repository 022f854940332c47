"""The command `hapticplayer` in this process or in one of its own, and what it says."""

import io
import json
import os
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.doctor import ROOT

DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")


def hapticplayer(*arguments, env=None):
    """Run a command here, where there is no display; what it raises is raised."""
    words, out, err = list(map(str, arguments)), io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), pytest.MonkeyPatch.context() as p:
        for name, value in (env or {}).items():
            p.setenv(name, value)
        status = cli.main(words)
    return subprocess.CompletedProcess(words, status, out.getvalue(), err.getvalue())


def command_line(*arguments):
    return [sys.executable, "-m", "app", *map(str, arguments)]


def in_process(*arguments, env=None, timeout=300):
    """Run a command as a user does where there is no display."""
    given = {name: value for name, value in os.environ.items() if name not in DISPLAYS}
    return subprocess.run(
        command_line(*arguments),
        capture_output=True,
        text=True,
        timeout=timeout,
        check=False,
        env={**given, **(env or {})},
        cwd=ROOT,
    )


def started(*arguments, **options):
    """Start a command whose stderr is read, and leave it running."""
    options = {"stderr": subprocess.PIPE, "text": True, "cwd": ROOT, **options}
    return subprocess.Popen(command_line(*arguments), **options)


def read_log(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def played(log, *arguments, follows_s=1.0):
    """Play until the force could follow its track for so long; return the log.

    A busy machine lets it ramp down, or shows too few frames to feel anything.
    """
    for _ in range(5):
        words = ("--headless", "--log", log, "--overwrite")
        done = in_process("play", *arguments, *words)
        assert done.returncode == 0, done.stderr
        lines = read_log(log)
        if len(followed(lines)[0]) > 1e3 * follows_s:
            break
    return lines


def forces_of(lines):
    """Return monotonic and media times (n,) and forces (n, 3) of a log."""
    forces = [line for line in lines if line["kind"] == "force"]
    times = [[line["monotonic_s"], line["media_s"]] for line in forces]
    return *np.reshape(times, (-1, 2)).T, np.array([line["force_n"] for line in forces])


def followed(lines):
    """Return media times and forces of the ticks in which the force followed its track."""
    time_s, media_s, force_n = forces_of(lines)
    follows = np.zeros(len(time_s), bool)
    for line in lines:
        if line["kind"] == "event" and ("cause" in line or line["name"] == "stop"):
            begins = line["name"] == "force_following"
            # the tick of an end is not followed any more
            follows[time_s >= line["monotonic_s"] - 0.002 * (not begins)] = begins
    return media_s[follows], force_n[follows]


def report_of(done):
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def refused(done, status=1):
    """Return the one sentence with which a command was refused."""
    assert done.returncode == status
    assert "Traceback" not in done.stderr
    complaint = [x for x in done.stderr.splitlines() if x.startswith("hapticplayer:")]
    assert len(complaint) == 1
    return complaint[0]
