"""How long the window's event loop is away, in a tour of everything a person does.

A timer of 5 ms beats in the real window, on a screen of its own with sound and the
simulated device. A gap is the time between two beats; for the longest of each step of
the tour, the functions the window's thread was in are shown. Judged is the whole gap,
also the time in which that thread could have run but others had the cores.
"""

import argparse
import json
import subprocess
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from app.bridge.settings import choose_library
from app.experimenter.study.editor import StudyEditor
from app.player.remake import OpenWindow
from app.player.window import PlayerWindow
from benchmarks.common import ROOT, Report
from benchmarks.person import KEY, LEFT, NO_KEY, REARM_WAIT_S, Person, Steps
from benchmarks.robustness.nuisance import stage
from benchmarks.window import Beats, open_window
from hapticplayer.playback.source import open_source
from hapticplayer.study.creation import create_study

LIMIT_MS = 50.0
SHOWN = 14
LONGEST_S = 900.0
NOTCH = 120  # of a wheel
BEAT_MS = 5
LONG_S, SILENT_S = 0.02, 0.03  # a gap that is kept; when its functions are noted
TOUR = (
    "watch", "open_menus", "seek_by_keys", "click_slider", "drag_slider", "pause",
    "stop_and_rearm", "zoom_plots", "hide_plots", "hide_grip", "turn_grip",
    "show_statistics", "drag_splitter", "resize", "maximise", "minimise", "fullscreen",
    "change_feedback", "change_device", "set_up_device", "get_to_know",
    "browse_sequences", "browse_videos", "type_import", "open_library", "show_keys",
    "show_about", "rest_pointer", "open_again", "open_again", "import_video",
    "edit_study", "use_light_theme", "use_german", "use_dark_theme", "open_again",
    "watch",
)  # fmt: skip


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--offscreen", action="store_true")
    parser.add_argument("--no-sound", action="store_true")
    parser.add_argument("--haste", type=float, default=0.4)
    parser.add_argument("--only", nargs="+", default=[], choices=sorted(set(TOUR)))


def run(options: argparse.Namespace, report: Report) -> None:
    """Take the tour in a process of its own, and judge the gaps."""
    steps = options.only or (TOUR[:12] if options.quick else TOUR)
    place = stage(is_offscreen=options.offscreen, has_sound=not options.no_sound)
    with place as (folder, environment):
        command = [sys.executable, "-m", "benchmarks.playback.window", str(folder)]
        command += [str(int(not options.no_sound)), str(options.haste), *steps]
        subprocess.run(
            command, env=environment, cwd=ROOT, check=True, timeout=LONGEST_S
        )
        seen = json.loads((folder / "seen.json").read_text())
    judge(seen, report)


def judge(seen: dict[str, Any], report: Report) -> None:
    """Show the gaps, and the longest of each step."""
    gaps_ms = 1e3 * np.array(seen["gaps_s"])
    worst: dict[str, dict[str, Any]] = {}
    for gap in seen["long_gaps"]:
        gap["own_s"] = max(0.0, gap["gap_s"] - gap["waited_s"])
        name = gap["doing"] or "begin"
        if gap["gap_s"] > worst.get(name, {"gap_s": 0.0})["gap_s"]:
            worst[name] = gap
    own_ms = np.append(
        gaps_ms[gaps_ms <= 1e3 * LONG_S], [1e3 * g["own_s"] for g in seen["long_gaps"]]
    )
    rows = []
    for name, values in (("all gaps", gaps_ms), ("without waiting for a core", own_ms)):
        quantiles = np.quantile(values, (0.5, 0.99, 0.999, 1.0)).tolist()
        rows.append([name, len(values), *quantiles, int(np.sum(values > LIMIT_MS))])
    header = ["ms", "n", "p50", "p99", "p99.9", "longest", f"above {LIMIT_MS:g}"]
    report.table("Gaps of the event loop", header, rows)
    longest = sorted(worst.items(), key=lambda item: -item[1]["gap_s"])
    cells = [
        [name, 1e3 * gap["gap_s"], 1e3 * gap["own_s"], _where(gap["stacks"])]
        for name, gap in longest[:SHOWN]
    ]
    report.table("Longest", ["step", "gap ms", "own ms", "in"], cells)
    report.target("gaps, p99.9 ms", rows[0][4], ("<=", LIMIT_MS))
    report.figures |= {"columns": header, "rows": rows, "longest": cells}


def _where(stacks: list[dict[str, Any]]) -> str:
    """Return the functions that most samples were in."""
    counts: defaultdict[str, int] = defaultdict(int)
    for stack in stacks:
        counts[" < ".join(stack["functions"][:4])] += 1
    return max(counts, key=counts.__getitem__) if counts else ""


