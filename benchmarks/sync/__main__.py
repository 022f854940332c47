"""Synchronisation: frames, sound, force and outputs in playback; a log with its clip."""

import sys

from benchmarks.common import command

PLACES = {
    "outputs": "sync.outputs",
    "outside": "sync.outside",
    "live": "sync.live",
    "pats": "sync.pats",
    "frames": "sync.frames",
}
sys.exit(command("sync", __doc__, PLACES))
