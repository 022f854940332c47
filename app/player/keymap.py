"""Every command of the window in one table: its name, its menu, its keys.

The keys are those of mpv and VLC where these agree. People may give a command
other keys; these are kept in the settings under the command's name.
"""

from typing import Any, NamedTuple

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QKeySequence

translate = QCoreApplication.translate

KEYS = "keys"
"""Name of the table in the settings."""

MOST_KEYS = 8


class Command(NamedTuple):
    """One thing that can be done.

    Attributes:
        name: of the action and in the settings.
        menu: file, playback, view or help.
        group: commands of one group lie together in the menu.
        keys: at first.
        needs_clip: cannot be done without one.
        is_checkable: is on or off.
        is_fixed: keeps its keys.
    """

    name: str
    menu: str
    group: int
    keys: tuple[str, ...] = ()
    needs_clip: bool = False
    is_checkable: bool = False
    is_fixed: bool = False


COMMANDS = (
    Command("open_sequence", "file", 0, ("Ctrl+O",)),
    Command("open_video", "file", 0, ("Ctrl+Shift+O",)),
    Command("import_recording", "file", 0, ("Ctrl+I",)),
    Command("library", "file", 0, ("Ctrl+B",)),
    Command("open_demo", "file", 1, ("Ctrl+D",)),
    Command("open_log", "file", 1, ("Ctrl+L",), needs_clip=True),
    Command("export_settings", "file", 2),
    Command("import_settings", "file", 2),
    Command("quit", "file", 3, ("Ctrl+Q", "Q")),
    Command("play", "playback", 0, ("Space",), needs_clip=True),
    Command("back", "playback", 0, ("Left",), needs_clip=True),
    Command("forward", "playback", 0, ("Right",), needs_clip=True),
    Command("far_back", "playback", 0, ("Down",), needs_clip=True),
    Command("far_forward", "playback", 0, ("Up",), needs_clip=True),
    Command("to_start", "playback", 0, ("Home",), needs_clip=True),
    Command("to_end", "playback", 0, ("End",), needs_clip=True),
    Command("step_forward", "playback", 1, (".",), needs_clip=True),
    Command("step_back", "playback", 1, (",",), needs_clip=True),
    Command("loop", "playback", 1, ("L",), needs_clip=True),
    Command("slower", "playback", 2, ("[",), needs_clip=True),
    Command("faster", "playback", 2, ("]",), needs_clip=True),
    Command("normal_speed", "playback", 2, ("Backspace",), needs_clip=True),
    Command("quieter", "playback", 3, ("9", "/")),
    Command("louder", "playback", 3, ("0", "*")),
    Command("mute", "playback", 3, ("M",), is_checkable=True),
    Command("stop", "playback", 4, ("Esc",), is_fixed=True),
    Command("rearm", "playback", 4, ("Ctrl+R",)),
    Command("set_up_device", "playback", 5),
    Command("get_to_know", "playback", 5, ("Ctrl+K",)),
    Command("latencies", "playback", 5),
    Command("plots", "view", 0, ("P",), is_checkable=True),
    Command("grip", "view", 0, ("G",), is_checkable=True),
    Command("sync_plot", "view", 0, ("S",), is_checkable=True),
    Command("statistics", "view", 0, ("I",), is_checkable=True),
    Command("faults", "view", 0),
    Command("fullscreen", "view", 1, ("F", "F11"), needs_clip=True),
    Command("shortcuts", "help", 0, ("?", "F1")),
    Command("about", "help", 0),
)

BY_NAME = {command.name: command for command in COMMANDS}


def texts() -> dict[str, str]:
    """Return what the commands are called; "&" marks the letter in the menu."""
    return {
        "open_sequence": translate("Actions", "&Open sequence\u2026"),
        "open_video": translate("Actions", "Open &video\u2026"),
        "import_recording": translate("Actions", "&Import a recording\u2026"),
        "library": translate("Actions", "Li&brary\u2026"),
        "open_demo": translate("Actions", "Open the &demo"),
        "open_log": translate("Actions", "Play a &log\u2026"),
        "export_settings": translate("Actions", "E&xport the settings\u2026"),
        "import_settings": translate("Actions", "I&mport settings\u2026"),
        "quit": translate("Actions", "&Quit"),
        "play": translate("Actions", "&Play or pause"),
        "back": translate("Actions", "5 s &back"),
        "forward": translate("Actions", "5 s &forward"),
        "far_back": translate("Actions", "1 min back"),
        "far_forward": translate("Actions", "1 min forward"),
        "to_start": translate("Actions", "To the b&eginning"),
        "to_end": translate("Actions", "To the e&nd"),
        "step_forward": translate("Actions", "Next picture"),
        "step_back": translate("Actions", "Previous picture"),
        "loop": translate("Actions", "&Loop: from here, to here, off"),
        "slower": translate("Actions", "Slower"),
        "faster": translate("Actions", "Faster"),
        "normal_speed": translate("Actions", "Normal speed"),
        "quieter": translate("Actions", "Quieter"),
        "louder": translate("Actions", "Louder"),
        "mute": translate("Actions", "&Mute"),
        "stop": translate("Actions", "&Stop the force"),
        "rearm": translate("Actions", "&Re-arm the force"),
        "set_up_device": translate("Actions", "Set up the &device\u2026"),
        "get_to_know": translate("Actions", "Get to &know the forces\u2026"),
        "latencies": translate("Actions", "Measure l&atencies\u2026"),
        "plots": translate("Actions", "Live &plots"),
        "grip": translate("Actions", "Simulated &grip"),
        "sync_plot": translate("Actions", "S&ync plot"),
        "statistics": translate("Actions", "&Statistics"),
        "faults": translate("Actions", "Fa&ults of the simulated device\u2026"),
        "fullscreen": translate("Actions", "&Fullscreen"),
        "shortcuts": translate("Actions", "&Keyboard\u2026"),
        "about": translate("Actions", "&About"),
    }


def keys_of(command: Command, chosen: dict[str, Any]) -> list[QKeySequence]:
    """Return the keys of a command.

    Args:
        command: whose.
        chosen: the table of the settings: texts by the command's name.
    """
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
