"""Whose telemetry a clip holds, by its marks, and what reads it."""

import importlib.util
import os
from pathlib import Path
from typing import NamedTuple

from hapticplayer.doctor import CAMERAS, how_to_get_cameras
from hapticplayer.errors import Message
from hapticplayer.media.telemetry import data_tracks
from hapticplayer.untrusted import open_regular


class Maker(NamedTuple):
    """A kind of telemetry.

    Attributes:
        name: of the maker or the format.
        marks: of its track.
        names: a part of the track's name, in lower case.
        end: of the file.
        why_not: it cannot be read; "" where the library reads it.
    """

    name: str
    marks: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    end: bytes = b""
    why_not: Message | str = ""


MAKERS = (
    Maker("Sony", marks=("rtmd",)),
    Maker("Insta360", end=b"8db42d694ccc418790edff439fe026bf"),
    Maker("DJI", marks=("djmd", "dbgi"), names=("dji",),
        why_not=Message("which has no accelerometer samples (DJI stores orientations only)")),
    Maker("Google's CAMM", marks=("camm",), names=("cameramotionmetadata", "camm"),
        why_not=Message("which nothing here reads")),
    Maker("GoPro", marks=("gpmd",),
        why_not=Message("whose track another program has renamed; the camera's file is read")),
    Maker("Canon", marks=("CTMD",), why_not=Message("which has no motion")),
)  # fmt: skip


def maker_of(path: Path) -> Maker | None:
    """Whose telemetry a clip holds, None where no mark tells."""
    tracks = data_tracks(path)
    with open_regular(path) as reader:
        reader.seek(-min(32, reader.seek(0, os.SEEK_END)), os.SEEK_END)
        end = reader.read()
    for maker in MAKERS:
        is_marked = any(
            track.mark in maker.marks
            or any(name in track.name.lower() for name in maker.names)
            for track in tracks
        )
        if is_marked or (maker.end and end.endswith(maker.end)):
            return maker
    return None


def has_library() -> bool:
    """Whether the library can be imported here."""
    return importlib.util.find_spec("telemetry_parser") is not None


def how_to_read() -> Message:
    """How to get the library."""
    return Message(
        "install hapticplayer[cameras] ({library}), which reads it ({how})",
        library=CAMERAS,
        how=how_to_get_cameras(),
    )
