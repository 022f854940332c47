"""A small web server for a packed file on a local network: the command `serve`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command


def commands() -> "tuple[Command, ...]":
    """The command `serve`."""
    from hapticplayer.cli import Command

    summary = "let others play a packed file over the network"
    return (Command("serve", summary, "hapticplayer.extras.serve.command"),)
