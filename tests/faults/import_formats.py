"""Writes the motion of `import_signal` in every format, from their documentation.

Each writer returns the files of a recording by name; what is one file only has one.
"""

import heapq
import io
import math
import operator
import re
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.faults.import_signal import GRAVITY_MPS2, Floats, Sampled
from tests.unit.capture.conftest import device, sensor

EPOCH_NS = 1_700_000_000_123_456_789
Files = dict[str, bytes]


@dataclass(frozen=True)
class Written:
    """A format under test.

    Attributes:
        key: for people.
        write: the files of a recording.
        apart: whether its sensors have times of their own.
        choices: what has to be decided, as typed.
        tolerance_mps2: of the force, from the digits that are written.
        tolerance_radps: of the rate at the same times.
        has_field: whether it stores the magnetic field.
        is_timed: whether it stores times.
    """

    key: str
    write: Callable[[Sampled], Files]
    apart: bool = False
    choices: tuple[str, ...] = ()
    tolerance_mps2: float = 1e-4
    tolerance_radps: float = 1e-4
    has_field: bool = True
    is_timed: bool = True


def put(files: Files, folder: Path, *, as_zip: bool = False) -> Path:
    """Write the files; return the file, folder or zip to be read."""
    folder.mkdir(parents=True, exist_ok=True)
    if as_zip:
        path = folder / "recording.zip"
        path.write_bytes(zipped(files))
        return path
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return folder / next(iter(files)) if len(files) == 1 else folder


def zipped(files: Files) -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return held.getvalue()


def _rows(
    columns: list[Floats | list[str]], formats: list[str], separator: str, end: str
) -> str:
    """Return lines; NaN is an empty cell."""
    lines = []
    for row in zip(*columns, strict=True):
        cells = [
            cell if isinstance(cell, str)
            else "" if math.isnan(cell) else one % cell
            for one, cell in zip(formats, row, strict=True)
        ]  # fmt: skip
        lines.append(separator.join(cells))
    return "".join(line + end for line in lines)


def _stamps_ns(t: Floats) -> list[str]:
    return [str(EPOCH_NS + round(1e9 * one)) for one in t]


def ultimate_imu(s: Sampled) -> Files:
    columns = [*np.degrees(s.rate).T, *(s.force / GRAVITY_MPS2).T, *(s.field / 100.0).T]
    ms = [f"{round(1e3 * t):06d}" for t in s.force_s]
    text = _rows([ms, *columns], [""] + ["%.2f"] * 9, ",", "\n\r")
    return {"Sensor1.csv": text.encode()}


def razor_m0(s: Sampled) -> Files:
    columns = [*(s.force / GRAVITY_MPS2).T, *np.degrees(s.rate).T, *s.field.T]
    ms = [f"{round(1e3 * t) + 5321}" for t in s.force_s]
    return {
        "LOG001.TXT": _rows([ms, *columns], [""] + ["%.2f"] * 9, ", ", "\r\n").encode()
    }


def razor_ahrs(s: Sampled) -> Files:
    """Board axes x forward, y right, z down; the acceleration is negated."""
    to_board = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
    force = -(s.force @ to_board.T) / GRAVITY_MPS2 * 256.0
    rate = np.degrees(s.rate @ to_board.T) * 14.375
    field = s.field @ to_board.T
    lines = []
    for a, m, g in zip(force, field, rate, strict=True):
        for letter, v in (("A", a), ("M", m), ("G", g)):
            lines.append(f"#{letter}-C=" + ",".join(f"{x:.2f}" for x in v) + "\r\n")
    return {"serial.log": "".join(lines).encode()}


def razor_dollar(s: Sampled) -> Files:
    force, rate = s.force / GRAVITY_MPS2 * 256.0, np.degrees(s.rate) * 14.375
    rows = np.concatenate([force, rate, s.field], axis=1)
    rows = np.rint(np.nan_to_num(rows)).astype(int)
    return {
        "razor.txt": "".join(
            "$" + ",".join(map(str, r)) + "#\r\n" for r in rows
        ).encode()
    }


