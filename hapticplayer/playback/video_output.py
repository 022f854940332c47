"""The frames of one clip after the other: shown in time, dropped when too late."""

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from hapticplayer.clock import Clock
from hapticplayer.errors import message_of
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.feeders import VideoFeeder

POLL_S = 0.034
"""A little more than a frame of 30 Hz is shown, so that one call does for both."""
PREVIEW_POLL_S = 0.005
"""A person waits for the frame of a seek."""
STARVED_POLL_S = 0.0125
STALLED_S = 0.2
MAX_LATE_DROPS = 15  # show one frame in half a second in any case
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


class NullSink:
    """Presents nowhere."""

    def show(self, frame: DecodedFrame) -> None:
        """Accept the frame."""


class VideoOutput:
    """Shows the frames of a clip.

    `presented` is called for each frame that was played: monotonic time at which it was
    on the screen, and its own time, s. `shown` and `dropped` count those of all clips.
    """

    def __init__(
        self,
        clock: Clock,
        sink: FrameSink | None,
        presented: Callable[[float, float], None],
    ) -> None:
        self.sink = sink or NullSink()
        self.feeder: VideoFeeder | None = None
        self.frame_s = 0.0
        self.shown = self.dropped = 0
        self._clock, self._presented = clock, presented
        self._leaving: list[VideoFeeder] = []  # asked to end, and not waited for
        self._damaged = 0
        self._fed_s = 0.0
        self._preview: DecodedFrame | None = None
        self._needs_preview = False
        self._late_in_a_row = 0
        self._show_cost_s = 0.0

    @property
    def damaged(self) -> int:
        """Frames of the last clip that are missing or broken."""
        return self.feeder.damaged if self.feeder else self._damaged

    @property
    def problem(self) -> str:
        """Why this clip cannot be decoded any further, "" for nothing."""
        problem = self.feeder.problem if self.feeder else None
        return message_of(problem) if problem else ""

    @property
    def is_ready(self) -> bool:
        """Whether enough is decoded to begin."""
        feeder = self.feeder
        return feeder is None or feeder.is_at_end or feeder.peek(1) is not None

    @property
    def is_dry(self) -> bool:
        """Whether no frame follows, because decoding has failed."""
        feeder = self.feeder
        return feeder is not None and feeder.problem is not None and not feeder.peek()

    @property
    def is_previewing(self) -> bool:
        """Whether the frame of a seek has not been shown yet."""
        return self._needs_preview

    def open(self, path: Path | ClipBytes) -> None:
        """Take another clip; `go_to` begins to decode it."""
        self.forget()
        self.feeder = VideoFeeder(path)

    def forget(self) -> None:
        """Drop the clip."""
        if self.feeder is not None:
            self.feeder.leave()
            self._leaving = [feeder for feeder in self._leaving if feeder.is_alive()]
            self._leaving.append(self.feeder)
            self._damaged = self.feeder.damaged
            self.feeder = None
        self._preview, self._needs_preview = None, False

    def close(self) -> None:
        """Drop the clip and wait for all decoders."""
        self.forget()
        for feeder in self._leaving:
            feeder.stop()

    def go_to(self, epoch: int, media_s: float) -> None:
        """Show the frame of a position, without waiting for the clock."""
        self._preview, self._needs_preview = None, True
        if self.feeder is not None:
            self.feeder.request(epoch, media_s)
            if self.feeder.ident is None:
                self.feeder.start()

    def show_next(self) -> float | None:
        """Show the next frame without playing, and return its time, s."""
        frame = self.feeder.pop() if self.feeder else None
        if frame is None:
            return None
        self._needs_preview, self._preview = False, frame
        self.frame_s = frame.pts_s
        self.sink.show(frame)
        return frame.pts_s

    def present(self, now_s: float, clock: PlaybackClock | None) -> float:
        """Show the frame that is due and return when the next one is, s."""
        feeder = self.feeder
        if feeder is None:
            return now_s + POLL_S
        if clock is None or now_s < clock.monotonic0_s:
            if self._needs_preview:
                self.show_next()
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

    def has_stalled(self, now_s: float, *, is_playing: bool) -> bool:
        """Whether the decoder has not kept up for 0.2 s."""
        feeder = self.feeder
        is_fed = feeder is None or feeder.is_at_end or feeder.peek() is not None
        if is_fed or not is_playing:
            self._fed_s = now_s
        return now_s > self._fed_s + STALLED_S

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
