"""The command `unpack`: a sequence from a file that was packed."""

import argparse
import json
from pathlib import Path

from hapticplayer.cli.common import (
    add_accept_changed,
    say,
    shown_progress,
)
from hapticplayer.cli.pack import listing, text_of
from hapticplayer.errors import UsageError
from hapticplayer.sequence.contents import contents_of
from hapticplayer.sequence.unpack import require_packed, unpack
from hapticplayer.storage import FOLDER, refuse_existing


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "video",
        metavar="FILE",
        help="written by `pack`; .mp4 with its side-car beside it",
    )
    command.add_argument("-o", "--output", metavar="DIR", help="a new sequence")
    command.add_argument(
        "--dry-run", action="store_true", help="say what it holds, write nothing"
    )
    add_accept_changed(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Say what a file holds, and write the folder of the sequence."""
    if options.output is None and not options.dry_run:
        raise UsageError("give the new folder with -o DIR, or --dry-run to look only")
    if options.output is not None:
        refuse_existing(Path(options.output), FOLDER)
    packed = require_packed(Path(options.video))
    what = contents_of(packed)
    report = {"file": options.video, "force_in": str(packed.carrier), **listing(what)}
    if not options.dry_run:
        with shown_progress() as progress:
            unpack(
                Path(options.video),
                Path(options.output),
                accepts_changed=options.accept_changed_video,
                progress=progress,
            )
        report["sequence"] = options.output
    say(json.dumps(report, ensure_ascii=False) if options.json else text_of(what))
    return 0
