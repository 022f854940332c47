"""The platform's legs, against their geometry; what is out of reach is held back."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from app.plots.rig_platform import (
    LONGEST_M,
    SHORTEST_M,
    YAW_S,
    Follower,
    PlatformPose,
    is_reachable,
    legs_m,
    platform_m,
    reached,
)
from hapticplayer.model.rig import RigMotion

SHIFTS = st.floats(-2.0, 2.0)
ANGLES = st.floats(-1.5, 1.5)
POSES = st.builds(PlatformPose, SHIFTS, SHIFTS, SHIFTS, ANGLES, ANGLES, ANGLES)


@given(POSES)
def test_the_platform_is_turned_as_the_packets_say(pose):
    """Yaw, then pitch, then roll in the platform's own axes, by scipy's own matrices."""
    angles = [pose.yaw_rad, pose.pitch_rad, pose.roll_rad]
    turn = Rotation.from_euler("ZXY", angles).as_matrix()
    level = platform_m(PlatformPose())
    centre = level.mean(axis=0)
    shift = [pose.right_m, pose.front_m, pose.up_m]
    expected = (level - centre) @ turn.T + centre + shift
    assert platform_m(pose) == pytest.approx(expected, abs=1e-12)


def test_in_neutral_all_legs_are_alike_and_in_the_middle():
    lengths = legs_m(PlatformPose())
    assert np.ptp(lengths) < 1e-12
    assert SHORTEST_M + 0.1 < lengths[0] < LONGEST_M - 0.1


def test_up_is_longer_and_a_nose_up_lifts_the_front():
    assert (legs_m(PlatformPose(up_m=0.05)) > legs_m(PlatformPose())).all()
    top = platform_m(PlatformPose(pitch_rad=0.2))
    assert top[:2, 2].min() > top[2:, 2].max()
    right_down = platform_m(PlatformPose(roll_rad=0.2))
    assert (
        right_down[right_down[:, 0] > 0.1, 2].max() < platform_m(PlatformPose())[0, 2]
    )


@given(POSES)
def test_a_held_back_pose_is_as_far_as_the_legs_reach(pose):
    done, share = reached(pose)
    assert is_reachable(done)
    assert 0.0 <= share <= 1.0
    if share < 1.0:
        assert not is_reachable(pose)
        assert not is_reachable(pose.scaled(share + 1e-4))
    assert done == pytest.approx(pose.scaled(share))


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_a_pose_that_is_not_a_number_is_neutral(bad):
    assert reached(PlatformPose(up_m=bad)) == (PlatformPose(), 0.0)


def test_a_heading_that_turns_on_comes_back():
    follower, heading, now_s = Follower(), 0.0, 0.0
    for _ in range(3000):  # 1 rad/s for 30 s: far round
        heading = math.remainder(heading + 0.01, math.tau)
        now_s += 0.01
        pose = follower.pose(RigMotion(heading_rad=heading), now_s)
    assert pose.yaw_rad == pytest.approx(YAW_S, rel=0.05)
    for _ in range(1000):
        now_s += 0.01
        pose = follower.pose(RigMotion(heading_rad=heading), now_s)
    assert abs(pose.yaw_rad) < 0.01
