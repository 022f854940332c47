"""A force that is made while it is felt: what a loop does with whatever is written."""

import math
import os

import pytest

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import ZERO, Limits
from hapticplayer.haptics.live import BLEND_S, LIVE_BYTES, LIVE_VALID_S, LiveForce
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.haptics.track import map_track, to_shared_memory
from hapticplayer.linux import anonymous_memory
from tests.faults.haptic_rig import Rig

LIMITS = Limits()
ALL = (1.0, 1.0, 1.0)


def read(live, scale=ALL, output="one"):
    descriptor = to_shared_memory(live.scaled(output, scale))
    try:
        return map_track(descriptor)
    finally:
        os.close(descriptor)


@pytest.fixture
def rig():
    made = Rig(is_live=True)
    made.following()
    yield made
    made.close()


def ticks(rig, count, force_n=None, at_s=None):
    """Tick with one value written in place of the usual ones; return what was sent."""
    rig.measures = False
    sent = []
    for _ in range(count):
        if force_n is not None:
            rig.live.write(rig.clock.now_s() if at_s is None else at_s, force_n)
        sent += rig.tick()
    return sent


def test_a_new_value_is_reached_within_5_ms_along_a_line():
    live = LiveForce()
    track = read(live)
    live.write(10.0, (1.0, 0.0, -1.0))
    live.write(10.01, (3.0, 0.0, 1.0))
    halfway = track.force_at(10.01 + BLEND_S / 2)
    assert halfway == pytest.approx((2.0, 0.0, 0.0))
    assert track.force_at(10.01 + BLEND_S) == (3.0, 0.0, 1.0)
    assert track.force_at(10.0) == (1.0, 0.0, -1.0)  # never beyond the two values
    assert not track.is_silent(10.01 + LIVE_VALID_S - 1e-6)
    assert track.is_silent(10.01 + LIVE_VALID_S + 1e-6)


def test_a_value_before_the_newest_one_is_left_out():
    live = LiveForce()
    track = read(live)
    live.write(10.0, (1.0, 0.0, 0.0))
    live.write(9.0, (2.0, 0.0, 0.0))
    live.write(10.0, (3.0, 0.0, 0.0))
    live.write(math.nan, (4.0, 0.0, 0.0))
    assert track.force_at(11.0) == (1.0, 0.0, 0.0)
    assert track.is_silent(10.11)


def test_each_output_has_its_own_scale():
    live = LiveForce()
    live.write(10.0, (1.0, 2.0, 3.0))
    weak, strong = read(live, (0.5, 0.0, 0.5)), read(live, (2.0, 2.0, 2.0), "two")
    assert weak.force_at(11.0) == (0.5, 0.0, 1.5)
    live.write(11.0, (2.0, 2.0, 2.0))
    assert weak.force_at(12.0) == (1.0, 0.0, 1.0)
    assert strong.force_at(12.0) == (4.0, 4.0, 4.0)


def test_another_scale_takes_the_place_of_the_one_before():
    live = LiveForce()
    before, after = read(live), read(live, (2.0, 2.0, 2.0))
    live.write(10.0, (1.0, 0.0, 0.0))
    assert before.is_silent(10.0)
    assert after.force_at(11.0) == (2.0, 0.0, 0.0)


def test_a_torn_value_leaves_the_last_one_until_it_expires():
    live = LiveForce()
    descriptor = to_shared_memory(live.scaled("one", ALL))
    track = map_track(descriptor)
    live.write(10.0, (1.0, 0.0, 0.0))
    assert track.force_at(10.1) == (1.0, 0.0, 0.0)
    os.pwrite(descriptor, b"\1" * 200, 64)
    os.pwrite(descriptor, b"\7", 320)
    os.close(descriptor)
    assert track.force_at(10.1) == (1.0, 0.0, 0.0)
    assert not track.is_silent(10.09)
    assert track.is_silent(10.11)


def test_memory_of_another_kind_is_refused():
    descriptor = anonymous_memory("test", LIVE_BYTES)
    with pytest.raises(ValueError, match="does not match"):
        map_track(descriptor, columns=6)  # of a rig
    os.close(descriptor)


def test_a_spike_stays_within_the_limits(rig):
    before = rig.device.sent[-1]
    sent = [before, *ticks(rig, 30, (1e9, -1e9, 1e38))]
    assert all(math.hypot(*force) <= LIMITS.force_cap_n + 1e-9 for force in sent)
    steps = [math.dist(a, b) for a, b in zip(sent[1:], sent, strict=False)]
    assert max(steps) <= LIMITS.content_slew_n + 1e-9


def test_a_value_that_is_not_a_number_trips(rig):
    sent = ticks(rig, 20, (math.nan, 0.0, 0.0))
    assert (rig.mode, rig.cause) == (Mode.TRIPPED, Cause.NOT_FINITE)
    assert sent[1:] == [ZERO] * 19


def test_an_hour_at_the_limit_of_the_sensor_stays_cool(rig):
    ticks(rig, 12_000, (0.0, 0.0, 60.0))
    assert rig.mode is Mode.FOLLOWING
    assert math.sqrt(rig.loop.state.heat_n2) <= rig.loop.limits.continuous_n


def test_a_time_that_stands_still_or_goes_back_is_silence(rig):
    at_s = rig.clock.now_s()
    for _ in range(110):
        ticks(rig, 1, (2.0, 0.0, 0.0), at_s)
        at_s -= 0.001
    assert rig.cause is Cause.SOURCE_SILENT


def test_a_time_to_come_is_silence(rig):
    ticks(rig, 3, (2.0, 0.0, 0.0), rig.clock.now_s() + 5.0)
    assert (rig.mode, rig.cause) == (Mode.RAMPING, Cause.SOURCE_SILENT)


def test_a_source_that_is_back_after_a_stop_stays_off(rig):
    ticks(rig, 101)
    assert (rig.mode, rig.cause) == (Mode.RAMPING, Cause.SOURCE_SILENT)
    rig.player.send(MessageKind.STOP)
    rig.measures = True
    rig.tick(200)
    assert (rig.mode, rig.device.sent[-1]) == (Mode.TRIPPED, ZERO)
    rig.player.send(MessageKind.REARM)
    rig.tick(300)
    assert rig.mode is Mode.FOLLOWING
