"""Reads a recording's motion, whatever kind of file it is in."""

import os
from collections.abc import Mapping as Dict
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.csv_log import read_motion_log
from hapticplayer.capture.foreign import (
    refuse_dates,
    refuse_foreign,
    refuse_workbook,
)
from hapticplayer.capture.gopro import GoProTelemetry, read_gopro, read_raw_gopro
from hapticplayer.capture.gopro_packets import RAW_MAGIC
from hapticplayer.capture.table import TIME
from hapticplayer.errors import InputError, TelemetryError
from hapticplayer.media.files import resolve_regular
from hapticplayer.model import ClockMap, ImuLog, Sampling

if TYPE_CHECKING:
    from hapticplayer.capture.logs import LogChoices, Source
    from hapticplayer.capture.logs.assemble import LogReading

_GAP_STEPS = 3.0
"""A step of more than this many samples is a gap."""

_SHOWN_SAMPLES = 60_000
"""Of which a camera's norm at rest is shown: five minutes."""


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """The motion of a recording and how its clock lies to the video.

    Attributes:
        imu: samples on the sensor's own clock.
        clock_map: that clock to media time; confidence 0 where nobody said.
        camera: what recorded it.
        notes: what a person should know about the quality.
        provenance: how it was read.
        is_gravity_free: the recorder had removed gravity: `imu` holds p[k] itself,
            and no angular rate.
    """

    imu: ImuLog
    clock_map: ClockMap
    camera: str
    notes: tuple[str, ...] = ()
    provenance: Dict[str, Any] = field(default_factory=dict)
    is_gravity_free: bool = False


def read_recording(
    path: str | os.PathLike[str], choices: "LogChoices | None" = None
) -> Recording:
    """Return the motion in a file or folder, recognised by its content.

    Args:
        path: a GoPro video, a raw GPMF dump, a log of a logger or a phone (`logs`;
            a folder or a zip where it writes several files), or a CSV (`csv_log`).
        choices: what was decided about a log that does not explain itself.

    Raises:
        InputError: when it cannot be read or holds no motion; says what to do.
        UsageError: when a decision is needed; says how to give it.
    """
    recording = _read(path, choices)
    if choices is None or not choices.sampling:
        return recording
    sampled = replace(recording.imu, sampling=Sampling(choices.sampling))
    return replace(recording, imu=sampled)


def _read(path: str | os.PathLike[str], choices: "LogChoices | None") -> Recording:
    from hapticplayer.capture.logs.source import HEAD_BYTES, ZIP_MAGIC, is_text

    if Path(path).is_dir():
        return _from_logs(path, choices)
    file = resolve_regular(path, TelemetryError)
    with file.open("rb") as stream:
        head = stream.read(HEAD_BYTES)
    refuse_foreign(head, str(file))
    if head.startswith(RAW_MAGIC):
        return _from_gopro(read_raw_gopro(file), "raw GPMF")
    if head.startswith(ZIP_MAGIC):
        return _from_logs(file, choices)
    if not is_text(head):
        return _from_video(file, choices)
    text = head.decode("utf-8-sig", "replace").lstrip(' \t\r\n"')
    is_own = text.startswith(TIME) and not (choices and choices.columns)
    return _from_csv(file) if is_own else _from_logs(file, choices)


def _from_logs(path: str | os.PathLike[str], choices: "LogChoices | None") -> Recording:
    from hapticplayer.capture import logs

    source = logs.open_source(path)
    choices = choices or logs.LogChoices()
    form = logs.find_format(source, choices) if source.names else None
    if form is None:
        return _from_unknown(source)
    return _of_log(logs.read_log(source, form, choices))


def _of_log(log: "LogReading") -> Recording:
    return Recording(
        imu=log.imu,
        clock_map=log.clock_map,
        camera=log.name,
        notes=log.notes,
        provenance=log.provenance,
        is_gravity_free=log.is_gravity_free,
    )


def _from_unknown(source: "Source") -> Recording:
    """Read what is no known log as a CSV, which says what is wrong with it."""
    refuse_workbook(source.names, str(source.path))
    if source.is_one_file:
        refuse_dates(source.head(source.names[0]), str(source.path))
    if not source.is_one_file:
        raise InputError(
            "holds no log that is known",
            where=str(source.path),
            remedy="give the folder or the zip that the logger has written, or a "
            "sequence",
        )
    return _from_csv(source.path)


