"""The sound of one clip after the other: decoder, ring, and an output that is kept open.

Neither PortAudio nor its process says anything when the sound server dies, and opening
again can take seconds. So an output that is not heard is replaced while frames and force
go on, and the new sound joins the running clock, which never jumps for its sake.
"""

from collections import deque
from collections.abc import Callable

from hapticplayer.clock import Clock
from hapticplayer.errors import Message
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.playback.clock import AudioReport, ClockSource, MediaClock
from hapticplayer.playback.feeders import AudioFeeder
from hapticplayer.playback.sound_process import AudioOut, OutputState
from hapticplayer.playback.sound_ring import AudioRing

AudioFactory = Callable[[AudioRing], AudioOut]
AHEAD_REPORTS = 50
NO_OUTPUT = Message("there is no sound output, so the clip plays silently")

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
(by 20 to 60 ms after the restart of a server) jumps to the clock, not the clock to it."""


class Sound:
    """What is heard of a clip; the player says where the clock is.

    An output stays open from clip to clip: opening one costs a process.
    """

    def __init__(
        self, clock: Clock, media: MediaClock, make: AudioFactory | None
    ) -> None:
        self.ring = AudioRing()
        self.feeder: AudioFeeder | None = None
        self._clock, self._media = clock, media
        self._keeper = OutputKeeper(self.ring, media, make)
        self._underruns = 0
        self._ahead_s: deque[float] = deque(maxlen=AHEAD_REPORTS)

    @property
    def underrun_s(self) -> float:
        """Silence in place of sound that was not there in time, so far."""
        return self.ring.underrun_samples / self.ring.rate_hz

    @property
    def is_open(self) -> bool:
        """Whether there is an output that plays."""
        return self.feeder is not None and self._keeper.is_open

    @property
    def name(self) -> str:
        """Name of the output that plays, "" for none."""
        return self._keeper.name if self.feeder else ""

    @property
    def output(self) -> str:
        """Name of the output, "lost" while there is none any more, "" for none."""
        return "lost" if self.feeder and self._keeper.was_lost else self.name

    @property
    def reported_latency_s(self) -> float:
        """How far ahead the output asks for its samples, s; 0 before it is known.

        Each poll comes a little after the callback, so the larger values are right.
        """
        known = sorted(self._ahead_s)
        return known[len(known) * 9 // 10] if len(known) == AHEAD_REPORTS else 0.0

    @property
    def problem(self) -> str:
        """Why there is no output."""
        return self._keeper.problem

    def prepare(self) -> None:
        """Open the output already, while something else is being done."""
        self._keeper.want(self._clock.now_s())

    def rest(self, *, is_wanted: bool) -> None:
        """Close the output, which plays silence while paused, or open it again."""
        if self.feeder is not None and is_wanted:
            self._keeper.close()
        elif self.feeder is not None:
            self.prepare()

    def open(self, clip: ClipInfo) -> None:
        """Take the sound of a clip; `go_to` begins to decode it."""
        self.forget()
        if clip.has_audio and self._keeper.make is not None:
            self.prepare()
            self.feeder = AudioFeeder(clip, self.ring)
        else:
            self._keeper.close()

    def forget(self) -> None:
        """Drop the clip."""
        if self.feeder is not None:
            self.feeder.stop()
            self.feeder = None
        self.ring.hold()
        self._keeper.rest()

    def close(self) -> None:
        """End the decoder and the output."""
        self.forget()
        self._keeper.close()
        self.ring.close()

    def use(self, make: AudioFactory) -> None:
        """Play through another output from here on; the caller seeks then."""
        self._keeper.use(make, self._clock.now_s())

    def go_to(self, media_s: float) -> None:
        """Stop at a position of the clock's new epoch.

        What has been decoded around it is kept, unless it is of another speed.
        """
        self._keeper.rest()
        media, feeder = self._media, self.feeder
        is_decoded = media.speed == self.ring.speed and feeder and feeder.ident
        if is_decoded and self.ring.resume_from(media.epoch, media_s):
            assert feeder is not None
            feeder.hurry()
            return
        generation = self.ring.load(media.epoch, media_s, media.speed)
        if feeder is not None:
            feeder.request(generation, media_s)
            if feeder.ident is None:
                feeder.start()

    def hold(self, media_s: float) -> None:
        """Stop at a position that was just heard; what is on its way is kept."""
        self._keeper.rest()
        if not self.ring.resume_from(self._media.epoch, media_s):
            self.go_to(media_s)

    def is_ready(self, now_s: float) -> bool:
        """Whether the clip may begin, for the sound's part."""
        feeder = self.feeder
        if feeder is None:
            return True
        is_full = self.ring.buffered_s() > PREBUFFER_S or self.ring.is_complete
        return (is_full or feeder.is_at_end) and self._keeper.is_settled(now_s)

    def watch(self, now_s: float, *, is_playing: bool) -> str:
        """Replace a lost output; return what has happened, "" for nothing."""
        if self.feeder is None:
            return ""
        happened = self._keeper.watch(now_s, self.feeder.request, is_playing=is_playing)
        if happened:
            self._ahead_s.clear()  # of another output
        return happened

    def reports(self) -> list[AudioReport]:
        """The sound reports since the last call, oldest first."""
        reports = self.ring.reports()
        if reports:
            handed_s = reports[-1].monotonic_s - self.ring.latency_s
            self._ahead_s.append(handed_s - self._clock.now_s())
        return reports

    def missing_s(self) -> float:
        """Return how much sound came too late since the last call, s."""
        missing = self.ring.underrun_samples - self._underruns
        self._underruns += missing
        return missing / self.ring.rate_hz


