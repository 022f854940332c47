"""Motion logs as plain CSV: SI units, frame A.

A log is `time_s,ax,ay,az,gx,gy,gz[,mx,my,mz]`, in any order and among others: specific
force in m/s2 (+9.8 up at rest), angular rate in rad/s, magnetic field in uT, frame A (x
right, y front, z up).

Loggers leave cells empty, repeat rows and swap them: this is repaired if possible, with a
note (`motion.repair`).
"""

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from hapticplayer.capture.agreement import ask_if_swapped, sensors_as_answered
from hapticplayer.capture.assemble import as_answered, ask_about_units
from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    FIELD_UNITS,
    RATE_UNITS,
    LogChoices,
    factor,
)
from hapticplayer.capture.csv_table import (
    FIELD_COLUMNS,
    LOG_COLUMNS,
    TIME,
    Numbers,
    Shape,
    head_lines,
    header_fault,
    read_table,
)
from hapticplayer.capture.formats import Confidence, Reader
from hapticplayer.capture.log_checks import check_norm, norm_at_rest
from hapticplayer.capture.recording import Recording, gap_notes
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import AlignedSamples, RawLog, on_common_times, split
from hapticplayer.capture.stuck import working
from hapticplayer.errors import InputError, Message
from hapticplayer.model import (
    ClockMap,
    ImuLog,
)
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_SI_RATE_RADPS,
)
from hapticplayer.model.spellings import column_names, find_separator
from hapticplayer.storage import file_replaced

RECORDING, SCHEMA = "recording.json", "hapticplayer.recording"
"""Describes a folder that was recorded here, see `recorded`; that of a simulated ride has
the same name."""

ARRIVAL = "arrival_s"
"""A column of recorders here: when the machine received the row."""

_UNITS: dict[str, tuple[str, Mapping[str, float]]] = {
    "accel_unit": ("accel", ACCEL_UNITS),
    "rate_unit": ("rate", RATE_UNITS),
    "field_unit": ("field", FIELD_UNITS),
}
"""Answers, and the samples and units that they are of."""


def recognises(source: LogSource) -> Confidence:
    """The name of the time column comes first; a folder holds one such file."""
    is_one = len(_logs(source)) == 1 and not is_recorded(source)
    return Confidence.CERTAIN if is_one else Confidence.NO


def is_recorded(source: LogSource) -> bool:
    """Whether it is a folder that was recorded here."""
    return RECORDING in source.names and f'"{SCHEMA}"' in source.head(RECORDING)


def _logs(source: LogSource) -> list[str]:
    """Return the members that begin with the name of the time column."""
    return [
        name
        for name in source.names
        if source.head(name).lstrip(' \t\r\n"').startswith(TIME)
    ]


def read(source: LogSource, choices: LogChoices) -> Recording:
    """Return the log.

    Empty cells, NaN and infinity are filled and marked; swapped and repeated rows are
    put in order; gaps remain.
    """
    source = source if source.is_one_file else source.alone(_logs(source)[0])
    numbers, others = _read_named(source)
    where, values = str(source.path), numbers.values
    from hapticplayer.motion.repair import repair_samples  # brings scipy along

    sensors = split(values, values[:, 0], range(1, len(values[0]), 3))
    raw = sensors_as_answered(RawLog("", *sensors), choices)
    accel, rate, field = raw.accel, raw.rate, raw.field
    assert rate is not None
    units = {
        unit: given
        for stream, unit in zip((accel, rate, field), _UNITS, strict=True)
        if stream is not None and (given := choices.take(unit))
    }
    raw = replace(raw, **units)
    ask_if_swapped(raw, choices, where)
    streams = working(accel, rate, field, where)
    stored = on_common_times(streams.accel, streams.rate, streams.field, where)
    samples = _in_si(stored, units)

    def line_of(row: int) -> int:
        return numbers.line(int(streams.rows[min(row, len(streams.rows) - 1)]))

    try:
        _check_accel(samples.accel, where)
        _check_rate(samples.rate, where)
        imu, repairs = repair_samples(*samples[:4], source=where)
    except InputError as error:
        ask_about_units(error, stored, raw, choices, where)
        raise InputError(
            _in_lines(error.what, line_of),
            where=error.where or where,
            remedy=error.remedy,
        ) from error
    notes = []
    for repair in repairs:
        note = _in_lines(repair.text, line_of)
        if note == repair.text and repair.count < len(values):
            first = line_of(repair.first_row)
            note = Message("{note} (first in line {line})", note=note, line=first)
        notes.append(note)
    recording = Recording(
        imu=imu,
        clock_map=ClockMap(confidence=0.0),
        camera=Message("CSV log"),
        notes=(
            *others,
            *gap_notes(imu),
            *streams.repeats.notes,
            *samples.notes,
            *notes,
        ),
        provenance={"reader": Message("CSV log"), **streams.repeats.provenance},
    )
    check_norm({"norm_at_rest_mps2": norm_at_rest(imu)}, raw, choices, where)
    return as_answered(recording, choices)


def _in_si(samples: AlignedSamples, given: Mapping[str, str]) -> AlignedSamples:
    scaled = {}
    for answer, unit in given.items():
        name, known = _UNITS[answer]
        to_si = factor(unit, known, answer.replace("_", "-"))
        scaled[name] = getattr(samples, name) * to_si
    return samples._replace(**scaled)


def _in_lines(message: Message, line_of: Callable[[int], int]) -> Message:
    """Replace rows of the array by lines of the file."""
    if message.template == "row {number}":
        return Message("line {number}", number=line_of(message.values["number"]))
    values = {
        name: _in_lines(value, line_of) if isinstance(value, Message) else value
        for name, value in message.values.items()
    }
    return Message(message.template, **values)


READER = Reader(recognises, read)


def write_imu_csv(path: str | os.PathLike[str], imu: ImuLog) -> None:
    """Write a motion log that `read_recording` returns to 9 digits."""
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


def _read_named(source: LogSource) -> tuple[Numbers, tuple[str, ...]]:
    """Return the columns of the log by their names, and notes on others."""
    name = source.names[0]
    lines = head_lines(source, name)
    at = next((number for number, line in enumerate(lines) if line.strip()), None)
    if at is None:
        raise header_fault(source)
    separator = find_separator(lines[at])
    names = column_names(lines[at], separator)
    wanted: tuple[str, ...] = LOG_COLUMNS
    if set(FIELD_COLUMNS) <= set(names):
        wanted += FIELD_COLUMNS
    if any(names.count(one) != 1 for one in wanted):
        raise header_fault(source)
    decimal = "," if separator != "," and "," in "".join(lines[at:]) else "."
    columns = tuple(names.index(one) for one in wanted)
    shape = Shape(
        len(names), columns, separator, decimal, skip_lines=at + 1, names=names
    )
    others = [one for one in names if one and one not in (*wanted, ARRIVAL)]
    note = Message("not read: the columns {names}", names=", ".join(others)[:120])
    return read_table(source, name, shape), (note,) if others else ()


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
