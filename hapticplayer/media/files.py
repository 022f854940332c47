"""Makes sure that a path is a regular file before anything reads from it.

A FIFO with the name of a clip would hang the reader for ever, a device could send
without end. This module needs no PyAV, so that text logs can use it.
"""

import os
import stat
from pathlib import Path

from hapticplayer.errors import InputError, MediaError, Message

COPY_AGAIN = Message("copy it again from the camera, or choose another file")

_KINDS = (
    (stat.S_ISDIR, Message("is a folder, not a file")),
    (stat.S_ISFIFO, Message("is a pipe, not a file")),
    (stat.S_ISCHR, Message("is a device, not a file")),
    (stat.S_ISBLK, Message("is a device, not a file")),
    (stat.S_ISSOCK, Message("is a socket, not a file")),
)


def resolve_regular(
    path: str | os.PathLike[str], error: type[InputError] = MediaError
) -> Path:
    """Return the absolute path of a readable, regular file that is not empty.

    Raises:
        MediaError: or `error`, when there is no such file.
    """
    where = str(path)
    try:
        file = Path(path).resolve(strict=True)
        status = file.stat()
    except FileNotFoundError:
        raise error(
            Message("there is no such file"),
            where=where,
            remedy=Message("check the name and the folder"),
        ) from None
    except (OSError, ValueError, RuntimeError) as cause:
        raise error(
            Message("cannot be reached ({reason})", reason=cause),
            where=where,
            remedy=Message("check the name and the rights of its folder"),
        ) from cause
    _check_kind(status, where, error)
    if not os.access(file, os.R_OK):
        raise error(
            Message("may not be read"),
            where=where,
            remedy=Message("change the rights of the file"),
        )
    return file


def _check_kind(status: os.stat_result, where: str, error: type[InputError]) -> None:
    for is_kind, sentence in _KINDS:
        if is_kind(status.st_mode):
            raise error(sentence, where=where, remedy=Message("choose a file"))
    if not stat.S_ISREG(status.st_mode):
        raise error(
            Message("is not a regular file"),
            where=where,
            remedy=Message("choose a file"),
        )
    if status.st_size == 0:
        raise error(Message("is empty (0 bytes)"), where=where, remedy=COPY_AGAIN)
