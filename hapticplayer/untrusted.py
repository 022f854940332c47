"""Opens the files that others give: the one place in the program that does.

A FIFO with the name of a clip would hang its reader for ever, a device could send
without end. So a file is opened without waiting and read only if it is a regular one.
"""

import json
import math
import os
import re
import stat
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, NamedTuple, Self

from hapticplayer.errors import InputError, MediaError, Message

ESCAPED = "backslashreplace"
"""For encoding text that may hold the name of a file which is not UTF-8: its bytes are
surrogates in a `str`, and are written as JSON escapes them."""

MAX_ATTACHED_BYTES = 128 << 20
"""All files attached to a video, and all their arrays: both are in memory together. Force of 4 h
at 200 Hz with its random track is 115 MB."""

MAX_ATTACHED_FILES = 64

PATIENCE_S = 20.0
"""How long opening a clip waits for its server; a clip that plays waits for ever."""

_MAX_DEPTH = 64
_CONTROLS = (*range(0x20), *range(0x7F, 0xA0))

ANOTHER = Message("choose another file")
COPY_AGAIN = Message("copy it again from the camera, or choose another file")

_KINDS = (
    (stat.S_ISDIR, Message("is a folder, not a file")),
    (stat.S_ISFIFO, Message("is a pipe, not a file")),
    (stat.S_ISCHR, Message("is a device, not a file")),
    (stat.S_ISBLK, Message("is a device, not a file")),
    (stat.S_ISSOCK, Message("is a socket, not a file")),
)
_ADDRESS = re.compile("[A-Za-z][A-Za-z0-9+.-]+:/")
_FLAGS = os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC

PathLike = str | os.PathLike[str]


def open_regular(
    path: PathLike, error: type[InputError] = InputError, remedy: str = ""
) -> BinaryIO:
    """Open a regular file for reading; never waits for anybody.

    Raises:
        InputError: or `error`, when there is no such file, or it cannot be read.
    """

    def refusal(what: Message, usual_remedy: Message) -> InputError:
        return error(what, where=str(path), remedy=remedy or usual_remedy)

    try:
        _refuse_special(Path(path).stat(), refusal)  # opening a device may act on it
        reader = open(path, "rb", opener=lambda one, _: os.open(one, _FLAGS))  # noqa: SIM115
    except FileNotFoundError:
        if _ADDRESS.match(str(path)):
            what = Message("is an address, not a file of this machine")
            raise refusal(what, Message("download it, and give the file")) from None
        raise refusal(
            Message("there is no such file"), Message("check the name and the folder")
        ) from None
    except PermissionError:
        raise refusal(
            Message("permission denied"), Message("change the rights of the file")
        ) from None
    except (OSError, ValueError) as cause:
        raise refusal(
            Message("cannot be reached ({reason})", reason=cause),
            Message("check the name and the rights of its folder"),
        ) from cause
    try:
        _refuse_special(os.fstat(reader.fileno()), refusal)
    except InputError:
        reader.close()
        raise
    return reader


def read_regular(
    path: PathLike,
    most_bytes: int,
    error: type[InputError] = InputError,
    remedy: str = "",
) -> bytes:
    """Return the content of a regular file.

    Raises:
        InputError: or `error`, when it cannot be read, or is too large.
    """
    try:
        with open_regular(path, error, remedy) as reader:
            size_bytes = os.fstat(reader.fileno()).st_size
            content = reader.read(most_bytes + 1) if size_bytes <= most_bytes else b""
    except OSError as problem:
        what = Message("cannot be read ({reason})", reason=problem)
        raise error(what, where=str(path), remedy=remedy) from problem
    if max(size_bytes, len(content)) > most_bytes:
        raise error(
            Message("is too large (limit: {most_bytes} bytes)", most_bytes=most_bytes),
            where=str(path),
            remedy=remedy or ANOTHER,
        )
    return content


def without_controls(text: str, kept: str = "") -> str:
    """Return a text in which no terminal finds a command.

    Args:
        text: may hold titles and names that others have chosen.
        kept: control characters that stay.
    """
    return text.translate({code: "?" for code in _CONTROLS if chr(code) not in kept})


