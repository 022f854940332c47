"""Synchronisation: frames, sound and force in playback; a log with its clip."""

import sys

from benchmarks.common import command

sys.exit(command("sync", __doc__, ("outside", "pats")))
