"""Gravity removal: error, short clips, run time, flaws, numerics, the error budget."""

import sys

from benchmarks.common import command

PLACES = {
    "accuracy": "motion.accuracy",
    "short_clips": "motion.short_clips",
    "run_time": "motion.run_time",
    "stress": "campaigns:stress",
    "numerics": "motion.numerics",
    "budget": "motion.budget",
}
sys.exit(command("motion", __doc__, PLACES))
