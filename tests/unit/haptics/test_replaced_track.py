"""An edited track takes the place of the one that plays: soon, and without a jump."""

import gc
import math
import os
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.follower import CHECKED_PER_TICK
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.haptics.track import to_shared_memory
from hapticplayer.linux import anonymous_memory
from hapticplayer.model import ForceTrack, PlaybackClock
from tests.doubles import SimulatedFalcon
from tests.rigs import FeedingPlayer, LoopRig

SLEW_N = Limits().entry_slew_n
TICKS_OF_200_MS = 200


def constant(y_n):
    return ForceTrack([0.0, 100.0], [[0, y_n, 0], [0, y_n, 0]])


def wave(seed, length_s=75.0, rate_hz=1000.0, peak_n=2.0):
    """Return smooth force in all directions, with its largest change per tick, N."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, length_s, 1.0 / rate_hz)
    force = np.zeros((len(t), 3))
    for frequency_hz in (0.3, 1.1, 4.0):
        force += np.sin(
            2 * np.pi * frequency_hz * t[:, None] + rng.uniform(0, 2 * np.pi, 3)
        )
    force *= peak_n / 3.0
    change_n = np.linalg.norm(np.diff(force, axis=0), axis=1).max() * rate_hz / 1000.0
    return ForceTrack(t, force), change_n


class Rig(LoopRig):
    """A clip plays, with a hand that gives way little; keeps what was sent."""

    def __init__(self, track):
        super().__init__(ManualClock(), SimulatedFalcon())
        self.block.beat_guard(math.inf)
        self.publish(1)
        self.states = []
        self.give_track(track)
        self.tick(600)
        assert self.loop.state.mode is Mode.FOLLOWING
        self.states.clear()

    def publish(self, epoch):
        clock = PlaybackClock(epoch, self.clock.now_s(), 0.0, 1.0, math.inf)
        self.block.write_clock(clock, 1)

    def tick(self, count=1):
        for _ in range(count):
            self.clock.advance(PERIOD_S)
            self.block.beat(self.clock.now_s())
            self.loop.tick(self.clock.now_s())
            self.states.append(self.loop.state)

    def give_bytes(self, data):
        descriptor = anonymous_memory("bad", len(data))
        os.pwrite(descriptor, data, 0)
        self.player.send(MessageKind.TRACK, "1", descriptor)
        os.close(descriptor)

    def distance_n(self, track):
        """Return how far the last plan is from a track."""
        state = self.loop.state
        return math.dist(state.planned_n, track.at(np.array([state.media_s]))[0])

    def ticks_until(self, track):
        """Return after how many ticks its numbers are what is planned."""
        for count in range(1, 2000):
            self.tick()
            if self.distance_n(track) < 1e-6:
                return count
        raise AssertionError("it never played")


@pytest.fixture
def play():
    rigs = []

    def begin(track):
        rigs.append(Rig(track))
        return rigs[-1]

    yield begin
    for rig in rigs:
        rig.close()


def steps_n(states, name="force_n"):
    values = [getattr(state, name) for state in states]
    return [math.dist(*pair) for pair in zip(values[1:], values, strict=False)]


def test_the_force_changes_over_evenly_and_without_a_pause(play):
    rig = play(constant(1.0))
    rig.give_track(constant(-1.0))
    assert rig.ticks_until(constant(-1.0)) == 2.0 / SLEW_N
    assert {state.mode for state in rig.states} == {Mode.FOLLOWING}
    assert max(steps_n(rig.states, "planned_n")) == pytest.approx(SLEW_N)


def test_a_clip_of_75_s_at_1_khz_plays_within_200_ticks(play):
    rig = play(wave(1)[0])
    other = wave(2)[0]
    rig.give_track(other)
    checking = math.ceil(4 * len(other.time_s) / CHECKED_PER_TICK)
    ticks = rig.ticks_until(other)
    assert checking <= ticks <= TICKS_OF_200_MS


@settings(max_examples=30)
@given(
    st.lists(st.tuples(st.integers(0, 99), st.integers(1, 90)), min_size=1, max_size=6)
)
def test_at_any_moment_nothing_changes_faster(edits):
    track, most_n = wave(100, length_s=4.0)
    rig = Rig(track)
    for seed, ticks in edits:
        track, change_n = wave(seed, length_s=4.0)
        most_n = max(most_n, change_n)
        rig.give_track(track)
        rig.tick(ticks)
    rig.tick(150)
    rig.close()
    assert {state.mode for state in rig.states} == {Mode.FOLLOWING}
    assert max(steps_n(rig.states, "planned_n")) <= most_n + SLEW_N + 1e-6
    assert rig.distance_n(track) < 1e-6


def not_finite():
    descriptor = to_shared_memory(constant(-1.0))
    data = bytearray(os.pread(descriptor, 4096, 0))
    os.close(descriptor)
    data[-4:] = np.float32(np.nan).tobytes()
    return bytes(data)


@pytest.mark.parametrize("data", [b"x" * 10, b"x" * 100, not_finite()])
def test_a_bad_version_is_refused_and_the_old_one_plays(play, data):
    rig = play(constant(1.0))
    rig.give_bytes(data)
    rig.tick(50)
    assert {state.planned_n for state in rig.states} == {(0.0, 1.0, 0.0)}
    assert {state.mode for state in rig.states} == {Mode.FOLLOWING}
    message = rig.player.receive()
    assert (message.word, "rejected" in message.text) == (MessageKind.FAILED, True)
    rig.give_track(constant(-1.0))
    rig.ticks_until(constant(-1.0))


def test_a_bad_version_does_not_hold_up_the_next(play):
    rig = play(constant(1.0))
    rig.give_bytes(not_finite())
    rig.give_track(constant(-1.0))
    rig.ticks_until(constant(-1.0))


def mapped_tracks():
    lines = Path("/proc/self/maps").read_text(encoding="utf-8").splitlines()
    return sum("hapticplayer-track" in line for line in lines)


def open_descriptors():
    return len(list(Path("/proc/self/fd").iterdir()))


def test_many_versions_leave_no_memory_and_no_descriptor(play):
    before, rig = mapped_tracks(), play(constant(1.0))
    descriptors = open_descriptors()
    gc.disable()  # as the loop does
    try:
        for number in range(300):
            rig.give_track(constant(0.001 * number))
            rig.tick()
        rig.states.clear()
        rig.tick(10)
        del rig.states[:-1]
        assert mapped_tracks() - before == 1
    finally:
        gc.enable()
    assert open_descriptors() == descriptors


def test_versions_without_a_pause_still_come_to_play(play):
    rig = play(wave(1)[0])
    versions = [wave(seed, peak_n=1.0)[0] for seed in range(4)]
    needed = math.ceil(4 * len(versions[0].time_s) / CHECKED_PER_TICK)
    for number in range(3 * needed):
        rig.give_track(versions[number % 4])
        rig.tick()
    checked = {id(state.track) for state in rig.states}
    assert len(checked) >= 3  # one after the other, though none was checked in a tick
    rig.give_track(constant(0.5))
    rig.ticks_until(constant(0.5))


def test_after_a_pause_nothing_of_the_difference_is_left(play):
    rig = play(constant(2.0))
    rig.give_track(constant(-2.0))
    rig.tick(5)
    rig.publish(2)
    rig.tick()
    assert (rig.loop.state.planned_n, rig.loop.state.switch_n) == (ZERO, ZERO)
    rig.tick(30)
    assert rig.loop.state.planned_n == (0.0, -2.0, 0.0)


@pytest.mark.realtime
def test_the_real_processes_change_over_while_they_play():
    process = HapticsProcesses(SystemClock())
    try:
        player = FeedingPlayer(process, 1.0)
        player.play_until(lambda ticks: np.sum(ticks["mode"] == Mode.FOLLOWING) > 200)
        first = len(player.ticks)
        for z_n in (0.5, -1.0):
            process.replace("track", ForceTrack([0.0, 1e4], [[0, 0, z_n]] * 2))
            player.play_until(lambda ticks, z_n=z_n: ticks["planned_n"][-1, 2] == z_n)
        assert process.problem == ""
        ticks = player.ticks[first:]
    finally:
        process.close()
    assert set(ticks["mode"].tolist()) == {Mode.FOLLOWING}
    assert np.abs(np.diff(ticks["planned_n"][:, 2])).max() <= SLEW_N + 1e-6
