"""Short forms of some benchmarks: their targets hold in every run of the tests."""

import os
import subprocess
import sys

import pytest

from hapticplayer.doctor import ROOT

COMMANDS = {
    "nuisance": ["robustness", "nuisance", "--quick"],
}


@pytest.mark.realtime
@pytest.mark.parametrize("name", COMMANDS)
def test_the_short_form_meets_its_targets(name):
    command = [sys.executable, "-m", "benchmarks." + COMMANDS[name][0]]
    done = subprocess.run(
        [*command, *COMMANDS[name][1:]],
        cwd=ROOT,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    assert "target met" in done.stdout
