"""The real window with the real player, and how regularly its thread is heard."""

import functools
import json
import resource
import sys
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication

from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_process import SoundProcess

LONG_GAP_S = 0.1
SAMPLE_S, SILENT_S = 0.02, 0.06
MOST_SAMPLES, STACK_DEPTH = 10, 10


Haptics = Callable[..., HapticsProcesses]


@dataclass(frozen=True, slots=True)
class Opened:
    """A window that is shown, and what belongs to it."""

    application: QApplication
    clock: SystemClock
    player: Player
    window: PlayerWindow


def open_window(
    settings: Path | None,
    *,
    sound: bool = False,
    plots: bool = True,
    fullscreen: bool = False,
    player: type[Player] = Player,
    haptics: Haptics | None = None,
) -> Opened:
    """Open the player's window with the simulated device.

    Args:
        settings: file of the window's settings.
        sound: whether there is any.
        plots: whether plots are shown.
        fullscreen: whether the window fills the screen.
        player: type of the player, to watch what it does.
        haptics: makes the owner of the haptic loop, see `with_device_options`.
    """
    application, clock, surface = make_application(), SystemClock(), VideoSurface()
    audio = SoundProcess if sound else None
    playing = player(clock, SurfaceSink(surface), audio=audio, haptics=haptics)
    window = PlayerWindow(playing, surface, clock, Settings(settings), plots=plots)
    playing.set_outputs(["simulated"])
    if fullscreen:
        window.enter_fullscreen()
    else:
        window.show()
    return Opened(application, clock, playing, window)


def with_device_options(*options: str, descriptors: Sequence[int] = ()) -> Haptics:
    """A maker of a haptic loop whose simulated device has these options.

    Args:
        options: command line of the process that simulates the device.
        descriptors: that these name.
    """
    return functools.partial(
        HapticsProcesses,
        device_options=list(options),
        device_descriptors=list(descriptors),
    )


def say(**content: object) -> None:
    """Print a line of JSON, at once."""
    sys.stdout.write(json.dumps(content) + "\n")
    sys.stdout.flush()


def run_for(seconds: float) -> None:
    """Let the event loop run for a while."""
    loop = QEventLoop()
    QTimer.singleShot(round(1e3 * seconds), loop.quit)
    loop.exec()


class Beats:
    """Gaps between the beats of a thread, and what it did in the long ones.

    Args:
        long_s: of longer gaps everything is kept.
        silent_s: after so long the thread's functions are noted.

    Attributes:
        gaps_s: all so far.
        long: of the long ones begin, share of computing and waiting, and functions.
        doing: what the script does, for the long ones.
    """

    def __init__(self, long_s: float = LONG_GAP_S, silent_s: float = SILENT_S) -> None:
        self._long_s, self._silent_s = long_s, silent_s
        self.gaps_s: list[float] = []
        self.long: list[dict[str, Any]] = []
        self.doing = ""
        self._last_s, self._before, self._faults = 0.0, (0.0, 0.0), 0
        self._account = Path(f"/proc/self/task/{threading.get_native_id()}/schedstat")
        self._watched = threading.get_ident()
        self._stacks: list[dict[str, Any]] = []
        self._is_over = threading.Event()
        self._sampler = threading.Thread(target=self._sample, daemon=True)
        self._sampler.start()

    def beat(self) -> None:
        """Note that the thread runs."""
        now_s = time.monotonic()
        ran_ns, waited_ns, _ = map(int, self._account.read_text().split())
        used = 1e-9 * ran_ns, 1e-9 * waited_ns
        faults = resource.getrusage(resource.RUSAGE_SELF).ru_majflt
        gap_s = now_s - self._last_s if self._last_s else 0.0
        self.gaps_s.append(gap_s)
        if gap_s > self._long_s:
            computed_s, waited_s = np.subtract(used, self._before)
            gap = {"begin_s": self._last_s, "gap_s": gap_s, "doing": self.doing}
            gap |= {"computed_s": float(computed_s), "waited_s": float(waited_s)}
            gap |= {"disk_waits": faults - self._faults, "stacks": self._stacks}
            self.long.append(gap)
        self._last_s, self._before, self._stacks = now_s, used, []
        self._faults = faults

    def end(self) -> None:
        """End the thread that notes functions."""
        self._is_over.set()
        self._sampler.join()

    def _sample(self) -> None:
        while not self._is_over.wait(SAMPLE_S):
            after_s = time.monotonic() - self._last_s
            if after_s > self._silent_s and len(self._stacks) < MOST_SAMPLES:
                stack = _stack_of(self._watched)
                self._stacks.append({"after_s": after_s, "functions": stack})


def _stack_of(thread: int) -> list[str]:
    """Return the innermost functions of a thread.

    In microseconds: while a frame is held its locals live on, and a painter that
    outlives its paintEvent brings Qt down.
    """
    frame, places = sys._current_frames().get(thread), []  # noqa: SLF001
    while frame is not None and len(places) < STACK_DEPTH:
        places.append((frame.f_code, frame.f_lineno))
        frame = frame.f_back
    return [f"{Path(c.co_filename).name}:{line} {c.co_name}" for c, line in places]
