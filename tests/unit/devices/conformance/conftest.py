"""Simulated other sides are plain modules here and beside the tests of each device."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
BESIDE = (HERE.parent / "gamepad", HERE.parent / "evdev", HERE.parents[2] / "faults")
for folder in (HERE, *BESIDE):
    sys.path.insert(0, str(folder))
