"""Recordings made here: a folder with `recording.json`, the clip and `imu.csv`.

Camera, microphone and IMU are stamped by one machine, so the place of the log in the clip is
known but for a residual, which taps or frames correct. A recorder that was killed leaves
both streams; `finished` makes an ordinary recording of them.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import msgspec
import numpy as np
from msgspec import Meta, Struct

from hapticplayer.capture import si_csv
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.clock_lag import stamped_here
from hapticplayer.capture.csv_table import LOG_COLUMNS
from hapticplayer.capture.formats import Confidence, Reader
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.si_csv import RECORDING, SCHEMA, is_recorded
from hapticplayer.capture.source import LogSource, open_file
from hapticplayer.errors import InputError, Message, shell_line
from hapticplayer.media.remux import MATROSKA, remux
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.arrays import Floats, arrays_of
from hapticplayer.model.limits import MAX_CSV_BYTES
from hapticplayer.storage import (
    file_replaced,
    json_text,
    lock_folder,
    replace_file,
)
from hapticplayer.structures import MAX_JSON_BYTES, check_schema, convert, decode
from hapticplayer.untrusted import read_regular

CLIP, LOG = "clip.mkv", "imu.csv"
SOURCE, COUNT = "source", "count"
COLUMNS = (*LOG_COLUMNS, si_csv.ARRIVAL)

_VERSION = 1
_OTHER = Message("is not a recording"), Message("choose the folder of a recording")
MOST_GAPS = 1000
"""That are kept of a stream, in memory and in the description."""

_MOST_S = 1e7
_Seconds = Annotated[float, Meta(ge=-_MOST_S, le=_MOST_S)]
_MOST_RESIDUAL_S = 60.0
_Residual = Annotated[float, Meta(ge=0.0, le=_MOST_RESIDUAL_S)]


class Gap(Struct, frozen=True):
    """Media times between which a stream delivered nothing."""

    stream: str
    begin_s: _Seconds
    end_s: _Seconds
    missing: int = 0


class SourceClockLine(Struct, frozen=True):
    """Times of `imu.csv` to media time: rate * time + offset, from one of them on."""

    offset_s: _Seconds
    rate: Annotated[float, Meta(ge=0.9, le=1.1)] = 1.0
    residual_s: _Residual = 0.0
    begin_s: _Seconds = 0.0

    @classmethod
    def of(cls, clock: Any, begin_s: float) -> "SourceClockLine":
        """Of a `SourceClock` that begins there."""
        offset_s, rate = clock.line()
        return cls(offset_s, rate, min(clock.residual_s, _MOST_RESIDUAL_S), begin_s)


class Stream(Struct, frozen=True):
    """What one of the three delivered, and how far its stamps are from a line.

    Attributes:
        name: as a person gave it.
        stamped_by: "monotonic" or "wall", the machine's clocks; or SOURCE, its own, or
            COUNT, its samples by their nominal period.
        residual_s: of its stamps on the machine's clock.
        count: frames, sound blocks or samples.
        dropped: how many are missing.
    """

    name: str
    stamped_by: str
    residual_s: _Residual = 0.0
    count: int = 0
    dropped: int = 0


class Take(Struct, frozen=True, kw_only=True):
    """What `recording.json` holds.

    Attributes:
        began: date and time, UTC.
        zero_s: monotonic time of the machine at media time 0.
        is_finished: False while it is recorded, and after a kill.
        mounting: of the IMU, as `--mounting`; "" where nobody said.
        clock: of the IMU; None without one, and before enough is known.
        restarts: its clocks after it was unplugged or restarted, in their order.
    """

    schema: str = SCHEMA
    version: int = _VERSION
    began: str
    zero_s: float = 0.0
    is_finished: bool = False
    camera: Stream | None = None
    microphone: Stream | None = None
    imu: Stream | None = None
    clock: SourceClockLine | None = None
    restarts: list[SourceClockLine] = []
    mounting: str = ""
    marks_s: list[_Seconds] = []
    gaps: list[Gap] = []
    notices: list[str] = []

    def write(self, folder: Path) -> None:
        # names that are not UTF-8 could not be read again
        text = json_text(msgspec.to_builtins(self), errors="replace")
        replace_file(folder / RECORDING, text)


class Parts(NamedTuple):
    """What an import takes of a recording: its clip, and the log if there is one."""

    clip: Path
    log: Path | None
    mounting: str


def is_take(folder: Path) -> bool:
    path = folder / RECORDING
    return path.is_file() and is_recorded(open_file(path))


def parts_of(folder: Path) -> Parts:
    """The files of a recording, which is finished before if it was not."""
    take = finished(folder)
    if take.camera is None:
        raise InputError(
            "holds no video, only motion",
            where=str(folder),
            remedy="record with a camera (--camera), or import a video with this log (--imu)",
        )
    return Parts(folder / CLIP, folder if take.imu else None, take.mounting)


def read_take(folder: Path) -> Take:
    path = folder / RECORDING
    return _take_of(read_regular(path, MAX_JSON_BYTES, InputError), str(path))


def _take_of(text: bytes, where: str) -> Take:
    content = decode(text, dict[str, Any], where)
    check_schema(content, (SCHEMA, _VERSION), where, _OTHER)
    return convert(content, Take, where)


def finished(folder: Path) -> Take:
    """The description of a recording; one that was killed gets its ends now.

    Raises:
        InputError: while it is recorded, or when nothing of it can be used.
    """
    take = read_take(folder)
    if take.is_finished:
        return take
    with _not_recorded_now(folder):
        changes: dict[str, Any] = {"is_finished": True}
        damaged = 0
        if take.camera is not None:
            _finish_clip(folder / CLIP)
        if take.imu is not None:
            pairs, damaged = _finish_log(folder / LOG)
            lines = _clocks(pairs, take)
            changes |= (
                {"clock": lines[0], "restarts": lines[1:]} if lines else {"imu": None}
            )
        ended = "The recorder was ended from outside; this is what it had written."
        changes["notices"] = [*take.notices, ended]
        if damaged:
            changes["notices"].append(
                f"Damaged rows of {LOG} that were left out: {damaged}."
            )
        take = msgspec.structs.replace(take, **changes)
        take.write(folder)
    return take


@contextmanager
def _not_recorded_now(folder: Path) -> Iterator[None]:
    lock = lock_folder(folder)
    if lock is None:
        raise InputError(
            "is being recorded",
            where=str(folder),
            remedy="stop the recording first",
        )
    try:
        yield
    finally:
        os.close(lock)


def _finish_clip(clip: Path) -> None:
    """Give it its length and its index."""
    with file_replaced(clip) as part:
        remux(clip, part, MATROSKA)


def _finish_log(log: Path) -> tuple[Floats, int]:
    """Leave only whole rows; their times and arrivals (n, 2), and how many others."""
    content = read_regular(log, MAX_CSV_BYTES, InputError)
    head, *rows = content.splitlines(keepends=True) or [b""]
    half = rows.pop() if rows and not rows[-1].endswith(b"\n") else b""
    found = [(row, pair) for row in rows if (pair := _pair(row)) is not None]
    if half or len(found) < len(rows):
        # a new file: the name may be a link
        replace_file(log, head + b"".join(row for row, _ in found))
    return np.array([pair for _, pair in found]).reshape(-1, 2), len(rows) - len(found)


def _pair(row: bytes) -> tuple[float, float] | None:
    """Time and arrival of a row; None of a damaged one, as a power failure leaves it."""
    try:
        first, *between, last = row.split(b",")
        pair = float(first), float(last)
        values = [float(cell) for cell in between if cell.strip()]
    except ValueError:
        return None
    is_sane = all(abs(one) < _MOST_S for one in (*pair, *values))
    return pair if is_sane and len(between) == len(COLUMNS) - 2 else None


def _clocks(pairs: Floats, take: Take) -> list[SourceClockLine]:
    """The clock of each stretch of a log, fitted to its rows."""
    from hapticplayer.capture.live.source import new_clock

    assert take.imu is not None
    is_stamped, lines = take.imu.stamped_by != COUNT, []
    begins_s = [one.begin_s for one in take.restarts]
    for part in np.split(pairs, np.searchsorted(pairs[:, 0], begins_s)):
        if len(part) > 1:
            clock = new_clock(take.imu.name, is_stamped=is_stamped)
            clock.add(part[:, 0], part[:, 1])
            lines.append(SourceClockLine.of(clock, float(part[0, 0])))
    return lines


def _in_media_time(imu: ImuLog, lines: list[SourceClockLine]) -> ImuLog:
    """A log by the clock of each of its stretches, of which none reaches into the next."""
    stretch = np.searchsorted(
        [one.begin_s for one in lines[1:]], imu.time_s, side="right"
    )
    rate, offset_s = np.array([(one.rate, one.offset_s) for one in lines]).T
    media_s = rate[stretch] * imu.time_s + offset_s[stretch]
    before_s = np.concatenate([[-np.inf], np.maximum.accumulate(media_s)[:-1]])
    kept = media_s > before_s
    parts = arrays_of(imu, kept)
    return replace(imu, **{**parts, "time_s": media_s[kept]})


def recognises(source: LogSource) -> Confidence:
    is_ours = LOG in source.names and is_recorded(source)
    return Confidence.CERTAIN if is_ours else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> Recording:
    """The log, in media time."""
    take = _take_of(source.text(RECORDING).encode(), source.where(RECORDING))
    if take.clock is None:
        raise InputError(
            "was not finished",
            where=str(source.path),
            remedy=Message(
                "finish it ({line})",
                line=shell_line(
                    "hapticplayer", "import", source.path, "-o", "SEQUENCE"
                ),
            ),
        )
    found = si_csv.read(source.alone(LOG), choices)
    lines = [take.clock, *take.restarts]
    residual_s = max(one.residual_s for one in lines)
    lag = stamped_here(residual_s)
    imu = replace(found.imu, source=str(source.path))
    return replace(
        found,
        imu=_in_media_time(imu, lines),
        clock_map=ClockMap(0.0, 1.0, residual_s, 1.0),
        lag=lag,
        camera=Message("recorded here"),
        notes=(*found.notes, lag.text),
        provenance={
            **found.provenance,
            "reader": Message("recorded here"),
            "recording": msgspec.to_builtins(take),
        },
    )


READER = Reader(recognises, read)
