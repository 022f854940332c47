"""The haptic side of the player: the processes of one device after the other.

Their ticks are read, compared with frames and sound, and logged.
"""

import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.errors import Message
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import is_near_middle, limits_of
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.model import DeviceCapabilities, ForceTrack, SyncStats
from hapticplayer.model.device import Signal
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.meters import Loudest, SyncAlarm, SyncMeter, TickHistory
from hapticplayer.playback.snapshot import Measurements, SyncTraces
from hapticplayer.rendering import adapted

SYNC_LOG_PERIOD_S = 1.0
TICKS_BEFORE_S = 0.02  # of an event: the tick that it falls into, even a late one
COMPARE_PERIOD_S = 0.2  # an alarm looks at half a second
READ_PERIOD_S = 0.05  # plots draw at 30 Hz; more often costs more than it shows
REARM_S = 0.06  # until a loop has followed: it may be at rest, with ticks of 20 ms
_DEAD = (Health.GONE, Health.FAILED)

MakeProcesses = Callable[..., HapticsProcesses]


class ForceOutput:
    """Owns the haptics processes of the chosen device, and measures what they do.

    `history` has the last ticks; `video` and `audio` measure how much later the force
    came than frame and sound.
    """

    def __init__(
        self,
        clock: Clock,
        reporter: Reporter,
        device: str,
        scheduling: Scheduling | None,
        make: MakeProcesses = HapticsProcesses,
        latch: StopLatch | None = None,
    ) -> None:
        self._clock, self._reporter = clock, reporter
        self._scheduling, self._make = scheduling, make
        self._tracks: Mapping[str, ForceTrack] = {}
        self._latch = latch or StopLatch()
        self._releasing: list[tuple[str, threading.Thread]] = []
        self._begin(device)

    def _begin(self, device: str, **options: Any) -> None:
        make, scheduling = self._make, self._scheduling
        self.processes = make(self._clock, device, scheduling=scheduling, **options)
        if self._latch.is_set:
            self.processes.stop_force()  # the first message that the loop reads
        self.history = TickHistory()
        self.restart_meters()
        self._alarms = {"video": SyncAlarm("video"), "sound": SyncAlarm("sound")}
        self._next_read_s = self._next_compare_s = self._next_sync_s = 0.0
        self._mode, self._mode_s = Mode.IDLE, float("-inf")
        self._is_closed = self._was_ready = False

    def use(
        self, device: str, record: Path | None = None, *, takes_faults: bool = False
    ) -> None:
        """Release the device and open another one; see `HapticsProcesses`."""
        self.release()
        if is_hardware(device):
            self.wait_released(hardware_only=True)
        self._begin(device, record=record, takes_faults=takes_faults)
        self.load(self._tracks)

    def release(self) -> None:
        """Close the device in a thread of its own: the force ramps down meanwhile."""
        processes = self.processes
        thread = threading.Thread(target=processes.close, name="device-releaser")
        self._releasing = [row for row in self._releasing if row[1].is_alive()]
        self._releasing.append((processes.device, thread))
        thread.start()

    @property
    def is_releasing(self) -> bool:
        """Whether a former device still comes to rest."""
        return any(thread.is_alive() for _, thread in self._releasing)

    def wait_released(self, *, hardware_only: bool = False) -> None:
        """Wait until all former devices, or all hardware, can be opened by others."""
        for device, thread in self._releasing:
            if not hardware_only or is_hardware(device):
                thread.join()

    def load(self, tracks: Mapping[str, ForceTrack]) -> None:
        """Hand over the tracks of a clip in place of those before."""
        self._tracks = tracks
        if self.processes.device != NO_DEVICE:
            capabilities = find_device(self.processes.device).capabilities
            self.processes.load(
                {name: adapted(track, capabilities) for name, track in tracks.items()}
            )

    def replace(self, name: str, track: ForceTrack) -> None:
        """Hand over another version of one of the tracks, also while it plays."""
        self._tracks = {**self._tracks, name: track}
        if self.processes.device != NO_DEVICE:
            capabilities = find_device(self.processes.device).capabilities
            self.processes.replace(name, adapted(track, capabilities))

    @property
    def problem(self) -> str:
        """What is wrong with device or processes, "" for nothing."""
        if self._is_closed:
            return ""
        if self.processes.health is Health.GONE:
            return Message(
                "the haptics process has ended, so the force is off; "
                "choose the device again"
            )
        return self.processes.problem

    def poll(self) -> None:
        """Read what the loop has done since."""
        before, health = self.processes.health, self.processes.poll()
        is_dead = health in _DEAD
        now_s = self._clock.now_s()
        if health is not Health.NONE and (now_s >= self._next_read_s or is_dead):
            self._read()
            self._next_read_s = now_s + READ_PERIOD_S
        if is_dead and before is not health and not self._is_closed:
            self._reporter.event("device_lost", problem=self.problem)
            self._reporter.notify(self.problem)
        is_lost = is_dead and self._was_ready and self.grip is not None
        self._was_ready = health is Health.READY
        if is_lost or self._has_tripped():
            self._latch.stop()

    @property
    def grip(self) -> DeviceCapabilities | None:
        """The device where a hand holds it."""
        device = self.processes.device
        found = find_device(device).capabilities if device != NO_DEVICE else None
        has_grip = found and found.axes and found.signal is Signal.FORCE
        return found if has_grip else None

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
        if self.processes.health in (*_DEAD, Health.NONE):
            return mode, cause
        if is_stopped is (mode is Mode.TRIPPED):
            return mode, cause
        return (Mode.TRIPPED, Cause.STOPPED) if is_stopped else (Mode.IDLE, Cause.NONE)

    def is_near_middle(self) -> bool:
        """Whether the grip is where force may come back; True where there is none."""
        tick, grip = self.history.latest(), self.grip
        if grip is None or tick is None or self.processes.health is not Health.READY:
            return True
        return is_near_middle(tick["position_m"].tolist(), limits_of(grip))

    def close(self) -> None:
        """Ramp the force to zero, end all processes and read the last ticks."""
        self._is_closed = True
        self.processes.close()
        self.wait_released()
        self._next_read_s = self._next_compare_s = 0.0
        self.poll()

    # --- what is measured -----------------------------------------------------

    def restart_meters(self) -> None:
        """Measure the force against frames and sound from here on."""
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
        """Return the last differences between force, frames and sound."""
        return SyncTraces(self.video.trace(), self.audio.trace())

    def summary(self) -> dict[str, Any]:
        """The loop's figures, for the end of a log."""
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
            "haptic_minus_video_ms": described(self.video.total()),
            "haptic_minus_audio_ms": described(self.audio.total()),
            "scheduling": self.processes.scheduling,
            "device": self.processes.device,
            "channels": self.loudest.described(),
        }

    def _read(self) -> None:
        records, lost = self.processes.read_ticks()
        self.history.add(records, lost)
        self.loudest.add(self.processes.levels)
        if (now_s := self._clock.now_s()) >= self._next_compare_s:
            self._next_compare_s = now_s + COMPARE_PERIOD_S
            self._compare("video", self.video)
            self._compare("sound", self.audio)
        if self._reporter.log is not None:
            self._reporter.log.ticks(records)
            self._log_sync()
        self._log_modes(records, lost)

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
            mode = Mode(int(modes[row + 1]))
            self._reporter.line(
                "event",
                name={Mode.RAMPING: "ramp", Mode.TRIPPED: "trip"}.get(
                    mode, f"force_{mode.name.lower()}"
                ),
                cause=Cause(int(records["cause"][row])).name.lower(),
                monotonic_s=(at_s := float(records["monotonic_s"][row])),
            )
            self._mode_s = at_s
        self._mode = Mode(int(modes[-1]))


def is_hardware(device: str) -> bool:
    """Whether only one process can have the device at a time."""
    return device != NO_DEVICE and not find_device(device).server


def described(stats: SyncStats | None) -> dict[str, float] | None:
    """Return the figures of a difference, ms, for logs and records."""
    if stats is None:
        return None
    figures = {"p05": stats.p05_ms, "p50": stats.p50_ms, "p95": stats.p95_ms}
    rounded = {name: round(value, 3) for name, value in figures.items()}
    return {"count": stats.count, **rounded}
