"""The loop of a rig's process, as many packets a second as a person chose, and its guard."""

import gc
import math
from dataclasses import dataclass

from hapticplayer.clock import Clock
from hapticplayer.errors import DeviceError, message_of
from hapticplayer.extras.rigs.sender import RigSender
from hapticplayer.extras.rigs.step import (
    NEUTRAL_S,
    RAMP_S,
    TAKE_OVER_S,
    RigSetup,
    RigState,
    ramped,
    rig_step,
)
from hapticplayer.haptics.block import REFUSED, SENT, LoopBlock
from hapticplayer.haptics.follower import TrackFollower
from hapticplayer.haptics.guard import CHECK_PERIOD_S, LoopProcess
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.model.rig import RigMotion

REST_PERIOD_S = 0.020
"""While nothing is sent; the fade that follows begins at neutral anyway."""


@dataclass
class RigLoop(TrackFollower):
    """Owner of a rig's socket, and of the state from packet to packet.

    `tick` is public so that tests drive it on a virtual clock.
    """

    clock: Clock
    block: LoopBlock
    line: MessageSocket
    sender: RigSender
    lifeline: Lifeline | None = None

    columns = len(RigMotion._fields)

    def __post_init__(self) -> None:
        self.listen()
        self.rig = RigState()
        self.count = 0
        chosen = self.sender.settings
        self._setup = RigSetup(chosen.signs(), 0.5 / chosen.rate_hz)

    @staticmethod
    def guard(clock: Clock, block: LoopBlock, sender: RigSender) -> "RigGuard":
        sender.open()
        return RigGuard(clock, block, sender)

    @property
    def period_s(self) -> float:
        """Time from this tick to the next."""
        if self.rig.is_sending:
            return 1.0 / self.sender.settings.rate_hz
        return REST_PERIOD_S

    def run(self) -> None:
        """Tick until the player quits or is gone, and the rig has come to rest.

        Ticks lie on multiples of their period, so that several rigs act at once.
        """
        gc.collect()
        gc.freeze()
        gc.disable()
        clock = self.clock
        deadline_s = REST_PERIOD_S * math.ceil(clock.now_s() / REST_PERIOD_S)
        while True:
            clock.sleep_until(deadline_s)
            now_s = clock.now_s()
            period_s, late_s = self.period_s, now_s - deadline_s
            missed = int(late_s / period_s)
            self.tick(now_s, late_s, missed)
            if self.is_over and not self.rig.is_sending:
                return
            deadline_s += missed * period_s + self.period_s

    def tick(self, now_s: float, late_s: float = 0.0, missed: int = 0) -> None:
        """Do one period: receive, decide, send, record."""
        self._receive()
        if self._unchecked:
            self._check_track()
        clock_count, heartbeat_s, guard_s = self.block.signs()
        self._read_clock(clock_count)
        self.rig = rig = rig_step(
            now_s,
            self._playback,
            self._track,
            self.rig,
            self._supervision(heartbeat_s, guard_s, missed),
            self._setup,
        )
        is_heard = self._send(rig) if rig.is_sending else True
        self.block.write_tick(
            self.count,
            now_s,
            rig.state.media_s,
            *rig.motion,
            late_s,
            rig.packet_s,
            now_s - rig.changed_s,
            missed,
            rig.state.mode,
            rig.state.cause,
            SENT * rig.is_sending | REFUSED * (not is_heard),
        )
        self.count += 1

    def _send(self, rig: RigState) -> bool:
        """Send a packet; return whether a receiver listens."""
        try:
            is_heard = self.sender.send(rig.motion, rig.packet_s)
        except DeviceError as problem:
            if not self._is_device_gone:
                self.line.send(MessageKind.LOST, message_of(problem))
            self._is_device_gone = True
            return False
        return is_heard


class RigGuard:
    """Checks the loop until it ends; ramps and sends neutral where it does not.

    It runs in a process of its own with a socket of its own.

    After a silence that was long enough for that the loop itself begins at the same
    place of the same ramp, see `rig.step`.
    """

    def __init__(self, clock: Clock, block: LoopBlock, sender: RigSender) -> None:
        self._clock, self._block, self._sender = clock, block, sender
        self._period_s = 1.0 / sender.settings.rate_hz

    def check(self) -> bool:
        """Beat, and send if the loop has been silent; return whether it is still sending."""
        now_s = self._clock.now_s()
        self._block.beat_guard(now_s)
        if now_s - self._block.last_tick_s() <= TAKE_OVER_S:
            return False
        return self._send(now_s, TAKE_OVER_S)

    def finish(self) -> None:
        """Ramp to neutral after the end of the loop, if it has not come to it."""
        began_s = self._clock.now_s()
        after_s = min(TAKE_OVER_S, max(0.0, began_s - self._block.last_tick_s()))
        while self._send(self._clock.now_s(), after_s):
            self._clock.sleep_until(self._clock.now_s() + self._period_s)

    def run(self, loop: LoopProcess) -> None:
        """Check until the loop's process has ended, or begins to."""
        pause_s = CHECK_PERIOD_S
        while not loop.has_ended(pause_s):
            pause_s = self._period_s if self.check() else CHECK_PERIOD_S
        self.finish()

    def _send(self, now_s: float, after_s: float) -> bool:
        """Send the packet of now of a ramp that began so long after the last tick."""
        tick = self._block.last_tick()
        if tick is None or not tick[-1] & SENT:
            return False
        last_s, motion, packet_s = tick[0], RigMotion(*tick[2:17]), tick[18]
        age_s = now_s - last_s - after_s
        if age_s >= RAMP_S + NEUTRAL_S:
            return False
        try:
            self._sender.send(ramped(motion, age_s), packet_s + now_s - last_s)
        except DeviceError:  # reported by the loop; the network may come back
            return True
        return True
