"""What the official validator says of a BIDS dataset."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest


def validated(folder):
    """Return the report of the validator."""
    program = shutil.which("bids-validator-deno", path=Path(sys.executable).parent)
    if program is None:
        pytest.skip("bids-validator-deno is not installed")
    command = [program, "--format", "json", "--max-rows", "-1", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(done.stdout)


def errors_in(folder):
    """Return what is not valid."""
    issues = validated(folder)["issues"]["issues"]
    return [issue for issue in issues if issue["severity"] == "error"]
