"""Nothing that exists is overwritten, but a file of ours where that is asked for."""

import os
import re

import pytest

from hapticplayer import cli
from hapticplayer.capture.si_csv import write_imu_csv
from tests.e2e.command import hapticplayer, refused
from tests.needed_extras import needs

WRITERS = [
    "log",
    "record",
    "template",
    "plot.png",
    "plot.svg",
    "export.csv",
]
FOREIGN = {
    "text": lambda path: path.write_text("dear"),
    "another log": lambda path: path.write_text('{"kind": "header"}\n'),
    "table": lambda path: path.write_text("tick,price\n1,2\n"),
    "settings": lambda path: path.write_text('{"axes": "x,y,z", "user": "root"}'),
    "empty": lambda path: path.write_bytes(b""),
    "pipe": os.mkfifo,
    "folder": lambda path: path.mkdir(),
    "dead link": lambda path: path.symlink_to("nowhere"),
    "device": lambda path: path.symlink_to("/dev/null"),
}


@pytest.fixture(scope="module")
def record(clip, tmp_path_factory):
    path = tmp_path_factory.mktemp("record") / "ride"
    done = hapticplayer("play", clip, "--headless", "--duration", 0.3, "--record", path)
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture
def write(clip, still_log, record, tmp_path):
    """Return what runs a command that writes to a path."""
    log = tmp_path / "log.csv"
    write_imu_csv(log, still_log)
    play = ("play", clip, "--headless", "--duration", 0.2)
    commands = {
        "log": (*play, "--device", "none", "--log"),
        "record": (*play, "--record"),
        "template": ("process", log, "--read-as", "axes=x,y,z", "--save-template"),
        "calibration": ("process", log, "--save-calibration"),
        "plot.png": ("process", log, "--plot"),
        "plot.svg": ("process", log, "--plot"),
        "export.csv": ("export", record, "-o"),
    }
    return lambda name, path, *more: hapticplayer(*commands[name], path, *more)


def state_of(path):
    found = path.lstat()
    content = path.read_bytes() if path.is_file() and not path.is_symlink() else b""
    return found.st_ino, found.st_mode, found.st_mtime_ns, content


@pytest.mark.parametrize("foreign", FOREIGN)
@pytest.mark.parametrize("name", WRITERS)
def test_files_of_others_are_never_overwritten(tmp_path, write, name, foreign):
    path = tmp_path / f"target.{name}"
    FOREIGN[foreign](path)
    before = state_of(path)
    assert "already exists" in refused(write(name, path))
    refused(write(name, path, "--overwrite"))
    assert state_of(path) == before
    assert sorted(p.name for p in tmp_path.iterdir()) == ["log.csv", path.name]


@pytest.mark.parametrize("name", WRITERS)
def test_files_of_ours_are_overwritten_where_asked_for(tmp_path, write, name):
    path = tmp_path / f"target.{name}"
    assert write(name, path).returncode == 0
    first = state_of(path)
    assert "--overwrite" in refused(write(name, path))
    assert state_of(path) == first
    assert write(name, path, "--overwrite").returncode == 0
    assert state_of(path)[0] != first[0] or state_of(path)[2] != first[2]


@pytest.mark.parametrize("name", WRITERS)
def test_one_kind_does_not_overwrite_another(tmp_path, write, name):
    other = "template" if name == "log" else "log"
    path = tmp_path / f"target.{name}"
    assert write(other, path).returncode == 0
    before = state_of(path)
    refused(write(name, path, "--overwrite"))
    assert state_of(path) == before


WORDS = [
    *((command.name,) for command in cli.commands()),
    pytest.param(("device", "measure"), marks=needs("measuring")),
]
FILE_OPTION = re.compile(
    r"--(log|record|save-template|save-calibration|plot|output) FILE\b|^  B  ",
    re.MULTILINE,
)


@pytest.mark.parametrize("words", WORDS, ids=" ".join)
def test_every_command_that_writes_a_file_has_the_option(words):
    said = hapticplayer(*words, "--help").stdout
    assert bool(FILE_OPTION.search(said)) == ("--overwrite" in said)
