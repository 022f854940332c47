"""The process that plays the sound: what it loads, how it ends, who replaces it."""

import os
import signal
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.playback.clock import ClockSource, MediaClock
from hapticplayer.playback.sound import (
    LOST_AFTER_S,
    OPENING_S,
    RETRY_S,
    SETTLED_S,
    OutputKeeper,
)
from hapticplayer.playback.sound_process import OutputState, SoundProcess
from hapticplayer.playback.sound_ring import AudioRing
from tests.material.sound_output import SilentOutput

PATIENCE_S = 20.0
BLOCK_S = 0.01

PLAYER = """
import sys
from hapticplayer.playback.sound_ring import AudioRing
from hapticplayer.playback.sound_process import SoundProcess
ring = AudioRing()
process = SoundProcess(ring)
print(process.pid, flush=True)
sys.stdin.read()
"""


@pytest.fixture
def nowhere(monkeypatch):
    """No sound server, no sound card."""
    monkeypatch.setenv("PULSE_SERVER", "unix:/nowhere")


def wait_for(condition):
    clock = SystemClock()
    until_s = clock.now_s() + PATIENCE_S
    while not condition():
        assert clock.now_s() < until_s, "it did not happen"
        clock.sleep_until(clock.now_s() + 0.005)


def is_alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def test_the_sound_process_loads_neither_numpy_nor_the_player():
    code = (
        "import sys, hapticplayer.playback.sound_device;"
        "heavy = {'numpy', 'av', 'scipy', 'PySide6', 'hapticplayer.model'};"
        "print(sorted(heavy & set(sys.modules)))"
    )
    printed = subprocess.check_output([sys.executable, "-c", code], text=True)
    assert printed.strip() == "[]"


def test_without_a_device_it_says_so_and_goes_on_looking(nowhere):
    ring = AudioRing()
    process = SoundProcess(ring, device="no such device")
    wait_for(lambda: process.poll() is not OutputState.OPENING)
    assert process.poll() is OutputState.FAILED
    assert process.problem
    assert is_alive(process.pid)
    process.close()
    assert process.poll() is OutputState.GONE
    assert not is_alive(process.pid)
    ring.close()


def test_one_that_is_killed_is_gone(nowhere):
    ring = AudioRing()
    process = SoundProcess(ring, device="no such device")
    os.kill(process.pid, signal.SIGKILL)
    wait_for(lambda: process.poll() is OutputState.GONE)
    process.close()
    ring.close()


