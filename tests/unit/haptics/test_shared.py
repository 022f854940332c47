"""The shared block under torn writes, full rings and dead writers."""

import os

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.haptics.shared import BLOCK_BYTES, RING_TICKS, SharedBlock
from hapticplayer.linux import anonymous_memory
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import ChannelLevel

numbers = st.floats(allow_nan=False, allow_infinity=False)


@pytest.fixture
def memory():
    """What a block is made of."""
    descriptor = anonymous_memory("test", BLOCK_BYTES)
    yield descriptor
    os.close(descriptor)


@pytest.fixture
def block(memory):
    return SharedBlock(memory)


def new_block():
    descriptor = anonymous_memory("test", BLOCK_BYTES)
    try:
        return SharedBlock(descriptor)
    finally:
        os.close(descriptor)


@given(st.integers(0, 2**40), st.integers(0, 2**40), numbers, numbers, numbers)
def test_a_clock_comes_back_as_it_went(track_id, epoch, monotonic, media, rate):
    block = new_block()
    clock = PlaybackClock(epoch, monotonic, media, rate, monotonic)
    block.write_clock(clock, track_id)
    assert block.read_clock() == (clock, track_id)


def test_before_the_first_clock_there_is_none(block):
    assert block.read_clock() is None


@pytest.mark.parametrize("cut", range(1, 52))
def test_a_write_that_was_cut_short_is_never_taken_for_a_clock(block, memory, cut):
    first = PlaybackClock(1, 100.0, 5.0, 1.0, 100.15)
    second = PlaybackClock(2, 200.0, 7.0, 1.0, 200.15)
    block.write_clock(first, 1)
    whole = newest_slot(block, memory)
    block.write_clock(second, 2)
    # a writer that died after `cut` bytes of its slot, with the index moved on
    at = (64, 128)[block.signs()[0] & 1]
    after = newest_slot(block, memory)
    os.pwrite(memory, whole[:cut], at)
    found = block.read_clock()
    assert found in (None, (second, 2), (first, 1))
    if found is not None:
        assert newest_slot(block, memory) in (after, whole)


def newest_slot(block, memory):
    return os.pread(memory, 52, (64, 128)[block.signs()[0] & 1])


def test_every_clock_is_counted(block):
    clock, counts = PlaybackClock(1, 100.0, 5.0, 1.0, 100.15), [block.signs()[0]]
    for _ in range(5):
        block.write_clock(clock, 1)
        counts.append(block.signs()[0])
    assert counts == [0, 1, 2, 3, 4, 5]


def tick(block, count):
    block.write_tick(count, 0.001 * count, 0.0, *[0.0] * 15, 1e-5, 0.0, 0.0, 0, 1, 2, 3)


def test_ticks_come_back_in_order_and_once(block):
    tail = 0
    seen = []
    for count in range(1000):
        tick(block, count)
        if count % 37 == 0:
            records, tail, lost = block.read_ticks(tail)
            assert lost == 0
            seen.extend(records["monotonic_s"])
    records, tail, _ = block.read_ticks(tail)
    seen.extend(records["monotonic_s"])
    assert np.allclose(seen, 0.001 * np.arange(1000))
    assert records["buttons"].tolist() == [3] * len(records)


def test_a_reader_that_slept_too_long_is_told_how_much_it_lost(block):
    for count in range(RING_TICKS + 500):
        tick(block, count)
    records, tail, lost = block.read_ticks(0)
    assert tail == RING_TICKS + 500
    assert len(records) + lost == tail
    assert np.all(np.diff(records["monotonic_s"]) > 0)
    assert records["monotonic_s"][-1] == pytest.approx(0.001 * (tail - 1))


def test_levels_of_sound_channels_come_back_as_they_went(block, memory):
    player, nothing_yet = SharedBlock(memory), block.levels()
    assert nothing_yet == ()
    block.write_levels([ChannelLevel(4, 0.25, True), ChannelLevel(1, 0.5, False)])
    assert player.levels() == (ChannelLevel(1, 0.5, False), ChannelLevel(4, 0.25, True))
    block.write_levels([ChannelLevel(8, 1.0, False)])
    assert player.levels() == (ChannelLevel(8, 1.0, False),)
    assert player.read_clock() is None


def test_a_block_of_another_size_is_refused():
    descriptor = anonymous_memory("test", 100)
    try:
        with pytest.raises(ValueError, match="another size"):
            SharedBlock(descriptor)
    finally:
        os.close(descriptor)