def _sensor_logger(name: str, t: Floats, xyz: Floats) -> Files:
    columns = [_stamps_ns(t), t, xyz[:, 2], xyz[:, 1], xyz[:, 0]]
    text = "time,seconds_elapsed,z,y,x\n"
    return {
        f"{name}.csv": (
            text + _rows(columns, ["", "%.6f", *["%.7f"] * 3], ",", "\n")
        ).encode()
    }


def _metadata(system: str) -> bytes:
    keys = "version,device name,recording time,platform,appVersion,standardisation"
    return f"{keys}\n3,phone,2026-01-01_10-00-00,{system},1.40.1,false\n".encode()


def sensor_logger_android(s: Sampled) -> Files:
    gravity = np.array([0.0, 0.0, GRAVITY_MPS2])
    return {
        **_sensor_logger("Accelerometer", s.force_s, s.force - gravity),
        **_sensor_logger("TotalAcceleration", s.force_s, s.force),
        **_sensor_logger("Gyroscope", s.rate_s, s.rate),
        **_sensor_logger("Magnetometer", s.field_s, s.field),
        "Metadata.csv": _metadata("android"),
    }


def sensor_logger_ios(s: Sampled) -> Files:
    gravity = np.tile([0.3, -0.2, 9.7], (len(s.force_s), 1))
    return {
        **_sensor_logger("Accelerometer", s.force_s, -(s.force - gravity)),
        **_sensor_logger("Gravity", s.force_s, -gravity),
        **_sensor_logger("Gyroscope", s.rate_s, s.rate),
        "Metadata.csv": _metadata("ios"),
    }


def ios_standard(s: Sampled) -> Files:
    """iOS with "Standardise Units & Frames": the signs of Android."""
    gravity = np.tile([0.3, -0.2, 9.7], (len(s.force_s), 1))
    return {
        **_sensor_logger("Accelerometer", s.force_s, s.force - gravity),
        **_sensor_logger("Gravity", s.force_s, gravity),
        **_sensor_logger("Gyroscope", s.rate_s, s.rate),
        "Metadata.csv": _metadata("ios").replace(b"false", b"true"),
    }


def _phyphox(header: str, unit: str, t: Floats, xyz: Floats, separator: str) -> bytes:
    names = ["Time (s)", *(f"{header} {axis} ({unit})" for axis in "xyz")]
    text = separator.join(f'"{name}"' for name in names) + "\n"
    text += _rows([t, *xyz.T], ["%.9E"] * 4, separator, "\n")
    return text.encode()


def phyphox(separator: str, decimal: str = ".") -> Callable[[Sampled], Files]:
    def write(s: Sampled) -> Files:
        files = {
            "Accelerometer.csv": _phyphox("Acceleration", "m/s^2", s.force_s, s.force, separator),
            "Gyroscope.csv": _phyphox("Gyroscope", "rad/s", s.rate_s, s.rate, separator),
            "Magnetometer.csv": _phyphox("Magnetic field", "µT", s.field_s, s.field, separator),
            "meta/time.csv": b'"event","experiment time","system time"\n"START",0.0E0,1.679E9\n',
        }  # fmt: skip
        if decimal == ",":
            head = {n: c.partition(b"\n") for n, c in files.items()}
            files = {n: a + b + c.replace(b".", b",") for n, (a, b, c) in head.items()}
        return files

    return write


def phyphox_plain(s: Sampled) -> Files:
    """An experiment of a user's own: the names of the files tell the sensors apart."""
    files = phyphox(",")(s)
    free = s.force - np.array([0.0, 0.0, GRAVITY_MPS2])
    files["Linear Acceleration.csv"] = _phyphox("", "m/s^2", s.force_s, free, ",")
    named = re.compile(rb'"(?:Acceleration|Gyroscope|Magnetic field|) ([xyz]) \(')
    return {
        name: named.sub(lambda found: b'"' + found[1].upper() + b" (", content)
        for name, content in files.items()
    }


def phyphox_linear(s: Sampled) -> Files:
    free = s.force - np.array([0.0, 0.0, GRAVITY_MPS2])
    return {
        "Raw Data.csv": _phyphox("Linear Acceleration", "m/s^2", s.force_s, free, ",")
    }


