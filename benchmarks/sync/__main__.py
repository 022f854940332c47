"""Synchronisation: frames, sound and force in playback; a log with its clip."""

import sys

from benchmarks.common import command

PLACES = {
    "outside": "sync.outside",
    "pats": "sync.pats",
}
sys.exit(command("sync", __doc__, PLACES))
