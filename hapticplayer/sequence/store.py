"""Opens, checks and describes a sequence."""

import os
from collections.abc import Iterator
from collections.abc import Mapping as Dict
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

from msgspec import structs
from numpy.typing import NDArray

from hapticplayer import storage
from hapticplayer.errors import (
    InputError,
    Message,
    Progress,
    SequenceError,
    message_of,
    no_progress,
)
from hapticplayer.media.clip_info import probe
from hapticplayer.model import (
    ClockMap,
    ForceTrack,
    ImuLog,
    Mapping,
    MotionTrack,
    Reconstruction,
    Sampling,
    rendered_feedback,
)
from hapticplayer.model.limits import (
    refuse_absurd,
    refuse_far_times,
    refuse_large_force,
)
from hapticplayer.rendering import FEEDBACKS, ConditionInputs
from hapticplayer.rendering.effects import NO_EFFECTS, EffectList
from hapticplayer.sequence.arrays import read_arrays
from hapticplayer.sequence.description import (
    IMPORT_AGAIN,
    Description,
    FileEntry,
    MappingEntry,
    TrackEntry,
    checked_description,
    written,
)
from hapticplayer.sequence.effects_file import read_effects
from hapticplayer.structures import missing, read_json
from hapticplayer.untrusted import (
    HeldFile,
    without_controls,
)

DESCRIPTION = "sequence.json"
MOTION = "motion.npz"
IMU = "imu.npz"
EFFECTS = "effects"
"""Begins the names of lists of effects; in a description, the name of the one used."""

OPTIONAL_IMU_FIELDS = ("magnetic_field_ut", "valid")
_MAX_NAME_BYTES = 255
_COPY_AGAIN = Message("copy the sequence again or import it again")


@dataclass(frozen=True, slots=True, eq=False)
class Sequence:
    """A clip, its motion, and a force track for each feedback condition.

    Attributes:
        folder: of the sequence.
        title: of the sequence.
        clip: the video file.
        motion: gravity-free acceleration, in media time; None if it was not shared.
        tracks: force tracks by name of the condition.
        mapping: of the realistic or estimated track.
        description: of the sequence, with its provenance.
    """

    folder: Path
    title: str
    clip: Path
    motion: MotionTrack | None
    tracks: Dict[str, ForceTrack]
    mapping: Mapping
    description: Description

    @property
    def duration_s(self) -> float:
        """Of the clip itself where it is there: a description may be wrong."""
        stated_s = self.description.clip.duration_s
        return probe(self.clip).duration_s if self.clip.is_file() else stated_s

    @property
    def rendered(self) -> ForceTrack:
        """The track that is rendered from the motion: realistic, or estimated."""
        return self.tracks[rendered_feedback(self.tracks)]


class SmallFiles(Protocol):
    """Where the arrays of a sequence are: in its folder, or attached to its clip."""

    where: str

    def arrays(
        self, name: str, listed: Dict[str, FileEntry]
    ) -> dict[str, NDArray[Any]]:
        """Return the arrays of a file, whose size and checksum are as listed."""


class FolderFiles:
    """The small files in the folder of a sequence."""

    def __init__(self, folder: Path) -> None:
        self._folder, self.where = folder, str(folder / DESCRIPTION)

    def arrays(
        self, name: str, listed: Dict[str, FileEntry]
    ) -> dict[str, NDArray[Any]]:
        """Return the arrays of a file; see `SmallFiles`."""
        return read_arrays(checked(self._folder, name, listed))


def open_sequence(folder: str | Path) -> Sequence:
    """Return the sequence in a folder.

    The small files are checked against their checksums, the clip by its size; see
    `verify_sequence`.

    Raises:
        SequenceError: when files are missing or damaged.
    """
    folder = Path(folder)
    if not (folder / DESCRIPTION).exists():
        raise SequenceError(
            "holds no {name}",
            where=str(folder),
            remedy="give the folder of a sequence, or a video",
            name=DESCRIPTION,
        )
    description = read_description(folder)
    while True:
        try:
            return sequence_of(description, FolderFiles(folder), folder)
        except SequenceError:
            before, description = description, read_description(folder)
            if description == before:  # else another program has changed it meanwhile
                raise


def read_description(folder: Path) -> Description:
    """The description in the folder of a sequence; raises SequenceError."""
    path = folder / DESCRIPTION
    content = read_json(path, dict[str, Any], SequenceError, IMPORT_AGAIN)
    return checked_description(content, str(path))


