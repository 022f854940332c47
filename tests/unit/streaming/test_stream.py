"""A stream gives what the file gives: bytes, frames, force; and seeks come first."""

import os
import threading
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import MediaError, UsageError
from hapticplayer.haptics.track import map_track
from hapticplayer.haptics.track_buffer import DeviceTrack
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.video import VideoDecoder
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.source import open_source
from hapticplayer.simulation.network import BadNetwork, NetworkFaults
from hapticplayer.streaming import client, remote_clip
from hapticplayer.streaming.client import StreamAddress
from hapticplayer.streaming.force_fetch import FIRST_PACKETS, ForceFetch
from hapticplayer.streaming.opening import open_stream
from hapticplayer.streaming.remote_clip import RemoteClip
from tests.unit.streaming.conftest import wait_for

CLOCK = SystemClock()


@pytest.fixture
def source(server):
    found = open_stream(server.url, CLOCK)
    yield found
    found.stream.close()


@pytest.fixture
def asked(server, monkeypatch):
    """Return the names of all resources that are asked for, as they come."""
    names, answer = [], server.offer.answer

    def noted(resource, byte_range):
        names.append(resource)
        return answer(resource, byte_range)

    monkeypatch.setattr(server.offer, "answer", noted)
    return names


def remote(server):
    return RemoteClip(StreamAddress.of(server.url), server.offer.manifest, CLOCK)


@pytest.mark.parametrize("block_bytes", [100, 1000, 1 << 17])
def test_the_clip_reads_like_the_file(server, packed, rng, monkeypatch, block_bytes):
    monkeypatch.setattr(remote_clip, "BLOCK_BYTES", block_bytes)
    clip, whole = remote(server), packed.read_bytes()
    with clip.open() as reader, clip.open() as other:
        assert other.read() == whole
        for at in rng.integers(0, len(whole) + 10, 40).tolist():
            reader.seek(at)
            assert reader.read(500) == whole[at : at + 500]
        reader.seek(-7, os.SEEK_END)
        assert reader.read() == whole[-7:]
    clip.close()


def test_a_network_that_becomes_thin_is_asked_for_less(server, packed, monkeypatch):
    monkeypatch.setattr(remote_clip, "BLOCK_BYTES", 500)
    monkeypatch.setattr(remote_clip, "FIRST_BLOCKS", 200)  # take 2.5 s
    monkeypatch.setattr(client, "ANSWER_S", 0.5)
    thin = NetworkFaults(bytes_per_s=40_000.0)
    with BadNetwork(server.url, thin, CLOCK) as network:
        clip = RemoteClip(StreamAddress.of(network.url), server.offer.manifest, CLOCK)
        with clip.open() as reader:
            assert reader.read(20_000) == packed.read_bytes()[:20_000]
        clip.close()


def test_memory_for_the_clip_is_limited(server, packed, monkeypatch):
    monkeypatch.setattr(remote_clip, "BLOCK_BYTES", 100)
    monkeypatch.setattr(remote_clip, "KEPT_BLOCKS", 20)
    monkeypatch.setattr(remote_clip, "AHEAD_BLOCKS", 5)
    monkeypatch.setattr(remote_clip, "MOST_BLOCKS", 5)
    clip = remote(server)
    with clip.open() as reader:
        assert reader.read() == packed.read_bytes()
    assert len(clip._blocks) <= 20
    clip.close()


def test_a_clip_says_whether_enough_of_it_is_there(server, packed, monkeypatch):
    monkeypatch.setattr(remote_clip, "BLOCK_BYTES", 500)
    monkeypatch.setattr(remote_clip, "MOST_BLOCKS", 2)
    clip = remote(server)
    with clip.open() as reader:
        reader.read(1)
        wait_for(lambda: clip.is_ahead(5_000))
        monkeypatch.setattr(server, "offer", None)  # nothing comes any more
        clip._blocks.pop(6)
        assert clip.is_ahead(2_000)
        assert not clip.is_ahead(5_000)
    clip.close()
    assert clip.is_ahead(5_000)


def test_frames_are_those_of_the_file(source, packed):
    assert source.clip.duration_s == open_source(packed).clip.duration_s
    with VideoDecoder(source.clip.content) as far, VideoDecoder(packed) as near:
        for a, b in zip(far.frames(), near.frames(), strict=True):
            assert a.pts_s == b.pts_s
            assert np.array_equal(a.native.to_ndarray(), b.native.to_ndarray())
        far.seek(1.0)
        assert far.next_frame().pts_s == pytest.approx(1.0)


def test_a_clip_without_sound_says_so_from_afar_too(source):
    assert not source.clip.has_audio
    with pytest.raises(MediaError, match="holds no sound"):
        AudioDecoder(source.clip.content)


def test_the_force_is_that_of_the_file(source, packed):
    buffer = source.stream.tracks["realistic"]
    wait_for(buffer.has_arrived.all)
    times = np.arange(len(buffer.force_n)) / 1e3
    expected = open_source(packed).tracks["realistic"].at(times)
    assert np.abs(buffer.force_n - expected).max() < 1e-6
    one = DeviceTrack(buffer, np.ones(3))
    loaded = map_track(descriptor := one.to_shared_memory())
    os.close(descriptor)
    assert np.abs(np.array(loaded.force_at(1.0)) - expected[1000]).max() < 1e-6


def test_only_the_chosen_track_is_fetched(source, asked):
    wait_for(source.stream.tracks["realistic"].has_arrived.all)
    assert not source.stream.tracks["random"].has_arrived.any()
    source.stream.follow("random", 0.0)
    wait_for(source.stream.tracks["random"].has_arrived.all)
    assert [name for name in asked if name.startswith("force/2/")]


def test_a_seek_asks_for_its_packets_first(server, asked):
    manifest = replace(server.offer.manifest, samples=600_000)
    server.offer.manifest = manifest
    fetch = ForceFetch(StreamAddress.of(server.url), manifest, CLOCK)
    fetch.follow("realistic", 0.0)
    wait_for(lambda: fetch.has("realistic", 10.0))
    before = len(asked)
    fetch.follow("realistic", 300.0)
    wait_for(lambda: fetch.has("realistic", 300.0))
    first = 300_000 // 128
    assert f"force/0/{first}-{first + FIRST_PACKETS - 1}" in asked[before:]
    assert not fetch.has("realistic", 200.0)
    fetch.close()


def test_a_server_that_ends_is_told_as_one_sentence(server, monkeypatch):
    monkeypatch.setattr(remote_clip, "PATIENCE_S", 0.3)
    clip = remote(server)
    server.offer = None  # it breaks off without an answer
    with pytest.raises(MediaError, match=r"ride.mkv: cannot be fetched") as caught:
        clip.open().read(1)
    assert "\n" not in str(caught.value)
    clip.close()


def test_a_clip_that_changes_on_the_server_ends_it(server, packed):
    clip = remote(server)
    packed.write_bytes(b"another")
    with pytest.raises(MediaError, match="has a clip that was changed meanwhile"):
        clip.open().read(1)
    clip.close()


def test_closing_frees_a_reader_that_waits(server):
    clip = remote(server)
    server.offer = None  # it breaks off without an answer
    reader = clip.open()
    threading.Timer(0.2, clip.close).start()
    with pytest.raises(MediaError):
        reader.read(1)


def test_other_feedbacks_cannot_be_made_of_a_stream(source):
    assert with_feedback(source, "random") == (source, "random")
    with pytest.raises(UsageError, match="only a sequence on this machine"):
        with_feedback(source, "delayed:delay_s=0.3")
