"""Everything that can be done, with its keys, and the menus that offer it."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar

translate = QCoreApplication.translate


class Actions:
    """The actions of the player's window.

    They belong to the window itself, so that their keys work in fullscreen, where
    the menu bar is hidden.
    """

    def __init__(self, window: QMainWindow) -> None:
        self._window = window
        self.all: list[QAction] = []
        make = self._make
        self.open_sequence = make(
            translate("Actions", "&Open sequence\u2026"), "Ctrl+O"
        )
        self.open_video = make(
            translate("Actions", "Open &video\u2026"), "Ctrl+Shift+O"
        )
        self.import_recording = make(
            translate("Actions", "&Import a recording\u2026"), "Ctrl+I"
        )
        self.open_demo = make(translate("Actions", "Open the &demo"), "Ctrl+D")
        self.quit = make(translate("Actions", "&Quit"), "Ctrl+Q")
        self.play = make(translate("Actions", "&Play or pause"), "Space")
        self.back = make(translate("Actions", "5 s &back"), "Left")
        self.forward = make(translate("Actions", "5 s &forward"), "Right")
        self.to_start = make(translate("Actions", "To the &beginning"), "Home")
        self.to_end = make(translate("Actions", "To the &end"), "End")
        self.stop = make(translate("Actions", "&Stop the force"), "Esc")
        # also while another window of this program has the keyboard
        self.stop.setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
        self.rearm = make(translate("Actions", "&Re-arm the force"), "Ctrl+R")
        self.get_to_know = make(
            translate("Actions", "Get to &know the forces\u2026"), "Ctrl+K"
        )
        self.plots = make(translate("Actions", "Live &plots"), "P")
        self.plots.setCheckable(True)
        self.grip = make(translate("Actions", "Simulated &grip"), "G")
        self.grip.setCheckable(True)
        self.grip.setChecked(True)
        self.fullscreen = make(translate("Actions", "&Fullscreen"), "F", "F11")
        self.shortcuts = make(translate("Actions", "&Keyboard shortcuts"), "F1")
        self.about = make(translate("Actions", "&About"))

    def _make(self, text: str, *keys: str) -> QAction:
        action = QAction(text, self._window)
        action.setShortcuts([QKeySequence(key) for key in keys])
        self._window.addAction(action)
        self.all.append(action)
        return action

    def fill(self, bar: QMenuBar) -> None:
        """Put the actions into menus."""
        _menu(
            bar,
            translate("Actions", "&File"),
            [self.open_sequence, self.open_video, self.import_recording],
            [self.open_demo],
            [self.quit],
        )
        _menu(
            bar,
            translate("Actions", "&Playback"),
            [self.play, self.back, self.forward, self.to_start, self.to_end],
            [self.stop, self.rearm],
            [self.get_to_know],
        )
        _menu(
            bar,
            translate("Actions", "&View"),
            [self.plots, self.grip, self.fullscreen],
        )
        _menu(bar, translate("Actions", "&Help"), [self.shortcuts, self.about])

    @property
    def opening(self) -> list[QAction]:
        """What begins a piece of work."""
        return [
            self.open_sequence,
            self.open_video,
            self.import_recording,
            self.open_demo,
        ]

    @property
    def playing(self) -> list[QAction]:
        """What needs a clip."""
        return [
            self.play,
            self.back,
            self.forward,
            self.to_start,
            self.to_end,
            self.fullscreen,
        ]


def _menu(bar: QMenuBar, title: str, *groups: list[QAction]) -> QMenu:
    menu = bar.addMenu(title)
    for number, group in enumerate(groups):
        if number:
            menu.addSeparator()
        menu.addActions(group)
    return menu
