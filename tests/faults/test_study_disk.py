"""Real disks that are full or read-only: nobody answers into the void."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = Path(__file__).with_name("study_disk.py")
NAMESPACE = ["unshare", "--user", "--map-root-user", "--mount"]


@pytest.fixture
def on_its_own_disk(tmp_path):
    """Run a scenario with a disk that nobody else sees."""
    if shutil.which("unshare") is None:
        pytest.skip("unshare is not on this machine")
    disk = tmp_path / "disk"
    disk.mkdir()
    mounting = [*NAMESPACE, "mount", "-t", "tmpfs", "tmpfs", str(disk)]
    if subprocess.run(mounting, capture_output=True, check=False).returncode:
        pytest.skip("a disk of one's own cannot be mounted here")

    def run(scenario) -> dict:
        done = subprocess.run(
            [*NAMESPACE, sys.executable, str(SCRIPT), scenario, str(disk)],
            capture_output=True,
            check=False,
            text=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout.splitlines()[-1])

    return run


def test_a_full_disk_stops_the_participant_and_no_answer_is_lost(on_its_own_disk):
    told = on_its_own_disk("full")
    assert told["kind"] == "problem"
    assert "could not be saved (No space left on device)" in told["problem"]
    assert told["halts"] > 0
    assert 1 <= told["accepted"] < 12
    assert told["kept"] == told["accepted"]
    assert told["after"] != "problem"
    assert told["kept_in_the_end"] == 12


def test_a_read_only_disk_is_told_before_anybody_answers(on_its_own_disk):
    told = on_its_own_disk("read-only")
    for action in ("begin", "resume"):
        assert "Read-only file system" in told[action]
        assert "\n" not in told[action]
    assert (told["kept"], told["sessions"]) == (1, 1)
