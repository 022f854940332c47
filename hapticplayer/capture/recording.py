"""Reads a recording's motion, whatever kind of file it is in."""

import os
from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.csv_log import read_motion_log
from hapticplayer.capture.gopro import GoProTelemetry, read_gopro, read_raw_gopro
from hapticplayer.capture.gopro_packets import RAW_MAGIC
from hapticplayer.errors import TelemetryError
from hapticplayer.media.files import resolve_regular
from hapticplayer.model import ClockMap, ImuLog

_SNIFFED_BYTES = 4096
_GAP_STEPS = 3.0
"""A step of more than this many samples is a gap."""


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """The motion of a recording and how its clock lies to the video.

    Attributes:
        imu: samples on the sensor's own clock.
        clock_map: that clock to media time; confidence 0 where nobody said.
        camera: what recorded it.
        notes: what a person should know about the quality.
        provenance: how it was read.
    """

    imu: ImuLog
    clock_map: ClockMap
    camera: str
    notes: tuple[str, ...] = ()
    provenance: Dict[str, Any] = field(default_factory=dict)


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """Return the motion in a file, recognised by its content.

    Args:
        path: a GoPro video, a raw GPMF dump, or a CSV log (`csv_log`).

    Raises:
        InputError: when the file cannot be read or holds no motion; says what to do.
    """
    file = resolve_regular(path, TelemetryError)
    with file.open("rb") as stream:
        head = stream.read(_SNIFFED_BYTES)
    if head.startswith(RAW_MAGIC):
        return _from_gopro(read_raw_gopro(file), "raw GPMF")
    if _is_text(head):
        return _from_log(file)
    return _from_video(file)


def _is_text(head: bytes) -> bool:
    try:
        text = head.decode("utf-8")
    except UnicodeDecodeError as error:
        # a character may be cut at the end of the sample
        if error.start < len(head) - 3:
            return False
        text = head[: error.start].decode("utf-8")
    return "\0" not in text


def _from_video(file: Path) -> Recording:
    from hapticplayer.media import data_track_names, read_telemetry_packets

    packets = read_telemetry_packets(file)
    if packets:
        return _from_gopro(read_gopro(packets, str(file)), "GPMF track")
    reason = "holds no motion telemetry"
    if any("dji" in name.lower() for name in data_track_names(file)):
        reason = "holds no accelerometer samples (DJI stores orientations only)"
    raise TelemetryError(
        reason, where=str(file), remedy="give the log with --imu LOG --offset S"
    )


def _from_gopro(telemetry: GoProTelemetry, reader: str) -> Recording:
    return Recording(
        imu=telemetry.imu,
        clock_map=ClockMap(),
        camera=telemetry.camera,
        notes=telemetry.notes + _gaps(telemetry.imu),
        provenance={
            "reader": reader,
            "accelerometer_rate_hz": round(telemetry.accelerometer_rate_hz, 3),
            "gyro_rate_hz": round(telemetry.gyro_rate_hz, 3),
        },
    )


def _from_log(file: Path) -> Recording:
    log = read_motion_log(file)
    return Recording(
        imu=log.imu,
        clock_map=ClockMap(confidence=0.0),
        camera="CSV log",
        notes=_gaps(log.imu) + log.notes,
        provenance={"reader": "CSV log"},
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
