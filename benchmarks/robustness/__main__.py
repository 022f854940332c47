"""The safety contract, damaged files, and normal use over time."""

import sys

from benchmarks.common import command

NAMES = ("faults", "nuisance", "eviction", "media", "importers")
sys.exit(command("robustness", __doc__, NAMES))
