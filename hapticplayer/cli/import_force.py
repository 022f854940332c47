"""The command `import-force`: force made elsewhere as a track of a sequence."""

import argparse
import json
from pathlib import Path
from typing import Any

from hapticplayer.cli.common import say, say_aside, shown_progress
from hapticplayer.cli.force_options import add_reading, read_choices, read_text
from hapticplayer.errors import UsageError, to_json
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.excursion import stored_texts
from hapticplayer.sequence.force_formats import format_of, read_force, read_formats
from hapticplayer.sequence.force_import import import_force


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("file", metavar="FILE", help=read_text())
    command.add_argument(
        "sequence", metavar="SEQUENCE", nargs="?", help="gets the track"
    )
    command.add_argument(
        "--check",
        action="store_true",
        help="only say what of FILE would be read and what not; status 2 if it is not "
        "all, 1 if FILE would be refused",
    )
    command.add_argument(
        "--name",
        help="name of the track, for `play --feedback` (default: that of FILE)",
    )
    command.add_argument(
        "--format", choices=list(read_formats()), help="(default: by the name of FILE)"
    )
    add_reading(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Add the track, and say what was assumed and what was not understood."""
    if options.check:
        return _check(options)
    if options.sequence is None:
        raise UsageError("import-force needs a SEQUENCE, or --check")
    path, folder = Path(options.file), Path(options.sequence)
    name = options.name or path.name.split(".")[0][:40]
    with shown_progress() as progress:
        notes = import_force(
            folder,
            name,
            path,
            choices=read_choices(options),
            form=options.format,
            progress=progress,
        )
    description = open_sequence(folder).description
    texts: list[str] = [*notes, *stored_texts(description, name)]
    made = description.feedbacks[name]
    if options.json:
        report = {
            "sequence": str(folder),
            "feedback": name,
            "peak_n": made.peak_n,
            "rms_n": made.rms_n,
            "notes": [to_json(note) for note in texts],
        }
        say(json.dumps(report))
        return 0
    for note in texts:
        say_aside(note)
    say(f"{folder}: track {name!r}, force peak {made.peak_n or 0.0:.2f} N")
    return 0


def _check(options: argparse.Namespace) -> int:
    """Say what would be read and what not; 2 if a part would be lost."""
    if options.sequence is not None or options.name is not None:
        raise UsageError("--check takes no SEQUENCE and no --name")
    path = Path(options.file)
    form = format_of(path, options.format)
    found = read_force(path, read_choices(options), form.name)
    report: dict[str, Any] = {
        "file": str(path),
        "format": form.name,
        "end_s": float(found.track.time_s[-1]),
        "peak_n": found.track.peak_n(),
        "assumed": [to_json(note) for note in found.assumed],
        "unread": [to_json(note) for note in found.unread],
    }
    if options.json:
        say(json.dumps(report))
    else:
        say(
            f"{path}: {form.name}, force until {report['end_s']:.3f} s, peak "
            f"{report['peak_n']:.2f} N"
        )
        for note in found.notes:
            say(f"{path}: {note}")
        say(f"{path}: {'only a part' if found.unread else 'all'} of it would be read")
    return 2 if found.unread else 0
