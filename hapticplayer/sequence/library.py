"""Lists the sequences in a folder from their descriptions alone."""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from hapticplayer.errors import InputError, Message, message_of
from hapticplayer.model import PresetName, rendered_feedback
from hapticplayer.sequence.description import (
    Description,
    TrackEntry,
)
from hapticplayer.sequence.presets import DEFAULT_PRESET
from hapticplayer.sequence.report import Finding, quality_report
from hapticplayer.sequence.store import DESCRIPTION, read_description
from hapticplayer.untrusted import without_controls

MAX_FOLDERS = 5000

_MAX_NAME = 60


@dataclass(frozen=True, slots=True)
class Track:
    """A force track as described.

    Attributes:
        name: of the feedback.
        peak_n: the largest force.
        rms_n: of all axes together.
        reach: predicted share of the workspace with a normal hand, or None.
    """

    name: str
    peak_n: float
    rms_n: float
    reach: float | None


@dataclass(frozen=True, slots=True)
class Entry:
    """A sequence in the library.

    Attributes:
        folder: of the sequence.
        title: of the sequence.
        clip: its video, which may be missing.
        duration_s: of the clip.
        size_bytes: of all its files, as described.
        camera: that recorded the motion.
        created_utc: time of the import.
        gain_n_per_mps2: of its mapping; None where the axes have different ones.
        preset: of its realistic track.
        tracks: its force tracks.
        findings: its quality report.
        problem: why it cannot be used, or "".
    """

    folder: Path
    title: str
    clip: Path | None = None
    duration_s: float = 0.0
    size_bytes: int = 0
    camera: str = ""
    created_utc: str = ""
    gain_n_per_mps2: float | None = None
    preset: str = PresetName.FAITHFUL
    tracks: tuple[Track, ...] = ()
    findings: list[Finding] = field(default_factory=list)
    problem: str = ""

    def matches(self, words: str) -> bool:
        known = f"{self.title} {self.folder.name} {self.camera} {self.created_utc}"
        known += " " + " ".join(track.name for track in self.tracks)
        return all(word in known.lower() for word in words.lower().split())


def entries(folder: Path) -> list[Entry]:
    """Return the sequences in a folder by title, damaged ones included.

    A folder that does not exist gives none.
    """
    try:
        inside = sorted(path for path in folder.iterdir() if path.is_dir())
    except OSError:
        return []
    held = (path for path in inside if not path.name.startswith("."))
    found = [read_entry(path) for path in held if (path / DESCRIPTION).is_file()]
    return sorted(
        found[:MAX_FOLDERS], key=lambda entry: (entry.title.lower(), entry.folder)
    )


def read_entry(folder: Path) -> Entry:
    """Return the entry of a sequence from its description; other files are not read."""
    try:
        return _entry(folder, read_description(folder))
    except InputError as problem:
        return Entry(folder, folder.name, problem=message_of(problem))


def _entry(folder: Path, described: Description) -> Entry:
    clip = folder / Path(described.clip.file).name
    gain, made_of = described.mapping.gain_n_per_mps2, described.provenance
    return Entry(
        folder=folder,
        title=without_controls(described.title),
        clip=clip,
        duration_s=described.clip.duration_s,
        size_bytes=sum(one.size_bytes for one in described.files.values()),
        camera=str(made_of.get("camera", "")),
        created_utc=str(made_of.get("created_utc", "")),
        gain_n_per_mps2=gain if isinstance(gain, float) else None,
        preset=_preset(described.feedbacks),
        tracks=tuple(
            _track(name, entry)
            for name, entry in described.feedbacks.items()
            if entry.file is not None
        ),
        findings=quality_report(described),
        problem="" if clip.is_file() else Message("{name} is missing", name=clip.name),
    )


def _track(name: str, entry: TrackEntry) -> Track:
    hands = entry.excursion.hands if entry.excursion else {}
    reach = hands["normal"].reach if "normal" in hands else None
    rms_n = math.hypot(*(entry.rms_n or ()))
    return Track(name, entry.peak_n or 0.0, rms_n, reach)


def _preset(feedbacks: Mapping[str, TrackEntry]) -> str:
    rendered = feedbacks.get(rendered_feedback(feedbacks), TrackEntry())
    return without_controls(str(rendered.provenance.get("preset", DEFAULT_PRESET)))


def name_from(title: str) -> str:
    return re.sub(r"[^\w.\- ]+", "_", title).strip(" ._")[:_MAX_NAME] or "sequence"


def free_name(library: Path, title: str) -> Path:
    """Return a folder name in the library that is not taken, from a title."""
    name = name_from(title)
    candidates = (
        library / f"{name}-{n}" if n > 1 else library / name
        for n in range(1, MAX_FOLDERS)
    )
    return next(path for path in candidates if not path.exists())
