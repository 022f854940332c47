"""Every command of the window: name, menu, shortcuts, action."""

from typing import Any, NamedTuple

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar

from app.bridge.settings import Settings

translate = QCoreApplication.translate

KEYS = "keys"
"""Name of the table in the settings."""

CONTEXT = "Actions"
"""Of the commands among the translations."""

MOST_KEYS = 8


class Command(NamedTuple):
    """One thing that can be done."""

    name: str  # of the action and in the settings
    text: str  # in English; "&" marks the letter in the menu
    menu: str  # file, playback, view or help
    group: int  # commands of one group lie together in the menu
    keys: tuple[str, ...] = ()  # at first
    needs_clip: bool = False
    is_checkable: bool = False
    is_fixed: bool = False  # keeps its keys


COMMANDS = (
    Command("open_sequence", "&Open sequence\u2026", "file", 0, ("Ctrl+O",)),
    Command("open_video", "Open &video\u2026", "file", 0, ("Ctrl+Shift+O",)),
    Command("import_recording", "&Import a recording\u2026", "file", 0, ("Ctrl+I",)),
    Command("library", "Li&brary\u2026", "file", 0, ("Ctrl+B",)),
    Command("open_demo", "Open the &demo", "file", 1, ("Ctrl+D",)),
    Command(
        "edit_effects",
        "Edit &effects\u2026",
        "file",
        1,
        ("Ctrl+T",),
        needs_clip=True,
    ),
    Command("rendering", "Re&ndering\u2026", "file", 1, needs_clip=True),
    Command("share", "S&hare\u2026", "file", 1, ("Ctrl+E",), needs_clip=True),
    Command("open_log", "Replay a &log\u2026", "file", 1, ("Ctrl+L",), needs_clip=True),
    Command("export_settings", "E&xport settings\u2026", "file", 2),
    Command("import_settings", "I&mport settings\u2026", "file", 2),
    Command("quit", "&Quit", "file", 3, ("Ctrl+Q", "Q")),
    Command("play", "&Play or pause", "playback", 0, ("Space",), needs_clip=True),
    Command("back", "&Back 5 s", "playback", 0, ("Left",), needs_clip=True),
    Command("forward", "&Forward 5 s", "playback", 0, ("Right",), needs_clip=True),
    Command("far_back", "Back 1 min", "playback", 0, ("Down",), needs_clip=True),
    Command("far_forward", "Forward 1 min", "playback", 0, ("Up",), needs_clip=True),
    Command(
        "to_start", "Go to the b&eginning", "playback", 0, ("Home",), needs_clip=True
    ),
    Command("to_end", "Go to the e&nd", "playback", 0, ("End",), needs_clip=True),
    Command("step_forward", "Next frame", "playback", 1, (".",), needs_clip=True),
    Command("step_back", "Previous frame", "playback", 1, (",",), needs_clip=True),
    Command(
        "loop", "&Loop: set start, set end, off", "playback", 1, ("L",), needs_clip=True
    ),
    Command("slower", "Slower", "playback", 2, ("[",), needs_clip=True),
    Command("faster", "Faster", "playback", 2, ("]",), needs_clip=True),
    Command(
        "normal_speed", "Normal speed", "playback", 2, ("Backspace",), needs_clip=True
    ),
    Command("quieter", "Quieter", "playback", 3, ("9", "/")),
    Command("louder", "Louder", "playback", 3, ("0", "*")),
    Command("mute", "&Mute", "playback", 3, ("M",), is_checkable=True),
    Command("stop", "&Stop the force", "playback", 4, ("Esc",), is_fixed=True),
    Command("rearm", "&Re-arm the force", "playback", 4, ("Ctrl+R",)),
    Command("feedback", "Other feed&back\u2026", "playback", 5, needs_clip=True),
    Command("set_up_device", "Set up the &device\u2026", "playback", 5),
    Command("outlets", "M&ore devices\u2026", "playback", 5),
    Command("get_to_know", "&Try out the forces\u2026", "playback", 5, ("Ctrl+K",)),
    Command("latencies", "Measure l&atencies\u2026", "playback", 5),
    Command("plots", "Live &plots", "view", 0, ("P",), is_checkable=True),
    Command("grip", "&Grip view", "view", 0, ("G",), is_checkable=True),
    Command("sync_plot", "S&ync plot", "view", 0, ("S",), is_checkable=True),
    Command("statistics", "&Statistics", "view", 0, ("I",), is_checkable=True),
    Command("rig", "Simulated &motion rig\u2026", "view", 0),
    Command("faults", "Inject fa&ults\u2026", "view", 0),
    Command("fullscreen", "&Fullscreen", "view", 1, ("F", "F11"), needs_clip=True),
    Command("shortcuts", "&Keyboard shortcuts\u2026", "help", 0, ("?", "F1")),
    Command("about", "&About", "help", 0),
)

BY_NAME = {command.name: command for command in COMMANDS}


def text_of(command: Command) -> str:
    """Return what a command is called in the window's language."""
    return translate(CONTEXT, command.text)


def keys_of(command: Command, chosen: dict[str, Any]) -> list[QKeySequence]:
    """Return the keys of a command; the table of the settings has texts by its name."""
    kept = chosen.get(command.name)
    is_list = isinstance(kept, list) and all(isinstance(key, str) for key in kept)
    texts = kept[:MOST_KEYS] if kept is not None and is_list else command.keys
    if command.is_fixed:
        texts = command.keys
    made = [QKeySequence(text) for text in texts]
    return [key for key in made if not key.isEmpty()]


def owner_of(key: QKeySequence, chosen: dict[str, Any]) -> Command | None:
    """Return the command that has a key already."""
    return next((c for c in COMMANDS if key in keys_of(c, chosen)), None)


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
        for command in COMMANDS:
            action = QAction(text_of(command), window)
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
