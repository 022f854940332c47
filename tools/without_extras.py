"""Runs the core's tests in a copy of the tree without the extras.

    python -m tools.without_extras [--only EXTRA] [PYTEST ARGUMENTS]

Tests whose material belongs to an extra are skipped: "needs the extra rides".
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
AT_WORK = "tests/unit", "tests/app", "tests/e2e"


def copy_without(names: set[str], target: Path) -> None:
    """Everything but folders `extras/NAME`, also those of their tests."""
    listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    found = subprocess.run(listed, cwd=ROOT, check=True, capture_output=True, text=True)
    for name in filter(None, found.stdout.split("\0")):
        room, _, rest = name.rpartition("extras/")
        is_left_out = room and rest.partition("/")[0] in names
        if not is_left_out and (ROOT / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, target / name)


def main() -> int:
    """Return the exit status of pytest."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", metavar="EXTRA", help="leave out this one alone")
    options, arguments = parser.parse_known_args()
    names = {path.name for path in ROOT.glob("*/extras/*") if path.is_dir()}
    with tempfile.TemporaryDirectory(prefix="core-") as folder:
        copy_without({options.only} if options.only else names, Path(folder))
        more = {"cwd": folder, "env": os.environ | {"PYTHONPATH": folder}}
        tables = [sys.executable, "-m", "tools.tables"]
        subprocess.run(tables, check=True, **more)  # of the rows that are left
        command = [sys.executable, "-m", "pytest", *(arguments or AT_WORK)]
        return subprocess.run(command, check=False, **more).returncode


if __name__ == "__main__":
    sys.exit(main())
