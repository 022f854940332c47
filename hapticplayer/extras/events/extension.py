"""What happens in a recording, such as impacts, and what may be made of it."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.cli import Command
    from hapticplayer.sequence.events import EventDetector

_HERE = "hapticplayer.extras.events"


def commands() -> "tuple[Command, ...]":
    """The command `events`."""
    from hapticplayer.cli import Command

    summary = "list what happens in a sequence, such as impacts"
    return (Command("events", summary, f"{_HERE}.command"),)


def event_detectors() -> "tuple[EventDetector, ...]":
    """A row for each kind of event."""
    from hapticplayer.sequence.events import EventDetector

    rows = (
        (
            "impact",
            Message("Impact"),
            Message("Shocks that stand out of what surrounds them"),
        ),
        ("braking", Message("Braking"), Message("Speed is lost at 0.3 g or more")),
        ("turn", Message("Turn"), Message("Bends with 0.15 g or more sideways")),
        (
            "stillness",
            Message("Stillness"),
            Message("A second or more without motion"),
        ),
        (
            "saturation",
            Message("Saturation"),
            Message("A sensor at the end of its range"),
        ),
        (
            "artefact",
            Message("Artefact"),
            Message("Missing samples and isolated spikes"),
        ),
    )
    find = f"{_HERE}.detectors:events_heard"
    return tuple(EventDetector(*row, find) for row in rows)
