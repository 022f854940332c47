"""Files that name other files or addresses: nothing but themselves is ever opened.

A tracer watches every `open`, `socket` and `connect` of the program and its children
while the files go in by command line, import, sequence, dialog and drop.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(
    shutil.which("strace") is None, reason="the program strace is not installed"
)

ADDRESS = "http://127.0.0.1:9/canary.ts"
HLS = "#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\n{}\n#EXT-X-ENDLIST\n"
CONCAT = "ffconcat version 1.0\nfile {}\n"
HOSTILE = {
    "net.m3u8": HLS.format(ADDRESS),
    "net.mp4": HLS.format(ADDRESS),
    "local.m3u8": HLS.format("file://{folder}/canary.mp4"),
    "local.mp4": HLS.format("file://{folder}/canary.mp4"),
    "sibling.ffconcat": CONCAT.format("canary.mp4"),
    "sibling.mp4": CONCAT.format("canary.mp4"),
    "netconcat.mp4": CONCAT.format(ADDRESS),
    "session.sdp": "v=0\nc=IN IP4 127.0.0.1\nm=video 5004 RTP/AVP 96\n",
    "session.mp4": "v=0\nc=IN IP4 127.0.0.1\nm=video 5004 RTP/AVP 96\n",
    "dash.mpd": f'<?xml version="1.0"?><MPD><BaseURL>{ADDRESS}</BaseURL></MPD>',
}
NAMES = (
    ADDRESS,
    "concat:canary.mp4|canary.mp4",
    "subfile,,start,0,end,0,,:canary.mp4",
    "async:canary.mp4",
    "tcp://127.0.0.1:9",
)

BY_COMMAND = """
import os, sys
from hapticplayer import cli
os.chdir(sys.argv[1])
for name in sys.argv[2:]:
    for command in (["play", name, "--headless", "--device", "none"],
                    ["import", name, "-o", "made"],
                    ["process", name]):
        status = cli.main(command)  # a sequence's motion may be processed
        assert status or command[0] == "process", (name, command)
"""

BY_WINDOW = """
import os, sys
from pathlib import Path
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.clock import SystemClock
from hapticplayer.playback.player import Player
os.chdir(sys.argv[1])
application, clock, surface = make_application(), SystemClock(), VideoSurface()
player = Player(clock, SurfaceSink(surface), audio=None)
window = PlayerWindow(player, surface, clock, Settings(Path("settings.json")))
window.show()

def drop(path):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path.resolve()))])
    window.dropEvent(QDropEvent(
        QPointF(50, 50), Qt.DropAction.CopyAction, data,
        Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier))

for name in sys.argv[2:]:
    for way in (window.session.open_path, drop):
        way(Path(name))
        while window.session.jobs.is_busy:
            application.processEvents()
            window.session.watch()
        assert player.snapshot().source is None, name
window.close()
"""


@pytest.fixture
def folder(tmp_path: Path, demo: Path) -> Path:
    for name, content in HOSTILE.items():
        (tmp_path / name).write_text(content.replace("{folder}", str(tmp_path)))
    shutil.copy(demo / "clip.mp4", tmp_path / "canary.mp4")
    for name in ("net.mp4", "sibling.mp4"):  # as the clip of a sequence
        sequence = tmp_path / f"sequence-{name}"
        shutil.copytree(demo, sequence)
        size_bytes = (demo / "clip.mp4").stat().st_size
        hostile = (tmp_path / name).read_bytes().ljust(size_bytes, b"\n")
        (sequence / "clip.mp4").write_bytes(hostile)
        shutil.copy(tmp_path / "canary.mp4", sequence / "canary.mp4")
    return tmp_path


@pytest.mark.parametrize("script", [BY_COMMAND, BY_WINDOW], ids=["command", "window"])
def test_a_hostile_file_opens_no_other_file_or_connection(folder, script):
    trace = folder.parent / f"{folder.name}.trace"
    sequences = [path.name for path in folder.glob("sequence-*")]
    watched = "trace=open,openat,openat2,socket,connect"
    command = ["strace", "-f", "-qq", "-s", "300", "-e", watched, "-o", str(trace)]
    command += [sys.executable, "-c", script, str(folder)]
    done = subprocess.run(
        [*command, *HOSTILE, *NAMES, *sequences],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    calls = trace.read_text()
    assert re.search(r"openat\(.*net\.mp4", calls), "the tracer has seen nothing"
    assert "canary" not in calls
    assert not re.findall(r"socket\(AF_INET6?,.*", calls)
    assert not re.findall(r"connect\(.*AF_INET6?.*", calls)
