"""EuRoC (and VI datasets) and the MARS logger: gyro, then accelerometer, ns, SI.

EuRoC: `#timestamp [ns],w_RS_S_x [rad s^-1],...,a_RS_S_x [m s^-2],...`, mav0/imu0/
data.csv, frames in cam0/data.csv. MARS: `Timestamp[nanosec], gx[rad/s], ...`,
some with a field and further columns; frame_timestamps.txt has the time of each frame on
the same clock, so that no pats are needed.

Source: projects.asl.ethz.ch (EuRoC MAV, ASL format); OSUPCVLab/mobile-ar-sensor-logger.
"""

import re

from hapticplayer.capture.assemble import log_reader, only_one
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import Shape, column_names, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import NANO, RawLog, split
from hapticplayer.errors import Message
from hapticplayer.model.limits import FIRST_FRAME_S

_EUROC = re.compile(r"^#\s*timestamp \[ns\]$")
_MARS = re.compile(r"^Timestamp\[nanosec\]$")
_AXES = (
    re.compile(r"^(w_RS_S_([xyz]) \[rad s\^-1\]|g([xyz])\[rad/s\])$"),
    re.compile(r"^(a_RS_S_([xyz]) \[m s\^-2\]|a([xyz])\[m/s\^2\])$"),
)
_FIELD = re.compile(r"^m[xyz]\[uT\]$")
_STAMP = re.compile(r"^\s*(\d{6,20})\s*(?:,.*)?$")


def recognises_euroc(source: LogSource) -> Confidence:
    """Its header."""
    return Confidence.CERTAIN if _tables(source, _EUROC) else Confidence.NO


def recognises_mars(source: LogSource) -> Confidence:
    """Its header."""
    return Confidence.CERTAIN if _tables(source, _MARS) else Confidence.NO


def read_euroc(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    name = only_one(_tables(source, _EUROC), source)
    frame_lists = [
        n
        for n in source.names
        if column_names(source.first_line(n), ",")[-1:] == ("filename",)
    ]
    return _read(source, name, frame_lists[:1], "EuRoC", Message("the IMU's axes"))


def read_mars(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    name = only_one(_tables(source, _MARS), source)
    frame_lists = [n for n in source.names if source.base(n) == "frame_timestamps.txt"]
    words = Message("the phone's axes: x right, y top, z out of the screen")
    return _read(
        source, name, frame_lists[:1], Message("MARS logger"), words, back_axis="z"
    )


def _tables(source: LogSource, mark: re.Pattern[str]) -> list[str]:
    """Return the members with this header whose columns are gyro and accelerometer."""
    found = []
    for name in source.names:
        columns = column_names(source.first_line(name), ",")
        fits = len(columns) >= 7 and mark.match(columns[0])
        if fits and all(_AXES[(at - 1) // 3].match(columns[at]) for at in range(1, 7)):
            found.append(name)
    return found


def _read(
    source: LogSource,
    name: str,
    frame_lists: list[str],
    title: str,
    words: str,
    *,
    back_axis: str = "",
) -> RawLog:
    columns = column_names(source.first_line(name), ",")
    has_field = len(columns) >= 10 and all(_FIELD.match(c) for c in columns[7:10])
    wanted = tuple(range(10 if has_field else 7))
    shape = Shape(len(columns), wanted, integer=0, skip_lines=1)
    numbers = read_table(source, name, shape)
    time_s = numbers.values[:, 0] * NANO
    rate, accel, field = split(
        numbers.values, time_s, (1, 4, 7) if has_field else (1, 4)
    )
    frame0_ns = _first_stamp(source, frame_lists)
    frame0_s = None if frame0_ns is None else (frame0_ns - numbers.origin) * NANO
    return RawLog(
        name=title,
        accel=accel,
        rate=rate,
        field=field,
        axes_words=words,
        back_axis=back_axis,
        frame0_s=plausible_frame0_s(frame0_s, float(time_s[-1])),
        notes=numbers.notes,
    )


def _first_stamp(source: LogSource, frame_lists: list[str]) -> int | None:
    for name in frame_lists:
        stamp = first_stamp_ns(source, name)
        if stamp is not None:
            return stamp
    return None


def first_stamp_ns(source: LogSource, name: str) -> int | None:
    """Return the first time in a list of frames, below an optional header."""
    for line in source.head(name).splitlines()[:3]:
        if match := _STAMP.match(line):
            return int(match[1])
    return None


def plausible_frame0_s(frame0_s: float | None, length_s: float) -> float | None:
    """Return the time of the first frame, or None if it is outside the log."""
    if frame0_s is None or not FIRST_FRAME_S <= frame0_s <= length_s:
        return None
    return frame0_s


EUROC = log_reader(recognises_euroc, read_euroc)
MARS = log_reader(recognises_mars, read_mars)