def sequence_of(
    description: Description,
    small: SmallFiles,
    folder: Path,
    clip: Path | None = None,
) -> Sequence:
    """Return the sequence that a description and its small files make.

    Args:
        description: of the sequence.
        small: where its arrays are.
        folder: that it is in.
        clip: a file that holds its video; None for the one that it describes.

    Raises:
        SequenceError: when an entry or a file is missing, or of the wrong kind.
    """
    listed = description.files
    with _named_as_damaged(small.where):
        if clip is None:
            name = description.clip.file
            clip = _check_file(folder, name, listed, with_checksum=False)
        tracks = _read_tracks(small, description.feedbacks, listed)
        mapping = mapping_of(description)
        motion = None
        if MOTION in listed:
            motion = MotionTrack(**_motion_fields(small.arrays(MOTION, listed)))
            refuse_absurd(motion.acceleration_mps2, "acceleration_mps2")
            refuse_far_times(motion.time_s, MOTION)
    title = without_controls(description.title)
    return Sequence(folder, title, clip, motion, tracks, mapping, description)


def verify_sequence(folder: str | Path, progress: Progress = no_progress) -> None:
    """Read every file of a sequence and compare its checksum."""
    folder = Path(folder)
    sequence = open_sequence(folder)
    listed = sequence.description.files
    for number, name in enumerate(listed):
        progress(number / len(listed), Message("checking {name}", name=name))
        _check_file(folder, name, listed, with_checksum=True)


def read_recorded(folder: str | Path) -> tuple[ImuLog, dict[str, Any]]:
    """Return the recorded samples of a sequence, and its provenance."""
    folder = Path(folder)
    described = read_description(folder)
    if IMU not in described.files:
        raise SequenceError(
            "holds no recorded samples",
            where=str(folder),
            remedy="import a recording, or ask for a file with its motion",
        )
    _check_file(folder, IMU, described.files, with_checksum=True)
    arrays, made_of = read_arrays(folder / IMU), described.provenance
    with _named_as_damaged(str(folder)):
        imu = ImuLog(
            time_s=arrays["time_s"],
            specific_force_mps2=arrays["specific_force_mps2"],
            angular_rate_radps=arrays["angular_rate_radps"],
            sampling=Sampling(str(arrays["sampling"])),
            source=str(made_of["motion_source"]),
            **{name: arrays.get(name) for name in OPTIONAL_IMU_FIELDS},
        )
    return imu, made_of


@contextmanager
def _named_as_damaged(where: str) -> Iterator[None]:
    """Raise SequenceError for what arrays lack, and for values that are not allowed."""
    try:
        yield
    except SequenceError:
        raise
    except InputError as problem:
        raise SequenceError(
            message_of(problem), where=where, remedy=IMPORT_AGAIN
        ) from problem
    except (LookupError, TypeError, ValueError) as problem:
        raise SequenceError(
            "an array is missing or of the wrong kind ({reason})",
            where=where,
            remedy=IMPORT_AGAIN,
            reason=problem,
        ) from problem


def motion_of(sequence: Sequence) -> MotionTrack:
    """Return the motion that force is rendered from."""
    if sequence.motion is None:
        raise SequenceError(
            "was shared without its motion, so its force cannot be rendered again",
            where=str(sequence.folder),
            remedy="ask for a file that was packed with it (--with-motion)",
        )
    return sequence.motion


def effects_of(sequence: Sequence) -> EffectList:
    """Return the effects of a sequence in a folder; none where it has no list."""
    name = sequence.description.effects
    if name is None:
        return NO_EFFECTS
    return read_effects(checked(sequence.folder, name, sequence.description.files))


def recorded_log(sequence: Sequence) -> ImuLog:
    """Return the recorded samples of a sequence in media time."""
    imu, _ = read_recorded(sequence.folder)
    clock = sequence.description.clock_map
    if clock is None:
        what, where = missing("clock_map")[0], str(sequence.folder / DESCRIPTION)
        raise SequenceError(what, where=where, remedy=IMPORT_AGAIN)
    return in_media_time(imu, clock)


def in_media_time(imu: ImuLog, clock: ClockMap) -> ImuLog:
    return replace(imu, time_s=clock.rate * imu.time_s + clock.offset_s)


def copy_files(folder: Path, target: Path, progress: Progress = no_progress) -> None:
    """Copy all files of a sequence into an empty folder."""
    description = open_sequence(folder).description
    listed = description.files
    whole = sum(entry.size_bytes for entry in listed.values())
    before = 0
    for name, entry in listed.items():
        _check_file(folder, name, listed, with_checksum=False)

        def report(
            share: float, before: int = before, entry: FileEntry = entry
        ) -> None:
            done = (before + share * entry.size_bytes) / max(1, whole)
            progress(done, Message("copying the sequence"))

        with HeldFile(folder / name, SequenceError) as source:
            digest = storage.copy_file(source, target / name, report)
        if digest != entry.sha256:
            raise changed(folder / name)
        before += entry.size_bytes
    storage.write_json(target / DESCRIPTION, written(description))


