"""Tables of programs whose columns are named: AndroSensor, RaceChrono, Xsens.

Lines above the header and between header and rows (units, sources) are passed over.
Each sensor may have rows of its own, with empty cells for the others.

AndroSensor and apps like it: "ACCELEROMETER X (m/s²)", "GYROSCOPE X (rad/s)",
"LINEAR ACCELERATION X (m/s²)", "Time since start in ms ", semicolons or commas; others
write "time (ms)".

RaceChrono: lines about the session, then the header. Format 3 has units ("unix time",
"G", "deg/s") and sources ("101: acc") in the two lines below it, and every sensor
interpolated in every row; format 2 has units and sources in the names ("X acceleration (G) *acc").

Xsens DOT: optional lines "sep=,", "DeviceTag:,D1" ..., then
PacketCounter,SampleTimeFine (us of a 32-bit counter), Euler_X or Quat_W ..., FreeAcc_X or
Acc_X ... in m/s2, Gyr_X ... in deg/s, Mag_X ... in units of the earth's field.

Xsens MTw and MTi (MT Manager): lines of "//", among them "// Update Rate: 100.0Hz", then
tabs: PacketCounter (16 bits), SampleTimeFine (often empty), Acc_X ... in m/s2, Gyr_X ...
in rad/s, Mag_X ... in units of the earth's field.

Source: RaceChrono 9.1 and 10.0 (format 3), Xsens DOT 2021.0 and MT Manager (firmware
4.0.2): exports in public repositories (popShell/RaceChrono-Notebooks,
jLynx/RaceChrono-to-CSV, Allwillcome/XsensDot2Mtw4OpenSense). RaceChrono format 2 and
AndroSensor: headers in public programs that read them. Units of Xsens: its manuals, from
memory.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.assemble import log_reader, only_one
from hapticplayer.capture.choices import TIME_UNITS, LogChoices, LogQuestion
from hapticplayer.capture.csv_table import Shape, head_lines, is_number, read_table
from hapticplayer.capture.formats import Confidence, Reader
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, split_sensors, unwrapped
from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats
from hapticplayer.model.spellings import column_names, find_separator

UNITS: Mapping[str, str] = {
    "m/s^2": "m/s2",
    "m/s²": "m/s2",
    "m/s2": "m/s2",
    "g": "g",
    "G": "g",
    "rad/s": "rad/s",
    "°/s": "deg/s",
    "deg/s": "deg/s",
    "µT": "uT",
    "μT": "uT",
    "uT": "uT",
}
"""Names of units in headers."""


@dataclass(frozen=True, slots=True)
class TableLayout:
    """The table of a program.

    Attributes:
        text: its name, for people.
        mark: pattern in the beginning of the file.
        time: pattern of the time's column; a group may hold its unit.
        sensors: patterns of the columns of accel (with gravity), linear (without),
            rate and field; groups are the axis and, in some, the unit.
        units: of the sensors, if neither the names nor the line below them say.
        time_unit: if the name does not say.
        rate_mark: pattern of the rows per second, for a time that counts rows.
        wraps_at: where the time starts again at 0.
        is_since_first_row: whether times count from the first row.
        words: the axes.
    """

    text: str
    mark: str
    time: str
    sensors: Mapping[str, str]
    units: Mapping[str, str] = field(default_factory=dict)
    time_unit: str = "s"
    rate_mark: str = ""
    wraps_at: float = 0.0
    is_since_first_row: bool = True
    words: str = ""


class _Header(NamedTuple):
    """Where the columns are.

    Attributes:
        columns: by sensor; "time" has one.
        units: by sensor and of the time, if named.
        rows_at: lines before the first row.
    """

    separator: str
    decimal: str
    width: int
    columns: Mapping[str, tuple[int, ...]]
    units: Mapping[str, str]
    rows_at: int


def table_reader(layout: TableLayout) -> Reader:
    """Return the reader of a program's tables."""
    mark = re.compile(layout.mark, re.MULTILINE)

    def found(source: LogSource) -> list[str]:
        return [name for name in source.names if mark.search(source.head(name))]

    def recognises(source: LogSource) -> Confidence:
        return Confidence.CERTAIN if found(source) else Confidence.NO

    def read(source: LogSource, choices: LogChoices) -> RawLog:
        return _read(source, only_one(found(source), source), layout, choices)

    return log_reader(recognises, read)


def _read(
    source: LogSource, name: str, layout: TableLayout, choices: LogChoices
) -> RawLog:
    """Return the log.

    Raises:
        InputError: when it holds no acceleration.
    """
    header = _header(source, name, layout)
    accel = "accel" if header and "accel" in header.columns else "linear"
    if header is None or accel not in header.columns:
        raise InputError(
            "is a table of {program} without the acceleration of three axes",
            where=source.where(name),
            remedy="export the accelerometer and the gyroscope too",
            program=layout.text,
        )
    kinds = [kind for kind in (accel, "rate", "field") if kind in header.columns]
    wanted = [at for kind in ("time", *kinds) for at in header.columns[kind]]
    numbers = read_table(
        source,
        name,
        Shape(
            header.width,
            tuple(wanted),
            header.separator,
            header.decimal,
            skip_lines=header.rows_at,
        ),
    )
    values = numbers.values
    time_s = _times(values[:, 0], layout, header, choices, source, name)
    parts = {
        kind: values[:, at : at + 3] for kind, at in zip(kinds, (1, 4, 7), strict=False)
    }
    parts = {**parts, "accel": parts[accel]}
    streams = split_sensors(time_s, parts)
    units = {**layout.units, **header.units}
    return RawLog(
        name=layout.text,
        accel=streams["accel"],
        rate=streams.get("rate"),
        field=streams.get("field"),
        accel_unit=units.get(accel, "m/s2"),
        rate_unit=units.get("rate", "rad/s"),
        field_unit=units.get("field", "uT"),
        axes_words=layout.words,
        is_gravity_free=accel == "linear",
        notes=numbers.notes,
    )


