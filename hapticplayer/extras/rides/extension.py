"""Simulated rides with known truth, and the demo that is drawn from one."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli import Command
    from hapticplayer.sequence.demo import Demo

_HERE = "hapticplayer.extras.rides"


def commands() -> "tuple[Command, ...]":
    """The command `simulate`."""
    from hapticplayer.cli import Command

    summary = "make a simulated ride with known truth"
    return (Command("simulate", summary, f"{_HERE}.command"),)


def demos() -> "tuple[Demo, ...]":
    """The built-in demo."""
    from hapticplayer.sequence.demo import Demo

    return (Demo("demo", f"{_HERE}.recordings:write_simulated_sequence"),)
