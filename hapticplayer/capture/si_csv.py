"""Motion logs and force tracks as plain CSV: SI units, frame A or frame D.

A log is `time_s,ax,ay,az,gx,gy,gz[,mx,my,mz]`: specific force in m/s2 (+9.8 up at
rest), angular rate in rad/s, magnetic field in uT, frame A (x right, y front, z up).
A force track is `time_s,fx_n,fy_n,fz_n` in frame D (x right, y up, z towards the
user); each force holds from its time until the next one's. A column `is_estimated` of
ones is added where the motion was estimated from the picture.

Loggers leave cells empty, repeat rows and swap them: this is repaired if possible, with a
note (`motion.repair_samples`).
"""

import math
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from hapticplayer.capture.assemble import clean
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.csv_table import (
    FIELD_COLUMNS,
    LOG_COLUMNS,
    TIME,
    Numbers,
    Selection,
    Shape,
    at,
    column_names,
    header_fault,
    read_table,
)
from hapticplayer.capture.formats import Confidence, Reader
from hapticplayer.capture.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_SI_RATE_RADPS,
)
from hapticplayer.capture.recording import Recording, gap_notes
from hapticplayer.capture.source import LogSource, open_file
from hapticplayer.errors import InputError, Message
from hapticplayer.model import (
    ClockMap,
    ForceTrack,
    ImuLog,
    Reconstruction,
)
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_FORCE_N
from hapticplayer.storage import file_replaced

FORCE_COLUMNS = (TIME, "fx_n", "fy_n", "fz_n")
ESTIMATED_COLUMNS = ("is_estimated",)

FORCE_STEP_S = 1e-4
"""The haptic loop takes a value every millisecond; denser rows cost memory only."""


def recognises(source: LogSource) -> Confidence:
    """The name of the time column comes first; a folder holds one such file."""
    return Confidence.CERTAIN if len(_logs(source)) == 1 else Confidence.NO


def _logs(source: LogSource) -> list[str]:
    """Return the members that begin with the name of the time column."""
    return [
        name
        for name in source.names
        if source.head(name).lstrip(' \t\r\n"').startswith(TIME)
    ]


def read(source: LogSource, _choices: LogChoices) -> Recording:
    """Return the log.

    Empty cells, NaN and infinity are filled and marked; swapped and repeated rows are
    put in order; gaps remain.

    Raises:
        InputError: with file, line, column and what to do; also when the numbers are
            in g or in degrees, and for what cannot be repaired.
    """
    source = source if source.is_one_file else source.alone(_logs(source)[0])
    numbers = _read_strict(source, LOG_COLUMNS, FIELD_COLUMNS)
    where, values = str(source.path), numbers.values
    _check_accel(values[:, 1:4], where)
    _check_rate(values[:, 4:7], where)
    try:
        imu, repairs = clean(
            values[:, 0],
            values[:, 1:4],
            values[:, 4:7],
            values[:, 7:10] if values.shape[1] == 10 else None,
            source=where,
        )
    except InputError as error:
        raise InputError(
            _in_lines(error.what, numbers),
            where=error.where or where,
            remedy=error.remedy,
        ) from error
    notes = []
    for repair in repairs:
        note = _in_lines(repair.text, numbers)
        if note == repair.text and repair.count < len(values):
            line = numbers.line(repair.first_row)
            note = Message("{note} (first in line {line})", note=note, line=line)
        notes.append(note)
    return Recording(
        imu=imu,
        clock_map=ClockMap(confidence=0.0),
        camera=Message("CSV log"),
        notes=(*gap_notes(imu), *notes),
        provenance={"reader": Message("CSV log")},
    )


def _in_lines(message: Message, numbers: Numbers) -> Message:
    """Replace rows of the array by lines of the file."""
    if message.template == "row {number}":
        return Message("line {number}", number=numbers.line(message.values["number"]))
    values = {
        name: _in_lines(value, numbers) if isinstance(value, Message) else value
        for name, value in message.values.items()
    }
    return Message(message.template, **values)


READER = Reader(recognises, read)


def write_imu_csv(path: str | os.PathLike[str], imu: ImuLog) -> None:
    """Write a motion log that `read_recording` returns to 9 digits.

    Raises:
        InputError: when the file cannot be written.
    """
    parts = [imu.time_s[:, None], imu.specific_force_mps2, imu.angular_rate_radps]
    names: tuple[str, ...] = LOG_COLUMNS
    if imu.magnetic_field_ut is not None:
        parts.append(imu.magnetic_field_ut)
        names += FIELD_COLUMNS
    values = np.concatenate(parts, axis=1)
    formats = ["%.9f"] + ["%.9g"] * (values.shape[1] - 1)
    with file_replaced(Path(path)) as part:
        np.savetxt(
            part,
            values,
            fmt=formats,
            delimiter=",",
            header=",".join(names),
            comments="",
            encoding="utf-8",
        )


