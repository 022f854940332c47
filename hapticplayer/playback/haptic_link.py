"""The player's side of the haptics process: tracks, clock, health, records."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.errors import Message, UsageError
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.process import HapticsProcess, Health
from hapticplayer.haptics.residence import Residence
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.model import ForceTrack, PlaybackClock, SyncStats
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.meters import SyncMeter, TickHistory
from hapticplayer.playback.snapshot import Measurements
from hapticplayer.playback.sync_alarm import SyncAlarm
from hapticplayer.rendering import adapted

SYNC_LOG_PERIOD_S = 1.0
TICKS_BEFORE_S = 0.02  # of an event: the tick that it falls into, even a late one
COMPARE_PERIOD_S = 0.2  # an alarm looks at half a second
READ_PERIOD_S = 0.05  # plots draw at 30 Hz; more often costs more than it shows
UNSEEN_PERIOD_S = 0.2  # while nobody looks and the track is followed


class HapticLink:
    """Owns the haptics process and what it says.

    Args:
        clock: of the machine.
        device: name of the device; "none" runs no process at all.
        scheduling: None for the best there is.
        record: a new file for every tick of the loop; None records nothing.
        takes_faults: whether `inject` may be called; for simulated devices only.
        make: starts the processes.

    Raises:
        UsageError: when a real device shall take faults.
        InputError: when the record cannot be created.
    """

    def __init__(
        self,
        clock: Clock,
        device: str,
        scheduling: Scheduling | None = None,
        record: Path | None = None,
        *,
        takes_faults: bool = False,
        make: Callable[..., HapticsProcess] = HapticsProcess,
    ) -> None:
        self.device = device
        self.history = TickHistory()
        self.video_sync = SyncMeter()
        self.audio_sync = SyncMeter()
        self.video_alarm = SyncAlarm("picture")
        self.audio_alarm = SyncAlarm("sound")
        self.told: list[str] = []  # remarks for people, in order
        self._clock = clock
        self._next_read_s = self._next_compare_s = 0.0
        self._next_sync_s = 0.0
        self._is_closed = False
        self._mode = Mode.IDLE
        self._track_ids: dict[str, int] = {}
        self._residence = Residence()
        self._process: HapticsProcess | None = None
        if device != NO_DEVICE:
            self._capabilities = find_device(device).capabilities
            self._process = make(
                clock,
                device,
                scheduling=scheduling,
                record=record,
                takes_faults=takes_faults,
            )

    @property
    def scheduling(self) -> str:
        """The scheduling class of the loop, or "" without a device."""
        return self._process.scheduling.value if self._process else ""

    @property
    def health(self) -> Health:
        """State of the process."""
        return self._process.health if self._process else Health.NONE

    @property
    def problem(self) -> str:
        """What is wrong with device or process, "" when nothing is."""
        if self._process is None or self._is_closed:
            return ""
        if self._process.health is Health.GONE:
            return Message(
                "the haptics process has ended, so there is no force any more"
            )
        return self._process.problem

    @property
    def record_problem(self) -> str:
        """Why the record of the ticks is not complete, "" when nothing is wrong."""
        return self._process.record_problem if self._process else ""

    @property
    def pid(self) -> int | None:
        """Process id of the loop."""
        return self._process.pid if self._process else None

    def wait_ready(self) -> None:
        """Wait for the device; raises DeviceError or HapticsError."""
        if self._process:
            self._process.wait_ready()

    def load(self, tracks: Mapping[str, ForceTrack]) -> None:
        """Hand over the tracks of a clip in place of those before."""
        if self._process:
            for track_id in self._track_ids.values():
                self._process.forget_track(track_id)
            self._track_ids = {
                name: self._process.load_track(adapted(track, self._capabilities))
                for name, track in tracks.items()
            }

    def publish(self, clock: PlaybackClock, feedback: str) -> None:
        """Beat the heart, and say where the media is and what to play."""
        if self._process:
            self._process.beat()
            self._process.publish(clock, self._track_ids.get(feedback, 0))

    def stop_force(self) -> None:
        """Zero at the next tick, latched."""
        if self._process:
            self._process.stop_force()

    def rearm(self) -> None:
        """Let the force come back."""
        if self._process:
            self._process.rearm()

    @property
    def takes_faults(self) -> bool:
        """Whether `inject` may be called."""
        return self._process is not None and self._process.takes_faults

    def inject(self, fault: str) -> float:
        """Make a fault happen; see `HapticsProcess.inject`."""
        if self._process is None:
            raise UsageError("there is no device that could have a fault")
        return self._process.inject(fault)

    def poll(self, log: PlaybackLog | None) -> bool:
        """Read what the process has done since; False when it has just died."""
        if not self._process:
            return True
        before = self._process.health
        health = self._process.poll()
        is_dead = health in (Health.GONE, Health.FAILED)
        now_s = self._clock.now_s()
        if now_s >= self._next_read_s or is_dead:
            self._residence.look()  # a heartbeat must not wait for the disk
            self._read(self._process, log)
            self._next_read_s = now_s + self._pause_s()
        return not is_dead or before is health

    def close(self) -> None:
        """Bring the hand to rest and end the process."""
        if self._process:
            self._is_closed = True
            self._process.close()
            # the last ticks are still to be read
            self._next_read_s = self._next_compare_s = 0.0

    def restart_meters(self) -> None:
        """Measure the force against picture and sound from here on."""
        self.video_sync, self.audio_sync = SyncMeter(), SyncMeter()

    def measurements(self, audio_underrun_s: float) -> Measurements:
        """Return what was measured so far."""
        return Measurements(
            self.history.recent_stats(),
            self.history.total_stats(),
            self.video_sync.recent(),
            self.audio_sync.recent(),
            self.video_sync.total(),
            self.audio_sync.total(),
            self.history.lost,
            audio_underrun_s,
        )

    def summary(self) -> dict[str, Any]:
        """Return what the loop measured, for the end of a log."""
        loop = self.history.total_stats()
        return {
            "lateness_us": {
                "p50": round(loop.lateness_p50_us, 1),
                "p99": round(loop.lateness_p99_us, 1),
                "p999": round(loop.lateness_p999_us, 1),
                "max": round(loop.lateness_max_us, 1),
            }
            if loop
            else None,
            "ticks": loop.ticks if loop else 0,
            "missed": loop.missed if loop else 0,
            "haptic_minus_video_ms": _described(self.video_sync.total()),
            "haptic_minus_audio_ms": _described(self.audio_sync.total()),
            "scheduling": self.scheduling,
            "device": self.device,
        }

    def _read(self, process: HapticsProcess, log: PlaybackLog | None) -> None:
        records, lost = process.read_ticks()
        self.history.add(records, lost)
        if (now_s := self._clock.now_s()) >= self._next_compare_s:
            self._next_compare_s = now_s + COMPARE_PERIOD_S
            self._compare("picture", self.video_sync, self.video_alarm, log)
            self._compare("sound", self.audio_sync, self.audio_alarm, log)
        if log:
            self._log(log, records, lost)
            self._log_sync(log)

    def _pause_s(self) -> float:
        """Return how long the ticks may wait to be read."""
        is_seen, latest = self.history.was_followed(), self.history.latest()
        is_steady = latest is not None and latest["mode"] == Mode.FOLLOWING
        return UNSEEN_PERIOD_S if is_steady and not is_seen else READ_PERIOD_S

    def _compare(
        self, what: str, meter: SyncMeter, alarm: SyncAlarm, log: PlaybackLog | None
    ) -> None:
        """Measure how much later the force came, and tell when that can be felt."""
        if not meter.is_waiting:
            return
        ticks = self.history.read_since(meter.oldest_s - TICKS_BEFORE_S)
        if not alarm.add(meter.compare(ticks)):
            return
        if alarm.is_on:
            self.told.append(alarm.sentence())
        if log:
            log.line(
                "event",
                name="sync_alarm" if alarm.is_on else "sync_alarm_over",
                against=what,
                p50_ms=round(alarm.p50_ms, 3),
                monotonic_s=self._clock.now_s(),
            )

    def _log_sync(self, log: PlaybackLog) -> None:
        """Once a second, write how force, picture and sound lie."""
        now_s = self._clock.now_s()
        if now_s < self._next_sync_s:
            return
        self._next_sync_s = now_s + SYNC_LOG_PERIOD_S
        video, audio = self.video_sync.recent(), self.audio_sync.recent()
        if video or audio:
            log.line(
                "sync",
                monotonic_s=now_s,
                haptic_minus_video_ms=_described(video),
                haptic_minus_audio_ms=_described(audio),
            )

    def _log(self, log: PlaybackLog, records: NDArray[Any], lost: int) -> None:
        log.ticks(records)
        if lost:
            log.line("event", name="ticks_lost", count=lost)
        modes = np.concatenate([[self._mode], records["mode"]])
        for row in np.flatnonzero(np.diff(modes.astype(np.int16))):
            mode = Mode(int(modes[row + 1]))
            log.line(
                "event",
                name={Mode.RAMPING: "ramp", Mode.TRIPPED: "trip"}.get(
                    mode, f"force_{mode.name.lower()}"
                ),
                cause=Cause(int(records["cause"][row])).name.lower(),
                monotonic_s=float(records["monotonic_s"][row]),
            )
        self._mode = Mode(int(modes[-1]))


def _described(stats: SyncStats | None) -> dict[str, float] | None:
    if stats is None:
        return None
    figures = {"p05": stats.p05_ms, "p50": stats.p50_ms, "p95": stats.p95_ms}
    rounded = {name: round(value, 3) for name, value in figures.items()}
    return {"count": stats.count, **rounded}
