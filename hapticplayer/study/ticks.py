"""The records of the device that a session has: every tick of each run."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.study.session_folder import StoredSession

RECORD = "ticks-{:02d}.hprec"
_WANTED = ("monotonic_s", "media_s", "force_n", "position_m")


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
    """Yield the intact ticks of a record; damage is added to the notices."""
    name = f"{path.parent.name}/{path.name}"
    try:
        with RecordReader(path) as reader:
            if not set(_WANTED) <= set(reader.dtype.names or ()):
                what = Message("lacks what is to be exported")
                notices.append(joined(": ", (name, what)))
                return
            for frame in reader.frames():
                yield frame.ticks
            if reader.notice:
                notices.append(joined(": ", (name, reader.notice)))
    except InputError as problem:
        notices.append(joined(": ", (name, problem.what)))
