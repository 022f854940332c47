"""A tour of the window: each thing once, in one order, as a person would do it."""

import argparse
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from nuisance import motion_log
from nuisance_beats import Beats
from nuisance_script import AGAIN_S, KEY, LEFT, NO_KEY, Places, Script, Steps
from nuisance_watch import Watch
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QDropEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from app.bridge.places import choose_library
from app.bridge.settings import Settings
from app.experimenter.analysis_window import AnalysisWindow
from app.experimenter.study_editor import StudyEditor
from app.player.application import make_application
from app.player.remake import OpenWindow
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.plots.save_view import save_view
from hapticplayer.clock import SystemClock
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import open_source
from hapticplayer.simulation.demo import demo_folder
from hapticplayer.study.creation import create_study
from hapticplayer.study.study_folder import open_study

ANSWERED, DAMAGED = "answered", "damaged.mp4"
SIZES = ((900, 620), (1240, 700))
NOTCH = 120  # of a wheel
GRACE_S = 0.3
BEAT_MS = 5
LONG_S, SILENT_S = 0.02, 0.03  # a gap that is kept; when its functions are noted


class Tour(Script):
    """Does everything once.

    Attributes:
        opened: holds the window; another look makes a new one.
        failed: what went wrong beside the window.

    Args:
        opened: holds the window that the script uses.
        rest: as a Script takes it, without the window.
        haste: less waits less.
        only: the one thing to do, "" for all.
    """

    def __init__(
        self, opened: OpenWindow, *rest: Any, haste: float, only: str = ""
    ) -> None:
        super().__init__(opened.window, *rest, seed=1, haste=haste)
        self.setParent(None)  # outlives the first window
        self.opened = opened
        self.failed: list[str] = []
        things = self._things()
        chosen = [t for t in things if only in ("", t.__name__.strip("_"))]
        self._left: Iterator[Callable[[], Steps]] = iter(chosen)

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
            QApplication.exit(1)  # nobody would go on with the tour
            raise

    def _shuffled(self) -> list[Callable[[], Steps]]:
        thing = next(self._left, None)
        return [thing or self._end]

    def _end(self) -> Steps:
        QApplication.exit(0)
        yield 1.0

    def _things(self) -> list[Callable[[], Steps]]:
        return [
            self._watch_it,
            self._open_menus,
            self._open_submenus,
            self._seek_by_keys,
            self._click_slider,
            self._drag_slider,
            self._hover_slider,
            self._step_and_loop,
            self._change_speed,
            self._change_volume,
            self._pause,
            self._stop_and_rearm,
            self._zoom_plots,
            self._save_plots,
            self._hide_plots,
            self._hide_grip,
            self._go_round_grip,
            self._show_statistics,
            self._drag_splitter,
            self._resize,
            self._maximise,
            self._minimise,
            self._go_fullscreen,
            self._change_feedback,
            self._change_device,
            self._set_up_device,
            self._get_to_know,
            self._open_sequence_dialog,
            self._open_video_dialog,
            self._open_log_dialog,
            self._import_dialog,
            self._open_library,
            self._tell_keys,
            self._tell_about,
            self._rest_pointer,
            self._open_again,
            self._open_damaged,
            self._drop_video,
            self._open_again,
            self._import,
            self._edit_study,
            self._analyse_study,
            self._go_light,
            self._speak_german,
            self._go_dark,
            self._open_again,
            self._watch_it,
        ]

    # --- playing -------------------------------------------------------------

    def _hover_slider(self) -> Steps:
        slider = self._window.transport.slider
        for k in range(1, 20):
            place = QPoint(slider.width() * k // 20, slider.height() // 2)
            QTest.mouseMove(slider, place)
            yield 0.15

    def _step_and_loop(self) -> Steps:
        for key in (KEY.Key_Period, KEY.Key_Period, KEY.Key_Comma, KEY.Key_L):
            self._key(key)
            yield 0.2
        self._window.player.play()
        yield 0.5
        self._key(KEY.Key_L)
        yield 1.5
        self._key(KEY.Key_L)

    def _change_speed(self) -> Steps:
        for key in (KEY.Key_BracketRight, KEY.Key_BracketLeft, KEY.Key_Backspace):
            self._key(key)
            yield self._haste

    def _change_volume(self) -> Steps:
        for key in (KEY.Key_9, KEY.Key_0, KEY.Key_M, KEY.Key_M):
            self._key(key)
            yield self._haste * 0.5

    def _open_submenus(self) -> Steps:
        bar = self._window.menuBar()
        for entry in bar.actions():
            QTest.mouseClick(bar, LEFT, NO_KEY, bar.actionGeometry(entry).center())
            yield 0.2
            for action in entry.menu().actions():
                if action.menu() is not None:
                    entry.menu().setActiveAction(action)
                    QTest.keyClick(entry.menu(), KEY.Key_Right)
                    yield 0.5
                    action.menu().close()
            entry.menu().close()
            yield 0.1

    # --- plots ---------------------------------------------------------------

    def _zoom_plots(self) -> Steps:
        panel = self._window.plots.panel
        for plot in (panel.acceleration, panel.force):
            for notches in (1, 1, -1, -1, -1, -1, 1, 1):
                _turn_wheel(plot.viewport(), notches)
                yield 0.1
            yield from self._drag(plot.viewport(), self._across(plot.viewport()))
            QTest.mouseDClick(plot.viewport(), LEFT)
            yield 0.1

    def _save_plots(self) -> Steps:
        for kind in ("png", "svg", "csv"):
            path = self._places.scratch / f"view.{kind}"
            problem = save_view(self._window.plots.panel.force, path)
            self.failed += [problem] if problem else []
            yield 0.3

    def _show_statistics(self) -> Steps:
        self._key(KEY.Key_I)
        yield 2 * self._haste
        self._key(KEY.Key_I)

    # --- dialogs -------------------------------------------------------------

    def _open_log_dialog(self) -> Steps:
        self._key(KEY.Key_L, Qt.KeyboardModifier.ControlModifier)
        yield from self._browse()

    def _open_library(self) -> Steps:
        self._window.dialogs.library()
        yield 1.5
        self._close_dialogs()

    def _set_up_device(self) -> Steps:
        self._window.commands.set_up_device.trigger()
        yield 2.0
        self._close_dialogs()
        yield 1.0

    def _get_to_know(self) -> Steps:
        self._window.commands.get_to_know.trigger()
        yield 2.0
        self._close_dialogs()
        yield 1.0

    # --- files ---------------------------------------------------------------

    def _open_damaged(self) -> Steps:
        self._window.session.open_path(self._places.scratch / DAMAGED)
        while self._window.session.jobs.is_busy:
            yield 0.1
        yield 0.5

    def _drop_video(self) -> Steps:
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(self._places.video))])
        event = QDropEvent(QPointF(9, 9), Qt.DropAction.CopyAction, data, LEFT, NO_KEY)
        self._window.dropEvent(event)
        while self._window.session.jobs.is_busy:
            yield 0.1
        yield 1.0

    # --- studies, looks ------------------------------------------------------

    def _edit_study(self) -> Steps:
        study = create_study(self._places.scratch / "study")
        editor = StudyEditor(study, self._window)
        editor.open()
        yield 1.0
        editor.reject()
        editor.deleteLater()

    def _analyse_study(self) -> Steps:
        study = open_study(self._places.scratch / ANSWERED)
        report = AnalysisWindow(study, self._clock, self._window)
        report.begin()
        while report.page.is_busy:
            yield 0.2
        self.failed += filter(None, [report.messages.text()])
        yield 1.0
        report.close()

    def _go_light(self) -> Steps:
        yield from self._remake("look", "light")

    def _go_dark(self) -> Steps:
        yield from self._remake("look", "dark")

    def _speak_german(self) -> Steps:
        yield from self._remake("language", "de")

    def _remake(self, name: str, value: str) -> Steps:
        self._window.settings.keep(name, value)
        self.opened.remake()
        while self.opened.is_remaking:
            yield 0.05
        yield AGAIN_S
        self._window.player.play()
        yield 1.0

    def _close_dialogs(self) -> None:
        for widget in QApplication.topLevelWidgets():
            if isinstance(widget, QDialog) and widget.isVisible():
                widget.reject()


