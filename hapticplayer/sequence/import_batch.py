"""Several clips, each with the log that belongs to it, are imported one by one."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from hapticplayer.capture.choices import LogChoices, LogQuestion, parse_choices
from hapticplayer.capture.log_tables import header_of, kept_answers, kept_for
from hapticplayer.capture.reading import find_format
from hapticplayer.capture.recorded import is_take, parts_of
from hapticplayer.capture.source import open_source
from hapticplayer.errors import (
    HapticPlayerError,
    InputError,
    MediaError,
    Progress,
    SequenceError,
    UsageError,
    no_progress,
)
from hapticplayer.media.clip_info import probe
from hapticplayer.media.telemetry import read_telemetry_packets
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.import_preview import tables_of
from hapticplayer.sequence.library import free_name
from hapticplayer.sequence.packed import is_video_name
from hapticplayer.sequence.store import DESCRIPTION, read_description, verify_sequence
from hapticplayer.storage import StorageError, sha256_of

LOG_ENDINGS = (".csv", ".txt", ".zip", ".gcsv")

_DEPTH, _MOST_CLIPS = 3, 1000
_BUILDING = 0.9
"""Of the time, before what was built is read again."""


class Item(NamedTuple):
    """A clip and the files of its log; None for a log whose clip is not there."""

    video: Path | None
    logs: tuple[Path, ...] = ()

    @property
    def paths(self) -> list[Path]:
        return [*([self.video] if self.video else []), *self.logs]


class BroughtIn(NamedTuple):
    """The sequence of a clip, and whether it is new in the library."""

    folder: Path
    is_new: bool


def items_of(paths: Iterable[Path]) -> list[Item]:
    """Return clips with their logs, from files and folders that were chosen together.

    A single clip gets all logs; of several, each gets those of its name. A take that was
    recorded here is its own log.
    """
    chosen = list(paths)
    takes = [take for path in chosen for take in _takes(path)]
    made = [Item(clip, (log,) if log else ()) for clip, log, _ in map(parts_of, takes)]
    others = [path for path in chosen if not _takes(path)]
    files = list(dict.fromkeys(file for path in others for file in _files(path)))
    return made + _paired(files)


def _takes(path: Path) -> list[Path]:
    """A take, or those in a folder of takes."""
    if is_take(path) or not path.is_dir():
        return [path] if is_take(path) else []
    return sorted(inside for inside in path.iterdir() if is_take(inside))


def title_of(video: Path) -> str:
    """The name of a clip; all takes have one of the same name in their folders."""
    return video.parent.name if is_take(video.parent) else video.stem


def _paired(files: list[Path]) -> list[Item]:
    clips = [file for file in files if _is_clip(file)]
    logs = [file for file in files if file not in clips]
    if len(clips) == 1:
        return [Item(clips[0], tuple(logs))]
    if not clips:
        return [Item(None, tuple(logs))] if logs else []
    made = [
        Item(clip, tuple(log for log in logs if log.stem == clip.stem))
        for clip in clips
    ]
    used = {log for item in made for log in item.logs}
    return made + [Item(None, (log,)) for log in logs if log not in used]


def _is_clip(path: Path) -> bool:
    if is_video_name(path) or path.suffix.lower() in LOG_ENDINGS or path.is_dir():
        return is_video_name(path)
    try:
        probe(path)
    except InputError:
        return False
    return True


def _files(path: Path) -> list[Path]:
    """A file; of a folder its clips and their logs, or itself where it holds none."""
    if not path.is_dir():
        return [path]
    found = list(_inside(path, _DEPTH))
    clips = [file for file in found if is_video_name(file)][:_MOST_CLIPS]
    if not clips:
        return [path]
    logs = [file for file in found if file.suffix.lower() in LOG_ENDINGS]
    return clips + [log for log in logs if _belongs(log, clips, logs)]


def _belongs(log: Path, clips: list[Path], logs: list[Path]) -> bool:
    """Whether a log has the name of a clip, or is alone with a clip."""
    beside = [clip for clip in clips if clip.parent == log.parent]
    are_alone = len(clips) == len(beside) == 1
    rivals = [other for other in logs if other.parent == log.parent]
    is_named = any(clip.stem == log.stem for clip in beside)
    return is_named or (are_alone and len(rivals) == 1)


def _inside(folder: Path, depth: int) -> Iterator[Path]:
    """The files in a folder, without those of sequences, links and hidden ones."""
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError:
        return
    if any(entry.name == DESCRIPTION for entry in entries):
        return
    for entry in entries:
        if entry.name.startswith("."):
            continue
        if entry.is_file(follow_symlinks=False):
            yield Path(entry.path)
        elif depth > 1 and entry.is_dir(follow_symlinks=False):
            yield from _inside(Path(entry.path), depth - 1)


def is_log(path: Path) -> bool:
    """Whether a file or folder is a motion log, by its beginning."""
    try:
        find_format(open_source(path), LogChoices())
    except LogQuestion:
        return True
    except HapticPlayerError:
        return False
    return True


def log_beside(video: Path) -> Path | None:
    """Return the log that has a video's name, where the video has no motion itself."""
    if read_telemetry_packets(video):
        return None
    found = (video.with_suffix(ending) for ending in LOG_ENDINGS)
    return next((path for path in found if path.is_file()), None)


