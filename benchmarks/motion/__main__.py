"""Gravity removal: error, run time, flawed recordings, numerics, and the error budget."""

import sys

from benchmarks.common import command

NAMES = ("accuracy", "run_time", "stress", "numerics", "budget")
sys.exit(command("motion", __doc__, NAMES))
