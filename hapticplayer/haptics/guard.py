"""The guard: a process that sends zero force when the loop cannot.

It watches the loop and writes zero to the device when the loop has ended or stalls. It
knows nothing of players, tracks and clips. Run as `python -m hapticplayer.haptics.guard`
by `HapticsProcesses`.
"""

import argparse
import select
import sys
from collections.abc import Callable
from typing import Any

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices import DeviceEntry, find_device
from hapticplayer.errors import DeviceError
from hapticplayer.extension import load
from hapticplayer.haptics.block import RESTING, LoopBlock
from hapticplayer.haptics.contract import GAP_RAMP_S
from hapticplayer.haptics.lifeline import Lifeline, map_lifeline, outlive_the_player
from hapticplayer.haptics.limiter import PERIOD_S
from hapticplayer.linux import GUARD_PRIORITY, acquire

CHECK_PERIOD_S = 0.019
REPEAT_PERIOD_S = 0.004
"""While the loop stalls, or without a lifeline that reports its end."""
REST_PERIOD_S = 1.0
"""At rest, which the loop ends before it gives a force."""
FINAL_ZEROS = 5
_JUST_AFTER_S = 0.0001


class LoopProcess:
    """The loop as the kernel sees it.

    Its lifeline reports its end at once; the pipe `end`, which only it holds open, when
    its memory has been torn down: up to 10 ms later for locked memory.
    """

    def __init__(self, end: int, lifeline: Lifeline) -> None:
        self._end, self._lifeline = end, lifeline

    def has_ended(self, timeout_s: float) -> bool:
        """Wait for its end."""
        if not self._lifeline.wakes():
            timeout_s = min(timeout_s, REPEAT_PERIOD_S)
        elif self._lifeline.wait(timeout_s):
            return True
        else:
            timeout_s = 0.0
        return bool(select.select([self._end], [], [], timeout_s)[0])


class Guard:
    """Checks the loop until it ends; `send_zero` is False when the device is gone.

    `watches_stalls` is whether zero is written also while the loop stands still.
    """

    def __init__(
        self,
        clock: Clock,
        block: LoopBlock,
        send_zero: Callable[[], bool],
        *,
        watches_stalls: bool = True,
    ) -> None:
        self._clock, self._block, self._send_zero = clock, block, send_zero
        self._watches_stalls = watches_stalls

    def check(self) -> None:
        """Beat, and write zero if the loop has held its last force for too long.

        After such a gap the loop itself continues from zero: see the rules TICK_LATE
        and TICK_LOST of the contract.
        """
        now_s = self._clock.now_s()
        self._block.beat_guard(now_s)
        last_s = self._block.last_tick_s()
        if self._watches_stalls and last_s > 0.0 and now_s - last_s > GAP_RAMP_S:
            self._send_zero()

    def send_final_zeros(self) -> None:
        """Leave zero on the wire after the end of the loop."""
        for _ in range(FINAL_ZEROS):
            if not self._send_zero():
                return
            self._clock.sleep_until(self._clock.now_s() + PERIOD_S)

    def _pause_s(self) -> float:
        """Return the time to the next check, in the middle between two ticks.

        So guard and loop do not need the same core at the same moment. A loop that
        stalls is checked as soon as it has done so for too long.
        """
        last_s, now_s = self._block.last_tick_s(), self._clock.now_s()
        if last_s <= 0.0:  # no force is held
            return REST_PERIOD_S if last_s == RESTING else CHECK_PERIOD_S
        overdue_s = last_s + GAP_RAMP_S + _JUST_AFTER_S - now_s
        if overdue_s <= 0.0:
            return REPEAT_PERIOD_S
        to_the_middle_s = (last_s + PERIOD_S / 2 - now_s) % PERIOD_S
        return min(CHECK_PERIOD_S - PERIOD_S + to_the_middle_s, overdue_s)

    def run(self, loop: LoopProcess) -> None:
        """Check until the loop's process has ended, or begins to."""
        while not loop.has_ended(self._pause_s()):
            self.check()
        self.send_final_zeros()


def main(argv: list[str] | None = None) -> int:
    """Guard one loop until its end."""
    parser = argparse.ArgumentParser(prog="hapticplayer.haptics.guard")
    for name in ("--block", "--end", "--handle"):
        parser.add_argument(name, type=int, required=True, help="descriptor")
    parser.add_argument("--lifeline", type=int, help="descriptor; else in the block")
    parser.add_argument("--device", required=True)
    options = parser.parse_args(argv)
    outlive_the_player()
    block, own = LoopBlock(options.block), options.lifeline
    try:
        guard = _guard(find_device(options.device), block, options.handle)
    except DeviceError:
        return 1  # the loop meets the same problem, and reports it
    acquire(priority=GUARD_PRIORITY)
    lifeline = Lifeline(block.lifeline) if own is None else map_lifeline(own)
    guard.run(LoopProcess(options.end, lifeline))
    return 0


def _guard(entry: DeviceEntry, block: LoopBlock, handle: int) -> Any:
    if entry.loop:
        return load(entry.loop).guard(SystemClock(), block, entry.make(handle))
    return Guard(
        SystemClock(),
        block,
        entry.silence(handle),
        watches_stalls=not entry.capabilities.has_own_clock,
    )


if __name__ == "__main__":
    sys.exit(main())
