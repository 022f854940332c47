"""Simulated other sides are plain modules here and beside the tests of each device."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
BESIDE = [HERE.parents[1] / "extras" / name for name in ("wheels", "toys", "shakers")]
for folder in (HERE, *BESIDE, HERE.parents[2] / "faults"):
    sys.path.insert(0, str(folder))
