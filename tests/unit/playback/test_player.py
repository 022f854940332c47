"""The player's state machine and its timing, on virtual time with real decoders."""

import threading

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.processes import Health
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ForceTrack
from hapticplayer.playback import sound
from hapticplayer.playback.clock import ClockSource
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.output import Output, OutputContext
from hapticplayer.playback.phases import Phase
from tests.conftest import clip_of
from tests.unit.playback.conftest import Theatre

FRAME_S = 1 / 25
LATENCY_S = 0.12


def test_opening_shows_the_first_picture_and_does_not_play(theatre):
    theatre.run(0.2)
    assert [pts for _, pts in theatre.sink.shown] == [0.0]
    assert theatre.player.snapshot().phase is Phase.PAUSED
    assert theatre.player.snapshot().media_s == 0.0


def test_pictures_come_when_the_sound_says_so(theatre):
    theatre.player.play()
    theatre.run(2.0)
    shown = np.array(theatre.sink.shown[1:])
    start_s = shown[0, 0]
    lateness_s = shown[:, 0] - start_s - shown[:, 1]
    # time moves in steps of 4 ms here; nothing may be early or later than a step
    assert lateness_s.min() > -0.0005
    assert lateness_s.max() < 0.0045
    assert np.allclose(np.diff(shown[:, 1]), FRAME_S, atol=1e-6)
    assert theatre.player.snapshot().clock == "audio"
    assert theatre.player.snapshot().frames_dropped == 0


def test_the_clock_starts_with_the_first_sound_not_before(theatre):
    theatre.player.play()
    theatre.run(LATENCY_S - 0.02)
    assert theatre.player.snapshot().media_s == 0.0
    theatre.run(0.5)
    assert theatre.player.snapshot().media_s == pytest.approx(0.48, abs=0.02)


def test_without_sound_the_monotonic_clock_leads(silent_theatre):
    silent_theatre.player.play()
    silent_theatre.run(1.0)
    assert silent_theatre.out is None
    assert silent_theatre.player.snapshot().clock == "monotonic"
    assert silent_theatre.player.snapshot().media_s == pytest.approx(1.0, abs=0.01)


def test_pause_stands_and_play_goes_on_from_there(theatre):
    theatre.player.play()
    theatre.run(1.0)
    theatre.player.pause()
    position_s = theatre.player.snapshot().media_s
    theatre.run(1.0)
    assert theatre.player.snapshot().media_s == position_s
    theatre.player.play()
    theatre.run(0.5)
    gained = theatre.player.snapshot().media_s - position_s
    assert gained == pytest.approx(0.5 - LATENCY_S, abs=0.02)


@pytest.mark.parametrize("is_woken", [True, False])
def test_sound_that_was_let_rest_goes_on_where_it_was(theatre, is_woken):
    theatre.player.play()
    theatre.run(1.0)
    theatre.player.rest(is_wanted=True)  # it plays: nothing rests
    assert theatre.player.snapshot().audio == "silent"
    theatre.player.pause()
    position_s = theatre.player.snapshot().media_s
    theatre.player.rest(is_wanted=True)
    theatre.out = None
    theatre.run(1.0)
    assert theatre.out is None
    if is_woken:
        theatre.player.rest(is_wanted=False)
        theatre.run(0.1)
    theatre.player.play()
    theatre.run(0.5)
    assert theatre.player.snapshot().clock == "audio"
    gained_s = theatre.player.snapshot().media_s - position_s
    assert gained_s == pytest.approx(0.5 - LATENCY_S, abs=0.02)


def test_a_seek_shows_the_picture_that_covers_it(theatre):
    theatre.run(0.1)
    theatre.player.seek(1.53)
    theatre.run(0.1)
    pts_s = theatre.sink.shown[-1][1]
    assert pts_s <= 1.53 < pts_s + FRAME_S
    assert theatre.player.snapshot().media_s == pytest.approx(1.53)
    assert theatre.player.snapshot().phase is Phase.PAUSED


def test_many_seeks_while_playing_leave_it_playing_in_time(theatre, rng):
    theatre.player.play()
    for target_s in rng.uniform(0.0, 2.0, 12):
        theatre.run(0.1)
        theatre.player.seek(float(target_s))
    theatre.run(0.6)
    assert theatre.player.snapshot().phase is Phase.PLAYING
    now_s, pts_s = theatre.sink.shown[-1]
    theatre.clock.advance(0.0)
    media_s = theatre.player.snapshot().media_s
    assert 0.0 <= media_s - pts_s < FRAME_S + 0.008
    assert now_s <= theatre.clock.now_s()


def test_seeks_outside_the_clip_are_brought_inside(theatre):
    theatre.player.seek(-5.0)
    assert theatre.player.snapshot().media_s == 0.0
    theatre.player.seek(99.0)
    assert (
        theatre.player.snapshot().media_s
        == theatre.player.snapshot().source.clip.duration_s
    )


