"""The guard on a virtual clock: when it writes zero, and when it leaves the loop alone."""

import ctypes
import mmap
import os
import signal
import subprocess
import sys
import threading
from functools import partial
from itertools import pairwise

import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.haptics.block import RESTING
from hapticplayer.haptics.guard import (
    CHECK_PERIOD_S,
    FINAL_ZEROS,
    REPEAT_PERIOD_S,
    Guard,
    LoopProcess,
)
from hapticplayer.haptics.lifeline import LIFELINE_BYTES, Lifeline
from hapticplayer.haptics.shared import BLOCK_BYTES, TICK, SharedBlock
from hapticplayer.linux import anonymous_memory

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
        self.guard = Guard(self.clock, self.block, self.send_zero)
        self.count = 0

    def send_zero(self):
        self.zeros.append(self.clock.now_s())
        return self.is_there

    def loop_ticks(self):
        self.block.write_tick(self.count, self.clock.now_s(), *[0] * FIELDS)
        self.count += 1

    def check_for(self, duration_s, *, ticking):
        for _ in range(round(duration_s / REPEAT_PERIOD_S)):
            self.clock.advance(REPEAT_PERIOD_S)
            if ticking:
                self.loop_ticks()
            self.guard.check()


@pytest.fixture
def bench():
    return Bench()


def test_a_loop_that_ticks_is_left_alone_and_the_guard_beats(bench):
    bench.check_for(1.0, ticking=True)
    assert bench.zeros == []
    assert bench.block.guard_s() == bench.clock.now_s()


def test_before_the_first_tick_nothing_is_sent(bench):
    bench.check_for(1.0, ticking=False)
    assert bench.zeros == []


@pytest.mark.parametrize("phase", range(20))
def test_a_stalled_loop_is_silenced_within_a_poll_after_20_ms(bench, phase):
    bench.check_for(0.1, ticking=True)
    bench.clock.advance(phase * REPEAT_PERIOD_S / 20)
    bench.loop_ticks()
    stopped_s = bench.clock.now_s()
    bench.check_for(0.06, ticking=False)
    waited_s = bench.zeros[0] - stopped_s
    assert 0.020 < waited_s <= 0.020 + REPEAT_PERIOD_S + 1e-9
    assert len(bench.zeros) >= 9  # and at each check after that


def test_a_loop_that_continues_is_left_alone_again(bench):
    bench.check_for(0.1, ticking=True)
    bench.check_for(0.1, ticking=False)
    bench.zeros.clear()
    bench.check_for(0.1, ticking=True)
    assert bench.zeros == []


def test_a_dead_loop_leaves_zeros_on_the_wire(bench):
    bench.guard.send_final_zeros()
    assert len(bench.zeros) == FINAL_ZEROS


def test_without_a_device_one_zero_is_tried(bench):
    bench.is_there = False
    bench.guard.send_final_zeros()
    assert len(bench.zeros) == 1


class Ticking:
    """A loop's process that ticks until it stalls, and that ends at a time."""

    def __init__(self, bench, stalls_s, ends_s):
        self.bench, self.stalls_s, self.ends_s = bench, stalls_s, ends_s
        self.next_tick_s = bench.clock.now_s() + 0.0003
        self.checks = []  # when, and how long after a tick

    def has_ended(self, timeout_s):
        clock = self.bench.clock
        until_s = min(clock.now_s() + timeout_s, max(self.ends_s, clock.now_s()))
        while self.next_tick_s <= until_s:
            clock.sleep_until(self.next_tick_s)
            self.next_tick_s += 0.001
            if clock.now_s() < self.stalls_s:
                self.bench.loop_ticks()
        clock.sleep_until(until_s)
        self.checks.append((until_s, until_s - self.next_tick_s + 0.001))
        return until_s >= self.ends_s


def test_the_checks_fall_between_the_ticks_and_are_few(bench):
    end_s = bench.clock.now_s() + 1.0
    loop = Ticking(bench, end_s, end_s)
    bench.guard.run(loop)
    phases_s = [phase_s for _, phase_s in loop.checks]
    assert 50 <= len(phases_s) <= 60
    assert phases_s[2:-2] == pytest.approx([0.0005] * (len(phases_s) - 4))
    assert len(bench.zeros) == FINAL_ZEROS  # none before its end


@pytest.mark.parametrize("phase", range(20))
def test_the_end_of_a_loop_is_followed_by_zeros_at_once(bench, phase):
    ends_s = bench.clock.now_s() + 0.1 + phase * CHECK_PERIOD_S / 20
    bench.guard.run(Ticking(bench, ends_s, ends_s))
    assert bench.zeros[0] == pytest.approx(ends_s)
    assert len(bench.zeros) == FINAL_ZEROS


HOLDER = """
import mmap, sys
from hapticplayer.haptics.lifeline import hold
memory = mmap.mmap(int(sys.argv[1]), mmap.PAGESIZE)
release = hold(memoryview(memory))
print("held", flush=True)
if input() == "release":
    release()
    print("released", flush=True)
    input()
"""


