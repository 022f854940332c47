"""The registry of recording formats, one line for each.

Command line, window and documents use it; a new format is a line here or in an extra, and a
module with its reader, which is imported when a file is read.
"""

import enum
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, cast

from hapticplayer import extension
from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.capture.choices import LogChoices
    from hapticplayer.capture.recording import Recording
    from hapticplayer.capture.source import LogSource


class Confidence(enum.IntEnum):
    """How well a source fits a format."""

    NO = 0
    POSSIBLE = 1
    """It can be read, but a more specific format may fit."""
    LIKELY = 2
    """The layout fits; another format could have the same."""
    CERTAIN = 3
    """A header or mark that no other format has."""


class Reader(NamedTuple):
    """The functions of a format.

    Attributes:
        recognises: judges by the beginnings of the files only.
        read: reads the whole recording.
    """

    recognises: "Callable[[LogSource], Confidence]"
    read: "Callable[[LogSource, LogChoices], Recording]"


class RecordingFormat(NamedTuple):
    """One format that can be read.

    Attributes:
        name: for `--read-as format=`.
        text: for people.
        home: of its `Reader`, as module:name.
        marks: what it is recognised by; this and the next two are for documents.
        zero: where its clock reads zero.
        checked: what its reader was compared with.
    """

    name: str
    text: Message
    home: str
    marks: str = ""
    zero: str = ""
    checked: str = ""

    def reader(self) -> Reader:
        return cast(Reader, extension.load(self.home))


_HERE = "hapticplayer.capture"
FORMATS: tuple[RecordingFormat, ...] = (
    RecordingFormat("gopro", Message("GoPro"), f"{_HERE}.gopro:READER",
        "the track `GoPro MET`; `DEVC` of raw GPMF", "at the first frame of the video; raw GPMF without STMP: where the first payload begins", "recordings of HERO5, 6, 7, 8, 9, 13 (time lapse) and Fusion; documentation of MAX and HERO11"),
    RecordingFormat("si-csv", Message("CSV in SI units"), f"{_HERE}.si_csv:READER",
        "`time_s,ax,...`", "where `time_s` is 0", "itself"),
    RecordingFormat("csv", Message("CSV with chosen columns"), f"{_HERE}.any_table:READER",
        "four columns of numbers or more", "where the time column is 0; at the first row for `time-unit=ns`, clock times and dates, or without a time", "the layout of SisFall"),
)  # fmt: skip
"""Those of the core, in the order in which they are listed."""

ANY_TABLE = FORMATS[-1]


def recording_formats() -> tuple[RecordingFormat, ...]:
    """Those of the core and of extensions."""
    return tuple(extension.rows("recording_formats", RecordingFormat, FORMATS))