def parse_json(content: bytes, where: str, error: type[InputError], remedy: str) -> Any:
    """Return the value of a JSON text, all numbers finite and no entry twice.

    Raises:
        InputError: `error`, when it is not such a text.
    """
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        what, to_do = Message("is text in UTF-16"), Message("save it as text in UTF-8")
        raise error(what, where=where, remedy=to_do)
    try:
        value = json.loads(
            content.decode("utf-8-sig"),
            object_pairs_hook=_object,
            parse_constant=_refuse_constant,
            parse_float=_finite_float,
        )
        _refuse_deep(value)
    except (ValueError, RecursionError) as problem:
        what = Message("is not valid JSON ({reason})", reason=problem)
        raise error(what, where=where, remedy=remedy) from problem
    return value


def _refuse_deep(value: Any) -> None:
    """Refuse what the next one who walks through it would need a deep stack for."""
    level = [value] if isinstance(value, dict | list) else []
    for _ in range(_MAX_DEPTH):
        level = [
            inner
            for one in level
            for inner in (one.values() if isinstance(one, dict) else one)
            if isinstance(inner, dict | list)
        ]
        if not level:
            return
    raise ValueError(Message("nested too deeply"))


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for name, value in pairs:
        if name in made:
            raise ValueError(Message("duplicate entry {twice!r}", twice=name))
        made[name] = value
    return made


def _refuse_constant(name: str) -> float:
    raise ValueError(Message("{name} is not a number", name=name))


def _finite_float(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(Message("{name} is out of range", name=text))
    return value


def resolve_regular(path: PathLike, error: type[InputError] = MediaError) -> Path:
    """Return the absolute path of a regular file, for what opens files by name.

    Raises:
        MediaError: or `error`, when it cannot be read, or is empty.
    """
    with open_regular(path, error) as reader:
        if os.fstat(reader.fileno()).st_size == 0:
            raise error(
                Message("is empty (0 bytes)"), where=str(path), remedy=COPY_AGAIN
            )
    return Path(path).resolve()


class FileState(NamedTuple):
    """What tells one state of a file from another.

    Its mtime can be put back after a change; `changed_ns`, its ctime, cannot.
    """

    path: Path
    device: int
    inode: int
    modified_ns: int
    changed_ns: int
    size_bytes: int

    @classmethod
    def of(cls, path: Path, status: os.stat_result | None = None) -> Self:
        """Return the state of now, or that of a status; raises OSError."""
        found = status or path.stat()
        return cls(
            path,
            found.st_dev,
            found.st_ino,
            found.st_mtime_ns,
            found.st_ctime_ns,
            found.st_size,
        )

    def refuse_changed(self, error: type[InputError] = InputError) -> None:
        """Raise the error if the name stands for another file or content now."""
        try:
            is_same = FileState.of(self.path) == self
        except OSError:  # its name is gone
            is_same = False
        if not is_same:
            raise error(
                Message("was changed or replaced while it was read"),
                where=str(self.path),
                remedy=Message("wait until nothing writes to it, then start again"),
            )


class HeldFile:
    """A file that is held open while its content is taken, so that a change is noticed.

    Attributes:
        size_bytes: when it was opened.

    Raises:
        InputError: or `error`, when it cannot be read.
    """

    def __init__(self, path: PathLike, error: type[InputError] = InputError) -> None:
        self.reader, self._error = open_regular(path, error), error
        self._state = FileState.of(Path(path), os.fstat(self.reader.fileno()))
        self.size_bytes = self._state.size_bytes

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _problem: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self.reader.close()

    def refuse_changed(self) -> None:
        """Raise the error if the name stands for another file or content now."""
        self._state.refuse_changed(self._error)


def _refuse_special(
    status: os.stat_result, refusal: Callable[[Message, Message], InputError]
) -> None:
    if stat.S_ISREG(status.st_mode):
        return
    kinds = (sentence for is_kind, sentence in _KINDS if is_kind(status.st_mode))
    sentence = next(kinds, Message("is not a regular file"))
    raise refusal(sentence, Message("choose a file"))
