"""A sensor in place of the demonstration, on the real player and the simulated device."""

import numpy as np
import pytest

from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.live.source import (
    OpenedSource,
    Samples,
    SourceLost,
    SourceRow,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import Message
from hapticplayer.haptics.contract import Mode
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source
from hapticplayer.study import felt_demonstration
from hapticplayer.study.definition import Checks, Condition, PlaybackLimits
from hapticplayer.study.felt_demonstration import FeltStage

pytestmark = pytest.mark.realtime
G, LIFT_MPS2 = 9.80665, 3.0


class Hand:
    """Rests for 2 s from its first read, then is lifted for good; 200 Hz."""

    def __init__(self, clock):
        self._clock, self._begun_s, self._sent = clock, 0.0, 0
        self.is_lost = False

    def read(self, timeout_s):
        if self.is_lost:
            raise SourceLost("was unplugged or closed", where="port", remedy="connect")
        now_s = self._clock.now_s()
        self._begun_s = self._begun_s or now_s
        self._clock.sleep_until(now_s + min(timeout_s, 0.005))
        at_s = 0.005 * np.arange(self._sent, (now_s - self._begun_s) / 0.005)
        self._sent += len(at_s)
        rows = np.zeros((len(at_s), 8))
        rows[:, 0], rows[:, 1] = now_s, at_s
        rows[:, 4] = G + np.where(at_s > 2.0, LIFT_MPS2, 0.0)
        return Samples.of(list(map(tuple, rows)))

    def close(self):
        """Nothing is held."""


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "clip.mp4"
    frames = (np.full((72, 128, 3), 90, np.uint8) for _ in range(25))
    write_clip(path, frames, frame_rate_hz=25)
    still = ForceTrack([0.0, 1.0], np.zeros((2, 3)))
    return Source("clip", path, probe(path), {"none": still}, None, "none")


@pytest.fixture
def stage(source, monkeypatch):
    clock = SystemClock()
    limits, checks = PlaybackLimits(1.0, 1e6, 1.0, 1e6), Checks(device=False)
    player = Player(clock, outputs=["simulated"], audio=None)
    row = SourceRow("hand", Message("A hand"), "")
    hand = Hand(clock)
    sensor = OpenedSource("hand:x", row, hand, LogChoices())
    parts = (player, {"clip": source}, source, (limits, checks), clock)
    made = FeltStage(*parts, sensor=sensor)
    made.hand = hand
    monkeypatch.setattr(felt_demonstration, "FELT_S", 1.5)
    player.wait_ready()
    made.prepare_demonstration()
    made.begin()
    yield made
    player.close()


def poll_until(stage, condition, limit_s=20.0):
    clock = SystemClock()
    end_s = clock.now_s() + limit_s
    while not condition():
        assert clock.now_s() < end_s
        clock.sleep_until(min(stage.player.poll(), clock.now_s() + 0.02))


def force_n(stage):
    tick = stage.player.snapshot().leading.tick
    return np.zeros(3) if tick is None else tick["force_n"]


def is_felt(stage):
    return bool(np.abs(force_n(stage)).max() > 1e-6)


def test_a_sensor_is_felt_until_the_demonstration_ends(stage):
    assert "lay the sensor down" in stage.said
    poll_until(stage, lambda: force_n(stage)[1] > 0.5 * 0.4 * LIFT_MPS2)
    assert "grip follows" in stage.said
    poll_until(stage, stage.is_over)
    assert stage.said == ""
    poll_until(stage, lambda: not is_felt(stage))
    stage.prepare(Condition("clip", "none"))
    stage.begin()
    poll_until(stage, stage.is_over)  # the clip: a trial is as ever


def test_a_stop_ends_the_sensor_until_a_person_rearms(stage):
    poll_until(stage, lambda: is_felt(stage))
    stage.halt()
    poll_until(stage, lambda: stage.player.snapshot().leading.mode is Mode.TRIPPED)
    poll_until(stage, lambda: not is_felt(stage))
    assert stage.is_stopped
    assert stage.said == ""


def test_a_sensor_that_is_unplugged_ends_the_demonstration(stage):
    poll_until(stage, lambda: is_felt(stage))
    stage.hand.is_lost = True
    poll_until(stage, stage.is_over)
    poll_until(stage, lambda: not is_felt(stage))
