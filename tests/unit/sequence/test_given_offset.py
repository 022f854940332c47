"""What is printed of a synchronisation can be given back and gives the same."""

import re

import numpy as np
import pytest

from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.cli.recording_options import sync_text
from hapticplayer.errors import Message, UsageError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.pace import Pace
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.sequence.synchronizing import SyncChoices, ask_for_pace, find_sync

SECONDS, ZERO_S = 20.0, 1.79e9


@pytest.fixture(scope="module")
def clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "clip.mp4"
    write_clip(path, [np.full((48, 64, 3), 90, np.uint8)] * 200, frame_rate_hz=10.0)
    return probe(path)


@pytest.fixture
def recording():
    """A log whose clock counts from 1970."""
    time_s = ZERO_S + np.arange(2000) / 100.0
    force = np.tile((0.0, 0.0, 9.81), (2000, 1))
    imu = ImuLog(time_s, force, np.zeros((2000, 3)), source="log.csv")
    return Recording(imu, ClockMap(confidence=0.0), "logger")


@pytest.mark.parametrize("drift_ppm", [0.0, 43.217, -180.0])
@pytest.mark.parametrize("zero_s", [0.0, ZERO_S])
def test_a_printed_offset_gives_the_same_import(clip, recording, drift_ppm, zero_s):
    found = ClockMap.at(SECONDS / 2, 0.71 - zero_s, 1.0 + 1e-6 * drift_ppm)
    sync = Synchronisation(found, "pats", has_drift=True, middle_s=SECONDS / 2)
    text = sync_text(sync.described())
    offset, drift = re.findall(r"--offset (\S+) --drift (\S+)", text)[0]
    assert float(offset) == pytest.approx(0.71 - zero_s, abs=1e-5)

    choices = SyncChoices(offset_s=float(offset), drift_ppm=float(drift))
    again = find_sync(clip, recording, choices).clock_map

    log_s = zero_s + np.array([-0.7, 9.0, 19.3])
    apart_s = (again.rate - found.rate) * log_s + (again.offset_s - found.offset_s)
    assert np.abs(apart_s).max() < 1e-5


def test_a_fitted_drift_is_not_extrapolated_over_years():
    found = ClockMap.at(10.0, 0.71 - ZERO_S, 1.0 + 50e-6)
    assert abs(found.offset_s - (0.71 - ZERO_S)) > 3600.0
    assert found.offset_at(10.0) == pytest.approx(0.71 - ZERO_S, abs=1e-5)


@pytest.fixture
def slow_clip(monkeypatch):
    pace = Pace(8.0, Message("it was recorded at 240 and plays at 30"))
    monkeypatch.setattr("hapticplayer.media.pace.pace_of", lambda _path: pace)


@pytest.mark.usefixtures("slow_clip")
def test_slow_motion_is_asked_about(clip):
    asked = r"ffmpeg -itsscale 0\.125 .*--slow-motion 1\).*--slow-motion 8 --offset S"
    with pytest.raises(UsageError, match=asked):
        ask_for_pace(clip, SyncChoices(offset_s=0.0))
    ask_for_pace(clip, SyncChoices(slowed=1.0))


@pytest.mark.usefixtures("slow_clip")
@pytest.mark.parametrize("slowed", [1.0, 8.0])
def test_slow_motion_is_taken_as_it_is_answered(clip, recording, slowed):
    choices = SyncChoices(offset_s=3.0, slowed=slowed)
    clock = find_sync(clip, recording, choices).clock_map
    assert clock.rate == slowed
    assert clock.rate * 7.0 + clock.offset_s == pytest.approx(10.0)


def test_another_pace_needs_an_offset(clip, recording):
    with pytest.raises(UsageError, match=r"offset, too \(--offset S\)"):
        find_sync(clip, recording, SyncChoices(slowed=8.0))
