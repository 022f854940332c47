"""Playback beside other players, the window, and what is skipped."""

import sys

from benchmarks.common import command

NAMES = ("players", "seeks", "window", "plots", "skips")
sys.exit(command("playback", __doc__, NAMES))
