"""The player: one clip, one clock, one state machine, polled by its front end.

Everything here runs on the thread that calls `poll`, at least every 40 ms: the
window's timer or the headless loop. Decoding, sound and force have threads or a
process of their own. A front end that stops polling stops the heartbeat, and the
force with it.
"""

from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import Message
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.process import HapticsProcess
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.playback.clock import AudioReport, MediaClock
from hapticplayer.playback.clock import Source as ClockSource
from hapticplayer.playback.farewell import Farewells, is_hardware
from hapticplayer.playback.feeders import VideoFeeder
from hapticplayer.playback.haptic_link import HapticLink
from hapticplayer.playback.latency import Latencies, Latency
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.screen import POLL_S, FrameSink, NullSink, Screen
from hapticplayer.playback.snapshot import Measurements, Phase, Snapshot, SyncTraces
from hapticplayer.playback.sound import NO_OUTPUT, AudioFactory, Sound
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import Source

FIRST_SOUND_TIMEOUT_S = 3.0  # a sound server that wakes its device took 1.3 s
AUDIO_LOG_PERIOD_S = 0.04
SLOWEST, FASTEST = 0.5, 4.0  # of `set_speed`
PICTURE_STOPS_S = 0.2
NO_TRACK = ""  # no force; what comes after it fades in
DAMAGED = Message("the clip is damaged: some of its pictures are missing or broken")


