"""The side of the pictures: which is due, shown in time, dropped when too late."""

from collections.abc import Callable
from typing import Protocol

from hapticplayer.clock import Clock
from hapticplayer.media import Picture
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.feeders import VideoFeeder

POLL_S = 0.034
"""A little more than a picture of 30 Hz is shown, so that one call does for both."""
PREVIEW_POLL_S = 0.005
"""Somebody waits for the picture of a seek."""
STARVED_POLL_S = 0.0125
# Painting takes 1 to 3 ms; a picture is begun so much earlier that it is on time.
MAX_SHOW_COST_S = 0.008
# On top of that: a force before its picture is felt three times sooner than one after
# it, so the picture is aimed to be a little early, not the force.
PICTURE_LEAD_S = 0.001
SHOW_COST_SMOOTHING = 0.1


class FrameSink(Protocol):
    """Where pictures go."""

    def show(self, picture: Picture) -> None:
        """Present a picture now; returns when it is on the screen.

        One without pixels is for who wants the times alone.
        """
        ...


class NullSink:
    """Presents to nobody."""

    def show(self, picture: Picture) -> None:
        """Accept the picture."""


class Screen:
    """Presents the pictures of one clip after the other.

    Args:
        clock: of the machine.
        sink: where pictures go; may be changed.
        presented: told of each picture that was played: monotonic time at which it was
            on the screen, and its own time, s.
    """

    def __init__(
        self, clock: Clock, sink: FrameSink, presented: Callable[[float, float], None]
    ) -> None:
        self.sink = sink
        self.picture_s = 0.0  # of what is shown
        self.shown = self.dropped = 0
        self._clock, self._presented = clock, presented
        self._preview: Picture | None = None
        self._needs_preview = False
        self._show_cost_s = 0.0
        self._painted: object = None  # owner of what the sink has

    def forget(self) -> None:
        """There is no clip any more."""
        self._preview, self._needs_preview, self._painted = None, False, None

    def renew(self) -> None:
        """The position has changed: show where it is, without waiting for the clock."""
        self._preview, self._needs_preview = None, True

    def present(
        self, now_s: float, feeder: VideoFeeder, clock: PlaybackClock | None
    ) -> float:
        """Show the picture that is due and return when the next one is, s.

        Args:
            now_s: monotonic time.
            feeder: has the pictures.
            clock: None while it stands still.
        """
        if clock is None or now_s < clock.monotonic0_s:
            if self._needs_preview and (picture := feeder.pop()) is not None:
                self.show_still(picture)
            if clock is not None:
                return clock.monotonic0_s
            is_awaited = self._needs_preview and not feeder.is_at_end
            return now_s + (PREVIEW_POLL_S if is_awaited else POLL_S)
        if self._preview is not None:
            self._show(self._preview)
            self._preview = None
        early_s = self._show_cost_s + PICTURE_LEAD_S
        media_s = clock.media_s(now_s + early_s)
        feeder.set_position(media_s)
        while (picture := feeder.peek()) is not None and picture.pts_s <= media_s:
            following = feeder.peek(1)
            if following is not None and following.pts_s <= media_s:
                self.dropped += 1
            else:
                self._show(picture)
            # not before: the decoder that this wakes would fight for the interpreter
            # while the picture is painted (p95 3.4 ms late instead of 1.3)
            feeder.pop()
        if picture is None:
            return now_s + STARVED_POLL_S
        return clock.monotonic_s(picture.pts_s) - early_s

    def show_still(self, picture: Picture) -> None:
        """Show a picture that does not count as played yet."""
        self._needs_preview, self._preview = False, picture
        self.picture_s, self._painted = picture.pts_s, picture.owner
        self.sink.show(picture)

    def _show(self, picture: Picture) -> None:
        begun_s = self._clock.now_s()
        self.sink.show(picture)
        if picture.has_pixels and picture.owner is not self._painted:
            shown_s = self._clock.now_s()
            cost_s = min(shown_s - begun_s, MAX_SHOW_COST_S)
            self._show_cost_s += SHOW_COST_SMOOTHING * (cost_s - self._show_cost_s)
            self._painted = picture.owner
        else:  # nothing was painted: it counts when it would have been there
            shown_s = begun_s + self._show_cost_s
        self.shown += 1
        self.picture_s = picture.pts_s
        self._presented(shown_s, picture.pts_s)
