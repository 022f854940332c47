"""Work that nobody would notice is not done, and what remains is the same."""

import hashlib
import threading

import av
import numpy as np
import pytest

from hapticplayer.media import AudioDecoder, Picture, VideoDecoder
from hapticplayer.media.pictures import PictureConverter
from hapticplayer.playback.feeders import QUEUE_PICTURES, VideoFeeder
from hapticplayer.playback.snapshot import Phase
from tests.unit.playback.conftest import RATE_HZ, Theatre

FRAME_S = 1.0 / RATE_HZ


class PixelSink:
    """Keeps when each picture came, its time, and a digest of what was on it."""

    def __init__(self, clock):
        self.clock, self.shown = clock, []

    def show(self, picture):
        digest = b""
        if picture.has_pixels:
            digest = hashlib.sha256(picture.as_rgb().tobytes()).digest()
        self.shown.append((round(self.clock.now_s(), 6), picture.pts_s, digest))


class Counts:
    """How often the costly things have been done, and what the loop was told."""

    def __init__(self, monkeypatch):
        self.of, self._monkeypatch = {}, monkeypatch
        self.watch(PictureConverter, "_converted")
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
        theatre.player._screen.sink = theatre.sink
        theatre.published = []
        theatre.player._link.publish = lambda clock, feedback: theatre.published.append(
            (clock.rate, round(clock.media_s(theatre.clock.now_s()), 6), feedback)
        )
        made.append(theatre)
        return theatre

    yield make
    for theatre in made:
        theatre.player.close()


def pictures_of(feeder):
    """Drive a feeder on this thread and return everything that comes out."""
    found = []
    while not feeder.is_at_end:
        feeder._decode()
        while (picture := feeder.pop()) is not None:
            found.append((picture.pts_s, picture.as_rgb().tobytes()))
    return found


def open_feeder(path):
    feeder = VideoFeeder(path)
    feeder._open()
    return feeder


def test_late_pictures_are_decoded_but_not_converted(clip, counts):
    feeder = open_feeder(clip.path)
    every = pictures_of(feeder)
    feeder._close()
    assert counts.take()["PictureConverter._converted"] == len(every) == 75
    feeder = open_feeder(clip.path)
    feeder.set_position(2.0)
    kept = pictures_of(feeder)
    feeder._close()
    in_time = [one for one in every if one[0] + FRAME_S >= 2.0]
    # one in 15 is shown whatever happens, so that the picture never stands still
    assert kept[-len(in_time) :] == in_time
    assert set(kept) <= set(every)
    late = len(every) - len(in_time)
    assert len(kept) == len(in_time) + late // 15
    assert counts.take()["PictureConverter._converted"] == len(kept)
    assert feeder.dropped == len(every) - len(kept)


@pytest.mark.parametrize(
    ("rate_hz", "low"), [(25.0, 2), (30.0, 2), (50.0, 3), (60.0, 4)]
)
def test_the_decoder_sleeps_until_60_ms_of_pictures_are_left(
    clip, counts, rate_hz, low
):
    feeder = open_feeder(clip.path)
    feeder._decoder.frame_rate_hz = rate_hz
    feeder._set_ahead()
    counts.take()  # one was decoded to open the clip

    def decoded():
        while feeder._has_work():
            feeder._decode()
        return counts.take()["VideoDecoder.next_frame"]

    assert decoded() == QUEUE_PICTURES
    for _ in range(3):
        awake = []
        for _ in range(QUEUE_PICTURES - low):
            feeder.pop()
            awake.append(decoded())
        assert awake == [*[0] * (QUEUE_PICTURES - low - 1), QUEUE_PICTURES - low]
        assert len(feeder._queue) == QUEUE_PICTURES
    feeder._close()


