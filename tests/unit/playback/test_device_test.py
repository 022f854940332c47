"""The test of a device: gentle, part by part, bounded, and stopped at once."""

import numpy as np
import pytest

from hapticplayer.devices import installed_devices
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import RigTrack
from hapticplayer.playback.device_test import HOMING_S, DeviceTest, parts_of
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.meters import Loudest
from tests.needed_extras import needs


class Player:
    """Plays nothing, in steps of 50 ms of the clock."""

    made: list["Player"]

    def __init__(self, clock, device, track, latch):
        latch.refuse()
        self.device, self.end_s, self._clock = device, float(track.time_s[-1]), clock
        self.mode, self.cause, self.problem, self.levels = Mode.IDLE, Cause.NONE, "", ()
        self.media_s, self.is_homed, self.age_s = 0.0, True, 0.0015
        self.done, self.loudest, self.notice = [], Loudest(), ""
        self.flags = 0
        self.made.append(self)

    @property
    def is_over(self):
        return (
            bool(self.problem)
            or self.media_s >= self.end_s
            or (self.mode is Mode.TRIPPED)
        )

    def poll(self):
        self.done.append("poll")
        if self.is_homed and self.mode is not Mode.TRIPPED:
            self.media_s, self.mode = self.media_s + 0.05, Mode.FOLLOWING
        ticks = np.zeros(50, TICK)
        ticks["mode"], ticks["reply_age_s"] = self.mode, self.age_s
        ticks["buttons"] = self.flags
        return ticks

    def stop(self):
        self.mode = Mode.TRIPPED
        self.done.append("stop")

    def close(self):
        self.done.append("close")


@pytest.fixture
def begin(manual_clock):
    Player.made = []
    latch = StopLatch()
    return lambda name: DeviceTest(manual_clock, name, Player, latch)


def finish(test, clock=None, most=2000):
    """Poll until it is over; return what was done, by part."""
    steps = []
    for _ in range(most):
        test.poll()
        test.wait()
        if clock is not None:
            clock.advance(0.05)
        if test.step is not None:
            steps.append((test.part.label, test.step))
        if test.is_over:
            return list(dict.fromkeys(steps))
    raise AssertionError("the test does not end")


def test_every_device_is_tested_gently_and_for_a_bounded_time():
    for name in (n for n, one in installed_devices().items() if not one.takes_motion):
        (part, *others) = parts_of(name)
        assert part.end_s + sum(one.end_s for one in others) < 25.0, name
        largest_n = np.linalg.norm(part.track.force_n, axis=1).max()
        record = installed_devices()[name].capabilities
        limit = 0.25 if record.axes else 0.5
        assert 0.0 < largest_n <= limit * min(4.5, record.peak_force_n) + 1e-6, name
        rise_npms = np.abs(np.diff(part.track.force_n, axis=0)).max() / 10.0
        assert rise_npms < 0.01, name  # slow enough to let go


@needs("wheels", "rigs", "shakers")
def test_the_test_of_a_device_follows_from_its_capabilities():
    directions = {
        name: [step.direction for step in parts_of(name)[0].steps]
        for name in ("simulated", "wheel", "wheel:axis=y", "rumble")
    }
    assert len(directions["simulated"]) == 6
    assert directions["wheel"] == ["right", "left"]
    assert directions["wheel:axis=y"] == ["up", "down"]
    assert directions["rumble"] == ["vibration"] * 2
    (rig,) = parts_of("rig:outsim")
    assert isinstance(rig.track, RigTrack)
    shaker = parts_of("shaker:pulse,channels=3+4")
    assert [part.label for part in shaker] == ["3", "4"]
    assert "channels=4" in shaker[1].device
    with pytest.raises(DeviceError, match="no driver"):
        parts_of("teleporter")


@needs("shakers")
def test_channels_are_tested_one_after_the_other(begin):
    test = begin("shaker:pulse,channels=3+4")
    steps = finish(test)
    assert [label for label, _ in steps] == ["3", "3", "4", "4"]
    assert [player.device[-60:] for player in Player.made] == [
        part.device[-60:] for part in parts_of("shaker:pulse,channels=3+4")
    ]
    assert [player.done[-1] for player in Player.made] == ["close"] * 2
    assert test.done_s == pytest.approx(test.end_s, abs=0.2)
    assert test.problem == ""


@needs("shakers")
def test_a_stop_ends_all_parts_at_once(begin):
    test = begin("shaker:pulse,channels=3+4")
    test.poll()
    test.stop()
    test.wait()
    assert test.is_over
    assert Player.made[0].done == ["poll", "stop", "close"]
    assert len(Player.made) == 1
    assert test.was_stopped
    assert len(test.poll()) == 0


@needs("shakers")
def test_a_stop_between_two_parts_begins_no_other(begin):
    test = begin("shaker:pulse,channels=3+4")
    Player.made[0].media_s = Player.made[0].end_s
    test.poll()
    test.wait()
    assert (test.is_acting, test.step) == (True, None)
    test.stop()
    assert test.was_stopped
    assert not test.is_acting
    assert test.is_over
    test.poll()
    assert len(Player.made) == 1


@needs("shakers")
def test_a_trip_or_a_problem_ends_it(begin):
    test = begin("shaker:pulse,channels=3+4")
    Player.made[0].mode, Player.made[0].cause = Mode.TRIPPED, Cause.GRIP_BUTTON
    finish(test)
    assert (test.cause, len(Player.made)) == (Cause.GRIP_BUTTON, 1)
    test = begin("rumble")
    Player.made[-1].problem = "it is gone"
    finish(test)
    assert test.problem == "it is gone"


def test_a_device_that_is_never_ready_is_given_up(begin, manual_clock):
    test = begin("falcon")
    Player.made[0].is_homed = False
    begin_s = manual_clock.now_s()
    finish(test, manual_clock)
    taken_s = manual_clock.now_s() - begin_s
    assert taken_s == pytest.approx(
        installed_devices()["falcon"].patience_s + HOMING_S, abs=0.2
    )
    assert "set it up first" in test.problem
    assert Player.made[0].done[-1] == "close"


@needs("inverse3")
def test_the_latency_is_half_the_age_of_answers(begin):
    test = begin("inverse3")
    assert test.latency_s is None
    finish(test)
    assert test.latency_s == pytest.approx(0.00075, rel=1e-5)
    test = begin("rumble")  # reports by itself, whatever it was sent
    finish(test)
    assert test.latency_s is None


@needs("rigs")
def test_a_rig_that_nobody_listens_to_is_the_problem(begin):
    test = begin("rig:outsim,127.0.0.1:4999")
    Player.made[0].flags = SENT | REFUSED
    while not test.is_over:
        test.poll()
    assert test.problem == "nobody listens at 127.0.0.1:4999: start the rig's software"


def test_a_report_with_the_last_stop_is_the_problem(begin):
    test = begin("simulated")
    player = Player.made[0]
    player.close = lambda: setattr(player, "notice", "the toy goes on; pull it")
    while not test.is_over:
        test.poll()
    assert test.problem == "the toy goes on; pull it"
