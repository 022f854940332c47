"""The markers of a timeline as a list: where they are, and their names."""

from collections.abc import Iterable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.rendering.effects import TimeMarker

_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
_DELETE = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace)
_NAME = 1


class _OnlyNames(QStyledItemDelegate):
    """Lets people edit the column of names."""

    def createEditor(  # noqa: N802 - Qt's name
        self,
        parent: QWidget,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> QWidget:
        if index.column() != _NAME:
            return None  # type: ignore[return-value] # as Qt asks for it
        return super().createEditor(parent, option, index)


class MarkerList(QTreeWidget):
    """Enter or a click goes to a marker, F2 renames it, Delete removes it."""

    wanted = Signal(float)
    """The cursor is to go to this time."""

    renamed = Signal(object, str)
    removed = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._markers: tuple[TimeMarker, ...] = ()
        self.setAccessibleName(self.tr("Markers"))
        self.setToolTip(self.tr("Enter goes there, F2 renames, Delete removes"))
        self.setColumnCount(2)
        self.setHeaderHidden(True)
        self.setRootIsDecorated(False)
        self.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        triggers = QTreeWidget.EditTrigger
        self.setEditTriggers(triggers.EditKeyPressed | triggers.DoubleClicked)
        self.setItemDelegate(_OnlyNames(self))
        self.itemChanged.connect(self._on_changed)
        self.itemClicked.connect(
            lambda item: self._go_to(self.indexOfTopLevelItem(item))
        )

    def show_markers(self, markers: Iterable[TimeMarker]) -> None:
        """Show these; the row stays where it was."""
        markers = tuple(markers)
        if markers == self._markers:
            return
        row = self._row()
        self._markers = markers
        self.blockSignals(True)
        self.clear()
        for marker in markers:
            time = local(f"{marker.time_s:.3f} s")
            item = QTreeWidgetItem(self, [time, marker.name])
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
            item.setToolTip(_NAME, marker.name)
        if markers:
            self.choose(min(max(row, 0), len(markers) - 1))
        self.blockSignals(False)

    def choose(self, number: int) -> None:
        if item := self.topLevelItem(number):
            self.setCurrentItem(item)

    def _row(self) -> int:
        item = self.currentItem()
        return -1 if item is None else self.indexOfTopLevelItem(item)

    def _go_to(self, row: int) -> None:
        if row >= 0:
            self.wanted.emit(self._markers[row].time_s)

    def _on_changed(self, item: QTreeWidgetItem) -> None:
        marker = self._markers[self.indexOfTopLevelItem(item)]
        name = item.text(_NAME).strip()
        if name and name != marker.name:
            self.renamed.emit(marker, name)
        else:
            item.setText(_NAME, marker.name)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        row, item = self._row(), self.currentItem()
        if item is None:
            super().keyPressEvent(event)
        elif event.key() in _ENTER:
            self._go_to(row)
        elif event.key() in _DELETE:
            self.removed.emit(self._markers[row])
        elif event.key() == Qt.Key.Key_F2:
            self.editItem(item, _NAME)
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._markers:
            return
        with QPainter(self.viewport()) as painter:
            painter.setPen(QColor(theme.DIM))
            room = self.viewport().rect().adjusted(8, 8, -8, -8)
            flags = Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
            text = self.tr("No markers yet. M sets one at the cursor.")
            painter.drawText(room, int(flags), text)
