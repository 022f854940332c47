"""The death of a player is seen in memory, before the kernel has taken it down."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.lifeline import map_lifeline
from hapticplayer.haptics.limiter import ZERO
from hapticplayer.linux import anonymous_memory
from tests.unit.haptics.test_loop import CONSTANT, Rig

HOLDER = """
import sys, threading
from hapticplayer.haptics.lifeline import hold_lifeline
if sys.argv[1] == "main":
    number = hold_lifeline()
else:
    numbers = []
    thread = threading.Thread(target=lambda: numbers.append(hold_lifeline()))
    thread.start()
    thread.join()
    number = numbers[0]
assert hold_lifeline() == number
print(number, flush=True)
sys.stdin.read()
"""


def holder(who):
    """Start a process that holds a lifeline; return it and what a loop would have."""
    process = subprocess.Popen(
        [sys.executable, "-c", HOLDER, who],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    number = int(process.stdout.readline())
    path = Path(f"/proc/{process.pid}/fd/{number}")
    return process, map_lifeline(os.open(path, os.O_RDWR))


def end(process):
    process.kill()
    process.wait()
    process.stdin.close()
    process.stdout.close()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSEGV])
def test_a_lifeline_is_cut_by_the_death_of_who_holds_it(number):
    process, lifeline = holder("main")
    try:
        assert not lifeline.is_cut()
        process.send_signal(number)
        process.wait()
        assert lifeline.is_cut()
    finally:
        end(process)


def test_a_thread_that_comes_and_goes_cuts_nothing():
    process, lifeline = holder("another")
    try:
        assert not lifeline.is_cut()
    finally:
        end(process)


def test_a_loop_without_a_player_trips_at_its_next_tick():
    descriptor = anonymous_memory("test", os.sysconf("SC_PAGESIZE"))
    rig = Rig()
    rig.loop.lifeline = map_lifeline(os.dup(descriptor))
    try:
        rig.give_track(CONSTANT)
        rig.play()
        assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))
        assert not rig.loop.is_over
        os.pwrite(descriptor, (0x4000_0000).to_bytes(4, sys.byteorder), 0)
        state = rig.tick()
        assert (state.force_n, state.mode, state.cause) == (
            ZERO,
            Mode.TRIPPED,
            Cause.PLAYER_GONE,
        )
        assert rig.loop.is_over
    finally:
        rig.close()
        os.close(descriptor)
