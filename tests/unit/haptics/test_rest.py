"""Rest on a virtual clock: 20 Hz when nothing plays, 1 kHz before the first force."""

import math

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.haptics import loop as loops
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.guard import CHECK_PERIOD_S, Guard
from hapticplayer.haptics.limiter import PERIOD_S, ZERO
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.model import ForceTrack, PlaybackClock
from tests.doubles import SimulatedFalcon
from tests.rigs import LoopRig

CONSTANT = ForceTrack([0.0, 100.0], [[0, 2.0, 0], [0, 2.0, 0]])
WAKES_AFTER_S = 0.05


class BeatingClock(ManualClock):
    """The player beats whenever the loop sleeps, and acts at chosen times."""

    def __init__(self):
        super().__init__()
        self.acts = []
        self.rig = None

    def sleep_until(self, deadline_s):
        super().sleep_until(deadline_s)
        if not self.rig.loop.is_resting:  # then nobody has to
            self.rig.block.beat(self.now_s())
        while self.acts and self.acts[0][0] <= self.now_s():
            self.acts.pop(0)[1]()

    def wait(self, poll, deadline_s):
        while self.now_s() < deadline_s and not poll.poll(0.0):
            self.sleep_until(min(self.now_s() + 0.001, deadline_s))


@pytest.fixture
def rig(monkeypatch):
    monkeypatch.setattr(loops, "REST_AFTER_S", WAKES_AFTER_S)
    made = LoopRig(BeatingClock(), SimulatedFalcon())
    made.clock.rig = made
    made.block.beat_guard(math.inf)
    made.give_track(CONSTANT)
    yield made
    made.close()


def publish(rig, rate, epoch=1):
    now_s = rig.clock.now_s()
    rig.block.write_clock(PlaybackClock(epoch, now_s, 0.0, rate, now_s + 1e6), 1)
    if rate:
        rig.player.send(MessageKind.WAKE)


def run(rig, acts, until_s):
    """Run the loop with acts at times since its start; return its ticks."""
    start_s = rig.clock.now_s()
    rig.clock.acts = [(start_s + at_s, act) for at_s, act in acts]
    rig.clock.acts.append((start_s + until_s, rig.player.close))
    rig.loop.run()
    records, _, lost = rig.block.read_ticks(0)
    assert not lost
    return records, records["monotonic_s"] - start_s


def looked_at(rig, monkeypatch):
    """The times at which the device is asked, from now on."""
    times_s, exchange = [], rig.device.exchange

    def noted(force_n, now_s):
        times_s.append(now_s)
        return exchange(force_n, now_s)

    monkeypatch.setattr(rig.device, "exchange", noted)
    return times_s


def test_a_loop_without_work_rests_at_20_hz(rig, monkeypatch):
    looks_s, start_s = looked_at(rig, monkeypatch), rig.clock.now_s()
    records, time_s = run(rig, [(0.0, lambda: publish(rig, 0.0))], 2.0)
    looks_s = np.array(looks_s) - start_s
    between = (looks_s > 0.1) & (looks_s < 1.99)
    assert np.allclose(np.diff(looks_s[between]), 0.050, atol=1e-9)
    resting = (time_s > 0.1) & (time_s < 1.99)
    assert np.allclose(np.diff(time_s[resting]), loops.REST_TICK_S, atol=1e-9)
    assert np.allclose(np.diff(time_s[time_s < WAKES_AFTER_S]), PERIOD_S, atol=1e-9)
    assert set(records["cause"][resting]) == {Cause.PAUSED}  # no answer counts as late
    assert not records["missed"].any()


