"""Help: what this program is."""

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.widgets.buttons import text_button
from app.widgets.icons import icon
from hapticplayer import __version__

translate = QCoreApplication.translate

_TEXT_PX = 320


def about_dialog(parent: QWidget) -> QDialog:
    """Return a dialog that says what this is."""
    dialog, column = _dialog(parent, translate("Help", "About hapticplayer"))
    picture = QLabel()
    picture.setPixmap(icon("hapticplayer").pixmap(QSize(56, 56)))
    text = QLabel(
        translate(
            "Help",
            "<b>hapticplayer {version}</b><p>Plays a video and lets you feel the "
            "motion of whoever recorded it.</p><p>After Danieau et al., A "
            "Framework for Enhancing Video Viewing Experience with Haptic Effects of "
            "Motion (2012).<br>MIT licence.</p>",
        ).format(version=__version__)
    )
    text.setTextFormat(Qt.TextFormat.RichText)
    text.setWordWrap(True)
    text.setMinimumWidth(_TEXT_PX)
    # a dialog asks for the height of its texts at another width than they get
    text.setMinimumHeight(text.heightForWidth(_TEXT_PX))
    row = QHBoxLayout()
    row.setSpacing(16)
    row.addWidget(picture, 0, Qt.AlignmentFlag.AlignTop)
    row.addWidget(text, 1)
    column.addLayout(row)
    return _closed_by_button(dialog, column)


def _dialog(parent: QWidget, title: str) -> tuple[QDialog, QVBoxLayout]:
    dialog = QDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    column = QVBoxLayout(dialog)
    column.setContentsMargins(18, 16, 18, 14)
    column.setSpacing(14)
    return dialog, column


def _closed_by_button(dialog: QDialog, column: QVBoxLayout) -> QDialog:
    close = text_button(translate("Help", "Close"), "")
    close.setDefault(True)
    close.clicked.connect(dialog.accept)
    row = QHBoxLayout()
    row.addStretch(1)
    row.addWidget(close)
    column.addLayout(row)
    return dialog
