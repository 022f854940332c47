"""What the motion rigs add to the window."""

from typing import Any

from PySide6.QtCore import Qt

from app.player.command import Command


def commands() -> tuple[Command[Any], ...]:
    """A simulated rig to look at."""
    return (Command("rig", "Simulated &motion rig\u2026", "device", 2, show_rig),)


def show_rig(window: Any) -> None:
    """Show what a motion rig at the other end would do."""
    from app.extras.rigs.panel import RigPanel

    panel = window.findChild(RigPanel) or RigPanel(window.clock, window)
    panel.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    panel.show()
