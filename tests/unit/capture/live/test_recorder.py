"""Recordings of a test camera, a test microphone and a board on a pseudo-terminal."""

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.live import recorder as module
from hapticplayer.capture.live.recorder import Recorder
from hapticplayer.capture.live.source import (
    OpenedSource,
    Samples,
    SourceRow,
    open_source,
)
from hapticplayer.capture.recorded import CLIP, LOG, parts_of, read_take
from hapticplayer.clock import SystemClock, realtime_minus_monotonic_s
from hapticplayer.errors import HapticPlayerError, InputError, Message, UsageError
from hapticplayer.media.clip_info import probe
from tests.material import recording

pytestmark = pytest.mark.realtime
WALL_S = realtime_minus_monotonic_s()


@pytest.fixture
def board():
    made = recording.Board()
    yield made
    made.unplug()


@pytest.fixture
def make(tmp_path, board):
    clock, made = SystemClock(), []

    def start(camera=None, audio=None, imu=board.source):
        source = open_source(imu, clock)
        recorder = Recorder(
            tmp_path / "take", camera, audio, source, clock, source_name=imu
        )
        recorder.start()
        made.append(recorder)
        return recorder

    yield start
    for one in made:
        one.stop()


def wait_until(recorder, condition, limit_s=6.0):
    clock = SystemClock()
    end_s = clock.now_s() + limit_s
    while not condition(state := recorder.snapshot()):
        assert clock.now_s() < end_s, state
        clock.sleep_until(clock.now_s() + 0.02)
    return state


def told(words):
    return lambda state: any(words in one for one in state.notices)


def test_three_streams_become_one_recording(make):
    recorder = make(recording.camera(), recording.MICROPHONE)
    recorder.mark()
    state = wait_until(
        recorder, lambda state: state.frames > 30 and state.samples > 200
    )
    folder = recorder.stop()
    assert state.frame.shape == (240, 320, 3)
    assert state.level_db > -40.0
    assert state.accel_mps2.shape == state.rate_radps.shape == (len(state.time_s), 3)
    assert state.imu_hz == pytest.approx(recording.RATE_HZ, rel=0.05)
    take, clip = read_take(folder), probe(folder / CLIP)
    assert take.is_finished
    assert clip.has_audio
    assert clip.duration_s == pytest.approx(take.camera.count / 30, abs=0.4)
    assert (take.camera.stamped_by, take.imu.stamped_by) == ("wall", "source")
    assert take.clock.residual_s < 0.02
    assert len(take.marks_s) == 1
    assert parts_of(folder).log == folder
    assert len((folder / LOG).read_text().splitlines()) == take.imu.count + 1


def test_an_imu_that_is_unplugged_is_told_and_the_camera_goes_on(make, board):
    recorder = make(recording.camera())
    wait_until(recorder, lambda state: state.samples > 50)
    board.unplug()
    frames = wait_until(recorder, told("imu: /dev/")).frames
    wait_until(recorder, lambda state: state.frames > frames + 25)
    take = read_take(recorder.stop())
    assert take.is_finished
    assert [gap.stream for gap in take.gaps] == ["imu"]
    assert take.gaps[0].end_s - take.gaps[0].begin_s > 0.6


def test_an_imu_that_comes_back_is_recorded_on_by_its_new_clock(make, board, tmp_path):
    port = tmp_path / "by-id"
    port.symlink_to(board.port)
    recorder = make(imu=board.source.replace(board.port, str(port)))
    wait_until(recorder, lambda state: state.samples > 300)
    board.unplug()
    before = wait_until(recorder, told("recorded again as soon")).samples
    board.plug_in(port)
    wait_until(recorder, told("imu: is back"))
    wait_until(recorder, lambda state: state.samples > before + 300)
    take = read_take(folder := recorder.stop())
    assert sum("recorded again as soon" in one for one in take.notices) == 1
    (gap,) = take.gaps
    imu = read_recording(folder).imu
    assert take.imu.count - len(imu) < 4  # of lines that were cut by the unplugging
    rows = np.searchsorted(imu.time_s, 0.5 * (gap.begin_s + gap.end_s))
    for part in (imu.part(slice(rows)), imu.part(slice(rows, None))):
        assert abs(recording.clock_error_s(part, take)) < 0.03


