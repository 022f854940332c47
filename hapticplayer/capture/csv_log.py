"""Motion logs and force tracks as plain CSV: SI units, frame A or frame D.

A log is `time_s,ax,ay,az,gx,gy,gz[,mx,my,mz]`: specific force in m/s2 (+9.8 up at
rest), angular rate in rad/s, magnetic field in uT, frame A (x right, y front, z up).
A force track is `time_s,fx_n,fy_n,fz_n` in frame D (x right, y up, z towards the
user); each force holds from its time until the next one's.
"""

import os
import secrets
from pathlib import Path

import numpy as np

from hapticplayer.capture.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_FORCE_N,
    MIN_RATE_HZ,
)
from hapticplayer.capture.table import TIME, Layout, Table, read_table
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
)
FORCE_LAYOUT = Layout(required=(TIME, "fx_n", "fy_n", "fz_n"))

PLAUSIBLE_NORM_MPS2 = (4.0, 25.0)
"""Median of the specific force: 1 g at rest, up to 2 g in a rough ride."""

LARGEST_RATE_RADPS = 40.0
"""Beyond 2300 deg/s: no hand turns so fast, so the unit is another."""


def read_imu_csv(path: str | os.PathLike[str]) -> ImuLog:
    """Read a motion log.

    Raises:
        InputError: naming file, line, column and what to do; also when the numbers
            are plainly in g or in degrees.
    """
    table = read_table(path, IMU_LAYOUT)
    force, rate = table.values[:, 1:4], table.values[:, 4:7]
    _check_force_unit(force, table)
    _check_rate_unit(rate, table)
    _check_time_unit(table)
    has_field = table.values.shape[1] == 10
    return ImuLog(
        time_s=table.values[:, 0],
        specific_force_mps2=force,
        angular_rate_radps=rate,
        magnetic_field_ut=table.values[:, 7:10] if has_field else None,
        sampling=Sampling.INSTANT,
        source=str(table.path),
    )


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
    steps = np.diff(table.values[:, 0])
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
    largest = float(np.abs(rate).max())
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
