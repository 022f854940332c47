"""The haptic loop, the Falcon's driver, and hands in virtual time."""

import sys

from benchmarks.common import command

PLACES = {
    "loop": "haptics.loop",
    "recorder": "haptics.loop:recorder",
    "waking": "haptics.waking",
    "rest": "haptics.rest",
    "exchange": "haptics.falcon:exchange",
    "kinematics": "haptics.falcon:kinematics",
    "centring": "campaigns:centring",
    "washout": "haptics.washout",
    "editing": "haptics.editing",
    "events": "haptics.events",
    "shaker": "haptics.shaker",
    "feel": "haptics.feel",
    "feel_window": "haptics.feel:window",
    "sound_layer": "haptics.sound_layer",
}
sys.exit(command("haptics", __doc__, PLACES))
