"""Keeping the user's copy of the Falcon's firmware: a file, its licence, a decision."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from app.bridge.languages import translated
from app.player import setup_texts
from app.player.question import ask
from app.widgets.files import file_dialog
from hapticplayer.devices.falcon import firmware
from hapticplayer.errors import HapticPlayerError, message_of

translate = QCoreApplication.translate


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


def _ask(parent: QWidget, text: str, yes: str, agreed: Callable[[], None]) -> None:
    title = translate("FirmwareDialog", "The Falcon's firmware")
    ask(parent, title, text, yes, agreed)
