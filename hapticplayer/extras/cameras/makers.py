"""Whose telemetry a clip holds, by its marks, and what reads it."""

import os
from pathlib import Path
from typing import NamedTuple

from hapticplayer.errors import Message
from hapticplayer.installation import EXTRAS, how_to_get
from hapticplayer.media.telemetry import data_tracks
from hapticplayer.untrusted import open_regular


class Maker(NamedTuple):
    """A kind of telemetry.

    Attributes:
        name: of the maker or the format.
        marks: of its track.
        names: a part of the track's name, in lower case.
        has_end: whether its mark is the end of the file.
        why_not: it cannot be read; "" where the library reads it.
    """

    name: str
    marks: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    has_end: bool = False
    why_not: Message | str = ""


_BLOCK_BYTES = 1 << 20
INSTA360 = b"8db42d694ccc418790edff439fe026bf"

MAKERS = (
    Maker("Sony", marks=("rtmd",)),
    Maker("Insta360", has_end=True),
    Maker("DJI", marks=("djmd", "dbgi"), names=("dji",),
        why_not=Message("which has no accelerometer samples (DJI stores orientations only)")),
    Maker("Google's CAMM", marks=("camm",), names=("cameramotionmetadata", "camm"),
        why_not=Message("which nothing here reads")),
    Maker("Canon", marks=("CTMD",), why_not=Message("which has no motion")),
)  # fmt: skip


def maker_of(path: Path) -> Maker | None:
    """Whose telemetry a clip holds, None where no mark tells."""
    tracks = data_tracks(path)
    is_ended = marked_size(path) is not None
    for maker in MAKERS:
        is_marked = any(
            track.mark in maker.marks
            or any(name in track.name.lower() for name in maker.names)
            for track in tracks
        )
        if is_marked or (maker.has_end and is_ended):
            return maker
    return None


def marked_size(path: Path) -> int | None:
    """The size of a file up to Insta360's mark, None without it.

    Zeros behind it are of a card or a copy.
    """
    with open_regular(path) as reader:
        at, content = reader.seek(0, os.SEEK_END), b""
        while at and not content:
            at = max(0, at - _BLOCK_BYTES)
            reader.seek(at)
            content = reader.read(_BLOCK_BYTES + len(INSTA360)).rstrip(b"\0")
        reader.seek(max(0, at + len(content) - len(INSTA360)))
        is_marked = reader.read(len(INSTA360)) == INSTA360
    return at + len(content) if is_marked else None


def has_library() -> bool:
    """Whether the library can be imported here."""
    return EXTRAS["cameras"].is_here()


def how_to_read() -> Message:
    """How to get the library."""
    return Message(
        "install hapticplayer[cameras], which reads it ({how})",
        how=how_to_get("cameras"),
    )
