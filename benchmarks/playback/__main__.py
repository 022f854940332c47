"""Playback beside other players, the window, and what is skipped."""

import sys

from benchmarks.common import command

PLACES = {
    "players": "playback.players",
    "start": "playback.start",
    "idle": "playback.idle",
    "seeks": "playback.plots_and_seeks:seeks",
    "window": "playback.window",
    "plots": "playback.plots_and_seeks:plots",
    "skips": "playback.skips",
}
sys.exit(command("playback", __doc__, PLACES))
