"""Work that nobody would notice is not done, and what remains is the same."""

import hashlib
import threading

import numpy as np
import pytest

from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.playback.feeders import VideoFeeder
from tests.conftest import clip_of
from tests.unit.playback.conftest import Theatre


class PixelSink:
    """Keeps when each picture came, its time, and a digest of what was on it."""

    def __init__(self, clock):
        self.clock, self.shown = clock, []

    def show(self, frame):
        pixels = FrameConverter().convert(frame, 128, 72).as_rgb().tobytes()
        digest = hashlib.sha256(pixels).digest()
        self.shown.append((round(self.clock.now_s(), 6), frame.pts_s, digest))


class Counts:
    """How often the costly things have been done, and what was sent to the loop."""

    def __init__(self, monkeypatch):
        self.of, self._monkeypatch = {}, monkeypatch
        self.watch(VideoDecoder, "seek")
        self.watch(VideoDecoder, "next_frame")
        self.watch(AudioDecoder, "seek")
        self.watch(AudioDecoder, "next_block")

    def watch(self, owner, name):
        original, key = getattr(owner, name), f"{owner.__name__}.{name}"
        self.of[key] = 0

        def counted(*args, **more):
            self.of[key] += 1
            return original(*args, **more)

        self._monkeypatch.setattr(owner, name, counted)

    def take(self):
        """Return the counts since the last call."""
        taken = dict(self.of)
        for key in self.of:
            self.of[key] = 0
        return taken


@pytest.fixture
def counts(monkeypatch):
    return Counts(monkeypatch)


@pytest.fixture
def stage():
    """Make theatres that note pixels and what is published; closed after the test."""
    made = []

    def make(info, **more):
        theatre = Theatre(info, **more)
        theatre.sink = PixelSink(theatre.clock)
        theatre.player.set_sink(theatre.sink)
        made.append(theatre)
        return theatre

    yield make
    for theatre in made:
        theatre.player.close()


def seeks(theatre, targets_s):
    """Seek while paused and return which picture each seek showed."""
    shown = []
    for target_s in targets_s:
        theatre.player.seek(target_s)
        theatre.run(0.012)
        shown.append(theatre.sink.shown[-1][1:])
    return shown


def test_a_small_seek_decodes_nothing_again(clip, counts, stage, monkeypatch):
    targets_s = [0.9, 0.9, 0.93, 0.97, 1.02, 1.0, 2.0, 2.06, 2.01, 0.1, 0.1 + 0.039]
    theatre = stage(clip)
    theatre.run(0.04)
    counts.take()
    found = seeks(theatre, targets_s)
    done = counts.take()
    monkeypatch.setattr(VideoFeeder, "_keep_from", lambda _self, _media_s: False)
    whole = stage(clip)
    whole.run(0.04)
    counts.take()
    assert found == seeks(whole, targets_s)
    every = counts.take()
    assert every["VideoDecoder.seek"] == len(targets_s)
    assert (
        done["VideoDecoder.seek"] == 4
    )  # 0.9, 1.0 goes back, 2.0 and 0.1 far, 2.01 not
    assert done["VideoDecoder.next_frame"] < every["VideoDecoder.next_frame"]


def test_a_seek_within_decoded_sound_decodes_nothing(clip, counts, stage):
    theatre = stage(clip)
    theatre.player.play()
    theatre.run(0.6)
    heard_s = theatre.player.snapshot().media_s
    counts.take()
    theatre.player.seek(heard_s + 0.4)
    theatre.run(0.5)
    assert counts.take()["AudioDecoder.seek"] == 0
    assert clip_of(theatre.player).media.error_s == pytest.approx(0.0, abs=1e-4)
    assert theatre.player.snapshot().media_s == pytest.approx(
        heard_s + 0.4 + 0.38, abs=0.02
    )
    theatre.player.seek(heard_s + 0.1)  # behind: half a second is kept
    theatre.run(0.2)
    assert counts.take()["AudioDecoder.seek"] == 0
    assert theatre.player.snapshot().clock == "audio"
    theatre.player.set_speed(1.5)  # this sound is of no use any more
    theatre.run(0.1)
    assert counts.take()["AudioDecoder.seek"] == 1


def test_a_seek_to_the_end_of_decoded_sound_wakes_the_decoder(clip, stage, monkeypatch):
    """It looks for room five times a second, which would be waited for."""
    monkeypatch.setattr("hapticplayer.playback.feeders.ROOM_S", 1e6)
    monkeypatch.setattr("hapticplayer.playback.sound_ring.PAUSED_AHEAD_S", 0.5)
    theatre = stage(clip)
    ring = clip_of(theatre.player).sound.ring
    for _ in range(1000):
        if ring.buffered_s() >= 0.5:
            break
        threading.Event().wait(0.005)
    theatre.player.seek(0.49)
    for _ in range(1000):
        if ring.buffered_s() >= 0.5:
            break
        threading.Event().wait(0.005)
    assert ring.buffered_s() == pytest.approx(0.5, abs=0.001)


def test_samples_after_a_small_seek_equal_those_after_a_full_one(clip, stage):
    played = []
    for is_kept in (True, False):
        theatre = stage(clip)
        ring = clip_of(theatre.player).sound.ring
        if not is_kept:
            ring.resume_from = lambda _epoch, _media_s: False
        theatre.player.play()
        theatre.run(0.6)
        theatre.player.seek(1.0)
        theatre.run(0.2)
        rows = np.arange(48_000, 48_000 + 9_600) % ring._capacity
        played.append(ring._samples[rows].copy())
    assert np.abs(played[1]).max() > 0.1
    np.testing.assert_allclose(played[0], played[1], atol=1e-5)


def test_another_clip_never_plays_the_sound_of_the_one_before(clip, counts, stage):
    theatre = stage(clip)
    theatre.run(0.1)
    counts.take()
    theatre.player.open(theatre.player.snapshot().source)
    theatre.run(0.1)
    assert counts.take()["AudioDecoder.next_block"] >= 1


def test_muted_without_a_window_decodes_no_sound(clip, counts, stage):
    found = []
    for with_sound in (True, False):
        theatre = stage(clip, with_sound=with_sound)
        theatre.player.play()
        theatre.run(1.5)
        shown = dict.fromkeys(one[1:] for one in theatre.sink.shown)
        feeder = clip_of(theatre.player).sound.feeder
        theatre.player.close()  # its threads would count for the next one
        found.append((feeder, counts.take(), list(shown)))
    (_, heard, loud_shown), (no_feeder, silent, muted_shown) = found
    assert heard["AudioDecoder.next_block"] > 0
    assert silent["AudioDecoder.next_block"] == silent["AudioDecoder.seek"] == 0
    assert no_feeder is None
    count = min(len(loud_shown), len(muted_shown))
    assert count >= 34
    assert loud_shown[:count] == muted_shown[:count]