class Tour(Person):
    """Does each thing once, in one order.

    Attributes:
        opened: holds the window; another theme or language makes a new one.
    """

    def __init__(self, opened: OpenWindow, folder: Path, haste: float) -> None:
        super().__init__(opened.window, folder, haste=haste)
        self.setParent(None)  # outlives the first window
        self.opened = opened
        self.left: Iterator[str] = iter(())

    @property
    def _window(self) -> PlayerWindow:
        return self.opened.window

    @_window.setter
    def _window(self, _window: PlayerWindow) -> None:
        """Whichever is open is used."""

    def _go_on(self) -> None:
        try:
            super()._go_on()
        except Exception:
            QApplication.exit(1)  # the tour cannot continue
            raise

    def deck(self) -> list[Callable[[], Steps]]:
        return [getattr(self, next(self.left, "_end"))]

    def _end(self) -> Steps:
        QApplication.exit(0)
        yield 1.0

    def zoom_plots(self) -> Steps:
        """Zoom and move both plots."""
        self._window.plots.prepare()
        panel = self._window.plots.panel
        for plot in (panel.acceleration, panel.force):
            for notches in (1, 1, -1, -1, -1, -1, 1, 1):
                _turn_wheel(plot.viewport(), notches)
                yield 0.1
            yield from self.drag(plot.viewport(), self.across(plot.viewport()))
            QTest.mouseDClick(plot.viewport(), LEFT)
            yield 0.1

    def show_statistics(self) -> Steps:
        yield from self.twice(KEY.Key_I, 2.0)

    def open_library(self) -> Steps:
        yield from self.dialog(self._window.dialogs.library, 1.5)

    def set_up_device(self) -> Steps:
        yield from self.dialog(self._window.commands.set_up_device.trigger, 2.0)

    def get_to_know(self) -> Steps:
        """Look at the demonstration of forces."""
        yield from self.dialog(self._window.commands.get_to_know.trigger, 2.0)

    def edit_study(self) -> Steps:
        """Look at a new study."""
        editor = StudyEditor(
            create_study(self.folder / "study").folder,
            lambda: self.folder,
            self._window,
        )
        editor.open()
        yield 1.0
        editor.reject()
        editor.deleteLater()

    def use_light_theme(self) -> Steps:
        yield from self._remake("look", "light")

    def use_dark_theme(self) -> Steps:
        yield from self._remake("look", "dark")

    def use_german(self) -> Steps:
        """Choose another language."""
        yield from self._remake("language", "de")

    def _remake(self, name: str, value: str) -> Steps:
        self._window.settings.keep(name, value)
        self.opened.remake()
        while self.opened.is_remaking:
            yield 0.05
        yield REARM_WAIT_S
        self._window.player.play()
        yield 1.0

    def close_dialogs(self) -> None:
        """Leave every dialog of any window."""
        for widget in QApplication.topLevelWidgets():
            if isinstance(widget, QDialog) and widget.isVisible():
                widget.reject()


def _turn_wheel(widget: QWidget, notches: int) -> None:
    place, still = QPointF(widget.rect().center()), Qt.ScrollPhase.NoScrollPhase
    event = QWheelEvent(
        place,
        QPointF(widget.mapToGlobal(place)),
        QPoint(),
        QPoint(0, NOTCH * notches),
        Qt.MouseButton.NoButton,
        NO_KEY,
        still,
        False,
    )
    QApplication.sendEvent(widget, event)


def _take_the_tour(
    folder: Path, has_sound: bool, haste: float, steps: list[str]
) -> int:
    """Run the window with the tour, and write what was seen."""
    shown = open_window(folder / "window.json", sound=has_sound)
    window, player = shown.window, shown.player
    opened = OpenWindow(window)
    tour = Tour(opened, folder, haste)
    tour.left = iter(steps)
    choose_library(window.settings, tour.sequence.parent)
    opened.begin()
    window.session.show_source(open_source(tour.sequence))
    player.play()
    beats = Beats(LONG_S, SILENT_S)

    def beat() -> None:
        beats.doing = tour.doing
        beats.beat()

    timer = QTimer(interval=BEAT_MS, timerType=Qt.TimerType.PreciseTimer)
    timer.timeout.connect(beat)
    timer.start()
    tour.start()
    is_whole = shown.application.exec() == 0
    timer.stop()
    tour.stop()
    beats.end()
    seen = {"gaps_s": beats.gaps_s, "long_gaps": beats.long}
    opened.end()
    (folder / "seen.json").write_text(json.dumps(seen))
    return 0 if is_whole else 1


if __name__ == "__main__":
    name, sound, haste_text, *chosen = sys.argv[1:]
    sys.exit(_take_the_tour(Path(name), bool(int(sound)), float(haste_text), chosen))
