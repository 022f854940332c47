"""The options of a live source, which `record` and `feel` share."""

import argparse
import sys

from hapticplayer.capture.choices import parse_choices
from hapticplayer.capture.live.source import OpenedSource, live_sources, open_source
from hapticplayer.cli.common import say_aside
from hapticplayer.cli.recording_options import add_mounting
from hapticplayer.clock import Clock
from hapticplayer.errors import Message

STANDARD_INPUT = "csv:-"


def add_source(command: argparse.ArgumentParser, *, is_required: bool = False) -> None:
    """Add which source is read, as what, and how it is mounted."""
    names = ", ".join(row.name for row in live_sources())
    command.add_argument(
        "--imu",
        metavar="SOURCE",
        required=is_required,
        help="NAME:PLACE, such as wt901:/dev/ttyUSB0, as `record --list` shows it; one "
        f"of {names}" + ("" if is_required else " (default: without)"),
    )
    command.add_argument(
        "--read-as",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="what the source does not say of its numbers, such as accel-unit=g; asked "
        "once and kept for it (see docs/formats.md)",
    )
    add_mounting(command)


def opened_source(options: argparse.Namespace, clock: Clock) -> OpenedSource:
    """Open the source, and say what a person does at its other end."""
    source = open_source(options.imu, clock, parse_choices(options.read_as), _ask)
    if source.how:
        say_aside(source.how)
    return source


def _ask(question: Message) -> bool:
    if not sys.stdin.isatty():
        return False
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    return sys.stdin.readline().strip().lower() in ("y", "yes")
