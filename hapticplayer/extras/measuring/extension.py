"""`device measure`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command


def device_actions() -> "tuple[Command, ...]":
    """The action `device measure`."""
    from hapticplayer.cli import Command

    summary = "measure what is not known of a Falcon, at low force"
    return (Command("measure", summary, "hapticplayer.extras.measuring.command"),)
