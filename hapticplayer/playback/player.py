"""The player as front ends have it: a snapshot, measurements, and commands.

Everything here runs on the thread that calls `poll`, at least every 40 ms: the
window's timer or the headless loop. Decoding, sound and force have threads or
processes of their own. A front end that stops polling stops the heartbeat, and the
force with it.
"""

from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import UsageError
from hapticplayer.haptics.live import LiveForce
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.haptics.shared import TICK
from hapticplayer.linux import Scheduling
from hapticplayer.model import ForceTrack, PlaybackClock
from hapticplayer.playback.clip_playback import FASTEST, SLOWEST, ClipPlayback
from hapticplayer.playback.clock import HORIZON_S, AudioReport
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.log import PlaybackLog, Reporter
from hapticplayer.playback.output import LIVE, NO_TRACK, OutputContext
from hapticplayer.playback.outputs import Outputs
from hapticplayer.playback.phases import Phase, PhaseEvent
from hapticplayer.playback.snapshot import Measurements, Snapshot, SyncTraces
from hapticplayer.playback.sound import AudioFactory
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import Source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.playback.video_output import POLL_S, FrameSink

__all__ = ["FASTEST", "SLOWEST", "Player"]

AUDIO_LOG_PERIOD_S = 0.04


class Player:
    """Plays one source at a time.

    Args:
        clock: of the machine.
        sink: where frames go; None for nowhere.
        outputs: names of the devices to play on, the leading one first.
        audio: makes the sound output, see `SoundKeeper`; None plays without sound.
        scheduling: of the haptic loop; None for the best there is.
        haptics: makes the owner of the haptics processes; None for the usual one.
        latch: of the stop, where others open devices, too; None for one of its own.
    """

    def __init__(  # noqa: PLR0913 - tests and benchmarks have two of them
        self,
        clock: Clock,
        sink: FrameSink | None = None,
        *,
        outputs: Sequence[str] = (),
        audio: AudioFactory | None = SoundProcess,
        scheduling: Scheduling | None = None,
        haptics: Callable[..., HapticsProcesses] | None = None,
        latch: StopLatch | None = None,
    ) -> None:
        self._latch = latch or StopLatch()
        self._latch.conditions.append(self._refuse_off_centre)
        self._is_held = self._latch.is_set
        self._clock, self._reporter = clock, Reporter(clock)
        self._feedback, self._log_problem, self._waiting = "", "", ""
        self._clip = ClipPlayback(
            clock, sink, audio, self._reporter, self._note_frame, self._note_sound
        )
        make = haptics or HapticsProcesses
        context = OutputContext(clock, self._reporter, self._latch, scheduling, make)
        self._outputs = Outputs(context)
        self._outputs.use(outputs)
        self._follow_outputs()
        self._logged_audio_s = float("-inf")
        self._first_frame_s: float | None = None
        self._was_stalled = False
        self._verdict: Verdict | None = None
        self._live: LiveForce | None = None

    @property
    def latch(self) -> StopLatch:
        """The stop, for others that open devices."""
        return self._latch

    # --- commands: the clip ---------------------------------------------------

    def open(self, source: Source, feedback: str | None = None) -> None:
        """Load a source and show its first frame; it does not play yet."""
        self._end_source()
        self._clip.open(source)
        self._feedback, self._live = feedback or source.feedback, None
        self._outputs.load(source.tracks, source.motion)

    def prepare_sound(self) -> None:
        """Open the sound output already: a clip with sound is about to be opened."""
        self._clip.sound.prepare()

    def rest(self, *, is_wanted: bool) -> None:
        """Nobody is here and nothing plays, or somebody is back; playing ends it, too."""
        if not (is_wanted and self._clip.is_playing):
            self._clip.sound.rest(is_wanted=is_wanted)

    def play(self) -> None:
        """Play from here; from the beginning when the clip has ended."""
        self._clip.sound.rest(is_wanted=False)
        if self._clip.handle(PhaseEvent.PLAY):
            self._reporter.event("play")

    def pause(self) -> None:
        """Pause; the force ramps to zero."""
        if self._clip.handle(PhaseEvent.PAUSE):
            self._reporter.event("pause")

    def toggle(self) -> None:
        (self.pause if self._clip.is_playing else self.play)()

    def seek(self, media_s: float) -> None:
        """Go to a position; keep playing if the clip plays."""
        self._clip.seek(media_s)

    def step(self, frames: int) -> None:
        """Pause one frame later (+1) or earlier (-1)."""
        self._clip.step(frames)

    def set_speed(self, speed: float) -> None:
        """Play faster or slower from here on; the sound keeps its pitch."""
        self._clip.set_speed(speed)

    def set_end(self, media_s: float) -> None:
        """Stop the clip at a position; opening a clip resets it to the clip's end."""
        self._clip.end_s = media_s

    def set_loop(self, span_s: tuple[float, float] | None) -> None:
        """Repeat a part of the clip, or nothing."""
        self._clip.loop_s = span_s

    def feel(self, force: LiveForce | None) -> None:
        """Play what is measured now in place of the clip, or the clip again.

        The force fades in; the clip is paused, and playing it shows frames only.
        """
        self.pause()
        self._clip.interrupt_force()
        self._live, source = force, self._clip.source
        if force is not None:
            self._outputs.load({LIVE: force}, None)
        else:
            self._outputs.load(
                *((source.tracks, source.motion) if source else ({}, None))
            )
        self._reporter.event("feel" if force else "feel_end")

    # --- commands: outputs ----------------------------------------------------

    def set_sink(self, sink: FrameSink) -> None:
        """Show the frames somewhere else; while paused the present one, too."""
        self._clip.video.sink = sink
        self._clip.refresh()

    def set_volume(self, share: float) -> None:
        """Set the loudness: 0 is silent, 1 as recorded; its cube is the amplitude."""
        self._clip.sound.ring.gain = min(max(share, 0.0), 1.0) ** 3

    def set_sound_output(self, make: AudioFactory) -> None:
        self._clip.set_sound_output(make)

    def set_latencies(self, latencies: Latencies) -> None:
        """Begin earlier from here on what reaches the person later."""
        self._outputs.set_latencies(latencies)
        self._clip.outputs_s = self._outputs.lead_s
        self._clip.set_latencies(latencies)

    def _follow_outputs(self) -> None:
        self._clip.outputs_s = self._outputs.lead_s
        self._clip.set_device(self._outputs.leading.name)

    # --- commands: the force --------------------------------------------------

    def set_feedback(self, name: str) -> None:
        """Change the force track; the force ramps down and fades in again."""
        source = self._clip.source
        if source is None or name not in source.tracks or name == self._feedback:
            return
        self._feedback = name
        self._reporter.event("feedback", feedback=name)
        self._clip.interrupt_force()

    def replace_track(self, name: str, track: ForceTrack) -> None:
        """Put an edited version in the place of a force track, also while it plays.

        The force changes over without a pause, by 0.05 N a millisecond at most beyond
        what both versions do. The source of the snapshot has the new one from here on.
        A name that the clip has no track of changes nothing.
        """
        source = self._clip.source
        if source is None or name not in source.tracks:
            return
        tracks = {**source.tracks, name: track}
        self._clip.source = replace(source, tracks=tracks)
        self._outputs.replace(name, track)
        self._reporter.event("track_replaced", feedback=name)

    def set_outputs(
        self,
        names: Sequence[str],
        record: Path | None = None,
        *,
        takes_faults: bool = False,
    ) -> None:
        """Play on these devices, in this order, and on no others; see `Outputs.use`.

        Names are those of `devices`, with their settings. The first one leads: its
        position is shown, its buttons count, its ticks are recorded and take faults.
        """
        try:
            self._outputs.use(names, record, takes_faults=takes_faults)
        finally:
            self._follow_outputs()
            self._reporter.event("outputs", outputs=self.output_names)

    @property
    def output_names(self) -> list[str]:
        return [one.name for one in self._outputs if one.name != NO_DEVICE]

    def set_output(
        self,
        name: str,
        *,
        feedback: str | None = None,
        is_muted: bool | None = None,
        gain: float | None = None,
    ) -> None:
        """Give an output a condition of its own ("" for the player's), mute or gain.

        None keeps what is.

        Raises:
            UsageError: for a gain that is not from 0 to 4.
        """
        output = self._outputs[name]
        if feedback is not None:
            output.feedback = feedback
        if is_muted is not None:
            output.is_muted = is_muted
        if gain is not None:
            output.set_gain(gain)
        now = {"feedback": output.feedback, "muted": output.is_muted}
        now = {**now, "gain": output.gain}
        self._reporter.event("output", output=name, **now)

    def lend_outputs(self, name: str = "") -> None:
        """Let go of one device or of all, for a test or others; see `Outputs.lend`."""
        self._outputs.lend(name)
        self._reporter.event("outputs_lent")

    def take_back_outputs(self, name: str = "") -> None:
        """Play again on what was lent; see `Outputs.take_back`."""
        self._reporter.event("outputs_taken_back")
        self._outputs.take_back(name)

    @property
    def are_outputs_free(self) -> bool:
        """Whether what was lent or released is at rest, so that others can open it."""
        return self._outputs.are_free

    def wait_ready(self) -> None:
        """Wait for the outputs; see `HapticsProcesses.wait_ready`."""
        self._outputs.wait_ready()

    def wait_released(self) -> None:
        """Wait until other programs can open the hardware that was released."""
        self._outputs.wait_released(hardware_only=True)

    def stop_force(self) -> None:
        """Set the force to zero at once and pause; only `rearm` brings it back."""
        self._latch.stop()
        self._stop_all()
        self._reporter.event("stop")
        self.pause()

    def _stop_all(self) -> None:
        self._is_held = True
        self._outputs.stop()

    def rearm(self) -> None:
        """Let the force fade in again after a stop: a person asks for it.

        Raises:
            UsageError: when a grip is not near the middle; the force stays off.
        """
        self._latch.rearm(self._clock.now_s())
        self._outputs.rearm()
        self._is_held = False
        self._reporter.event("rearm")

    def _refuse_off_centre(self) -> None:
        if not all(one.is_near_middle() for one in self._outputs):
            raise UsageError("move the grip to the centre first, then re-arm again")

    def _follow_latch(self) -> None:
        """Stop, or let the force come back, where another owner of the latch did."""
        if self._latch.is_set and not self._is_held:
            self._stop_all()
        elif self._is_held and not self._latch.is_set:
            self._outputs.rearm()
        self._is_held = self._latch.is_set

    def inject(self, fault: str) -> float:
        """Make a fault happen; see `HapticsProcesses.inject`."""
        return self._outputs.leading.processes.inject(fault)

    # --- commands: the log, the end --------------------------------------------

    def attach_log(self, log: PlaybackLog) -> None:
        """Write everything from now on into a log, until `close`."""
        self._reporter.log = log
        self._reporter.event("latency", **asdict(self._clip.latency))

    @property
    def media_clock(self) -> PlaybackClock:
        """Media time as a line over the monotonic clock, as it is now."""
        return self._clip.clock()

    @property
    def first_frame_s(self) -> float | None:
        """When media time 0 was on the screen, monotonic; None before a frame."""
        return self._first_frame_s

    def restart_meters(self) -> None:
        """Measure the force against frames and sound from here on.

        `first_frame_s` becomes the monotonic time at which media time 0 was on the
        screen, by the next frame that is shown.
        """
        self._first_frame_s = None
        for one in self._outputs:
            one.restart_meters()

    def close(self) -> None:
        """Ramp the force to zero, end all threads and finish the log."""
        self._stop_all()  # before anything that takes its time
        if self._refuse_off_centre in self._latch.conditions:
            self._latch.conditions.remove(self._refuse_off_centre)
        self._end_source()
        self._clip.close()
        self._outputs.close()
        self._clip.video.close()
        if (log := self._reporter.log) is not None:
            self._reporter.log = None
            log.close(self.summary())
            self._log_problem = log.problem

    # --- what a front end shows -----------------------------------------------

    def snapshot(self) -> Snapshot:
        """Return the state of clip and device."""
        clip = self._clip
        return Snapshot(
            phase=clip.phase,
            source=clip.source,
            media_s=clip.media_s,
            end_s=clip.end_s,
            loop_s=clip.loop_s,
            speed=clip.media.speed,
            epoch=clip.media.epoch,
            feedback=self._feedback,
            clock=clip.media.source.value,
            audio=clip.sound.output,
            sound_output=clip.sound.name,
            reported_latency_s=clip.sound.reported_latency_s,
            latency=clip.latency,
            is_stopped=self._latch.is_set,
            frames_shown=clip.video.shown,
            frames_dropped=clip.video.dropped,
            frames_damaged=clip.video.damaged,
            problem=clip.problem or clip.waiting,
            notices=tuple(self._reporter.notices),
            log_problem=self._log_problem,
            outputs=self._outputs.states(LIVE if self._live else self._feedback),
        )

    def measurements(self) -> Measurements:
        """Return lateness and synchronisation so far."""
        return self._outputs.leading.measurements(self._clip.sound.underrun_s)

    def ticks_since(self, monotonic_s: float) -> NDArray[Any]:
        """The leading output's ticks of the last 12 s after a time, oldest first.

        See `TICK`; none of a rig, whose ticks hold its motion.
        """
        leading = self._outputs.leading
        if leading.takes_motion:
            return np.empty(0, TICK)
        return leading.history.since(monotonic_s)

    def sync_traces(self) -> SyncTraces:
        """Return the last differences between force, frames and sound."""
        return self._outputs.leading.traces()

    def summary(self) -> dict[str, Any]:
        """The summary at the end of the log."""
        video = self._clip.video
        return {
            **self._outputs.leading.summary(),
            "outputs": self._outputs.summary(),
            "frames": {
                "shown": video.shown,
                "dropped": video.dropped,
                "damaged": video.damaged,
            },
            "audio_underrun_s": round(self._clip.sound.underrun_s, 4),
            "clock": self._clip.led_by.value,
        }

    # --- what happens by itself -----------------------------------------------

    def poll(self) -> float:
        """Do what is due and return the monotonic time of the next call, s."""
        now_s = self._clock.now_s()
        for one in self._outputs:
            one.poll()
        self._follow_latch()
        next_s = self._clip.advance(now_s)
        self._note_waiting()
        self._publish(now_s)
        return min(next_s, now_s + POLL_S)

    def _publish(self, now_s: float) -> None:
        clock, track = self._clip.clock(), self._feedback
        has_no_force = self._has_stalled(now_s) or self._is_withheld()
        if self._live is not None:  # its media clock is the machine's
            epoch = self._clip.media.epoch
            rate = float(self._live.has_begun)
            clock = PlaybackClock(epoch, 0.0, 0.0, rate, now_s + HORIZON_S)
            track, has_no_force = LIVE, False
        has_no_force = has_no_force or self._latch.is_set
        self._outputs.publish(clock, NO_TRACK if has_no_force else track)

    def _has_stalled(self, now_s: float) -> bool:
        """Whether the decoder does not keep up: no force without its frame."""
        is_playing = self._clip.phase is Phase.PLAYING
        has_stalled = self._clip.video.has_stalled(now_s, is_playing=is_playing)
        if has_stalled is not self._was_stalled:
            self._was_stalled = has_stalled
            self._reporter.event("video_stalled" if has_stalled else "video_resumed")
            if has_stalled:
                self._clip.wait_for_bytes()
        return has_stalled

    def _note_waiting(self) -> None:
        """Report why a remote clip does not play on."""
        if (why := self._clip.waiting) != self._waiting:
            self._waiting = why
            if why:
                self._reporter.event("waiting", reason=why)
                self._reporter.notify(why)

    def _is_withheld(self) -> bool:
        """Whether the video is not known to be the one that the force was made for."""
        source = self._clip.source
        if source is None or source.check is None:
            return False
        verdict = source.check.verdict
        if verdict is not self._verdict:
            self._verdict = verdict
            self._reporter.event("video_check", verdict=verdict.name.lower())
            if verdict is Verdict.ANOTHER:
                self._reporter.notify(source.check.notice)
        own = source.description.feedbacks if source.description else {}
        return self._feedback in own and not source.check.allows_force

    def _end_source(self) -> None:
        """Stop reading what is not played any more."""
        if (source := self._clip.source) and source.check:
            source.check.close()
        if source and source.clip.remote:
            source.clip.remote.close()

    def _note_frame(self, shown_s: float, frame_s: float) -> None:
        seen_s = shown_s + self._clip.latency.display_s
        if self._first_frame_s is None:
            self._first_frame_s = seen_s - frame_s
        self._outputs.note_frame(seen_s, frame_s)
        self._reporter.line("frame", monotonic_s=seen_s, media_s=frame_s)

    def _note_sound(self, report: AudioReport) -> None:
        if report.monotonic_s < self._logged_audio_s + AUDIO_LOG_PERIOD_S:
            return
        self._logged_audio_s = report.monotonic_s
        self._outputs.note_sound(report.monotonic_s, report.media_s)
        at = {"monotonic_s": report.monotonic_s, "media_s": report.media_s}
        self._reporter.line("audio", **at)
