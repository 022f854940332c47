"""A player that commands 4 N and then waits to be killed; run by a test."""

import sys
from pathlib import Path

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.process import HapticsProcess
from hapticplayer.model import ForceTrack, PlaybackClock


def main() -> None:
    """Argument: the file for the shared block. Says when the force is there."""
    clock = SystemClock()
    process = HapticsProcess(clock, record=Path(sys.argv[1]))
    process.wait_ready()
    track = process.load_track(ForceTrack([0.0, 1e4], [[0, 0, 4.0], [0, 0, 4.0]]))
    start_s = clock.now_s()
    is_told = False
    while True:
        now_s = clock.now_s()
        process.beat()
        process.publish(PlaybackClock(1, start_s, 0.0, 1.0, now_s + 0.15), track)
        records, _ = process.read_ticks()
        if not is_told and len(records) and records["force_n"][-1, 2] > 3.99:
            sys.stdout.write(f"{process.pid}\n")
            sys.stdout.flush()
            is_told = True
        clock.sleep_until(now_s + 0.01)


if __name__ == "__main__":
    main()
