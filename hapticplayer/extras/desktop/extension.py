"""The command `desktop`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command


def commands() -> "tuple[Command, ...]":
    """The command `desktop`."""
    from hapticplayer.cli import Command

    summary = "add the program to the desktop's menu and kinds of files"
    here = "hapticplayer.extras.desktop.command"
    return (Command("desktop", summary, here, ("install", "remove")),)
