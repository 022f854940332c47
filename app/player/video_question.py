"""Asks whether force may be felt with another video than it was made for."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QMessageBox, QWidget

from app.bridge.languages import translated
from app.widgets.texts import capitalised
from hapticplayer.playback.source import Source
from hapticplayer.playback.video_check import ANOTHER_VIDEO

translate = QCoreApplication.translate


def video_question(source: Source, parent: QWidget | None) -> QMessageBox:
    """Return the question; declined, the video plays on without force."""
    box = QMessageBox(
        QMessageBox.Icon.Warning,
        translate("VideoQuestion", "Another video"),
        capitalised(translated(ANOTHER_VIDEO)) + ".",
        parent=parent,
    )
    box.setInformativeText(
        translate(
            "VideoQuestion",
            "What is felt may not be what is seen. Feel the force anyway?",
        )
    )
    roles = QMessageBox.ButtonRole
    felt = box.addButton(
        translate("VideoQuestion", "&Feel the force"), roles.AcceptRole
    )
    without = box.addButton(
        translate("VideoQuestion", "Play &without"), roles.RejectRole
    )
    box.setDefaultButton(without)
    box.setEscapeButton(without)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    if source.check is not None:
        felt.clicked.connect(source.check.accept)
    return box
