"""The guard: a process that takes the force away when the loop cannot.

It watches the loop and writes zero to the device when the loop has died or stands
still. It knows nothing of players, tracks and clips. Run as
`python -m hapticplayer.haptics.guard` by `HapticsProcess`.
"""

import argparse
import os
import select
import signal
import sys
from collections.abc import Callable

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.contract import GAP_RAMP_S
from hapticplayer.haptics.limiter import PERIOD_S
from hapticplayer.haptics.scheduling import GUARD_PRIORITY, acquire

LOOK_PERIOD_S = 0.004
SUSPECT_AGE_S = 0.0015
"""A loop whose last tick is older than this may be dying: ask the kernel."""
LAST_ZEROS = 5
_JUST_AFTER_S = 0.0001


class LoopProcess:
    """The loop as the kernel sees it.

    A killed process is told of (its descriptor becomes readable) only when its memory
    has been taken down, up to 10 ms for locked memory; its flags say so from the first
    microsecond of its exit (PF_EXITING, proc(5) field 9).

    Args:
        pidfd: the descriptor of the process.
    """

    _EXITING = 0x4
    _FLAGS_FIELD = 6  # counted behind the name, which may hold blanks

    def __init__(self, pidfd: int) -> None:
        with open(f"/proc/self/fdinfo/{pidfd}", encoding="ascii") as lines:  # noqa: PTH123
            pid = next(int(line[4:]) for line in lines if line.startswith("Pid:"))
        # None: it is dead already; open before any other process can have its number
        self._stat = os.open(f"/proc/{pid}/stat", os.O_RDONLY) if pid > 0 else None
        self._pidfd = pidfd

    def has_ended(self, timeout_s: float) -> bool:
        """Wait for its end."""
        return bool(select.select([self._pidfd], [], [], timeout_s)[0])

    def is_dying(self) -> bool:
        """Return whether it runs no instruction of its own any more."""
        if self._stat is None:
            return True
        try:
            stat = os.pread(self._stat, 1024, 0)
        except ProcessLookupError:
            return True
        fields = stat[stat.rindex(b")") + 2 :].split(maxsplit=self._FLAGS_FIELD + 1)
        return bool(int(fields[self._FLAGS_FIELD]) & self._EXITING)


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

    def look(self) -> float:
        """Beat, and write zero if the loop holds its last force for too long.

        The loop itself goes on from zero after such a gap: see the rules TICK_LATE
        and TICK_LOST of the contract.

        Returns:
            the age of the loop's last tick in seconds; 0 before the first.
        """
        now_s = self._clock.now_s()
        self._block.beat_guard(now_s)
        last_s = self._block.last_tick_s()
        age_s = now_s - last_s if last_s else 0.0
        if age_s > GAP_RAMP_S:
            self._silence()
        return age_s

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
        pause_s = LOOK_PERIOD_S - PERIOD_S + (last_s + PERIOD_S / 2 - now_s) % PERIOD_S
        overdue_s = last_s + GAP_RAMP_S + _JUST_AFTER_S - now_s
        return min(pause_s, overdue_s) if overdue_s > 0.0 else pause_s

    def run(self, loop: LoopProcess) -> None:
        """Look until the loop's process has gone, or is going."""
        while not loop.has_ended(self._pause_s()):
            if self.look() > SUSPECT_AGE_S and loop.is_dying():
                break
        self.bury()


def main(argv: list[str] | None = None) -> int:
    """Watch one loop until its end."""
    parser = argparse.ArgumentParser(prog="hapticplayer.haptics.guard")
    parser.add_argument("--block", type=int, required=True, help="descriptor")
    parser.add_argument("--loop-pidfd", type=int, required=True, help="descriptor")
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
    loop = LoopProcess(options.loop_pidfd)
    Guard(SystemClock(), LoopBlock(options.block), silence).run(loop)
    return 0


if __name__ == "__main__":
    sys.exit(main())
