"""A player that commands 2.8 N (3 N are refused on a machine that is too busy) and then waits to be killed; run by a test."""

import sys

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.model import ForceTrack, PlaybackClock


def main() -> None:
    """Say the loop's process id when the force is there."""
    clock = SystemClock()
    process = HapticsProcesses(clock, device_options=["--hand", "firm"])
    process.wait_ready()
    process.load({"track": ForceTrack([0.0, 1e4], [[0, 0, 2.8], [0, 0, 2.8]])})
    start_s = clock.now_s()
    is_reported = False
    while True:
        now_s = clock.now_s()
        process.beat()
        process.publish(PlaybackClock(1, start_s, 0.0, 1.0, now_s + 0.15), "track")
        records, _ = process.read_ticks()
        if not is_reported and len(records) and records["force_n"][-1, 2] > 2.79:
            sys.stdout.write(f"{process.pids['loop']}\n")
            sys.stdout.flush()
            is_reported = True
        clock.sleep_until(now_s + 0.01)


if __name__ == "__main__":
    main()
