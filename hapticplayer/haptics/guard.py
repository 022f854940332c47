"""The guard: a process that takes the force away when the loop cannot.

It watches the loop and writes zero to the device when the loop has died or stands
still. It knows nothing of players, tracks and clips. Run as
`python -m hapticplayer.haptics.guard` by `HapticsProcesses`.
"""

import argparse
import select
import signal
import sys
from collections.abc import Callable

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.contract import GAP_RAMP_S
from hapticplayer.haptics.lifeline import Lifeline, map_lifeline
from hapticplayer.haptics.limiter import PERIOD_S
from hapticplayer.haptics.scheduling import GUARD_PRIORITY, acquire

LOOK_PERIOD_S = 0.019
REPEAT_PERIOD_S = 0.004
"""While the loop stands still, or cannot tell of its end by itself."""
LAST_ZEROS = 5
_JUST_AFTER_S = 0.0001


class LoopProcess:
    """The loop as the kernel sees it.

    Its lifeline tells of its end at once, its descriptor when its memory has been taken
    down, up to 10 ms later for locked memory.

    Args:
        pidfd: the descriptor of the process.
        life: its lifeline.
    """

    def __init__(self, pidfd: int, life: Lifeline) -> None:
        self._pidfd, self._life = pidfd, life

    def has_ended(self, timeout_s: float) -> bool:
        """Wait for its end."""
        rest_s = min(timeout_s, REPEAT_PERIOD_S)
        if self._life.wakes():
            if self._life.wait(timeout_s):
                return True
            rest_s = 0.0
        return bool(select.select([self._pidfd], [], [], rest_s)[0])


class Guard:
    """What the guard does at each look.

    Args:
        clock: of the machine.
        block: shared with the loop.
        silence: writes one zero command; False when there is no device any more.
    """

    def __init__(
        self, clock: Clock, block: LoopBlock, silence: Callable[[], bool]
    ) -> None:
        self._clock, self._block, self._silence = clock, block, silence

    def look(self) -> None:
        """Beat, and write zero if the loop holds its last force for too long.

        The loop itself goes on from zero after such a gap: see the rules TICK_LATE
        and TICK_LOST of the contract.
        """
        now_s = self._clock.now_s()
        self._block.beat_guard(now_s)
        last_s = self._block.last_tick_s()
        if last_s and now_s - last_s > GAP_RAMP_S:
            self._silence()

    def bury(self) -> None:
        """The loop is dead: leave nothing but zero on the wire."""
        for _ in range(LAST_ZEROS):
            if not self._silence():
                return
            self._clock.sleep_until(self._clock.now_s() + PERIOD_S)

    def _pause_s(self) -> float:
        """Return the time to the next look, in the middle between two ticks.

        So that guard and loop do not ask for the same core at the same moment. A loop
        that stands still is looked at as soon as it has done so for too long.
        """
        last_s, now_s = self._block.last_tick_s(), self._clock.now_s()
        overdue_s = last_s + GAP_RAMP_S + _JUST_AFTER_S - now_s
        if overdue_s <= 0.0:
            return REPEAT_PERIOD_S
        to_the_middle_s = (last_s + PERIOD_S / 2 - now_s) % PERIOD_S
        return min(LOOK_PERIOD_S - PERIOD_S + to_the_middle_s, overdue_s)

    def run(self, loop: LoopProcess) -> None:
        """Look until the loop's process has gone, or is going."""
        while not loop.has_ended(self._pause_s()):
            self.look()
        self.bury()


def main(argv: list[str] | None = None) -> int:
    """Watch one loop until its end."""
    parser = argparse.ArgumentParser(prog="hapticplayer.haptics.guard")
    parser.add_argument("--block", type=int, required=True, help="descriptor")
    parser.add_argument("--loop-pidfd", type=int, required=True, help="descriptor")
    parser.add_argument("--lifeline", type=int, help="descriptor; else in the block")
    parser.add_argument("--device", required=True)
    parser.add_argument("--handle", type=int, required=True, help="descriptor")
    options = parser.parse_args(argv)
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    try:
        silence = find_device(options.device).silence(options.handle)
    except DeviceError:
        return 1  # the loop meets the same trouble, and tells
    acquire(priority=GUARD_PRIORITY)
    block = LoopBlock(options.block)
    own = options.lifeline
    life = Lifeline(block.life) if own is None else map_lifeline(own)
    loop = LoopProcess(options.loop_pidfd, life)
    Guard(SystemClock(), block, silence).run(loop)
    return 0


if __name__ == "__main__":
    sys.exit(main())
