"""The records of the device that a session has: every tick of each run."""

from bisect import bisect_right
from collections.abc import Iterator, Mapping
from itertools import chain, pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.study.session_folder import StoredSession

RECORD = "ticks-{:02d}.hprec"
_WANTED = {"monotonic_s": (), "media_s": (), "force_n": (3,), "position_m": (3,)}
_MOST = 1e9
"""Neither the clock of a machine nor a value of a device reaches it."""

_ALONE_S = 60.0
"""From all other ticks: no loop sleeps so long."""


def next_record(session_folder: Path) -> Path:
    """Return the path for the ticks of the next run of a session."""
    number = 1
    while (path := session_folder / RECORD.format(number)).exists():
        number += 1
    return path


def tick_files(session: StoredSession) -> list[Path]:
    pattern = RECORD.format(0).replace("00", "*")
    return sorted(session.folder.glob(pattern))


def tick_chunks(path: Path, notices: list[str]) -> Iterator[NDArray[Any]]:
    """Yield the ticks of a record that a device can have; others add to the notices."""
    name, left_out, until_s = f"{path.parent.name}/{path.name}", 0, 0.0
    try:
        with RecordReader(path) as reader:
            if not _has_wanted(reader.dtype):
                what = Message("lacks what is to be exported")
                notices.append(joined(": ", (name, what)))
                return
            frames = chain((frame.ticks for frame in reader.frames()), [None])
            for ticks, following in pairwise(frames):
                assert ticks is not None
                kept = ticks[_are_possible(ticks, until_s, following)]
                left_out += len(ticks) - len(kept)
                if len(kept):
                    until_s = float(kept["monotonic_s"][-1])
                    yield kept
            if reader.notice:
                notices.append(joined(": ", (name, reader.notice)))
    except InputError as problem:
        notices.append(joined(": ", (name, problem.what)))
    if left_out:
        what = Message(
            "{count} ticks have times or values that no device has; they are left out",
            count=left_out,
        )
        notices.append(joined(": ", (name, what)))


def _has_wanted(dtype: np.dtype[Any]) -> bool:
    fields: Mapping[str, Any] = dtype.fields or {}
    return all(
        name in fields and fields[name][0].shape == shape
        for name, shape in _WANTED.items()
    )


def _are_possible(
    ticks: NDArray[Any], begin_s: float, following: NDArray[Any] | None
) -> NDArray[np.bool_]:
    """Which ticks have times that go on, and values; NaN is a value that is not known.

    Times that would leave out the most others are wrong, also where those follow in the
    next frame; so is a first or last one that stands alone.
    """
    time_s = np.asarray(ticks["monotonic_s"], np.float64)
    later_s = time_s[:0] if following is None else following["monotonic_s"]
    both_s = np.concatenate([time_s, later_s])
    rows = np.flatnonzero((both_s >= begin_s) & (both_s < _MOST))
    rows = rows[_longest_rise(both_s[rows])]
    alone = np.diff(both_s[rows[:2]]) > _ALONE_S
    rows = rows[alone.sum() * (begin_s == 0.0) :]
    if following is None and np.any(np.diff(both_s[rows[-2:]]) > _ALONE_S):
        rows = rows[:-1]
    possible = np.isin(np.arange(len(ticks)), rows)
    for name in _WANTED:
        too_large = np.abs(np.asarray(ticks[name], np.float64)) >= _MOST
        possible &= ~too_large.reshape(len(ticks), -1).any(axis=1)
    return possible


def _longest_rise(time_s: NDArray[np.float64]) -> NDArray[np.intp]:
    """The most rows whose times do not fall (Schensted 1961)."""
    if not np.any(np.diff(time_s) < 0.0):
        return np.arange(len(time_s))
    ends_s: list[float] = []  # of the best rise of each length so far
    ends: list[int] = []
    before = np.full(len(time_s), -1)
    for row, at_s in enumerate(time_s.tolist()):
        length = bisect_right(ends_s, at_s)
        before[row] = ends[length - 1] if length else -1
        ends_s[length : length + 1], ends[length : length + 1] = [at_s], [row]
    found = [ends[-1]]
    while before[found[-1]] >= 0:
        found.append(int(before[found[-1]]))
    return np.array(found[::-1])
