"""The guard: a process that takes the force away when the loop cannot.

It watches the loop and writes zero to the device when the loop has died or stands
still. It knows nothing of players, tracks and clips. Run as
`python -m hapticplayer.haptics.guard` by `HapticsProcess`.
"""

import argparse
import select
import signal
import sys
from collections.abc import Callable

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.contract import GAP_RAMP_S
from hapticplayer.haptics.limiter import PERIOD_S
from hapticplayer.haptics.scheduling import GUARD_PRIORITY, acquire
from hapticplayer.haptics.shared import SharedBlock

LOOK_PERIOD_S = 0.004
LAST_ZEROS = 5


class Guard:
    """What the guard does at each look.

    Args:
        clock: of the machine.
        block: shared with the loop.
        silence: writes one zero command; False when there is no device any more.
    """

    def __init__(
        self, clock: Clock, block: SharedBlock, silence: Callable[[], bool]
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

    def run(self, loop_pidfd: int) -> None:
        """Look until the loop's process has gone."""
        poll = select.poll()
        poll.register(loop_pidfd, select.POLLIN)
        while not poll.poll(LOOK_PERIOD_S * 1000):
            self.look()
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
    Guard(SystemClock(), SharedBlock(options.block), silence).run(options.loop_pidfd)
    return 0


if __name__ == "__main__":
    sys.exit(main())
