"""What force tracks can be exported as and imported from, one entry for each format."""

import zlib
from pathlib import Path
from typing import Any

from hapticplayer import extension, storage
from hapticplayer.errors import InputError, Message, UsageError, to_json
from hapticplayer.model import ForceTrack
from hapticplayer.sequence import force_as_csv
from hapticplayer.sequence.force_files import (
    ForceFile,
    ForceFormat,
    Loss,
    MeasureLoss,
    Read,
    ReadChoices,
    WriteChoices,
)
from hapticplayer.sequence.milliseconds import end_ms, force_loss
from hapticplayer.untrusted import open_regular

_BYTES_PER_ENTRY = 20  # of a native track: float64 time, three float32
_CHUNK_BYTES = 1 << 20


def read_back(read: Read) -> MeasureLoss:
    """Return the measure of a format that keeps newtons."""

    def loss(track: ForceTrack, path: Path, choices: WriteChoices) -> Loss:
        until_ms = end_ms(track, choices.duration_s)
        return force_loss(track, read(path, ReadChoices()).track, until_ms)

    return loss


CSV = ForceFormat(
    "csv",
    ".csv",
    Message("a row for each change of the force"),
    Message("the force in newtons at every millisecond"),
    force_as_csv.is_ours,
    force_as_csv.write,
    force_as_csv.read,
    read_back(force_as_csv.read),
)
"""The core's own."""


def force_formats() -> dict[str, ForceFormat]:
    found = extension.rows("force_formats", ForceFormat, (CSV,))
    return {one.name: one for one in found}


def written_formats() -> dict[str, ForceFormat]:
    return {name: one for name, one in force_formats().items() if one.write}


def read_formats() -> dict[str, ForceFormat]:
    return {name: one for name, one in force_formats().items() if one.read}


def format_of(path: Path, name: str | None = None) -> ForceFormat:
    """Return the format of a name, else that of the suffix of a file."""
    for one in force_formats().values():
        suffixes = (one.suffix, *one.other_suffixes)
        if one.name == name or (name is None and path.suffix.lower() in suffixes):
            return one
    raise UsageError(
        "the format of {name!r} is unknown; choose one of {known}",
        name=name or path.name,
        known=", ".join(force_formats()),
    )


def read_force(
    path: Path, choices: ReadChoices | None = None, name: str | None = None
) -> ForceFile:
    """Return the force in a file."""
    form = format_of(path, name)
    if form.read is None:
        raise UsageError(
            "{name} is only written; choose one of {known}",
            name=form.name,
            known=", ".join(read_formats()),
        )
    try:
        return form.read(path, choices or ReadChoices())
    except (MemoryError, RecursionError, OverflowError) as problem:
        raise InputError(
            "is damaged ({reason})",
            where=str(path),
            remedy="choose another file",
            reason=problem,
        ) from problem


def export_track(
    track: ForceTrack,
    target: Path,
    form: ForceFormat,
    choices: WriteChoices,
) -> dict[str, Any]:
    """Write a track to a new file, and return its size and largest error.

    Args:
        track: any.
        target: of the file.
        form: one that is written.
        choices: of the format.

    Returns:
        `bytes`, `kbit_s`, `kbit_s_compressed` (zlib), `track_kbit_s` (of the arrays of
        the native track), `error_rms_n`, `error_max_n` (None where the file holds no
        newtons), `compared`, `keeps`.
    """
    if form.write is None:
        raise UsageError(
            "{name} is only read; choose one of {known}",
            name=form.name,
            known=", ".join(written_formats()),
        )
    is_ours = form.is_ours if choices.overwrite else None
    with storage.file_written_aside(target, is_ours) as part:
        with part.open("xb") as out:
            form.write(track, out, choices)
        loss = form.loss(track, part, choices)
        sizes = _sizes(part)
    seconds = max(1e-3, end_ms(track, choices.duration_s) / 1000.0)
    return {
        "bytes": sizes[0],
        "duration_s": seconds,
        "kbit_s": 0.008 * sizes[0] / seconds,
        "kbit_s_compressed": 0.008 * sizes[1] / seconds,
        "track_kbit_s": 0.008 * _BYTES_PER_ENTRY * len(track.time_s) / seconds,
        "error_rms_n": loss.rms_n,
        "error_max_n": loss.max_n,
        "compared": to_json(loss.of),
        "keeps": to_json(form.keeps),
    }


def _sizes(path: Path) -> tuple[int, int]:
    """Return the bytes of a file, and of it compressed."""
    packer, size, packed = zlib.compressobj(9), 0, 0
    with open_regular(path) as reader:
        while chunk := reader.read(_CHUNK_BYTES):
            size += len(chunk)
            packed += len(packer.compress(chunk))
    return size, packed + len(packer.flush())
