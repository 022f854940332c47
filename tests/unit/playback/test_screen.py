"""When the screen asks to be called again."""

from hapticplayer.clock import ManualClock
from hapticplayer.media import Picture
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.screen import POLL_S, PREVIEW_POLL_S, NullSink, Screen

HEARTBEAT_RAMP_S = 0.150


class Pictures:
    """As much of a feeder as the screen asks for."""

    def __init__(self, times_s: list[float]) -> None:
        self.queue = [Picture(t, 2, 2, 8, memoryview(b""), None) for t in times_s]
        self.is_at_end = False

    def peek(self, number: int = 0) -> Picture | None:
        return self.queue[number] if number < len(self.queue) else None

    def pop(self) -> Picture | None:
        return self.queue.pop(0) if self.queue else None

    def set_position(self, media_s: float) -> None:
        self.position_s = media_s


def test_one_call_serves_a_frame_and_the_heartbeat_at_30_hz() -> None:
    clock = ManualClock()
    screen = Screen(clock, NullSink(), lambda _shown_s, _pts_s: None)
    begin_s = clock.now_s()
    running = PlaybackClock(1, begin_s, 0.0, 1.0, begin_s + 100.0)
    feeder = Pictures([k / 30 for k in range(31)])
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
    feeder = Pictures([])
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    screen.renew()
    assert screen.present(5.0, feeder, None) == 5.0 + PREVIEW_POLL_S  # type: ignore[arg-type]
    feeder.is_at_end = True  # none will ever come
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    feeder.queue = Pictures([1.0]).queue
    assert screen.present(5.0, feeder, None) == 5.0 + POLL_S  # type: ignore[arg-type]
    assert screen.picture_s == 1.0
