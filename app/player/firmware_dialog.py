"""Keeping the user's copy of the Falcon's firmware: a file, its licence, a decision."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QDialog, QWidget

from app.bridge.languages import translated
from app.player import setup_texts
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of
from hapticplayer.devices.falcon import firmware
from hapticplayer.errors import HapticPlayerError, message_of

translate = QCoreApplication.translate

_WIDTH_PX = 460


def ask_for_firmware(
    parent: QWidget, kept: Callable[[], None], failed: Callable[[str], None]
) -> None:
    """Let a person choose the file, accept its licence, and keep it.

    None of the dialogs stops the event loop; `kept` is called once there is a copy.
    """
    title = translate("FirmwareDialog", "The Falcon's firmware")
    kinds = translate("FirmwareDialog", "Firmware (*.bin *.BIN);;All files (*)")
    dialog = file_dialog(parent, title, str(Path.home()), kinds)
    dialog.fileSelected.connect(
        lambda name: offer_firmware(parent, Path(name), kept, failed)
    )
    dialog.open()


def offer_firmware(
    parent: QWidget,
    path: Path,
    kept: Callable[[], None],
    failed: Callable[[str], None],
) -> None:
    """Ask whether its licence is accepted, then keep it."""
    accept = translate("FirmwareDialog", "I accept the licence")
    keep = translate("FirmwareDialog", "Install anyway")

    def install(*, accept_unknown: bool = False) -> None:
        try:
            firmware.install_image(path, accept_unknown=accept_unknown)
        except firmware.UnknownFirmwareError:
            _ask(
                parent,
                setup_texts.unknown_image(),
                keep,
                lambda: install(accept_unknown=True),
            )
        except HapticPlayerError as problem:
            failed(translated(message_of(problem)))
        else:
            kept()

    _ask(parent, setup_texts.licence(), accept, install)


class Question(QDialog):
    """A text with two answers."""

    def __init__(self, parent: QWidget, text: str, yes: str) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(translate("FirmwareDialog", "The Falcon's firmware"))
        self.text = paragraph(text)
        self.text.setMinimumWidth(_WIDTH_PX)
        self.yes = text_button(yes, "", "primary")
        self.no = text_button(translate("FirmwareDialog", "Cancel"), "")
        self.yes.clicked.connect(self.accept)
        self.no.clicked.connect(self.reject)
        fill_page(self, self.text, row_of(STRETCH, self.no, self.yes), spacing=14)


def _ask(parent: QWidget, text: str, yes: str, agreed: Callable[[], None]) -> None:
    question = Question(parent, text, yes)
    question.accepted.connect(agreed)
    question.open()
