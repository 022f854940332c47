"""Which frame is due: shown in time, dropped when too late."""

from collections.abc import Callable
from typing import Protocol

from hapticplayer.clock import Clock
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.feeders import VideoFeeder

POLL_S = 0.034
"""A little more than a frame of 30 Hz is shown, so that one call does for both."""
PREVIEW_POLL_S = 0.005
"""Somebody waits for the frame of a seek."""
STARVED_POLL_S = 0.0125
MAX_LATE_DROPS = 15  # show one frame in half a second whatever happens
# Converting and painting take 1 to 3 ms, up to 12 for 4K; a frame is begun so much
# earlier that it is on time.
MAX_SHOW_COST_S = 0.020
# On top of that: a force before its frame is felt three times sooner than one after
# it, so the frame is aimed to be a little early, not the force.
FRAME_LEAD_S = 0.001
SHOW_COST_SMOOTHING = 0.1


class FrameSink(Protocol):
    """Where frames go."""

    def show(self, frame: DecodedFrame) -> None:
        """Present a frame now; returns when it is on the screen."""
        ...


class NullSink:
    """Presents to nobody."""

    def show(self, frame: DecodedFrame) -> None:
        """Accept the frame."""


class Screen:
    """Presents the frames of one clip after the other.

    Args:
        clock: of the machine.
        sink: where frames go; may be changed.
        presented: called for each frame that was played: monotonic time at which it was
            on the screen, and its own time, s.
    """

    def __init__(
        self, clock: Clock, sink: FrameSink, presented: Callable[[float, float], None]
    ) -> None:
        self.sink = sink
        self.frame_s = 0.0  # of what is shown
        self.shown = self.dropped = 0
        self._clock, self._presented = clock, presented
        self._preview: DecodedFrame | None = None
        self._needs_preview = False
        self._late_in_a_row = 0
        self._show_cost_s = 0.0

    def forget(self) -> None:
        """There is no clip any more."""
        self._preview, self._needs_preview = None, False

    def renew(self) -> None:
        """The position has changed: show where it is, without waiting for the clock."""
        self._preview, self._needs_preview = None, True

    def present(
        self, now_s: float, feeder: VideoFeeder, clock: PlaybackClock | None
    ) -> float:
        """Show the frame that is due and return when the next one is, s.

        Args:
            now_s: monotonic time.
            feeder: has the frames.
            clock: None while it stands still.
        """
        if clock is None or now_s < clock.monotonic0_s:
            if self._needs_preview and (frame := feeder.pop()) is not None:
                self.show_still(frame)
            if clock is not None:
                return clock.monotonic0_s
            is_awaited = self._needs_preview and not feeder.is_at_end
            return now_s + (PREVIEW_POLL_S if is_awaited else POLL_S)
        if self._preview is not None:
            self._show(self._preview)
            self._preview = None
        early_s = self._show_cost_s + FRAME_LEAD_S
        media_s = clock.media_s(now_s + early_s)
        while (frame := feeder.peek()) is not None and frame.pts_s <= media_s:
            if self._is_late(frame, feeder, media_s):
                self.dropped += 1
            else:
                self._show(frame)
            # not before: the decoder that this wakes would fight for the interpreter
            # while the frame is painted (p95 3.4 ms late instead of 1.3)
            feeder.pop()
        if frame is None:
            return now_s + STARVED_POLL_S
        return clock.monotonic_s(frame.pts_s) - early_s

    def _is_late(
        self, frame: DecodedFrame, feeder: VideoFeeder, media_s: float
    ) -> bool:
        """Whether the time of a frame is over, and it need not be shown."""
        following = feeder.peek(1)
        if following is not None:
            is_late = following.pts_s <= media_s
        else:  # the decoder is behind, unless this is the last frame
            is_late = not feeder.is_at_end and frame.pts_s + frame.duration_s < media_s
        self._late_in_a_row = self._late_in_a_row + 1 if is_late else 0
        return is_late and self._late_in_a_row % MAX_LATE_DROPS != 0

    def show_still(self, frame: DecodedFrame) -> None:
        """Show a frame that does not count as played yet."""
        self._needs_preview, self._preview = False, frame
        self.frame_s = frame.pts_s
        self.sink.show(frame)

    def _show(self, frame: DecodedFrame) -> None:
        self._needs_preview = False
        begun_s = self._clock.now_s()
        self.sink.show(frame)
        shown_s = self._clock.now_s()
        cost_s = min(shown_s - begun_s, MAX_SHOW_COST_S)
        self._show_cost_s += SHOW_COST_SMOOTHING * (cost_s - self._show_cost_s)
        self.shown += 1
        self.frame_s = frame.pts_s
        self._presented(shown_s, frame.pts_s)
