"""A scripted person who uses everything the window has, in any order.

Each thing a person does is a generator that does a part and yields how long the person
waits, s, until the next. Mouse and keys go through Qt as those of a window system do.
"""

import random
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QDialog, QFileDialog, QSplitter, QWidget

from app.bridge.jobs import in_child
from app.experimenter.import_wizard import ImportWizard
from app.player.window import PlayerWindow
from hapticplayer.errors import Progress
from hapticplayer.haptics.contract import Cause
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.synchronizing import SyncChoices
from hapticplayer.sequence.unpack import unpack
from hapticplayer.shipped import DEMO

Steps = Iterator[float]
KEY, NO_KEY, LEFT = Qt.Key, Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier
CHECK_MS = 500
REARM_WAIT_S = 0.3
SIZES = ((780, 640), (900, 620), (1000, 700), (1280, 720), (1100, 560))
LOADED_AGAIN = (Cause.PAUSED, Cause.NO_TRACK, Cause.SEEK)
SOUGHT = (Cause.SEEK, Cause.PAUSED)


class Person(QObject):
    """Uses a window until it is stopped; the demo is what it opens.

    Attributes:
        done: how often each thing was done.
        doing: what is being done.
        shown: messages of the window meanwhile.
        only: the one thing to do, "" for all.
        on_action: called with the name of an action and the causes for which the
            haptic loop may react to it.
        on_check: called twice a second, and before a device is let go of.

    Args:
        window: shown, with a device.
        folder: for what is imported.
        seed: the same seed gives the same order.
        haste: 1 for a person; less waits less between two things.
    """

    def __init__(
        self, window: PlayerWindow, folder: Path, seed: int = 1, haste: float = 1.0
    ) -> None:
        super().__init__(window)
        self.done: dict[str, int] = {}
        self.shown: list[str] = []
        self.doing = self.only = ""
        self.on_action: Callable[..., None] = lambda _name, *_causes: None
        self.on_check: Callable[[], None] = lambda: None
        self.sequence = folder / "demo"
        unpack(DEMO, self.sequence)
        self.video, self.folder = open_sequence(self.sequence).clip, folder
        self._window, self._haste = window, haste
        self._dice = random.Random(seed)  # noqa: S311 - chance, not secrecy
        self._steps: Steps = iter(())
        self._deck: list[Callable[[], Steps]] = []
        self._imports = 0
        self._next = QTimer(self, singleShot=True, timeout=self._go_on)
        self._check = QTimer(self, interval=CHECK_MS, timeout=self._look_after)
        window.session.opening.connect(lambda _: self.on_action("open", *LOADED_AGAIN))

    def start(self) -> None:
        """Begin; the first thing comes when the event loop runs."""
        self._check.start()
        self._next.start(0)

    def stop(self) -> None:
        """Do no more."""
        self._next.stop()
        self._check.stop()
        self.on_check()

    def _go_on(self) -> None:
        wait_s = next(self._steps, None)
        if wait_s is None:
            self.doing = ""
            if not self._deck:
                self._deck = self.deck()
            thing = self._deck.pop()
            self.doing = thing.__name__.strip("_")
            self.done[self.doing] = self.done.get(self.doing, 0) + 1
            self._steps = thing()
            wait_s = self._haste * self._dice.uniform(0.3, 2.0)
        self._next.start(max(1, round(1e3 * wait_s)))

    def deck(self) -> list[Callable[[], Steps]]:
        """The tasks that come next, the last one first."""
        if self.only:
            return [getattr(self, self.only)]
        things = [self.watch] * 6
        things += [self.seek_by_keys, self.click_slider, self.drag_slider]
        things += [self.open_menus, self.browse_sequences, self.browse_videos]
        things += [self.type_import, self.show_keys, self.show_about]
        things += [self.resize, self.maximise, self.minimise, self.fullscreen]
        things += [self.hide_plots, self.hide_grip, self.turn_grip]
        things += [self.drag_splitter, self.change_feedback, self.change_device]
        things += [self.pause, self.stop_and_rearm, self.open_again]
        things += [self.drag_window, self.rest_pointer]
        if self._imports < 1 or self._dice.random() < 0.2:
            things.append(self.import_video)
        self._dice.shuffle(things)
        return things

    def _look_after(self) -> None:
        """Play on, as a person would who wants to feel it."""
        self.on_check()
        window, player = self._window, self._window.player
        text = window.messages.text()
        if text and text not in self.shown:
            self.shown.append(text)
        if self.doing in ("pause", "stop_and_rearm", "change_device"):
            return
        if player.snapshot().source is None:
            return
        if window.session.is_stopped:
            window.session.rearm()
        if not player.snapshot().is_playing:
            player.play()

    # --- hands ---------------------------------------------------------------

    def key(self, *keys: Qt.Key, modifier: Qt.KeyboardModifier = NO_KEY) -> None:
        for key in keys:
            QTest.keyClick(self._window.windowHandle(), key, modifier)

    def drag(self, widget: QWidget, path: list[QPoint]) -> Steps:
        """Drag along a path."""
        QTest.mousePress(widget, LEFT, NO_KEY, path[0])
        for point in path[1:]:
            yield 0.016
            QTest.mouseMove(widget, point)
        yield 0.05
        QTest.mouseRelease(widget, LEFT, NO_KEY, path[-1])

    def across(self, widget: QWidget, steps: int = 20) -> list[QPoint]:
        """Return a straight way between two places of a widget."""
        dice, box = self._dice, widget.rect()
        begin, end = (
            QPoint(dice.randint(2, box.width() - 2), dice.randint(2, box.height() - 2))
            for _ in range(2)
        )
        return [begin + (end - begin) * k / steps for k in range(steps + 1)]

    def close_dialogs(self) -> None:
        """Leave every dialog."""
        for dialog in self._window.findChildren(QDialog):
            if dialog.isVisible():
                dialog.reject()

    def jobs(self) -> Steps:
        """Wait until the window is not busy."""
        while self._window.session.jobs.is_busy:
            yield 0.1

    def twice(self, key: Qt.Key, wait_s: float) -> Steps:
        """Press a key, wait, and press it again."""
        self.key(key)
        yield self._haste * wait_s
        self.key(key)

    # --- things: playing -----------------------------------------------------

    def watch(self) -> Steps:
        """Do nothing."""
        yield self._haste * self._dice.uniform(2.0, 5.0)

    def click_slider(self) -> Steps:
        """Seek by a click."""
        slider = self._window.transport.slider
        self.on_action("seek", *SOUGHT)
        QTest.mouseClick(slider, LEFT, NO_KEY, self.across(slider)[0])
        yield 0.1

    def drag_slider(self) -> Steps:
        """Scrub."""
        slider = self._window.transport.slider
        for wait_s in self.drag(slider, self.across(slider)):
            self.on_action("scrub", *SOUGHT)
            yield wait_s
        self.on_action("scrub", *SOUGHT)

    def seek_by_keys(self) -> Steps:
        """Seek three times."""
        keys, weights = (KEY.Key_Left, KEY.Key_Right, KEY.Key_Home), (4, 4, 1)
        for key in self._dice.choices(keys, weights, k=3):
            self.on_action("seek", *SOUGHT)
            self.key(key)
            yield self._haste * self._dice.uniform(0.2, 1.0)

    def pause(self) -> Steps:
        """Pause for a while."""
        self.on_action("pause", Cause.PAUSED)
        self.key(KEY.Key_Space)
        yield self._haste
        self._window.player.play()

    def stop_and_rearm(self) -> Steps:
        """Stop the force, and re-arm."""
        self.on_action("stop", Cause.STOPPED)
        self._window.transport.stop.click()
        yield self._haste
        self._window.session.rearm()
        yield REARM_WAIT_S
        self._window.player.play()

    def choose(self, combo: QComboBox, row: int) -> Steps:
        """Choose an entry of a list."""
        combo.showPopup()
        yield self._haste * 0.5
        combo.hidePopup()
        combo.setCurrentIndex(row)
        combo.activated.emit(row)

    def change_feedback(self) -> Steps:
        """Feel another feedback, and the realistic one again."""
        combo = self._window.transport.feedback
        for row in (self._dice.randrange(combo.count()), combo.findData("realistic")):
            for wait_s in self.choose(combo, row):
                yield wait_s
                self.on_action("feedback", *LOADED_AGAIN)
            yield self._haste

    def change_device(self) -> Steps:
        """Let go of the device, and take it again."""
        combo = self._window.transport.device
        for name in ("none", "simulated"):
            for wait_s in self.choose(combo, combo.findData(name)):
                yield wait_s
                self.on_check()
                self.on_action("device", Cause.CLOSING)
            yield self._haste
        while self._window.player.snapshot().leading.tick is None:
            yield 0.1

    # --- things: the window --------------------------------------------------

    def open_menus(self) -> Steps:
        """Go through the menus."""
        bar = self._window.menuBar()
        for action in bar.actions():
            QTest.mouseClick(bar, LEFT, NO_KEY, bar.actionGeometry(action).center())
            yield self._haste * 0.5
            menu = action.menu()
            for _ in range(3):
                QTest.keyClick(menu, KEY.Key_Down)
                yield self._haste * 0.1
            menu.close()
            yield 0.1

    def show_keys(self) -> Steps:
        """Read the list of keys."""
        yield from self.dialog(lambda: self.key(KEY.Key_F1), self._haste)

    def show_about(self) -> Steps:
        """Read what this program is."""
        yield from self.dialog(self._window.commands.about.trigger, self._haste)

    def dialog(self, open_it: Callable[[], object], wait_s: float) -> Steps:
        """Open a dialog, read it, and close it."""
        open_it()
        yield wait_s
        self.close_dialogs()
        yield 0.3

    def resize(self) -> Steps:
        """Drag an edge of the window."""
        wide, high = self._dice.choice(SIZES)
        size = self._window.size()
        for k in range(1, 16):
            self._window.resize(
                size.width() + (wide - size.width()) * k // 15,
                size.height() + (high - size.height()) * k // 15,
            )
            yield 0.016

    def drag_window(self) -> Steps:
        """Move the window."""
        for k in range(15):
            self._window.move(4 * k, 3 * k)
            yield 0.016
        self._window.move(0, 0)

    def maximise(self) -> Steps:
        """Make the window as large as the screen."""
        self._window.showMaximized()
        yield self._haste
        self._window.showNormal()

    def minimise(self) -> Steps:
        """Put the window away for a moment."""
        self._window.showMinimized()
        yield self._haste
        self._window.showNormal()
        self._window.activateWindow()

    def fullscreen(self) -> Steps:
        """See nothing but the clip."""
        yield from self.twice(KEY.Key_F, 1.5)

    def hide_plots(self) -> Steps:
        yield from self.twice(KEY.Key_P, 1.0)

    def hide_grip(self) -> Steps:
        yield from self.twice(KEY.Key_G, 0.7)

    def turn_grip(self) -> Steps:
        """See the grip from somewhere else."""
        panel = self._window.plots.panel
        if panel is None or not panel.grip.isVisible():
            return
        yield from self.drag(panel.grip, self.across(panel.grip, 40))
        QTest.mouseDClick(panel.grip, LEFT)

    def drag_splitter(self) -> Steps:
        """Give the plots more room, and less."""
        handle = self._window.findChild(QSplitter).handle(1)
        middle = handle.rect().center()
        up = [middle - QPoint(0, 4 * k) for k in range(15)]
        yield from self.drag(handle, up)
        yield 0.3
        yield from self.drag(handle, [middle + QPoint(0, 4 * k) for k in range(15)])

    def rest_pointer(self) -> Steps:
        """Stay over a control until it tells what it is for."""
        transport = self._window.transport
        for widget in (transport.play, transport.feedback, self._window.health):
            QTest.mouseMove(widget)
            yield self._haste

    # --- things: files -------------------------------------------------------

    def browse_sequences(self) -> Steps:
        """Look for a sequence, and open none."""
        self.key(KEY.Key_O, modifier=CONTROL)
        yield from self.browse()

    def browse_videos(self) -> Steps:
        """Look for a video, and open none."""
        self.key(KEY.Key_O, modifier=CONTROL | Qt.KeyboardModifier.ShiftModifier)
        yield from self.browse()

    def browse(self) -> Steps:
        """Look into folders."""
        yield self._haste * 0.7
        for dialog in self._window.findChildren(QFileDialog):
            for folder in ("/usr/lib", "/usr/share", str(Path.home())):
                dialog.setDirectory(folder)
                yield self._haste * 0.4
        self.close_dialogs()

    def type_import(self) -> Steps:
        """Begin an import by typing a path, and leave it."""
        self.key(KEY.Key_I, modifier=CONTROL)
        yield self._haste * 0.5
        for dialog in self._window.findChildren(ImportWizard):
            for letter in str(self.video):
                QTest.keyClicks(dialog.files.video, letter)
                yield 0.03
            yield self._haste * 0.5
        self.close_dialogs()

    def import_video(self) -> Steps:
        """Import for good: the sequence is made, and then opened."""
        session = self._window.session
        if session.jobs.is_busy:
            return
        self._imports += 1
        target, log = self.folder / f"imported-{self._imports}", self._motion_log()

        def work(progress: Progress) -> object:
            choices = Choices(sync=SyncChoices(offset_s=0.0))
            given = {"imu_log": log, "choices": choices, "progress": progress}
            return in_child(build_sequence, self.video, target, **given)

        session.jobs.run("importing", work, session.open_path)
        yield from self.jobs()

    def _motion_log(self) -> Path:
        """Write the demo's motion as a CSV that can be imported."""
        path = self.folder / "imu.csv"
        with np.load(self.sequence / "imu.npz") as imu:
            names = ("time_s", "specific_force_mps2", "angular_rate_radps")
            rows = np.column_stack([imu[name] for name in names])
        header = "time_s,ax,ay,az,gx,gy,gz"
        np.savetxt(path, rows, "%.6f", delimiter=",", header=header, comments="")
        return path

    def open_again(self) -> Steps:
        if not self._window.session.jobs.is_busy:
            self._window.session.open_path(self.sequence)
            yield from self.jobs()
