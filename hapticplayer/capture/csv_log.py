"""Motion logs and force tracks as plain CSV: SI units, frame A or frame D.

A log is `time_s,ax,ay,az,gx,gy,gz[,mx,my,mz]`: specific force in m/s2 (+9.8 up at
rest), angular rate in rad/s, magnetic field in uT, frame A (x right, y front, z up).
A force track is `time_s,fx_n,fy_n,fz_n` in frame D (x right, y up, z towards the
user); each force holds from its time until the next one's.

Loggers leave cells empty, repeat rows and swap them: what can be repaired in a log
without guessing is, and is said (`motion.repair_samples`).
"""

import os
import re
import secrets
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hapticplayer.capture.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_FORCE_N,
    MIN_RATE_HZ,
)
from hapticplayer.capture.table import TIME, Layout, Table, find_lines, read_table
from hapticplayer.errors import InputError
from hapticplayer.model import (
    STANDARD_GRAVITY_MPS2,
    ForceTrack,
    ImuLog,
    Reconstruction,
    Sampling,
)
from hapticplayer.model.arrays import Floats

IMU_LAYOUT = Layout(
    required=(TIME, "ax", "ay", "az", "gx", "gy", "gz"),
    optional=("mx", "my", "mz"),
    least_rows=2,
    has_holes=True,
)
FORCE_LAYOUT = Layout(required=(TIME, "fx_n", "fy_n", "fz_n"))

PLAUSIBLE_NORM_MPS2 = (4.0, 25.0)
"""Median of the specific force: 1 g at rest, up to 2 g in a rough ride."""

LARGEST_RATE_RADPS = 40.0
"""Beyond 2300 deg/s: no hand turns so fast, so the unit is another."""


_ROW = re.compile(r"\b(row|rows from) (\d+)\b")


@dataclass(frozen=True, slots=True, eq=False)
class MotionLog:
    """What a motion log holds.

    Attributes:
        imu: the samples; not valid where they had to be filled in.
        notes: what was repaired, in words, with the first line of each kind.
    """

    imu: ImuLog
    notes: tuple[str, ...]


def read_imu_csv(path: str | os.PathLike[str]) -> ImuLog:
    """Read the samples of a motion log; see `read_motion_log`."""
    return read_motion_log(path).imu


def read_motion_log(path: str | os.PathLike[str]) -> MotionLog:
    """Read a motion log and repair what can be repaired without guessing.

    Empty cells, NaN and infinity are filled in and marked; swapped and repeated rows
    are put in order; gaps stay gaps.

    Raises:
        InputError: naming file, line, column and what to do; also when the numbers
            are plainly in g or in degrees, and for what cannot be repaired.
    """
    table = read_table(path, IMU_LAYOUT)
    force, rate = table.values[:, 1:4], table.values[:, 4:7]
    _check_force_unit(force, table)
    _check_rate_unit(rate, table)
    _check_time_unit(table)
    return _constant(table) if _is_constant(table) else _repaired(table)


def _repaired(table: Table) -> MotionLog:
    from hapticplayer.motion import repair_samples  # brings scipy along

    values, count = table.values, len(table.values)
    try:
        done = repair_samples(
            values[:, 0],
            values[:, 1:4],
            values[:, 4:7],
            values[:, 7:10] if values.shape[1] == 10 else None,
            sampling=Sampling.INSTANT,
            source=str(table.path),
        )
    except InputError as error:
        rows = [int(match[2]) for match in _ROW.finditer(error.what)]
        what = _ROW.sub(_naming_lines(find_lines(table.path, rows)), error.what)
        where = error.where or str(table.path)
        raise InputError(what, where=where, remedy=error.remedy) from error
    lines = find_lines(table.path, (repair.first_row for repair in done.repairs))
    notes = []
    for repair in done.repairs:
        note = _ROW.sub(_naming_lines(lines), repair.text)
        if note == repair.text and repair.count < count:
            note += f" (first in line {lines[repair.first_row]})"
        notes.append(note)
    return MotionLog(done.imu, tuple(notes))


def _naming_lines(lines: dict[int, int]) -> Callable[[re.Match[str]], str]:
    """Return what replaces the row of an array by the line of its file."""

    def named(match: re.Match[str]) -> str:
        return f"{match[1].replace('row', 'line')} {lines[int(match[2])]}"

    return named


def _is_constant(table: Table) -> bool:
    values = table.values
    return bool(
        np.isfinite(values).all()
        and (np.diff(values[:, 0]) > 0.0).all()
        and (values[:, 1:] == values[0, 1:]).all()
    )


