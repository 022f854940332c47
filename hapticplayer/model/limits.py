"""Limits that more than one room checks."""

GAP_STEPS = 3.0
"""A step of more than this many median steps of a log is a gap."""

MAX_SAMPLES = 100_000_000
"""Rows of one sensor: 34 h of an 800 Hz sensor."""

MAX_FORCE_N = 1000.0
"""Beyond any haptic device of this kind, the Falcon has 9 N: it is in another unit."""
