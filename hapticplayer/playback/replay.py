"""Feel again what was sent: the force lines of a playback log as a force track."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from msgspec import Meta, Struct

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack
from hapticplayer.model.limits import MAX_FORCE_N
from hapticplayer.model.ranges import MEDIA_TIME_S
from hapticplayer.playback.source import Source
from hapticplayer.structures import convert
from hapticplayer.untrusted import open_regular

FROM_LOG = "log"
"""Name of the feedback that a log adds."""

MAX_LINES = 20_000_000
"""Five hours of force at 1 kHz; a larger log is not of one session."""

MAX_LINE = 65_536
_Force = Annotated[float, Meta(ge=-MAX_FORCE_N, le=MAX_FORCE_N)]
_SAME_DURATION_S = 0.1
_REMEDY = Message("choose a playback log (`hapticplayer play --log FILE`)")


def with_log(source: Source, path: Path) -> Source:
    """Return the source with the force of a log as another feedback, which plays.

    Where the log passes a time twice, after a seek, the last pass counts.
    """
    header, track = read_force_log(path)
    clip, wanted = source.clip, header.get("duration_s")
    is_near = isinstance(wanted, int | float) and (
        abs(wanted - clip.duration_s) <= _SAME_DURATION_S
    )
    if header.get("clip") != clip.path.name or not is_near:
        raise InputError(
            "belongs to the clip {found!r}, not to {expected!r}",
            where=str(path),
            remedy="open its sequence first, then the log",
            found=str(header.get("clip"))[:200],
            expected=clip.path.name,
        )
    return replace(source, tracks={FROM_LOG: track, **source.tracks}, feedback=FROM_LOG)


def read_force_log(path: Path) -> tuple[dict[str, Any], ForceTrack]:
    """Return a log's header and what was sent, over media time; raises InputError."""
    header: dict[str, Any] = {}
    rows: list[tuple[float, float, float, float]] = []
    try:
        with open_regular(path, remedy=_REMEDY) as reader:
            for number in range(1, MAX_LINES + 2):
                text = reader.readline(MAX_LINE)
                if not text:
                    break
                line = _parsed(text, path, number)
                if number == 1:
                    header = _header(line, path)
                elif line.get("kind") == "force":
                    rows.append(_force(line, path, number))
    except OSError as problem:
        raise InputError(
            "cannot be read ({reason})", where=str(path), remedy=_REMEDY, reason=problem
        ) from problem
    if not rows:
        raise InputError("holds no force", where=str(path), remedy=_REMEDY)
    times_s, values = _last_pass(np.array(rows))
    return header, ForceTrack(times_s, values, provenance={"log": path.name})


def _last_pass(rows: np.ndarray[Any, np.dtype[np.float64]]) -> tuple[Any, Any]:
    """Return times (N,) that increase and forces (N, 3): of each time the last row."""
    times_s = np.round(rows[:, 0], 4)  # a pause repeats one time with its jitter
    _, from_the_end = np.unique(times_s[::-1], return_index=True)
    kept = len(times_s) - 1 - from_the_end
    return times_s[kept], rows[kept, 1:].astype(np.float32)


def _parsed(text: bytes, path: Path, number: int) -> dict[str, Any]:
    try:
        line = json.loads(text)
    except (ValueError, RecursionError) as problem:
        raise _refusal(Message("is not JSON"), path, number) from problem
    if not isinstance(line, dict):
        raise _refusal(Message("is not a playback log"), path, number)
    return line


def _header(line: dict[str, Any], path: Path) -> dict[str, Any]:
    if line.get("kind") != "header":
        raise InputError("begins without a header", where=str(path), remedy=_REMEDY)
    return line


class _ForceLine(Struct):
    media_s: Annotated[float, Meta(ge=-MEDIA_TIME_S.largest, le=MEDIA_TIME_S.largest)]
    force_n: tuple[_Force, _Force, _Force]


def _force(
    line: dict[str, Any], path: Path, number: int
) -> tuple[float, float, float, float]:
    where = f"{path}, line {number}"
    found = convert(line, _ForceLine, where, InputError, _REMEDY)
    return found.media_s, *found.force_n


def _refusal(what: Message, path: Path, number: int) -> InputError:
    where = Message("{file}, line {line}", file=path, line=number)
    return InputError(what, where=where, remedy=_REMEDY)
