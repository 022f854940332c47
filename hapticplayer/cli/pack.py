"""The command `pack`: a sequence as one video file, to send to someone."""

import argparse
import json
from pathlib import Path
from typing import Any

from msgspec import to_builtins

from hapticplayer.cli.common import add_overwrite, say, shown_progress
from hapticplayer.sequence.contents import Contents
from hapticplayer.sequence.pack import container_of, is_packed, outputs_of
from hapticplayer.sequence.sharing import share, shared_contents
from hapticplayer.storage import FILE, refuse_existing
from hapticplayer.untrusted import without_controls

_ALONG, _LEFT = "included", "left out, see --with-places"


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("sequence", metavar="SEQUENCE")
    command.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="FILE",
        help="FILE.mkv: one file that every player plays and this one makes felt; "
        "FILE.mp4: the video, with its force beside it in FILE.haptics.mkv",
    )
    command.add_argument(
        "--with-motion",
        action="store_true",
        help="also the motion and the recorded samples, from which others can render "
        "another force",
    )
    command.add_argument(
        "--with-places",
        action="store_true",
        help="also names of the original files, dates, numbers of devices, and with "
        "--with-motion in an MP4 the camera's own track, which may hold places",
    )
    command.add_argument(
        "--dry-run", action="store_true", help="say what it would hold, write nothing"
    )
    add_overwrite(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Say what a file for sharing holds, and write it."""
    folder, target = Path(options.sequence), Path(options.output)
    is_ours = is_packed if options.overwrite else None
    container_of(target)
    for path in outputs_of(target):
        refuse_existing(path, FILE, is_ours)
    what = shared_contents(
        folder, with_motion=options.with_motion, with_places=options.with_places
    )
    report = {"outputs": [str(path) for path in outputs_of(target)], **listing(what)}
    if not options.json:
        say(text_of(what, with_track=target.suffix.lower() == ".mp4"))
    if not options.dry_run:
        with shown_progress() as progress:
            payload = share(
                folder,
                target,
                with_motion=options.with_motion,
                with_places=options.with_places,
                is_ours=is_ours,
                progress=progress,
            )
        report["video"] = {**report["video"], **to_builtins(payload)}
        report["written_bytes"] = sum(
            path.stat().st_size for path in outputs_of(target)
        )
        if not options.json:
            names = " and ".join(map(str, outputs_of(target)))
            say(f"{names}: {megabytes(report['written_bytes'])}")
    if options.json:
        say(json.dumps(report, ensure_ascii=False))
    return 0


def listing(what: Contents) -> dict[str, Any]:
    """The contents of a file as plain values."""
    return {
        "title": what.title,
        "feedbacks": list(what.feedbacks),
        "has_motion": what.has_motion,
        "size_bytes": what.size_bytes,
        "personal": [[str(one.text), one.value] for one in what.personal],
        "with_places": what.with_places,
        "video": {"name": what.video.name, "size_bytes": what.video.size_bytes},
        "attached": [
            {
                "name": part.name,
                "what": str(part.text),
                "media_type": part.media_type,
                "size_bytes": part.size_bytes,
            }
            for part in what.attached
        ],
    }


def text_of(what: Contents, *, with_track: bool = False) -> str:
    """The contents of a file as a table; see `Contents.told`."""
    parts = [
        f"  {part.name:24.24} {megabytes(part.size_bytes):>10}  {part.text}"
        for part in (what.video, *what.attached)
    ]
    head = f"{what.title} - feedbacks {', '.join(what.feedbacks)}"
    whole = f"  {'together':24} {megabytes(what.size_bytes):>10}"
    told = [
        f"  {_ALONG if along else _LEFT}: {one.text} {one.value}".rstrip()
        for one, along in what.told(with_track=with_track)
    ]
    return without_controls("\n".join([head, *parts, whole, *told]), "\n")


def megabytes(size_bytes: int) -> str:
    return f"{1e-6 * size_bytes:.{3 if size_bytes < 1e6 else 1}f} MB"
