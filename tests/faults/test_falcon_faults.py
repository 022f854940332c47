"""Faults that only the Falcon's USB has."""

import math

import pytest
from falcon_rig import FalconGrip
from haptic_rig import Rig, SlowClock

from hapticplayer.devices.falcon.driver import DriverState
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import Limits
from hapticplayer.haptics.messages import MessageKind

CAP_N = Limits().force_cap_n
ROUNDING_N = 0.01  # of motor words, in newtons


@pytest.fixture
def rig():
    clock = SlowClock()
    made = Rig(device=FalconGrip(clock), clock=clock)
    yield made
    made.close()


def assert_the_motors_are_off(rig, ticks=10):
    """After what was on its way has arrived, every frame is zero."""
    count = len(rig.device.mechanics.commands)
    rig.tick(ticks)
    late = rig.device.mechanics.commands[count + 2 :]
    assert all(words == (0, 0, 0) for _, words in late)


def test_the_motors_get_what_was_sent_within_the_cap(rig):
    rig.tick(900)
    most_n = rig.device.motor_forces_n().max()
    assert 3.5 < most_n <= CAP_N + ROUNDING_N
    sent = [math.hypot(*force) for force in rig.device.sent]
    assert most_n == pytest.approx(max(sent), abs=ROUNDING_N)


@pytest.mark.parametrize("moment", range(40))
def test_the_cable_may_be_pulled_at_any_moment(moment, rig):
    rig.following()
    rig.clock.advance(moment * 25e-6)
    rig.device.chip.unplug()
    assert rig.ticks_to(Mode.TRIPPED, 2) <= 2
    assert rig.cause is Cause.UNPLUGGED
    message = rig.player.receive()
    assert message.word is MessageKind.LOST
    assert "unplugged" in message.text


@pytest.mark.parametrize(
    ("stall_ms", "mode", "cause"),
    [
        (5, Mode.FOLLOWING, Cause.NONE),
        (20, Mode.RAMPING, Cause.REPLY_LATE),
        (100, Mode.TRIPPED, Cause.REPLY_LOST),
        (1000, Mode.TRIPPED, Cause.REPLY_LOST),
    ],
)
def test_stalls_of_the_bus(stall_ms, mode, cause, rig):
    rig.following()
    rig.device.chip.stalled_until_s = rig.clock.now_s() + stall_ms / 1000.0
    seen, causes = [], []
    for _ in range(stall_ms + 3):
        rig.tick()
        seen.append(rig.mode)
        causes.append(rig.cause)
    assert mode in seen
    assert cause in causes
    if stall_ms == 5:
        assert set(seen) == {Mode.FOLLOWING}
    # when the bus goes on, the newest frame is the first that it takes
    if mode is Mode.TRIPPED:
        assert_the_motors_are_off(rig)
        rig.player.send(MessageKind.REARM)
    rig.tick(400)
    assert rig.mode is Mode.FOLLOWING


@pytest.mark.parametrize("stall_ms", [5, 20, 60, 100, 1000])
@pytest.mark.parametrize("speed_mps", [0.3, 0.8])
def test_a_hand_that_moves_during_a_stall_has_not_lost_its_place(
    stall_ms, speed_mps, rig
):
    """What waited in the chip meanwhile is old; no leap follows on it."""
    rig.following()
    began_s, way_m = rig.clock.now_s(), 0.02
    rig.device.chip.stalled_until_s = began_s + stall_ms / 1000.0
    causes = set()
    for _ in range(stall_ms + 40):
        angle = speed_mps / way_m * (rig.clock.now_s() - began_s)
        rig.device.position_m = (way_m * math.sin(angle), 0.0, 0.0)
        rig.tick()
        causes.add(rig.cause)
    assert rig.device.driver.state is DriverState.READY
    assert causes <= {Cause.NONE, Cause.REPLY_LATE, Cause.REPLY_LOST}
    x_m = rig.loop.reading.position_m[0]
    assert x_m == pytest.approx(rig.device.position_m[0], abs=0.004)


@pytest.mark.parametrize("most", [1, 2, 7, 15, 16, 17, 61])
def test_short_and_split_packets_change_nothing(most, rig):
    rig.device.chip.most_payload = most
    rig.following()
    modes = set()
    for _ in range(300):
        rig.tick()
        modes.add(rig.mode)
    assert modes == {Mode.FOLLOWING}


@pytest.mark.parametrize("fault", ["corrupt", "silent", "noise", "leap"])
def test_single_faults_are_dropped_without_a_reaction(fault, rig):
    rig.following()
    device = rig.device
    for moment in range(40):
        counts = device.mechanics.counts
        if fault == "noise":
            device.board.faults.noise = b"<\x00\xff>"
        elif fault == "leap":
            device.mechanics.counts = (counts[0] + 5000, *counts[1:])
        else:
            setattr(device.board.faults, fault, 1 + moment % 3)
        rig.tick()
        device.mechanics.counts = counts
        rig.tick(6)
        assert rig.mode is Mode.FOLLOWING
        assert math.hypot(*rig.loop.state.hand.position_m) < 1e-4


def test_a_hand_slowly_at_the_edge_is_not_pushed_outward(rig):
    """The glide that no leap can show: fade, and at the edge the trip."""
    rig.following()
    for _ in range(400):
        force = rig.loop.state.planned_n
        size = math.hypot(*force)
        rig.device.velocity_mps = tuple(0.4 * f / size for f in force)
        rig.tick()
        if rig.mode is Mode.TRIPPED:
            break
    assert rig.cause is Cause.OUTSIDE
    assert_the_motors_are_off(rig)


def test_lost_homing_is_zero_with_the_next_frame(rig):
    rig.following()
    rig.device.is_homed = False
    rig.tick(3)
    assert_the_motors_are_off(rig)
    rig.device.is_homed = True
    rig.tick(400)
    assert rig.mode is Mode.FOLLOWING
