"""Simulated other sides are plain modules here and beside the tests of each device."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
for folder in (HERE, HERE.parent / "gamepad", HERE.parents[2] / "faults"):
    sys.path.insert(0, str(folder))