class Player:
    """Plays one source at a time.

    Args:
        clock: of the machine.
        sink: where frames go; None for nowhere.
        device: name of the haptic device, or "none".
        audio: makes the sound output, see `SoundKeeper`; None plays without sound.
        scheduling: of the haptics process; None for the best there is.
        haptics: makes the owner of the haptics processes; None for the usual one.
    """

    def __init__(
        self,
        clock: Clock,
        sink: FrameSink | None = None,
        *,
        device: str = NO_DEVICE,
        audio: AudioFactory | None = SoundProcess,
        scheduling: Scheduling | None = None,
        haptics: Callable[..., HapticsProcess] | None = None,
    ) -> None:
        self._source: Source | None = None
        self._phase = Phase.EMPTY
        self._feedback = ""
        self._problem = ""
        self._notices: list[str] = []  # remarks for people, in order
        self._log_problem = ""
        self._end_s = 0.0
        self._loop_s: tuple[float, float] | None = None  # played again and again
        self._clock = clock
        self._screen = Screen(clock, sink or NullSink(), self._note_picture)
        self._scheduling = scheduling
        self._media = MediaClock()
        self._sound = Sound(clock, self._media, audio)
        self._video_feeder: VideoFeeder | None = None
        self._log: PlaybackLog | None = None
        self._make_haptics = haptics or HapticsProcess
        self._link = HapticLink(clock, device, scheduling, make=self._make_haptics)
        self._latencies, self._latency = Latencies(), Latency()
        self._farewells = Farewells()
        self._first_sound_by_s = self._pictured_s = 0.0
        self._logged_audio_s = float("-inf")
        self._led_by = ClockSource.MONOTONIC
        self._is_blind = False
        self._leaving: list[VideoFeeder] = []  # told to end, and not waited for
        self._damaged = 0

    # --- commands -------------------------------------------------------------

    def open(self, source: Source, feedback: str | None = None) -> None:
        """Load a source and show its first picture; it does not play yet."""
        self._unload()
        self._source = source
        self._feedback = feedback or source.feedback
        self._end_s = source.clip.duration_s
        self._link.load(source.tracks)
        self._video_feeder = VideoFeeder(source.clip.path)
        self._sound.open(source.clip.path, has_sound=source.clip.has_audio)
        self._phase = Phase.PAUSED
        self._go_to(0.0)
        self._video_feeder.start()

    def prepare_sound(self) -> None:
        """Open the sound output already: a clip with sound is about to be opened."""
        self._sound.prepare()

    def _unload(self) -> None:
        """Stop playing and forget the source."""
        self._sound.forget()
        if self._video_feeder is not None:
            self._video_feeder.leave()
            self._leaving = [f for f in self._leaving if f.is_alive()]
            self._leaving.append(self._video_feeder)
            self._video_feeder = None
        self._source, self._loop_s = None, None
        self._screen.forget()
        self._phase, self._problem, self._damaged = Phase.EMPTY, "", 0
        self._media.seek(0.0)

    def play(self) -> None:
        """Play from here; from the beginning when the clip has ended."""
        if self._phase is Phase.ENDED:
            self._go_to(0.0)
        if self._phase in (Phase.PAUSED, Phase.ENDED):
            self._phase = Phase.BUFFERING
            self._event("play")

    def pause(self) -> None:
        """Stand still; the force ramps to zero."""
        if self._is_playing:
            self._hold(Phase.PAUSED)
            self._event("pause")

    def toggle(self) -> None:
        """Play or pause."""
        (self.pause if self._is_playing else self.play)()

    def seek(self, media_s: float) -> None:
        """Go to a position and go on as before."""
        if self._source is None:
            return
        was_playing = self._is_playing
        self._go_to(min(max(0.0, media_s), self._source.clip.duration_s))
        self._phase = Phase.BUFFERING if was_playing else Phase.PAUSED
        self._event("seek", to_s=self._media.media_s(self._clock.now_s()))

    def step(self, frames: int) -> None:
        """Stand still one picture farther (+1) or one picture back (-1)."""
        feeder, source = self._video_feeder, self._source
        if feeder is None or source is None:
            return
        self.pause()
        if frames < 0:
            half_s = 0.5 / (source.clip.frame_rate_hz or 30.0)
            frame_s = self._screen.frame_s - half_s
            self.seek(frame_s)
            self._screen.frame_s = max(0.0, frame_s)
        elif (frame := feeder.pop()) is not None:
            self._media.seek(frame.pts_s)
            self._sound.go_to(frame.pts_s)
            self._screen.show_still(frame)

    def set_speed(self, speed: float) -> None:
        """Play faster or slower from here on; the sound keeps its pitch."""
        position_s = self._media_s()
        self._media.speed = min(max(speed, SLOWEST), FASTEST)
        self._event("speed", speed=self._media.speed)
        self.seek(position_s)

    def set_end(self, media_s: float) -> None:
        """Stop the clip at a position; opening a clip resets it to the clip's end."""
        self._end_s = media_s

    def set_loop(self, span_s: tuple[float, float] | None) -> None:
        """Repeat a part of the clip, or nothing."""
        self._loop_s = span_s

    def set_sink(self, sink: FrameSink) -> None:
        """Present the pictures somewhere else, at a standstill the present one too."""
        self._screen.sink = sink
        if not self._is_playing:  # else the next picture comes soon enough
            self.seek(self._media_s())

    def set_volume(self, share: float) -> None:
        """Set the loudness: 0 is silent, 1 as recorded; its cube is the amplitude."""
        self._sound.ring.gain = min(max(share, 0.0), 1.0) ** 3

    def set_latencies(self, latencies: Latencies) -> None:
        """Begin earlier from here on what reaches the person later."""
        self._latencies = latencies
        if self._note_latency():
            self.seek(self._media_s())

    def set_sound_output(self, make: AudioFactory) -> None:
        """Play through another output from here on."""
        self._sound.use(make)
        self.seek(self._media_s())

    def set_feedback(self, name: str) -> None:
        """Change the force track; the force ramps down and fades in again."""
        if self._source is None or name not in self._source.tracks:
            return
        if name != self._feedback:
            self._feedback = name
            self._event("feedback", feedback=name)
            self._media.renew()
            self._sound.ring.follow(self._media.epoch)

    def set_device(
        self, name: str, record: Path | None = None, *, takes_faults: bool = False
    ) -> None:
        """Let go of the device and take another one, recording its ticks if asked.

        Waits for the old one only where both are hardware.
        """
        self._farewells.begin(self._link)
        if is_hardware(name):
            self.wait_released()
        self._link = HapticLink(
            self._clock,
            name,
            self._scheduling,
            record,
            takes_faults=takes_faults,
            make=self._make_haptics,
        )
        if self._source is not None:
            self._link.load(self._source.tracks)
        self._event("device", device=name)
        self._note_latency()

    def wait_ready(self) -> None:
        """Wait for the device.

        Raises:
            DeviceError: with the device's own reason.
            HapticsError: when the haptics process died or said nothing in time.
        """
        self._link.wait_ready()

    def wait_released(self) -> None:
        """Wait until other programs can have the hardware that was let go of."""
        self._farewells.wait(hardware_only=True)

    def stop_force(self) -> None:
        """Take the force away at once and stand still; `rearm` brings it back."""
        self._link.stop_force()
        self._event("stop")
        self.pause()

    def rearm(self) -> None:
        """Let the force come back after a stop."""
        self._link.rearm()
        self._event("rearm")

    def inject(self, fault: str) -> float:
        """Make a fault happen; see `HapticsProcess.inject`."""
        return self._link.inject(fault)

    def restart_meters(self) -> None:
        """Measure the force against picture and sound from here on."""
        self._link.restart_meters()

    def attach_log(self, log: PlaybackLog) -> None:
        """Write everything from now on into a log, until `close`."""
        self._log = log
        self._event("latency", **asdict(self._latency))

    def close(self) -> None:
        """Bring the hand to rest, end all threads and finish the log."""
        self._link.stop_force()  # before anything that takes its time
        self._unload()
        self._sound.close()
        self._link.close()
        self._farewells.wait()
        for feeder in self._leaving:
            feeder.stop()
        self._link.poll(self._log)
        if self._log is not None:
            self._log.close(self.summary())
            self._log_problem = self._log.problem
            self._log = None

    # --- what a front end shows -----------------------------------------------

    def snapshot(self) -> Snapshot:
        """Return the state of clip and device."""
        link, latest = self._link, self._link.history.latest()
        return Snapshot(
            phase=self._phase,
            source=self._source,
            media_s=self._media_s(),
            end_s=self._end_s,
            loop_s=self._loop_s,
            speed=self._media.speed,
            epoch=self._media.epoch,
            feedback=self._feedback,
            clock=self._media.source.value,
            audio=self._sound.output,
            sound_output=self._sound.name,
            reported_latency_s=self._sound.reported_latency_s,
            latency=self._latency,
            device=link.device,
            device_health=link.health,
            device_problem=link.problem,
            takes_faults=link.takes_faults,
            loop_pid=link.pid,
            scheduling=link.scheduling,
            record_problem=link.record_problem,
            mode=Mode(int(latest["mode"])) if latest is not None else Mode.IDLE,
            cause=Cause(int(latest["cause"])) if latest is not None else Cause.NONE,
            tick=latest,
            frames_shown=self._screen.shown,
            frames_dropped=self._screen.dropped,
            frames_damaged=self._damaged,
            problem=self._problem,
            notices=tuple(self._notices),
            log_problem=self._log_problem,
        )

    def measurements(self) -> Measurements:
        """Return lateness and synchronisation so far."""
        return self._link.measurements(self._sound.underrun_s)

    def ticks_since(self, monotonic_s: float) -> NDArray[Any]:
        """Return the ticks after a time, of the last 12 s, oldest first; see `TICK`."""
        return self._link.history.since(monotonic_s)

    def sync_traces(self) -> SyncTraces:
        """Return the last differences between force, picture and sound."""
        return SyncTraces(self._link.video_sync.trace(), self._link.audio_sync.trace())

    def summary(self) -> dict[str, Any]:
        """Return what the log ends with."""
        return {
            **self._link.summary(),
            "frames": {
                "shown": self._screen.shown,
                "dropped": self._screen.dropped,
                "damaged": self._damaged,
            },
            "audio_underrun_s": round(self._sound.underrun_s, 4),
            "clock": self._led_by.value,
        }

    # --- what happens by itself ---------------------------------------------

    @property
    def _is_playing(self) -> bool:
        return self._phase in (Phase.BUFFERING, Phase.STARTING, Phase.PLAYING)

    def _media_s(self) -> float:
        return self._media.media_s(self._clock.now_s())

    def poll(self) -> float:
        """Do what is due and return the monotonic time of the next call, s."""
        now_s = self._clock.now_s()
        if not self._link.poll(self._log):
            self._event("device_lost", problem=self._link.problem)
            self._notices.append(self._link.problem)
        self._notices += self._link.told
        self._link.told.clear()
        self._hear()
        self._media.check(now_s)
        self._advance(now_s)
        next_s = self._present(self._clock.now_s())
        feedback = NO_TRACK if self._has_picture_stopped(now_s) else self._feedback
        clock = self._media.snapshot(self._clock.now_s())
        self._link.publish(clock.ahead(self._latency.device_s), feedback)
        return min(next_s, now_s + POLL_S)

    def _has_picture_stopped(self, now_s: float) -> bool:
        """Whether the decoder does not keep up; nobody shall feel what nobody sees."""
        feeder = self._video_feeder
        is_fed = feeder is None or feeder.is_at_end or feeder.peek() is not None
        if is_fed or self._phase is not Phase.PLAYING:
            self._pictured_s = now_s
        has_stopped = now_s > self._pictured_s + PICTURE_STOPS_S
        if has_stopped is not self._is_blind:
            self._is_blind = has_stopped
            self._event("picture_stopped" if has_stopped else "picture_back")
        return has_stopped

    def _hear(self) -> None:
        """Follow what the sound output reports."""
        for report in self._sound.reports():
            if self._phase is Phase.STARTING and report.epoch == self._media.epoch:
                self._media.start_with(report)
                self._phase = Phase.PLAYING
            elif not self._media.report(report, self._clock.now_s()):
                # too far off to be caught up with: seek to where the sound is
                self._event("resync", to_s=report.media_s)
                self.seek(report.media_s)
                return
            self._note_sound(report)
        if missing_s := self._sound.missing_s():
            self._event("underrun", missing_s=missing_s)

    def _note_sound(self, report: AudioReport) -> None:
        if report.monotonic_s < self._logged_audio_s + AUDIO_LOG_PERIOD_S:
            return
        self._logged_audio_s = report.monotonic_s
        commanded_s = report.monotonic_s - self._latency.device_s
        self._link.audio_sync.event(commanded_s, report.media_s)
        if self._log:
            at = {"monotonic_s": report.monotonic_s, "media_s": report.media_s}
            self._log.line("audio", **at)

    def _advance(self, now_s: float) -> None:
        """Move the state machine on."""
        feeder = self._video_feeder
        if feeder is None:
            return
        self._keep_sound(now_s)
        self._note_damage(feeder)
        if self._phase is Phase.BUFFERING and self._is_ready(feeder, now_s):
            self._start(now_s)
        elif self._phase is Phase.STARTING and now_s > self._first_sound_by_s:
            self._media.start(now_s)
            self._phase = Phase.PLAYING
            self._event("no_sound")
        elif self._phase is Phase.PLAYING:
            if self._media.source is not self._led_by:  # another clock leads now
                self._led_by = self._media.source
                self._event("clock", source=self._led_by.value)
            if self._loop_s is not None and self._media_s() >= self._loop_s[1]:
                self.seek(self._loop_s[0])
            elif self._is_over(feeder, now_s):
                self._hold(Phase.ENDED)
                self._event("end")

    def _note_damage(self, feeder: VideoFeeder) -> None:
        if feeder.damaged > self._damaged:
            if not self._damaged:
                self._notices.append(DAMAGED)
            self._damaged = feeder.damaged
            self._event("damaged_pictures", count=feeder.damaged)
        if feeder.problem is not None and not self._problem:
            self._problem = str(feeder.problem)
            self._event("damaged", problem=self._problem)

    def _is_ready(self, feeder: VideoFeeder, now_s: float) -> bool:
        has_picture = feeder.peek(1) is not None or feeder.is_at_end
        return has_picture and self._sound.is_ready(now_s)

    def _keep_sound(self, now_s: float) -> None:
        """Notice that the output is lost, and use the next one."""
        happened = self._sound.look(now_s, is_playing=self._phase is Phase.PLAYING)
        if happened == "no_sound_output":
            self._event(happened, reason=self._sound.problem)
            self._notices.append(NO_OUTPUT)
        elif happened:
            self._event(happened)
            self._note_latency()
            if happened == "sound_lost":
                self._notices.append(
                    Message("the sound was lost; picture and force go on")
                )
            if self._phase is Phase.STARTING:
                self._phase = Phase.BUFFERING  # what was begun is not heard

    def _note_latency(self) -> bool:
        """Follow outputs that are others now; return whether a latency is another."""
        before = self._latency
        self._latency = self._latencies.of(self._sound.name, self._link.device)
        self._sound.ring.latency_s = self._latency.sound_s
        if self._latency == before:
            return False
        self._event("latency", **asdict(self._latency))
        return True

    def _start(self, now_s: float) -> None:
        if not self._sound.is_open:
            self._media.start(now_s + self._latency.lead_s)
            self._phase = Phase.PLAYING
        else:
            # the clock starts with the first sound: its delay is never assumed
            self._sound.ring.play()
            self._first_sound_by_s = now_s + FIRST_SOUND_TIMEOUT_S
            self._phase = Phase.STARTING

    def _is_over(self, feeder: VideoFeeder, now_s: float) -> bool:
        media_s = self._media.media_s(now_s)
        is_dry = feeder.problem is not None and feeder.peek() is None
        return media_s >= self._end_s or is_dry

    def _hold(self, phase: Phase) -> None:
        """Stand still; the sound that is on its way stays in the ring."""
        now_s = self._clock.now_s()
        self._media.pause(now_s)
        self._sound.hold(self._media.media_s(now_s))
        self._phase = phase

    def _go_to(self, media_s: float) -> None:
        self._media.seek(media_s)
        self._screen.renew()
        if self._video_feeder is not None:
            self._video_feeder.request(self._media.epoch, media_s)
        self._sound.go_to(media_s)

    def _present(self, now_s: float) -> float:
        """Show the picture that is due and return when the next one is, s."""
        feeder = self._video_feeder
        if feeder is None:
            return now_s + POLL_S
        clock = self._media.snapshot(now_s) if self._media.is_running else None
        clock = clock.ahead(self._latency.display_s) if clock else None
        return self._screen.present(now_s, feeder, clock)

    def _note_picture(self, shown_s: float, pts_s: float) -> None:
        seen_s = shown_s + self._latency.display_s
        self._link.video_sync.event(seen_s - self._latency.device_s, pts_s)
        if self._log:
            self._log.line("frame", monotonic_s=seen_s, media_s=pts_s)

    def _event(self, name: str, **fields: Any) -> None:
        if self._log:
            now_s = self._clock.now_s()
            self._log.line("event", name=name, monotonic_s=now_s, **fields)
