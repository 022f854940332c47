"""One output: a device with its processes, what they are given, and what they do.

Every output reads the same playback clock, ahead by its own latency. Its ticks are read
and compared with frames and sound. What happens to one leaves the others alone.
"""

import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.devices.options import GAIN
from hapticplayer.errors import Message
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import is_near_middle, limits_of
from hapticplayer.haptics.live import LiveForce, ScaledForce
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.linux import Scheduling
from hapticplayer.model import (
    DeviceCapabilities,
    Feedback,
    ForceTrack,
    PlaybackClock,
    RigTrack,
)
from hapticplayer.model.device import Signal
from hapticplayer.playback.faults import NOBODY_LISTENS, OutputFaults
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.log import OutputReporter, Reporter
from hapticplayer.playback.meters import (
    Loudest,
    SyncAlarm,
    SyncMeter,
    TickHistory,
    described,
)
from hapticplayer.playback.snapshot import Measurements, OutputSnapshot, SyncTraces
from hapticplayer.rendering import adapted
from hapticplayer.rendering.force import device_gain

SYNC_LOG_PERIOD_S = 1.0
TICKS_BEFORE_S = 0.02  # of an event: the tick that it falls into, even a late one
COMPARE_PERIOD_S = 0.2  # an alarm looks at half a second
READ_PERIOD_S = 0.05  # plots draw at 30 Hz; more often costs more than it shows
REARM_S = 0.06  # until a loop has followed: it may be at rest, with ticks of 20 ms
_DEAD = (Health.GONE, Health.FAILED)

NO_TRACK = ""  # no force; what comes after it fades in
LIVE = "live"  # in place of a condition: what is measured now
Force = ForceTrack | LiveForce
NO_MOTION = Message(
    "a rig moves only with the realistic feedback of a sequence that has its motion"
)
LENT = Message("in test, or being set up")


class OutputContext(NamedTuple):
    """What all outputs of a player share."""

    clock: Clock
    reporter: Reporter
    latch: StopLatch
    scheduling: Scheduling | None = None
    make: Callable[..., HapticsProcesses] = HapticsProcesses


