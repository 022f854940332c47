"""Normal use of the window by a person who is not there: everything, in any order.

Each thing a person does is a generator that does a part and yields how long the person
waits, s, until the next. Mouse and keys go through Qt as those of a window system do.
"""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from nuisance_watch import Watch
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QDialog, QFileDialog, QSplitter, QWidget

from app.bridge.child import in_child
from app.experimenter.import_wizard import ImportWizard
from app.player.window import PlayerWindow
from hapticplayer.clock import Clock
from hapticplayer.haptics.contract import Cause
from hapticplayer.sequence import build_sequence

Steps = Iterator[float]
KEY, NO_KEY, LEFT = Qt.Key, Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
LOOK_MS = 500
AGAIN_S = 0.3
SIZES = ((780, 640), (900, 620), (1000, 700), (1280, 720), (1100, 560))


@dataclass(frozen=True, slots=True)
class Places:
    """What the script may open.

    Attributes:
        sequence: a folder with force.
        video: a clip.
        imu_log: its motion.
        scratch: a folder for what is imported.
    """

    sequence: Path
    video: Path
    imu_log: Path
    scratch: Path


class Script(QObject):
    """Uses a window until it is told to stop.

    Attributes:
        done: how often each thing was done.
        doing: what is being done.
        told: what the window has told meanwhile.
        only: the one thing to do, "" for all.

    Args:
        window: shown, with a device.
        watch: told of what the loop has to react to.
        clock: of the machine.
        places: what is opened.
        seed: the same seed gives the same order.
        haste: 1 for a person; less waits less between two things.
    """

    def __init__(
        self,
        window: PlayerWindow,
        watch: Watch,
        clock: Clock,
        places: Places,
        seed: int,
        haste: float = 1.0,
    ) -> None:
        super().__init__(window)
        self.done: dict[str, int] = {}
        self.told: list[str] = []
        self.doing = ""
        self.only = ""
        self._window, self._watch, self._clock = window, watch, clock
        self._places, self._haste = places, haste
        self._dice = random.Random(seed)  # noqa: S311 - chance, not secrecy
        self._steps: Steps = iter(())
        self._deck: list[Callable[[], Steps]] = []
        self._imports = 0
        self._turn = QTimer(self, singleShot=True, timeout=self._go_on)
        self._look = QTimer(self, interval=LOOK_MS, timeout=self._look_after)
        session = window.session
        session.opening.connect(
            lambda _: self._expect("open", Cause.PAUSED, Cause.NO_TRACK, Cause.SEEK)
        )

    def start(self) -> None:
        """Begin; the first thing comes when the event loop runs."""
        self._look.start()
        self._turn.start(0)

    def stop(self) -> None:
        """Do no more."""
        self._turn.stop()
        self._look.stop()
        self._watch.look()

    def _go_on(self) -> None:
        wait_s = next(self._steps, None)
        if wait_s is None:
            self.doing = ""
            if not self._deck:
                self._deck = self._shuffled()
            thing = self._deck.pop()
            self.doing = thing.__name__.strip("_")
            self._watch.doing.append((self._clock.now_s(), self.doing))
            self.done[self.doing] = self.done.get(self.doing, 0) + 1
            self._steps = thing()
            wait_s = self._haste * self._dice.uniform(0.3, 2.0)
        self._turn.start(max(1, round(1e3 * wait_s)))

    def _shuffled(self) -> list[Callable[[], Steps]]:
        things = [
            *[self._watch_it] * 6,
            self._seek_by_keys,
            self._drag_slider,
            self._open_menus,
            self._open_sequence_dialog,
            self._open_video_dialog,
            self._import_dialog,
            self._tell_keys,
            self._tell_about,
            self._click_slider,
            self._resize,
            self._maximise,
            self._minimise,
            self._go_fullscreen,
            self._hide_plots,
            self._hide_grip,
            self._go_round_grip,
            self._drag_splitter,
            self._change_feedback,
            self._change_device,
            self._pause,
            self._stop_and_rearm,
            self._open_again,
            self._drag_window,
            self._rest_pointer,
        ]
        if self.only:
            return [getattr(self, f"_{self.only}")]
        if self._imports < 1 or self._dice.random() < 0.2:
            things.append(self._import)
        self._dice.shuffle(things)
        return things

    def _look_after(self) -> None:
        """See what the loop did; play on, as a person would who wants to feel it."""
        self._watch.look()
        window, player = self._window, self._window.player
        text = window.messages.text()
        if text and text not in self.told:
            self.told.append(text)
        is_ours = self.doing in ("pause", "stop_and_rearm", "change_device")
        if is_ours or player.snapshot().source is None:
            return
        if window.session.is_stopped:
            window.session.rearm()
        if not player.snapshot().is_playing:
            player.play()

    def _expect(self, name: str, *causes: Cause) -> None:
        self._watch.expect(self._clock.now_s(), name, *causes)

    # --- hands ---------------------------------------------------------------

    def _key(self, key: Qt.Key, modifier: Qt.KeyboardModifier = NO_KEY) -> None:
        handle = self._window.windowHandle()
        QTest.keyClick(handle, key, modifier)

    def _drag(self, widget: QWidget, path: list[QPoint]) -> Steps:
        QTest.mousePress(widget, LEFT, NO_KEY, path[0])
        for point in path[1:]:
            yield 0.016
            QTest.mouseMove(widget, point)
        yield 0.05
        QTest.mouseRelease(widget, LEFT, NO_KEY, path[-1])

    def _across(self, widget: QWidget, steps: int = 20) -> list[QPoint]:
        dice, box = self._dice, widget.rect()
        begin, end = (
            QPoint(dice.randint(2, box.width() - 2), dice.randint(2, box.height() - 2))
            for _ in range(2)
        )
        return [begin + (end - begin) * k / steps for k in range(steps + 1)]

    def _close_dialogs(self) -> None:
        for dialog in self._window.findChildren(QDialog):
            if dialog.isVisible():
                dialog.reject()

    # --- things --------------------------------------------------------------

    def _watch_it(self) -> Steps:
        yield self._haste * self._dice.uniform(2.0, 5.0)

    def _open_menus(self) -> Steps:
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

    def _open_sequence_dialog(self) -> Steps:
        self._key(KEY.Key_O, Qt.KeyboardModifier.ControlModifier)
        yield from self._browse()

    def _open_video_dialog(self) -> Steps:
        control = Qt.KeyboardModifier.ControlModifier
        self._key(KEY.Key_O, control | Qt.KeyboardModifier.ShiftModifier)
        yield from self._browse()

    def _browse(self) -> Steps:
        yield self._haste * 0.7
        for dialog in self._window.findChildren(QFileDialog):
            for folder in ("/usr/lib", "/usr/share", str(Path.home())):
                dialog.setDirectory(folder)
                yield self._haste * 0.4
        self._close_dialogs()

    def _import_dialog(self) -> Steps:
        self._key(KEY.Key_I, Qt.KeyboardModifier.ControlModifier)
        yield self._haste * 0.5
        for dialog in self._window.findChildren(ImportWizard):
            for letter in str(self._places.video):
                QTest.keyClicks(dialog.files.video, letter)
                yield 0.03
            yield self._haste * 0.5
        self._close_dialogs()

    def _import(self) -> Steps:
        """Import for good: the sequence is made in a thread, and then opened."""
        session = self._window.session
        if session.jobs.is_busy:
            return
        self._imports += 1
        places = self._places
        target = places.scratch / f"imported-{self._imports}"
        session.jobs.run(
            "importing",
            lambda told: in_child(
                build_sequence,
                places.video,
                target,
                imu_log=places.imu_log,
                offset_s=0.0,
                progress=told,
            ),
            session.open_path,
        )
        while session.jobs.is_busy:
            yield 0.2

    def _tell_keys(self) -> Steps:
        self._key(KEY.Key_F1)
        yield self._haste
        self._close_dialogs()

    def _tell_about(self) -> Steps:
        self._window.commands.about.trigger()
        yield self._haste
        self._close_dialogs()

    def _click_slider(self) -> Steps:
        slider = self._window.transport.slider
        self._expect("seek", Cause.SEEK, Cause.PAUSED)
        QTest.mouseClick(slider, LEFT, NO_KEY, self._across(slider)[0])
        yield 0.1

    def _drag_slider(self) -> Steps:
        slider = self._window.transport.slider
        for wait_s in self._drag(slider, self._across(slider)):
            self._expect("scrub", Cause.SEEK, Cause.PAUSED)
            yield wait_s
        self._expect("scrub", Cause.SEEK, Cause.PAUSED)

    def _seek_by_keys(self) -> Steps:
        for key in self._dice.choices(
            (KEY.Key_Left, KEY.Key_Right, KEY.Key_Home), (4, 4, 1), k=3
        ):
            self._expect("seek", Cause.SEEK, Cause.PAUSED)
            self._key(key)
            yield self._haste * self._dice.uniform(0.2, 1.0)

    def _resize(self) -> Steps:
        wide, high = self._dice.choice(SIZES)
        size = self._window.size()
        for k in range(1, 16):
            self._window.resize(
                size.width() + (wide - size.width()) * k // 15,
                size.height() + (high - size.height()) * k // 15,
            )
            yield 0.016

    def _maximise(self) -> Steps:
        self._window.showMaximized()
        yield self._haste
        self._window.showNormal()

    def _minimise(self) -> Steps:
        self._window.showMinimized()
        yield self._haste
        self._window.showNormal()
        self._window.activateWindow()

    def _go_fullscreen(self) -> Steps:
        self._key(KEY.Key_F)
        yield self._haste * 1.5
        self._key(KEY.Key_F)

    def _hide_plots(self) -> Steps:
        self._key(KEY.Key_P)
        yield self._haste
        self._key(KEY.Key_P)

    def _hide_grip(self) -> Steps:
        self._key(KEY.Key_G)
        yield self._haste * 0.7
        self._key(KEY.Key_G)

    def _go_round_grip(self) -> Steps:
        panel = self._window.plots.panel
        if panel is None or not panel.grip.isVisible():
            return
        yield from self._drag(panel.grip, self._across(panel.grip, 40))
        QTest.mouseDClick(panel.grip, LEFT)

    def _drag_splitter(self) -> Steps:
        handle = self._window.findChild(QSplitter).handle(1)
        middle = handle.rect().center()
        up = [middle - QPoint(0, 4 * k) for k in range(15)]
        yield from self._drag(handle, up)
        yield 0.3
        yield from self._drag(handle, [middle + QPoint(0, 4 * k) for k in range(15)])

    def _choose(self, combo: QComboBox, row: int) -> Steps:
        combo.showPopup()
        yield self._haste * 0.5
        combo.hidePopup()
        combo.setCurrentIndex(row)
        combo.activated.emit(row)

    def _change_feedback(self) -> Steps:
        combo = self._window.transport.feedback
        for row in (self._dice.randrange(combo.count()), combo.findData("realistic")):
            causes = (Cause.SEEK, Cause.PAUSED, Cause.NO_TRACK)
            for wait_s in self._choose(combo, row):
                yield wait_s
                self._expect("feedback", *causes)
            yield self._haste

    def _change_device(self) -> Steps:
        combo = self._window.transport.device
        for name in ("none", "simulated"):
            for wait_s in self._choose(combo, combo.findData(name)):
                yield wait_s
                self._watch.look()
                self._expect("device", Cause.CLOSING)
            yield self._haste
        while self._window.player.snapshot().tick is None:
            yield 0.1

    def _pause(self) -> Steps:
        self._expect("pause", Cause.PAUSED)
        self._key(KEY.Key_Space)
        yield self._haste
        self._window.player.play()

    def _stop_and_rearm(self) -> Steps:
        self._expect("stop", Cause.STOPPED)
        self._window.transport.stop.click()
        yield self._haste
        self._window.session.rearm()
        yield AGAIN_S
        self._window.player.play()

    def _open_again(self) -> Steps:
        session = self._window.session
        if session.jobs.is_busy:
            return
        session.open_path(self._places.sequence)
        while session.jobs.is_busy:
            yield 0.1

    def _drag_window(self) -> Steps:
        for k in range(15):
            self._window.move(4 * k, 3 * k)
            yield 0.016
        self._window.move(0, 0)

    def _rest_pointer(self) -> Steps:
        """Stay over a control until it tells what it is for."""
        transport = self._window.transport
        for widget in (transport.play, transport.feedback, self._window.health):
            QTest.mouseMove(widget)
            yield self._haste
