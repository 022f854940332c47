"""Each extra can be deleted: all else starts, helps and lists without it."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
EXTRAS = sorted({path.parent.name for path in ROOT.glob("*/extras/*/extension.py")})
CHILD = """
import contextlib, io, json, os, sys
from pathlib import Path

from PySide6.QtWidgets import QApplication

from app.bridge.settings import Settings
from app.player import dialogs
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer import cli, extension
from hapticplayer.clock import SystemClock
from hapticplayer.playback.player import Player
from tools.tables import TABLES

found = {}
out = io.StringIO()
with contextlib.redirect_stdout(out):
    found["help"] = cli.main(["--help"])
    found["address"] = cli.main(["play", "https://127.0.0.1/ride.mkv"]) - 2
    found["device list"] = cli.main(["device", "list"])
    for one in cli.commands():
        found[one.name] = cli.main([one.name, "--help"])
found["empty tables"] = sum(not make().strip() for make in TABLES.values())
application = QApplication([])
dialogs.load()
surface, clock = VideoSurface(), SystemClock()
player = Player(clock, SurfaceSink(surface), audio=None)
window = PlayerWindow(player, surface, clock, Settings(None))
window.show()
application.processEvents()
found["window"] = int(not window.isVisible())
window.close()
loaded = [name for name in sys.modules if f".extras.{sys.argv[1]}" in name]
print(json.dumps([found, loaded, extension.take_problems()]))
sys.stdout.flush()
os._exit(0)
"""


@pytest.mark.parametrize("name", EXTRAS)
def test_everything_else_works_without_an_extra(tmp_path, name):
    for package in ("hapticplayer", "app"):
        left_out = str(ROOT / package / "extras" / name)
        shutil.copytree(
            ROOT / package,
            tmp_path / package,
            copy_function=os.symlink,
            ignore=lambda folder, names, at=left_out: [
                one for one in names if f"{folder}/{one}" == at
            ],
        )
    path = os.pathsep.join([str(tmp_path), str(ROOT)])
    more = {"PYTHONPATH": path, "QT_QPA_PLATFORM": "offscreen", "HOME": str(tmp_path)}
    result = subprocess.run(
        [sys.executable, "-P", "-c", CHILD, name],
        env=os.environ | more,
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    status, loaded, problems = json.loads(result.stdout.splitlines()[-1])
    assert not any(status.values()), status
    assert not loaded
    assert not problems
    assert "Traceback" not in result.stderr
