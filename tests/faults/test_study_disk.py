"""Full and read-only disks: no answer is lost unnoticed."""

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
    """Run a scenario with a disk of its own."""
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
    reported = on_its_own_disk("full")
    assert reported["kind"] == "problem"
    assert "could not be saved (the disk at /" in reported["problem"]
    assert reported["interrupts"] > 0
    assert 1 <= reported["accepted"] < 12
    assert reported["kept"] == reported["accepted"]
    assert reported["after"] != "problem"
    assert reported["kept_in_the_end"] == 12


def test_a_read_only_disk_is_reported_before_the_first_answer(on_its_own_disk):
    reported = on_its_own_disk("read-only")
    for action in ("begin", "resume"):
        assert "Read-only file system" in reported[action]
        assert "\n" not in reported[action]
    assert (reported["kept"], reported["sessions"]) == (1, 1)
