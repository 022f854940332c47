"""A window opens while a thread imports more of it."""

import os
import subprocess
import sys
from pathlib import Path

from hapticplayer.doctor import ROOT

SCRIPT = Path(__file__).with_name("naming_threads.py")


def test_two_threads_may_name_a_class_of_qt_first():
    """It crashed the process in each of four runs."""
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT),
        "QT_QPA_PLATFORM": "offscreen",
    }
    environment.pop("PYSIDE6_OPTION_LAZY", None)
    done = subprocess.run(
        [sys.executable, SCRIPT],
        env=environment,
        capture_output=True,
        check=False,
        text=True,
    )
    assert (done.returncode, done.stdout) == (0, "made\n"), done.stderr