class OutputKeeper:
    """Opens an output where one is wanted, and another one where that is lost.

    `make` raises OSError where there is none yet. `was_lost` is whether there is none
    any more, since the last one; `problem` says why.
    """

    def __init__(
        self, ring: AudioRing, media: MediaClock, make: AudioFactory | None
    ) -> None:
        self.is_open = self.was_lost = False
        self.problem = ""
        self.make = make
        self._ring, self._media = ring, media
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
        return self._output.name if self._output and self.is_open else ""

    def want(self, now_s: float) -> None:
        """Open an output unless there is one."""
        if self.make is not None and not self._is_wanted:
            self._is_wanted, self._retry_s, self._wait_s = True, now_s, RETRY_S
            self._open(now_s)

    def use(self, make: AudioFactory, now_s: float) -> None:
        """Play through another output from here on."""
        is_wanted = self._is_wanted
        self.close()
        self.make = make
        if is_wanted:
            self.want(now_s)

    def close(self) -> None:
        """Close the output, and open none any more."""
        self.rest()
        self._is_wanted = self.was_lost = False
        self.problem = ""
        self._release()

    def rest(self) -> None:
        """Join nothing: the sound restarts, after a seek or a pause."""
        self._is_joining, self._align_until_s, self._settled_s = False, 0.0, 0.0

    def is_settled(self, now_s: float) -> bool:
        """Whether there is no use in waiting for an output any longer."""
        is_opening = self._output is not None and not (self.is_open or self.problem)
        return not is_opening or now_s > self._opening_s + OPENING_S

    def watch(
        self,
        now_s: float,
        request: Callable[[int, float], None],
        *,
        is_playing: bool,
    ) -> str:
        """Do what is due, and return what has happened, "" for nothing.

        `request` asks the decoder for sound of a generation from a position, s.
        """
        happened = self._follow_output(now_s)
        is_silent = is_playing and self._media.source is ClockSource.MONOTONIC
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
            if abs(self._media.error_s) > ALIGN_FROM_S:
                self._join(now_s)
        elif now_s > max(self._heard_s + LOST_AFTER_S, self._opening_s + OPENING_S):
            return self._lose(now_s)
        return happened

    def _follow_output(self, now_s: float) -> str:
        """Notice that an output has opened, failed or gone."""
        if self._output is None and self._is_wanted and now_s >= self._retry_s:
            self._open(now_s)
        if self._output is None:
            return ""
        state = self._output.poll()
        if state is OutputState.OPEN and not self.is_open:
            happened = "sound_back" if self.was_lost or self.problem else "sound_open"
            self.is_open, self.was_lost, self.problem = True, False, ""
            return happened
        if state is OutputState.GONE:
            return self._lose(now_s)
        if state is OutputState.FAILED and not self.problem:
            self.problem = self._output.problem
            return "" if self.was_lost else "no_sound_output"
        return ""

    def _open(self, now_s: float) -> None:
        """Start to open an output."""
        assert self.make is not None
        self.problem, self._opening_s = "", now_s
        self._retry_s = now_s + self._wait_s
        self._wait_s = min(2.0 * self._wait_s, SLOWEST_RETRY_S)
        try:
            self._output = self.make(self._ring)
        except OSError as problem:
            self.problem = str(problem)

    def _lose(self, now_s: float) -> str:
        """Close an output that is gone or not heard; another one is opened soon."""
        happened = "sound_lost" if self.is_open else ""
        self.was_lost = self.was_lost or self.is_open
        self.rest()
        self._release()
        if now_s > self._opening_s + SLOWEST_RETRY_S:
            self._wait_s, self._retry_s = RETRY_S, now_s
        return happened

    def _release(self) -> None:
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

    def _join(self, now_s: float) -> None:
        self._align_s = now_s + ALIGN_AGAIN_S
        self._ring.join(self._media.snapshot(now_s))