def read_force_csv(
    path: str | os.PathLike[str], until_s: float = math.inf
) -> ForceTrack:
    """Read a force track; each force holds until the time of the next.

    Args:
        path: of the file.
        until_s: later rows are checked, and only the last one is kept.

    Raises:
        InputError: with file, line, column and what to do.
    """
    source = open_file(path)
    rows = _ForceRows(str(source.path), until_s)
    values = _read_strict(
        source, FORCE_COLUMNS, ESTIMATED_COLUMNS, min_rows=1, select=rows.select
    ).values
    if rows.last is not None:
        values = np.concatenate([values, rows.last])
    is_estimated = bool(values[:, len(FORCE_COLUMNS) :].any())
    return ForceTrack(
        time_s=values[:, 0],
        force_n=values[:, 1:4].astype(np.float32),
        reconstruction=Reconstruction.HOLD,
        provenance={"source": source.path.name, "reader": "force csv"}
        | ({"feedback": "estimated"} if is_estimated else {}),
    )


class _ForceRows:
    """Checks the rows of a force track chunk by chunk, and selects those that are felt.

    Attributes:
        last: (1, columns) the last row if it is not selected.
    """

    def __init__(self, where: str, until_s: float) -> None:
        self._where, self._until_s = where, until_s
        self._last_s = -math.inf
        self.last: Floats | None = None

    def select(self, values: Floats, lines: Sequence[int]) -> Floats:
        """Return the rows before the end; of those in one slot of time the last one."""
        _check_finite(values, lines, self._where)
        self._check_order(values[:, 0], lines)
        largest_n = float(np.abs(values[:, 1:4]).max())
        if largest_n > MAX_FORCE_N:
            raise InputError(
                "holds a force of {largest_n:.3g} N, beyond any device",
                where=self._where,
                remedy="give the forces in newton",
                largest_n=largest_n,
            )
        is_first = self._last_s == -math.inf
        self._last_s = float(values[-1, 0])
        with np.errstate(over="ignore"):
            slots = np.floor(values[:, 0] / FORCE_STEP_S)
        kept = np.append(slots[1:] > slots[:-1], True) & (values[:, 0] < self._until_s)
        kept[0] |= is_first
        self.last = None if kept[-1] else values[-1:].copy()
        return values[kept]

    def _check_order(self, time_s: Floats, lines: Sequence[int]) -> None:
        before_s = np.concatenate([[self._last_s], time_s[:-1]])
        late = np.flatnonzero(time_s <= before_s)
        if not len(late):
            return
        row = int(late[0])
        is_repeated = time_s[row] == before_s[row]
        raise InputError(
            "the time {fault} ({time_s} s after {last_s} s)",
            where=at(self._where, lines[row], TIME),
            remedy="sort the log by time and remove duplicates",
            fault=Message("repeats") if is_repeated else Message("decreases"),
            time_s=time_s[row],
            last_s=before_s[row],
        )


def _read_strict(
    source: LogSource,
    required: tuple[str, ...],
    optional: tuple[str, ...] = (),
    *,
    min_rows: int = 2,
    select: Selection | None = None,
) -> Numbers:
    """Return a table with the required columns, and all or none of the optional ones."""
    name = source.names[0]
    names = column_names(source.first_line(name))
    if names not in {required, required + optional}:
        raise header_fault(source, required, optional)
    columns = tuple(range(len(names)))
    shape = Shape(len(names), columns, skip_lines=1, names=names, min_rows=min_rows)
    return read_table(source, name, shape, select)


def _check_finite(values: Floats, lines: Sequence[int], where: str) -> None:
    bad = np.argwhere(~np.isfinite(values))
    if not len(bad):
        return
    row, column = (int(at) for at in bad[0])
    value = float(values[row, column])
    raise InputError(
        "{text} is not a finite number",
        where=at(where, lines[row], (*FORCE_COLUMNS, *ESTIMATED_COLUMNS)[column]),
        remedy="remove the line or correct the number",
        text=value,
    )


def _check_rate(rate: Floats, where: str) -> None:
    largest = float(np.abs(rate).max(initial=0.0, where=np.isfinite(rate)))
    if largest <= MAX_SI_RATE_RADPS:
        return
    remedy = Message("it looks like deg/s: multiply gx, gy, gz by 0.0174532925")
    if np.degrees(MAX_ANGULAR_RATE_RADPS) < largest:
        remedy = Message("give the angular rate in rad/s")
    raise InputError(
        "the largest angular rate is {largest:.3g} rad/s",
        where=where,
        remedy=remedy,
        largest=largest,
    )


def _check_accel(accel: Floats, where: str) -> None:
    """Reject single outliers beyond any sensor."""
    rows = accel[np.isfinite(accel).all(axis=1)]
    with np.errstate(over="ignore"):
        size = np.linalg.norm(rows, axis=1)
    if not len(size) or size.max() <= MAX_ACCELERATION_MPS2:
        return
    if np.median(size) <= MAX_ACCELERATION_MPS2:
        raise InputError(
            "holds an acceleration of {largest:.3g} m/s2, beyond any sensor",
            where=where,
            remedy="give the specific force in m/s2, about 9.8 at rest",
            largest=np.abs(rows).max() if np.isinf(size).any() else size.max(),
        )
