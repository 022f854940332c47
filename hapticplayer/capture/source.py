"""What a recording is made of: one file, a folder of files, or a zip of them.

Nothing is unpacked to disk. The limits on the number of members, their size and the
content of a zip apply before memory is used.
"""

import contextlib
import functools
import io
import os
import re
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager
from pathlib import Path, PurePosixPath
from typing import BinaryIO, NamedTuple, cast

from hapticplayer.errors import InputError
from hapticplayer.model.limits import (
    MAX_CSV_BYTES,
    MAX_FOLDER_DEPTH,
    MAX_MEMBERS,
)
from hapticplayer.untrusted import FileState, open_regular, resolve_regular

LogPath = str | os.PathLike[str] | Sequence[str | os.PathLike[str]]
"""Of a log; several files, such as one for each sensor, are one log together."""

HEAD_BYTES = 65_536
"""Of a file, to recognise it: flight controllers write all their settings first."""

_SAMPLE_BYTES = 4096
"""Of these, to tell text from binary: damage farther on is left to the reader."""

ZIP_MAGIC = b"PK\x03\x04"
_CONTROLS = bytes({*range(0x20), 0x7F} - {*b"\t\n\r\f"})
_MAX_FOREIGN_SHARE = 0.05
"""Of the characters of a text in Latin-1: units and names."""

_NO_TEXT = frozenset(
    [
        ".jpg",
        ".jpeg",
        ".png",
        ".gif",
        ".mp4",
        ".mov",
        ".m4a",
        ".wav",
        ".mp3",
        ".npz",
        ".zip",
    ]
)
_ZIP_ERRORS = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    NotImplementedError,
    RuntimeError,
    EOFError,
    OSError,
    ValueError,
)


class _Member(NamedTuple):
    """A file of a source: the claimed size, how to open it, and what it is read from."""

    size_bytes: int
    open: Callable[[], AbstractContextManager[BinaryIO]]
    file: FileState


class LogSource:
    """The files of one recording.

    Attributes:
        path: of the file or folder that was given.
        names: of its members, relative to a folder or in a zip; of a single file,
            its own name.
        is_one_file: neither a folder nor a zip.
        is_binary: one file that is not text: a video, or raw telemetry.
    """

    def __init__(
        self, path: Path, members: dict[str, _Member], *, is_one_file: bool = False
    ) -> None:
        self.path, self.names, self.is_one_file = path, tuple(members), is_one_file
        self._members = members
        self.beginning = functools.cache(self._beginning)
        self.is_binary = is_one_file and not is_text(self.beginning(self.names[0]))

    def alone(self, name: str) -> "LogSource":
        path = self.path if self.is_one_file else self.path / name
        return LogSource(path, {name: self._members[name]}, is_one_file=True)

    def refuse_changed(self) -> None:
        """Raise InputError if a file is not what it was when the source was opened."""
        for state in {member.file for member in self._members.values()}:
            state.refuse_changed()

    def where(self, name: str) -> str:
        """Return the name of a member for messages."""
        return str(self.path) if len(self.names) == 1 else f"{self.path}: {name}"

    def base(self, name: str) -> str:
        """Return the last part of a member's name, in lower case."""
        return PurePosixPath(name).name.lower()

    def _beginning(self, name: str) -> bytes:
        with self._readable(name) as stream:
            return stream.read(HEAD_BYTES)

    def head(self, name: str) -> str:
        """Return the beginning as text; "" if it is not text."""
        return _decoded(self.beginning(name)) or ""

    def first_line(self, name: str) -> str:
        """Return the first line without its end."""
        return re.split(r"[\r\n]", self.head(name), maxsplit=1)[0].strip()

    @contextlib.contextmanager
    def opened(self, name: str) -> Iterator[BinaryIO]:
        """Open a member; reading beyond the limit raises."""
        if self._members[name].size_bytes > MAX_CSV_BYTES:
            raise _too_large(self.where(name))
        with self._readable(name) as stream:
            yield cast(BinaryIO, _Bounded(stream, self.where(name)))

    @contextlib.contextmanager
    def _readable(self, name: str) -> Iterator[BinaryIO]:
        try:
            with self._members[name].open() as stream:
                yield stream
        except InputError:
            raise
        except _ZIP_ERRORS as error:
            raise InputError(
                "cannot be read ({reason})",
                where=self.where(name),
                remedy="copy it again from the recorder",
                reason=error,
            ) from error

    def text(self, name: str, limit_bytes: int = 1 << 20) -> str:
        """Return the whole of a small member."""
        with self.opened(name) as stream:
            return stream.read(limit_bytes).decode("utf-8-sig", "replace")

    def text_of(self, base: str) -> str:
        """Return the text of the first member with this last part, or ""."""
        name = next((name for name in self.names if self.base(name) == base), None)
        return "" if name is None else self.text(name)


class _Bounded(io.RawIOBase):
    """Limits what is read from a stream, whatever size was claimed."""

    def __init__(self, stream: BinaryIO, where: str) -> None:
        super().__init__()
        self._stream, self._where, self._left = stream, where, MAX_CSV_BYTES

    def read(self, size: int = -1) -> bytes:
        wanted = self._left + 1 if size < 0 else min(size, self._left + 1)
        content = self._stream.read(wanted)
        self._left -= len(content)
        if self._left < 0:
            raise _too_large(self._where)
        return content


def _folder_members(folder: Path) -> dict[str, _Member]:
    """Return the files below a folder; links and special files are ignored."""
    files = sorted(_walk(folder, MAX_FOLDER_DEPTH))
    return {file.relative_to(folder).as_posix(): _file_member(file) for file in files}


