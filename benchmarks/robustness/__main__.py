"""The safety contract, damaged files, and normal use over time."""

import sys

from benchmarks.common import command

PLACES = {
    "faults": "robustness.faults",
    "axes": "robustness.axes",
    "nuisance": "robustness.nuisance",
    "real_files": "robustness.real_files",
    "eviction": "robustness.eviction",
    "record_kills": "robustness.record_kills",
    "record_load": "robustness.record_load",
    "without": "campaigns:without",
    "media": "campaigns:media",
    "importers": "campaigns:importers",
}
sys.exit(command("robustness", __doc__, PLACES))
