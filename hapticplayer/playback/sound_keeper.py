"""Keeps a sound output open, also when one was lost while picture and force go on.

Neither PortAudio nor its process says anything when the sound server dies, and opening
again can take seconds. So what is not heard is replaced, and the new sound joins the
running clock, which never leaps for its sake.
"""

from collections.abc import Callable

from hapticplayer.errors import message_of
from hapticplayer.playback.audio import AudioRing
from hapticplayer.playback.clock import MediaClock, Source
from hapticplayer.playback.sound_process import AudioOut, OutputState

LOST_AFTER_S = 1.0
"""Without a report for so long, an output is lost; a busy computer is back sooner.
A new one may take its time: after the first blocks a null sink wanted none for 1.3 s."""
RETRY_S, SLOWEST_RETRY_S = 0.5, 8.0
OPENING_S = 3.0
"""So long does the clip wait for an output; a server that wakes its device took 1.3 s."""
PREBUFFER_S = 0.25
SETTLED_S = 1.5
"""A new output plays silence for so long: its first times are wrong."""
ALIGN_S, ALIGN_AGAIN_S, ALIGN_FROM_S = 5.0, 0.3, 0.003
"""For so long after that, how often, and from where on, sound that turns out to be off
(by 20 to 60 ms after the restart of a server) leaps to the clock, not the clock to it."""


class SoundKeeper:
    """Opens an output where one is wanted, and another one where that is lost.

    Args:
        ring: that outputs empty.
        media: the clock.
        make: starts to open one; OSError means that there is none yet.

    Attributes:
        is_open: whether there is an output that plays.
        was_lost: whether there is none any more, since the last one.
        problem: why there is none.
    """

    def __init__(
        self, ring: AudioRing, media: MediaClock, make: Callable[[], AudioOut] | None
    ) -> None:
        self.is_open = self.was_lost = False
        self.problem = ""
        self._ring, self._media, self._make = ring, media, make
        self._output: AudioOut | None = None
        self._is_wanted = False
        self._opening_s = self._retry_s = 0.0
        self._wait_s = RETRY_S
        self._heard_s = 0.0
        self._settled_s = 0.0  # from then on a new output can be relied on, 0: it is
        self._is_joining = False
        self._align_s = self._align_until_s = 0.0

    @property
    def name(self) -> str:
        """Name of the output that plays, "" for none."""
        return self._output.name if self._output and self.is_open else ""

    def want(self, now_s: float) -> None:
        """Open an output unless there is one."""
        if self._make is not None and not self._is_wanted:
            self._is_wanted, self._retry_s, self._wait_s = True, now_s, RETRY_S
            self._open(now_s)

    def use(self, make: Callable[[], AudioOut], now_s: float) -> None:
        """Play through another output from here on."""
        is_wanted = self._is_wanted
        self.close()
        self._make = make
        if is_wanted:
            self.want(now_s)

    def close(self) -> None:
        """Let go of the output, and look for none any more."""
        self.rest()
        self._is_wanted = self.was_lost = False
        self.problem = ""
        self._let_go()

    def rest(self) -> None:
        """The sound begins anew, after a seek or a pause."""
        self._is_joining, self._align_until_s, self._settled_s = False, 0.0, 0.0

    def is_settled(self, now_s: float) -> bool:
        """Whether there is no use in waiting for an output any longer."""
        is_opening = self._output is not None and not (self.is_open or self.problem)
        return not is_opening or now_s > self._opening_s + OPENING_S

    def look(
        self,
        now_s: float,
        request: Callable[[int, float], None],
        *,
        is_playing: bool,
    ) -> str:
        """Do what is due.

        Args:
            now_s: monotonic time.
            request: asks the decoder for sound of a generation from a position, s.
            is_playing: whether something should be heard.

        Returns:
            What has happened, "" for nothing.
        """
        happened = self._follow_output(now_s)
        is_silent = is_playing and self._media.source is Source.MONOTONIC
        if not is_silent or happened:
            self._heard_s = now_s
        if not self.is_open:
            return happened
        if happened:
            self._settled_s = now_s + SETTLED_S if is_playing else 0.0
        elif self._settled_s:
            self._load_when_settled(now_s, request)
        elif self._is_joining:
            self._join_when_ready(now_s)
        elif not is_silent and self._align_s < now_s < self._align_until_s:
            self._align(now_s)
        elif now_s > max(self._heard_s + LOST_AFTER_S, self._opening_s + OPENING_S):
            return self._lose(now_s)
        return happened

    def _follow_output(self, now_s: float) -> str:
        """Notice that the output is another one, open or gone."""
        if self._output is None and self._is_wanted and now_s >= self._retry_s:
            self._open(now_s)
        if self._output is None:
            return ""
        state = self._output.poll()
        if state is OutputState.OPEN:
            return "" if self.is_open else self._note_open()
        if state is OutputState.GONE:
            return self._lose(now_s)
        if state is OutputState.FAILED and not self.problem:
            self.problem = self._output.problem
            return "" if self.was_lost else "no_sound_output"
        return ""

    def _open(self, now_s: float) -> None:
        """Start to open an output."""
        assert self._make is not None
        self.problem, self._opening_s = "", now_s
        self._retry_s = now_s + self._wait_s
        self._wait_s = min(2.0 * self._wait_s, SLOWEST_RETRY_S)
        try:
            self._output = self._make()
        except OSError as problem:
            self.problem = message_of(problem)

    def _note_open(self) -> str:
        happened = "sound_back" if self.was_lost or self.problem else "sound_open"
        self.is_open, self.was_lost, self.problem = True, False, ""
        return happened

    def _lose(self, now_s: float) -> str:
        """Let go of an output that is gone or not heard; another one is opened soon."""
        happened = "sound_lost" if self.is_open else ""
        self.was_lost = self.was_lost or self.is_open
        self.rest()
        self._let_go()
        if now_s > self._opening_s + SLOWEST_RETRY_S:
            self._wait_s, self._retry_s = RETRY_S, now_s
        return happened

    def _let_go(self) -> None:
        self.is_open = False
        self._ring.hold()
        if self._output is not None:
            self._output.close()
            self._output = None

    def _load_when_settled(
        self, now_s: float, request: Callable[[int, float], None]
    ) -> None:
        if now_s > self._settled_s:
            self._settled_s, self._is_joining = 0.0, True
            media_s = self._media.media_s(now_s)
            epoch, speed = self._media.epoch, self._media.speed
            request(self._ring.load(epoch, media_s, speed), media_s)

    def _join_when_ready(self, now_s: float) -> None:
        if self._ring.buffered_s() >= PREBUFFER_S or self._ring.is_complete:
            self._is_joining = False
            self._heard_s = now_s
            self._align_until_s = now_s + ALIGN_S
            self._join(now_s)

    def _align(self, now_s: float) -> None:
        if abs(self._media.error_s) > ALIGN_FROM_S:
            self._join(now_s)

    def _join(self, now_s: float) -> None:
        self._align_s = now_s + ALIGN_AGAIN_S
        self._ring.join(self._media.snapshot(now_s))
