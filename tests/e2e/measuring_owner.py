"""`device measure` on a Falcon whose motors and buttons are at hand; see test_latch.

Arguments: descriptors, of the record of its motors and of what presses its buttons.
"""

import sys

from hapticplayer import cli
from hapticplayer.cli import device_measure
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.guarded_clock import GuardedClock


def watched_falcon(device):
    record, control = map(int, sys.argv[1:])
    options = ["--unhomed", "--record", str(record), "--control", str(control)]
    return GuardedClock(SystemClock(), device, options, [record, control])


if __name__ == "__main__":
    device_measure._guarded_clock = watched_falcon
    device_measure.STOPS_S = 2.0  # until the hand is back from homing
    sys.exit(cli.main(["device", "measure", "--device", "falcon-simulated", "--yes"]))
