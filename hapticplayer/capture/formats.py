"""The registry of recording formats, one line for each.

Command line, window, validation and documents use it; a new format is a line here and a
module with its reader, which is imported when a file is read.
"""

import enum
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, cast

from hapticplayer.devices import load
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
    """

    name: str
    text: Message
    home: str

    def reader(self) -> Reader:
        """Import its reader."""
        return cast(Reader, load(self.home))


_HERE = "hapticplayer.capture"
FORMATS: tuple[RecordingFormat, ...] = (
    RecordingFormat("gopro", Message("GoPro"), f"{_HERE}.gopro:READER"),
    RecordingFormat("camera", Message("another camera"), f"{_HERE}.other_cameras:READER"),
    RecordingFormat("si-csv", Message("CSV in SI units"), f"{_HERE}.si_csv:READER"),
    RecordingFormat("sensor-logger", Message("Sensor Logger"), f"{_HERE}.logs.sensor_logger:READER"),
    RecordingFormat("phyphox", Message("phyphox"), f"{_HERE}.logs.phyphox:READER"),
    RecordingFormat("gcsv", Message("Gyroflow gcsv"), f"{_HERE}.logs.gcsv:READER"),
    RecordingFormat("euroc", Message("EuRoC"), f"{_HERE}.logs.nanoseconds:EUROC"),
    RecordingFormat("mars", Message("MARS logger"), f"{_HERE}.logs.nanoseconds:MARS"),
    RecordingFormat("razor", Message("Razor 9DOF"), f"{_HERE}.logs.razor_lines:READER"),
    RecordingFormat("ultimate-imu", Message("Ultimate IMU, stock firmware"), f"{_HERE}.logs.ultimate_imu:READER"),
    RecordingFormat("razor-m0", Message("Razor M0"), f"{_HERE}.logs.razor_m0:READER"),
    RecordingFormat("opencamera", Message("OpenCamera Sensors"), f"{_HERE}.logs.opencamera:READER"),
    RecordingFormat("androsensor", Message("AndroSensor"), f"{_HERE}.logs.named_tables:ANDROSENSOR"),
    RecordingFormat("racechrono", Message("RaceChrono"), f"{_HERE}.logs.named_tables:RACECHRONO"),
    RecordingFormat("xsens-dot", Message("Xsens DOT"), f"{_HERE}.logs.named_tables:XSENS_DOT"),
    RecordingFormat("xsens-mt", Message("Xsens MT Manager"), f"{_HERE}.logs.named_tables:XSENS_MT"),
    RecordingFormat("csv", Message("CSV with chosen columns"), f"{_HERE}.logs.any_table:READER"),
)  # fmt: skip
"""In the order in which they are listed."""

ANY_TABLE = FORMATS[-1]