def _constant(table: Table) -> MotionLog:
    """Return a log without any noise: made by a program, or by a stuck sensor."""
    values = table.values
    imu = ImuLog(
        time_s=values[:, 0],
        specific_force_mps2=values[:, 1:4],
        angular_rate_radps=values[:, 4:7],
        magnetic_field_ut=values[:, 7:10] if values.shape[1] == 10 else None,
        sampling=Sampling.INSTANT,
        source=str(table.path),
    )
    return MotionLog(imu, ("all samples are the same: was the sensor stuck?",))


def write_imu_csv(path: str | os.PathLike[str], imu: ImuLog) -> None:
    """Write a motion log so that `read_imu_csv` gives it back to 9 digits.

    Raises:
        InputError: when the file cannot be written.
    """
    parts = [imu.time_s[:, None], imu.specific_force_mps2, imu.angular_rate_radps]
    names = IMU_LAYOUT.required
    if imu.magnetic_field_ut is not None:
        parts.append(imu.magnetic_field_ut)
        names += IMU_LAYOUT.optional
    values = np.concatenate(parts, axis=1)
    formats = ["%.9f"] + ["%.9g"] * (values.shape[1] - 1)
    target = Path(path)
    part = target.with_name(f".{target.name}.{secrets.token_hex(4)}.part")
    try:
        np.savetxt(
            part,
            values,
            fmt=formats,
            delimiter=",",
            header=",".join(names),
            comments="",
            encoding="utf-8",
        )
        part.replace(target)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise InputError(
            f"cannot be written ({error.strerror})",
            where=str(target),
            remedy="choose another folder",
        ) from error


def read_force_csv(path: str | os.PathLike[str]) -> ForceTrack:
    """Read a force track; each force holds until the next one's time.

    Raises:
        InputError: naming file, line, column and what to do.
    """
    table = read_table(path, FORCE_LAYOUT)
    forces = table.values[:, 1:4]
    largest_n = float(np.abs(forces).max())
    if largest_n > MAX_FORCE_N:
        raise InputError(
            f"holds a force of {largest_n:.3g} N, beyond any device",
            where=str(table.path),
            remedy="give the forces in newton",
        )
    return ForceTrack(
        time_s=table.values[:, 0],
        force_n=forces.astype(np.float32),
        reconstruction=Reconstruction.HOLD,
        provenance={"source": table.path.name, "reader": "force csv"},
    )


def _check_force_unit(force: Floats, table: Table) -> None:
    force = force[np.isfinite(force).all(axis=1)]
    if not len(force):
        return
    norm = float(np.median(np.linalg.norm(force, axis=1)))
    low, high = PLAUSIBLE_NORM_MPS2
    largest = float(np.abs(force).max())
    if low <= norm <= high and largest <= MAX_ACCELERATION_MPS2:
        return
    what = f"the median of |(ax, ay, az)| is {norm:.3g} m/s2"
    if low <= norm <= high:
        what = f"holds an acceleration of {largest:.3g} m/s2, beyond any sensor"
    raise InputError(what, where=str(table.path), remedy=_unit_remedy(norm))


def _unit_remedy(norm: float) -> str:
    low, high = PLAUSIBLE_NORM_MPS2
    gravity = STANDARD_GRAVITY_MPS2
    if low / gravity <= norm <= high / gravity:
        return "it looks like g: multiply ax, ay, az by 9.80665"
    if low <= norm * gravity / 1000.0 <= high:
        return "it looks like milli-g: multiply ax, ay, az by 0.00980665"
    if norm < low / gravity:
        return (
            "gravity seems to be removed already: export the acceleration with gravity"
        )
    return "give the specific force in m/s2, about 9.8 at rest"


def _check_time_unit(table: Table) -> None:
    time_s = table.values[:, 0]
    steps = np.diff(time_s[np.isfinite(time_s)])
    steps = steps[steps > 0.0]  # repeated and missing times are repaired later
    rate_hz = 1.0 / float(np.median(steps)) if len(steps) else MIN_RATE_HZ
    if rate_hz >= MIN_RATE_HZ:
        return
    is_milliseconds = 1000.0 * rate_hz >= MIN_RATE_HZ
    raise InputError(
        f"time_s runs at {rate_hz:.3g} samples a second",
        where=str(table.path),
        remedy="it looks like milliseconds: divide time_s by 1000"
        if is_milliseconds
        else f"give at least {MIN_RATE_HZ:g} samples a second",
    )


def _check_rate_unit(rate: Floats, table: Table) -> None:
    largest = float(np.abs(rate).max(initial=0.0, where=np.isfinite(rate)))
    if largest <= LARGEST_RATE_RADPS:
        return
    remedy = "it looks like deg/s: multiply gx, gy, gz by 0.0174532925"
    if np.degrees(MAX_ANGULAR_RATE_RADPS) < largest:
        remedy = "give the angular rate in rad/s"
    raise InputError(
        f"the largest angular rate is {largest:.3g} rad/s",
        where=str(table.path),
        remedy=remedy,
    )
