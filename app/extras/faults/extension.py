"""What injected faults add to the window."""

from typing import Any

from app.player.command import Command


def commands() -> tuple[Command[Any], ...]:
    """The panel of faults."""
    return (Command("faults", "Inject fa&ults\u2026", "device", 2, show_faults),)


def show_faults(window: Any) -> None:
    """Show the panel that makes faults happen to the simulated device."""
    from app.extras.faults.panel import FaultPanel

    shown = window.findChild(FaultPanel)
    panel = shown or FaultPanel(window.clock, window.session, window)
    panel.show()