def test_hidden_frames_are_not_converted(clip, counts, stage):
    runs = []
    for is_seen in (True, False):
        theatre = stage(clip)
        theatre.run(0.04)
        counts.take()
        theatre.player.set_seen(is_seen=is_seen)
        theatre.player.play()
        theatre.run(1.0)
        done = counts.take()
        times = [(now_s, pts_s) for now_s, pts_s, _ in theatre.sink.shown]
        snapshot = theatre.player.snapshot()
        told = (snapshot.frames_shown, snapshot.frames_dropped, snapshot.phase)
        runs.append((done, times, theatre.published, told))
    (seen, *seen_rest), (unseen, *unseen_rest) = runs
    assert unseen_rest == seen_rest
    assert seen["PictureConverter._converted"] >= 20
    assert unseen["PictureConverter._converted"] == 0
    assert unseen["VideoDecoder.next_frame"] == seen["VideoDecoder.next_frame"]


def test_who_looks_again_sees_the_right_picture_at_once(clip, counts, stage):
    theatre = stage(clip)
    theatre.player.play()
    theatre.run(0.3)
    theatre.player.set_seen(is_seen=False)
    theatre.run(0.3)
    theatre.settle()
    queued = len(theatre.player._video_feeder._queue)
    assert 2 < queued <= QUEUE_PICTURES
    counts.take()
    theatre.player.set_seen(is_seen=True)
    theatre.settle()  # the queue is filled in
    assert counts.take()["PictureConverter._converted"] == queued
    before = len(theatre.sink.shown)
    theatre.run(0.3)
    theatre.player.pause()
    back = theatre.sink.shown[before:]
    reference = stage(clip)
    reference.player.play()
    reference.run(0.95)
    right = {pts_s: digest for _, pts_s, digest in reference.sink.shown}
    assert len(back) >= 6
    assert all(digest == right[pts_s] for _, pts_s, digest in back)


@pytest.mark.parametrize("way", ["paused", "ended"])
def test_a_paused_clip_shown_again_shows_its_position(clip, stage, way):
    theatre = stage(clip)
    theatre.player.play()
    theatre.run(0.2)
    theatre.player.set_seen(is_seen=False)
    theatre.run(0.4 if way == "paused" else 3.5)
    if way == "paused":
        theatre.player.pause()
    phase, media_s = theatre.player.snapshot().phase, theatre.player.snapshot().media_s
    assert phase is {"paused": Phase.PAUSED, "ended": Phase.ENDED}[way]
    theatre.player.set_seen(is_seen=True)
    theatre.run(0.1)
    _, pts_s, digest = theatre.sink.shown[-1]
    assert digest
    assert pts_s <= media_s <= pts_s + FRAME_S + 1e-6
    assert (theatre.player.snapshot().phase, theatre.player.snapshot().media_s) == (
        phase,
        media_s,
    )


def test_without_a_screen_no_picture_is_converted(clip, counts):
    theatre = Theatre(clip, with_screen=False)
    try:
        theatre.player.play()
        theatre.run(1.0)
        done = counts.take()
        assert done["PictureConverter._converted"] == 0
        assert done["VideoDecoder.next_frame"] >= 20
        assert theatre.player.snapshot().frames_shown >= 20
    finally:
        theatre.player.close()


@pytest.fixture(scope="module")
def slides(tmp_path_factory):
    """A lossless clip of 3 pictures that stay for 10 frames each."""
    path = tmp_path_factory.mktemp("slides") / "slides.mkv"
    rng = np.random.default_rng(3)
    with av.open(str(path), "w") as file:
        stream = file.add_stream("libx264", rate=RATE_HZ, options={"qp": "0"})
        stream.width, stream.height, stream.pix_fmt = 128, 72, "yuv420p"
        for _ in range(3):
            slide = rng.integers(0, 256, (72, 128, 3)).astype(np.uint8)
            for _ in range(10):
                file.mux(stream.encode(av.VideoFrame.from_ndarray(slide, "rgb24")))
        file.mux(stream.encode())
    return path


