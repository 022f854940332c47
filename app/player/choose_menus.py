"""The menus whose entries are found when they open: recent, outputs, screens."""

from collections.abc import Callable, Iterable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup, QGuiApplication
from PySide6.QtWidgets import QMenu

from app.player.actions import Actions
from app.player.controls import Controls
from app.player.history import History

LONGEST_NAME = 60


class ChoiceMenu(QObject):
    """A menu of which one entry is chosen.

    Args:
        menu: filled anew each time it opens.
        entries: return (value, text) pairs.
        chosen: returns the value that is chosen now.
        choose: called with the value of the entry that was triggered.
    """

    def __init__(
        self,
        menu: QMenu,
        entries: Callable[[], Iterable[tuple[str, str]]],
        chosen: Callable[[], str],
        choose: Callable[[str], None],
    ) -> None:
        super().__init__(menu)
        self._menu = menu
        self._entries, self._chosen, self._choose = entries, chosen, choose
        menu.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """Find the entries."""
        self._menu.clear()
        group = QActionGroup(self._menu)
        for value, text in self._entries():
            action = self._menu.addAction(shortened(text))
            action.setCheckable(True)
            action.setChecked(value == self._chosen())
            action.setData(value)
            group.addAction(action)
        group.triggered.connect(lambda action: self._choose(action.data()))


class RecentMenu(QObject):
    """What was opened before; what is gone cannot be chosen."""

    def __init__(
        self, menu: QMenu, history: History, open_path: Callable[[Path], None]
    ) -> None:
        super().__init__(menu)
        self._menu, self._history, self._open = menu, history, open_path
        menu.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """List the paths."""
        self._menu.clear()
        for path in self._history.recent():
            action = self._menu.addAction(shortened(path.name or str(path)))
            action.setToolTip(str(path))
            action.setEnabled(path.exists())
            action.triggered.connect(lambda _=False, path=path: self._open(path))
        self._menu.addSeparator()
        clear = QAction(self.tr("Forget all"), self._menu)
        clear.setEnabled(bool(self._history.recent()))
        clear.triggered.connect(self._history.forget)
        self._menu.addAction(clear)


def screen_names() -> list[tuple[str, str]]:
    """Return the screens as (name, text)."""
    found = []
    for screen in QGuiApplication.screens():
        size = screen.size() * screen.devicePixelRatio()  # of the screen's own pixels
        text = f"{screen.name()}  {size.width()} \u00d7 {size.height()}"
        found.append((screen.name(), text))
    return found


def shortened(text: str) -> str:
    """Return a text that fits a menu, and whose ampersands are shown."""
    if len(text) > LONGEST_NAME:
        text = f"{text[: LONGEST_NAME - 1]}\u2026"
    return text.replace("&", "&&")


class ChooseMenus(QObject):
    """All of them, in their places."""

    def __init__(
        self,
        actions: Actions,
        history: History,
        controls: Controls,
        open_path: Callable[[Path], None],
        screen: tuple[Callable[[], str], Callable[[str], None]],
    ) -> None:
        super().__init__()
        recent = actions.add_menu("file", self.tr("Open &recent"), "open_demo")
        self.recent = RecentMenu(recent, history, open_path)
        output = actions.add_menu("playback", self.tr("Sound &output"), "stop")
        self.outputs = ChoiceMenu(
            output,
            lambda: [
                ("", self.tr("As the system says")),
                *((n, n) for n in controls.outputs()),
            ],
            lambda: controls.output,
            controls.choose_output,
        )
        actions.menus["playback"].aboutToShow.connect(controls.present.look)
        controls.present.changed.connect(self.outputs.fill)
        screens = actions.add_menu("view", self.tr("Fullscreen &on"), "fullscreen")
        self.screens = ChoiceMenu(
            screens,
            lambda: [("", self.tr("The window's screen")), *screen_names()],
            *screen,
        )
