"""Which replies are believed: leaps, silence, homing, impossible legs."""

import pytest

from hapticplayer.devices.falcon import kinematics
from hapticplayer.devices.falcon.driver import (
    LEAPS_TO_FAULT,
    MOST_COUNTS_PER_MS,
    Tracker,
)
from hapticplayer.devices.falcon.kinematics import Kinematics
from hapticplayer.devices.falcon.protocol import Reply

HOME = (-300, -300, -300)


@pytest.fixture
def tracker():
    tracker = Tracker(Kinematics())
    tracker.take(Reply(HOME, 0, 7), 10.0)
    return tracker


def shifted(by):
    return Reply((HOME[0] + by, HOME[1], HOME[2]), 1, 7)


def test_the_limit_is_counts_per_millisecond(tracker):
    tracker.take(shifted(MOST_COUNTS_PER_MS), 10.001)
    assert (tracker.rejected, tracker.replied_s, tracker.buttons) == (0, 10.001, 1)
    tracker.take(shifted(-1), 10.002)
    assert (tracker.rejected, tracker.replied_s) == (1, 10.001)


def test_after_a_silence_the_hand_may_be_elsewhere(tracker):
    tracker.take(shifted(900), 10.050)
    assert (tracker.rejected, tracker.replied_s) == (0, 10.050)
    expected = kinematics.forward(kinematics.angles((600, -300, -300)))
    assert tracker.pose.position_m == pytest.approx(expected, abs=1e-12)


def test_two_replies_in_one_packet_give_no_infinite_speed(tracker):
    tracker.take(shifted(20), 10.0)
    assert tracker.rejected == 0


def test_a_zero_that_has_moved_is_told_from_a_glitch(tracker):
    for number in range(1, LEAPS_TO_FAULT + 1):
        assert not tracker.has_lost_its_place
        tracker.take(shifted(600), 10.0 + number / 1000)
    assert tracker.has_lost_its_place


def test_glitches_that_end_in_time_are_forgotten(tracker):
    for number in range(50):
        value = 0 if number % LEAPS_TO_FAULT == LEAPS_TO_FAULT - 1 else 1000
        tracker.take(shifted(value), 10.001 + number / 1000)
        assert not tracker.has_lost_its_place


def test_counts_that_no_legs_can_have_are_not_believed(tracker):
    before = tracker.pose
    tracker.take(Reply((4000, -3500, 900), 0, 7), 15.0)
    assert (tracker.rejected, tracker.pose) == (1, before)
    tracker.take(Reply(HOME, 0, 7), 20.0)
    assert tracker.rejected == 0


def test_without_homing_there_is_no_pose_and_any_zero_may_follow(tracker):
    tracker.take(Reply((5, 6, 7), 2, 3), 10.001)
    assert (tracker.is_homed, tracker.pose, tracker.buttons) == (False, None, 2)
    tracker.take(Reply((700, -600, 100), 0, 7), 10.002)
    assert (tracker.is_homed, tracker.rejected) == (True, 0)
    assert tracker.pose is not None
