"""The command `convert`: force from one format to another."""

import argparse
import json
from pathlib import Path

from hapticplayer.cli.common import add_overwrite, say, say_aside
from hapticplayer.cli.force_options import (
    add_reading,
    add_writing,
    read_choices,
    read_text,
    write_choices,
    written_text,
)
from hapticplayer.errors import to_json
from hapticplayer.sequence.force_formats import (
    export_track,
    format_of,
    loss_line,
    read_force,
    read_formats,
    written_formats,
)
from hapticplayer.storage import FILE, refuse_existing


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("source", metavar="A", help=read_text())
    command.add_argument("target", metavar="B", help=written_text())
    command.add_argument("--from", dest="read_as", choices=list(read_formats()))
    command.add_argument("--to", dest="write_as", choices=list(written_formats()))
    add_reading(command)
    add_writing(command)
    add_overwrite(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Convert, and say what was assumed, its size and largest error."""
    source, target = Path(options.source), Path(options.target)
    form = format_of(target, options.write_as)
    is_ours = form.is_ours if options.overwrite else None
    refuse_existing(target, FILE, is_ours)
    found = read_force(source, read_choices(options), options.read_as)
    cost = export_track(found.track, target, form, write_choices(options))
    if options.json:
        notes = [to_json(note) for note in found.notes]
        say(
            json.dumps(
                {"output": str(target), "format": form.name, **cost, "notes": notes}
            )
        )
        return 0
    for note in found.notes:
        say_aside(note)
    say(f"{target}: {loss_line(cost)}")
    return 0
