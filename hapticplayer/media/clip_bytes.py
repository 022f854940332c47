"""A clip that is not a file of this machine, but is read like one."""

import abc
import io
import os
from pathlib import Path
from typing import BinaryIO, Self

from hapticplayer.errors import MediaError, Message
from hapticplayer.model.limits import MAX_HEADER_BYTES, MAX_OPENING_BYTES
from hapticplayer.untrusted import PATIENCE_S, open_regular


class ClipBytes(abc.ABC):
    """Gives the content of a clip that is somewhere else.

    Args:
        name: of the clip, for people.
        size_bytes: of all of it.

    Attributes:
        patience_s: how long a reader waits for its bytes.
    """

    patience_s = PATIENCE_S

    def __init__(self, name: str, size_bytes: int) -> None:
        self.name, self.size_bytes = name, size_bytes

    def __str__(self) -> str:
        return self.name

    @abc.abstractmethod
    def open(self) -> BinaryIO:
        """Return a reader from the beginning, for one thread; it raises MediaError."""

    @abc.abstractmethod
    def beside(self, name: str) -> Self | None:
        """Return the file of a name in the same folder, None without one."""

    @property
    @abc.abstractmethod
    def waiting(self) -> Message | None:
        """Why the next bytes do not come, None while they do."""

    @abc.abstractmethod
    def is_ahead(self, share: float) -> bool:
        """Whether such a share of the clip can be read next without waiting."""

    @abc.abstractmethod
    def close(self) -> None:
        """Let go of where it is; its readers fail from now on."""


def path_of(clip: Path | ClipBytes) -> Path:
    """The path of a clip; of a remote one its name, where no file of this machine is."""
    return Path("remote:", clip.name) if isinstance(clip, ClipBytes) else clip


AnyClip = str | os.PathLike[str] | ClipBytes


def open_clip(clip: AnyClip) -> BinaryIO:
    """Return a reader of a clip; raises MediaError."""
    return (
        clip.open() if isinstance(clip, ClipBytes) else open_regular(clip, MediaError)
    )


def size_of(reader: BinaryIO) -> int:
    """Return the size of what is read, bytes."""
    at = reader.tell()
    size_bytes = reader.seek(0, os.SEEK_END)
    reader.seek(at)
    return size_bytes


HIDDEN = b"\xec\x81\0\xec"
"""In place of the number of Matroska's attachments: two void elements, the first of 3 bytes."""


class HeaderReader:
    """Reads a file for FFmpeg, which keeps what it meets at opening in memory.

    While it `is_opening`, so many bytes are given at most, and only while the process grows
    little. Attachments are hidden: nobody needs those that FFmpeg would load.

    Args:
        reader: of the file.
        hidden: where attachments begin.
        descriptor: to be closed with its last user, which may be part of a cycle.
    """

    def __init__(
        self,
        reader: BinaryIO | io.FileIO,
        hidden: tuple[int, ...],
        descriptor: int | None = None,
    ) -> None:
        self._reader, self._hidden, self._descriptor = reader, hidden, descriptor
        self._left_bytes = MAX_HEADER_BYTES
        self.name = str(getattr(reader, "name", ""))
        self.is_opening = True
        self._most_bytes = resident_bytes() + MAX_OPENING_BYTES
        self.seek, self.tell = reader.seek, reader.tell

    def __del__(self) -> None:
        """Close the file."""
        self._reader.close()
        if self._descriptor is not None:
            os.close(self._descriptor)

    def read(self, count: int) -> bytes:
        """Return the next bytes; raises MediaError beyond the limits."""
        at = self._reader.tell() if self._hidden else 0
        content = self._reader.read(count)
        if self.is_opening:
            self._left_bytes -= len(content)
            if self._left_bytes < 0 or resident_bytes() > self._most_bytes:
                raise MediaError(
                    "its headers are too large",
                    where=self.name,
                    remedy="choose another clip",
                )
        for place in self._hidden:
            if at - len(HIDDEN) < place < at + len(content):
                content = _patched(content, place - at)
        return content


def _patched(content: bytes, place: int) -> bytes:
    first, last = max(0, place), min(len(content), place + len(HIDDEN))
    return content[:first] + HIDDEN[first - place : last - place] + content[last:]


def resident_bytes() -> int:
    """The memory that this process has now."""
    with Path("/proc/self/statm").open("rb", buffering=0) as status:
        return int(status.read(200).split()[1]) * os.sysconf("SC_PAGE_SIZE")
