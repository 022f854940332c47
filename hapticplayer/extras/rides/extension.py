"""Simulated rides with known truth."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command

_HERE = "hapticplayer.extras.rides"


def commands() -> "tuple[Command, ...]":
    """The command `simulate`."""
    from hapticplayer.cli import Command

    summary = "make a simulated ride with known truth"
    return (Command("simulate", summary, f"{_HERE}.command"),)