def gcsv(s: Sampled) -> Files:
    head = (
        "GYROFLOW IMU LOG\nversion,1.3\nid,custom_logger\norientation,XYZ\n"
        "tscale,0.001\ngscale,0.00106\nascale,0.00012\nmscale,0.0005\n"
        "t,gx,gy,gz,ax,ay,az,mx,my,mz\n"
    )
    columns = [*(s.rate / 0.00106).T, *(s.force / GRAVITY_MPS2 / 0.00012).T,
               *(s.field / 100.0 / 0.0005).T]  # fmt: skip
    text = head + _rows([1e3 * s.force_s, *columns], ["%.3f"] + ["%.0f"] * 9, ",", "\n")
    return {"clip.gcsv": text.encode()}


def euroc(s: Sampled) -> Files:
    head = (
        "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
        "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n"
    )
    columns = [_stamps_ns(s.force_s), *s.rate.T, *s.force.T]
    text = head + _rows(columns, [""] + ["%.9f"] * 6, ",", "\n")
    pictures = "#timestamp [ns],filename\n" + "".join(
        f"{EPOCH_NS + 500_000_000 + k * 50_000_000},{k}.png\n" for k in range(20)
    )
    return {
        "mav0/imu0/data.csv": text.encode(),
        "mav0/cam0/data.csv": pictures.encode(),
    }


def mars(s: Sampled) -> Files:
    head = (
        "Timestamp[nanosec], gx[rad/s], gy[rad/s], gz[rad/s],"
        " ax[m/s^2], ay[m/s^2], az[m/s^2]\n"
    )
    columns = [_stamps_ns(s.force_s), *s.rate.T, *s.force.T]
    text = head + _rows(columns, [""] + ["%.7f"] * 6, ", ", "\n")
    frames = "".join(f"{EPOCH_NS + 750_000_000 + k * 33_333_333}\n" for k in range(90))
    return {"gyro_accel.csv": text.encode(), "frame_timestamps.txt": frames.encode()}


def opencamera(s: Sampled) -> Files:
    def one(t: Floats, xyz: Floats) -> bytes:
        return _rows([*xyz.T, _stamps_ns(t)], ["%.7f"] * 3 + [""], ",", "\n").encode()

    stamps = "".join(f"{EPOCH_NS + 250_000_000 + k * 33_333_333}\n" for k in range(90))
    return {
        "VID_1accel.csv": one(s.force_s, s.force),
        "VID_1gyro.csv": one(s.rate_s, s.rate),
        "VID_1magnetic.csv": one(s.field_s, s.field),
        "VID_1_timestamps.csv": stamps.encode(),
    }


def generic(s: Sampled) -> Files:
    head = "my logger;v2\ncounter;t_us;Ax;Ay;Az;Gx;Gy;Gz\n"
    columns = [np.arange(float(len(s.force_s))), 1e6 * s.force_s,
               *(s.force / GRAVITY_MPS2).T, *np.degrees(s.rate).T]  # fmt: skip
    text = _rows(columns, ["%.0f", "%.0f"] + ["%.6f"] * 6, ";", "\r\n").replace(
        ".", ","
    )
    return {"mine.txt": (head + text).encode()}


GENERIC = ("columns=-,time,ax,ay,az,gx,gy,gz", "time-unit=us", "accel-unit=g",
           "rate-unit=deg/s")  # fmt: skip


def androsensor(s: Sampled) -> Files:
    sensors = [
        *(f"ACCELEROMETER {axis} (m/s²)" for axis in "XYZ"),
        *(f"LINEAR ACCELERATION {axis} (m/s²)" for axis in "XYZ"),
        *(f"GYROSCOPE {axis} (rad/s)" for axis in "XYZ"),
        "LIGHT (lux)",
        *(f"MAGNETIC FIELD {axis} (μT)" for axis in "XYZ"),
    ]
    head = ";".join([*sensors, "Time since start in ms ", "YYYY-MO-DD HH-MI-SS_SSS"])
    free = s.force - np.array([0.0, 0.0, GRAVITY_MPS2])
    count = len(s.force_s)
    columns = [*s.force.T, *free.T, *s.rate.T, np.full(count, 12.0), *s.field.T,
               1e3 * s.force_s, ["2018-04-04 21:39:36:123"] * count]  # fmt: skip
    formats = ["%.6f"] * 13 + ["%.0f", ""]
    return {
        "Sensor_record.csv": (head + "\n" + _rows(columns, formats, ";", "\n")).encode()
    }