def _turn_wheel(widget: QWidget, notches: int) -> None:
    place = QPointF(widget.rect().center())
    event = QWheelEvent(
        place,
        QPointF(widget.mapToGlobal(place)),
        QPoint(),
        QPoint(0, NOTCH * notches),
        Qt.MouseButton.NoButton,
        NO_KEY,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def use(options: argparse.Namespace) -> int:
    """Run the window with the tour, and write what was seen."""
    folder, demo = Path(options.folder), demo_folder()
    application, clock, surface = make_application(), SystemClock(), VideoSurface()
    audio = None if options.no_sound else SoundProcess
    player = Player(clock, SurfaceSink(surface), audio=audio)
    settings = Settings(folder / "window.json")
    choose_library(settings, demo.parent)
    window = PlayerWindow(player, surface, clock, settings)
    opened = OpenWindow(window)
    whole = (demo / "clip.mp4").read_bytes()
    (folder / DAMAGED).write_bytes(whole[: len(whole) // 2])
    places = Places(demo, demo / "clip.mp4", motion_log(demo, folder), folder)
    watch = Watch(player, GRACE_S)
    more = {"haste": options.haste, "only": options.only}
    tour = Tour(opened, watch, clock, places, **more)
    player.set_device("simulated")
    window.show()
    opened.begin()
    window.session.show_source(open_source(demo))
    player.play()
    beats = Beats(LONG_S, SILENT_S)
    timer = _beating(beats, tour)
    tour.start()
    is_whole = application.exec() == 0
    timer.stop()
    tour.stop()
    beats.end()
    seen = {
        "platform": application.platformName(),
        "sound": player.snapshot().audio,
        "things": tour.done,
        "failed": tour.failed,
        "long_s": LONG_S,
        "gaps_s": beats.gaps_s,
        "long_gaps": beats.long,
    }
    opened.end()
    (folder / "seen.json").write_text(json.dumps(seen))
    return 0 if is_whole else 1


def _beating(beats: Beats, tour: Tour) -> QTimer:
    def beat() -> None:
        beats.doing = tour.doing
        beats.beat()

    timer = QTimer(interval=BEAT_MS, timerType=Qt.TimerType.PreciseTimer)
    timer.timeout.connect(beat)
    timer.start()
    return timer
