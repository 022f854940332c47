"""The loop of a rig's process: as many packets a second as a person chose."""

import gc
import math
from dataclasses import dataclass

from hapticplayer.clock import Clock
from hapticplayer.devices.rig.sender import RigSender
from hapticplayer.errors import DeviceError, message_of
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.follower import TrackFollower
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.haptics.rig.step import RigSetup, RigState, rig_step
from hapticplayer.model.rig import RigMotion

REST_PERIOD_S = 0.020
"""While nothing is sent; the fade that follows begins at neutral anyway."""

SENT, REFUSED = 1, 2
"""Bits of a tick: a packet belongs to it; nobody listens at its destination."""


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
        self._setup = RigSetup(chosen.factors(), 0.5 / chosen.rate_hz)

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
