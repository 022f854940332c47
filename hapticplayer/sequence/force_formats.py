"""What force tracks can be exported as and imported from, one entry for each format."""

import zlib
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import extension, storage
from hapticplayer.errors import (
    InputError,
    Message,
    UsageError,
    from_json,
    joined,
    to_json,
)
from hapticplayer.model import ForceTrack
from hapticplayer.sequence import force_as_csv
from hapticplayer.sequence.force_files import (
    SAMPLE_RATE_HZ,
    ForceFile,
    ForceFormat,
    Loss,
    MeasureLoss,
    Read,
    ReadChoices,
    WriteChoices,
    refuse_untaken,
)
from hapticplayer.sequence.milliseconds import end_ms, force_loss, goes_on_after
from hapticplayer.untrusted import open_regular

_BYTES_PER_ENTRY = 20  # of a native track: float64 time, three float32
_CHUNK_BYTES = 1 << 20
_MOST_COMPRESSED = 16
"""Chunks of a file; of a longer one these are compressed, evenly apart."""

_ROWS_AT_ONCE = 1 << 20
_JUMP_S, _MS = 1e-5, 0.99e-3
"""Entries between them are nearer than the milliseconds of a file, and no jump."""


def read_back(read: Read) -> MeasureLoss:
    """Return the measure of a format that keeps newtons."""

    def loss(track: ForceTrack, path: Path, choices: WriteChoices) -> Loss:
        until_ms = end_ms(track, choices.duration_s)
        found = read(path, ReadChoices()).track
        return force_loss(track, [(until_ms, found)], until_ms)

    return loss


CSV = ForceFormat(
    "csv",
    ".csv",
    Message("a row for each change of the force"),
    Message("the force in newtons at every millisecond"),
    force_as_csv.is_ours,
    force_as_csv.write,
    force_as_csv.read,
    force_as_csv.loss,
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
    choices = replace(choices or ReadChoices())
    try:
        found = form.read(path, choices)
    except (MemoryError, RecursionError, OverflowError) as problem:
        raise InputError(
            "is damaged ({reason})",
            where=str(path),
            remedy="choose another file",
            reason=problem,
        ) from problem
    refuse_untaken(choices, form.name, str(path))
    active_s = found.track.active_s
    if len(active_s) and active_s[0, 0] < 0.0:
        said = Message("what lies before 0 s was left out")
        found = found._replace(unread=(*found.unread, said))
    if not len(active_s):
        said = Message("its force is 0 N from beginning to end")
        found = found._replace(unread=(*found.unread, said))
    return found


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
        newtons), `compared`, `keeps`, `left_out`, `beside` (other files that belong
        to it).
    """
    if form.write is None:
        raise UsageError(
            "{name} is only read; choose one of {known}",
            name=form.name,
            known=", ".join(written_formats()),
        )
    is_ours = form.is_ours if choices.overwrite else None
    names = [f"{target.stem}{part}{target.suffix}" for part in form.parts(choices)]
    left_out = _left_out(track, form, choices)
    with ExitStack() as files:
        parts = [
            files.enter_context(
                storage.file_written_aside(target.with_name(name), is_ours)
            )
            for name in names
        ]
        for part, infix in zip(parts, form.parts(choices), strict=True):
            with part.open("xb") as out:
                of_part = replace(choices, part=infix)
                left_out += form.write(track, out, of_part)
                refuse_untaken(of_part, form.name, str(target))
        loss = form.loss(track, parts[0], choices)
        sizes = [sum(both) for both in zip(*map(_sizes, parts), strict=True)]
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
        "left_out": [to_json(what) for what in dict.fromkeys(left_out)],
        "beside": names[1:],
    }


def loss_line(report: dict[str, Any]) -> Message:
    """What a file keeps, costs and leaves out, by the report of `export_track`."""
    kept, compared = from_json(report["keeps"]), from_json(report["compared"])
    rate = Message(
        "{bytes} bytes, {rate:.3g} kbit/s ({packed:.3g} compressed; the track: {own:.3g})",
        bytes=report["bytes"],
        rate=report["kbit_s"],
        packed=report["kbit_s_compressed"],
        own=report["track_kbit_s"],
    )
    error = Message("not compared with the track")
    if report["error_max_n"] is not None:
        error = Message(
            "error RMS {rms:.4f} N, largest {largest:.4f} N ({compared})",
            rms=report["error_rms_n"],
            largest=report["error_max_n"],
            compared=compared,
        )
    parts = [kept, rate, error]
    if report["beside"]:
        names = ", ".join(report["beside"])
        parts.append(Message("the other axes are in {names}", names=names))
    what = [from_json(one) for one in report["left_out"]]
    left_out = Message("left out: {what}", what=joined(", ", what))
    return joined("; ", [*parts, left_out if what else Message("left out: nothing")])


def _left_out(
    track: ForceTrack, form: ForceFormat, choices: WriteChoices
) -> list[Message]:
    """What no format keeps of a track: outside the clip, and between its samples."""
    found = []
    if len(track.active_s) and track.active_s[0, 0] < 0.0:
        found.append(Message("the force before 0 s"))
    end_s = choices.duration_s
    if end_s is not None and goes_on_after(track, end_s):
        said = Message(
            "the force after the end of the clip ({end_s:.3f} s)", end_s=end_s
        )
        found.append(said)
    rows = range(0, len(track.time_s), _ROWS_AT_ONCE)
    spans = (np.diff(track.time_s[row : row + _ROWS_AT_ONCE + 1]) for row in rows)
    if any(((span > _JUMP_S) & (span < _MS)).any() for span in spans) and not (
        form.is_sampled and choices.sample_rate_hz > SAMPLE_RATE_HZ.least
    ):
        found.append(Message("what changes within a millisecond"))
    return found


def _sizes(path: Path) -> tuple[int, float]:
    """Return the bytes of a file, and of it compressed: of a long one estimated."""
    size, read, packed = path.stat().st_size, 0, 0
    step = max(_CHUNK_BYTES, size // _MOST_COMPRESSED)
    with open_regular(path) as reader:
        for begin in range(0, size, step):
            reader.seek(begin)
            chunk = reader.read(_CHUNK_BYTES)
            read, packed = read + len(chunk), packed + len(zlib.compress(chunk, 9))
    return size, packed * size / max(read, 1)
