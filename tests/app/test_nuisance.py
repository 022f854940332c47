"""Normal use of the window: the loop reacts to nothing but what a person asked for.

`benchmarks.robustness nuisance` does so for half an hour. A busy machine is no fault here: what it
can bring about does not count.
"""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QSplitter

from hapticplayer.haptics.contract import Cause
from tools.reactions import OF_LOAD

LEFT, NO_KEY = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
CONTROL = Qt.KeyboardModifier.ControlModifier
# while the decoder does not keep up there is no track
MAY_BE_LOAD = OF_LOAD | {Cause.NO_TRACK}


class Use:
    """A person with mouse and keyboard, and what the loop does meanwhile."""

    def __init__(self, window, qtbot):
        self.window, self.qtbot = window, qtbot
        self.seen_s = window.player.snapshot().leading.tick["monotonic_s"]
        self.causes: set[Cause] = set()

    def look(self):
        """Note why the loop held its force back since the last call."""
        ticks = self.window.player.ticks_since(self.seen_s)
        if len(ticks):
            self.seen_s = ticks["monotonic_s"][-1]
            self.causes |= {Cause(cause) for cause in np.unique(ticks["cause"])}

    def has_noted(self, cause):
        """Look, and return whether a cause was ever noted."""
        self.look()
        return cause in self.causes

    def do(self, *steps):
        """Do one thing after the other; each step is followed by a wait in ms."""
        for step in steps:
            for wait_ms in step():
                self.qtbot.wait(wait_ms)
                self.look()

    def key(self, key, modifier=NO_KEY):
        QTest.keyClick(self.window.windowHandle(), key, modifier)

    def close_dialogs(self):
        for dialog in self.window.findChildren(QDialog):
            if dialog.isVisible():
                dialog.reject()

    # --- things ---------------------------------------------------------------

    def open_menus(self) -> Iterator[int]:
        bar = self.window.menuBar()
        for action in bar.actions():
            QTest.mouseClick(bar, LEFT, NO_KEY, bar.actionGeometry(action).center())
            yield 50
            QTest.keyClick(action.menu(), Qt.Key.Key_Down)
            yield 20
            action.menu().close()

    def open_dialogs(self) -> Iterator[int]:
        for key, modifier in (
            (Qt.Key.Key_O, CONTROL),
            (Qt.Key.Key_I, CONTROL),
            (Qt.Key.Key_F1, NO_KEY),
        ):
            self.key(key, modifier)
            yield 200
            self.close_dialogs()

    def resize(self) -> Iterator[int]:
        for width in range(800, 1300, 50):
            self.window.resize(width, 700)
            yield 16

    def show_and_hide(self) -> Iterator[int]:
        """Fullscreen, plots and grip, there and back."""
        for key in (Qt.Key.Key_F, Qt.Key.Key_P, Qt.Key.Key_G):
            for _ in range(2):
                self.key(key)
                yield 150
        self.window.showMinimized()
        yield 150
        self.window.showNormal()

    def drag_splitter(self) -> Iterator[int]:
        handle = self.window.findChild(QSplitter).handle(1)
        middle = handle.rect().center()
        QTest.mousePress(handle, LEFT, NO_KEY, middle)
        for up_px in range(0, 60, 10):
            QTest.mouseMove(handle, middle - type(middle)(0, up_px))
            yield 16
        QTest.mouseRelease(handle, LEFT, NO_KEY, middle)

    def seek(self) -> Iterator[int]:
        slider = self.window.transport.slider
        QTest.mouseClick(slider, LEFT, NO_KEY, slider.rect().center())
        yield 50
        self.key(Qt.Key.Key_Left)
        yield 50


@pytest.mark.realtime
def test_using_the_window_causes_no_unintended_reaction(
    make_window, long_source, qtbot, wait_for, feel
):
    window = make_window("simulated")
    window.session.show_source(long_source)
    wait_for(lambda: window.player.snapshot().leading.tick is not None)
    person = Use(window, qtbot)
    feel(window, person.look)
    person.causes.clear()
    person.do(person.open_menus, person.open_dialogs, person.resize)
    person.do(person.show_and_hide, person.drag_splitter)
    assert person.causes <= MAY_BE_LOAD | {Cause.NONE}
    feel(window, person.look)
    person.do(person.seek)
    wait_for(lambda: person.has_noted(Cause.SEEK))
    feel(window, person.look)
    assert person.causes <= MAY_BE_LOAD | {Cause.NONE, Cause.SEEK, Cause.PAUSED}
