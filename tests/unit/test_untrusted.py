"""Files of others are opened in one place, which waits for nobody."""

import ast
import os
import socket
from pathlib import Path

import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import read_template
from hapticplayer.devices.falcon.firmware.store import read_image
from hapticplayer.errors import DeviceError, InputError
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.media.clip_info import probe
from hapticplayer.playback.latency import read_settings
from hapticplayer.playback.replay import read_force_log
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.calibration import read_calibration
from hapticplayer.sequence.library import read_entry
from hapticplayer.study.creation import create_study
from hapticplayer.study.journal import read_journal, refuse_if_open
from hapticplayer.study.study_folder import open_study
from hapticplayer.untrusted import open_regular, read_regular, resolve_regular

ROOT = Path(__file__).resolve().parents[2]


def pipe(path):
    os.mkfifo(path)


def device(path):
    path.symlink_to("/dev/zero")


def terminal(path):
    path.symlink_to("/dev/tty")


def bound_socket(path):
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(str(path))


def loop(path):
    path.symlink_to(path)


SPECIAL = [pipe, device, terminal, bound_socket, Path.mkdir, loop]


@pytest.mark.parametrize("make", SPECIAL)
@pytest.mark.parametrize("take", [open_regular, resolve_regular])
def test_a_file_that_is_not_regular_is_refused_at_once(
    tmp_path, monkeypatch, make, take
):
    monkeypatch.chdir(tmp_path)
    path = Path("given")
    make(path)
    with pytest.raises(InputError, match=r"^given: (is a|cannot be reached)"):
        take(path)


def test_a_file_that_becomes_a_pipe_before_it_opens_is_refused(tmp_path, monkeypatch):
    path, stat = tmp_path / "given", Path.stat
    path.write_bytes(b"content")

    def then_replaced(self, **options):
        found = stat(self, **options)
        path.unlink()
        os.mkfifo(path)
        return found

    monkeypatch.setattr(Path, "stat", then_replaced)
    with pytest.raises(InputError, match="is a pipe"):
        open_regular(path)


def test_a_small_file_is_read_up_to_its_limit(tmp_path):
    path = tmp_path / "given"
    path.write_bytes(b"12345")
    assert read_regular(path, 5) == b"12345"
    with pytest.raises(InputError, match="is too large"):
        read_regular(path, 4)


@pytest.mark.parametrize("make", [pipe, device])
@pytest.mark.parametrize(
    "take",
    [
        probe,
        read_recording,
        read_template,
        read_calibration,
        read_image,
        RecordReader,
        read_force_log,
        read_journal,
    ],
)
def test_readers_of_files_refuse_them(tmp_path, make, take):
    make(tmp_path / "given")
    with pytest.raises((InputError, DeviceError), match=r"is a (pipe|device)"):
        take(tmp_path / "given")


@pytest.mark.parametrize("make", [pipe, device])
def test_settings_that_are_no_file_are_none(tmp_path, make):
    make(tmp_path / "given")
    assert read_settings(tmp_path / "given") == {}


def replaced(path, make):
    path.unlink()
    make(path)


@pytest.mark.parametrize("make", [pipe, device])
@pytest.mark.parametrize("name", ["sequence.json", "motion.npz", "force_random.npz"])
def test_a_sequence_of_special_files_is_refused(sequence_folder, make, name):
    replaced(sequence_folder / name, make)
    with pytest.raises(InputError, match=name):
        open_sequence(sequence_folder)


@pytest.mark.parametrize("make", [pipe, device])
def test_the_library_names_a_special_description(sequence_folder, make):
    replaced(sequence_folder / "sequence.json", make)
    assert "is a " in read_entry(sequence_folder).problem


@pytest.mark.parametrize("make", [pipe, device])
def test_a_study_of_special_files_is_refused(tmp_path, make):
    folder = create_study(tmp_path / "study").folder
    replaced(folder / "study.json", make)
    with pytest.raises(InputError, match=r"is a (pipe|device)"):
        open_study(folder)


def test_a_pipe_in_place_of_answers_locks_nobody(tmp_path):
    os.mkfifo(tmp_path / "answers.jsonl")
    refuse_if_open(tmp_path / "answers.jsonl")


OWN = {
    ("hapticplayer/untrusted.py", "os.open"): "the one place",
    ("hapticplayer/untrusted.py", "open"): "the same, with the name of the file",
    ("hapticplayer/doctor.py", "read_text"): "files of the program and the system",
    ("hapticplayer/extension.py", "read_text"): "files of installed packages",
    ("hapticplayer/extras/desktop/command.py", "read_text"): "files of the program",
    ("hapticplayer/study/creation.py", "read_text"): "templates of the program",
    ("hapticplayer/study/analysis/report.py", "read_bytes"): "written just before",
    ("hapticplayer/study/analysis/preregistered.py", "read_bytes"): "its own source",
    ("hapticplayer/linux.py", "os.open"): "a device, to hold it",
    ("hapticplayer/devices/joystick.py", "os.open"): "a device",
    ("hapticplayer/devices/serial_line.py", "os.open"): "a serial port",
    ("hapticplayer/media/camera_modes.py", "os.open"): "a camera, to ask its driver",
    ("hapticplayer/haptics/records.py", "os.open"): "a new file",
    ("app/player/problem_report.py", "ZipFile"): "a new file",
    ("hapticplayer/media/live_input.py", "open"): "a camera or microphone",
    ("hapticplayer/media/opening.py", "open"): "by its resolved name",
    ("hapticplayer/media/opening.py", "read_text"): "a file of the system",
    ("hapticplayer/media/clip_bytes.py", "open"): "a file of the system",
    ("hapticplayer/storage.py", "os.open"): "to sync, to lock, and new files",
    ("hapticplayer/study/journal.py", "os.open"): "to append, and to lock",
    ("hapticplayer/extras/wheels/ports.py", "os.open"): "a device",
    ("hapticplayer/extras/wheels/ports.py", "read_text"): "files of the system",
    ("hapticplayer/extras/shakers/coils.py", "read_text"): "files of the system",
}
READERS = {"open", "os.open", "io.open", "np.load", "np.loadtxt", "np.fromfile"}
READING_METHODS = {
    "copyfile",
    "copytree",
    "read_text",
    "read_bytes",
    "ZipFile",
    "genfromtxt",
    "memmap",
}


def opened_by(call):
    """Return how a call opens a file for reading, "" if it does not."""
    name, last = ast.unparse(call.func), getattr(call.func, "attr", "")
    given = ast.unparse(call.args[0]) if call.args else ""
    # it is open already, or holds nothing
    if given in ("reader", "os.devnull") or given.startswith("io.BytesIO("):
        return ""
    if name in READERS or last in READING_METHODS:
        return name if name in READERS else last
    modes = [
        ast.unparse(one) for one in (*call.args, *(k.value for k in call.keywords))
    ]
    is_reading = "'rb'" in modes or "'r'" in modes
    is_text = [k.arg for k in call.keywords] == ["encoding"] and not call.args
    return "open" if last == "open" and (is_reading or is_text) else ""


def test_no_other_place_opens_files_for_reading():
    found = set()
    for folder in ("hapticplayer", "app"):
        for path in (ROOT / folder).rglob("*.py"):
            calls = (
                node
                for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
                if isinstance(node, ast.Call)
            )
            name = str(path.relative_to(ROOT))
            found |= {(name, how) for call in calls if (how := opened_by(call))}
    assert found == {one for one in OWN if (ROOT / one[0]).is_file()}
