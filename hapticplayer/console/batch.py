"""Imports several videos, each with the log beside it; what fails stops no other."""

import argparse
import json
from dataclasses import asdict, dataclass
from pathlib import Path

from hapticplayer.console.recordings import chosen_import
from hapticplayer.console.speech import interruptible, say, shown_progress
from hapticplayer.errors import Cancelled, HapticPlayerError, UsageError
from hapticplayer.media import read_telemetry_packets
from hapticplayer.sequence import build_sequence, open_sequence
from hapticplayer.sequence.build import Choices
from hapticplayer.sequence.files import Progress

LOG_ENDINGS = (".csv", ".txt", ".zip", ".gcsv")


@dataclass(frozen=True, slots=True)
class Row:
    """What became of one video.

    Attributes:
        video: its name.
        sequence: the new folder, or "" where there is none.
        status: 0 done, 1 refused, 2 a person has to decide.
        text: the offset and its confidence, or what was wrong.
    """

    video: str
    sequence: str
    status: int
    text: str


def import_batch(options: argparse.Namespace) -> int:
    """Import all videos and print a summary; the status is the worst but 2 of doubt.

    Raises:
        UsageError: for options that only one video can have.
    """
    for name in ("imu", "offset", "title"):
        if getattr(options, name) is not None:
            raise UsageError(f"--{name} belongs to one video; import them one by one")
    videos = [Path(video) for video in options.videos]
    names = [video.stem for video in videos]
    if len(set(names)) < len(names):
        raise UsageError("two videos have one name; import them into different folders")
    choices, rows = chosen_import(options), []
    with interruptible():
        for video in videos:
            with shown_progress() as progress:
                target = Path(options.output) / video.stem
                rows.append(_import(video, target, choices, progress))
    if options.json:
        say(json.dumps([asdict(row) for row in rows], ensure_ascii=False))
    else:
        _say(rows)
    statuses = {row.status for row in rows}
    return 1 if 1 in statuses else max(statuses)


def log_beside(video: Path) -> Path | None:
    """Return the log that has a video's name, where the video has no motion itself."""
    if read_telemetry_packets(video):
        return None
    found = (video.with_suffix(ending) for ending in LOG_ENDINGS)
    return next((path for path in found if path.is_file()), None)


def _import(video: Path, target: Path, choices: Choices, progress: Progress) -> Row:
    try:
        log = log_beside(video)
        folder = build_sequence(
            video, target, imu_log=log, choices=choices, progress=progress
        )
        description = open_sequence(folder).description
    except Cancelled:
        raise
    except UsageError as problem:
        return Row(video.name, "", 2, str(problem))
    except HapticPlayerError as problem:
        return Row(video.name, "", 1, str(problem))
    clock, made_of = description["clock_map"], description["provenance"]
    method = made_of["synchronisation"]["method"]
    text = (
        f"{description['clip']['duration_s']:.1f} s at {made_of['imu_rate_hz']:.0f} Hz, "
        f"offset {clock['offset_s']:.3f} s by {method} "
        f"(confidence {clock['confidence']:.2f}), {len(made_of['notes'])} notes"
    )
    return Row(video.name, str(folder), 0, text)


def _say(rows: list[Row]) -> None:
    words = ("done", "refused", "to be decided")
    width = max(len(row.video) for row in rows)
    for row in rows:
        say(f"{row.video:<{width}}  {words[row.status]:<13}  {row.text}")
    counts = [sum(row.status == status for row in rows) for status in (0, 1, 2)]
    named = zip(counts, words, strict=True)
    say(f"{len(rows)} videos: " + ", ".join(f"{n} {word}" for n, word in named))
