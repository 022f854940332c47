"""The registry of recording formats, one line for each.

Command line, window and documents use it; a new format is a line here or in an extra, and a
module with its reader, which is imported when a file is read.
"""

import enum
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, cast

from hapticplayer import extension
from hapticplayer.errors import InputError, Message

if TYPE_CHECKING:
    from hapticplayer.capture.choices import LogChoices
    from hapticplayer.capture.log_tables import LogTable
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


def without_reason(_source: "LogSource") -> InputError | None:
    """Of a format whose files cannot be mistaken."""
    return None


def without_tables(_source: "LogSource") -> tuple["LogTable", ...]:
    """Of a format that describes itself."""
    return ()


WhyNot = Callable[["LogSource"], InputError | None]


class Reader(NamedTuple):
    """The functions of a format.

    Attributes:
        recognises: judges by the beginnings of the files only.
        read: reads the whole recording.
        why_not: the reason why what is nearly of this format is not, or None.
        tables: the beginnings of those whose columns a person names.
    """

    recognises: "Callable[[LogSource], Confidence]"
    read: "Callable[[LogSource, LogChoices], Recording]"
    why_not: WhyNot = without_reason
    tables: "Callable[[LogSource], tuple[LogTable, ...]]" = without_tables


class RecordingFormat(NamedTuple):
    """One format that can be read.

    Attributes:
        name: for `--read-as format=`.
        text: for people.
        home: of its `Reader`, as module:name.
        marks: what it is recognised by; this and the next two are for documents.
        zero: where its clock reads zero.
        checked: what its reader was compared with.
        is_any: any table, of which a person names the columns; others come first.
    """

    name: str
    text: Message
    home: str
    marks: str = ""
    zero: str = ""
    checked: str = ""
    is_any: bool = False

    def reader(self) -> Reader:
        return cast(Reader, extension.load(self.home))


_HERE = "hapticplayer.capture"
FORMATS: tuple[RecordingFormat, ...] = (
    RecordingFormat("gopro", Message("GoPro"), f"{_HERE}.gopro:READER",
        "the track `GoPro MET`; `DEVC` of raw GPMF", "at the first frame of the video; raw GPMF without STMP: where the first payload begins", "recordings of HERO5, 6, 7, 8, 9, 13 (time lapse) and Fusion; documentation of MAX and HERO11"),
    RecordingFormat("recorded", Message("Recorded here"), f"{_HERE}.recorded:READER",
        "a folder with `recording.json` and `imu.csv`", "at the first frame of the video", "itself"),
    RecordingFormat("si-csv", Message("CSV in SI units"), f"{_HERE}.si_csv:READER",
        "`time_s,ax,...`", "where `time_s` is 0", "itself"),
)  # fmt: skip
"""Those of the core, in the order in which they are listed."""


def recording_formats() -> tuple[RecordingFormat, ...]:
    """Those of the core and of extensions."""
    return tuple(extension.rows("recording_formats", RecordingFormat, FORMATS))