def test_at_the_end_it_stops_and_plays_again_from_the_start(theatre):
    theatre.player.seek(2.5)
    theatre.player.play()
    theatre.run(1.0)
    assert theatre.player.snapshot().phase is Phase.ENDED
    assert not theatre.player.snapshot().is_playing
    theatre.player.play()
    theatre.run(0.5)
    assert theatre.player.snapshot().phase is Phase.PLAYING
    assert theatre.player.snapshot().media_s < 0.6


def test_when_the_sound_dies_the_picture_goes_on(theatre):
    theatre.player.play()
    theatre.run(1.0)
    before_s = theatre.player.snapshot().media_s
    theatre.out.is_alive = False
    theatre.run(1.0)
    assert theatre.player.snapshot().clock == "monotonic"
    assert theatre.player.snapshot().media_s - before_s == pytest.approx(1.0, abs=0.01)


def test_a_sound_that_never_starts_is_not_waited_for_for_ever(theatre):
    theatre.out.is_alive = False
    theatre.player.play()
    theatre.run(4.0)
    assert theatre.player.snapshot().clock == "monotonic"
    assert 0.5 < theatre.player.snapshot().media_s < 1.5


def test_late_pictures_are_dropped_not_shown_late(theatre):
    theatre.player.play()
    theatre.run(0.5)
    theatre.settle()
    for _ in range(30):  # the front end is busy for 0.3 s, the sound goes on
        theatre.out.advance(480)
        theatre.clock.advance(0.01)
    shown_before = len(theatre.sink.shown)
    theatre.player.poll()
    assert theatre.player.snapshot().frames_dropped >= 3
    theatre.run(0.5)
    later = [pts for _, pts in theatre.sink.shown[shown_before:]]
    assert all(np.diff(later) > 0)


def test_another_feedback_starts_a_new_epoch_and_video_continues(theatre):
    theatre.player.play()
    theatre.run(1.0)
    epoch, media_s = theatre.player.snapshot().epoch, theatre.player.snapshot().media_s
    theatre.player.set_feedback("other")
    assert theatre.player.snapshot().epoch == epoch + 1
    assert theatre.player.snapshot().media_s == pytest.approx(media_s)
    theatre.run(0.5)
    assert theatre.player.snapshot().media_s == pytest.approx(media_s + 0.5, abs=0.01)
    assert theatre.player.snapshot().clock == "audio"


def test_a_feedback_that_is_not_there_changes_nothing(theatre):
    theatre.player.set_feedback("strong")
    assert theatre.player.snapshot().feedback == "realistic"


def test_an_edited_track_is_taken_while_the_clip_plays(theatre):
    theatre.player.play()
    theatre.run(1.0)
    before = theatre.player.snapshot()
    edited = ForceTrack([0.0, 3.0], [[0, 2.0, 0], [0, 2.0, 0]])
    theatre.player.replace_track("realistic", edited)
    theatre.player.replace_track("missing", edited)
    after = theatre.player.snapshot()
    assert (after.epoch, after.phase) == (before.epoch, before.phase)
    assert after.source.tracks["realistic"] is edited
    assert set(after.source.tracks) == set(before.source.tracks)
    assert before.source.tracks["realistic"] is not edited


class GivenTracks:
    """Processes that note the tracks they are given, newest last."""

    health, notice = Health.NONE, ""

    def __init__(self, _clock, device, **_options):
        self.device, self.given = device, []

    def load(self, tracks):
        self.given.extend(tracks.items())

    def replace(self, name, track):
        self.given.append((name, track))

    def poll(self):
        return self.health

    def close(self):
        pass


def test_an_output_gets_the_edited_track_also_after_it_was_lent(manual_clock):
    context = OutputContext(
        manual_clock, Reporter(manual_clock), StopLatch(), None, GivenTracks
    )
    output = Output(context, "simulated")
    track = ForceTrack([0.0, 3.0], [[0, 4.5, 0], [0, 4.5, 0]])
    output.load({"realistic": track, "other": track}, None)
    edited = ForceTrack([0.0, 3.0], [[0, 2.0, 0], [0, 2.0, 0]])
    output.replace("other", edited)
    assert output.processes.given[-1] == ("other", edited)
    output.lend()
    output.take_back()
    assert dict(output.processes.given) == {"realistic": track, "other": edited}
    output.wait_released()


def test_closing_ends_all_threads(clip):
    before = set(threading.enumerate())
    made = Theatre(clip)
    made.player.play()
    made.run(0.2)
    made.player.close()
    assert set(threading.enumerate()) == before


