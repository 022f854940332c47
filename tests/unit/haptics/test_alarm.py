"""A signal stops the loop at its next tick, whatever the player's thread does."""

import signal
import socket

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import ZERO
from hapticplayer.haptics.messages import (
    Alarm,
    MessageKind,
    MessageSocket,
    signal_alarm,
)
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.model import ForceTrack
from tests.unit.haptics.test_loop import CONSTANT, Rig
from tests.unit.haptics.test_process import follow


@pytest.fixture
def alarm():
    """The alarm of one test."""
    write_end, read_end = socket.socketpair()
    write_end.setblocking(False)
    read_end.setblocking(False)
    with write_end, read_end:
        yield Alarm(write_end, read_end)


@pytest.fixture
def rig(alarm):
    """A loop that polls it, and has a force on the hand."""
    rig = Rig()
    rig.loop.line = MessageSocket(rig.line._end, alarm.read_end.fileno())
    rig.give_track(CONSTANT)
    rig.play()
    assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))
    yield rig
    rig.close()


def test_the_next_tick_trips_and_stays_so(alarm, rig):
    alarm.write_end.send(b"\x02")
    state = rig.tick()
    assert (state.force_n, state.mode) == (ZERO, Mode.TRIPPED)
    assert state.cause is Cause.STOPPED
    rig.player.send(MessageKind.REARM)
    assert rig.tick(5).mode is Mode.TRIPPED


def test_once_cleared_a_person_may_re_arm(alarm, rig):
    alarm.write_end.send(b"\x02\x0f")
    assert rig.tick().mode is Mode.TRIPPED
    alarm.clear()
    alarm.clear()  # there may be nothing to clear
    rig.player.send(MessageKind.REARM)
    assert rig.tick(400).force_n == pytest.approx((0.0, 2.0, 0.0))


def test_messages_are_handled_while_the_alarm_is_on(alarm, rig):
    alarm.write_end.send(b"\x02")
    rig.tick()
    rig.player.send(MessageKind.QUIT)
    rig.tick(2)
    assert rig.loop.is_over


def test_the_end_of_an_alarm_is_not_an_alarm(alarm, rig):
    alarm.write_end.close()
    assert rig.tick(10).force_n == pytest.approx((0.0, 2.0, 0.0))
    assert not rig.loop.is_over


def _has_stopped(ticks):
    return (ticks["cause"] == Cause.STOPPED).any()


@pytest.mark.realtime
def test_the_loop_stops_before_the_players_handler_runs():
    clock, handled_s = SystemClock(), []
    process = HapticsProcesses(clock)
    alarm = signal_alarm()
    before = signal.signal(signal.SIGALRM, lambda *_: handled_s.append(clock.now_s()))
    wakeup = signal.set_wakeup_fd(alarm.write_end.fileno(), warn_on_full_buffer=False)
    try:
        process.wait_ready()
        track = ForceTrack([0.0, 1e4], [[0, 0, 2.0], [0, 0, 2.0]])
        process.load({"track": track})
        follow(process, clock, lambda r: r["force_n"][-1:, 2].sum() > 1.99)
        values = [*range(1000, 0, -1)] * 2000
        signal.setitimer(signal.ITIMER_REAL, 0.02)
        sorted(values)  # holds the interpreter for much longer: the handler comes after
        ticks = follow(process, clock, _has_stopped)
    finally:
        signal.set_wakeup_fd(wakeup)
        signal.signal(signal.SIGALRM, before)
        alarm.clear()
        process.close()
    stopped = ticks[ticks["cause"] == Cause.STOPPED]
    assert stopped["monotonic_s"][0] < handled_s[0]
    assert not stopped["force_n"].any()
