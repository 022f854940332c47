"""The haptic loop, the Falcon's driver, and hands in virtual time."""

import sys

from benchmarks.common import command

NAMES = ("loop", "recorder", "exchange", "kinematics", "centring")
sys.exit(command("haptics", __doc__, NAMES))
