"""Makes sure that a path is a regular file before anything reads from it.

A FIFO with the name of a clip would hang the reader for ever, a device could send
without end. This module needs no PyAV, so that text logs can use it.
"""

import os
import stat
from pathlib import Path

from hapticplayer.errors import InputError, MediaError

COPY_AGAIN = "copy it again from the camera, or choose another file"

_KINDS = (
    (stat.S_ISDIR, "is a folder, not a file"),
    (stat.S_ISFIFO, "is a pipe, not a file"),
    (stat.S_ISCHR, "is a device, not a file"),
    (stat.S_ISBLK, "is a device, not a file"),
    (stat.S_ISSOCK, "is a socket, not a file"),
)


def resolve_regular(
    path: str | os.PathLike[str], error: type[InputError] = MediaError
) -> Path:
    """Return the absolute path of a readable, regular file that is not empty.

    Args:
        path: symbolic links are followed.
        error: what to raise.

    Raises:
        MediaError: or `error`, when there is no such file.
    """
    where = str(path)
    try:
        file = Path(path).resolve(strict=True)
        status = file.stat()
    except FileNotFoundError:
        raise error(
            "there is no such file", where=where, remedy="check the name and the folder"
        ) from None
    except (OSError, ValueError, RuntimeError) as cause:
        raise error(
            f"cannot be reached ({reason(cause)})",
            where=where,
            remedy="check the name and the rights of its folder",
        ) from cause
    _check_kind(status, where, error)
    if not os.access(file, os.R_OK):
        raise error(
            "may not be read", where=where, remedy="change the rights of the file"
        )
    return file


def reason(error: BaseException) -> str:
    """Return the first line of what an exception says."""
    text = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return str(text).splitlines()[0]


def _check_kind(status: os.stat_result, where: str, error: type[InputError]) -> None:
    for is_kind, sentence in _KINDS:
        if is_kind(status.st_mode):
            raise error(sentence, where=where, remedy="choose a file")
    if not stat.S_ISREG(status.st_mode):
        raise error("is not a regular file", where=where, remedy="choose a file")
    if status.st_size == 0:
        raise error("is empty (0 bytes)", where=where, remedy=COPY_AGAIN)