_RACECHRONO = (
    "This file is created using RaceChrono v9.1.3 ( http://racechrono.com/ ).\n"
    'Format,{format}\nSession title,"Ride, with a comma"\nSession type,Lap timing\n'
    "Track name,\nDriver name,\nCreated,21/02/2026,22:12\nNote,\n\n"
)


def _interleaved(s: Sampled) -> str:
    """Rows of speed, accelerometer and gyro, with empty cells between."""
    accel, rate = s.force / GRAVITY_MPS2, np.degrees(s.rate)
    rows = heapq.merge(
        ((t, "3.9,,,,,,") for t in s.force_s[50::100]),
        ((t, f",{x:.6f},{y:.6f},{z:.6f},,,")
         for t, (x, y, z) in zip(s.force_s, accel, strict=True)),
        ((t, f",,,,{x:.6f},{y:.6f},{z:.6f}")
         for t, (x, y, z) in zip(s.rate_s, rate, strict=True)),
        key=operator.itemgetter(0),
    )  # fmt: skip
    begin_s = 1_767_150_797.44
    lines = (f"{begin_s + t:.4f},0,,{cells}\n" for t, cells in rows)
    return "".join(lines).replace("nan", "")


def racechrono(s: Sampled) -> Files:
    head = (
        "timestamp,fragment_id,lap_number,speed,x_acc,y_acc,z_acc,"
        "x_rate_of_rotation,y_rate_of_rotation,z_rate_of_rotation\n"
        "unix time,,,m/s,G,G,G,deg/s,deg/s,deg/s\n"
        ",,,100: gps,101: acc,101: acc,101: acc,102: gyro,102: gyro,102: gyro\n"
    )
    return {
        "session.csv": (_RACECHRONO.format(format=3) + head + _interleaved(s)).encode()
    }


def racechrono_2(s: Sampled) -> Files:
    head = "Time (s),Session fragment #,Lap #,Speed (m/s) *calc," + ",".join(
        [f"{axis} acceleration (G) *acc" for axis in "XYZ"]
        + [f"{axis} rate of rotation (deg/s) *gyro" for axis in "XYZ"]
    )
    return {
        "session.csv": (
            _RACECHRONO.format(format=2) + head + "\n" + _interleaved(s)
        ).encode()
    }


def xsens_dot(s: Sampled) -> Files:
    """The counter of microseconds has 32 bits and starts again after 0.97 s."""
    head = (
        "sep=,\nDeviceTag:,D1\nFirmwareVersion:,3.0.0\nOutputRate:,60Hz\n"
        "Measurement Mode:,Sensor fusion Mode - Custom Mode 5\n"
        "© Movella Technologies B. V. 2005-2025\n\n"
        "PacketCounter,SampleTimeFine,Euler_X,Euler_Y,Euler_Z,"
        "Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z,Status\n"
    )
    count = len(s.force_s)
    zero = np.zeros(count)
    columns = [np.arange(float(count)), (4_294_000_000 + 1e6 * s.force_s) % 2.0**32,
               zero, zero, zero, *s.force.T, *np.degrees(s.rate).T, zero]  # fmt: skip
    formats = ["%.0f", "%.0f"] + ["%.6f"] * 9 + ["%.0f"]
    return {"D1_20250711.csv": (head + _rows(columns, formats, ",", "\n")).encode()}


def xsens_mt(s: Sampled) -> Files:
    """The counter of rows has 16 bits and starts again after 5.36 s."""
    head = (
        "// Start Time: Unknown\n// Update Rate: 100.0Hz\n"
        "// Filter Profile: human (46.1)\n// Firmware Version: 4.6.0\n"
        "PacketCounter\tSampleTimeFine\tAcc_X\tAcc_Y\tAcc_Z\tGyr_X\tGyr_Y\tGyr_Z\n"
    )
    columns = [np.rint(65_000 + 100.0 * s.force_s) % 65_536, np.full(len(s.force_s), np.nan),
               *s.force.T, *s.rate.T]  # fmt: skip
    text = _rows(columns, ["%05.0f", ""] + ["%.6f"] * 6, "\t", "\r\n")
    return {"MT_00B4D7D3.txt": (head + text).encode()}


