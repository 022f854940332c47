"""Gravity removal: error, run time, flawed recordings, numerics, and the error budget."""

import sys

from benchmarks.common import command

PLACES = {
    "accuracy": "motion.accuracy",
    "run_time": "motion.run_time",
    "stress": "campaigns:stress",
    "numerics": "motion.numerics",
    "budget": "motion.budget",
}
sys.exit(command("motion", __doc__, PLACES))