def checked(folder: Path, name: str, listed: Dict[str, FileEntry]) -> Path:
    return _check_file(folder, name, listed, with_checksum=True)


def changed(path: Path) -> SequenceError:
    """Return the error of a file whose checksum differs."""
    return SequenceError(
        "has changed since it was written (its checksum differs)",
        where=str(path),
        remedy=_COPY_AGAIN,
    )


def track_arrays(track: ForceTrack) -> dict[str, Any]:
    """Return the arrays of a force track as they are stored."""
    return {
        "time_s": track.time_s,
        "force_n": track.force_n,
        "reconstruction": track.reconstruction.value,
    }


def mapping_of(description: Description) -> Mapping:
    """From motion to force, as a sequence was rendered."""
    return Mapping(**structs.asdict(description.mapping))


def describe_mapping(mapping: Mapping) -> MappingEntry:
    return MappingEntry(
        mapping.axes.tolist(),
        mapping.gain_n_per_mps2,
        mapping.force_limit_n,
        mapping.soft_knee_n,
        mapping.lever_arm_m,
    )


def inside(folder: Path, name: str) -> Path:
    """Return the path of a file directly in the folder."""
    if not _is_plain(name):
        raise SequenceError(
            "{name!r} is not a plain file name",
            where=str(folder / DESCRIPTION),
            remedy="import it again",
            name=name[:60],
        )
    return folder / name


def _is_plain(name: str) -> bool:
    try:
        size_bytes = len(os.fsencode(name))
    except UnicodeEncodeError:  # a half of a pair of surrogates
        return False
    is_whole = Path(name).name == name and name not in ("", ".", "..")
    return is_whole and "\0" not in name and size_bytes <= _MAX_NAME_BYTES


def _check_file(
    folder: Path, name: str, listed: Dict[str, FileEntry], *, with_checksum: bool
) -> Path:
    path, entry = inside(folder, name), listed.get(name)
    if entry is None or path.is_symlink() or not path.is_file():
        raise SequenceError("is missing", where=str(path), remedy=_COPY_AGAIN)
    size = path.stat().st_size
    if size != entry.size_bytes:
        raise SequenceError(
            "has {count} bytes instead of {expected}",
            where=str(path),
            remedy=_COPY_AGAIN,
            count=size,
            expected=entry.size_bytes,
        )
    if with_checksum and storage.sha256_of(path) != entry.sha256:
        raise changed(path)
    return path


def _read_tracks(
    small: SmallFiles, feedbacks: dict[str, TrackEntry], listed: Dict[str, FileEntry]
) -> dict[str, ForceTrack]:
    tracks = {}
    for name, entry in feedbacks.items():
        if entry.file is None:
            continue
        arrays = small.arrays(entry.file, listed)
        tracks[name] = track = ForceTrack(
            arrays["time_s"],
            arrays["force_n"],
            Reconstruction(str(arrays["reconstruction"])),
            entry.provenance,
        )
        refuse_large_force(track.force_n, entry.file)
        refuse_far_times(track.time_s, entry.file)
    rendered = rendered_feedback(tracks)
    if rendered not in tracks:
        raise SequenceError(
            "holds no track {name!r}",
            where=small.where,
            remedy=IMPORT_AGAIN,
            name=str(rendered),
        )
    realistic = tracks[rendered]
    for condition in FEEDBACKS:
        if condition.is_made_at_opening:
            tracks[condition.name] = condition.track(ConditionInputs(realistic), {})
    order = [condition.name for condition in FEEDBACKS]
    return dict(sorted(tracks.items(), key=lambda i: [*order, i[0]].index(i[0])))


def _motion_fields(arrays: dict[str, NDArray[Any]]) -> dict[str, Any]:
    sigma = arrays.get("gravity_sigma_mps2")
    return {
        "time_s": arrays["time_s"],
        "acceleration_mps2": arrays["acceleration_mps2"],
        "gravity_mps2": arrays["gravity_mps2"],
        "accelerometer_gain": float(arrays["accelerometer_gain"]),
        "quaternion_wxyz": arrays["quaternion_wxyz"],
        "gravity_sigma_mps2": sigma,
        "valid": arrays["valid"],
        "sampling": Sampling(str(arrays["sampling"])),
        "is_estimated": bool(arrays["is_estimated"]),
    }
