"""Windows no larger than the screen that they are on."""

from PySide6.QtWidgets import QWidget


def resize_within_screen(window: QWidget, width_px: int, height_px: int) -> None:
    """Give a window a size, or less where the screen has no room for it.

    At a scale of 200 % a screen of 1920 x 1080 pixels has room for half as many.
    """
    room = window.screen().availableGeometry()
    window.resize(min(width_px, room.width()), min(height_px, room.height()))
