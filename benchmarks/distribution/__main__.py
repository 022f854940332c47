"""Files that carry force: who accepts them, and what they cost."""

import sys

from benchmarks.common import command

PLACES = {
    "one_file": "distribution.one_file",
    "web": "distribution.web",
    "formats": "distribution.formats",
    "installed": "distribution.installed",
    "ten_hours": "distribution.ten_hours",
    "damage": "campaigns:force_damage",
}
sys.exit(command("distribution", __doc__, PLACES))
