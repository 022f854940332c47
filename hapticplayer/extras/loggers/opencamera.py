"""OpenCamera Sensors: a headerless CSV for each sensor, x, y, z and ns.

`<video>_accel.csv`, `_gyro.csv`, `_magnetic.csv`; `_timestamps.csv` has the time of
each frame on the same clock. Names differ between versions, so the numbers have to confirm
the sensor that a name suggests.

Source: MobileRoboticsSkoltech/OpenCamera-Sensors, README; telemetry-parser.
"""

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.csv_table import Shape, first_numbers
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, Sensor, read_sensor
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.extras.loggers.nanoseconds import frames_of
from hapticplayer.model.limits import COARSE_REST_MPS2

_SHAPE = Shape(4, (3, 0, 1, 2), integer=3)
_ROLES = ("accel", "gyro", "magnetic")
_MIN_STAMP_NS = 1e8
_RATE_NORM = 6.0


def recognises(source: LogSource) -> Confidence:
    """Four numbers a row, the last one rising nanoseconds."""
    found = [name for name in source.names if _is_sensor(source, name)]
    if not found:
        return Confidence.NO
    named = [name for name in found if _named(source, name)]
    return Confidence.LIKELY if named else Confidence.POSSIBLE


def read(source: LogSource, _choices: LogChoices) -> RawLog:
    """Return the log."""
    where = str(source.path)
    roles: dict[str, str] = {}
    for name in source.names:
        if not _is_sensor(source, name):
            continue
        role = _named(source, name)
        if role in roles:
            raise LogQuestion(
                Message(
                    "holds several recordings ({first}, {second})",
                    first=roles[role],
                    second=name,
                ),
                (Message("give the folder of one of them instead"),),
                where,
            )
        if role:
            roles[role] = name
    missing = [role for role in ("accel", "gyro") if role not in roles]
    if missing:
        raise InputError(
            "holds no {missing} file",
            where=where,
            remedy="give the folder with the files of all sensors",
            missing=joined(Message(" and no "), missing),
        )
    sensors = {role: read_sensor(source, name, _SHAPE) for role, name in roles.items()}
    _check_roles(sensors, where)
    accel, rate = sensors["accel"], sensors["gyro"]
    field = sensors.get("magnetic")
    origin = accel.origin_ns
    return RawLog(
        name="OpenCamera Sensors",
        accel=accel.stream,
        rate=rate.since(origin),
        field=None if field is None else field.since(origin),
        axes_words=Message("the phone's axes: x right, y top, z out of the screen"),
        back_axis="z",
        frames_s=_frames_s(source, accel),
        notes=tuple(note for sensor in sensors.values() for note in sensor.notes),
    )


def _is_sensor(source: LogSource, name: str) -> bool:
    rows = first_numbers(source, name)
    if len(rows) < 3 or {len(row) for row in rows} != {4}:
        return False
    times = np.array([row[3] for row in rows])
    steps = np.diff(times)
    return bool(
        times[0] > _MIN_STAMP_NS and (steps >= 0).all() and np.median(steps) > 1e5
    )


def _named(source: LogSource, name: str) -> str:
    base = source.base(name)
    return next((role for role in _ROLES if role in base), "")


def _check_roles(sensors: dict[str, Sensor], where: str) -> None:
    """Check the names against gravity."""
    norms = {
        role: float(np.nanmedian(np.linalg.norm(sensor.stream.values, axis=1)))
        for role, sensor in sensors.items()
    }
    low, high = COARSE_REST_MPS2
    is_swapped = low < norms["gyro"] < high and norms["accel"] < _RATE_NORM
    if is_swapped:
        raise InputError(
            "its gyro file has the norm {norm:.3g} of gravity, its accel file has "
            "not: the names are swapped",
            where=where,
            remedy="restore the original file names",
            norm=norms["gyro"],
        )


def _frames_s(source: LogSource, accel: Sensor) -> tuple[float, float] | None:
    bases = {name: source.base(name) for name in source.names}
    lists = [
        n for n, b in bases.items() if b.endswith("timestamps.csv") and "imu" not in b
    ]
    return frames_of(source, lists, accel.origin_ns, float(accel.stream.time_s[-1]))


READER = log_reader(recognises, read)
