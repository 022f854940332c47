"""Force in packets comes back as it was, and what is damaged is left out."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.haptics.streamed_track import PACKET_SAMPLES, RATE_HZ
from hapticplayer.model import ForceTrack
from hapticplayer.streaming.packets import (
    PACKET_BYTES,
    decoded,
    encoded,
    packets_of,
)

TRACK, PACKETS = 3, 8


@pytest.fixture
def track(rng):
    return ForceTrack(np.arange(200) / 200.0, rng.standard_normal((200, 3)))


def test_packets_hold_what_the_loop_would_feel(track):
    found = list(decoded(encoded(track, TRACK, 0, PACKETS), TRACK, PACKETS))
    assert [packet.number for packet in found] == list(range(PACKETS))
    force_n = np.concatenate([packet.force_n for packet in found])
    times = np.arange(PACKETS * PACKET_SAMPLES) / RATE_HZ
    assert np.abs(force_n - track.at(times)).max() < 1e-6  # float32


def test_any_part_of_a_track_can_be_asked_for(track):
    whole = encoded(track, TRACK, 0, PACKETS)
    part = encoded(track, TRACK, 5, 7)
    assert part == whole[5 * PACKET_BYTES : 7 * PACKET_BYTES]


def test_packets_are_counted_up_to_the_last_sample():
    assert [packets_of(n) for n in (1, 128, 129, 1000)] == [1, 1, 2, 8]


def test_what_is_lost_or_swapped_costs_nothing_else(track):
    whole = encoded(track, TRACK, 0, PACKETS)
    parts = [whole[k * PACKET_BYTES : (k + 1) * PACKET_BYTES] for k in (6, 2, 4)]
    numbers = [packet.number for packet in decoded(b"".join(parts), TRACK, PACKETS)]
    assert numbers == [6, 2, 4]


@given(at=st.integers(0, 3 * PACKET_BYTES - 1), bit=st.integers(0, 7))
def test_one_wrong_bit_costs_its_packet_alone(at, bit):
    track = ForceTrack([0.0, 1.0], [[1.0, 2.0, 3.0], [3.0, 2.0, 1.0]])
    content = bytearray(encoded(track, TRACK, 0, 3))
    content[at] ^= 1 << bit
    numbers = [packet.number for packet in decoded(bytes(content), TRACK, 3)]
    assert numbers == [k for k in range(3) if k != at // PACKET_BYTES]


@given(content=st.binary(max_size=3 * PACKET_BYTES))
def test_any_bytes_are_read_without_harm(content):
    assert not list(decoded(content, TRACK, PACKETS))


def test_packets_of_elsewhere_are_left_out(track):
    content = encoded(track, TRACK, 0, PACKETS)
    assert not list(decoded(content, TRACK + 1, PACKETS))
    assert len(list(decoded(content, TRACK, 3))) == 3


def test_force_that_is_not_finite_is_left_out(monkeypatch, track):
    bad = np.full((PACKET_SAMPLES, 3), np.nan)
    monkeypatch.setattr(ForceTrack, "at", lambda *_: bad)
    content = encoded(track, TRACK, 2, 3)
    assert not list(decoded(content, TRACK, PACKETS))
