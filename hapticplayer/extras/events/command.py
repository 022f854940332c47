"""The command `events`: what happens in a sequence, and what to make of it."""

import argparse
import json

from hapticplayer.cli.common import say
from hapticplayer.sequence.effects_file import described_effect
from hapticplayer.sequence.events import Event, event_detectors, events_of


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    known = event_detectors()
    listed = "; ".join(f"{one.name}: {one.text.lower()}" for one in known.values())
    command.set_defaults(run=run)
    command.add_argument("sequence", metavar="SEQUENCE", help="nothing in it changes")
    command.add_argument(
        "--kind",
        action="append",
        choices=list(known),
        help=f"one kind, or several by repeating it (default: all). {listed}",
    )
    command.add_argument(
        "--sound",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="let the sound of the clip confirm impacts (default: yes)",
    )
    command.add_argument("--json", action="store_true", help="print them as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Print the events of a sequence."""
    events = events_of(options.sequence, kinds=options.kind, with_sound=options.sound)
    if options.json:
        listed = [_described(event) for event in events]
        content = {"sequence": options.sequence, "events": listed}
        say(json.dumps(content, ensure_ascii=False))
        return 0
    for event in events:
        say(_line(event))
    say(f"{len(events)} events")
    return 0


def _described(event: Event) -> dict[str, object]:
    """The event as JSON; its effect is as in an `effects.json`."""
    return {
        "kind": event.kind,
        "start_s": event.start_s,
        "end_s": event.end_s,
        "confidence": event.confidence,
        "text": event.text,
        "effect": described_effect(event.effect),
    }


def _line(event: Event) -> str:
    numbers = [f"{name} {value:g}" for name, value in event.effect.parameters.items()]
    return (
        f"{event.start_s:8.2f} to {event.end_s:8.2f} s  {event.kind:<10}  "
        f"{event.confidence:4.0%}  {event.text} "
        f"(effect: {', '.join([event.effect.kind, *numbers])})"
    )