def test_a_clip_that_breaks_ends_with_a_sentence(theatre, monkeypatch):
    from hapticplayer.errors import MediaError

    theatre.player.play()
    theatre.run(0.3)

    def broken(_decoder):
        raise MediaError("is damaged", where="short.mp4")

    monkeypatch.setattr(VideoDecoder, "next_frame", broken)
    reading = threading.Event()  # never set: gives the reading thread a moment
    for _ in range(4000):
        theatre.player.poll()
        if theatre.player.snapshot().phase is Phase.ENDED:
            break
        theatre.out.advance(192)
        theatre.clock.advance(0.004)
        reading.wait(0.002)
    assert "damaged" in theatre.player.snapshot().problem
    assert theatre.player.snapshot().phase is Phase.ENDED


def test_a_seek_in_a_clip_that_has_broken_does_not_wait_for_ever(theatre, monkeypatch):
    from hapticplayer.errors import MediaError

    player = theatre.player
    player.play()
    theatre.run(0.3)

    def broken(_decoder):
        raise MediaError("is damaged", where="short.mp4")

    monkeypatch.setattr(VideoDecoder, "next_frame", broken)
    clip_of(player).video.feeder.request(99, 2.0)
    clip_of(player).video.feeder.join(20)
    assert clip_of(player).video.feeder.problem is not None
    player.seek(1.0)
    player.play()
    reading = threading.Event()
    for _ in range(500):
        player.poll()
        if player.snapshot().phase is Phase.ENDED:
            break
        theatre.out.advance(192)
        theatre.clock.advance(0.004)
        reading.wait(0.001)
    assert player.snapshot().phase is Phase.ENDED


def test_a_sound_output_that_was_lost_comes_back_without_a_jump(theatre, monkeypatch):
    monkeypatch.setattr(sound, "RETRY_S", 0.001)
    monkeypatch.setattr(sound, "SETTLED_S", 0.3)
    monkeypatch.setattr(sound, "OPENING_S", 0.5)
    player, first = theatre.player, theatre.out
    player.play()
    theatre.run(0.6)
    epoch, first.is_alive = player.snapshot().epoch, False
    offsets = []
    pause = SystemClock()  # for the thread that opens the new output
    while theatre.out is first or clip_of(player).media.source is not ClockSource.AUDIO:
        theatre.run(theatre.STEP_S)
        offsets.append(player.snapshot().media_s - theatre.clock.now_s())
        pause.sleep_until(pause.now_s() + 0.001)
        assert player.snapshot().phase is Phase.PLAYING, "the clip was over before"
    theatre.run(0.3)
    assert clip_of(player).media.source is ClockSource.AUDIO
    assert player.snapshot().epoch == epoch, "the force was interrupted"
    offsets.append(player.snapshot().media_s - theatre.clock.now_s())
    assert max(offsets) - min(offsets) < 0.001
    assert abs(clip_of(player).media.error_s) < 0.001


def test_when_the_picture_stops_the_force_does_until_it_is_back(theatre, monkeypatch):
    player = theatre.player

    def tracks():
        return [track for _, _, track in theatre.published]

    player.play()
    theatre.run(0.5)
    assert set(tracks()) == {"realistic"}
    goes_on, decode = threading.Event(), VideoDecoder.next_frame
    with monkeypatch.context() as stall:
        stall.setattr(
            VideoDecoder, "next_frame", lambda it: goes_on.wait(30.0) and decode(it)
        )
        stall.setattr(theatre, "settle_video", lambda: None)
        theatre.run(2 * FRAME_S + 0.15)  # so much is queued at least, 5 at most
        assert set(tracks()) == {"realistic"}
        theatre.run(3 * FRAME_S + 0.2)
        assert tracks()[-1] == ""
    goes_on.set()
    theatre.run(0.1)
    assert tracks()[-1] == "realistic"
    assert player.snapshot().phase is Phase.PLAYING


def test_every_frame_of_a_4k_clip_is_shown_in_order(tmp_path):
    path, levels = tmp_path / "large.mp4", range(40, 200, 16)
    frames = (np.full((2160, 3840, 3), level, np.uint8) for level in levels)
    write_clip(path, frames, frame_rate_hz=25, is_quick=True)
    theatre = Theatre(probe(path), with_sound=False)
    greys, converter = [], FrameConverter()

    def show(frame):
        image = converter.convert(frame, 1280, 720)
        greys.append(image.as_rgb()[::90, ::90].mean())

    theatre.sink.show = show
    theatre.run(0.02)  # shows the first one
    theatre.player.play()
    theatre.run(len(levels) / 25)
    snapshot = theatre.player.snapshot()
    theatre.player.close()
    assert (snapshot.frames_shown, snapshot.frames_dropped) == (len(levels), 0)
    assert greys == pytest.approx([levels[0], *levels], abs=2.5)
