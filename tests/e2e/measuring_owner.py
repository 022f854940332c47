"""`device measure` on a Falcon whose motors and buttons are at hand; see test_latch.

Arguments: descriptors, of the record of its motors and of what presses its buttons.
"""

import sys

from hapticplayer import cli
from hapticplayer.extras.measuring import command
from hapticplayer.extras.measuring.guarded_clock import GuardedClock


def watched_falcon(clock, device, options):
    passed = [int(number) for number in sys.argv[1:]]
    names = ("--record", "--control")
    more = [text for pair in zip(names, sys.argv[1:], strict=True) for text in pair]
    return GuardedClock(clock, device, [*options, *more], passed)


if __name__ == "__main__":
    command.GuardedClock = watched_falcon
    command.STOPS_S = 2.0  # until the hand is back from homing
    sys.exit(cli.main(["device", "measure", "--device", "falcon-simulated", "--yes"]))
