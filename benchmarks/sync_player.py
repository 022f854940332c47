"""The real window with the real player, used by benchmarks/sync.py.

    python benchmarks/sync_player.py CLIP FORCE RECORD CASE SECONDS

RECORD is a descriptor for the simulated device. Plays the clip on the whole screen and
does meanwhile what the case says; prints the player's own summary as JSON at the end.
"""

import ctypes
import functools
import json
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from PySide6.QtCore import QTimer
from sync_clips import PERIOD_S

from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.process import HapticsProcess
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source

SEEKS = 50
FREEZE_S = 2.0
HELD_S = 0.5

Steps = Iterator[float]


class Deeds:
    """What a case does: each is a generator of the seconds until its next step."""

    def __init__(self, window: PlayerWindow, seconds: float) -> None:
        self._window, self._player, self._seconds = window, window.player, seconds
        self.done: list[tuple[float, float]] = []  # spans in which nothing is in time

    def of(self, case: str) -> Steps:
        """Return what a case does."""
        if case.startswith("speed-"):
            return self._speed(float(case.removeprefix("speed-")))
        return getattr(self, f"_{case}", self._nothing)()

    def _nothing(self) -> Steps:
        yield from ()

    def _pause(self) -> Steps:
        while True:
            yield 2.2
            self._player.pause()
            yield 0.7
            self._player.play()

    def _seek(self) -> Steps:
        for number in range(SEEKS):
            yield 1.0
            turn = (7 * number) % round((self._seconds - 4.0) / PERIOD_S)
            self._player.seek((turn + 0.5) * PERIOD_S)

    def _speed(self, rate: float) -> Steps:
        yield 0.0
        self._player.set_speed(rate)

    def _freeze(self) -> Steps:
        yield from self._stand_still(lambda: time.sleep(FREEZE_S))

    def _hold(self) -> Steps:
        yield from self._stand_still(_keep_the_interpreter)

    def _stand_still(self, hang: Callable[[], None]) -> Steps:
        """Hang, then let a person re-arm."""
        while True:
            yield 4.0
            begin_s = time.monotonic()
            hang()
            yield 0.5
            self._window.session.rearm()
            yield 0.3
            self.done.append((begin_s, time.monotonic()))


def _keep_the_interpreter() -> None:
    """Sleep without letting any other thread of the interpreter run meanwhile."""
    ctypes.PyDLL(None).usleep(round(1e6 * FREEZE_S))


def main() -> None:
    """Play to the end."""
    clip, force, record, case, seconds = sys.argv[1:]
    haptics = functools.partial(
        HapticsProcess,
        device_options=["--hand", "firm", "--record", record],
        device_descriptors=[int(record)],
    )
    application = make_application()
    clock, surface = SystemClock(), VideoSurface()
    player = Player(clock, SurfaceSink(surface), haptics=haptics)
    settings = Settings(Path(clip).parent / "settings.json")
    window = PlayerWindow(player, surface, clock, settings, plots=False)
    player.set_device("simulated")
    window.enter_fullscreen()
    player.poll()
    window.session.show_source(open_source(clip, force))
    player.play()
    deeds = Deeds(window, float(seconds))
    steps = deeds.of(case)
    timer = QTimer(singleShot=True)

    def go_on() -> None:
        wait_s = next(steps, None)
        if wait_s is not None:
            timer.start(round(1e3 * wait_s))

    def end() -> None:
        window.close()
        application.quit()

    timer.timeout.connect(go_on)
    timer.start(1500)
    QTimer.singleShot(round(1e3 * (float(seconds) + HELD_S)), end)
    application.exec()
    summary = {
        **player.summary(),
        "told": player.snapshot().notices,
        "hung": deeds.done,
    }
    sys.stdout.write(json.dumps(summary) + "\n")


if __name__ == "__main__":
    main()
