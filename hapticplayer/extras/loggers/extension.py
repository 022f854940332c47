"""Recording formats of phones, loggers and inertial sensors."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.capture.formats import RecordingFormat

_HERE = "hapticplayer.extras.loggers"


def recording_formats() -> "tuple[RecordingFormat, ...]":
    """Each recognised by its content."""
    from hapticplayer.capture.formats import RecordingFormat

    return (
        RecordingFormat("sensor-logger", Message("Sensor Logger"), f"{_HERE}.sensor_logger:READER",
            "`time,seconds_elapsed,...`, in a folder or zip", "where `seconds_elapsed` is 0, the start of the recording", "documentation"),
        RecordingFormat("phyphox", Message("phyphox"), f"{_HERE}.phyphox:READER",
            '`"Time (s)"` and the names of the axes, in a CSV or zip', "where `Time (s)` is 0, the start of the experiment", "documentation; the layout of exports of Android (tab) and iOS (comma)"),
        RecordingFormat("gcsv", Message("Gyroflow gcsv"), f"{_HERE}.gcsv:READER",
            "its first line", "where `t` is 0", "documentation"),
        RecordingFormat("euroc", Message("EuRoC"), f"{_HERE}.nanoseconds:EUROC",
            "`#timestamp [ns],w_RS_S_x ...`", "at the first row of the IMU", "documentation; the layout of an excerpt"),
        RecordingFormat("mars", Message("MARS logger"), f"{_HERE}.nanoseconds:MARS",
            "`Timestamp[nanosec], gx[rad/s] ...`; `frame_timestamps.txt` fixes the clock", "at the first row of the IMU", "documentation"),
        RecordingFormat("razor", Message("Razor 9DOF"), f"{_HERE}.razor_lines:READER",
            "`#A-C=` of Razor-AHRS, or raw `$...#`", "at the first row", "firmware source; raw output from memory"),
        RecordingFormat("ultimate-imu", Message("Ultimate IMU, stock firmware"), f"{_HERE}.ultimate_imu:READER",
            "10 numbers, LF CR", "where the milliseconds are 0, the start of the board", "firmware source"),
        RecordingFormat("razor-m0", Message("Razor M0"), f"{_HERE}.razor_m0:READER",
            "numbers with comma and blank, CRLF", "where the milliseconds are 0, the start of the board", "firmware source"),
        RecordingFormat("opencamera", Message("OpenCamera Sensors"), f"{_HERE}.opencamera:READER",
            "x, y, z, ns without header, in a folder or zip; `*_timestamps.csv` fixes the clock", "at the first row of the accelerometer's file", "documentation"),
        RecordingFormat("androsensor", Message("AndroSensor"), f"{_HERE}.named_tables:ANDROSENSOR",
            "`ACCELEROMETER X (m/s²)` and `Time since start in ms`", "where the time since start is 0", "headers in public programs"),
        RecordingFormat("racechrono", Message("RaceChrono"), f"{_HERE}.named_tables:RACECHRONO",
            "its first line, formats 2 and 3", "at the first row", "the layout of an export (3); headers in public programs (2)"),
        RecordingFormat("xsens-dot", Message("Xsens DOT"), f"{_HERE}.named_tables:XSENS_DOT",
            "`PacketCounter,SampleTimeFine`", "at the first row", "the layout of an export of free acceleration"),
        RecordingFormat("xsens-mt", Message("Xsens MT Manager"), f"{_HERE}.named_tables:XSENS_MT",
            "`//` lines, `PacketCounter`", "at the first row", "the layout of an export without gyroscope"),
        RecordingFormat("csv", Message("CSV with chosen columns"), f"{_HERE}.any_table:READER",
            "four columns of numbers or more", "where the time column is 0; at the first row for `time-unit=ns`, clock times and dates, or without a time", "the layout of SisFall", is_any=True),
    )  # fmt: skip
