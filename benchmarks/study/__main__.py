"""Studies: whether an answer that was acknowledged is ever lost."""

import sys

from benchmarks.common import command

sys.exit(command("study", __doc__, ("kill",)))
