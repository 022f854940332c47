"""Titles and names that a terminal cannot show, or would take for commands."""

import json
import os

import pytest

from hapticplayer.capture.si_csv import write_imu_csv
from tests.e2e.command import hapticplayer, in_process, refused

TITLE = "a\ud800\x1b[2J\r\n\x9bü\x7f"
ASCII = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}


@pytest.fixture
def hostile(sequence_folder):
    """A sequence with such a title."""
    path = sequence_folder / "sequence.json"
    description = {**json.loads(path.read_text()), "title": TITLE}
    path.write_text(json.dumps(description))
    return sequence_folder


@pytest.mark.parametrize(
    ("env", "shown"),
    [(ASCII, r"a\ud800?[2J???\xfc?"), ({"LC_ALL": "C.UTF-8"}, r"a\ud800?[2J???ü?")],
)
def test_a_title_is_shown_on_any_terminal(hostile, env, shown):
    done = in_process("play", hostile, "--headless", "--start", 99, env=env)
    assert f"--start 99 is after the end of {shown} (" in refused(done, status=2)
    quiet = ("--headless", "--mute", "--device", "none", "--duration", 0.1)
    done = in_process("play", hostile, *quiet, env=env)
    assert done.stdout.startswith(f"{shown} - feedback realistic")


def test_names_of_files_hold_no_commands(still_log, tmp_path):
    log = tmp_path / "l\x1b]0;x\x07.csv"
    write_imu_csv(log, still_log)
    for words in (("process", log), ("process", f"{log}x"), ("process", log, log)):
        done = hapticplayer(*map(os.fspath, words))
        assert "?]0;x?" in done.stdout + done.stderr
        assert not set("\x1b\x07") & set(done.stdout + done.stderr)
