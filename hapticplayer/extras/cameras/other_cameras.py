"""Cameras beyond GoPro, through the optional library `telemetry-parser`.

It runs in a child process with limits of memory and time, on a copy of the video in a
separate folder, because it reads side-car files next to a video. Its known errors
(version 0.3.0) are avoided: GoPro videos are not given to it; samples without acceleration
(DJI, and floats that it drops) are rejected; it pairs sensors by index, so that missing
samples mean wrong times. It declares no frame, so a person gives the axes.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.capture.assemble import log_reader
from hapticplayer.capture.choices import OPTION, LogChoices, LogQuestion
from hapticplayer.capture.formats import Confidence
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import InputError, Message, TelemetryError
from hapticplayer.extras.cameras.makers import (
    has_library,
    how_to_read,
    maker_of,
    marked_size,
)
from hapticplayer.extras.cameras.telemetry_child import COLUMNS
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    MAX_ANSWER_BYTES,
    MAX_VIDEO_BYTES,
    MEMORY_BYTES,
    TIME_LIMIT_S,
)
from hapticplayer.untrusted import open_regular

_COMMAND = (sys.executable, "-P", "-m", "hapticplayer.extras.cameras.telemetry_child")
_MIN_SHARE = 0.98
"""Of the samples that must have acceleration and rate."""
_LOG = Message("give its log, too (--imu LOG), and {option} if asked", option=OPTION)
_BY_OTHERS = Message(
    "give the log, too (--imu LOG), or have the motion estimated from the frames "
    "(--suggest-motion)"
)


def recognises(source: LogSource) -> Confidence:
    """Any video; GoPro has a higher confidence."""
    return Confidence.POSSIBLE if source.is_binary else Confidence.NO


def read(source: LogSource, choices: LogChoices) -> RawLog:
    """Return the motion in a video.

    Raises:
        TelemetryError: when it holds none, or telemetry-parser is not installed.
    """
    maker = maker_of(source.path)
    if maker is None and not has_library():
        raise _refusal(source.path, Message("contains no motion data"), _BY_OTHERS)
    if maker is not None and (maker.why_not or not has_library()):
        mark = Message("holds telemetry of {maker}", maker=maker.name)
        if maker.why_not:
            what = Message("{what}, {why}", what=mark, why=maker.why_not)
            raise _refusal(source.path, what, _BY_OTHERS)
        remedy = Message("{how}; or {others}", how=how_to_read(), others=_BY_OTHERS)
        raise _refusal(source.path, mark, remedy)
    return read_other_camera(source.path, choices)


READER = log_reader(recognises, read)


def read_other_camera(
    video: Path,
    choices: LogChoices,
    *,
    command: Sequence[str] = _COMMAND,
    time_limit_s: float = TIME_LIMIT_S,
) -> RawLog:
    """Return the motion in a video of a camera that telemetry-parser supports.

    Args:
        video: not of a GoPro.
        choices: `axes` must be given.
        command: of the child.
        time_limit_s: for the child, without copying.
    """
    with tempfile.TemporaryDirectory(prefix="hapticplayer-") as folder:
        name, arrays = _read_copy(video, Path(folder), command, time_limit_s)
    time_s, accel, rate = (arrays[column] for column in COLUMNS)
    if not choices.axes:
        raise LogQuestion(
            Message(
                "is of a {name}, whose telemetry does not declare its axes", name=name
            ),
            (Message("axes=RIGHT,FRONT,UP in its axes, such as axes=x,-z,y"),),
            str(video),
        )
    return RawLog(
        name=name,
        accel=SensorStream(time_s, accel),
        rate=SensorStream(time_s, rate),
        rate_unit="deg/s",
        axes_words=Message("as telemetry-parser gives them"),
        notes=(
            Message(
                "read by telemetry-parser; its timestamps are those of a mean rate"
            ),
        ),
    )


def _read_copy(
    video: Path, folder: Path, command: Sequence[str], time_limit_s: float
) -> tuple[str, dict[str, Floats]]:
    if video.stat().st_size > MAX_VIDEO_BYTES:
        raise _refusal(
            video, Message("is larger than {most_gb} GB", most_gb=MAX_VIDEO_BYTES >> 30)
        )
    copy, answer = folder / f"video{video.suffix}", folder / "answer.npz"
    try:
        with open_regular(video) as reader, copy.open("xb") as writer:
            shutil.copyfileobj(reader, writer)
            if (size_bytes := marked_size(video)) is not None:
                writer.truncate(size_bytes)
        done = subprocess.run(
            [
                *command,
                str(copy),
                str(answer),
                str(MEMORY_BYTES),
                f"{time_limit_s:.0f}",
            ],
            capture_output=True,
            timeout=time_limit_s,
            check=False,
        )
    except OSError as error:
        raise _refusal(
            video, Message("cannot be copied ({reason})", reason=error)
        ) from error
    except subprocess.TimeoutExpired as error:
        raise _refusal(
            video,
            Message(
                "took telemetry-parser {time_limit_s:g} s", time_limit_s=time_limit_s
            ),
        ) from error
    if done.returncode:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines()
        why = (
            lines[-1][:200]
            if lines
            else Message("it died, status {status}", status=done.returncode)
        )
        raise _refusal(
            video,
            Message("cannot be read by telemetry-parser ({reason})", reason=why),
        )
    try:
        about: Any = json.loads(done.stdout)
        name = f"{about['camera']} {about['model']}".strip()[:60]
        return name, _checked(answer, name)
    except (InputError, ValueError, KeyError, TypeError, MemoryError) as error:
        raise _refusal(
            video,
            Message(
                "made telemetry-parser return invalid data ({reason})", reason=error
            ),
        ) from error


def _checked(answer: Path, name: str) -> dict[str, Floats]:
    """Return the arrays of an answer.

    Raises:
        ValueError: with the reason, when they are not those of a log.
    """
    if name.startswith("GoPro"):  # it pairs their sensors wrongly
        raise ValueError(
            Message("a GoPro's telemetry is read without it, and is damaged")
        )
    with open_regular(answer) as reader:
        if os.fstat(reader.fileno()).st_size > MAX_ANSWER_BYTES:
            raise ValueError(Message("it is too large"))
        with np.load(reader, allow_pickle=False) as archive:
            arrays = {name: np.asarray(archive[name], np.float64) for name in COLUMNS}
    time_s, accel, rate = (arrays[name] for name in COLUMNS)
    if time_s.ndim != 1 or accel.shape != (len(time_s), 3) or rate.shape != accel.shape:
        raise ValueError(Message("its arrays do not belong together"))
    if not len(time_s) or not np.isfinite(accel).any():
        raise ValueError(Message("it holds no accelerations"))
    whole = np.isfinite(accel).all(axis=1) & np.isfinite(rate).all(axis=1)
    if whole.mean() < _MIN_SHARE:
        raise ValueError(
            Message("only {share:.0%} of its samples are whole", share=whole.mean())
        )
    return arrays


def _refusal(video: Path, what: str, remedy: str = _LOG) -> TelemetryError:
    return TelemetryError(what, where=str(video), remedy=remedy)
