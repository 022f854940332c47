"""The side of the sound: decoder, ring and output of one clip after the other."""

from collections import deque
from collections.abc import Callable
from functools import partial
from pathlib import Path

from hapticplayer.clock import Clock
from hapticplayer.errors import Message
from hapticplayer.playback.audio import AudioRing
from hapticplayer.playback.clock import AudioReport, MediaClock
from hapticplayer.playback.feeders import AudioFeeder
from hapticplayer.playback.sound_keeper import PREBUFFER_S, SoundKeeper
from hapticplayer.playback.sound_process import AudioOut

AudioFactory = Callable[[AudioRing, Clock], AudioOut]
AHEAD_REPORTS = 50
NO_OUTPUT = Message("there is no sound output, so the clip plays silently")


class Sound:
    """What is heard of a clip; the player says where the clock is.

    An output stays open from clip to clip: opening one costs a process.

    Args:
        clock: of the machine.
        media: the clock of the clip.
        make: opens a sound output; None plays without sound.
    """

    def __init__(
        self, clock: Clock, media: MediaClock, make: AudioFactory | None
    ) -> None:
        self.ring = AudioRing()
        self.feeder: AudioFeeder | None = None
        self._clock, self._media = clock, media
        bound = partial(make, self.ring, clock) if make else None
        self._has_outputs = make is not None
        self._keeper = SoundKeeper(self.ring, media, bound)
        self._underruns = 0
        self._ahead_s: deque[float] = deque(maxlen=AHEAD_REPORTS)

    @property
    def is_wanted(self) -> bool:
        """Whether the clip has sound that shall be heard."""
        return self.feeder is not None

    @property
    def underrun_s(self) -> float:
        """Silence in place of sound that was not there in time, so far."""
        return self.ring.underrun_samples / self.ring.rate_hz

    @property
    def is_open(self) -> bool:
        """Whether there is an output that plays."""
        return self.is_wanted and self._keeper.is_open

    @property
    def name(self) -> str:
        """Name of the output that plays, "" for none."""
        return self._keeper.name if self.is_wanted else ""

    @property
    def output(self) -> str:
        """Name of the output, "lost" while there is none any more, "" for none."""
        if not self.is_wanted:
            return ""
        return "lost" if self._keeper.was_lost else self._keeper.name

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

    def open(self, path: Path, *, has_sound: bool) -> None:
        """Take the sound of a clip; `go_to` begins to decode it."""
        self.forget()
        if has_sound and self._has_outputs:
            self.prepare()
            self.feeder = AudioFeeder(path, self.ring)
        else:
            self._keeper.close()

    def forget(self) -> None:
        """There is no clip any more."""
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
        self._has_outputs = True
        self._keeper.use(partial(make, self.ring, self._clock), self._clock.now_s())

    def go_to(self, media_s: float) -> None:
        """Stand at a position of the clock's new epoch.

        What has been decoded around it is kept, unless it is of another speed.
        """
        self._keeper.rest()
        media, feeder = self._media, self.feeder
        if feeder is not None and feeder.ident is not None and self._resumes(media_s):
            feeder.hurry()
            return
        generation = self.ring.load(media.epoch, media_s, media.speed)
        if feeder is not None:
            feeder.set_speed(media.speed)
            feeder.request(generation, media_s)
            if feeder.ident is None:
                feeder.start()

    def _resumes(self, media_s: float) -> bool:
        """Stand where sound of this speed is here already, if it is."""
        media = self._media
        is_same_speed = media.speed == self.ring.speed
        return is_same_speed and self.ring.resume_from(media.epoch, media_s)

    def hold(self, media_s: float) -> None:
        """Stand at a position that was just heard; what is on its way is kept."""
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

    def look(self, now_s: float, *, is_playing: bool) -> str:
        """Look after the output; return what has happened, "" for nothing."""
        if self.feeder is None:
            return ""
        happened = self._keeper.look(now_s, self.feeder.request, is_playing=is_playing)
        if happened:
            self._ahead_s.clear()  # of another output
        return happened

    def reports(self) -> list[AudioReport]:
        """Return what was heard since the last call, oldest first."""
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
