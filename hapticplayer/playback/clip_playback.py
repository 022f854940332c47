"""Plays one clip after the other: media clock, frames and sound, by the phase table."""

from collections.abc import Callable
from dataclasses import asdict

from hapticplayer.clock import Clock
from hapticplayer.errors import Message
from hapticplayer.model import PlaybackClock
from hapticplayer.model.ranges import SPEED
from hapticplayer.playback.clock import AudioReport, MediaClock
from hapticplayer.playback.latency import Latencies, Latency
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.phases import (
    PLAYING_PHASES,
    Action,
    Phase,
    PhaseEvent,
    transition,
)
from hapticplayer.playback.sound import NO_OUTPUT, AudioFactory, Sound
from hapticplayer.playback.source import Source
from hapticplayer.playback.video_output import FrameSink, VideoOutput

FIRST_SOUND_TIMEOUT_S = 3.0  # a sound server that wakes its device took 1.3 s
FETCHED_S, FETCHED_AGAIN_S = 0.5, 2.0
"""Of a remote clip, before it plays, and before it resumes after it had to wait."""
SLOWEST, FASTEST = SPEED.least, SPEED.largest
DAMAGED = Message("the clip is damaged: some of its frames are missing or broken")


class ClipPlayback:
    """The state machine of a clip; everything on the thread that calls `advance`.

    `presented` is called with the monotonic time of each frame and its own time, s;
    without `audio` it plays without sound.
    """

    def __init__(
        self,
        clock: Clock,
        sink: FrameSink | None,
        audio: AudioFactory | None,
        reporter: Reporter,
        presented: Callable[[float, float], None],
        heard: Callable[[AudioReport], None],
    ) -> None:
        self.phase = Phase.EMPTY
        self.source: Source | None = None
        self.problem = ""  # of the clip
        self.end_s = 0.0
        self.loop_s: tuple[float, float] | None = None
        self.latency, self.outputs_s = Latency(), 0.0  # the largest latency of them
        self.media = MediaClock()
        self.video = VideoOutput(clock, sink, presented)
        self.sound = Sound(clock, self.media, audio)
        self.led_by = self.media.source  # while playing
        self._clock, self._reporter, self._heard = clock, reporter, heard
        self._latencies, self._device = Latencies(), ""
        self._first_sound_by_s = 0.0
        self._damaged = 0
        self.fetched_s = FETCHED_S  # of a remote clip before it plays
        self._actions: dict[Action, Callable[[float], None]] = {
            Action.GO_TO: self._go_to,
            Action.HOLD: self._hold,
            Action.START_SOUND: self._start_sound,
            Action.START_CLOCK: self._start_clock,
            Action.FORGET: self._forget,
        }

    @property
    def is_playing(self) -> bool:
        return self.phase in PLAYING_PHASES

    @property
    def media_s(self) -> float:
        return self.media.media_s(self._clock.now_s())

    def handle(self, event: PhaseEvent, media_s: float = 0.0) -> bool:
        """Do what an event asks for in this phase; False where it is ignored."""
        found = transition(self.phase, event)
        if found is None:
            return False
        self.phase = found.phase
        for action in found.actions:
            self._actions[action](media_s)
        return True

    # --- commands -------------------------------------------------------------

    def open(self, source: Source) -> None:
        """Load a source and show its first frame."""
        self.handle(PhaseEvent.CLOSE)
        self.source, self.end_s = source, source.clip.duration_s
        self.fetched_s = FETCHED_S
        self.video.open(source.clip.content)
        self.sound.open(source.clip)
        self.handle(PhaseEvent.OPEN)

    def close(self) -> None:
        self.handle(PhaseEvent.CLOSE)
        self.sound.close()

    def seek(self, media_s: float) -> None:
        """Go to a position; keep playing if the clip plays."""
        duration_s = self.source.clip.duration_s if self.source else 0.0
        if self.handle(PhaseEvent.SEEK, min(max(0.0, media_s), duration_s)):
            self._reporter.event("seek", to_s=self.media_s)

    def step(self, frames: int) -> None:
        """Pause one frame later (+1) or earlier (-1)."""
        if self.source is None:
            return
        if self.handle(PhaseEvent.PAUSE):
            self._reporter.event("pause")
        if frames < 0:
            half_s = 0.5 / (self.source.clip.frame_rate_hz or 30.0)
            frame_s = self.video.frame_s - half_s
            self.seek(frame_s)
            self.video.frame_s = max(0.0, frame_s)
        elif (shown_s := self.video.show_next()) is not None:
            self.media.seek(shown_s)
            self.sound.go_to(shown_s)

    def set_speed(self, speed: float) -> None:
        """Play faster or slower from here on."""
        position_s = self.media_s
        self.media.speed = min(max(speed, SLOWEST), FASTEST)
        self._reporter.event("speed", speed=self.media.speed)
        self.seek(position_s)

    def set_latencies(self, latencies: Latencies) -> None:
        """Begin earlier from here on what reaches the person later."""
        self._latencies = latencies
        if self._note_latency():
            self.seek(self.media_s)

    def set_device(self, device: str) -> None:
        """Compensate the latency of another leading device."""
        self._device = device
        self._note_latency()

    def set_sound_output(self, make: AudioFactory) -> None:
        """Play through another output from here on."""
        self.sound.use(make)
        self.seek(self.media_s)

    def refresh(self) -> None:
        """Show the present frame again; while playing the next one comes soon enough."""
        self.handle(PhaseEvent.REFRESH, self.media_s)

    def interrupt_force(self) -> None:
        """Begin a new epoch where the clip is: the force fades out and in."""
        self.media.renew()
        self.sound.ring.follow(self.media.epoch)

    def wait_for_bytes(self) -> None:
        """Stop at the last frame until more has come, if a remote clip is late."""
        if not self._is_fetched(0.0):
            self.fetched_s = FETCHED_AGAIN_S
            self.seek(self.video.frame_s)

    @property
    def waiting(self) -> str:
        """Why a remote clip does not play on, "" while it does or is paused by a person."""
        remote = self.source.clip.remote if self.source else None
        if remote is None or self.phase is not Phase.BUFFERING:
            return ""
        return remote.waiting or ""

    # --- actions --------------------------------------------------------------

    def _go_to(self, media_s: float) -> None:
        self.media.seek(media_s)
        self.video.go_to(self.media.epoch, media_s)
        self.sound.go_to(media_s)

    def _hold(self, _media_s: float) -> None:
        now_s = self._clock.now_s()
        self.media.pause(now_s)
        self.sound.hold(self.media.media_s(now_s))

    def _start_sound(self, _media_s: float) -> None:
        # the clock starts with the first sound: its delay is never assumed
        self.sound.ring.play()
        self._first_sound_by_s = self._clock.now_s() + FIRST_SOUND_TIMEOUT_S

    def _start_clock(self, _media_s: float) -> None:
        lead_s = max(self.latency.lead_s, self.outputs_s)
        self.media.start(self._clock.now_s() + lead_s)

    def _forget(self, _media_s: float) -> None:
        self.sound.forget()
        self.video.forget()
        self.source, self.loop_s = None, None
        self.problem, self._damaged = "", 0
        self.media.seek(0.0)

    # --- what happens by itself -------------------------------------------------

    def advance(self, now_s: float) -> float:
        """Do what is due and return the monotonic time of the next frame, s."""
        self._hear()
        self.media.check(now_s)
        if self.source is not None:
            self._watch_sound_output(now_s)
            self._note_damage()
            self._note_progress(now_s)
        now_s = self._clock.now_s()
        clock = self.media.snapshot(now_s) if self.media.is_running else None
        clock = clock.ahead(self.latency.display_s) if clock else None
        return self.video.present(now_s, clock)

    def clock(self) -> PlaybackClock:
        return self.media.snapshot(self._clock.now_s())

    def _note_progress(self, now_s: float) -> None:
        if self.phase is Phase.BUFFERING:
            is_ready = self.video.is_ready and self.sound.is_ready(now_s)
            if is_ready and self._is_fetched(self.fetched_s):
                is_heard = self.sound.is_open
                self.handle(
                    PhaseEvent.BUFFERED if is_heard else PhaseEvent.BUFFERED_SILENT
                )
        elif self.phase is Phase.STARTING:
            if now_s > self._first_sound_by_s and self.handle(PhaseEvent.UNHEARD):
                self._reporter.event("no_sound")
        elif self.phase is Phase.PLAYING:
            if self.media.source is not self.led_by:  # another clock leads now
                self.led_by = self.media.source
                self._reporter.event("clock", source=self.led_by.value)
            media_s = self.media_s
            if self.loop_s is not None and media_s >= self.loop_s[1]:
                self.seek(self.loop_s[0])
            elif media_s >= self.end_s or self.video.is_dry:
                self.handle(PhaseEvent.END)
                self._reporter.event("end")

    def _is_fetched(self, seconds: float) -> bool:
        """Whether so much of a remote clip lies ahead."""
        clip = self.source.clip if self.source else None
        if clip is None or clip.remote is None:
            return True
        return clip.remote.is_ahead(seconds / clip.duration_s)

    def _hear(self) -> None:
        """Follow what the sound output reports."""
        for report in self.sound.reports():
            if self.phase is Phase.STARTING and report.epoch == self.media.epoch:
                self.media.start_with(report)
                self.handle(PhaseEvent.HEARD)
            elif not self.media.report(report, self._clock.now_s()):
                # too far off to be caught up with: seek to where the sound is
                self._reporter.event("resync", to_s=report.media_s)
                self.seek(report.media_s)
                return
            self._heard(report)
        if missing_s := self.sound.missing_s():
            self._reporter.event("underrun", missing_s=missing_s)

    def _note_damage(self) -> None:
        if self.video.damaged > self._damaged:
            if not self._damaged:
                self._reporter.notify(DAMAGED)
            self._damaged = self.video.damaged
            self._reporter.event("damaged_frames", count=self._damaged)
        if self.video.problem and not self.problem:
            self.problem = self.video.problem
            self._reporter.event("damaged", problem=self.problem)

    def _watch_sound_output(self, now_s: float) -> None:
        """Notice that the output is lost, and use the next one."""
        happened = self.sound.watch(now_s, is_playing=self.phase is Phase.PLAYING)
        if happened == "no_sound_output":
            self._reporter.event(happened, reason=self.sound.problem)
            self._reporter.notify(NO_OUTPUT)
        elif happened:
            self._reporter.event(happened)
            self._note_latency()
            if happened == "sound_lost":
                self._reporter.notify(
                    Message("the sound output was lost; video and force continue")
                )
            self.handle(PhaseEvent.OUTPUT_CHANGED)

    def _note_latency(self) -> bool:
        """Follow outputs that have changed; return whether a latency has."""
        before = self.latency
        self.latency = self._latencies.of(self.sound.name, self._device)
        self.sound.ring.latency_s = self.latency.sound_s
        if self.latency == before:
            return False
        self._reporter.event("latency", **asdict(self.latency))
        return True
