"""What the motion rigs add to the window."""

from typing import Any

from PySide6.QtCore import Qt

from app.player.command import Command

RIG = "rig:outsim"


def commands() -> tuple[Command[Any], ...]:
    """A simulated rig to look at."""
    return (Command("rig", "Simulated &motion rig\u2026", "device", 2, show_rig),)


def show_rig(window: Any) -> None:
    """Show what a motion rig at the other end would do."""
    from app.extras.rigs.panel import RigPanel

    def play() -> None:
        names = window.player.output_names
        if RIG not in names:
            window.dialogs.choose([*names, RIG])

    panel = window.findChild(RigPanel)
    if panel is None:
        panel = RigPanel(window.clock, window)
        panel.play_wanted.connect(play)
    panel.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    panel.show()
