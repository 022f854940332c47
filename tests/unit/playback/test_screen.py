"""When the screen asks to be called again."""

from hapticplayer.clock import ManualClock
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.screen import POLL_S, PREVIEW_POLL_S, NullSink, Screen

HEARTBEAT_RAMP_S, FRAME_S = 0.150, 0.04


class Frames:
    """As much of a feeder as the screen asks for."""

    def __init__(self, times_s: list[float]) -> None:
        self.queue = [DecodedFrame(t, FRAME_S, None) for t in times_s]  # type: ignore[arg-type]
        self.is_at_end = False

    def peek(self, number: int = 0) -> DecodedFrame | None:
        return self.queue[number] if number < len(self.queue) else None

    def pop(self) -> DecodedFrame | None:
        return self.queue.pop(0) if self.queue else None


def test_one_call_serves_a_frame_and_the_heartbeat_at_30_hz() -> None:
    clock = ManualClock()
    screen = Screen(clock, NullSink(), lambda _shown_s, _pts_s: None)
    begin_s = clock.now_s()
    running = PlaybackClock(1, begin_s, 0.0, 1.0, begin_s + 100.0)
    feeder = Frames([k / 30 for k in range(31)])
    calls, now_s = 0, begin_s
    while feeder.queue:
        next_s = screen.present(now_s, feeder, running)  # type: ignore[arg-type]
        now_s = min(next_s, now_s + POLL_S) + 1e-6
        clock.advance(max(0.0, now_s - clock.now_s()))
        calls += 1
    assert screen.shown == 31
    assert calls <= 32
    assert POLL_S < HEARTBEAT_RAMP_S / 4


def test_somebody_who_waits_for_a_picture_is_looked_after_sooner() -> None:
    screen = Screen(ManualClock(), NullSink(), lambda _shown_s, _pts_s: None)
    feeder = Frames([])
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    screen.renew()
    assert screen.present(5.0, feeder, None) == 5.0 + PREVIEW_POLL_S  # type: ignore[arg-type]
    feeder.is_at_end = True  # none will ever come
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    feeder.queue = Frames([1.0]).queue
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    assert screen.frame_s == 1.0


def test_late_frames_are_dropped_but_one_in_15() -> None:
    shown: list[float] = []
    screen = Screen(ManualClock(), NullSink(), lambda _s, pts_s: shown.append(pts_s))
    running = PlaybackClock(1, 0.0, 0.0, 1.0, 100.0)
    for number in range(60):  # one by one, as from a decoder that is 2 s behind
        feeder = Frames([FRAME_S * number])
        now_s = FRAME_S * number + 2.0
        screen.present(now_s, feeder, running)  # type: ignore[arg-type]
        assert not feeder.queue
    assert shown == [FRAME_S * number for number in (14, 29, 44, 59)]
    assert (screen.shown, screen.dropped) == (4, 56)


def test_of_several_frames_that_are_due_the_last_is_shown() -> None:
    shown: list[float] = []
    screen = Screen(ManualClock(), NullSink(), lambda _s, pts_s: shown.append(pts_s))
    running = PlaybackClock(1, 0.0, 0.0, 1.0, 100.0)
    feeder = Frames([0.0, 0.04, 0.08, 0.12])
    screen.present(0.09, feeder, running)  # type: ignore[arg-type]
    assert (shown, screen.dropped) == ([0.08], 2)
    assert [frame.pts_s for frame in feeder.queue] == [0.12]


def test_the_last_frame_is_shown_however_late() -> None:
    screen = Screen(ManualClock(), NullSink(), lambda _s, _pts_s: None)
    feeder = Frames([1.0])
    feeder.is_at_end = True
    screen.present(9.0, feeder, PlaybackClock(1, 0.0, 0.0, 1.0, 100.0))  # type: ignore[arg-type]
    assert screen.shown == 1


def test_a_pause_right_after_the_first_frame_keeps_it() -> None:
    screen = Screen(ManualClock(), NullSink(), lambda _s, _pts_s: None)
    screen.renew()
    feeder = Frames([0.0, 0.04])
    screen.present(0.01, feeder, PlaybackClock(1, 0.0, 0.0, 1.0, 100.0))  # type: ignore[arg-type]
    screen.present(0.02, feeder, None)  # type: ignore[arg-type]
    assert screen.frame_s == 0.0