def _file_member(file: Path) -> _Member:
    state = FileState.of(file)
    return _Member(state.size_bytes, lambda: open_regular(file), state)


def _zip_members(path: Path) -> dict[str, _Member]:
    state = FileState.of(path)
    with open_regular(path) as reader, zipfile.ZipFile(reader) as archive:
        infos = archive.infolist()
    if len(infos) > MAX_MEMBERS:
        raise _too_many(path)
    for info in infos:
        _refuse_escape(info.filename, path)
    return {
        info.filename: _Member(
            info.file_size, functools.partial(_unzipped, path, info), state
        )
        for info in sorted(infos, key=lambda info: info.filename)
        if not info.is_dir() and info.file_size and is_wanted(info.filename)
    }


@contextlib.contextmanager
def _unzipped(path: Path, info: zipfile.ZipInfo) -> Iterator[BinaryIO]:
    with (
        open_regular(path) as reader,
        zipfile.ZipFile(reader) as archive,
        archive.open(info) as stream,
    ):
        yield cast(BinaryIO, stream)


def paths_of(log: LogPath) -> tuple[Path, ...]:
    if isinstance(log, (str, os.PathLike)):
        return (Path(log),)
    return tuple(Path(one) for one in log)


def name_of(log: LogPath) -> str:
    return " + ".join(path.name for path in paths_of(log))


def open_source(log: LogPath) -> LogSource:
    """Return the source at a path: a file, a folder, or a zip; or of several files."""
    path, *others = paths_of(log)
    if others:
        return _several(log)
    folder = Path(path)
    if folder.is_dir():
        return LogSource(folder.resolve(), _folder_members(folder.resolve()))
    found = open_file(path)
    if not found.beginning(found.names[0]).startswith(ZIP_MAGIC):
        return found
    try:
        return LogSource(found.path, _zip_members(found.path))
    except InputError:
        raise
    except _ZIP_ERRORS as error:
        raise InputError(
            "is a zip that is cut off, damaged or followed by other bytes ({reason})",
            where=str(found.path),
            remedy="export the recording again, or unpack it and give the folder",
            reason=error,
        ) from error


def _several(log: LogPath) -> LogSource:
    """Return files as one source; those of the same name by their path."""
    files = [resolve_regular(path, InputError) for path in paths_of(log)]
    names = [file.name for file in files]
    members = {
        file.name if names.count(file.name) == 1 else str(file): _file_member(file)
        for file in files
    }
    return LogSource(files[0].with_name(name_of(log)), members)


def open_file(path: str | os.PathLike[str]) -> LogSource:
    file = resolve_regular(path, InputError)
    return LogSource(file, {file.name: _file_member(file)}, is_one_file=True)


def is_text(content: bytes) -> bool:
    """Whether the beginning of a file is text in UTF-8 or Latin-1."""
    return _decoded(content) is not None


def _decoded(content: bytes) -> str | None:
    """Return the beginning of a file as text, or None."""
    sample, encoding = content[:_SAMPLE_BYTES], "utf-8-sig"
    try:
        sample.decode(encoding)
    except UnicodeDecodeError as error:
        # a character may be cut at the end of the sample
        if error.start < len(sample) - 3:
            if not _is_latin_1(sample):
                return None
            encoding = "latin-1"
    return None if b"\0" in sample else content.decode(encoding, "replace")


def _is_latin_1(content: bytes) -> bool:
    """Whether nearly all is ASCII, and nothing is a control character."""
    foreign = sum(byte > 0x7F for byte in content)
    return (
        foreign <= _MAX_FOREIGN_SHARE * len(content)
        and content.translate(None, _CONTROLS) == content
    )


def is_plain_text(content: bytes) -> bool:
    """Whether a sample is several lines of text without control characters."""
    return (
        b"\n" in content
        and content.translate(None, _CONTROLS) == content
        and is_text(content)
    )


def is_wanted(name: str) -> bool:
    """Whether a member may be a log: not hidden, no image, no sound."""
    path = PurePosixPath(name)
    is_hidden = any(part.startswith((".", "__MACOSX")) for part in path.parts)
    return not is_hidden and path.suffix.lower() not in _NO_TEXT


def _walk(folder: Path, depth: int) -> list[Path]:
    found: list[Path] = []
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError as error:
        raise InputError(
            "cannot be listed ({reason})",
            where=str(folder),
            remedy="check the rights of the folder",
            reason=error,
        ) from error
    for entry in entries:
        if entry.is_dir(follow_symlinks=False) and depth > 1:
            if is_wanted(entry.name):
                found += _walk(Path(entry.path), depth - 1)
        elif entry.is_file(follow_symlinks=False) and is_wanted(entry.name):
            found += [Path(entry.path)] if entry.stat().st_size else []
        if len(found) > MAX_MEMBERS:
            raise _too_many(folder)
    return found


def _refuse_escape(name: str, path: Path) -> None:
    parts = PurePosixPath(name.replace("\\", "/")).parts
    if ".." in parts or name.startswith(("/", "\\")) or ":" in name[:3]:
        raise InputError(
            "holds {name!r}, a name outside the zip",
            where=str(path),
            remedy="export the recording again",
            name=name[:80],
        )


def _too_many(path: Path) -> InputError:
    return InputError(
        "holds more than {most} files",
        where=str(path),
        remedy="give the folder of one recording",
        most=MAX_MEMBERS,
    )


def _too_large(where: str) -> InputError:
    return InputError(
        "is larger than the limit of {most_mb} MB",
        where=where,
        remedy="cut the log into parts",
        most_mb=MAX_CSV_BYTES >> 20,
    )
