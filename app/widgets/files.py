"""Choosing files and folders without stopping the window."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QFileDialog, QRubberBand, QWidget


def video_filter() -> str:
    """Return the kinds of files that a file dialog offers."""
    return QCoreApplication.translate(
        "Files",
        "Videos (*.mp4 *.mov *.mkv *.avi *.webm *.m4v *.360 *.MP4 *.MOV *.LRV);;"
        "All files (*)",
    )


def settings_filter() -> str:
    return QCoreApplication.translate("Files", "Settings (*.json)")


def file_dialog(parent: QWidget, title: str, folder: str, kinds: str) -> QFileDialog:
    """Return a dialog that chooses a file; show it with `open`."""
    dialog = QFileDialog(parent, title, folder, kinds)
    dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    return dialog


def folder_dialog(parent: QWidget, title: str, folder: str) -> QFileDialog:
    """Return a dialog that chooses a folder; show it with `open`."""
    dialog = QFileDialog(parent, title, folder)
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    return dialog


class FileDrops(QObject):
    """Gives files that are dropped on a widget to `take`; a frame offers it before.

    They are always copied: a source that also offers to move them would delete them.
    """

    def __init__(self, target: QWidget, take: Callable[[list[Path]], None]) -> None:
        super().__init__(target)
        self._target, self._take = target, take
        self.frame = QRubberBand(QRubberBand.Shape.Rectangle, target)
        target.setAcceptDrops(True)
        target.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        if event.type() == QEvent.Type.DragLeave:
            self.frame.hide()
        if not isinstance(event, QDropEvent):  # what enters and moves is one, too
            return super().eventFilter(watched, event)
        urls = event.mimeData().urls()
        paths = [Path(url.toLocalFile()) for url in urls if url.isLocalFile()]
        is_welcome = bool(paths) and Qt.DropAction.CopyAction in event.possibleActions()
        if is_welcome:
            event.setDropAction(Qt.DropAction.CopyAction)
        event.setAccepted(is_welcome)
        is_drop = event.type() == QEvent.Type.Drop
        self.frame.setGeometry(self._target.rect())
        self.frame.setVisible(is_welcome and not is_drop)
        if is_welcome and is_drop:
            self._take(paths)
        return True
