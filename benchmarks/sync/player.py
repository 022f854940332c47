"""The real window with the real player, run by `outside`: it does what the case says.

`python -m benchmarks.sync.player CLIP FORCE RECORD CASE SECONDS`; RECORD is a descriptor
for the simulated device. Prints the player's own summary as JSON at the end.
"""

import ctypes
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from PySide6.QtCore import QTimer

from app.player.window import PlayerWindow
from benchmarks.sync.clips import PERIOD_S
from benchmarks.window import open_window, say, with_device_options
from hapticplayer.playback.source import open_source

SEEKS = 50
FREEZE_S = 2.0
HELD_S = 0.5
Steps = Iterator[float]


class Case:
    """What a case does: each is a generator of the seconds until its next step."""

    def __init__(self, window: PlayerWindow, seconds: float) -> None:
        self._window, self._player, self._seconds = window, window.player, seconds
        self.hung: list[tuple[float, float]] = []  # spans in which nothing is in time

    def of(self, case: str) -> Steps:
        """Return the steps of a case."""
        if case.startswith("speed-"):
            return self._speed(float(case.removeprefix("speed-")))
        return getattr(self, f"_{case}", lambda: iter(()))()

    def _pause(self) -> Steps:
        while True:
            yield 2.2
            self._player.pause()
            yield 0.7
            self._player.play()

    def _seek(self) -> Steps:
        for number in range(SEEKS):
            yield 1.0
            moment = (7 * number) % round((self._seconds - 4.0) / PERIOD_S)
            self._player.seek((moment + 0.5) * PERIOD_S)

    def _speed(self, rate: float) -> Steps:
        yield 0.0
        self._player.set_speed(rate)

    def _freeze(self) -> Steps:
        yield from self._hang(lambda: time.sleep(FREEZE_S))

    def _hold(self) -> Steps:
        """Sleep without letting any other thread of the interpreter run meanwhile."""
        usleep = ctypes.PyDLL(None).usleep
        yield from self._hang(lambda: usleep(round(1e6 * FREEZE_S)))

    def _hang(self, hang: Callable[[], object]) -> Steps:
        """Hang, then let a person re-arm."""
        while True:
            yield 4.0
            begin_s = time.monotonic()
            hang()
            yield 0.5
            self._window.session.rearm()
            yield 0.3
            self.hung.append((begin_s, time.monotonic()))


def main() -> None:
    """Play to the end."""
    clip, force, record, name, seconds = sys.argv[1:]
    device = ("--hand", "firm", "--record", record)
    haptics = with_device_options(*device, descriptors=[int(record)])
    settings, shown = Path(clip).parent / "settings.json", {"fullscreen": True}
    opened = open_window(settings, sound=True, plots=False, haptics=haptics, **shown)
    window, player = opened.window, opened.player
    player.poll()
    window.session.show_source(open_source(clip, force))
    player.play()
    case = Case(window, float(seconds))
    steps, timer = case.of(name), QTimer(singleShot=True)

    def go_on() -> None:
        wait_s = next(steps, None)
        if wait_s is not None:
            timer.start(round(1e3 * wait_s))

    def end() -> None:
        window.close()
        opened.application.quit()

    timer.timeout.connect(go_on)
    timer.start(1500)
    QTimer.singleShot(round(1e3 * (float(seconds) + HELD_S)), end)
    opened.application.exec()
    notices = player.snapshot().notices
    say(**{**player.summary(), "notices": notices, "hung": case.hung})


if __name__ == "__main__":
    main()
