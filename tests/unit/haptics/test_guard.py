"""The guard on a virtual clock: when it writes zero, and when it leaves the loop alone."""

import os
import signal
import subprocess
import sys
from itertools import pairwise

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.haptics.guard import LAST_ZEROS, LOOK_PERIOD_S, Guard, LoopProcess
from hapticplayer.haptics.shared import BLOCK_BYTES, TICK, SharedBlock
from hapticplayer.haptics.track import anonymous_memory

FIELDS = len(TICK.descr) - 1 + 4 * 2 + 2  # five vectors of three, without the time


class Bench:
    """A guard, a loop that may stop, and what reached the device."""

    def __init__(self):
        descriptor = anonymous_memory("test", BLOCK_BYTES)
        self.block = SharedBlock(descriptor)
        os.close(descriptor)
        self.clock = ManualClock()
        self.zeros = []
        self.is_there = True
        self.guard = Guard(self.clock, self.block, self.silence)
        self.count = 0

    def silence(self):
        self.zeros.append(self.clock.now_s())
        return self.is_there

    def loop_ticks(self):
        self.block.write_tick(self.count, self.clock.now_s(), *[0] * FIELDS)
        self.count += 1

    def look_for(self, duration_s, *, ticking):
        for _ in range(round(duration_s / LOOK_PERIOD_S)):
            self.clock.advance(LOOK_PERIOD_S)
            if ticking:
                self.loop_ticks()
            self.guard.look()


@pytest.fixture
def bench():
    return Bench()


def test_a_loop_that_ticks_is_left_alone_and_the_guard_beats(bench):
    bench.look_for(1.0, ticking=True)
    assert bench.zeros == []
    assert bench.block.guard_s() == bench.clock.now_s()


def test_before_the_first_tick_there_is_nothing_to_silence(bench):
    bench.look_for(1.0, ticking=False)
    assert bench.zeros == []


@pytest.mark.parametrize("phase", range(20))
def test_a_loop_that_stands_still_is_silenced_within_a_look_after_20_ms(bench, phase):
    bench.look_for(0.1, ticking=True)
    bench.clock.advance(phase * LOOK_PERIOD_S / 20)
    bench.loop_ticks()
    stopped_s = bench.clock.now_s()
    bench.look_for(0.06, ticking=False)
    waited_s = bench.zeros[0] - stopped_s
    assert 0.020 < waited_s <= 0.020 + LOOK_PERIOD_S + 1e-9
    assert len(bench.zeros) >= 9  # and at each look after that


def test_a_loop_that_goes_on_is_left_alone_again(bench):
    bench.look_for(0.1, ticking=True)
    bench.look_for(0.1, ticking=False)
    bench.zeros.clear()
    bench.look_for(0.1, ticking=True)
    assert bench.zeros == []


def test_a_dead_loop_leaves_zeros_on_the_wire(bench):
    bench.guard.bury()
    assert len(bench.zeros) == LAST_ZEROS


def test_without_a_device_there_is_nothing_to_bury(bench):
    bench.is_there = False
    bench.guard.bury()
    assert len(bench.zeros) == 1


class Dying:
    """A loop's process that dies at a time, and of which the kernel tells late."""

    def __init__(self, bench, dies_s, told_s):
        self.bench, self.dies_s, self.told_s = bench, dies_s, told_s
        self.next_tick_s = bench.clock.now_s() + 0.0003
        self.phases_s = []

    def has_ended(self, timeout_s):
        clock = self.bench.clock
        until_s = clock.now_s() + timeout_s
        while self.next_tick_s <= until_s:
            clock.sleep_until(self.next_tick_s)
            self.next_tick_s += 0.001
            if not self.is_dying():
                self.bench.loop_ticks()
        clock.sleep_until(until_s)
        self.phases_s.append(until_s - self.next_tick_s + 0.001)
        return clock.now_s() >= self.told_s

    def is_dying(self):
        return self.bench.clock.now_s() >= self.dies_s


def test_the_looks_fall_between_the_ticks(bench):
    now_s = bench.clock.now_s()
    loop = Dying(bench, now_s + 0.2, now_s + 0.2)
    bench.guard.run(loop)
    assert len(loop.phases_s) >= 50
    assert loop.phases_s[2:-2] == pytest.approx([0.0005] * (len(loop.phases_s) - 4))


@pytest.mark.parametrize("phase", range(20))
def test_a_loop_that_dies_slowly_is_buried_before_the_kernel_tells(bench, phase):
    dies_s = bench.clock.now_s() + 0.1 + phase * LOOK_PERIOD_S / 20
    bench.guard.run(Dying(bench, dies_s, dies_s + 0.1))
    assert 0.0 <= bench.zeros[0] - dies_s <= LOOK_PERIOD_S + 0.002
    assert len(bench.zeros) == LAST_ZEROS


def test_the_kernel_tells_of_a_living_a_dead_and_a_reaped_process():
    child = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    descriptor = os.pidfd_open(child.pid)
    loop = LoopProcess(descriptor)
    assert not loop.has_ended(0.0)
    assert not loop.is_dying()
    child.send_signal(signal.SIGKILL)
    assert loop.has_ended(10.0)
    assert loop.is_dying()  # a zombie
    child.communicate()
    assert loop.is_dying()
    assert LoopProcess(descriptor).is_dying()
    os.close(descriptor)


@pytest.mark.parametrize("phase", range(20))
def test_a_loop_that_stands_still_is_silenced_as_soon_as_it_did_for_20_ms(bench, phase):
    stands_s = bench.clock.now_s() + 0.1 + phase * LOOK_PERIOD_S / 20
    loop = Dying(bench, stands_s, stands_s + 0.1)
    loop.is_dying = lambda: False
    ticks = bench.loop_ticks

    def tick():
        if bench.clock.now_s() < stands_s:
            ticks()

    bench.loop_ticks = tick
    bench.guard.run(loop)
    last_s = bench.block.last_tick_s()
    assert 0.020 < bench.zeros[0] - last_s <= 0.0202
    waits_s = [b - a for a, b in pairwise(bench.zeros[:-LAST_ZEROS])]
    assert waits_s
    assert max(waits_s) <= LOOK_PERIOD_S + 1e-9
