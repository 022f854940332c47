"""The recorder: it keeps every tick, whoever dies, and says when it cannot."""

import json
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.errors import InputError
from hapticplayer.haptics.record_reader import read_record
from hapticplayer.haptics.recorder import (
    SYNC_PERIOD_S,
    LoopRecording,
    Status,
    TickRecorder,
)
from hapticplayer.haptics.records import RecordWriter, open_record
from hapticplayer.haptics.shared import BLOCK_BYTES, RING_TICKS, SharedBlock
from hapticplayer.linux import anonymous_memory

HERE = Path(__file__).parent
PATIENCE_S = 30.0


class Ring:
    """What a loop would write: ticks that tell their number."""

    def __init__(self):
        self.descriptor = anonymous_memory("test", BLOCK_BYTES)
        self.block = SharedBlock(self.descriptor)
        self.count = 0

    def tick(self, count=1, mode=2):
        for _ in range(count):
            x = float(self.count)
            floats = [x / 2.0, *[x + 0.5] * 15, 1e-5, 0.001, 1.5]
            self.block.write_tick(self.count, x, *floats, 0, mode, 0, 0)
            self.count += 1


@pytest.fixture
def ring():
    made = Ring()
    yield made
    os.close(made.descriptor)


@pytest.fixture
def loop():
    """A process that stands for the loop: it lives until its stdin closes."""
    end, held = os.pipe()
    process = subprocess.Popen(
        [sys.executable, "-S", "-c", "import sys; sys.stdin.read()"],
        stdin=subprocess.PIPE,
        pass_fds=[held],
    )
    os.close(held)
    process.end = end
    yield process
    process.stdin.close()
    process.wait()
    os.close(end)


@pytest.fixture
def start(ring, loop, tmp_path):
    """Start recording into a file; whatever still runs is killed at the end."""
    started = []

    def start_one(name="record"):
        path = tmp_path / name
        recording = LoopRecording(path, ring.descriptor)
        started.append(recording)
        recording.start(loop.end, {"device": "test", "scheduling": "fifo"})
        return recording, path

    yield start_one
    for recording in started:
        recording.process.kill()
        recording.process.wait()


def wait_until(condition):
    clock = SystemClock()
    deadline_s = clock.now_s() + PATIENCE_S
    while not condition():
        assert clock.now_s() < deadline_s, "nothing happened"
        clock.sleep_until(clock.now_s() + 0.01)


def wait_for_ticks(path, count):
    wait_until(lambda: len(read_record(path).ticks) >= count)


def open_descriptors():
    return len(list(Path("/proc/self/fd").iterdir()))


def numbers(record):
    return record.ticks["monotonic_s"].tolist()


# --- on a virtual clock -----------------------------------------------------


class CountingWriter(RecordWriter):
    syncs = 0

    def sync(self):
        self.syncs += 1
        super().sync()


@pytest.fixture
def recording(ring, tmp_path):
    descriptor = open_record(tmp_path / "record")
    writer = CountingWriter(descriptor)
    writer.begin({})
    clock = ManualClock()
    yield TickRecorder(clock, ring.block, writer), clock, writer, tmp_path / "record"
    os.close(descriptor)


def test_every_tick_is_there_with_all_its_fields(recording, ring, rng):
    recorder, _, _, path = recording
    for count in rng.integers(0, 120, 30):
        ring.tick(int(count))
        recorder.collect()
    recorder.finish()
    record = read_record(path)
    assert numbers(record) == list(range(ring.count))
    expected, _, _ = ring.block.read_ticks(0)
    assert record.ticks.tobytes() == expected.tobytes()
    assert record.is_complete
    assert record.lost == 0


def test_ticks_that_the_ring_has_overrun_are_counted(recording, ring):
    recorder, _, _, path = recording
    ring.tick(100)
    recorder.collect()
    ring.tick(RING_TICKS + 777)
    recorder.collect()
    ring.tick(10)
    recorder.finish()
    record = read_record(path)
    assert record.lost == ring.count - len(record.ticks)
    assert 777 <= record.lost <= 778  # the slot being written is never trusted
    assert record.is_complete
    assert np.flatnonzero(np.diff(record.ticks["monotonic_s"]) != 1).tolist() == [99]


def test_a_record_is_made_durable_once_a_second(recording, ring):
    recorder, clock, writer, _ = recording
    for _ in range(10 * 16 + 1):
        ring.tick(60)
        recorder.collect()
        clock.advance(SYNC_PERIOD_S / 16)  # adds up without rounding
    assert writer.syncs == 10


