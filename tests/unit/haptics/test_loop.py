"""The loop itself on a virtual clock: deadlines, skipping, listening, ending."""

import math
import os

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.follower import CHECKED_PER_TICK
from hapticplayer.haptics.limiter import PERIOD_S, ZERO
from hapticplayer.haptics.loop import ZERO_TICKS_BEFORE_CLOSING
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.linux import CpuLatencyRequest, anonymous_memory
from hapticplayer.model import ForceTrack, PlaybackClock
from tests.doubles import SimulatedFalcon
from tests.rigs import LoopRig


class StallingClock(ManualClock):
    """Wakes late at chosen deadlines, and hangs up after a number of them."""

    def __init__(self, stalls, wakes):
        super().__init__()
        self.stalls, self.line, self.wakes = dict(stalls), None, wakes
        self.count = 0

    def sleep_until(self, deadline_s):
        super().sleep_until(deadline_s)
        self.advance(self.stalls.get(self.count, 0.0))
        self.count += 1
        if self.count == self.wakes:
            self.line.close()


class Rig(LoopRig):
    """A loop with a simulated Falcon."""

    def __init__(self, clock=None):
        super().__init__(clock or ManualClock(), SimulatedFalcon())
        self.block.beat_guard(math.inf)

    def play(self, track_id=1, epoch=1):
        now_s = self.clock.now_s()
        clock = PlaybackClock(epoch, now_s, 0.0, 1.0, now_s + 1e6)
        self.block.write_clock(clock, track_id)

    def tick(self, count=1):
        for _ in range(count):
            self.clock.advance(PERIOD_S)
            self.block.beat(self.clock.now_s())
            self.loop.tick(self.clock.now_s())
        return self.loop.state


@pytest.fixture
def rig():
    made = Rig()
    yield made
    made.close()


CONSTANT = ForceTrack([0.0, 100.0], [[0, 2.0, 0], [0, 2.0, 0]])


def test_a_track_and_a_clock_make_a_force(rig):
    rig.give_track(CONSTANT)
    rig.play()
    assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))
    records, _, _ = rig.block.read_ticks(0)
    assert len(records) == 300
    assert records["position_m"][-1, 1] > 0.005  # the simulated hand gives way upwards


def test_a_long_track_is_checked_a_part_at_every_tick(rig):
    rows = CHECKED_PER_TICK // 4 * 50 + 1
    time_s = np.linspace(0.0, 100.0, rows)
    rig.give_track(ForceTrack(time_s, np.tile([0, 2.0, 0], (rows, 1))))
    rig.play()
    assert rig.tick(50).mode is Mode.IDLE
    assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))


def test_a_clock_that_names_another_track_plays_none(rig):
    rig.give_track(CONSTANT)
    rig.play(track_id=2)
    assert rig.tick(50).force_n == ZERO


def test_a_track_that_comes_after_its_clock_is_still_found(rig):
    rig.play()
    rig.tick(5)
    rig.give_track(CONSTANT)
    assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))


@pytest.mark.parametrize("clocks", [1, 2, 3, 4])
def test_of_the_clocks_between_two_ticks_the_last_one_counts(rig, clocks):
    rig.give_track(CONSTANT)
    rig.play()
    rig.tick(300)
    for number in range(clocks):
        rig.play(epoch=2 + number)
    rig.tick(300)
    assert (rig.loop.state.mode, rig.loop.state.epoch) == (Mode.FOLLOWING, 1 + clocks)


def test_stop_is_obeyed_at_the_next_tick(rig):
    rig.give_track(CONSTANT)
    rig.play()
    rig.tick(300)
    rig.player.send(MessageKind.STOP)
    state = rig.tick()
    assert (state.force_n, state.mode, state.cause) == (
        ZERO,
        Mode.TRIPPED,
        Cause.STOPPED,
    )
    rig.player.send(MessageKind.REARM)
    assert rig.tick(300).mode is Mode.FOLLOWING


