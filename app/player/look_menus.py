"""The menus of look and language."""

from PySide6.QtCore import QObject, Signal

from app.bridge import languages
from app.bridge.settings import Settings
from app.player.actions import Actions
from app.player.choose_menus import ChoiceMenu
from app.widgets import theme

LOOK, LANGUAGE = "look", "language"
"""Names in the settings."""


class LookMenus(QObject):
    """Asks how the window shall look and speak.

    Signals:
        changed: the settings say something else; the window has to be made anew.
    """

    changed = Signal()

    def __init__(self, actions: Actions, settings: Settings) -> None:
        super().__init__()
        self._settings = settings
        look = actions.add_menu("view", self.tr("&Look"), "fullscreen")
        self.looks = ChoiceMenu(
            look,
            lambda: [
                (theme.SYSTEM, self.tr("As the desktop")),
                (theme.DARK, self.tr("Dark")),
                (theme.LIGHT, self.tr("Light")),
                (theme.CONTRAST, self.tr("High contrast")),
            ],
            lambda: settings.text(LOOK, theme.DARK),
            lambda value: self._choose(LOOK, value),
        )
        spoken = actions.add_menu("view", self.tr("Lan&guage"), "fullscreen")
        self.languages = ChoiceMenu(
            spoken,
            lambda: [
                (languages.SYSTEM, self.tr("As the desktop")),
                *languages.NAMES.items(),
            ],
            lambda: settings.text(LANGUAGE, languages.ENGLISH),
            lambda value: self._choose(LANGUAGE, value),
        )

    def _choose(self, name: str, value: str) -> None:
        if self._settings.text(name) != value:
            self._settings.keep(name, value)
            self._settings.save()
            self.changed.emit()
