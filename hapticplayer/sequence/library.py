"""Lists the sequences in a folder from their descriptions alone."""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hapticplayer.errors import InputError, Message, SequenceError, message_of
from hapticplayer.model import PresetName, rendered_feedback
from hapticplayer.sequence import files
from hapticplayer.sequence.report import Finding, quality_report
from hapticplayer.sequence.store import DESCRIPTION, SCHEMA
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
        """Whether title, folder, camera, date or tracks contain every word."""
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
        description = files.read_json(folder / DESCRIPTION)
        if description.get("schema") != SCHEMA:
            raise SequenceError(
                "is not the description of a sequence", where=str(folder)
            )
        return _entry(folder, description)
    except InputError as problem:
        return Entry(folder, folder.name, problem=message_of(problem))
    except (KeyError, TypeError, ValueError, AttributeError) as problem:
        what = Message(
            "an entry is missing or of the wrong kind ({reason})", reason=problem
        )
        error = SequenceError(what, where=str(folder / DESCRIPTION))
        return Entry(folder, folder.name, problem=message_of(error))


def _entry(folder: Path, description: Mapping[str, Any]) -> Entry:
    clip = folder / Path(str(description["clip"]["file"])).name
    made_of = description.get("provenance", {})
    return Entry(
        folder=folder,
        title=without_controls(str(description["title"])),
        clip=clip,
        duration_s=_finite(description["clip"]["duration_s"]),
        size_bytes=sum(int(one["size_bytes"]) for one in description["files"].values()),
        camera=str(made_of.get("camera", "")),
        created_utc=str(made_of.get("created_utc", "")),
        gain_n_per_mps2=_one_gain(description["mapping"]["gain_n_per_mps2"]),
        preset=_preset(description["feedbacks"]),
        tracks=tuple(
            _track(name, entry)
            for name, entry in description["feedbacks"].items()
            if "file" in entry
        ),
        findings=quality_report(description),
        problem="" if clip.is_file() else Message("{name} is missing", name=clip.name),
    )


def _track(name: str, entry: Mapping[str, Any]) -> Track:
    rms_n = math.sqrt(sum(_finite(value) ** 2 for value in entry["rms_n"]))
    hands = (entry.get("excursion") or {}).get("hands", {})
    reach = hands.get("normal", {}).get("reach")
    return Track(
        name,
        _finite(entry["peak_n"]),
        rms_n,
        None if reach is None else _finite(reach),
    )


def _preset(feedbacks: Mapping[str, Any]) -> str:
    """Return the preset of the rendered track; earlier versions had one."""
    made_of = feedbacks.get(rendered_feedback(feedbacks), {}).get("provenance", {})
    return without_controls(str(made_of.get("preset", PresetName.FAITHFUL)))


def _one_gain(value: Any) -> float | None:
    if isinstance(value, list):
        _, _, _ = map(_finite, value)
        return None
    return _finite(value)


def _finite(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(Message("{value} is not a number", value=repr(value)))
    return number


def name_from(title: str) -> str:
    """Return a name for a file or folder from a title."""
    return re.sub(r"[^\w.\- ]+", "_", title).strip(" ._")[:_MAX_NAME] or "sequence"


def free_name(library: Path, title: str) -> Path:
    """Return a folder name in the library that is not taken, from a title."""
    name = name_from(title)
    candidates = (
        library / f"{name}-{n}" if n > 1 else library / name
        for n in range(1, MAX_FOLDERS)
    )
    return next(path for path in candidates if not path.exists())
