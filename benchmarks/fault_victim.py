"""The real window with the real player under 4 N, for benchmarks/faults.py to hurt.

    python benchmarks/fault_victim.py CLIP FORCE RECORD CONTROL

RECORD and CONTROL are descriptors for the simulated device. Reads one word a line from
standard input (esc, stop, close, interrupt, rearm, play, where) and answers in JSON with
the monotonic time at which it was done.
"""

import functools
import json
import os
import signal
import sys
from pathlib import Path

from PySide6.QtCore import QSocketNotifier, Qt, QTimer
from PySide6.QtTest import QTest

from app.bridge.interrupts import closing_on_signals, hold_signals
from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.process import HapticsProcess
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source

READY_FORCE_N = 3.9


class Victim:
    """A window that does what it is told, and says when."""

    def __init__(self, clip: Path, force: Path, record: int, control: int) -> None:
        options = ["--hand", "firm", "--record", str(record), "--control", str(control)]
        haptics = functools.partial(
            HapticsProcess,
            device_options=options,
            device_descriptors=[record, control],
        )
        self.clock, surface = SystemClock(), VideoSurface()
        self.player = Player(
            self.clock,
            SurfaceSink(surface),
            device="simulated",
            audio=None,
            haptics=haptics,
        )
        settings = Settings(clip.parent / "settings.json")
        self.window = PlayerWindow(self.player, surface, self.clock, settings)
        self.window.show()
        self.window.session.show_source(open_source(clip, force))
        self.player.play()
        self._timer = QTimer(interval=10)
        self._timer.timeout.connect(self._tell_when_ready)
        self._timer.start()
        self._input = QSocketNotifier(0, QSocketNotifier.Type.Read)
        self._input.activated.connect(self._obey)

    def _tell_when_ready(self) -> None:
        if self.window.session.is_stopped:  # until it is known here, and done there
            self.window.session.rearm()
            self.player.play()
        latest = self.player.snapshot().tick
        if latest is None or abs(complex(*latest["force_n"][:2])) < READY_FORCE_N:
            return
        self._timer.stop()
        self._say(ready=True, loop=self.player.snapshot().loop_pid)

    def _obey(self) -> None:
        said = os.read(0, 4096)
        if not said:  # nobody is left who wants anything
            self._input.setEnabled(False)
            self.window.close()
        for word in said.decode().split():
            now_s = self.clock.now_s()
            self._do(word)
            self._say(word=word, at_s=now_s)

    def _do(self, word: str) -> None:
        if word == "esc":
            QTest.keyClick(self.window.windowHandle(), Qt.Key.Key_Escape)
        elif word == "stop":
            self.window.transport.stop.click()
        elif word == "close":
            QTimer.singleShot(0, self.window.close)
        elif word == "interrupt":
            os.kill(os.getpid(), signal.SIGINT)
        elif word == "rearm":
            self._timer.start()

    def _say(self, **content: object) -> None:
        sys.stdout.write(json.dumps(content) + "\n")
        sys.stdout.flush()


def main() -> None:
    """Run until closed."""
    hold_signals()
    application = make_application()
    clip, force, record, control = sys.argv[1:]
    victim = Victim(Path(clip), Path(force), int(record), int(control))

    def close() -> None:
        victim.window.close()
        application.quit()

    with closing_on_signals(lambda: QTimer.singleShot(0, close)):
        application.exec()


if __name__ == "__main__":
    main()
