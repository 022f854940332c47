"""The file of answers while a participant sits there: append, sync, then go on."""

import errno
import fcntl
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import Message, StudyError
from hapticplayer.study.json_files import read_file
from hapticplayer.study.private import failed
from hapticplayer.study.records import VERSION, Record, Records, decode, encode

MAX_BYTES = 256 << 20


class Journal:
    """Appends records to a file that exists; one program at a time.

    Args:
        path: made by `session_folder.create_session`.
        clock: of the machine.

    Raises:
        StudyError: when it cannot be written, another program has it, or a newer
            version of the program wrote it.
    """

    def __init__(self, path: Path, clock: Clock) -> None:
        self._path, self._clock = path, clock
        try:
            self._file = os.open(path, os.O_RDWR | os.O_APPEND | os.O_NOFOLLOW)
        except OSError as problem:
            failed(problem, path)
        try:
            _take(self._file, path)
            found = read_journal(path)
        except BaseException:
            os.close(self._file)
            raise
        self.found = found
        self._next = found.next_number
        self._is_torn = found.is_torn

    def append(self, kind: str, **content: Any) -> Record:
        """Keep one record; when this returns, it is on the disk.

        Raises:
            StudyError: when it is not; it can be tried again.
        """
        monotonic_s, utc = self._clock.now_s(), utc_now_iso("milliseconds")
        line = encode(self._next, utc, monotonic_s, kind, content)
        # what an interrupted write left stays a line of its own
        line = b"\n" + line if self._is_torn else line
        try:
            self._is_torn = True
            _write_whole(self._file, line)
            os.fsync(self._file)
            self._is_torn = False
            self._check_place()
        except OSError as problem:
            raise StudyError(
                "the answer could not be saved ({reason})",
                where=str(self._path.parent.name),
                remedy="call the experimenter",
                reason=problem,
            ) from problem
        made = Record(self._next, utc, monotonic_s, kind, content)
        self._next += 1
        return made

    def _check_place(self) -> None:
        """Raise FileNotFoundError when the file is no longer where it was."""
        held, named = os.fstat(self._file), self._path.stat()
        if (held.st_dev, held.st_ino) != (named.st_dev, named.st_ino):
            raise FileNotFoundError(errno.ENOENT, Message("the folder was replaced"))

    def close(self) -> None:
        """Let go; everything has been saved before."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1


def refuse_if_open(path: Path) -> None:
    """Raise StudyError when another program has the file; it may be damaged or gone."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW)
    except OSError:
        return  # nor could a `Journal` open it
    try:
        _take(descriptor, path)
    finally:
        os.close(descriptor)


def _take(descriptor: int, path: Path) -> None:
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as problem:
        raise StudyError(
            "is open in another window",
            where=str(path.parent),
            remedy="close it there first",
        ) from problem


def _write_whole(descriptor: int, line: bytes) -> None:
    if os.write(descriptor, line) != len(line):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def read_journal(path: Path) -> Records:
    """Return what a file of answers holds.

    Raises:
        StudyError: when it cannot be read, or is of a newer program.
    """
    found = decode(read_file(path, MAX_BYTES))
    if found.newest_version > VERSION:
        raise StudyError(
            "holds records of version {found}, this program reads {version}",
            where=str(path),
            remedy="update hapticplayer",
            found=found.newest_version,
            version=VERSION,
        )
    return found


def content_of(records: Records, kind: str) -> list[Mapping[str, Any]]:
    """Return what the records of one kind say, in order."""
    return [record.content for record in records.intact if record.kind == kind]