def test_the_loop_is_at_1_khz_again_before_the_first_force(rig):
    acts = [(0.0, lambda: publish(rig, 0.0)), (1.005, lambda: publish(rig, 1.0))]
    records, time_s = run(rig, acts, 2.0)
    first = int(np.argmax(records["mode"] == Mode.ENTERING))
    assert 1.005 <= time_s[first] < 1.005 + 0.004
    assert time_s[first] - time_s[first - 1] == pytest.approx(PERIOD_S)
    assert not records["force_n"][:first].any()
    assert np.abs(np.diff(records["force_n"][:-20, 1])).max() < 0.051
    assert records["force_n"][time_s < 1.9][-1, 1] == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("fault", "cause", "within_s"),
    [
        (lambda rig: rig.player.send(MessageKind.STOP), Cause.STOPPED, 0.002),
        (
            lambda rig: setattr(rig.device.simulation, "buttons", 1),
            Cause.GRIP_BUTTON,
            0.050,
        ),
        (lambda rig: rig.device.unplug(), Cause.UNPLUGGED, 0.050),
    ],
)
def test_at_rest_a_trip_is_noticed_soon(rig, fault, cause, within_s):
    acts = [(0.0, lambda: publish(rig, 0.0)), (1.005, lambda: fault(rig))]
    records, time_s = run(rig, acts, 1.2)
    tripped = time_s[records["mode"] == Mode.TRIPPED]
    assert 1.005 <= tripped[0] <= 1.005 + within_s + 1e-9
    assert records["cause"][time_s >= tripped[0]][0] == cause
    assert not records["force_n"].any()


def test_a_tripped_loop_rests_and_can_be_armed_again(rig):
    acts = [
        (0.0, lambda: publish(rig, 1.0)),
        (0.5, lambda: rig.player.send(MessageKind.STOP)),
        (1.5, lambda: publish(rig, 0.0)),
        (2.6, lambda: rig.player.send(MessageKind.REARM)),
        (2.7, lambda: publish(rig, 1.0, epoch=2)),
    ]
    records, time_s = run(rig, acts, 3.6)
    waits_s = np.diff(time_s[(time_s > 1.8) & (time_s < 2.59)])  # the hand still creeps
    assert waits_s.min() + 1e-9 > loops.REST_PERIOD_S
    assert waits_s.max() < loops.REST_TICK_S + 1e-9
    assert records["force_n"][time_s < 3.5][-1, 1] == pytest.approx(2.0)


def test_a_grip_that_moves_at_rest_is_followed(rig):
    def move():
        rig.device.simulation.aim((0.01, 0.0, 0.0))

    acts = [(0.0, lambda: publish(rig, 0.0)), (1.0, move)]
    records, time_s = run(rig, acts, 2.0)
    moving = (time_s > 1.05) & (time_s < 1.3)
    assert np.allclose(np.diff(time_s[moving]), 0.050, atol=1e-9)
    assert records["position_m"][time_s < 1.99][-1, 0] > 0.002


def test_no_force_begins_before_the_guard_has_woken(rig):
    asleep_s = rig.clock.now_s()
    rig.block.beat_guard(asleep_s)
    acts = [
        (0.0, lambda: publish(rig, 0.0)),
        (1.0, lambda: publish(rig, 1.0)),
        (1.03, lambda: rig.block.beat_guard(math.inf)),
    ]
    records, time_s = run(rig, acts, 1.5)
    first = int(np.argmax(records["mode"] == Mode.ENTERING))
    assert 1.03 <= time_s[first] < 1.03 + 0.003
    waiting = (time_s > 1.003) & (time_s < 1.03)
    assert set(records["cause"][waiting]) == {Cause.GUARD_LOST}
    resting = (time_s > 0.3) & (time_s < 0.99)
    assert set(records["cause"][resting]) == {Cause.PAUSED}


def test_the_guard_leaves_a_resting_loop_alone(rig):
    zeros = []
    guard = Guard(rig.clock, rig.block, lambda: bool(zeros.append(ZERO)))
    acts = [(at_ms / 1e3, guard.check) for at_ms in range(0, 1000, 7)]
    run(rig, [(0.0, lambda: publish(rig, 0.0)), *acts], 1.0)
    assert zeros == []
    assert rig.block.last_tick_s() > 0.0  # its end is not resting
    assert CHECK_PERIOD_S < loops.REST_PERIOD_S  # a loop that wakes is watched in time