class Restarted:
    """A phone that is restarted after each second, behind the same link."""

    def __init__(self, clock, times):
        self.clock, self.times = clock, times
        self.begun_s, self.last_s = clock.now_s(), 0.0

    def read(self, timeout_s):
        self.clock.sleep_until(self.clock.now_s() + min(timeout_s, 0.01))
        since_s = self.clock.now_s() - self.begun_s
        at_s = np.arange(self.last_s + 0.005, since_s, 0.005)
        if not len(at_s):
            return Samples.of(())
        self.last_s = at_s[-1]
        own_s = at_s - 500.0 * np.minimum(self.times, np.floor(at_s))
        values = recording.rolled(at_s + self.begun_s + WALL_S)
        arrival_s = np.full(len(at_s), self.clock.now_s())
        return Samples(arrival_s, own_s, values[:, :3], values[:, 3:])

    def close(self):
        """Nothing is held."""


def started_with_phone(folder, times):
    clock = SystemClock()
    row = SourceRow("phone", Message("A phone"), "")
    source = OpenedSource("phone:x", row, Restarted(clock, times), LogChoices())
    recorder = Recorder(folder, None, None, source, clock)
    recorder.start()
    return recorder


def test_a_clock_that_begins_anew_is_told_and_goes_on(tmp_path):
    recorder = started_with_phone(tmp_path / "take", 1)
    wait_until(recorder, told("imu: its clock restarted"))
    before = recorder.snapshot().samples
    wait_until(recorder, lambda state: state.samples > before + 200)
    take = read_take(folder := recorder.stop())
    assert len(take.restarts) == 1
    imu = read_recording(folder).imu
    assert abs(recording.clock_error_s(imu.part(slice(-150, None)), take)) < 0.03


def test_two_phones_that_send_at_once_are_given_up_and_readable(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "MOST_RESTARTS", 1)
    recorder = started_with_phone(tmp_path / "take", 9)
    wait_until(recorder, lambda state: state.is_over)
    take = read_take(folder := recorder.stop())
    assert len(take.restarts) == 1
    assert "imu: phone:x: its clock restarted" in take.notices[-1]
    assert len(read_recording(folder).imu) > 300


def test_a_camera_that_is_unplugged_is_told_and_the_imu_goes_on(make):
    recorder = make(recording.camera(seconds=0.5))
    samples = wait_until(recorder, told("camera: lavfi")).samples
    state = wait_until(recorder, lambda state: state.samples > samples + 250)
    assert not state.is_over
    folder = recorder.stop()
    assert [gap.stream for gap in read_take(folder).gaps] == ["camera"]
    assert probe(folder / CLIP).duration_s == pytest.approx(0.5, abs=0.1)


def test_a_phone_that_sleeps_is_told_and_that_it_is_back(make, board):
    recorder = make()
    wait_until(recorder, lambda state: state.samples > 50)
    board.sleep(True)
    wait_until(recorder, told("imu: nothing for"))
    board.sleep(False)
    wait_until(recorder, told("imu: is back"))
    take = read_take(recorder.stop())
    assert [gap.stream for gap in take.gaps] == ["imu"]
    assert take.imu.dropped == take.gaps[0].missing > 80


def test_a_camera_that_cannot_be_opened_leaves_nothing(make, tmp_path):
    with pytest.raises(InputError, match="record --list"):
        make(str(tmp_path / "video9"))
    assert not (tmp_path / "take").exists()


@pytest.mark.parametrize(
    ("camera", "audio", "sentence"),
    [(None, None, "nothing is recorded"), (None, "default", "with a camera")],
)
def test_streams_that_make_no_recording_are_refused(tmp_path, camera, audio, sentence):
    with pytest.raises(UsageError, match=sentence):
        Recorder(tmp_path / "take", camera, audio, None, SystemClock())


def test_a_folder_that_exists_is_kept(make, tmp_path):
    (tmp_path / "take").mkdir()
    with pytest.raises(HapticPlayerError, match="exists"):
        make(recording.camera())


def test_the_last_samples_of_a_pipe_are_recorded(tmp_path):
    class Pipe:
        def __init__(self):
            self.has_sent = False

        def read(self, _timeout_s):
            if self.has_sent:
                raise InputError("has ended", where="standard input")
            self.has_sent = True
            return Samples.of([(1.0, 0.01 * k, 0, 0, 9.8, 0, 0, 0) for k in range(50)])

        def close(self):
            """Nothing is held."""

    row = SourceRow("csv", Message("Lines"), "-")
    source = OpenedSource("csv:-", row, Pipe(), LogChoices())
    recorder = Recorder(tmp_path / "take", None, None, source, SystemClock())
    recorder.start()
    wait_until(recorder, told("has ended"))
    recorder.stop()
    assert read_take(tmp_path / "take").imu.count == 50
    assert len((tmp_path / "take" / LOG).read_text().splitlines()) == 51
