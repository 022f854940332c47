"""Every command of the window, one row each, and its actions and menus."""

from typing import Protocol

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar

from app.bridge.settings import Settings
from app.extension import rows
from app.player.command import KEYS, SHARED, Command
from app.player.controls import Controls
from app.player.dialogs import Dialogs
from app.player.session import Session
from hapticplayer.clock import Clock
from hapticplayer.playback.player import Player

SKIP_S, FAR_S = 5.0, 60.0
translate = QCoreApplication.translate


class View(Protocol):
    """How the video is looked at."""

    def zoom(self, steps: int) -> None: ...
    def save_frame(self) -> None: ...


class CommandTarget(Protocol):
    """What a command can act on: the player's window."""

    player: Player
    session: Session
    dialogs: Dialogs
    clock: Clock

    @property
    def viewing(self) -> View: ...
    @property
    def controls(self) -> Controls: ...
    def close(self) -> bool: ...
    def stop(self) -> None: ...
    def toggle_fullscreen(self) -> None: ...
    def show_plots(self, *, are_wanted: bool) -> None: ...
    def show_grip(self, *, is_wanted: bool) -> None: ...
    def show_sync_plot(self, *, is_wanted: bool) -> None: ...
    def show_statistics(self, *, is_wanted: bool) -> None: ...
    def show_playlist(self) -> None: ...
    def show_preferences(self) -> None: ...
    def go_to_file(self, steps: int) -> None: ...
    def turn_repeat(self) -> None: ...


