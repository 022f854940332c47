"""The preferences: what the menus choose one by one, on one page."""

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QDialog, QFormLayout, QWidget

from app.bridge import languages
from app.bridge.settings import LANGUAGE, THEME, Settings, library_folder
from app.player.controls import OUTPUT, Controls
from app.player.extras import RESUMES, SCREEN
from app.player.menus import language_names, screen_names, theme_names
from app.player.viewing import FRAMES, Viewing
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.texts import titled

WIDTH_PX, HEIGHT_PX = 560, 420
_PLACE_PX = 220


class Chosen(NamedTuple):
    """What a person has set; a rebuild of the window follows another look or language."""

    output: str
    screen: str
    library: Path
    is_rebuilt: bool


class PreferencesPage(QDialog):
    """Changes nothing before it is accepted.

    Signals:
        chosen: with `Chosen`.
        page_wanted: the command whose page is to open: keys, outputs, latencies.
    """

    chosen = Signal(object)
    page_wanted = Signal(str)

    def __init__(
        self, settings: Settings, controls: Controls, viewing: Viewing, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Preferences"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._settings = settings
        look, language = settings.text(THEME, theme.DARK), settings.text(LANGUAGE)
        self.language = _combo(language_names(), language or languages.SYSTEM)
        self.theme = _combo(theme_names(), look)
        outputs = [("", self.tr("System default"))]
        outputs += [(name, name) for name in controls.outputs()]
        self.output = _combo(outputs, controls.output)
        screens = [("", self.tr("Same screen as the window")), *screen_names()]
        self.screen_choice = _combo(screens, settings.text(SCREEN))
        self.resumes = QCheckBox(self.tr("Resume clips &where they were left"))
        self.resumes.setChecked(settings.flag(RESUMES, default=True))
        self.library = _Place(library_folder(settings), self)
        self.frames = _Place(viewing.folder, self)
        self._lay_out()
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)

    def _lay_out(self) -> None:
        form = QFormLayout()
        for text, field in (
            (self.tr("&Language"), self.language),
            (self.tr("&Theme"), self.theme),
            (self.tr("Sound &output"), self.output),
            (self.tr("&Fullscreen on"), self.screen_choice),
        ):
            form.addRow(text, field)
        for text, place in (
            (self.tr("Library"), self.library),
            (self.tr("Saved frames"), self.frames),
        ):
            form.addRow(text, place)
            place.button.setAccessibleName(titled(text, place.button.text()))
        form.addRow("", self.resumes)
        more = [
            ("shortcuts", text_button(self.tr("&Keys\u2026"), "")),
            ("outputs", text_button(self.tr("&Devices\u2026"), "")),
            ("latencies", text_button(self.tr("L&atencies\u2026"), "")),
        ]
        for name, button in more:
            button.clicked.connect(lambda _on=False, n=name: self._leave_for(n))
        self.accept_button = text_button(self.tr("O&K"), "", "primary")
        cancel = text_button(self.tr("&Cancel"), "")
        self.accept_button.clicked.connect(self.accept)
        self.accept_button.setDefault(True)
        cancel.clicked.connect(self.reject)
        hint = paragraph(self.tr("More is set on pages of its own:"), theme.DIM)
        pages = row_of(*(button for _, button in more), STRETCH)
        row = row_of(STRETCH, cancel, self.accept_button)
        fill_page(self, form, hint, pages, STRETCH, row)

    def _leave_for(self, page: str) -> None:
        self.accept()
        self.page_wanted.emit(page)

    def accept(self) -> None:
        """Keep what was set, and say what has changed."""
        settings = self._settings
        before = settings.text(LANGUAGE), settings.text(THEME)
        settings.keep(LANGUAGE, self.language.currentData())
        settings.keep(THEME, self.theme.currentData())
        settings.keep(OUTPUT, self.output.currentData())
        settings.keep(RESUMES, self.resumes.isChecked())
        settings.keep(FRAMES, str(self.frames.folder))
        settings.save()
        after = settings.text(LANGUAGE), settings.text(THEME)
        first = before[0] or languages.SYSTEM, before[1] or theme.DARK
        made = Chosen(
            self.output.currentData(),
            self.screen_choice.currentData(),
            self.library.folder,
            after != first,
        )
        super().accept()
        self.chosen.emit(made)


class _Place(QWidget):
    """A folder, and a button that chooses another."""

    def __init__(self, folder: Path, page: QWidget) -> None:
        super().__init__()
        self.folder, self._page = folder, page
        self.label = ElidedLabel(str(folder), elide=Qt.TextElideMode.ElideMiddle)
        self.label.setMinimumWidth(_PLACE_PX)
        self.button = text_button(self.tr("Choose\u2026"), str(folder))
        self.button.clicked.connect(self._ask)
        row_of((self.label, 1), self.button, of=self)

    def take(self, path: str) -> None:
        self.folder = Path(path)
        self.label.set_text(path)
        self.button.setToolTip(path)

    def _ask(self) -> None:
        dialog = folder_dialog(self._page, self.tr("Choose a folder"), str(self.folder))
        dialog.fileSelected.connect(self.take)
        dialog.open()


def _combo(entries: Iterable[tuple[str, str]], chosen: str) -> QComboBox:
    made = QComboBox()
    for value, text in entries:
        made.addItem(text, value)
    made.setCurrentIndex(max(0, made.findData(chosen)))
    return made
