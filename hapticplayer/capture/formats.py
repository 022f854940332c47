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
        """Import its reader."""
        return cast(Reader, extension.load(self.home))


_HERE = "hapticplayer.capture"
FORMATS: tuple[RecordingFormat, ...] = (
    RecordingFormat("gopro", Message("GoPro"), f"{_HERE}.gopro:READER",
        "the track `GoPro MET`; `DEVC` of raw GPMF", "at the first frame of the video; raw GPMF without STMP: where the first payload begins", "recordings of HERO5, 6, 7, 8, 9, 13 (time lapse) and Fusion; documentation of MAX and HERO11"),
    RecordingFormat("si-csv", Message("CSV in SI units"), f"{_HERE}.si_csv:READER",
        "`time_s,ax,...`", "where `time_s` is 0", "itself"),
    RecordingFormat("sensor-logger", Message("Sensor Logger"), f"{_HERE}.logs.sensor_logger:READER",
        "`time,seconds_elapsed,...`, in a folder or zip", "where `seconds_elapsed` is 0, the start of the recording", "documentation"),
    RecordingFormat("phyphox", Message("phyphox"), f"{_HERE}.logs.phyphox:READER",
        '`"Time (s)"` and the names of the axes, in a CSV or zip', "where `Time (s)` is 0, the start of the experiment", "documentation; the layout of exports of Android (tab) and iOS (comma)"),
    RecordingFormat("gcsv", Message("Gyroflow gcsv"), f"{_HERE}.logs.gcsv:READER",
        "its first line", "where `t` is 0", "documentation"),
    RecordingFormat("euroc", Message("EuRoC"), f"{_HERE}.logs.nanoseconds:EUROC",
        "`#timestamp [ns],w_RS_S_x ...`", "at the first row of the IMU", "documentation; the layout of an excerpt"),
    RecordingFormat("mars", Message("MARS logger"), f"{_HERE}.logs.nanoseconds:MARS",
        "`Timestamp[nanosec], gx[rad/s] ...`; `frame_timestamps.txt` fixes the clock", "at the first row of the IMU", "documentation"),
    RecordingFormat("razor", Message("Razor 9DOF"), f"{_HERE}.logs.razor_lines:READER",
        "`#A-C=` of Razor-AHRS, or raw `$...#`", "at the first row", "firmware source; raw output from memory"),
    RecordingFormat("ultimate-imu", Message("Ultimate IMU, stock firmware"), f"{_HERE}.logs.ultimate_imu:READER",
        "10 numbers, LF CR", "where the milliseconds are 0, the start of the board", "firmware source"),
    RecordingFormat("razor-m0", Message("Razor M0"), f"{_HERE}.logs.razor_m0:READER",
        "numbers with comma and blank, CRLF", "where the milliseconds are 0, the start of the board", "firmware source"),
    RecordingFormat("opencamera", Message("OpenCamera Sensors"), f"{_HERE}.logs.opencamera:READER",
        "x, y, z, ns without header, in a folder or zip; `*_timestamps.csv` fixes the clock", "at the first row of the accelerometer's file", "documentation"),
    RecordingFormat("androsensor", Message("AndroSensor"), f"{_HERE}.logs.named_tables:ANDROSENSOR",
        "`ACCELEROMETER X (m/s²)` and `Time since start in ms`", "where the time since start is 0", "headers in public programs"),
    RecordingFormat("racechrono", Message("RaceChrono"), f"{_HERE}.logs.named_tables:RACECHRONO",
        "its first line, formats 2 and 3", "at the first row", "the layout of an export (3); headers in public programs (2)"),
    RecordingFormat("xsens-dot", Message("Xsens DOT"), f"{_HERE}.logs.named_tables:XSENS_DOT",
        "`PacketCounter,SampleTimeFine`", "at the first row", "the layout of an export of free acceleration"),
    RecordingFormat("xsens-mt", Message("Xsens MT Manager"), f"{_HERE}.logs.named_tables:XSENS_MT",
        "`//` lines, `PacketCounter`", "at the first row", "the layout of an export without gyroscope"),
    RecordingFormat("csv", Message("CSV with chosen columns"), f"{_HERE}.logs.any_table:READER",
        "four columns of numbers or more", "where the time column is 0; at the first row for `time-unit=ns` or without a time", "the layout of SisFall"),
)  # fmt: skip
"""Those of the core, in the order in which they are listed."""

ANY_TABLE = FORMATS[-1]


def recording_formats() -> tuple[RecordingFormat, ...]:
    """Those of the core and of extensions."""
    return tuple(extension.rows("recording_formats", RecordingFormat, FORMATS))
