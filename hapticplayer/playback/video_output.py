"""The frames of one clip after the other: decoder, screen, and what went wrong."""

from collections.abc import Callable
from pathlib import Path

from hapticplayer.clock import Clock
from hapticplayer.errors import message_of
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.feeders import VideoFeeder
from hapticplayer.playback.screen import POLL_S, FrameSink, NullSink, Screen

STALLED_S = 0.2


class VideoOutput:
    """Shows the frames of a clip.

    Args:
        clock: of the machine.
        sink: where frames go; None for nowhere.
        presented: called with the monotonic time of each frame and its own time, s.
    """

    def __init__(
        self,
        clock: Clock,
        sink: FrameSink | None,
        presented: Callable[[float, float], None],
    ) -> None:
        self._screen = Screen(clock, sink or NullSink(), presented)
        self._feeder: VideoFeeder | None = None
        self._leaving: list[VideoFeeder] = []  # asked to end, and not waited for
        self._damaged = 0
        self._fed_s = 0.0

    @property
    def shown(self) -> int:
        """Frames that were shown, of all clips."""
        return self._screen.shown

    @property
    def dropped(self) -> int:
        """Frames that came too late to be shown, of all clips."""
        return self._screen.dropped

    @property
    def damaged(self) -> int:
        """Frames of the last clip that are missing or broken."""
        return self._feeder.damaged if self._feeder else self._damaged

    @property
    def problem(self) -> str:
        """Why this clip cannot be decoded any further, "" for nothing."""
        problem = self._feeder.problem if self._feeder else None
        return message_of(problem) if problem else ""

    @property
    def frame_s(self) -> float:
        """Time of the frame that is shown."""
        return self._screen.frame_s

    @property
    def is_ready(self) -> bool:
        """Whether enough is decoded to begin."""
        feeder = self._feeder
        return feeder is None or feeder.is_at_end or feeder.peek(1) is not None

    @property
    def is_dry(self) -> bool:
        """Whether nothing comes any more, for decoding has failed."""
        feeder = self._feeder
        return feeder is not None and feeder.problem is not None and not feeder.peek()

    def open(self, path: Path) -> None:
        """Take another clip; `go_to` begins to decode it."""
        self.forget()
        self._feeder = VideoFeeder(path)

    def forget(self) -> None:
        """Drop the clip."""
        if self._feeder is not None:
            self._feeder.leave()
            self._leaving = [feeder for feeder in self._leaving if feeder.is_alive()]
            self._leaving.append(self._feeder)
            self._damaged = self._feeder.damaged
            self._feeder = None
        self._screen.forget()

    def close(self) -> None:
        """Drop the clip and wait for all decoders."""
        self.forget()
        for feeder in self._leaving:
            feeder.stop()

    def go_to(self, epoch: int, media_s: float) -> None:
        """Show where the clip stands now."""
        self._screen.renew()
        if self._feeder is not None:
            self._feeder.request(epoch, media_s)
            if self._feeder.ident is None:
                self._feeder.start()

    def show_next(self) -> float | None:
        """Show the next frame without playing, and return its time, s."""
        frame = self._feeder.pop() if self._feeder else None
        if frame is None:
            return None
        self._screen.show_still(frame)
        return frame.pts_s

    def expect(self, frame_s: float) -> None:
        """Count from this frame on until it is decoded and shown."""
        self._screen.frame_s = max(0.0, frame_s)

    def present(self, now_s: float, clock: PlaybackClock | None) -> float:
        """Show the frame that is due and return when the next one is, s."""
        if self._feeder is None:
            return now_s + POLL_S
        return self._screen.present(now_s, self._feeder, clock)

    def has_stalled(self, now_s: float, *, is_playing: bool) -> bool:
        """Whether the decoder has not kept up for 0.2 s."""
        feeder = self._feeder
        is_fed = feeder is None or feeder.is_at_end or feeder.peek() is not None
        if is_fed or not is_playing:
            self._fed_s = now_s
        return now_s > self._fed_s + STALLED_S

    def set_sink(self, sink: FrameSink) -> None:
        """Show frames somewhere else."""
        self._screen.sink = sink
