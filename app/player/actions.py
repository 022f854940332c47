"""The actions of the player's window, made from the table of commands."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar

from app.bridge.settings import Settings
from app.player.keymap import COMMANDS, KEYS, keys_of, texts

translate = QCoreApplication.translate

_OPENING = (
    "open_sequence",
    "open_video",
    "import_recording",
    "library",
    "open_demo",
)


class Actions:
    """One action for each command, also as an attribute of its name.

    They belong to the window itself, so that their keys work in fullscreen, where
    the menu bar is hidden.
    """

    def __init__(self, window: QMainWindow, settings: Settings) -> None:
        self._settings = settings
        self.by_name: dict[str, QAction] = {}
        self.menus: dict[str, QMenu] = {}
        named = texts()
        for command in COMMANDS:
            action = QAction(named[command.name], window)
            action.setCheckable(command.is_checkable)
            window.addAction(action)
            self.by_name[command.name] = action
        self.grip.setChecked(True)
        # also while another window of this program has the keyboard
        self.stop.setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
        self.apply_keys()

    def __getattr__(self, name: str) -> QAction:
        try:
            return self.__dict__["by_name"][name]  # type: ignore[no-any-return]
        except KeyError:
            raise AttributeError(name) from None

    def apply_keys(self) -> None:
        """Give every action the keys that the settings say."""
        chosen = self._settings.table(KEYS)
        for command in COMMANDS:
            self.by_name[command.name].setShortcuts(keys_of(command, chosen))

    def fill(self, bar: QMenuBar) -> None:
        """Put the actions into menus."""
        titles = {
            "file": translate("Actions", "&File"),
            "playback": translate("Actions", "&Playback"),
            "view": translate("Actions", "&View"),
            "help": translate("Actions", "&Help"),
        }
        for name, title in titles.items():
            menu = self.menus[name] = bar.addMenu(title)
            group = 0
            for command in (c for c in COMMANDS if c.menu == name):
                if command.group != group:
                    menu.addSeparator()
                    group = command.group
                menu.addAction(self.by_name[command.name])

    def add_menu(self, menu: str, title: str, before: str) -> QMenu:
        """Return a new menu within another, above one of its actions."""
        made = QMenu(title, self.menus[menu])
        self.menus[menu].insertMenu(self.by_name[before], made)
        return made

    @property
    def opening(self) -> list[QAction]:
        """What begins a piece of work."""
        return [self.by_name[name] for name in _OPENING]

    @property
    def playing(self) -> list[QAction]:
        """What needs a clip."""
        return [self.by_name[c.name] for c in COMMANDS if c.needs_clip]