def _times(
    values: Floats,
    layout: TableLayout,
    header: _Header,
    choices: LogChoices,
    source: LogSource,
    name: str,
) -> Floats:
    step_s = TIME_UNITS[header.units.get("time", layout.time_unit)]
    if layout.rate_mark:
        found = re.search(layout.rate_mark, source.head(name))
        rate_hz = choices.take_rate_hz() or (float(found[1]) if found else 0.0)
        if not rate_hz:
            raise LogQuestion(
                Message("does not declare its rate"),
                ("rate-hz=100",),
                source.where(name),
            )
        step_s = 1.0 / rate_hz
    if layout.wraps_at:
        values = unwrapped(values, layout.wraps_at)
    known = values[np.isfinite(values)]
    if layout.is_since_first_row and len(known):
        values -= known[0]
    with np.errstate(all="ignore"):
        return np.asarray(values * step_s)


def _header(source: LogSource, name: str, layout: TableLayout) -> _Header | None:
    """Return where the columns of a table are, or None."""
    lines = head_lines(source, name)
    cells_of = [column_names(line, find_separator(line)) for line in lines]
    found = [_columns(cells, layout) for cells in cells_of]
    at = next((n for n, (held, _) in enumerate(found) if {"time"} < set(held)), None)
    if at is None:
        return None
    columns, units = found[at]
    separator = find_separator(lines[at])
    (time_at,) = columns["time"]
    for rows_at, line in enumerate(lines[at + 1 :], start=at + 1):
        cells = column_names(line, separator)
        cell = cells[time_at] if len(cells) > time_at else ""
        if cell and is_number(cell.replace(",", ".")):
            decimal = "," if separator != "," and "," in line else "."
            return _Header(separator, decimal, len(cells), columns, units, rows_at)
        for kind, held in columns.items():
            unit = cells[held[0]] if len(cells) > held[0] else ""
            if kind not in units and unit in UNITS:
                units[kind] = UNITS[unit]
    return None


def _columns(
    names: tuple[str, ...], layout: TableLayout
) -> tuple[dict[str, tuple[int, ...]], dict[str, str]]:
    """Return the columns and the units that the names of a header declare."""
    columns: dict[str, tuple[int, ...]] = {}
    units: dict[str, str] = {}
    for kind, pattern in {"time": layout.time, **layout.sensors}.items():
        axes: dict[str, int] = {}
        unit = ""
        for number, name in enumerate(names):
            match = re.fullmatch(pattern, name, re.IGNORECASE)
            if match is None:
                continue
            groups = [group for group in match.groups() if group]
            axes.setdefault(groups.pop(0).lower() if kind != "time" else "t", number)
            unit = unit or (groups[0] if groups else "")
        if set(axes) == (set("xyz") if kind != "time" else {"t"}):
            columns[kind] = tuple(axes[axis] for axis in sorted(axes))
            if unit:
                units[kind] = unit.lower() if kind == "time" else UNITS.get(unit, unit)
    return columns, units


_PHONE = Message("the phone's axes: x right, y top, z out of the screen")

_SINCE_START = r"time(?:stamp)?(?: since start)? ?(?:in |\()(s|ms|us|ns)\b\)?"
"""phyphox has "Time (s)"."""

ANDROSENSOR = table_reader(
    TableLayout(
        Message("AndroSensor"),
        mark=rf"(?i)^(?=.*\bACCELER(?:OMETER|ATION) X \()(?=.*\b(?!time \(s\)){_SINCE_START})",
        time=_SINCE_START,
        sensors={
            "accel": r"ACCELEROMETER ([XYZ]) \((.+)\)",
            "linear": r"LINEAR ACCELERATION ([XYZ]) \((.+)\)",
            "rate": r"GYROSCOPE ([XYZ]) \((.+)\)",
            "field": r"MAGNETIC FIELD ([XYZ]) \((.+)\)",
        },
        is_since_first_row=False,
        words=_PHONE,
    )
)
RACECHRONO = table_reader(
    TableLayout(
        Message("RaceChrono"),
        mark=r"\A\"?This file is created using RaceChrono",
        time=r"timestamp|Time \(s\)",
        sensors={
            "accel": r"([xyz])(?:_acc| acceleration \((.+)\).*)",
            "rate": r"([xyz])(?:_rate_of_rotation| rate of rotation \((.+)\).*)",
        },
        units={"accel": "g", "rate": "deg/s"},
        words=_PHONE,
    )
)
XSENS_DOT = table_reader(
    TableLayout(
        Message("Xsens DOT"),
        mark=r"\A(?!//)(?:.*\n)*?\"?PacketCounter\"?[,;\t]\"?SampleTimeFine",
        time="SampleTimeFine",
        sensors={
            "accel": r"Acc_([XYZ])",
            "linear": r"FreeAcc_([XYZ])",
            "rate": r"Gyr_([XYZ])",
        },
        units={"rate": "deg/s"},
        time_unit="us",
        wraps_at=2.0**32,
        words=Message("the sensor's axes"),
    )
)
XSENS_MT = table_reader(
    TableLayout(
        Message("Xsens MT Manager"),
        mark=r"\A//(?:.*\n)*?PacketCounter\b",
        time="PacketCounter",
        sensors={
            "accel": r"Acc_([XYZ])",
            "linear": r"FreeAcc_([XYZ])",
            "rate": r"Gyr_([XYZ])",
        },
        rate_mark=r"//\s*Update Rate:\s*([\d.]+)\s*Hz",
        wraps_at=2.0**16,
        words=Message("the sensor's axes"),
    )
)
