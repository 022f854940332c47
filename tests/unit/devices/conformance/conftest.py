"""Simulated other sides are plain modules here and beside the tests of each device."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
BESIDE = [HERE.parent / name for name in ("evdev", "toys", "transducer")]
for folder in (HERE, *BESIDE, HERE.parents[2] / "faults"):
    sys.path.insert(0, str(folder))
