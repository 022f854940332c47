"""The records of the device that a session has: every tick of each run."""

from collections.abc import Iterator, Mapping
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
            for frame in reader.frames():
                kept = frame.ticks[_are_possible(frame.ticks, until_s)]
                left_out += len(frame.ticks) - len(kept)
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


def _are_possible(ticks: NDArray[Any], begin_s: float) -> NDArray[np.bool_]:
    """Which ticks have times that go on, and values; NaN is a value that is not known."""
    time_s = np.asarray(ticks["monotonic_s"], np.float64)
    is_time = (time_s >= begin_s) & (time_s < _MOST)
    latest_s = np.maximum.accumulate(np.where(is_time, time_s, begin_s))
    possible = is_time & (time_s >= latest_s)
    for name in _WANTED:
        too_large = np.abs(np.asarray(ticks[name], np.float64)) >= _MOST
        possible &= ~too_large.reshape(len(ticks), -1).any(axis=1)
    return np.asarray(possible)
