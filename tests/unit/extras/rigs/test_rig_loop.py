"""A rig's loop and guard on a virtual clock: ramps, neutral packets, time, silence."""

import itertools
import math
import os
import socket

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.clock import ManualClock
from hapticplayer.errors import DeviceError
from hapticplayer.extras.rigs.loop import RigGuard, RigLoop
from hapticplayer.extras.rigs.packets import FORMATS
from hapticplayer.extras.rigs.sender import RigSender
from hapticplayer.extras.rigs.settings import rig_settings
from hapticplayer.extras.rigs.step import CAPS, NEUTRAL_S, RAMP_S, TAKE_OVER_S
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.track import to_shared_memory
from hapticplayer.linux import anonymous_memory
from hapticplayer.model import PlaybackClock
from hapticplayer.model.rig import NEUTRAL, RigMotion
from hapticplayer.model.rig_track import RigTrack

STEADY = RigMotion(*(2.0, -1.0, 3.0), *(0.1, -0.2, 0.3), *[0.5] * 9)


class Sender:
    """Keeps (monotonic time, time in the packet, motion) of every packet."""

    def __init__(self, clock, text=""):
        self.settings, self.clock = rig_settings(text), clock
        self.packets = []
        self.is_heard, self.is_broken = True, False

    def open(self):
        self.packets = []

    def send(self, motion, time_s):
        if self.is_broken:
            raise DeviceError("the network is down")
        self.packets.append((self.clock.now_s(), time_s, motion))
        return self.is_heard


class Bench:
    """Player, loop and guard of a rig in one thread."""

    def __init__(self, text="", motion=STEADY):
        self.clock = ManualClock()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        descriptor = anonymous_memory("test", BLOCK_BYTES)
        self.block = SharedBlock(descriptor)
        os.close(descriptor)
        self.player, self.line = MessageSocket(ours), MessageSocket(theirs)
        self.sender = Sender(self.clock, text)
        self.loop = RigLoop(self.clock, self.block, self.line, self.sender)
        self.epoch, self.rate, self.beats = 1, 1.0, True
        self.block.beat_guard(math.inf)
        self.give(RigTrack([0.0, 1e3], [motion] * 2))

    def give(self, track, track_id=1):
        descriptor = to_shared_memory(track)
        self.player.send(MessageKind.TRACK, str(track_id), descriptor)
        os.close(descriptor)

    def run(self, duration_s, track_id=1):
        """Tick as often as the loop wants to; return the packets of this time."""
        first, end_s = len(self.sender.packets), self.clock.now_s() + duration_s
        while self.clock.now_s() < end_s - 1e-9:
            self.clock.advance(self.loop.period_s)
            now_s = self.clock.now_s()
            if self.beats:
                self.block.beat(now_s)
            clock = PlaybackClock(self.epoch, 999.0, 0.0, self.rate, now_s + 1.0)
            self.block.write_clock(clock, track_id)
            self.loop.tick(now_s)
        return self.sender.packets[first:]

    @property
    def state(self):
        return self.loop.rig.state

    def close(self):
        self.player.close()
        self.line.close()


@pytest.fixture
def bench():
    made = Bench()
    yield made
    made.close()


def size(packet):
    return math.hypot(*packet[2])


def assert_comes_to_rest(packets, begins_s):
    """Ramp of 0.5 s at least, neutral for 2 s at least, time that only grows."""
    moving = [p for p in packets if size(p) > 1e-6]
    neutral = [p for p in packets if p[0] > moving[-1][0]]
    assert moving[-1][0] - begins_s >= RAMP_S - 0.021
    assert all(p[2] == pytest.approx(NEUTRAL, abs=1e-6) for p in neutral)
    assert neutral[-1][0] - neutral[0][0] >= NEUTRAL_S - 0.02
    sizes = [size(p) for p in packets]
    assert all(b <= a + 1e-9 for a, b in itertools.pairwise(sizes))
    times = [p[1] for p in packets]
    assert all(b > a for a, b in itertools.pairwise(times))


def test_a_rig_fades_in_from_neutral_with_time_0(bench):
    packets = bench.run(2.0)
    assert packets[0][1] == 0.0
    assert packets[0][2] == NEUTRAL
    assert packets[-1][2] == pytest.approx(STEADY, rel=1e-6)
    steps = np.abs(np.diff([p[2] for p in packets], axis=0)).max()
    assert steps < 0.05  # of 3 m/s^2, in 5 ms
    assert bench.state.mode is Mode.FOLLOWING


