"""Studies: whether an answer is ever lost, and the time of their analysis."""

import sys

from benchmarks.common import command

PLACES = {
    "kill": "study.kill",
    "analysis": "study.analysis",
    "ordinal": "study.ordinal",
    "sites": "study.sites",
    "thresholds": "study.thresholds",
    "rating": "study.rating",
}
sys.exit(command("study", __doc__, PLACES))
