"""Which frame is shown, which is dropped, and when the output asks to be called again."""

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.video_output import (
    MAX_LATE_DROPS,
    POLL_S,
    PREVIEW_POLL_S,
    VideoOutput,
)

HEARTBEAT_RAMP_S, FRAME_S = 0.150, 0.04
RUNNING = PlaybackClock(1, 0.0, 0.0, 1.0, 100.0)


class Frames:
    """As much of a feeder as the output asks for."""

    ident, problem, damaged = 1, None, 0

    def __init__(self, times_s):
        self.queue = [DecodedFrame(t, FRAME_S, None) for t in times_s]
        self.is_at_end = False

    def peek(self, number=0):
        return self.queue[number] if number < len(self.queue) else None

    def pop(self):
        return self.queue.pop(0) if self.queue else None

    def request(self, epoch, media_s):
        self.requested = (epoch, media_s)


class Screen(VideoOutput):
    """Notes the times of the frames that were played."""

    def __init__(self, *times_s):
        self.clock, self.played_s = ManualClock(), []
        super().__init__(self.clock, None, lambda _shown_s, s: self.played_s.append(s))
        self.feeder = Frames(times_s)


def test_one_call_serves_a_frame_and_the_heartbeat_at_30_hz():
    screen = Screen(*[k / 30 for k in range(31)])
    begin_s = screen.clock.now_s()
    running = PlaybackClock(1, begin_s, 0.0, 1.0, begin_s + 100.0)
    calls, now_s = 0, begin_s
    while screen.feeder.queue:
        next_s = screen.present(now_s, running)
        now_s = min(next_s, now_s + POLL_S) + 1e-6
        screen.clock.advance(max(0.0, now_s - screen.clock.now_s()))
        calls += 1
    assert screen.shown == 31
    assert calls <= 32
    assert POLL_S < HEARTBEAT_RAMP_S / 4


def test_the_frame_of_a_seek_is_polled_for_more_often():
    screen = Screen()
    assert screen.present(5.0, None) == 5.0 + POLL_S
    screen.go_to(7, 1.0)
    assert screen.feeder.requested == (7, 1.0)
    assert screen.present(5.0, None) == 5.0 + PREVIEW_POLL_S
    screen.feeder.is_at_end = True  # none will ever come
    assert screen.present(5.0, None) == 5.0 + POLL_S
    screen.feeder.queue = Frames([1.0]).queue
    assert screen.present(5.0, None) == 5.0 + POLL_S
    assert (screen.frame_s, screen.is_previewing) == (1.0, False)


def test_late_frames_are_dropped_but_one_in_15():
    screen = Screen()
    for number in range(60):  # one by one, as from a decoder that is 2 s behind
        screen.feeder = Frames([FRAME_S * number])
        screen.present(FRAME_S * number + 2.0, RUNNING)
        assert not screen.feeder.queue
    shown = range(MAX_LATE_DROPS - 1, 60, MAX_LATE_DROPS)
    assert screen.played_s == [FRAME_S * number for number in shown]
    assert (screen.shown, screen.dropped) == (4, 56)


def test_of_several_frames_that_are_due_the_last_is_shown():
    screen = Screen(0.0, 0.04, 0.08, 0.12)
    screen.present(0.09, RUNNING)
    assert (screen.played_s, screen.dropped) == ([0.08], 2)
    assert [frame.pts_s for frame in screen.feeder.queue] == [0.12]


def test_the_last_frame_is_shown_however_late():
    screen = Screen(1.0)
    screen.feeder.is_at_end = True
    screen.present(9.0, RUNNING)
    assert screen.shown == 1


def test_a_pause_right_after_the_first_frame_keeps_it():
    screen = Screen(0.0, 0.04)
    screen.go_to(1, 0.0)
    screen.present(0.01, RUNNING)
    screen.present(0.02, None)
    assert screen.frame_s == 0.0


@pytest.mark.parametrize("is_playing", [True, False])
def test_a_decoder_behind_for_200_ms_has_stalled_while_playing(is_playing):
    screen = Screen(0.0)
    assert not screen.has_stalled(5.0, is_playing=is_playing)
    screen.feeder.queue.clear()
    assert not screen.has_stalled(5.19, is_playing=is_playing)
    assert screen.has_stalled(5.21, is_playing=is_playing) is is_playing