def test_an_unchanged_frame_is_not_converted_again(slides, counts, monkeypatch):
    feeder = open_feeder(slides)
    pictures = pictures_of(feeder)
    feeder._close()
    assert counts.take()["PictureConverter._converted"] == 3
    monkeypatch.setattr(
        "hapticplayer.media.pictures.shows_the_same", lambda _one, _other: False
    )
    feeder = open_feeder(slides)
    assert pictures_of(feeder) == pictures
    feeder._close()
    assert counts.take()["PictureConverter._converted"] == len(pictures) == 30


def test_where_all_moves_few_pictures_are_compared(clip, counts, monkeypatch):
    from hapticplayer.media import pictures

    asked = []
    compare = pictures.shows_the_same
    monkeypatch.setattr(
        pictures, "shows_the_same", lambda *two: asked.append(two) or compare(*two)
    )
    feeder = open_feeder(clip.path)
    assert len(pictures_of(feeder)) == 75
    feeder._close()
    assert counts.take()["PictureConverter._converted"] == 75
    assert len(asked) == 8 + (74 - 8) // 8


def test_what_is_not_painted_does_not_make_the_next_picture_late(clip, theatre):
    screen = theatre.player._screen
    painted = Picture(0.0, 2, 2, 8, memoryview(bytes(16)), object())
    screen._show_cost_s = 0.002
    told = []
    screen._presented = lambda shown_s, pts_s: told.append((shown_s, pts_s))
    screen._show(painted)
    cost_s, now_s = screen._show_cost_s, theatre.clock.now_s()
    for number in range(50):
        screen._show(Picture(0.04 * number, 2, 2, 8, painted.pixels, painted.owner))
    assert screen._show_cost_s == cost_s
    assert told[-1] == (now_s + cost_s, 0.04 * 49)


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


def test_a_small_seek_after_a_resize_shows_the_new_size(clip, stage):
    theatre = stage(clip)
    sizes = []
    theatre.sink.show = lambda picture: sizes.append((picture.width, picture.height))
    theatre.player.set_size(64, 36)
    theatre.player.seek(0.5)
    theatre.run(0.04)
    theatre.player.set_size(96, 54)
    theatre.player.seek(0.5)
    theatre.run(0.04)
    assert sizes[-2:] == [(64, 36), (96, 54)]


def test_pictures_that_were_dropped_are_not_taken_for_covered(clip):
    feeder = open_feeder(clip.path)
    feeder._decode()
    feeder.pop()
    feeder.set_position(0.5)  # what is decoded next is late, and dropped
    while feeder.peek(1) is None:
        feeder._decode()
    first_s = feeder.peek().pts_s
    feeder.request(1, 0.5 * first_s)
    assert feeder._target == (1, 0.5 * first_s)
    feeder._close()


def test_a_seek_within_decoded_sound_decodes_nothing(clip, counts, stage):
    theatre = stage(clip)
    theatre.player.play()
    theatre.run(0.6)
    heard_s = theatre.player.snapshot().media_s
    counts.take()
    theatre.player.seek(heard_s + 0.4)
    theatre.run(0.5)
    assert counts.take()["AudioDecoder.seek"] == 0
    assert theatre.player._media.error_s == pytest.approx(0.0, abs=1e-4)
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
    monkeypatch.setattr("hapticplayer.playback.audio.STANDING_AHEAD_S", 0.5)
    theatre = stage(clip)
    ring = theatre.player._sound.ring
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
        ring = theatre.player._sound.ring
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
        feeder = theatre.player._sound.feeder
        theatre.player.close()  # its threads would count for the next one
        found.append((feeder, counts.take(), list(shown)))
    (_, heard, loud_shown), (no_feeder, silent, muted_shown) = found
    assert heard["AudioDecoder.next_block"] > 0
    assert silent["AudioDecoder.next_block"] == silent["AudioDecoder.seek"] == 0
    assert no_feeder is None
    count = min(len(loud_shown), len(muted_shown))
    assert count >= 34
    assert loud_shown[:count] == muted_shown[:count]