Row = Command[CommandTarget]
_OWN: tuple[Row, ...] = (
    Row("open_sequence", "&Open sequence\u2026", "file", 0, lambda w: w.dialogs.open_sequence(), ("Ctrl+O",), is_work=True),
    Row("open_video", "Open &video\u2026", "file", 0, lambda w: w.dialogs.open_video(), ("Ctrl+Shift+O",), is_work=True),
    Row("import_recording", "&Import a recording\u2026", "file", 0, lambda w: w.dialogs.import_recording(), ("Ctrl+I",), is_work=True),
    Row("record", "Re&cord\u2026", "file", 0, lambda w: w.dialogs.record(w.clock), ("Ctrl+Shift+R",), is_work=True),
    Row("library", "Li&brary\u2026", "file", 0, lambda w: w.dialogs.library(w.clock), ("Ctrl+B",), is_work=True),
    Row("open_demo", "Open the &demo", "file", 1, lambda w: w.session.open_demo(), ("Ctrl+D",), is_work=True),
    Row("playlist", "&Playlist\u2026", "file", 1, lambda w: w.show_playlist(), ("Ctrl+Y",)),
    Row("edit_effects", "Edit &effects\u2026", "edit", 0, lambda w: w.dialogs.edit_effects(w.clock), ("Ctrl+T",), needs_clip=True),
    Row("rendering", "Re&ndering\u2026", "edit", 0, lambda w: w.dialogs.rendering(), needs_clip=True),
    Row("share", "S&hare\u2026", "file", 1, lambda w: w.dialogs.share(), ("Ctrl+E",), needs_clip=True),
    Row("open_log", "Replay a &log\u2026", "file", 1, lambda w: w.dialogs.open_log(), ("Ctrl+L",), needs_clip=True),
    Row("preferences", "&Preferences\u2026", "edit", 1, lambda w: w.show_preferences(), ("Ctrl+,",)),
    Row("export_settings", "E&xport settings\u2026", "edit", 1, lambda w: w.dialogs.export_settings()),
    Row("import_settings", "I&mport settings\u2026", "edit", 1, lambda w: w.dialogs.import_settings()),
    Row("quit", "&Quit", "file", 3, lambda w: w.close(), ("Ctrl+Q", "Q")),
    Row("play", "&Play or pause", "playback", 0, lambda w: w.player.toggle(), SHARED["play"], needs_clip=True),
    Row("back", "&Back 5 s", "playback", 0, lambda w: w.session.skip(-SKIP_S), ("Left",), needs_clip=True),
    Row("forward", "&Forward 5 s", "playback", 0, lambda w: w.session.skip(SKIP_S), ("Right",), needs_clip=True),
    Row("far_back", "Back 1 min", "playback", 0, lambda w: w.session.skip(-FAR_S), ("Down",), needs_clip=True),
    Row("far_forward", "Forward 1 min", "playback", 0, lambda w: w.session.skip(FAR_S), ("Up",), needs_clip=True),
    Row("to_start", "Go to the b&eginning", "playback", 0, lambda w: w.player.seek(0.0), ("Home",), needs_clip=True),
    Row("to_end", "Go to the e&nd", "playback", 0, lambda w: w.session.go_to_end(), ("End",), needs_clip=True),
    Row("next_file", "Ne&xt file", "playback", 1, lambda w: w.go_to_file(1), ("PgDown",), needs_clip=True),
    Row("previous_file", "P&revious file", "playback", 1, lambda w: w.go_to_file(-1), ("PgUp",), needs_clip=True),
    Row("repeat", "Repea&t: off, this clip, all", "playback", 1, lambda w: w.turn_repeat(), ("R",)),
    Row("step_forward", "Next frame", "playback", 2, lambda w: w.controls.step(1), (".",), needs_clip=True),
    Row("step_back", "Previous frame", "playback", 2, lambda w: w.controls.step(-1), (",",), needs_clip=True),
    Row("loop", "&Loop: set start, set end, off", "playback", 2, lambda w: w.controls.loop(), ("L",), needs_clip=True),
    Row("slower", "Slower", "playback", 3, lambda w: w.controls.change_speed(-1), ("[", "-"), needs_clip=True),
    Row("faster", "Faster", "playback", 3, lambda w: w.controls.change_speed(1), ("]", "+"), needs_clip=True),
    Row("normal_speed", "Normal speed", "playback", 3, lambda w: w.controls.change_speed(0), ("Backspace",), needs_clip=True),
    Row("quieter", "Quieter", "playback", 4, lambda w: w.controls.turn(-1), ("9", "/")),
    Row("louder", "Louder", "playback", 4, lambda w: w.controls.turn(1), ("0", "*")),
    Row("mute", "&Mute", "playback", 4, None, ("M",), toggles=lambda w, on: w.controls.mute(is_wanted=on)),
    Row("stop", "&Stop the force", "device", 0, lambda w: w.stop(), ("Esc",), is_fixed=True),
    Row("rearm", "&Re-arm the force", "device", 0, lambda w: w.session.rearm(), SHARED["rearm"]),
    Row("feedback", "Other feedbac&k\u2026", "playback", 5, lambda w: w.dialogs.other_feedback(), needs_clip=True),
    Row("set_up_device", "Set up the &device\u2026", "device", 1, lambda w: w.dialogs.set_up(w.clock)),
    Row("outputs", "&Outputs\u2026", "device", 1, lambda w: w.dialogs.outputs(w.clock)),
    Row("get_to_know", "&Try out the forces\u2026", "device", 1, lambda w: w.dialogs.get_to_know(w.clock), ("Ctrl+K",)),
    Row("latencies", "Measure l&atencies\u2026", "device", 1, lambda w: w.dialogs.latencies(w.clock)),
    Row("plots", "Live &plots", "view", 0, None, ("P",), toggles=lambda w, on: w.show_plots(are_wanted=on)),
    Row("grip", "&Grip view", "view", 0, None, ("G",), toggles=lambda w, on: w.show_grip(is_wanted=on)),
    Row("sync_plot", "S&ync plot", "view", 0, None, ("S",), toggles=lambda w, on: w.show_sync_plot(is_wanted=on)),
    Row("statistics", "&Statistics", "view", 0, None, ("I",), toggles=lambda w, on: w.show_statistics(is_wanted=on)),
    Row("video_larger", "&Zoom in", "view", 1, lambda w: w.viewing.zoom(1), ("Ctrl++", "Ctrl+="), needs_clip=True),
    Row("video_smaller", "Zoom o&ut", "view", 1, lambda w: w.viewing.zoom(-1), ("Ctrl+-",), needs_clip=True),
    Row("video_fit", "As large as fits", "view", 1, lambda w: w.viewing.zoom(0), ("Ctrl+0",), needs_clip=True),
    Row("save_frame", "Save this frame as a pictu&re", "view", 1, lambda w: w.viewing.save_frame(), ("Shift+S",), needs_clip=True),
    Row("fullscreen", "&Fullscreen", "view", 2, lambda w: w.toggle_fullscreen(), ("F", "F11"), needs_clip=True),
    Row("shortcuts", "&Keyboard shortcuts\u2026", "help", 0, lambda w: w.dialogs.shortcuts(COMMANDS), ("?",)),
    Row("guide", "&Guide", "help", 0, lambda w: w.dialogs.guide(), ("F1",)),
    Row("system_check", "&System check\u2026", "help", 1, lambda w: w.dialogs.system_check()),
    Row("report_problem", "&Report a problem\u2026", "help", 1, lambda w: w.dialogs.report_problem()),
    Row("about", "&About", "help", 2, lambda w: w.dialogs.about()),
)  # fmt: skip
COMMANDS: tuple[Row, ...] = tuple(rows("commands", Command, _OWN))


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
            action = QAction(command.title, window)
            action.setCheckable(command.toggles is not None)
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
        chosen = self._settings.table(KEYS)
        for command in COMMANDS:
            self.by_name[command.name].setShortcuts(command.keys_in(chosen))

    def bind(self, window: CommandTarget) -> None:
        """Let every action do what its row says."""
        for command in COMMANDS:
            action = self.by_name[command.name]
            if (toggles := command.toggles) is not None:
                action.toggled.connect(lambda on, do=toggles: do(window, on))
            elif (does := command.does) is not None:
                action.triggered.connect(lambda _=False, do=does: do(window))

    def fill(self, bar: QMenuBar) -> None:
        """Put the actions into menus."""
        titles = {
            "file": translate("Actions", "&File"),
            "edit": translate("Actions", "&Edit"),
            "playback": translate("Actions", "&Playback"),
            "view": translate("Actions", "&View"),
            "device": translate("Actions", "&Device"),
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
        return [self.by_name[c.name] for c in COMMANDS if c.is_work]

    @property
    def playing(self) -> list[QAction]:
        return [self.by_name[c.name] for c in COMMANDS if c.needs_clip]
