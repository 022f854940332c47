"""Where results go: nothing that exists is overwritten.

With `--overwrite` a file is replaced, but only by one of the same kind: each writer knows
its own files by their beginning.
"""

import os
from collections.abc import Callable
from pathlib import Path

from hapticplayer.errors import InputError, Message
from hapticplayer.untrusted import open_regular

HEAD_BYTES = 1 << 16
FOLDER, FILE = Message("folder"), Message("file")
_OVERWRITE = Message("choose another file, or replace it with --overwrite")

IsOurs = Callable[[bytes], bool]
"""Whether a file begins as what is to be written there does."""


def refuse_existing(
    target: Path,
    kind: str = FILE,
    is_ours: IsOurs | None = None,
    error: type[InputError] = InputError,
) -> None:
    """Refuse a target that exists.

    Args:
        target: of the result.
        kind: FILE or FOLDER.
        is_ours: recognises a file that may be overwritten; None overwrites nothing.
        error: what to raise.

    Raises:
        InputError: or `error`.
    """
    if not os.path.lexists(target):
        return
    other = Message("choose another {kind}", kind=kind)
    if is_ours is None:
        remedy = _OVERWRITE if kind == FILE else other
        raise error(Message("already exists"), where=str(target), remedy=remedy)
    with open_regular(target, error, other) as reader:
        head = reader.read(HEAD_BYTES)
    if not is_ours(head):
        raise error(
            Message(
                "is not overwritten, because it is not such a file written by hapticplayer"
            ),
            where=str(target),
            remedy=other,
        )


def make_way(target: Path, is_ours: IsOurs | None = None) -> None:
    """Remove the file that is overwritten.

    Raises:
        InputError: as `refuse_existing`, or when it cannot be removed.
    """
    refuse_existing(target, FILE, is_ours)
    try:
        target.unlink(missing_ok=True)
    except OSError as problem:
        raise InputError(
            "cannot be overwritten ({reason})",
            where=str(target),
            remedy="choose another file",
            reason=problem,
        ) from problem
