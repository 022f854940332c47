"""The guard of a rig: brings it to neutral when the loop cannot.

Run by `haptics.guard`, in a process of its own with a socket of its own.
"""

from hapticplayer.clock import Clock
from hapticplayer.devices.rig.sender import RigSender
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.guard import CHECK_PERIOD_S, LoopProcess
from hapticplayer.haptics.rig.loop import SENT
from hapticplayer.haptics.rig.step import NEUTRAL_S, RAMP_S, TAKE_OVER_S, ramped
from hapticplayer.model.rig import RigMotion


class RigGuard:
    """Checks the loop until it ends; ramps and sends neutral where it does not.

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


def make(clock: Clock, block: LoopBlock, sender: RigSender) -> RigGuard:
    """Return the guard of a rig whose socket is open."""
    sender.open()
    return RigGuard(clock, block, sender)