@pytest.mark.parametrize("rate", [50, 200, 500])
def test_packets_come_as_often_as_was_chosen(rate):
    bench = Bench(f"outsim,rate={rate}")
    bench.run(1.0)
    assert len(bench.run(1.0)) == pytest.approx(rate, abs=1)
    bench.close()


def pause(bench):
    bench.rate, bench.epoch = 0.0, 2


def seek(bench):
    bench.epoch = 2


def stop(bench):
    bench.player.send(MessageKind.STOP)


def hang(bench):
    bench.beats = False


def die(bench):
    bench.player.close()


def quit_it(bench):
    bench.player.send(MessageKind.QUIT)


def break_track(bench):
    bench.loop._track.values_at = lambda _media_s: (math.nan,) * 15


@pytest.mark.parametrize(
    ("end", "cause"),
    [
        (pause, Cause.PAUSED),
        (seek, Cause.SEEK),
        (stop, Cause.STOPPED),
        (hang, Cause.HEARTBEAT_LATE),
        (die, Cause.PLAYER_GONE),
        (quit_it, Cause.CLOSING),
        (break_track, Cause.NOT_FINITE),
    ],
)
def test_every_end_is_a_ramp_and_neutral_packets(bench, end, cause):
    bench.run(2.0)
    end(bench)
    begins_s = bench.clock.now_s() + 0.151 * (end is hang)
    packets = bench.run(RAMP_S + NEUTRAL_S + 0.13 + 0.15 * (end is hang))
    records = bench.block.read_ticks(0)[0]
    assert cause in records["cause"]
    if end is seek:  # it plays on after that, from neutral and time 0
        again = [i for i, p in enumerate(packets) if p[1] == 0.0]
        packets = packets[: again[0]]
    assert_comes_to_rest(packets[int(200 * 0.15 * (end is hang)) :], begins_s)


def test_after_the_neutral_packets_there_is_silence(bench):
    bench.run(2.0)
    pause(bench)
    bench.run(RAMP_S + NEUTRAL_S + 0.1)
    assert bench.run(10.0) == []
    assert bench.state.mode is Mode.IDLE


def test_a_seek_starts_time_again_only_after_neutral(bench):
    bench.run(2.0)
    seek(bench)
    packets = bench.run(6.0)
    back = [i for i, (a, b) in enumerate(itertools.pairwise(packets)) if b[1] < a[1]]
    assert len(back) == 1
    before = [p for p in packets[: back[0] + 1] if size(p) == 0.0]
    assert before[-1][0] - before[0][0] >= NEUTRAL_S - 0.02
    assert packets[back[0] + 1][1:] == (0.0, NEUTRAL)
    assert packets[-1][2] == pytest.approx(STEADY, rel=1e-6)


def test_a_trip_is_latched_until_a_person_re_arms(bench):
    bench.run(2.0)
    stop(bench)
    bench.run(10.0)
    assert bench.state.mode is Mode.TRIPPED
    assert bench.run(5.0) == []
    bench.player.send(MessageKind.REARM)
    packets = bench.run(2.0)
    assert packets[0][1:] == (0.0, NEUTRAL)
    assert bench.state.mode is Mode.FOLLOWING


def test_re_arming_early_still_comes_to_rest_first(bench):
    bench.run(2.0)
    stop(bench)
    begins_s = bench.clock.now_s()
    packets = bench.run(0.2)
    bench.player.send(MessageKind.REARM)
    packets += bench.run(5.0)
    again = [i for i, p in enumerate(packets) if p[1] == 0.0]
    assert_comes_to_rest(packets[: again[0]], begins_s)


def test_no_track_means_no_packets(bench):
    assert bench.run(2.0, track_id=7) == []


def test_the_sign_of_an_axis_reaches_the_packet():
    bench = Bench("outsim,invert=sway")
    last = bench.run(2.0)[-1][2]
    assert last.right_mps2 == pytest.approx(-STEADY.right_mps2)
    assert last.front_mps2 == pytest.approx(STEADY.front_mps2)
    bench.close()


def test_no_packet_exceeds_the_caps():
    bench = Bench(motion=RigMotion(*[1e6, -1e6] * 7, 1e6))
    sent = np.array([p[2] for p in bench.run(2.0)])
    assert np.all(np.abs(sent) <= np.array(CAPS))
    assert np.abs(sent[-1]) == pytest.approx(np.array(CAPS))
    bench.close()


def test_a_receiver_that_is_not_there_yet_is_no_fault(bench):
    bench.sender.is_heard = False
    bench.run(2.0)
    assert bench.state.mode is Mode.FOLLOWING
    assert bench.block.read_ticks(0)[0]["buttons"][-1] == SENT | REFUSED


