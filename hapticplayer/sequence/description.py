"""The structure of `sequence.json`, as far as the program depends on it."""

from typing import Any

from msgspec import Struct

from hapticplayer.errors import Message, SequenceError
from hapticplayer.model.mapping import AxisGains
from hapticplayer.structures import check_version, convert

SCHEMA, VERSION = "hapticplayer.sequence", 1
IMPORT_AGAIN = Message("import it again")


class FileEntry(Struct):
    """A file of the sequence."""

    size_bytes: int
    sha256: str


class ClipEntry(Struct):
    """The video."""

    file: str
    duration_s: float


class MappingEntry(Struct):
    """From acceleration to force."""

    axes: list[list[float]]
    gain_n_per_mps2: float | AxisGains
    force_limit_n: float
    soft_knee_n: float | None
    lever_arm_m: tuple[float, float, float]


class HandEntry(Struct):
    """How far a hand of one kind would move."""

    reach: float | None = None


class ExcursionEntry(Struct):
    """What a track is predicted to do to hands."""

    hands: dict[str, HandEntry] = {}


class TrackEntry(Struct):
    """A force track; one that is made when the sequence is opened has no file."""

    file: str | None = None
    peak_n: float = 0.0
    rms_n: tuple[float, ...] = ()
    excursion: ExcursionEntry | None = None
    provenance: dict[str, Any] = {}


class Description(Struct):
    """The object in the file."""

    title: str
    clip: ClipEntry
    mapping: MappingEntry
    feedbacks: dict[str, TrackEntry]
    files: dict[str, FileEntry]
    effects: str | None = None
    provenance: dict[str, Any] = {}


def checked_description(content: dict[str, Any], where: str) -> Description:
    """Return a description as a structure.

    Raises:
        SequenceError: names the wrong field and what is allowed there.
    """
    if content.get("schema") != SCHEMA:
        raise SequenceError(
            "is not the description of a sequence",
            where=where,
            remedy="give the folder of a sequence",
        )
    check_version(content, SCHEMA, VERSION, where, SequenceError)
    return convert(content, Description, where, SequenceError, IMPORT_AGAIN)
