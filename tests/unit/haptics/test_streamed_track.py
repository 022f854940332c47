"""A force that is late or lost fades, and nothing of it is ever a step."""

import os

import numpy as np
import pytest

from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.streamed_track import FADE_S, PACKET_SAMPLES
from hapticplayer.haptics.track import anonymous_memory, map_track
from hapticplayer.haptics.track_buffer import DeviceTrack, TrackBuffer
from hapticplayer.model import PlaybackClock
from tests.unit.haptics.test_step import START_S, World

PACKETS = 24
FULL = np.full((PACKET_SAMPLES, 3), (0.0, 4.0, 0.0), np.float32)
# 4 N over the time of a fade, 1 ms
SLOPE_N = 4.0 / FADE_S * 1e-3 * 1.001


def read(track, gain=(1.0, 1.0, 1.0)):
    descriptor = DeviceTrack(track, np.array(gain)).to_shared_memory()
    try:
        return map_track(descriptor)
    finally:
        os.close(descriptor)


@pytest.fixture
def buffer():
    return TrackBuffer(PACKETS * PACKET_SAMPLES)


@pytest.fixture
def world(buffer):
    """A player of the track from media time 0 on."""
    made = World()
    made.track = read(buffer)
    made.clock = PlaybackClock(1, START_S, 0.0, 1.0, np.inf)
    return made


def played(world, seconds):
    """Return what was sent along y, N, a value per tick."""
    before = len(world.sent)
    world.tick(round(seconds * 1e3))
    return np.array(world.sent)[before:, 1]


def test_what_has_arrived_is_felt_as_it_is(buffer, rng):
    force = rng.standard_normal((PACKETS * PACKET_SAMPLES, 3)).astype(np.float32)
    loaded = read(buffer)
    for packet in rng.permutation(PACKETS).tolist():
        first = packet * PACKET_SAMPLES
        buffer.fill(packet, force[first : first + PACKET_SAMPLES])
    found = np.array([loaded.force_at(k / 1e3) for k in range(len(force) - 1)])
    assert np.abs(found - force[:-1]).max() < 1e-6


def test_what_arrived_before_a_loop_is_there_for_it(buffer):
    buffer.fill(2, FULL)
    weak, strong = read(buffer, (1.0, 0.5, 0.0)), read(buffer)
    buffer.fill(3, FULL)
    for loaded, force_n in ((weak, 2.0), (strong, 4.0)):
        found = [loaded.force_at(t)[1] for t in (0.1, 0.3, 0.4)]
        assert found == [0.0, force_n, force_n]


def test_a_device_that_is_released_gets_no_more(buffer):
    track = DeviceTrack(buffer, np.ones(3))
    loaded = map_track(descriptor := track.to_shared_memory())
    os.close(descriptor)
    track.close()
    buffer.fill(0, FULL)
    assert loaded.force_at(0.05) == (0.0, 0.0, 0.0)


def test_a_lost_packet_fades_out_and_in(buffer, world):
    for packet in range(PACKETS):
        if packet != 12:
            buffer.fill(packet, FULL)
    sent = played(world, 2.5)
    assert world.state.mode is Mode.FOLLOWING
    gap = slice(12 * PACKET_SAMPLES, 13 * PACKET_SAMPLES)
    assert np.all(np.abs(sent[gap]) < SLOPE_N)
    assert np.abs(np.diff(sent[600:])).max() <= SLOPE_N
    settled = [sent[gap.start - 120], sent[gap.stop + 120]]
    assert settled == pytest.approx([4.0, 4.0])


@pytest.mark.parametrize("late_s", [0.005, 0.05, 0.099, 0.2, 0.6])
def test_a_late_packet_is_never_a_step(buffer, world, late_s):
    for packet in range(8):
        buffer.fill(packet, FULL)
    due_s = 8 * PACKET_SAMPLES / 1e3 - FADE_S
    sent = [played(world, due_s + late_s)]
    for packet in range(8, PACKETS):
        buffer.fill(packet, FULL)
    sent = np.concatenate([*sent, played(world, 0.5)])
    assert np.abs(np.diff(sent[600:])).max() <= SLOPE_N
    assert sent[-1] == pytest.approx(4.0)


def test_a_loop_that_stumbles_has_faded_in_time(buffer, world):
    for packet in range(8):
        buffer.fill(packet, FULL)
    played(world, 8 * PACKET_SAMPLES / 1e3 - 0.05)
    world.now_s += 0.015  # the loop was held up
    sent = played(world, 0.05)
    assert abs(sent[-1]) < SLOPE_N


def test_at_other_speeds_the_fade_begins_in_time(buffer, world):
    world.clock = PlaybackClock(1, START_S, 0.0, 2.0, np.inf)
    for packet in range(8):
        buffer.fill(packet, FULL)
    sent = played(world, 4 * PACKET_SAMPLES / 1e3 + 0.1)
    assert np.abs(np.diff(sent[450:])).max() <= SLOPE_N
    assert np.all(np.abs(sent[4 * PACKET_SAMPLES :]) < SLOPE_N)


def test_after_a_seek_the_force_waits_for_its_packet(buffer, world):
    for packet in range(8):
        buffer.fill(packet, FULL)
    played(world, 0.7)
    world.clock = PlaybackClock(2, world.now_s, 2.0, 1.0, np.inf)
    sent = [played(world, 0.3)]
    assert abs(sent[0][-1]) == 0.0
    for packet in range(15, PACKETS):
        buffer.fill(packet, FULL)
    sent.append(played(world, 0.4))
    after = np.concatenate(sent)
    assert np.abs(np.diff(after[30:])).max() <= 0.05  # the slew of an entry
    assert after[-1] == pytest.approx(4.0)


@pytest.mark.parametrize("late_ticks", [1, 25, 60, 150])
def test_a_packet_just_after_a_seek_is_no_step(buffer, world, late_ticks):
    for packet in range(8):
        buffer.fill(packet, FULL)
    played(world, 0.7)
    world.clock = PlaybackClock(2, world.now_s, 2.0, 1.0, np.inf)
    planned = []
    for tick in range(400):
        if tick == late_ticks:
            for packet in range(15, PACKETS):
                buffer.fill(packet, FULL)
        planned.append(world.tick().planned_n[1])
    assert np.diff(planned).max() <= SLOPE_N
    assert planned[-1] == pytest.approx(4.0)


@pytest.mark.parametrize("media_s", [-1.0, 1e9, 1e300])
def test_outside_of_the_track_there_is_no_force(buffer, media_s):
    buffer.fill(0, FULL)
    loaded = read(buffer)
    assert loaded.force_at(media_s) == (0.0, 0.0, 0.0)
    assert loaded.share(1.0, media_s, 1.0, 0.001) == 1.0


def test_memory_of_another_size_is_refused():
    descriptor = anonymous_memory("test", 200)
    os.pwrite(descriptor, b"\x80" + bytes(7) + b"\x01" + bytes(7) + b"\x02", 0)
    with pytest.raises(ValueError, match="does not match"):
        map_track(descriptor)
    os.close(descriptor)
