"""The loop of the haptics process: absolute deadlines, skip, never burst."""

import gc
import math
from dataclasses import dataclass, field

from hapticplayer.clock import WaitingClock
from hapticplayer.devices import DelayedDevice, HapticDevice
from hapticplayer.errors import DeviceError, message_of
from hapticplayer.haptics.block import RESTING, LoopBlock
from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.contract import (
    Cause,
    Mode,
    Situation,
    State,
)
from hapticplayer.haptics.follower import TrackFollower
from hapticplayer.haptics.hand import observe
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.haptics.step import step
from hapticplayer.linux import CpuLatencyRequest
from hapticplayer.model.device import ChannelLevel, DeviceReading, Vector

ZERO_TICKS_BEFORE_CLOSING = 5
REST_AFTER_S = 30.0
REST_PERIOD_S = 0.050
"""Unplugging and buttons are noticed within one; what the player says at once."""
REST_TICK_S = 0.2
"""A tick at rest, where the device answers as before."""
_RESTING = (Mode.IDLE, Mode.TRIPPED)


@dataclass
class Loop(TrackFollower):
    """Owner of the device, and of the state from tick to tick.

    `tick` is public so that tests drive it on a virtual clock.
    """

    clock: WaitingClock
    block: LoopBlock
    line: MessageSocket
    device: HapticDevice
    limits: Limits = field(default_factory=Limits)
    centring: Centring = field(default_factory=Centring)
    cpu_latency: CpuLatencyRequest | None = None
    lifeline: Lifeline | None = None

    def __post_init__(self) -> None:
        self.listen()
        self.state = State()
        self.count = 0
        self.reading: DeviceReading | None = None
        self._levels: tuple[ChannelLevel, ...] = ()
        self._notice = ""
        self._needed_s = self.clock.now_s()
        self._woken_s = -math.inf
        self._guard_sleep = Lifeline(self.block.lifeline)

    def run(self) -> None:
        """Tick until the player quits or is gone, then leave zero on the wire.

        At 1 kHz. When there was no force for 30 s and nothing plays, the device is looked
        at with 20 Hz, and a tick comes where it or the player has something new.
        """
        gc.collect()
        gc.freeze()
        gc.disable()  # the loop makes no cycles; a collection costs milliseconds
        clock = self.clock
        deadline_s = clock.now_s() + PERIOD_S
        last_ticks = ZERO_TICKS_BEFORE_CLOSING
        while last_ticks:
            if self.is_resting:
                clock.wait(self.line.poll, deadline_s)
                deadline_s = now_s = clock.now_s()
                if self._is_as_before(now_s):
                    deadline_s += REST_PERIOD_S
                    continue
            else:
                clock.sleep_until(deadline_s)
                now_s = clock.now_s()
            late_s = now_s - deadline_s
            missed = int(late_s / PERIOD_S)
            self.tick(now_s, late_s, missed)
            if self.is_resting:
                deadline_s = now_s + REST_PERIOD_S
            else:
                deadline_s += (missed + 1) * PERIOD_S
            is_owed = getattr(self.device, "is_owed", False)  # an answer to the stop
            if self.state.force_n == ZERO and self.is_over and not is_owed:
                last_ticks -= 1

    def _is_as_before(self, now_s: float) -> bool:
        """Whether a tick at rest would change nothing; asks the device, with zero force."""
        seen, lifeline = self.reading, self.lifeline
        is_due = now_s > self.state.now_s + REST_TICK_S - PERIOD_S
        if is_due or seen is None or self._is_device_gone or self.line.poll.poll(0):
            return False
        if lifeline is not None and lifeline.is_cut():
            return False
        try:
            self.reading = reading = self.device.exchange(ZERO, now_s)
        except DeviceError:
            return False  # the tick meets it, too
        return reading._replace(replied_s=seen.replied_s) == seen

    def tick(self, now_s: float, late_s: float = 0.0, missed: int = 0) -> None:
        """Do one period: receive, decide, exchange, record."""
        self._receive()
        if self._unchecked:
            self._check_track()
        clock_count, heartbeat_s, guard_s = self.block.signs()
        self._read_clock(clock_count)
        if self.is_resting:  # no force can begin, so nobody has to watch
            heartbeat_s = guard_s = now_s
        elif guard_s < self._woken_s:
            self._guard_sleep.end()
            guard_s = -math.inf
        before = self.state
        self.state = state = step(
            Situation(
                now_s,
                self._playback,
                self._track,
                before,
                observe(before.hand, self.reading, self.limits),
                self._supervision(heartbeat_s, guard_s, missed),
                self.limits,
                self.centring,
            )
        )
        self._exchange(state.force_n, now_s)
        if state.mode is not before.mode:
            self._note_mode(state.mode)
        self._record(late_s, missed)
        self.count += 1
        if self._is_needed or state.mode not in _RESTING or self.is_over:
            self._needed_s, self._is_needed = now_s, False
        was_resting = self.is_resting
        self.is_resting = now_s - self._needed_s >= REST_AFTER_S
        if self.is_resting:
            self.block.beat_loop(RESTING)  # the guard has no force to watch over
        elif was_resting:
            self._woken_s = now_s

    def _note_mode(self, mode: Mode) -> None:
        if mode is Mode.TRIPPED and isinstance(self.device, DelayedDevice):
            self.device.forget()
        if self.cpu_latency is not None:
            self.cpu_latency.set_active(is_active=mode not in _RESTING)

    def _exchange(self, force_n: Vector, now_s: float) -> None:
        """Send the command, unless it has become too old meanwhile."""
        age_s = self.clock.now_s() - now_s
        self._is_stale = is_stale = age_s > self.limits.command_age_s
        if is_stale:
            # 20 ms have passed: a ramp that began with them would be over
            force_n = ZERO
            is_acting = self.state.mode not in _RESTING
            if is_acting:
                self.state = self.state._replace(
                    force_n=ZERO, mode=Mode.RAMPING, cause=Cause.COMMAND_STALE
                )
        if self._is_device_gone:
            return
        try:
            self.reading = reading = self.device.exchange(force_n, now_s)
        except DeviceError as problem:
            self._is_device_gone = self._is_needed = True
            self.line.send(MessageKind.LOST, message_of(problem))
            return
        if reading.buttons:
            self._is_needed = True
        if reading.levels is not self._levels:
            self._levels = reading.levels
            self.block.write_levels(reading.levels)
        if reading.notice is not self._notice:
            self._notice = reading.notice
            if reading.notice:
                self.line.send(MessageKind.NOTICE, reading.notice)

    def _record(self, late_s: float, missed: int) -> None:
        state = self.state
        hand = state.hand
        self.block.write_tick(
            self.count,
            state.now_s,
            state.media_s,
            *state.planned_n,
            *state.force_n,
            *hand.position_m,
            *hand.velocity_mps,
            *state.centring_n,
            late_s,
            state.now_s - hand.replied_s,
            math.sqrt(state.heat_n2),
            missed,
            state.mode,
            state.cause,
            hand.buttons,
        )