def test_a_torn_write_is_taken_back(tmp_path, ring, monkeypatch):
    path = tmp_path / "record"
    descriptor = open_record(path)
    writer = RecordWriter(descriptor)
    writer.begin({})
    size = path.stat().st_size
    write = os.write

    def write_half(where, data):
        if path.stat().st_size > size:
            raise OSError(28, "No space left on device")
        return write(where, data[: len(data) // 2])

    monkeypatch.setattr(os, "write", write_half)
    ring.tick(10)
    with pytest.raises(OSError, match="No space"):
        writer.append(0, 0, ring.block.read_ticks(0)[0])
    os.close(descriptor)
    assert path.stat().st_size == size
    assert read_record(path).notice.startswith("the recording has no end")


# --- as a process -----------------------------------------------------------


def test_a_recorder_ends_with_the_loop_and_holds_the_last_tick(start, ring, loop):
    recorder, path = start()
    ring.tick(500)
    wait_for_ticks(path, 500)
    ring.tick(400)
    ring.tick(5, mode=4)
    loop.kill()
    recorder.finish()
    assert recorder.problem == ""
    record = read_record(path)
    assert numbers(record) == list(range(905))
    assert record.ticks["mode"][-5:].tolist() == [4] * 5
    assert record.is_complete
    assert record.header["scheduling"] == "fifo"
    assert record.header["causes"]["7"] == "player_gone"


def test_ticks_from_before_it_was_there_are_kept(start, ring, loop):
    ring.tick(3000)
    recorder, path = start()
    loop.kill()
    recorder.finish()
    assert recorder.problem == ""
    assert numbers(read_record(path)) == list(range(3000))


@pytest.mark.parametrize(
    "number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]
)
def test_signals_to_the_player_do_not_end_it(start, ring, loop, number):
    recorder, path = start()
    ring.tick(10)
    wait_for_ticks(path, 10)
    assert os.getpgid(recorder.process.pid) != os.getpgid(0)
    recorder.process.send_signal(number)
    ring.tick(10)
    wait_for_ticks(path, 20)
    loop.kill()
    recorder.finish()
    assert recorder.problem == ""


def test_killed_itself_it_leaves_what_it_had_written(start, ring):
    recorder, path = start()
    ring.tick(300)
    wait_for_ticks(path, 300)
    recorder.process.kill()
    recorder.process.wait()
    record = read_record(path)
    assert numbers(record) == list(range(300))
    assert not record.is_complete
    assert "status -9" in recorder.problem


@pytest.mark.realtime
def test_the_record_of_a_killed_player_goes_to_the_end(tmp_path):
    path = tmp_path / "record"
    player = subprocess.run(
        [sys.executable, str(HERE / "recorded_player.py"), str(path)],
        capture_output=True,
        timeout=PATIENCE_S,
        check=False,
    )
    assert player.returncode == -signal.SIGKILL
    wait_until(lambda: read_record(path).is_complete)
    record = read_record(path)
    assert numbers(record) == list(range(1000))
    assert record.ticks["mode"][-1] == 4


def test_a_full_disk_ends_it_with_a_reason_and_a_whole_record(start, ring, capfd):
    recorder, path = start()
    ring.tick(100)
    wait_for_ticks(path, 100)
    limit = path.stat().st_size + 5000  # bytes; a frame of 200 ticks does not fit
    resource.prlimit(recorder.process.pid, resource.RLIMIT_FSIZE, (limit, limit))
    ring.tick(200)
    assert recorder.process.wait(PATIENCE_S) == Status.FULL
    assert "the disk at /" in recorder.problem
    record = read_record(path)
    assert len(record.ticks) >= 100
    assert numbers(record) == list(range(len(record.ticks)))
    assert "damaged" not in record.notice
    assert len(capfd.readouterr().err.splitlines()) == 1


def test_a_removed_file_ends_it_with_a_reason(start, ring, capfd):
    recorder, path = start()
    ring.tick(10)
    wait_for_ticks(path, 10)
    path.unlink()
    assert recorder.process.wait(PATIENCE_S) == Status.REMOVED
    assert "removed" in recorder.problem
    assert "removed" in capfd.readouterr().err


def test_a_block_of_another_version_is_refused(tmp_path, loop, capfd):
    descriptor = anonymous_memory("test", 4096)
    recorder = LoopRecording(tmp_path / "record", descriptor)
    recorder.start(loop.end, {})
    os.close(descriptor)
    assert recorder.process.wait(PATIENCE_S) == Status.FAILED
    assert "versions differ" in capfd.readouterr().err


def test_the_recorder_imports_nothing_heavy():
    code = (
        "import sys, json, hapticplayer.haptics.recorder; "
        "print(json.dumps(sorted({m.split('.')[0] for m in sys.modules})))"
    )
    found = json.loads(
        subprocess.run(
            [sys.executable, "-P", "-c", code], capture_output=True, check=True
        ).stdout
    )
    assert not {"av", "PySide6", "scipy", "matplotlib", "sounddevice"} & set(found)


# --- the player's handle ----------------------------------------------------


def test_a_recording_holds_what_came_before_its_start(ring, loop, tmp_path):
    path = tmp_path / "record"
    handle = LoopRecording(path, ring.descriptor)
    ring.tick(50)
    handle.start(loop.end, {"device": "test"})
    loop.kill()
    handle.finish()
    handle.finish()  # a second time does no harm
    assert handle.problem == ""
    assert numbers(read_record(path)) == list(range(50))


def test_a_recording_of_a_loop_that_never_was_leaves_no_file(ring, tmp_path):
    path = tmp_path / "record"
    handle = LoopRecording(path, ring.descriptor)
    assert path.exists()
    handle.finish()
    assert not path.exists()
    handle.start(-1, {})  # too late: ignored
    assert not path.exists()
    assert handle.problem == ""


def test_a_recording_that_cannot_start_is_reported(ring, loop, tmp_path, monkeypatch):
    handle = LoopRecording(tmp_path / "record", ring.descriptor)

    def fail(_self, _header):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(RecordWriter, "begin", fail)
    handle.start(loop.end, {})
    assert "is full" in handle.problem
    handle.finish()
    assert "is full" in handle.problem


def test_a_recording_never_replaces_a_file_and_leaks_nothing(ring, tmp_path):
    (tmp_path / "record").write_text("dear")
    before = open_descriptors()
    with pytest.raises(InputError, match="already exists"):
        LoopRecording(tmp_path / "record", ring.descriptor)
    with pytest.raises(InputError, match="cannot be written"):
        LoopRecording(tmp_path / "none" / "record", ring.descriptor)
    assert (tmp_path / "record").read_text() == "dear"
    handle = LoopRecording(tmp_path / "other", ring.descriptor)
    handle.finish()
    assert open_descriptors() == before
