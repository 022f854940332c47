"""The older Razor 9DOF: what its firmwares write line by line.

Razor-AHRS: a line for each sensor, `#A-C=x,y,z`, `#M-C=`, `#G-C=` (calibrated) or
`#A-R=` ... (raw); three lines are one frame of 20 ms, without a time. Its axes are x
forward, y right, z down; the acceleration is the negated specific force, 256 counts
a g, and the gyro has 14.375 counts per deg/s. `#YPR=` is angles only.

Stock: `!ANG:roll,pitch,yaw`, some with `,ACC:x,y,z`; or `$...#` with nine counts
(acceleration, gyro, field).

Source: Razor-AHRS 1.4.2 by Peter Bartz (Output.ino, Razor_AHRS.ino); capture notes.
"""

import re
from typing import BinaryIO

import numpy as np

from hapticplayer.capture.limits import MAX_CSV_ROWS, MAX_LINE_BYTES
from hapticplayer.capture.logs.choices import LogChoices, question
from hapticplayer.capture.logs.numbers import MAX_DAMAGED
from hapticplayer.capture.logs.raw import Confidence, Format, RawLog, Stream
from hapticplayer.capture.logs.source import Source
from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

FRAME_S = 0.02
COUNTS_PER_G = 256.0
COUNTS_PER_DPS = 14.375

_SENSOR_LINE = re.compile(r"#([AMG])-([RC])=(.*)")
_ANGLES = re.compile(r"^(#YPR=|!ANG:)")
_DOLLAR = re.compile(r"^\$(-?\d+(?:,-?\d+){8})#?$")
_SENT = "AMG"


def recognises(source: Source) -> Confidence:
    """The marks at the beginning of nearly every line."""
    if len(source.names) != 1:
        return Confidence.NO
    lines = [line.strip() for line in source.head(source.names[0]).splitlines()][1:-1]
    lines = [line for line in lines if line]
    marked = [
        line
        for line in lines
        if _SENSOR_LINE.match(line) or _ANGLES.match(line) or _DOLLAR.match(line)
    ]
    if len(lines) > 2 and len(marked) > 0.8 * len(lines):
        return Confidence.CERTAIN
    return Confidence.NO


def read(source: Source, choices: LogChoices) -> RawLog:
    """Return the log.

    Raises:
        InputError: when it holds angles only.
        UsageError: when the rate has to be told.
    """
    name = source.names[0]
    where = source.where(name)
    lines = source.head(name).splitlines()
    with source.opened(name) as stream:
        if any(_SENSOR_LINE.match(line.strip()) for line in lines):
            rows, notes = _sensor_frames(stream, where)
            return _ahrs(rows, choices, notes)
        if any(_DOLLAR.match(line.strip()) for line in lines):
            return _dollar(stream, choices, where)
    raise InputError(
        "holds angles without angular rates, from which motion cannot be had",
        where=where,
        remedy="switch the board to its sensor output (#osct with Razor-AHRS)",
    )


def _lines(stream: BinaryIO) -> "list[str]":
    """Return short lines; the rest of one that never ends is passed over."""
    found = []
    rest = b""
    while content := stream.read(1 << 20):
        *whole, rest = (rest + content).split(b"\n")
        found += [line[:MAX_LINE_BYTES].decode("ascii", "replace") for line in whole]
        rest = rest[:MAX_LINE_BYTES]
        if len(found) > 4 * MAX_CSV_ROWS // 10:
            break
    return [*found, rest.decode("ascii", "replace")]


def _sensor_frames(stream: BinaryIO, where: str) -> tuple[Floats, tuple[str, ...]]:
    """Return rows of A, M, G; a frame that lacks a line has NaN there."""
    frames: list[list[float]] = []
    seen = _SENT  # nothing is open
    damaged = total = 0
    for line in _lines(stream):
        if not line.strip():
            continue
        total += 1
        match = _SENSOR_LINE.match(line.strip())
        values = _three(match[3]) if match else None
        if match is None or values is None:
            damaged += 1
            continue
        at = _SENT.index(match[1])
        if match[1] in seen or not frames:
            frames.append([np.nan] * 9)
            seen = ""
        seen += match[1]
        frames[-1][3 * at : 3 * at + 3] = values
    if len(frames) < 2 or damaged > MAX_DAMAGED * total:
        raise InputError(
            f"has {len(frames)} frames and {damaged} damaged lines",
            where=where,
            remedy="record again or choose another log",
        )
    notes = (f"{damaged} lines are damaged and left out",) if damaged else ()
    return np.array(frames), notes


def _three(text: str) -> list[float] | None:
    cells = text.split(",")
    try:
        values = [float(cell) for cell in cells if "_" not in cell]
    except ValueError:
        return None
    return values if len(values) == len(cells) == 3 else None


def _ahrs(rows: Floats, choices: LogChoices, notes: tuple[str, ...]) -> RawLog:
    rate_hz = choices.sample_rate_hz or 1.0 / FRAME_S
    if choices.sample_rate_hz is None:
        notes += ("the log has no times: 50 frames a second are assumed",)
    time_s = np.arange(len(rows)) / rate_hz
    return RawLog(
        name="Razor-AHRS",
        force=Stream(time_s, -rows[:, 0:3]),
        rate=Stream(time_s, rows[:, 6:9]),
        force_unit=f"{STANDARD_GRAVITY_MPS2 / COUNTS_PER_G:.10g}",
        rate_unit=f"{np.radians(1.0 / COUNTS_PER_DPS):.10g}",
        axes="y,x,-z",
        axes_words="the firmware's axes: x forward, y right, z down",
        notes=notes,
    )


def _dollar(stream: BinaryIO, choices: LogChoices, where: str) -> RawLog:
    if choices.sample_rate_hz is None:
        raise question(
            "has no times, and its firmware has no fixed rate", ("rate-hz=50",), where
        )
    found = [(line, _DOLLAR.match(line.strip())) for line in _lines(stream)]
    rows = [
        [float(cell) for cell in match[1].split(",")] for _, match in found if match
    ]
    damaged = sum(not match and bool(line.strip()) for line, match in found)
    if len(rows) < 2 or damaged > MAX_DAMAGED * len(rows):
        raise InputError(
            f"has {len(rows)} rows and {damaged} damaged lines",
            where=where,
            remedy="record again or choose another log",
        )
    values = np.array(rows)
    time_s = np.arange(len(values)) / choices.sample_rate_hz
    return RawLog(
        name="Razor, raw output",
        force=Stream(time_s, values[:, 0:3]),
        rate=Stream(time_s, values[:, 3:6]),
        force_unit=f"{STANDARD_GRAVITY_MPS2 / COUNTS_PER_G:.10g}",
        rate_unit=f"{np.radians(1.0 / COUNTS_PER_DPS):.10g}",
        axes_words="the board's axes",
        notes=(f"{damaged} lines are damaged and left out",) if damaged else (),
    )


FORMAT = Format("razor", "Razor 9DOF", recognises, read)
