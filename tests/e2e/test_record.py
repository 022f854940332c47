"""The command `record` and what `import` makes of its folder."""

import signal
import subprocess
import sys

import pytest

from hapticplayer.capture.recorded import parts_of, read_take
from hapticplayer.media.clip_info import probe
from hapticplayer.sequence import open_sequence
from tests.e2e.command import hapticplayer, in_process, refused, started
from tests.material import recording

pytestmark = pytest.mark.realtime
CAMERA = recording.camera("160x120")


@pytest.fixture
def board():
    made = recording.Board()
    yield made
    made.unplug()


def test_a_recording_is_imported_without_a_question(tmp_path, board):
    take, words = tmp_path / "take", ("--imu", board.source, "--duration", "1.5")
    done = hapticplayer("record", "-o", take, "--camera", CAMERA, *words)
    assert done.returncode == 0, done.stderr
    assert f"hapticplayer import {take} -o SEQUENCE" in done.stdout
    assert "clock of the IMU:" in done.stdout
    done = hapticplayer("import", take, "-o", tmp_path / "ride")
    assert done.returncode == 0, done.stderr
    sequence = open_sequence(tmp_path / "ride")
    assert sequence.duration_s == pytest.approx(1.5, abs=0.3)
    made_of = sequence.description.provenance
    assert made_of["synchronisation"]["method"] == "embedded"
    assert made_of["recording"]["imu"]["name"] == board.source


def test_enter_marks_and_interrupt_ends_as_the_duration_does(tmp_path):
    take = tmp_path / "take"
    words = ("record", "-o", take, "--camera", CAMERA)
    running = started(*words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    running.stdin.write("\n")
    running.stdin.flush()
    while "marked at" not in running.stderr.readline():
        assert running.poll() is None
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=10)
    assert running.returncode == 0, err
    assert "--suggest-motion" in out
    found = read_take(take)
    assert found.is_finished
    assert len(found.marks_s) == 1


def test_a_full_disk_is_told_and_what_fitted_is_imported(tmp_path, board):
    take = tmp_path / "take"
    line = [sys.executable, "-m", "app", "record", "-o", str(take), "--duration", "3"]
    line += ["--camera", recording.camera("640x480"), "--imu", board.source]
    limited = ["bash", "-c", 'ulimit -f 300; exec "$@"', "bash", *line]
    done = subprocess.run(
        limited, capture_output=True, text=True, timeout=30, check=False
    )
    assert done.returncode == 1
    assert "larger than a file on the disk" in done.stderr
    assert "Traceback" not in done.stderr
    assert probe(parts_of(take).clip).duration_s > 0.2


def test_a_killed_recorder_loses_at_most_a_second(tmp_path):
    kill = recording.killed(tmp_path / "take", 1.2)
    assert not kill.problem
    assert kill.film_lost_s < 1.0
    assert kill.motion_lost_s < 1.0


def test_the_list_names_sources_and_devices():
    done = in_process("record", "--list")
    assert done.returncode == 0
    assert "wt901:/dev/ttyUSB0" in done.stdout
    assert "/dev/video" in done.stdout


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ((), "-o DIR"),
        (("-o", "take"), "nothing is recorded"),
        (("-o", "take", "--imu", "nonsense:x"), "'nonsense' not found"),
    ],
)
def test_a_recording_of_nothing_is_refused(tmp_path, monkeypatch, words, sentence):
    monkeypatch.chdir(tmp_path)
    assert sentence in refused(hapticplayer("record", *words), status=2)
    assert not (tmp_path / "take").exists()
