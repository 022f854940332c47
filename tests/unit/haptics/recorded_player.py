"""A player that starts a loop and its recorder, and is killed; run by a test."""

import os
import signal
import subprocess
import sys
from pathlib import Path

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.recorder import LoopRecording
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.linux import anonymous_memory

TICKS = 1000


def play(path: Path) -> None:
    """Start both and die once the loop has said that it runs."""
    block = anonymous_memory("test", BLOCK_BYTES)
    end, held = os.pipe()
    loop = subprocess.Popen(
        [sys.executable, __file__, "--loop", str(block)],
        pass_fds=[block, held],
        stdout=subprocess.PIPE,
    )
    os.close(held)
    LoopRecording(path, block).start(end, {})
    loop.stdout.readline()
    os.kill(os.getpid(), signal.SIGKILL)


def loop(block: int) -> None:
    """Write ticks for a second, as the loop does, and a TRIP as the last."""
    clock, shared = SystemClock(), SharedBlock(block)
    for count in range(TICKS):
        mode = 4 if count == TICKS - 1 else 2
        shared.write_tick(count, float(count), *[0.0] * 19, 0, mode, 0, 0)
        if count == 100:
            sys.stdout.write("running\n")
            sys.stdout.flush()
        clock.sleep_until(clock.now_s() + 0.001)


if __name__ == "__main__":
    if sys.argv[1] == "--loop":
        loop(int(sys.argv[2]))
    else:
        play(Path(sys.argv[1]))