def bring_in(
    item: Item, library: Path, *, progress: Progress = no_progress
) -> BroughtIn:
    """Import a clip into the library unless it is there, and read all that is there.

    Raises:
        TelemetryError: for a clip without motion and without a log.
        UsageError: when a person has to decide something.
        InputError: when a file cannot be used, or the sequence is damaged.
    """
    if item.video is None:
        raise UsageError(
            "{log} is a motion log; choose the video that it belongs to",
            log=" + ".join(log.name for log in item.logs),
        )
    video = item.video
    progress(0.0, video.name)
    if before := imported_before(video, library):
        verify_sequence(before, progress)
        return BroughtIn(before, is_new=False)
    logs = () if read_telemetry_packets(video) else item.logs
    if not logs and (beside := log_beside(video)):
        logs = (beside,)
    folder = build_sequence(
        video,
        free_name(library, title_of(video)),
        imu_log=logs or None,
        choices=Choices(log=_known_answers(logs), mounting=_mounting(logs)),
        progress=lambda share, step: progress(_BUILDING * share, step),
    )
    verify_sequence(
        folder,
        lambda share, step: progress(_BUILDING + (1.0 - _BUILDING) * share, step),
    )
    return BroughtIn(folder, is_new=True)


def _mounting(logs: tuple[Path, ...]) -> str:
    """As a take says that its sensor was mounted."""
    is_one = len(logs) == 1 and is_take(logs[0])
    return parts_of(logs[0]).mounting if is_one else ""


def _known_answers(logs: tuple[Path, ...]) -> LogChoices | None:
    """Answers that are kept for logs with this header."""
    kept = kept_answers() if logs else {}
    if not kept:
        return None
    try:
        tables = tables_of(logs, LogChoices())
    except UsageError:  # which the import will raise, too
        return None
    name = kept_for(header_of(tables), kept)
    words = (
        [f"{key}={value}" for key, value in kept[name].answers.items()] if name else []
    )
    return parse_choices(words) if words else None


def imported_before(video: Path, library: Path) -> Path | None:
    """The sequence in a library that was made of a clip, by size and checksum."""
    size_bytes, digest = video.stat().st_size, ""
    for description in sorted(library.glob(f"*/{DESCRIPTION}")):
        try:
            described = read_description(description.parent)
        except InputError:
            continue
        entry = described.files.get(described.clip.file)
        if entry is None or entry.size_bytes != size_bytes:
            continue
        digest = digest or sha256_of(video)
        if digest == entry.sha256:
            return description.parent
    return None


def needs_an_answer(problem: BaseException) -> bool:
    """Whether a person can go on with a clip in the wizard, which can be read."""
    is_damage = isinstance(problem, MediaError | SequenceError | StorageError)
    return isinstance(problem, UsageError | InputError) and not is_damage
