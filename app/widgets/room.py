"""Windows and their screen: how much room there is, and whether they are seen."""

from PySide6.QtWidgets import QWidget


def resize_within_screen(window: QWidget, width_px: int, height_px: int) -> None:
    """Give a window a size, or less where the screen has no room for it.

    At a scale of 200 % a screen of 1920 x 1080 pixels has room for half as many.
    """
    room = window.screen().availableGeometry()
    window.resize(min(width_px, room.width()), min(height_px, room.height()))


def is_seen(widget: QWidget) -> bool:
    """Return whether a widget may be on a screen; else it need not be drawn.

    Not hidden, not in a minimised window (which X11 without a window manager goes on
    to expose). Whether another window covers it is known only where the desktop tells Qt
    (macOS, some of Wayland's); on X11 it counts as seen, and so it does where in doubt.
    """
    window = widget.window()
    handle = window.windowHandle()
    is_open = widget.isVisible() and not window.isMinimized()
    return is_open and bool(handle) and handle.isExposed()
