"""A new format or method is one line in its list and one module: this one."""

import numpy as np
import pytest

from hapticplayer.capture import formats, read_recording, synchronize
from hapticplayer.capture.choices import LogChoices, parse_choices
from hapticplayer.capture.formats import Confidence, Reader, RecordingFormat
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.sync import methods
from hapticplayer.capture.sync.methods import SyncMethod
from hapticplayer.capture.sync.result import Synchronisation, SyncInput
from hapticplayer.cli import main
from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ClockMap, ImuLog

IMU = ImuLog(np.arange(9) / 100.0, np.tile([0.0, 0.0, 9.8], (9, 1)), np.zeros((9, 3)))
FORMAT = RecordingFormat("dummy", Message("Dummy logger"), f"{__name__}:READER")
METHOD = SyncMethod("dummy", Message("a dummy method"), f"{__name__}:by_guess")


def recognises(source: LogSource) -> Confidence:
    is_own = source.first_line(source.names[0]) == "dummy"
    return Confidence.CERTAIN if is_own else Confidence.NO


def read(_source: LogSource, _choices: LogChoices) -> Recording:
    return Recording(IMU, ClockMap(confidence=0.0), "dummy camera")


READER = Reader(recognises, read)


def by_guess(_inputs: SyncInput) -> Synchronisation:
    return Synchronisation(ClockMap(7.0), "dummy")


@pytest.fixture
def lists(monkeypatch):
    monkeypatch.setattr(formats, "FORMATS", (*formats.FORMATS, FORMAT))
    monkeypatch.setattr(methods, "SYNC_METHODS", (*methods.SYNC_METHODS, METHOD))


@pytest.mark.usefixtures("lists")
@pytest.mark.parametrize("command", ["import", "sync"])
def test_help_shows_a_new_entry(command, capsys):
    assert main([command, "--help"]) == 0
    assert "dummy: a dummy method" in " ".join(capsys.readouterr().out.split())


@pytest.mark.usefixtures("lists")
def test_a_new_format_is_recognised_and_chosen(tmp_path):
    path = tmp_path / "log.txt"
    path.write_text("dummy\n")
    assert read_recording(path).camera == "dummy camera"
    assert read_recording(path, parse_choices(["format=dummy"])).camera
    with pytest.raises(UsageError, match="csv, dummy"):
        read_recording(path, parse_choices(["format=nonsense"]))


@pytest.mark.usefixtures("lists")
def test_a_new_method_synchronises():
    found = synchronize(IMU, method="dummy")
    assert (found.method, found.clock_map.offset_s) == ("dummy", 7.0)
    with pytest.raises(UsageError, match="offset, dummy"):
        synchronize(IMU, method="nonsense")


def test_every_entry_has_its_function():
    assert all(isinstance(one.reader(), Reader) for one in formats.recording_formats())
    assert all(callable(one.function()) for one in methods.sync_methods())
