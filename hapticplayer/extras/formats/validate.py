"""The command `validate`: whether a file of force is one that other software takes."""

import argparse
import json
from pathlib import Path

from hapticplayer.cli.common import say
from hapticplayer.errors import to_json
from hapticplayer.extras.formats.hjif_check import HjifFinding, check
from hapticplayer.sequence.force_formats import format_of, read_force, read_formats


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "file",
        metavar="FILE",
        help="hjif is checked by the rules of the published reference loader (except "
        "its JSON schema, which is not public), other formats by reading them",
    )
    command.add_argument("--format", choices=list(read_formats()))
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """List what is wrong; 1 if the file would be refused."""
    path = Path(options.file)
    form = format_of(path, options.format)
    findings: list[HjifFinding] = check(path) if form.name == "hjif" else []
    is_refused = any(one.is_refusal for one in findings)
    notes = () if is_refused else read_force(path, name=form.name).notes
    if options.json:
        report = {
            "file": str(path),
            "format": form.name,
            "refused": is_refused,
            "findings": [
                {"refusal": f.is_refusal, "where": f.where, "what": f.what}
                for f in findings
            ],
            "notes": [to_json(note) for note in notes],
        }
        say(json.dumps(report))
        return int(is_refused)
    for one in findings:
        word = "refused" if one.is_refusal else "left out"
        say(f"{path}: {word}: {one.where}: {one.what}")
    for note in notes:
        say(f"{path}: note: {note}")
    if not findings:
        say(f"{path}: nothing is wrong")
    return int(is_refused)
