"""A packed file over HTTP: played from any web server, and served on a local network."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command
    from hapticplayer.cli.play import RemoteSource


def commands() -> "tuple[Command, ...]":
    """The command `serve`."""
    from hapticplayer.cli import Command

    summary = "let others play a packed file over the network"
    return (Command("serve", summary, "hapticplayer.extras.web.serving"),)


def sources() -> "tuple[RemoteSource, ...]":
    """What web servers offer."""
    from hapticplayer.cli.play import RemoteSource

    home = "hapticplayer.extras.web.http_clip:HttpClip"
    return (RemoteSource("web", ("http", "https"), home),)