def own_csv(s: Sampled) -> Files:
    head = "time_s,ax,ay,az,gx,gy,gz,mx,my,mz\n"
    columns = [s.force_s, *s.force.T, *s.rate.T, *s.field.T]
    return {
        "log.csv": (head + _rows(columns, ["%.9f"] + ["%.7f"] * 9, ",", "\n")).encode()
    }


def gopro_raw(s: Sampled) -> Files:
    """HERO9: stored Z,X,Y of camera axes X left, Y back, Z up; stamps in us."""
    return {"telemetry.gpmf": b"".join(payload for _, payload in gopro_payloads(s))}


def gopro_payloads(s: Sampled) -> list[tuple[float, bytes]]:
    def stored(values: Floats) -> Floats:
        x, y, z = values.T
        return np.stack([z, -x, -y], axis=1)

    payloads, totals = [], [0, 0]
    # a clock that was set back never runs on in a payload
    order = [np.maximum.accumulate(t) for t in (s.force_s, s.rate_s)]
    last_s = float(np.nanmax(s.force_s)) if len(s.force_s) else 0.0
    for second in range(int(last_s) + 1):
        streams = []
        for at, (key, t, values) in enumerate(
            (("ACCL", s.force_s, s.force), ("GYRO", s.rate_s, s.rate))
        ):
            here = np.arange(*np.searchsorted(order[at], [second, second + 1]))
            if len(here):
                totals[at] += len(here)
                stamp = round(1e6 * (float(t[here][0]) + 1.0))
                streams.append(
                    sensor(key, stored(values[here]), total=totals[at], stamp_us=stamp)
                )
        shutter = sensor("SHUT", [[1.0]] * 30, stamp_us=1_000_000 * (second + 1))
        payloads.append((float(second), device("HERO9 Black", *streams, shutter)))
    return payloads


FORMATS = {
    one.key: one
    for one in (
        Written("own CSV", own_csv),
        Written("GoPro, raw", gopro_raw, apart=True, has_field=False),
        Written("Ultimate IMU", ultimate_imu, tolerance_mps2=0.06, tolerance_radps=2e-4),
        Written("Razor M0", razor_m0, tolerance_mps2=0.06, tolerance_radps=2e-4),
        Written("Razor-AHRS", razor_ahrs, choices=("rate-hz=100",), tolerance_mps2=5e-4,
                has_field=False, is_timed=False),
        Written("Razor $", razor_dollar, choices=("rate-hz=100",), tolerance_mps2=0.03,
                tolerance_radps=1e-3, has_field=False, is_timed=False),
        Written("Sensor Logger Android", sensor_logger_android, apart=True),
        Written("Sensor Logger iOS", sensor_logger_ios, apart=True, has_field=False),
        Written("phyphox comma", phyphox(","), apart=True),
        Written("phyphox semicolon", phyphox(";", ","), apart=True),
        Written("phyphox tab", phyphox("\t"), apart=True),
        Written("gcsv", gcsv, tolerance_mps2=1e-3, tolerance_radps=6e-4),
        Written("EuRoC", euroc, has_field=False),
        Written("MARS", mars, has_field=False),
        Written("OpenCamera Sensors", opencamera, apart=True),
        Written("phyphox X Y Z", phyphox_plain, apart=True),
        Written("AndroSensor", androsensor),
        Written("RaceChrono", racechrono, apart=True, has_field=False),
        Written("RaceChrono 2", racechrono_2, apart=True, has_field=False),
        Written("Xsens DOT", xsens_dot, has_field=False),
        Written("Xsens MTw", xsens_mt, has_field=False),
        Written("generic CSV", generic, choices=GENERIC, has_field=False),
    )
}  # fmt: skip
"""phyphox's linear acceleration is apart: it has no gravity to compare."""
