"""A gentle test of any device, through all that guards a hand in play.

The same loop, limits, ramps and guard as in play: each part of the device is opened by a
`ForcePlayer`, one after the other.
"""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of
from hapticplayer.errors import HapticPlayerError, Message, message_of
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack, RigTrack
from hapticplayer.model.device import ChannelLevel, Signal
from hapticplayer.playback.faults import NOBODY_LISTENS, OutputFaults
from hapticplayer.playback.forces import ForcePlayer
from hapticplayer.playback.latch import StopLatch
from hapticplayer.rendering.demonstration import DemonstrationStep, demonstration
from hapticplayer.rendering.rig import RigStep, rig_demonstration

GENTLE, GENTLE_VIBRATION = (0.25,), (0.25, 0.5)
"""Strengths, as shares of the largest force."""
HOMING_S = 20.0
"""A device that does not know where its grip is by then has to be set up first."""
_LEAST_TICKS = 100
Step = DemonstrationStep | RigStep
MakePlayer = Callable[[Clock, str, ForceTrack | RigTrack, StopLatch], ForcePlayer]


@dataclass(frozen=True, slots=True)
class DevicePart:
    """What is tested by itself: a whole device, or one of its channels.

    Attributes:
        label: of a channel, "" for a whole device.
        device: its name.
        track, steps: what it does, and when.
    """

    label: str
    device: str
    track: ForceTrack | RigTrack
    steps: tuple[Step, ...]

    @property
    def end_s(self) -> float:
        """How long it takes."""
        return float(self.track.time_s[-1])


def parts_of(name: str, strengths: Sequence[float] = ()) -> tuple[DevicePart, ...]:
    """The steps of a device test, in order."""
    entry = find_device(name)
    record, divide = entry.capabilities, guide_of(entry).parts
    if record.signal is Signal.MOTION:
        return (DevicePart("", name, *rig_demonstration()),)
    gentle = GENTLE if record.axes else GENTLE_VIBRATION
    track, steps = demonstration(record, strengths or gentle)
    parts = divide(entry.settings) if divide else (("", name),)
    return tuple(DevicePart(label, device, track, steps) for label, device in parts)