def _from_video(file: Path, choices: "LogChoices | None") -> Recording:
    from hapticplayer.capture import logs, other_cameras
    from hapticplayer.media import data_track_names, read_telemetry_packets

    packets = read_telemetry_packets(file)
    if packets:
        return _from_gopro(read_gopro(packets, str(file)), "GPMF track")
    reason = "holds no motion telemetry"
    if any("dji" in name.lower() for name in data_track_names(file)):
        reason = "holds no accelerometer samples (DJI stores orientations only)"
    elif other_cameras.is_available():
        return _of_log(
            other_cameras.read_other_camera(file, choices or logs.LogChoices())
        )
    raise TelemetryError(
        reason, where=str(file), remedy="give the log with --imu LOG --offset S"
    )


def _from_gopro(telemetry: GoProTelemetry, reader: str) -> Recording:
    return Recording(
        imu=telemetry.imu,
        clock_map=ClockMap(),
        camera=telemetry.camera,
        notes=(*_how_read(telemetry.imu), *telemetry.notes, *_gaps(telemetry.imu)),
        provenance={
            "reader": reader,
            "accelerometer_rate_hz": round(telemetry.accelerometer_rate_hz, 3),
            "gyro_rate_hz": round(telemetry.gyro_rate_hz, 3),
        },
    )


def _how_read(imu: ImuLog) -> tuple[str, ...]:
    """Return units and axes of a camera's motion, and what speaks for them."""
    from hapticplayer.capture.logs.assemble import REST_NORM_MPS2, norm_at_rest

    few, rate = slice(_SHOWN_SAMPLES), imu.angular_rate_radps
    norm = norm_at_rest(
        ImuLog(imu.time_s[few], imu.specific_force_mps2[few], rate[few])
    )
    largest_radps = max(float(rate.max()), -float(rate.min()))
    rest = "" if norm is None else f", {norm:.2f} m/s2 at rest"
    text = (
        "read as telemetry of the camera: specific force in m/s2, angular rate in rad/s, "
        f"x to its right, y to where it looks, z to its top{rest}, turning at "
        f"{largest_radps:.2f} rad/s at most"
    )
    low, high = REST_NORM_MPS2
    if norm is None or low <= norm <= high:
        return (text,)
    return (
        text,
        f"gravity is 9.81 m/s2 and not {norm:.2f}: the accelerometer is doubtful",
    )


def _from_csv(file: Path) -> Recording:
    log = read_motion_log(file)
    return Recording(
        imu=log.imu,
        clock_map=ClockMap(confidence=0.0),
        camera="CSV log",
        notes=_gaps(log.imu) + log.notes,
        provenance={"reader": "CSV log"},
    )


def refuse_gravity_free(recording: Recording) -> None:
    """Refuse motion whose gravity was removed by the recorder.

    Raises:
        InputError: naming what to record instead.
    """
    if recording.is_gravity_free:
        raise InputError(
            "holds acceleration from which the recorder has removed gravity, so it "
            "cannot be checked or levelled",
            where=recording.imu.source,
            remedy="export the acceleration with gravity, and the gyroscope",
        )


def find_gaps(imu: ImuLog) -> NDArray[np.intp]:
    """Return the samples (G,) that are followed by a gap."""
    steps_s = np.diff(imu.time_s)
    if not steps_s.size:
        return np.zeros(0, dtype=np.intp)
    return np.flatnonzero(steps_s > _GAP_STEPS * np.median(steps_s))


def _gaps(imu: ImuLog) -> tuple[str, ...]:
    steps_s, wide = np.diff(imu.time_s), find_gaps(imu)
    if not wide.size:
        return ()
    longest = int(wide[np.argmax(steps_s[wide])])
    count = "one gap" if wide.size == 1 else f"{wide.size} gaps"
    length_s, at_s = steps_s[longest], imu.time_s[longest]
    return (f"The log has {count}, the longest of {length_s:.2f} s at {at_s:.2f} s.",)