class Holder:
    """A real process with a lifeline, and the guard's view of it."""

    def __init__(self):
        descriptor = anonymous_memory("test", mmap.PAGESIZE)
        self.pipe, held = os.pipe()
        self.page = mmap.mmap(descriptor, mmap.PAGESIZE)
        self.lifeline = Lifeline(memoryview(self.page)[:LIFELINE_BYTES])
        command = [sys.executable, "-c", HOLDER, str(descriptor)]
        self.child = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            pass_fds=[descriptor, held],
            text=True,
        )
        os.close(descriptor)
        os.close(held)
        self.process = LoopProcess(self.pipe, self.lifeline)

    def listen(self):
        return self.child.stdout.readline().strip()

    def say(self, text):
        self.child.stdin.write(text + "\n")
        self.child.stdin.flush()

    def end(self):
        self.child.kill()
        self.child.wait()
        for end in (self.child.stdin, self.child.stdout):
            end.close()
        os.close(self.pipe)


@pytest.fixture
def holder():
    holder = Holder()
    yield holder
    holder.end()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSEGV, signal.SIGTERM])
def test_the_end_of_a_loop_wakes_the_guard(holder, number):
    assert holder.listen() == "held"
    assert holder.lifeline.wakes()
    assert not holder.process.has_ended(0.001)
    threading.Timer(0.05, holder.child.send_signal, [number]).start()
    clock = SystemClock()
    begin_s = clock.now_s()
    assert holder.lifeline.wait(60.0)
    assert clock.now_s() - begin_s < 60.0  # woken: it did not wait in vain
    assert holder.process.has_ended(60.0)


def test_a_released_lifeline_leaves_it_to_the_pipe(holder):
    assert holder.listen() == "held"
    holder.say("release")
    assert holder.listen() == "released"
    assert not holder.lifeline.wakes()
    assert not holder.process.has_ended(0.0)
    holder.child.kill()
    holder.child.wait()
    assert not holder.lifeline.is_cut()
    assert holder.process.has_ended(0.0)


def test_a_loop_that_leaves_its_rest_wakes_the_guard(holder):
    assert holder.listen() == "held"
    found = []
    guard = threading.Thread(
        target=lambda: found.append(holder.lifeline.wait(600.0)), daemon=True
    )
    guard.start()
    other = Lifeline(memoryview(holder.page)[:LIFELINE_BYTES])
    while guard.is_alive():  # it may not sleep yet
        other.end()
        guard.join(0.001)
    assert found == [False]


def test_a_guard_sleeps_longer_while_the_loop_rests(bench):
    bench.loop_ticks()
    bench.block.beat_loop(RESTING)
    ends_s = bench.clock.now_s() + 10.0
    loop = Ticking(bench, bench.clock.now_s(), ends_s)
    bench.guard.run(loop)
    assert len(loop.checks) <= 11
    assert len(bench.zeros) == FINAL_ZEROS


def test_a_system_that_refuses_to_wait_is_asked_once(holder, monkeypatch):
    assert holder.listen() == "held"
    library = ctypes.CDLL(None, use_errno=True)
    refused = partial(library.syscall, ctypes.c_long(1_000_000))  # no such call
    monkeypatch.setattr(holder.lifeline, "_sleep", refused)
    assert not holder.lifeline.wait(60.0)
    assert not holder.lifeline.wakes()
    assert not holder.process.has_ended(0.0)


def test_an_end_before_the_wait_is_seen(holder):
    assert holder.listen() == "held"
    holder.child.kill()
    holder.child.wait()
    assert holder.lifeline.wait(60.0)
    assert holder.process.has_ended(60.0)


def test_a_device_that_fades_alone_is_silenced_only_at_the_end(bench):
    bench.guard = Guard(bench.clock, bench.block, bench.send_zero, watches_stalls=False)
    stalls_s = bench.clock.now_s() + 0.1
    bench.guard.run(Ticking(bench, stalls_s, stalls_s + 0.3))
    assert len(bench.zeros) == FINAL_ZEROS
    assert bench.zeros[0] == pytest.approx(stalls_s + 0.3, abs=REPEAT_PERIOD_S)


@pytest.mark.parametrize("phase", range(20))
def test_a_loop_that_stalls_for_20_ms_is_silenced(bench, phase):
    stalls_s = bench.clock.now_s() + 0.1 + phase * CHECK_PERIOD_S / 20
    bench.guard.run(Ticking(bench, stalls_s, stalls_s + 0.1))
    last_s = bench.block.last_tick_s()
    assert 0.020 < bench.zeros[0] - last_s <= 0.0202
    waits_s = [b - a for a, b in pairwise(bench.zeros[:-FINAL_ZEROS])]
    assert waits_s
    assert max(waits_s) <= REPEAT_PERIOD_S + 1e-9
