"""A clip that is not a file of this machine, but is read like one."""

import abc
import os
from pathlib import Path
from typing import BinaryIO, Self

from hapticplayer.errors import MediaError, Message
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


class LimitedReader:
    """Gives FFmpeg so many bytes at most, for it keeps attachments and tables in memory.

    Attributes:
        left_bytes: that may still be read; infinity without a limit.
    """

    def __init__(self, reader: BinaryIO, most_bytes: float) -> None:
        self._reader, self.left_bytes = reader, most_bytes
        self.seek, self.tell = reader.seek, reader.tell

    def read(self, count: int) -> bytes:
        """Return the next bytes; raises MediaError beyond the limit."""
        content = self._reader.read(count)
        self.left_bytes -= len(content)
        if self.left_bytes < 0:
            raise MediaError(
                "its headers are too large",
                where=str(getattr(self._reader, "name", "")),
                remedy="choose another clip",
            )
        return content