def test_the_sound_process_ends_with_a_killed_player(nowhere):
    player = subprocess.Popen(
        [sys.executable, "-c", PLAYER],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    with player:
        pid = int(player.stdout.readline())
        assert is_alive(pid)
        player.kill()
    wait_for(lambda: not is_alive(pid))


class Bench:
    """A keeper with a clock that runs and outputs that do as commanded."""

    def __init__(self):
        self.clock, self.media, self.ring = ManualClock(), MediaClock(), AudioRing()
        self.outputs, self.requests, self.events = [], [], []
        self.is_there = True
        self.generation, self.end_s = 0, 0.0
        self.keeper = OutputKeeper(self.ring, self.media, self.make)

    def make(self, _ring):
        if not self.is_there:
            raise OSError("no processes left")
        self.outputs.append(SilentOutput(self.ring, self.clock))
        return self.outputs[-1]

    def request(self, generation, media_s):
        self.requests.append(media_s)
        self.generation, self.end_s = generation, media_s
        self.write_ahead(3.0)

    def write_ahead(self, seconds):
        samples = np.zeros((round(48_000 * seconds), 2), np.float32)
        written = self.ring.write(self.generation, self.end_s, samples)
        self.end_s += written / 48_000

    def start(self):
        """Play with sound from media time 1 s."""
        self.keeper.want(self.clock.now_s())
        self.media.seek(1.0)
        generation = self.ring.load(self.media.epoch, 1.0)
        self.request(generation, 1.0)
        self.ring.play()
        self.turn()
        self.media.start_with(self.ring.reports()[0])

    def turn(self):
        """Let one block be played."""
        self.write_ahead(0.1)
        self.outputs[-1].advance(round(BLOCK_S * 48_000))
        self.clock.advance(BLOCK_S)
        now_s = self.clock.now_s()
        if self.media.is_running:
            for report in self.ring.reports():
                assert self.media.report(report, now_s)
            self.media.check(now_s)
        happened = self.keeper.watch(
            now_s, self.request, is_playing=self.media.is_running
        )
        if happened:
            self.events.append(happened)

    def run(self, seconds):
        for _ in range(round(seconds / BLOCK_S)):
            self.turn()


@pytest.fixture
def bench():
    made = Bench()
    yield made
    made.keeper.close()
    made.ring.close()


@pytest.mark.parametrize("loss", ["the process dies", "the server is silent"])
def test_a_lost_output_is_replaced_and_joins_the_clock(bench, loss):
    bench.start()
    bench.run(9.0)  # one that dies young is not replaced at once
    epoch = bench.media.epoch
    offset_s = bench.media.media_s(bench.clock.now_s()) - bench.clock.now_s()
    lost = bench.outputs[0]
    lost.is_alive = False
    if loss == "the process dies":
        lost.state = OutputState.GONE
    bench.run(LOST_AFTER_S + 0.4)
    assert bench.events[:3] == ["sound_open", "sound_lost", "sound_back"]
    assert bench.media.source is ClockSource.MONOTONIC
    assert len(bench.outputs) == 2
    bench.run(SETTLED_S + 0.5)
    assert bench.media.source is ClockSource.AUDIO
    now_s = bench.clock.now_s()
    assert bench.media.epoch == epoch, "the force was interrupted"
    assert bench.media.media_s(now_s) - now_s == pytest.approx(offset_s, abs=1e-3)
    assert abs(bench.media.error_s) < 1e-3
    assert bench.ring.underrun_samples == 0
    assert len(bench.events) == 3


def test_an_output_that_comes_late_joins_what_plays(bench):
    bench.keeper.want(bench.clock.now_s())
    bench.outputs[0].state = OutputState.FAILED
    bench.outputs[0].problem = "no device"
    bench.media.seek(0.0)
    bench.ring.load(bench.media.epoch, 0.0)
    bench.media.start(bench.clock.now_s())
    bench.run(1.0)
    assert bench.events == ["no_sound_output"]
    assert bench.keeper.is_settled(bench.clock.now_s())
    bench.outputs[0].state = OutputState.OPEN
    bench.run(SETTLED_S + 0.5)
    assert bench.events == ["no_sound_output", "sound_back"]
    assert bench.media.source is ClockSource.AUDIO
    assert len(bench.outputs) == 1


def test_the_wait_for_a_slow_output_is_limited(bench):
    bench.keeper.want(bench.clock.now_s())
    bench.outputs[0].state = OutputState.OPENING
    assert not bench.keeper.is_settled(bench.clock.now_s())
    bench.clock.advance(OPENING_S + 0.1)
    assert bench.keeper.is_settled(bench.clock.now_s())


def test_restarts_of_a_dying_process_are_limited(bench):
    bench.keeper.want(bench.clock.now_s())
    for _ in range(round(60.0 / BLOCK_S)):
        bench.outputs[-1].state = OutputState.GONE
        bench.turn()
    assert 5 <= len(bench.outputs) <= 13


def test_a_process_that_cannot_be_started_is_tried_again(bench):
    bench.is_there = False
    bench.keeper.want(bench.clock.now_s())
    assert bench.keeper.is_settled(bench.clock.now_s())
    assert "processes" in bench.keeper.problem
    bench.is_there = True
    bench.clock.advance(RETRY_S + BLOCK_S)
    bench.keeper.watch(bench.clock.now_s(), bench.request, is_playing=False)
    assert bench.keeper.is_open


def test_another_output_is_used_at_once(bench):
    bench.start()
    bench.run(0.2)
    other = SilentOutput(bench.ring, bench.clock)
    bench.keeper.use(lambda _ring: other, bench.clock.now_s())
    assert not bench.keeper.is_open
    bench.keeper.watch(bench.clock.now_s(), bench.request, is_playing=False)
    assert bench.keeper.is_open
    assert len(bench.outputs) == 1


def test_a_window_hanging_for_2_s_stops_neither_sound_nor_clock(bench):
    bench.start()
    bench.run(1.5)
    epoch = bench.media.epoch
    offset_s = bench.media.media_s(bench.clock.now_s()) - bench.clock.now_s()
    for _ in range(round(2.0 / BLOCK_S)):  # nobody decodes, nobody looks
        bench.outputs[0].advance(round(BLOCK_S * 48_000))
        bench.clock.advance(BLOCK_S)
    bench.run(0.1)
    now_s = bench.clock.now_s()
    assert bench.ring.underrun_samples == 0
    assert bench.media.source is ClockSource.AUDIO
    assert bench.media.epoch == epoch
    assert bench.media.media_s(now_s) - now_s == pytest.approx(offset_s, abs=1e-3)
    assert bench.events == ["sound_open"]
