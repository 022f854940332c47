"""EuRoC (and VI datasets) and the MARS logger: gyro, then accelerometer, ns, SI.

EuRoC: `#timestamp [ns],w_RS_S_x [rad s^-1],...,a_RS_S_x [m s^-2],...`, mav0/imu0/
data.csv, frames in cam0/data.csv. MARS: `Timestamp[nanosec], gx[rad/s], ...`,
some with a field and further columns; frame_timestamps.txt has the time of each frame on
the same clock, so that no pats are needed.

Source: projects.asl.ethz.ch (EuRoC MAV, ASL format); OSUPCVLab/mobile-ar-sensor-logger.
"""

import re
from collections.abc import Sequence

from hapticplayer.capture.assemble import log_reader, only_one
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import Shape, read_table
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import NANO, RawLog, split
from hapticplayer.errors import Message
from hapticplayer.model.limits import FIRST_FRAME_S
from hapticplayer.model.spellings import column_names

_EUROC = re.compile(r"^#\s*timestamp \[ns\]$")
_MARS = re.compile(r"^Timestamp\[nanosec\]$")
_AXES = (
    re.compile(r"^(w_RS_S_([xyz]) \[rad s\^-1\]|g([xyz])\[rad/s\])$"),
    re.compile(r"^(a_RS_S_([xyz]) \[m s\^-2\]|a([xyz])\[m/s\^2\])$"),
)
_FIELD = re.compile(r"^m[xyz]\[uT\]$")
_STAMP = re.compile(r"^\s*(\d{6,20})\s*(?:,.*)?$")
_MAX_LIST_BYTES = 1 << 26  # ten hours of 60 frames/s


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
    return RawLog(
        name=title,
        accel=accel,
        rate=rate,
        field=field,
        axes_words=words,
        back_axis=back_axis,
        frames_s=frames_of(source, frame_lists, numbers.origin, float(time_s[-1])),
        notes=numbers.notes,
    )


def frames_of(
    source: LogSource, lists: Sequence[str], origin_ns: int, length_s: float
) -> tuple[float, float] | None:
    """When the first frame began and the last one ended, on the log's clock.

    Args:
        source: with the lists.
        lists: of the times of frames, below an optional header.
        origin_ns: of the log.
        length_s: of the log; a first frame outside is not believed.
    """
    stamps_ns = [
        int(match[1])
        for name in lists[:1]
        for line in source.text(name, _MAX_LIST_BYTES).splitlines()
        if (match := _STAMP.match(line))
    ]
    if not stamps_ns:
        return None
    first_s, last_s = (
        (stamp - origin_ns) * NANO for stamp in (stamps_ns[0], stamps_ns[-1])
    )
    if not FIRST_FRAME_S <= first_s <= length_s:
        return None
    return first_s, last_s + (last_s - first_s) / max(1, len(stamps_ns) - 1)


EUROC = log_reader(recognises_euroc, read_euroc)
MARS = log_reader(recognises_mars, read_mars)
