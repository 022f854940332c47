"""Without a force no torques are worked out, at rest no pose; frames go out all the same."""

import pytest

from hapticplayer.devices.falcon import driver as driver_module
from hapticplayer.devices.falcon.kinematics import Kinematics

ZERO, PUSH = (0.0, 0.0, 0.0), (1.0, 2.0, -3.0)
TICKS = 200


@pytest.fixture
def counts(monkeypatch):
    found = {"words": 0, "pose": 0}
    words, pose = driver_module.motor_words, Kinematics.pose

    def counted_words(*args):
        found["words"] += 1
        return words(*args)

    def counted_pose(*args):
        found["pose"] += 1
        return pose(*args)

    monkeypatch.setattr(driver_module, "motor_words", counted_words)
    monkeypatch.setattr(Kinematics, "pose", counted_pose)
    return found


@pytest.fixture
def device(running):
    made = running.driver()
    made.open()
    yield made
    made.close()


def tick(bench, device, force_n, count=TICKS):
    """Exchange at 1 kHz and return the last reading and how many commands came."""
    before = len(bench.mechanics.commands)
    for _ in range(count):
        reading = device.exchange(force_n, bench.clock.now_s())
        bench.clock.advance(0.001)
    return reading, len(bench.mechanics.commands) - before


def test_zero_forces_skip_torques_and_are_sent_each_period(running, device, counts):
    tick(running, device, ZERO)
    counts["words"] = 0
    _, sent = tick(running, device, ZERO)
    assert counts["words"] == 0
    assert sent == TICKS
    assert running.mechanics.commands[-1][1] == (0, 0, 0)
    _, sent = tick(running, device, PUSH)
    assert counts["words"] == sent == TICKS


def test_a_grip_at_rest_needs_no_pose_and_stays_where_it_is(running, device, counts):
    first, _ = tick(running, device, ZERO)
    assert counts["pose"] == 1
    reading, _ = tick(running, device, ZERO)
    assert counts["pose"] == 1
    assert reading.position_m == first.position_m
    assert reading.replied_s > running.clock.now_s() - 0.005  # its age is not frozen
    kinematics, counted = Kinematics(), running.mechanics.counts
    x, y, z = kinematics.pose(kinematics.angles(counted)).position_m
    middle_m = kinematics.geometry.centre_z_m
    assert reading.position_m == pytest.approx((x, y, z - middle_m), abs=1e-9)


def test_a_grip_that_moves_has_a_pose_for_each_answer(running, device, counts):
    tick(running, device, ZERO)
    counts["pose"] = 0
    for number in range(50):
        a, b, c = running.mechanics.counts
        running.mechanics.counts = (a + 1, b - 1, c + number % 2)
        tick(running, device, ZERO, 1)
    tick(running, device, ZERO, 4)
    assert counts["pose"] == 50
