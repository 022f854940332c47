"""The kinds of effects, to be dragged onto the timeline."""

from collections.abc import Sequence

from PySide6.QtCore import QMimeData, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.bridge.languages import translated
from hapticplayer.rendering.effects import EFFECTS

MIME = "application/x-hapticplayer-effect"
_KIND = int(Qt.ItemDataRole.UserRole)
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
_BESIDE_PX = 40


class KindList(QListWidget):
    """Drag puts an effect where it is dropped, Enter and double click at the cursor."""

    wanted = Signal(str)
    """Name of the kind that is to be added at the cursor."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Kinds of effects"))
        self.setToolTip(self.tr("Drag onto the timeline; Enter adds at the cursor"))
        self.setDragEnabled(True)
        self.setDragDropMode(QListWidget.DragDropMode.DragOnly)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        for kind in EFFECTS:
            item = QListWidgetItem(translated(kind.text))
            item.setData(_KIND, kind.name)
            self.addItem(item)
        self.setCurrentRow(0)
        self.setMinimumWidth(self.sizeHintForColumn(0) + _BESIDE_PX)
        self.itemDoubleClicked.connect(lambda item: self.wanted.emit(item.data(_KIND)))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _ENTER:
            self.wanted.emit(self.currentItem().data(_KIND))
        else:
            super().keyPressEvent(event)

    def mimeData(  # noqa: N802 - Qt's name
        self, items: Sequence[QListWidgetItem]
    ) -> QMimeData:
        data = QMimeData()
        for item in items:
            data.setData(MIME, str(item.data(_KIND)).encode())
        return data


def kind_in(data: QMimeData) -> str:
    """Return the name of the kind that is dragged, "" for anything else."""
    name = bytes(data.data(MIME).data()).decode(errors="replace")
    return name if name in {kind.name for kind in EFFECTS} else ""
