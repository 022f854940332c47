"""Gravity removal and motion from frames: errors, run time, flaws, numerics, budget."""

import sys

from benchmarks.common import command

PLACES = {
    "accuracy": "motion.accuracy",
    "causal": "motion.causal",
    "short_clips": "motion.short_clips",
    "run_time": "motion.run_time",
    "stress": "campaigns:stress",
    "numerics": "motion.numerics",
    "budget": "motion.budget",
    "sensitivity": "motion.sensitivity",
    "suggested": "motion.suggested",
}
sys.exit(command("motion", __doc__, PLACES))