def test_a_stop_also_drops_what_has_not_acted_yet(rig):
    """Once at each stop, and not when a clip is paused: that fades out."""
    forgotten, rig.device.forget = [], lambda: forgotten.append(rig.loop.count)
    rig.give_track(CONSTANT)
    rig.play()
    rig.tick(300)
    rig.play(epoch=2)
    rig.tick(300)
    assert forgotten == []
    rig.player.send(MessageKind.STOP)
    rig.tick(20)
    assert forgotten == [600]


def test_a_closed_line_trips_at_the_next_tick(rig):
    rig.give_track(CONSTANT)
    rig.play()
    rig.tick(300)
    rig.player.close()
    state = rig.tick()
    assert (state.force_n, state.cause) == (ZERO, Cause.PLAYER_GONE)


def test_an_invalid_track_is_refused_and_the_loop_continues(rig):
    descriptor = anonymous_memory("bad", 10)
    rig.player.send(MessageKind.TRACK, "1", descriptor)
    os.close(descriptor)
    rig.tick(2)
    message = rig.player.receive()
    assert message.word is MessageKind.FAILED
    assert "does not match" in message.text


def test_missed_periods_are_skipped_and_counted_never_caught_up():
    clock = StallingClock({10: 0.0075, 20: 0.0004, 30: 0.051}, wakes=100)
    rig = Rig(clock)
    clock.line = rig.player
    rig.loop.run()
    rig.close()
    records, _, _ = rig.block.read_ticks(0)
    assert records["missed"].sum() == 7 + 51
    assert len(records) == 100 + ZERO_TICKS_BEFORE_CLOSING - 1
    # after a stall the next tick is on the grid again, never sooner than that
    grid_ms = (records["monotonic_s"] - records["lateness_s"]) * 1e3
    steps = np.diff(grid_ms)
    assert np.allclose(steps, np.round(steps), atol=1e-3)
    assert steps.min() > 0.999
    assert np.diff(records["monotonic_s"]).min() > 0.0004


def test_the_last_packets_are_zero():
    clock = StallingClock({}, wakes=400)
    rig = Rig(clock)
    rig.give_track(CONSTANT)
    rig.play()
    clock.line = rig.player
    rig.block.beat(clock.now_s() + 100.0)
    rig.loop.run()
    rig.close()
    records, _, _ = rig.block.read_ticks(0)
    assert np.linalg.norm(records["force_n"][398]) == pytest.approx(2.0)
    assert not records["force_n"][399:].any()
    assert len(records) == 399 + ZERO_TICKS_BEFORE_CLOSING


def test_processors_are_kept_awake_only_while_a_force_may_be_on(tmp_path):
    kernel = tmp_path / "cpu_dma_latency"
    kernel.touch()
    rig = Rig()
    rig.loop.cpu_latency = CpuLatencyRequest(kernel)
    rig.give_track(CONSTANT)
    rig.tick(20)
    assert not kernel.read_bytes()
    rig.play()
    rig.block.beat(rig.clock.now_s() + 100.0)
    rig.tick(200)
    assert np.frombuffer(kernel.read_bytes(), "=i4").tolist() == [0]
    rig.player.send(MessageKind.STOP)
    rig.tick(200)
    rig.close()
    assert np.frombuffer(kernel.read_bytes(), "=i4").tolist() == [0, -1]


@pytest.mark.parametrize("file", ["nothing is there", "/dev/full"])
def test_a_loop_refused_the_latency_request_still_plays(file, tmp_path):
    rig = Rig()
    rig.loop.cpu_latency = CpuLatencyRequest(tmp_path / file)
    rig.give_track(CONSTANT)
    rig.play()
    rig.block.beat(rig.clock.now_s() + 100.0)
    rig.tick(300)
    records, _, _ = rig.block.read_ticks(0)
    rig.close()
    assert np.linalg.norm(records["force_n"][-1]) == pytest.approx(2.0)
