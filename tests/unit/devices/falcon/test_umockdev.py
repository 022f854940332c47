"""The driver once through the machine's own libusb, on a mocked usbfs."""

import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from hapticplayer.doctor import ROOT
from tests.needed_extras import needs

SCENARIO = Path(__file__).with_name("umockdev_falcon.py")
WRAPPER = shutil.which("umockdev-wrapper")


def missing() -> str:
    """Return what is not installed, "" when all is."""
    if WRAPPER is None:
        return "umockdev is not installed (packages umockdev, gir1.2-umockdev-1.0)"
    if sys.maxsize < 1 << 32:
        return "the layout of usbfs is that of 64-bit machines"
    is_there = importlib.util.find_spec("gi") or Path(
        "/usr/lib/python3/dist-packages/gi"
    )
    if isinstance(is_there, Path) and not is_there.is_dir():
        return "PyGObject is not installed (package python3-gi)"
    return ""


@pytest.mark.skipif(bool(missing()), reason=missing())
@needs("faults")
def test_the_whole_life_of_a_falcon_through_libusb():
    done = subprocess.run(
        [WRAPPER, sys.executable, str(SCENARIO)],
        capture_output=True,
        text=True,
        cwd=ROOT,
        timeout=100,
        check=False,
    )
    assert done.stdout, done.stderr
    found = json.loads(done.stdout)
    assert found.pop("serials") == ["12PZ657E"]
    assert found.pop("guard_wrote") == 16
    assert "unplugged" in found.pop("unplugged")
    assert all(found.values()), found