class Output:
    """A device that plays, for as long as it is in the list.

    A rig waits in neutral until outputs that were released are at rest: they may drive
    the same rig, and packets of both would alternate.

    Attributes:
        name: as it was chosen, with its settings.
        gain: multiplies what it plays; at first that of its settings.
        feedback: a condition of its own, "" for the player's.
        is_muted: whether a person has silenced it.
        is_lent: whether a test or another program has the device meanwhile.
        processes: of the device, or of none while it is lent.
        history: the last ticks.
        faults: what kept it from playing, since the meters were restarted.
        video, audio: how much later the force came than frame and sound.
    """

    def __init__(
        self,
        context: OutputContext,
        name: str,
        before: Sequence["Output"] = (),
        record: Path | None = None,
        *,
        takes_faults: bool = False,
        is_lent: bool = False,
    ) -> None:
        self._context, self._clock, self._latch = context, context.clock, context.latch
        self._reporter = OutputReporter(context.clock, context.reporter, name)
        self.name, self._before = name, before
        self.capabilities: DeviceCapabilities | None = None
        self.gain, self._address = 1.0, ""
        if name != NO_DEVICE:
            entry = find_device(name)
            self.capabilities = entry.capabilities
            self.gain, self._address = entry.settings.gain, entry.settings.address
        self.set_latencies(Latencies())
        self.feedback, self.is_muted, self.is_lent = "", False, is_lent
        self._tracks: Mapping[str, Force] = {}
        self._motion: RigTrack | None = None
        self._names: set[str] = set()
        self._releasing: list[threading.Thread] = []
        if is_lent:
            self._begin(NO_DEVICE)
        else:
            self._begin(name, record=record, takes_faults=takes_faults)

    def _begin(self, device: str, **options: Any) -> None:
        _, _, _, scheduling, make = self._context
        self.processes = make(self._clock, device, scheduling=scheduling, **options)
        if self._latch.is_set:
            self.processes.stop_force()  # the first message that the loop reads
        self.history = TickHistory()
        self.restart_meters()
        self._alarms = {"video": SyncAlarm("video"), "sound": SyncAlarm("sound")}
        self._next_read_s = self._next_compare_s = self._next_sync_s = 0.0
        self._mode, self._mode_s = Mode.IDLE, float("-inf")
        self._is_closed = self._was_ready = self._is_death_known = False
        self._is_wanted = self._was_unheard = False

    @property
    def takes_motion(self) -> bool:
        """Whether it is a rig."""
        return bool(self.capabilities and self.capabilities.signal is Signal.MOTION)

    @property
    def has_grip(self) -> bool:
        """Whether a hand holds it."""
        found = self.capabilities
        return bool(found and found.axes) and not self.takes_motion

    @property
    def is_dead(self) -> bool:
        """Whether it has to be opened again."""
        return self.processes.health in _DEAD

    # --- commands ---------------------------------------------------------------

    def lead(self, *, is_wanted: bool) -> None:
        """Be the one whose position is shown and whose ticks are logged, or not."""
        self._reporter.leads = is_wanted

    def lend(self) -> None:
        """Let go of the device until `take_back`, so that others can have it."""
        if not self.is_lent:
            self.is_lent = True
            self.release()
            self._begin(NO_DEVICE)

    def take_back(self) -> None:
        """Open the device again, with its tracks."""
        if self.is_lent:
            self.is_lent = False
            self._begin(self.name)
            self.load(self._tracks, self._motion)

    def release(self) -> None:
        """Close the device in a thread of its own: the force ramps down meanwhile.

        What its loop has done until now still counts: it may have tripped.
        """
        self._next_read_s = 0.0
        self.poll()
        thread = threading.Thread(target=self.processes.close, name="device-releaser")
        self._releasing = [one for one in self._releasing if one.is_alive()]
        self._releasing.append(thread)
        thread.start()

    @property
    def is_releasing(self) -> bool:
        """Whether the device still comes to rest."""
        return any(thread.is_alive() for thread in self._releasing)

    def wait_released(self) -> None:
        """Wait until others can open the device."""
        for thread in self._releasing:
            thread.join()

    def set_latencies(self, latencies: Latencies) -> None:
        """Take what is known of this device."""
        self.latency_s, self.latency_source = latencies.of_device(self.name)

    def load(self, tracks: Mapping[str, Force], rig: RigTrack | None) -> None:
        """Hand over the signal of each condition in place of those before."""
        self._tracks, self._motion = tracks, rig
        signals: dict[str, Force | RigTrack] = dict(tracks)
        if self.takes_motion:
            signals = {} if rig is None else {Feedback.REALISTIC.value: rig}
        self._names = set(signals)
        if self.is_lent or (found := self.capabilities) is None:
            return
        self.processes.load(
            {name: self._adapted(one, found) for name, one in signals.items()}
        )

    def _adapted(
        self, signal: Force | RigTrack, found: DeviceCapabilities
    ) -> ForceTrack | RigTrack | ScaledForce:
        if isinstance(signal, LiveForce):
            x, y, z = (self.gain * device_gain(found)).tolist()
            return signal.scaled(self.name, (x, y, z))
        return adapted(signal, found, self.gain)

    def replace(self, name: str, track: Force) -> None:
        """Hand over another version of a force; a rig moves as it did."""
        self._tracks, found = {**self._tracks, name: track}, self.capabilities
        is_here = not (self.is_lent or self.takes_motion) and name in self._names
        if found is not None and is_here:
            self.processes.replace(name, self._adapted(track, found))

    def set_gain(self, gain: float) -> None:
        """Multiply what it plays, also while it plays; a rig fades in again."""
        self.gain = GAIN.parse("gain", repr(gain))
        if self.takes_motion:
            self.load(self._tracks, self._motion)
        for name, track in self._tracks.items():
            self.replace(name, track)

    def choose_as(self, before: "Output") -> None:
        """Take over what a person has chosen of it: it is opened again."""
        self.feedback, self.is_muted = before.feedback, before.is_muted
        self.gain = before.gain

    def publish(self, clock: PlaybackClock, feedback: str) -> None:
        """Beat, and publish where the clip is, with the player's condition."""
        self.processes.beat()
        wanted = self._condition(feedback)
        is_on = wanted in self._names and not self.is_muted
        if self.takes_motion and any(one.is_releasing for one in self._before):
            is_on = False
        self._is_wanted = is_on and clock.rate != 0.0
        ahead = clock.ahead(self.latency_s)
        self.processes.publish(ahead, wanted if is_on else NO_TRACK)

    def _condition(self, feedback: str) -> str:
        """Which one it plays while the player has this: its own, of a clip."""
        has_own = self.feedback and feedback not in {NO_TRACK, LIVE}
        return self.feedback if has_own else feedback

    def poll(self) -> None:
        """Read what the loop has done since."""
        health = self.processes.poll()
        is_dead, was_ready = health in _DEAD, self._was_ready
        now_s = self._clock.now_s()
        if health is not Health.NONE and (now_s >= self._next_read_s or is_dead):
            self._read()
            self._next_read_s = now_s + READ_PERIOD_S
        if is_dead and not self._is_closed and not self._is_death_known:
            self._is_death_known = True
            self._reporter.event("device_lost", problem=self.problem)
            self._reporter.notify(self.problem)
        self._was_ready = health is Health.READY
        if (notice := self.processes.notice) and notice != self.faults.notice:
            self._reporter.event("device_notice", problem=notice)
            self._reporter.notify(notice)
        self.faults.notice, self.processes.notice = notice or self.faults.notice, ""
        if (is_dead and was_ready and self.has_grip) or self._has_tripped():
            self._latch.stop()

    def close(self) -> None:
        """Ramp the force to zero, end all processes and read the last ticks."""
        self._is_closed = True
        self.processes.close()
        self.wait_released()
        self._next_read_s = self._next_compare_s = 0.0
        self.poll()

    # --- what it does -----------------------------------------------------------

    def state(self, feedback: str) -> OutputSnapshot:
        """What a front end shows; `feedback` is the player's."""
        processes, tick = self.processes, self.history.latest()
        mode, cause = self.activity()
        feedback = self._condition(feedback) or self.feedback
        return OutputSnapshot(
            self.name,
            processes.health,
            self.problem,
            self._note(feedback),
            feedback,
            self.is_muted,
            self.gain,
            self.latency_s,
            self.latency_source,
            mode,
            cause,
            None if self.takes_motion else tick,
            processes.pids.get("loop"),
            processes.levels,
            processes.takes_faults,
            processes.scheduling,
            processes.record_problem,
            self.faults.sentence,
            self._is_unheard(),
        )

    @property
    def problem(self) -> str:
        """What is wrong with device or processes, "" for nothing."""
        if self.processes.health is Health.GONE and not self._is_closed:
            return Message(
                "the haptics process has ended, so the force is off; "
                "choose the device again"
            )
        return self.processes.problem

    def _note(self, feedback: str) -> Message | str:
        if self.is_lent:
            return LENT
        known = {*self._names, NO_TRACK, Feedback.NONE.value}
        if self.takes_motion and feedback not in known:
            return NO_MOTION
        return self._unheard_text()

    def _unheard_text(self) -> Message | str:
        is_unheard = self._is_unheard()
        return Message(NOBODY_LISTENS, address=self._address) if is_unheard else ""

    def _is_unheard(self) -> bool:
        """Whether nobody listens now, or has listened to most of it."""
        tick = self.history.latest() if self.takes_motion else None
        is_refused = tick is not None and bool(tick["buttons"] & REFUSED)
        return is_refused or self.faults.is_unheard

    def _has_tripped(self) -> bool:
        """Whether the loop has stopped by itself, or does not follow a re-arm.

        A device that is gone has nothing to be re-armed; the others play on.
        """
        mode, cause = self._last()
        if self.processes.health is not Health.READY or mode is not Mode.TRIPPED:
            return False
        rearmed_s = self._latch.rearmed_s
        if cause not in (Cause.STOPPED, Cause.UNPLUGGED) and self._mode_s > rearmed_s:
            return True
        at_s = float(self.history.latest()["monotonic_s"])
        is_stuck = at_s - max(self._mode_s, rearmed_s) > REARM_S
        return is_stuck and cause is not Cause.UNPLUGGED

    def _last(self) -> tuple[Mode, Cause]:
        tick = self.history.latest()
        if tick is None:
            return Mode.IDLE, Cause.NONE
        return Mode(int(tick["mode"])), Cause(int(tick["cause"]))

    def activity(self) -> tuple[Mode, Cause]:
        """What the loop does, and why.

        A stop and a re-arm count from the moment they are asked for; ticks come later.
        """
        mode, cause = self._last()
        is_stopped = self._latch.is_set
        is_as_asked = is_stopped is (mode is Mode.TRIPPED)
        if is_as_asked or self.processes.health in (*_DEAD, Health.NONE):
            return mode, cause
        return (Mode.TRIPPED, Cause.STOPPED) if is_stopped else (Mode.IDLE, Cause.NONE)

    def is_near_middle(self) -> bool:
        """Whether the grip is where force may come back; True where there is none."""
        tick, found = self.history.latest(), self.capabilities
        is_there = self.has_grip and self.processes.health is Health.READY
        if not is_there or found is None or tick is None:
            return True
        return is_near_middle(tick["position_m"].tolist(), limits_of(found))

    # --- what is measured -----------------------------------------------------

    def restart_meters(self) -> None:
        """Measure the force against frames and sound from here on."""
        self.faults = OutputFaults()
        self.video, self.audio = SyncMeter(), SyncMeter()
        self.loudest = Loudest()

    def measurements(self, audio_underrun_s: float) -> Measurements:
        """The figures so far."""
        return Measurements(
            self.history.recent_stats(),
            self.video.recent(),
            self.audio.recent(),
            self.video.total(),
            self.audio.total(),
            self.history.lost,
            audio_underrun_s,
        )

    def traces(self) -> SyncTraces:
        traces = self.video.trace(), self.audio.trace()
        return SyncTraces(*traces, self.video.recent(), self.audio.recent())

    def summary(self) -> dict[str, Any]:
        """The figures of the loop, for the end of a log."""
        loop = self.history.total_stats()
        return {
            "lateness_us": loop
            and {
                name: round(getattr(loop, f"lateness_{name}_us"), 1)
                for name in ("p50", "p99", "p999", "max")
            },
            "ticks": loop.ticks if loop else 0,
            "missed": loop.missed if loop else 0,
            "haptic_minus_video_ms": described(self.video.total()),
            "haptic_minus_audio_ms": described(self.audio.total()),
            "scheduling": self.processes.scheduling,
            "device": self.processes.device,
            "channels": self.loudest.described(),
            "fault": str(
                self.processes.problem or self.faults.sentence or self._unheard_text()
            )
            or None,
        }

    def _read(self) -> None:
        records, lost = self.processes.read_ticks()
        self.history.add(records, lost)
        self.loudest.add(self.processes.levels)
        wanted, is_rig = self._is_wanted, self.takes_motion
        self.faults.add(records, is_wanted=wanted, is_rig=is_rig)
        if (now_s := self._clock.now_s()) >= self._next_compare_s:
            self._next_compare_s = now_s + COMPARE_PERIOD_S
            self._compare("video", self.video)
            self._compare("sound", self.audio)
        if not self.takes_motion:
            self._reporter.ticks(records)
        self._log_sync()
        self._log_modes(records, lost)
        self._log_unheard(records)

    def _compare(self, what: str, meter: SyncMeter) -> None:
        """Measure how much later the force came, and report what can be felt."""
        if not meter.is_waiting:
            return
        alarm = self._alarms[what]
        ticks = self.history.since(meter.oldest_s - TICKS_BEFORE_S)
        if not alarm.add(meter.compare(ticks)):
            return
        if alarm.is_on:
            self._reporter.notify(alarm.sentence())
        name = "sync_alarm" if alarm.is_on else "sync_alarm_over"
        self._reporter.event(name, against=what, p50_ms=round(alarm.p50_ms, 3))

    def _log_sync(self) -> None:
        """Write the recent synchronisation once a second."""
        now_s = self._clock.now_s()
        if now_s < self._next_sync_s:
            return
        self._next_sync_s = now_s + SYNC_LOG_PERIOD_S
        video, audio = self.video.recent(), self.audio.recent()
        if video or audio:
            self._reporter.line(
                "sync",
                monotonic_s=now_s,
                haptic_minus_video_ms=described(video),
                haptic_minus_audio_ms=described(audio),
            )

    def _log_modes(self, records: NDArray[Any], lost: int) -> None:
        if lost:
            self._reporter.event("ticks_lost", count=lost)
        modes = np.concatenate([[self._mode], records["mode"]])
        for row in np.flatnonzero(np.diff(modes.astype(np.int16))):
            mode, cause = Mode(int(modes[row + 1])), Cause(int(records["cause"][row]))
            if self.faults.note_mode(mode, cause):
                self._reporter.notify(self.faults.trip)
            self._reporter.line(
                "event",
                name={Mode.RAMPING: "ramp", Mode.TRIPPED: "trip"}.get(
                    mode, f"force_{mode.name.lower()}"
                ),
                cause=cause.name.lower(),
                monotonic_s=(at_s := float(records["monotonic_s"][row])),
            )
            self._mode_s = at_s
        self._mode = Mode(int(modes[-1]))

    def _log_unheard(self, records: NDArray[Any]) -> None:
        """Log when a rig begins not to be listened to, and when that is over."""
        sent = records["buttons"][records["buttons"] & SENT > 0]
        if not self.takes_motion or not len(sent):
            return
        is_unheard = bool(sent[-1] & REFUSED)
        if is_unheard is not self._was_unheard:
            self._was_unheard = is_unheard
            self._reporter.event("nobody_listens" if is_unheard else "listened_to")