class DeviceTest:
    """A test that has begun; poll it at 10 Hz or more until `is_over`.

    Attributes:
        part: that is tested now, or was last.
        problem: what is wrong with the device, "" for nothing.
        mode, cause: of its loop, last.
        was_stopped: whether a person has stopped it.
        loudest: of the sound channels that were played, see `Loudest.described`.
        player: what moves the device; None while nothing does.

    Raises:
        DeviceError: for a name or settings that are not allowed.
        HapticsError: when the processes cannot be started.
        UsageError: when the latch is set.
    """

    def __init__(
        self,
        clock: Clock,
        name: str,
        make: MakePlayer = ForcePlayer,
        latch: StopLatch | None = None,
        homing_s: float = HOMING_S,
        strengths: Sequence[float] = (),
    ) -> None:
        self._latch = latch or StopLatch()
        entry = find_device(name)
        self._tells_latency = guide_of(entry).tells_latency
        self._clock, self._make = clock, make
        self._patience_s = entry.patience_s + homing_s
        parts = parts_of(name, strengths)
        self.part, self._next = parts[0], list(parts[1:])
        self._before_s, self.end_s = 0.0, sum(one.end_s for one in parts)
        self.loudest: list[dict[str, Any]] = []
        self.problem: Message | str = ""
        self.mode, self.cause, self.was_stopped = Mode.IDLE, Cause.NONE, False
        self.player: ForcePlayer | None = None
        self._releaser: threading.Thread | None = None
        self._ages_s: list[NDArray[Any]] = []
        self._is_rig, self._faults = entry.takes_motion, OutputFaults()
        self._begin(self.part)

    @property
    def is_over(self) -> bool:
        """Whether all of it is done, and the device can be opened by others."""
        is_released = self._releaser is None or not self._releaser.is_alive()
        return self.player is None and is_released and not self._next

    @property
    def is_acting(self) -> bool:
        """Whether a part is tested, or another one is still to come."""
        return self.player is not None or bool(self._next)

    @property
    def done_s(self) -> float:
        """How much of `end_s` is over."""
        return self._before_s + (self.player.media_s if self.player else 0.0)

    @property
    def step(self) -> Step | None:
        """What is done now, None in between."""
        media_s = self.player.media_s if self.player else -1.0
        steps = (s for s in self.part.steps if s.begin_s <= media_s < s.end_s)
        return next(steps, None)

    @property
    def levels(self) -> tuple[ChannelLevel, ...]:
        """How loud the channels of a sound card are."""
        return self.player.levels if self.player else ()

    @property
    def latency_s(self) -> float | None:
        """Half the median age of the device's answers while it acted.

        A command is on its way there for about half of that. None if it tells nothing.
        """
        ages_s = np.concatenate([np.empty(0), *self._ages_s])
        return 0.5 * float(np.median(ages_s)) if len(ages_s) >= _LEAST_TICKS else None

    def poll(self) -> NDArray[Any]:
        """Advance, and return the ticks since the last call (see TICK)."""
        player = self.player
        if player is None:
            is_released = self._releaser is None or not self._releaser.is_alive()
            if is_released and self._next:
                self._go_on()
            return np.empty(0, TICK)
        ticks = player.poll()
        self.mode, self.cause = player.mode, player.cause
        self._faults.add(ticks, is_wanted=False, is_rig=self._is_rig)
        if self._tells_latency:
            self._ages_s.append(ticks["reply_age_s"][ticks["mode"] == Mode.FOLLOWING])
        is_late = player.media_s <= 0.0 and self._clock.now_s() > self._limit_s
        if is_late:
            self.problem = Message(
                "the device is not homed or not ready; set it up first"
            )
        if player.is_over or is_late:
            self._end()
        return ticks

    def stop(self) -> None:
        """Take the force away at once until a person re-arms; let go of the device."""
        self._latch.stop()
        self.was_stopped = self.was_stopped or self.is_acting
        self._next.clear()
        if self.player is not None:
            self.player.stop()
            self._end()

    def wait(self) -> None:
        """Wait until the device is let go of, after `stop`."""
        if self._releaser is not None:
            self._releaser.join()

    def _begin(self, part: DevicePart) -> None:
        self.player = self._make(self._clock, part.device, part.track, self._latch)
        self._limit_s = self._clock.now_s() + self._patience_s

    def _go_on(self) -> None:
        self.part = self._next.pop(0)
        try:
            self._begin(self.part)
        except HapticPlayerError as problem:
            self.problem = message_of(problem)
            self._next.clear()

    def _end(self) -> None:
        """Let the device come to rest, in a thread of its own."""
        player, self.player = self.player, None
        if player is None:
            return
        self._before_s += player.media_s
        self.loudest += player.loudest.described()
        self.problem = self.problem or player.problem or self._unheard_text()
        is_cut = player.media_s < player.end_s and player.mode is not Mode.TRIPPED
        if is_cut and not (self.problem or self.was_stopped):
            self.problem = Message(
                "the haptics process has ended; test the device again"
            )
        if self.problem or player.mode is Mode.TRIPPED:
            self._next.clear()
        self._releaser = threading.Thread(
            target=self._release, args=(player,), name="device-test"
        )
        self._releaser.start()

    def _unheard_text(self) -> Message | str:
        address = find_device(self.part.device).settings.address
        is_unheard = self._faults.is_unheard
        return Message(NOBODY_LISTENS, address=address) if is_unheard else ""

    def _release(self, player: ForcePlayer) -> None:
        """Close it; a device may report an error with its last stop."""
        player.close()
        self.problem = self.problem or player.notice
