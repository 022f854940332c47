"""A signal stops the loop within four periods, whatever the player's thread does."""

import signal
import socket

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.alarm import Alarm, alarm
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import ZERO
from hapticplayer.haptics.messages import RESTS, Line, Word
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.model import ForceTrack
from tests.unit.haptics.test_loop import CONSTANT, Rig
from tests.unit.haptics.test_process import follow


@pytest.fixture
def bell():
    """The alarm of one test."""
    bell, ear = socket.socketpair()
    bell.setblocking(False)
    ear.setblocking(False)
    with bell, ear:
        yield Alarm(bell, ear)


@pytest.fixture
def rig(bell):
    """A loop that listens for it, and has a force on the hand."""
    rig = Rig()
    rig.loop.line = Line(rig.line._end, bell.ear.fileno(), inbox=rig.block.outbox)
    rig.give_track(CONSTANT)
    rig.play()
    assert rig.tick(300).force_n == pytest.approx((0.0, 2.0, 0.0))
    yield rig
    rig.close()


@pytest.mark.parametrize("phase", range(RESTS + 1))
def test_the_fourth_tick_trips_at_the_latest_and_stays_so(bell, rig, phase):
    rig.tick(phase)
    bell.bell.send(b"\x02")
    state = rig.tick(RESTS + 1)
    assert (state.force_n, state.mode) == (ZERO, Mode.TRIPPED)
    assert state.cause is Cause.STOPPED
    rig.player.send(Word.REARM)
    assert rig.tick(5).mode is Mode.TRIPPED


def test_once_silenced_a_person_may_re_arm(bell, rig):
    bell.bell.send(b"\x02\x0f")
    assert rig.tick(RESTS + 1).mode is Mode.TRIPPED
    bell.silence()
    bell.silence()  # there may be nothing to be taken
    rig.player.send(Word.REARM)
    assert rig.tick(400).force_n == pytest.approx((0.0, 2.0, 0.0))


def test_messages_are_obeyed_while_it_sounds(bell, rig):
    bell.bell.send(b"\x02")
    rig.tick(RESTS + 1)
    rig.player.send(Word.QUIT)
    rig.tick(2)
    assert rig.loop.is_over


def test_an_alarm_that_hangs_up_is_no_alarm(bell, rig):
    bell.bell.close()
    assert rig.tick(10).force_n == pytest.approx((0.0, 2.0, 0.0))
    assert not rig.loop.is_over


def _has_stopped(ticks):
    return (ticks["cause"] == Cause.STOPPED).any()


def test_the_loop_stops_before_the_players_handler_runs():
    clock, handled_s = SystemClock(), []
    process = HapticsProcesses(clock)
    ring = alarm()
    before = signal.signal(signal.SIGALRM, lambda *_: handled_s.append(clock.now_s()))
    wakeup = signal.set_wakeup_fd(ring.bell.fileno(), warn_on_full_buffer=False)
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
        ring.silence()
        process.close()
    stopped = ticks[ticks["cause"] == Cause.STOPPED]
    assert stopped["monotonic_s"][0] < handled_s[0]
    assert not stopped["force_n"].any()
