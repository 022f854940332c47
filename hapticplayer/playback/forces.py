"""Plays a track without a clip: demonstrations and tests of a device or a rig."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.model import ForceTrack, PlaybackClock, RigTrack
from hapticplayer.model.device import ChannelLevel
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.meters import Loudest
from hapticplayer.rendering import adapted

VALID_S = 0.150
TRACK = "track"


class ForcePlayer:
    """Opens a device and plays one track on it; poll it at 10 Hz or more.

    The media clock is paused until the device is ready and homed; from then on it runs
    to the end of the track, which must have one. A stop sets the latch, and a latch that
    is set stops it.

    Raises:
        UsageError: when the latch is set: the force waits for a person.
        DeviceError: when this version has no driver for the device.
        HapticsError: when the haptics process cannot be started.
    """

    def __init__(
        self,
        clock: Clock,
        device: str,
        track: ForceTrack | RigTrack,
        latch: StopLatch | None = None,
    ) -> None:
        self._latch = latch or StopLatch()
        self._latch.refuse()
        entry = find_device(device)
        self._track = adapted(track, entry.capabilities, entry.settings.gain)
        self._processes = HapticsProcesses(clock, device)
        self.media_s = 0.0
        self.mode, self.cause = Mode.IDLE, Cause.NONE
        self.loudest = Loudest()
        self.end_s = float(track.time_s[-1])
        self._clock = clock
        self._begin_s: float | None = None
        self._epoch = 1
        self._is_loaded = False

    @property
    def health(self) -> Health:
        """State of the haptics processes."""
        return self._processes.health

    @property
    def problem(self) -> str:
        """What is wrong with the device, "" for nothing."""
        return self._processes.problem

    @property
    def notice(self) -> str:
        """What the device has reported, also when it was closed; "" for nothing."""
        return self._processes.notice

    @property
    def pids(self) -> dict[str, int]:
        return self._processes.pids

    @property
    def levels(self) -> tuple[ChannelLevel, ...]:
        """How loud the channels of a sound card are."""
        return self._processes.levels

    def wait_ready(self) -> None:
        """Wait for the device; see `HapticsProcesses.wait_ready`."""
        self._processes.wait_ready()

    @property
    def is_over(self) -> bool:
        """Whether there is nothing more to come."""
        is_dead = self.health in (Health.FAILED, Health.GONE)
        return is_dead or self.media_s >= self.end_s or self.mode is Mode.TRIPPED

    def poll(self) -> NDArray[Any]:
        """Beat, advance, and return the ticks since the last call (see TICK)."""
        processes, now_s = self._processes, self._clock.now_s()
        processes.beat()
        if self._latch.is_set:
            processes.stop_force()
        if processes.poll() is Health.READY:
            if not self._is_loaded:
                self._is_loaded = True
                processes.load({TRACK: self._track})
            self._publish(now_s)
        self.loudest.add(processes.levels)
        ticks, _ = processes.read_ticks()
        if len(ticks):
            self.mode = Mode(int(ticks["mode"][-1]))
            self.cause = Cause(int(ticks["cause"][-1]))
        if self.mode is Mode.TRIPPED and self.cause is not Cause.UNPLUGGED:
            self._latch.stop()
        return ticks

    def stop(self) -> None:
        """Set the force to zero at once, and keep it off until a person re-arms."""
        self._latch.stop()
        self._processes.stop_force()

    def close(self) -> None:
        """Ramp the force to zero and release the device."""
        self._processes.stop_force()
        self._processes.close()

    def _publish(self, now_s: float) -> None:
        if self._begin_s is None and self._is_waiting():
            self._begin_s = now_s
            self._epoch += 1
        begin_s, rate = self._begin_s, 1.0
        if begin_s is None:
            begin_s, rate = now_s, 0.0
        self.media_s = min(self.end_s, now_s - begin_s)
        clock = PlaybackClock(self._epoch, begin_s, 0.0, rate, now_s + VALID_S)
        self._processes.publish(clock, TRACK)

    def _is_waiting(self) -> bool:
        """Whether the loop is ready, and paused."""
        return self.cause is Cause.PAUSED


def moved_along(ticks: NDArray[Any]) -> float:
    """Return how well the grip follows the force: cosine, -1 to 1; 0 if it does not move.

    Between force and displacement from the mean position, over ticks with a force.
    """
    active = ticks[np.linalg.norm(ticks["force_n"], axis=1) > 0.0]
    if not len(active):
        return 0.0
    way = active["position_m"] - active["position_m"].mean(axis=0)
    size = np.linalg.norm(active["force_n"]) * np.linalg.norm(way)
    return float(np.sum(active["force_n"] * way) / size) if size else 0.0