@pytest.mark.parametrize("name", list(FORMATS))
def test_a_rig_that_leaves_and_comes_back_is_noticed(name):
    """By what the network says of the packet before."""
    motion = STEADY
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        where = end.getsockname()
        sender = RigSender(rig_settings(f"{name},127.0.0.1:{where[1]}"))
        sender.open()
        assert sender.send(motion, 0.0)
        assert sender.send(motion, 0.1)
    assert [sender.send(motion, k / 10.0) for k in range(2, 6)][1:] == [False] * 3
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(where)
        heard = [sender.send(motion, k / 10.0) for k in range(6, 10)]
        assert heard[1:] == [True] * 3
        sender.close()


@pytest.mark.parametrize("name", list(FORMATS))
def test_a_rig_that_is_slow_or_answers_gets_its_packets(name):
    """One that reads nothing for a while, and one that sends errors nobody asked for."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        sender = RigSender(rig_settings(f"{name},127.0.0.1:{end.getsockname()[1]}"))
        sender.open()
        for k in range(200):
            assert sender.send(STEADY, k / 200.0)
            if k == 100:
                _, back = end.recvfrom(1000)
                for _ in range(300):
                    end.sendto(b"ERROR", back)
        sender.close()


def test_a_broken_network_trips_and_is_reported_once(bench):
    bench.run(2.0)
    bench.sender.is_broken = True
    bench.run(1.0)
    assert (bench.state.mode, bench.state.cause) == (Mode.TRIPPED, Cause.UNPLUGGED)
    received = [message for _ in range(5) if (message := bench.player.receive())]
    assert [message.word for message in received] == [MessageKind.LOST]


def guard_of(bench):
    """Return a guard whose packets come after those of the loop."""
    sender = Sender(bench.clock)
    sender.packets = bench.sender.packets
    return RigGuard(bench.clock, bench.block, sender)


def watched(guard, clock, duration_s):
    end_s = clock.now_s() + duration_s
    while clock.now_s() < end_s:
        clock.advance(0.005)
        guard.check()


def test_the_guard_leaves_a_loop_alone_that_sends(bench):
    guard = guard_of(bench)
    for _ in range(100):
        bench.run(0.01)
        assert not guard.check()
    assert len(bench.sender.packets) == pytest.approx(200, abs=4)


def test_the_guard_brings_the_rig_of_a_dead_loop_to_rest(bench):
    bench.run(2.0)
    first, begins_s = len(bench.sender.packets), bench.clock.now_s()
    bench.clock.advance(0.003)
    guard_of(bench).finish()
    assert_comes_to_rest(bench.sender.packets[first:], begins_s)
    assert bench.clock.now_s() < begins_s + RAMP_S + NEUTRAL_S + 0.1


def test_the_guard_of_a_rig_at_rest_sends_nothing(bench):
    bench.run(2.0)
    pause(bench)
    bench.run(4.0)
    count = len(bench.sender.packets)
    guard_of(bench).finish()
    assert len(bench.sender.packets) == count


@settings(max_examples=40)
@given(st.floats(0.06, 3.0), st.sampled_from([0.3, 2.0, 2.2, 3.0]))
def test_guard_and_loop_make_one_ramp_of_a_stall(stall_s, begins_s):
    bench = Bench()
    bench.run(min(begins_s, 2.0))
    if begins_s > 2.0:
        pause(bench)
        bench.run(begins_s - 2.0)
    first, stopped_s = len(bench.sender.packets), bench.clock.now_s()
    was = bench.sender.packets[-1]
    guard = guard_of(bench)
    watched(guard, bench.clock, stall_s)
    packets = bench.sender.packets
    if stall_s > TAKE_OVER_S + 0.02:
        assert packets[first][0] - stopped_s <= TAKE_OVER_S + 0.01
    bench.run(3.0)  # the loop is back; it was acting, so it has tripped
    mine = [was, *packets[first:]]
    sizes = np.array([size(p) for p in mine])
    gaps_s = np.diff([p[0] for p in mine])
    assert np.all(np.diff(sizes) <= 1e-6)
    assert np.all(-np.diff(sizes)[1:] <= 3.3 * size(was) * gaps_s[1:] + 1e-6)
    assert np.all(np.diff([p[1] for p in mine]) > 0.0)
    neutral = [p for p in mine if size(p) < 1e-9]
    assert neutral[-1][0] - neutral[0][0] >= NEUTRAL_S - 0.02
    bench.close()
