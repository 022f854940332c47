"""What a screen reader gets of the window, through AT-SPI as it is on a desktop."""

import json
import os
import shutil
import subprocess
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from tests.e2e.command import started

SYSTEMS_PYTHON = "/usr/bin/python3"
NEEDED = ("Xvfb", "dbus-daemon", SYSTEMS_PYTHON, "/usr/libexec/at-spi-bus-launcher")
MOST_LOOKS = 500  # of 0.2 s
DRAWN = ("Simulated grip", "Force around the playhead", "Time")


@pytest.fixture
def long_clip(tmp_path):
    """A minute without sound."""
    path = tmp_path / "long.mp4"
    grey = (np.full((36, 64, 3), 90, np.uint8) for _ in range(600))
    write_clip(path, grey, frame_rate_hz=10, is_quick=True)
    return path


@pytest.fixture
def desktop(tmp_path):
    """The environment of a display and a message bus with the service for readers."""
    missing = [one for one in NEEDED if shutil.which(one) is None]
    gi = [SYSTEMS_PYTHON, "-c", "import gi"]
    if missing or subprocess.run(gi, check=False, capture_output=True).returncode:
        pytest.skip(f"not on this machine: {', '.join(missing) or 'python3-gi'}")
    run = tmp_path / "run"
    run.mkdir(mode=0o700)
    env = {**os.environ, "XDG_RUNTIME_DIR": str(run), "QT_QPA_PLATFORM": "xcb"}
    env |= {"QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "XDG_CONFIG_HOME": str(tmp_path)}
    display = ["Xvfb", "-displayfd", "1", "-screen", "0", "1280x720x24"]
    bus = ["dbus-daemon", "--session", "--nofork", "--print-address"]
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "text": True}
    with (
        subprocess.Popen(display, env=env, **options) as screen,
        subprocess.Popen(bus, env=env, **options) as daemon,
    ):
        env["DISPLAY"] = f":{screen.stdout.readline().strip()}"
        env["DBUS_SESSION_BUS_ADDRESS"] = daemon.stdout.readline().strip()
        yield env
        for one in (daemon, screen):
            one.terminate()


def tree(env, wanted):
    """Return what is shown to readers, by role, once something has that name."""
    command = [SYSTEMS_PYTHON, Path(__file__).with_name("accessible_tree.py")]
    said = None
    for _ in range(MOST_LOOKS):
        said = subprocess.run(command, env=env, capture_output=True, check=False)
        if said.returncode:
            continue  # something went while it was read
        found = defaultdict(dict)
        for one in json.loads(said.stdout):
            found[one["role"]][one["label"] or one["name"]] = one["description"]
        if any(wanted in names for names in found.values()):
            return found
    pytest.fail(f"nothing is called {wanted}: {said}")


def test_a_screen_reader_gets_names_roles_and_values(desktop, long_clip):
    words = ("play", long_clip, "--device", "simulated")
    with started(*words, env=desktop, stderr=subprocess.DEVNULL) as window:
        found = tree(desktop, DRAWN[1])  # the plots come last
        window.terminate()
    assert {"File", "Playback", "Device", "Study", "Help"} <= set(found["menu item"])
    assert {"Pause", "Stop the force", "Mute"} <= set(found["push button"])
    assert {"Feedback", "Device"} == set(found["combo box"])
    assert found["slider"]["Position"].endswith("/ 01:00.0")
    assert set(DRAWN) <= set(found["graphic"])
    assert all(found["graphic"].values())
    spoken = ("menu item", "push button", "combo box", "slider", "graphic")
    assert [role for role in spoken if not all(found[role])] == []
