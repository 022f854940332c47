"""The cases are plain modules beside the tests, so that the benchmark can use them."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))


HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
NAMESPACE = ["unshare", "--user", "--map-root-user", "--mount"]


@pytest.fixture
def on_its_own_disk(tmp_path):
    """Run a scenario of a script with a disk of its own."""
    if shutil.which("unshare") is None:
        pytest.skip("unshare is not on this machine")
    disk = tmp_path / "disk"
    disk.mkdir()
    mounting = [*NAMESPACE, "mount", "-t", "tmpfs", "tmpfs", str(disk)]
    if subprocess.run(mounting, capture_output=True, check=False).returncode:
        pytest.skip("a disk of one's own cannot be mounted here")

    def run(script, scenario) -> dict:
        done = subprocess.run(
            [*NAMESPACE, sys.executable, str(HERE / script), scenario, str(disk)],
            capture_output=True,
            check=False,
            text=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout.splitlines()[-1])

    return run
