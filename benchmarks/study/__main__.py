"""Studies: whether an answer is ever lost, and the time of their analysis."""

import sys

from benchmarks.common import command

sys.exit(command("study", __doc__, ("kill", "analysis")))
