"""A session is recorded by LabRecorder, or its trials do not begin."""

import re
import socket
from contextlib import suppress
from pathlib import Path
from threading import Thread

import pytest

from hapticplayer.errors import StudyError
from hapticplayer.extras.research.lsl import LslStreams
from hapticplayer.extras.research.recorder import LabRecorder
from hapticplayer.study.creation import create_study
from hapticplayer.study.streams import Wanted
from hapticplayer.study.study_folder import begin_session

FIELD = re.compile(r"\{(\w+?):([^}]*)\}")
PLACEHOLDERS = {"%p": "participant", "%b": "task", "%n": "run"}


class FakeLabRecorder(Thread):
    """What LabRecorder does with lines, as its source says.

    It reads one line of what has arrived, answers "OK" without an end of line, and
    writes its template in lower case.
    """

    def __init__(self, *, is_busy=False):
        super().__init__(daemon=True)
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.lines, self.fields, self.is_busy = [], {}, is_busy
        self.wire = None

    def run(self):
        with suppress(OSError):
            self.wire, _ = self.server.accept()
            with self.wire:
                while arrived := self.wire.recv(4096):
                    self.handle(arrived.decode().splitlines()[0])
                    self.wire.sendall(b"OK")

    def handle(self, line):
        self.lines.append(line)
        if line.startswith("filename"):
            self.fields = dict(FIELD.findall(line))
        if line == "start" and not self.is_busy:
            self.path.write_bytes(b"XDF:")

    @property
    def path(self):
        name = self.fields["template"].lower()
        for placeholder, field in PLACEHOLDERS.items():
            value = self.fields[field]
            name = name.replace(placeholder, value.zfill(3 * (field == "run")))
        return Path(self.fields["root"]) / name

    def quit(self):
        self.wire.shutdown(socket.SHUT_RDWR)


@pytest.fixture
def lab(request):
    made = FakeLabRecorder(is_busy=getattr(request, "param", False))
    made.start()
    yield made
    made.server.close()
    made.join(5.0)


@pytest.fixture
def session(tmp_path, manual_clock):
    study = create_study(tmp_path / "study")
    return begin_session(study, "en", {}, manual_clock)


def begun(lab, session):
    recorder = LabRecorder(lab.port)
    recorder.begin(session)
    recorder.starting.join()
    return recorder


def test_a_session_is_recorded_in_its_folder_by_a_bids_name(lab, session):
    recorder = begun(lab, session)
    recorder.check()
    name = f"sub-{session.code}_task-qoe_run-001_beh.xdf"
    assert (session.folder / name).is_file()
    assert lab.lines[:2] == ["update", "select all"]
    recorder.close()
    assert lab.lines[3:] == ["start", "stop"]


def test_trials_wait_until_the_recording_has_begun(lab):
    recorder = LabRecorder(lab.port)
    with pytest.raises(StudyError, match="still starting"):
        recorder.check()
    recorder.close()


@pytest.mark.parametrize("lab", [True], indirect=True)
def test_a_recorder_that_is_busy_refuses_trials(lab, session):
    recorder = begun(lab, session)
    with pytest.raises(StudyError, match="has not begun its file"):
        recorder.check()
    recorder.close()


def test_a_recorder_that_was_closed_refuses_trials(lab, session):
    recorder = begun(lab, session)
    lab.quit()
    lab.join(5.0)
    with pytest.raises(StudyError, match="was closed"):
        recorder.check()
    recorder.close()


def test_a_session_without_labrecorder_does_not_open():
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with pytest.raises(StudyError, match="LabRecorder does not answer at port"):
        LabRecorder(port)


def test_a_missing_stream_refuses_trials_until_it_is_there():
    pylsl = pytest.importorskip("pylsl", exc_type=(ImportError, RuntimeError))
    streams = LslStreams(Wanted(("amplifier",)))
    with pytest.raises(StudyError, match="not on this computer: amplifier"):
        streams.check()
    info = pylsl.StreamInfo("amplifier", "EEG", 1, 0.0, pylsl.cf_float32, "amp")
    amplifier = pylsl.StreamOutlet(info)
    if not pylsl.resolve_byprop("name", "amplifier", timeout=10.0):
        pytest.skip("streams cannot be found on this machine's loopback")
    for _ in range(200):  # the resolver asks every half second or so
        if "amplifier" in streams.names_found():
            break
        pylsl.resolve_byprop("name", "nobody", timeout=0.05)
    streams.check()
    streams.close()
    del amplifier
