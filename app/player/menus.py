"""The menus whose entries are found when they open: recent, outputs, screens, theme."""

import math
from collections.abc import Callable, Iterable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QAction, QActionGroup, QGuiApplication
from PySide6.QtWidgets import QMenu

from app.bridge import languages
from app.bridge.settings import LANGUAGE, THEME, Settings
from app.player.commands import Actions
from app.player.controls import Controls
from app.widgets import theme
from hapticplayer.playback.player import Player

translate = QCoreApplication.translate

RECENT, POSITIONS = "recent", "positions"
"""Names in the settings."""

MOST_RECENT, MOST_POSITIONS = 10, 200
FROM_START_S, FROM_END_S = 5.0, 5.0
"""Nearer to an end of the clip than this, it starts from the beginning."""


class History:
    """Remembers paths and positions, nothing else, and nothing beside the clips."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings

    def recent(self) -> list[Path]:
        """The clips that were opened, the latest first."""
        return [Path(text) for text in self._settings.texts(RECENT)[:MOST_RECENT]]

    def note_opened(self, path: Path) -> None:
        """Put a path at the top of the list."""
        whole = str(path.absolute())
        others = [text for text in self._settings.texts(RECENT) if text != whole]
        self._settings.keep(RECENT, [whole, *others][:MOST_RECENT])

    def forget(self) -> None:
        self._settings.keep(RECENT, [])
        self._settings.keep(POSITIONS, {})

    def note_position(self, player: Player) -> None:
        """Remember where the clip is; not at its ends."""
        now = player.snapshot()
        if now.source is None or now.source.clip.remote:
            return
        place, kept = str(now.source.path.absolute()), self._positions()
        kept.pop(place, None)
        media_s = now.media_s
        if is_worth_keeping(media_s, now.duration_s):
            kept[place] = round(media_s, 3)
        newest = list(kept.items())[-MOST_POSITIONS:]
        self._settings.keep(POSITIONS, dict(newest))

    def position_s(self, path: Path, duration_s: float) -> float:
        """Return where a clip was left, 0 where it is to begin at its beginning."""
        kept_s = self._positions().get(str(path.absolute()), 0.0)
        return kept_s if is_worth_keeping(kept_s, duration_s) else 0.0

    def _positions(self) -> dict[str, float]:
        kept = self._settings.table(POSITIONS)
        return {
            path: float(value)
            for path, value in kept.items()
            if isinstance(value, int | float) and math.isfinite(value)
        }


def is_worth_keeping(media_s: float, duration_s: float) -> bool:
    return FROM_START_S <= media_s <= duration_s - FROM_END_S


LONGEST_NAME = 60


class ChoiceMenu(QObject):
    """A menu of which one entry (value, text) is chosen; it is filled as it opens."""

    def __init__(
        self,
        menu: QMenu,
        entries: Callable[[], Iterable[tuple[str, str]]],
        chosen: Callable[[], str],
        choose: Callable[[str], None],
    ) -> None:
        super().__init__(menu)
        self.menu = menu
        self._entries, self._chosen, self._choose = entries, chosen, choose
        menu.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """Find the entries."""
        self.menu.clear()
        group = QActionGroup(self.menu)
        for value, text in self._entries():
            action = self.menu.addAction(shortened(text))
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
        self.menu, self._history, self._open = menu, history, open_path
        menu.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """List the paths."""
        self.menu.clear()
        for path in self._history.recent():
            action = self.menu.addAction(shortened(path.name or str(path)))
            action.setToolTip(str(path))
            action.setEnabled(path.exists())
            action.triggered.connect(lambda _=False, path=path: self._open(path))
        self.menu.addSeparator()
        clear = QAction(self.tr("Clear list"), self.menu)
        clear.setEnabled(bool(self._history.recent()))
        clear.triggered.connect(self._history.forget)
        self.menu.addAction(clear)


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
        output = actions.add_menu("playback", self.tr("Sound &output"), "feedback")
        self.outputs = ChoiceMenu(
            output,
            lambda: [
                ("", self.tr("System default")),
                *((n, n) for n in controls.outputs()),
            ],
            lambda: controls.output,
            controls.choose_output,
        )
        actions.menus["playback"].aboutToShow.connect(controls.present.refresh)
        controls.present.changed.connect(self.outputs.fill)
        screens = actions.add_menu("view", self.tr("Fullscreen &on"), "fullscreen")
        self.screens = ChoiceMenu(
            screens,
            lambda: [("", self.tr("Same screen as the window")), *screen_names()],
            *screen,
        )


def theme_names() -> list[tuple[str, str]]:
    return [
        (theme.SYSTEM, translate("ThemeMenus", "System default")),
        (theme.DARK, translate("ThemeMenus", "Dark")),
        (theme.LIGHT, translate("ThemeMenus", "Light")),
        (theme.CONTRAST, translate("ThemeMenus", "High contrast")),
    ]


def language_names() -> list[tuple[str, str]]:
    system = translate("ThemeMenus", "System default")
    return [(languages.SYSTEM, system), *languages.NAMES.items()]


class ThemeMenus(QObject):
    """The choices of theme and language; for another one the window has to be rebuilt."""

    changed = Signal()

    def __init__(self, actions: Actions, settings: Settings) -> None:
        super().__init__()
        self._settings = settings
        themes = actions.add_menu("view", self.tr("&Theme"), "fullscreen")
        self.themes = ChoiceMenu(
            themes,
            theme_names,
            lambda: settings.text(THEME, theme.DARK),
            lambda value: self._choose(THEME, value),
        )
        spoken = actions.add_menu("view", self.tr("&Language"), "fullscreen")
        self.languages = ChoiceMenu(
            spoken,
            language_names,
            lambda: settings.text(LANGUAGE, languages.SYSTEM),
            lambda value: self._choose(LANGUAGE, value),
        )

    def _choose(self, name: str, value: str) -> None:
        if self._settings.text(name) != value:
            self._settings.keep(name, value)
            self._settings.save()
            self.changed.emit()
