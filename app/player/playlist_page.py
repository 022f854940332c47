"""The list of clips that play one after the other."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QListWidget,
    QListWidgetItem,
    QWidget,
)

from app.player.playlist import Playlist, Repeat, is_playable
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import FileDrops, file_dialog, video_filter
from app.widgets.layout import (
    STRETCH,
    captioned,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)

WIDTH_PX, HEIGHT_PX = 560, 460


class PlaylistPage(QDialog):
    """Stays beside the window; a double click plays a clip."""

    def __init__(self, playlist: Playlist, folder: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Playlist"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._playlist, self._folder = playlist, folder
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Clips"))
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.list.itemActivated.connect(self._play)
        self.list.model().rowsMoved.connect(lambda *_: self._keep())
        self.hint = paragraph(colour=theme.DIM)
        self.repeat = QComboBox()
        for kind, text in (
            (Repeat.OFF, self.tr("Do not repeat")),
            (Repeat.ONE, self.tr("Repeat this clip")),
            (Repeat.ALL, self.tr("Repeat all")),
        ):
            self.repeat.addItem(text, kind)
        self.repeat.activated.connect(lambda _: self._choose_repeat())
        self._lay_out()
        self.drops = FileDrops(self, self.add)
        playlist.changed.connect(self.refresh)
        self.refresh()
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)

    def _lay_out(self) -> None:
        self.add_button = text_button(
            self.tr("&Add\u2026"), self.tr("Add videos; sequences can be dropped here")
        )
        self.remove_button = text_button(
            self.tr("&Remove"), self.tr("Remove from the list; no file is deleted")
        )
        self.up = text_button(self.tr("&Up"), self.tr("Play it earlier"))
        self.down = text_button(self.tr("&Down"), self.tr("Play it later"))
        close = text_button(self.tr("&Close"), "")
        self.add_button.clicked.connect(self._ask)
        self.remove_button.clicked.connect(self.remove)
        self.up.clicked.connect(lambda: self.move_by(-1))
        self.down.clicked.connect(lambda: self.move_by(1))
        close.clicked.connect(self.reject)
        edit = (self.add_button, self.remove_button, self.up, self.down)
        fill_page(
            self,
            (self.list, 1),
            self.hint,
            row_of(*captioned(self.tr("At the e&nd"), self.repeat), STRETCH),
            row_of(*edit, STRETCH, close),
        )

    def refresh(self) -> None:
        """Show the list and what plays of it."""
        playlist, row = self._playlist, self.list.currentRow()
        self.list.blockSignals(True)
        self.list.clear()
        for path in playlist.paths if playlist.is_chosen else ():
            item = QListWidgetItem(path.name)
            item.setToolTip(str(path))
            item.setData(Qt.ItemDataRole.UserRole, path)
            font = QFont(self.list.font())
            font.setBold(path == playlist.current)
            item.setFont(font)
            self.list.addItem(item)
        self.list.setCurrentRow(min(row, self.list.count() - 1))
        self.list.blockSignals(False)
        self.hint.setText(
            self.tr("Clips play one after the other.")
            if playlist.is_chosen
            else self.tr(
                "The list is empty. Add videos, or drop videos and sequences here. Without "
                "a list, Next and Previous play what is in the folder of the clip."
            )
        )
        for button in (self.remove_button, self.up, self.down):
            button.setEnabled(playlist.is_chosen)
        self.repeat.setCurrentIndex(self.repeat.findData(playlist.repeat))

    def add(self, paths: list[Path]) -> None:
        """Put clips at the end of the list."""
        known = self._playlist.paths if self._playlist.is_chosen else []
        self._playlist.set_paths([*known, *filter(is_playable, paths)])

    def remove(self) -> None:
        gone = {self._path(item) for item in self.list.selectedItems()}
        self._playlist.set_paths(p for p in self._playlist.paths if p not in gone)

    def move_by(self, steps: int) -> None:
        """Move the current clip in the list."""
        row = self.list.currentRow()
        to = row + steps
        if row < 0 or not 0 <= to < self.list.count():
            return
        paths = list(self._playlist.paths)
        paths.insert(to, paths.pop(row))
        self._playlist.set_paths(paths)
        self.list.setCurrentRow(to)

    def _keep(self) -> None:
        items = (self.list.item(row) for row in range(self.list.count()))
        self._playlist.set_paths(self._path(item) for item in items)

    def _choose_repeat(self) -> None:
        self._playlist.repeat = self.repeat.currentData()
        self._playlist.changed.emit()

    def _play(self, item: QListWidgetItem) -> None:
        self._playlist.play(self._path(item))

    @staticmethod
    def _path(item: QListWidgetItem) -> Path:
        found: Path = item.data(Qt.ItemDataRole.UserRole)
        return found

    def _ask(self) -> None:
        dialog = file_dialog(self, self.tr("Add videos"), self._folder, video_filter())
        dialog.setFileMode(dialog.FileMode.ExistingFiles)
        dialog.filesSelected.connect(lambda found: self.add([Path(p) for p in found]))
        dialog.open()
