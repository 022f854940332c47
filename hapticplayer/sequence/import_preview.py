"""Previews a recording before its import: format, axes, synchronisation, curves."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.frames import FrameRotation, frame_function
from hapticplayer.capture.log_checks import norm_at_rest
from hapticplayer.capture.log_tables import LogTable
from hapticplayer.capture.mounting import (
    WRONG_SIGN,
    fallen_text,
    gravity_agrees,
    is_down,
    is_fallen,
    mean_up,
)
from hapticplayer.capture.reading import find_format
from hapticplayer.capture.recording import Recording, find_gaps, refuse_gravity_free
from hapticplayer.capture.source import LogPath, name_of, open_source
from hapticplayer.capture.sync.methods import AUTO
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import (
    InputError,
    Message,
    Progress,
    UsageError,
    message_of,
    no_progress,
)
from hapticplayer.media.clip_info import ClipInfo, probe
from hapticplayer.media.pace import Pace, pace_of
from hapticplayer.model import ImuLog
from hapticplayer.sequence.mounting_by_frames import ask_about_sign
from hapticplayer.sequence.synchronizing import (
    SyncChoices,
    find_sync,
    notes_on_sync,
    watch,
)

Curve = tuple[NDArray[np.float64], NDArray[np.float64]]

_NOTHING: Curve = (np.zeros(0), np.zeros(0))

BY_HAND = "offset"
"""The method that leaves the offset to a person."""

MAX_POINTS = 2_000_000
"""Of the motion curve; more are reduced to the maximum of each block."""


@dataclass(frozen=True, slots=True, eq=False)
class ImportPreview:
    """What is found in a recording, and its proposed synchronisation.

    Attributes:
        clip: the video.
        recorder: that recorded the motion.
        samples: their number.
        rate_hz: median.
        duration_s: from the first sample to the last.
        begin_s: log time of the first sample.
        gaps: their number.
        notes: format, units, axes and warnings.
        provenance: the same in figures.
        up: mean up direction in the recorder's axes; None if it rotated too much.
        motion: log times and distance of each sample from rest, m/s2.
        sound: media times and loudness, each millisecond; empty without sound.
        turned: media times and turn rate of the camera as its frames show it, rad/s;
            empty where they were not followed.
        gyro: log times and turn rate of the gyro, rad/s; empty where `turned` is.
        found: the synchronisation; None if none was possible, or a person gives it.
        problem: why none was possible.
        pace: that the clip's metadata tell, where nobody has said how slow it plays.
        slowed: how many times as slow as it was recorded it plays, as a person said.
    """

    clip: ClipInfo
    recorder: str
    samples: int
    rate_hz: float
    duration_s: float
    begin_s: float
    gaps: int
    notes: tuple[str, ...]
    provenance: dict[str, Any]
    up: tuple[float, float, float] | None
    motion: Curve
    sound: Curve
    turned: Curve
    gyro: Curve
    found: Synchronisation | None
    problem: str = ""
    pace: Pace | None = None
    slowed: float | None = None

    @property
    def knows_clip_clock(self) -> bool:
        """Whether the recorder's own clock is the clip's."""
        return _is_own_clock(self.found)


def _is_own_clock(found: Synchronisation | None) -> bool:
    is_own = found is not None and found.method == "embedded"
    return is_own and found is not None and not found.contradiction


def preview_import(
    video: Path,
    log: LogPath | None,
    choices: LogChoices | None = None,
    method: str = AUTO,
    slowed: float | None = None,
    *,
    progress: Progress = no_progress,
) -> ImportPreview:
    """Read a clip and its motion, and propose a synchronisation.

    Args:
        video: the clip.
        log: a separate motion log, in one file or several; None for the clip's own telemetry.
        choices: answers about a log that does not describe itself.
        method: of synchronisation, see `capture.sync.methods`.
        slowed: how many times as slow as it was recorded the clip plays; None if not asked.
        progress: called with each step; raises Cancelled to stop.

    Raises:
        InputError: when a file cannot be read or holds no motion.
        LogQuestion: when a decision about the log is needed.
    """
    progress(0.0, video.name)
    clip = probe(video)
    progress(0.1, name_of(log or video))
    recording = read_recording(log or video, choices)
    refuse_gravity_free(recording)
    progress(0.5, Message("listening"))
    pace = pace_of(clip.path) if slowed is None else None
    if pace is not None or slowed not in {None, 1.0}:
        method = BY_HAND
    found, problem, sound, frames = _sync(
        clip, recording, method, lambda f, step: progress(0.5 + 0.5 * f, step)
    )
    if log is not None and not (choices and choices.accel_sign):
        _ask_about_sign(recording, found)
    imu = recording.imu
    turned, gyro = _turn_rates(imu, frames)
    progress(1.0, "")
    return ImportPreview(
        clip=clip,
        recorder=recording.camera,
        samples=len(imu),
        rate_hz=imu.rate_hz,
        duration_s=float(imu.time_s[-1] - imu.time_s[0]),
        begin_s=float(imu.time_s[0]),
        gaps=len(find_gaps(imu)),
        notes=notes_on_sync(recording, found) if found else recording.notes,
        provenance=dict(recording.provenance),
        up=mean_up(imu),
        motion=_motion(recording),
        sound=sound,
        turned=turned,
        gyro=gyro,
        found=found,
        problem=problem,
        pace=pace,
        slowed=slowed,
    )


@dataclass(frozen=True, slots=True)
class ReadingCheck:
    """What the answers about a log make of it.

    Attributes:
        rate_hz: median.
        duration_s: from the first sample to the last.
        at_rest_mps2: norm of the specific force while stationary; None if it never was.
        agrees: whether the gyroscope shows how gravity turned; None where it hardly did.
        notes: format, units, axes and warnings.
    """

    rate_hz: float
    duration_s: float
    at_rest_mps2: float | None
    agrees: bool | None
    notes: tuple[str, ...]


def check_reading(
    log: LogPath, choices: LogChoices, *, progress: Progress = no_progress
) -> ReadingCheck:
    """Read a log as it was answered; raises as `preview_import` does."""
    from hapticplayer.motion.repair.rotation import doubt_about, turns_gravity

    progress(0.0, name_of(log))
    recording = read_recording(log, choices)
    refuse_gravity_free(recording)
    imu = recording.imu
    return ReadingCheck(
        rate_hz=imu.rate_hz,
        duration_s=float(imu.time_s[-1] - imu.time_s[0]),
        at_rest_mps2=norm_at_rest(imu),
        agrees=doubt_about(imu) is None if turns_gravity(imu) else None,
        notes=recording.notes[:-1] if choices.given() else recording.notes,
    )  # the last one tells the answers again


def tables_of(log: LogPath, choices: LogChoices) -> tuple[LogTable, ...]:
    """The tables of a log whose columns a person has to name; () for any other log."""
    source = open_source(log)
    form = find_format(source, replace(choices))  # of which nothing is taken
    return form.reader().tables(source)


def _ask_about_sign(recording: Recording, found: Synchronisation | None) -> None:
    """Ask for the accelerometer's sign where only it, or a recorder upside down, fits."""
    shown, up = found.mounting if found else None, mean_up(recording.imu)
    ask_about_sign(recording, shown)
    is_shown = shown is not None and shown.is_clear and gravity_agrees(up, shown.axes)
    if up is None or is_shown or not is_fallen(recording.imu) or not is_down(up):
        return
    raise LogQuestion(
        fallen_text(up),
        (WRONG_SIGN, Message("accel-sign=+ if the recorder was that way up")),
        recording.imu.source,
    )


def _sync(
    clip: ClipInfo, recording: Recording, method: str, progress: Progress
) -> tuple[Synchronisation | None, str, Curve, FrameRotation | None]:
    """Return the synchronisation, or why there is none, loudness, and frames."""
    seen: list[FrameRotation] = []

    def look() -> FrameRotation:
        seen.append(watch(clip, progress))
        return seen[-1]

    found, problem = None, ""
    try:
        if method != BY_HAND:
            found = find_sync(clip, recording, SyncChoices(method), look=look)
    except LogQuestion:
        raise
    except (InputError, UsageError) as failure:
        problem = message_of(failure)
    is_heard = clip.has_audio and not _is_own_clock(found)
    sound = loudness_of(clip.path) if is_heard else _NOTHING
    return found, problem, sound, seen[-1] if seen else None


def _turn_rates(imu: ImuLog, frames: FrameRotation | None) -> tuple[Curve, Curve]:
    """Return the turn rates of the frames and of the gyro."""
    if frames is None or not len(frames) or not imu.angular_rate_radps.any():
        return _NOTHING, _NOTHING
    turned, gyro = frame_function("turn-rates")(imu, frames)
    return turned, gyro


def loudness_of(clip: Path) -> Curve:
    """Return times (N,) in s and the loudness (N,) of a clip; none where it is silent.

    Raises:
        MediaError: when the sound cannot be read.
    """
    from hapticplayer.capture.sync.events import loudness
    from hapticplayer.capture.sync.synchronize import read_sound

    heard = read_sound(clip)
    if not len(heard.samples):
        return _NOTHING
    level = loudness(heard.samples, heard.rate_hz)
    return np.arange(len(level)) / 1000.0, np.asarray(level, dtype=float)


def _motion(recording: Recording) -> Curve:
    """Return the distance of each sample from rest."""
    imu = recording.imu
    size = np.linalg.norm(imu.specific_force_mps2, axis=1)
    far = np.abs(size - np.median(size))
    few = -(-len(far) // MAX_POINTS)
    whole = len(far) // few * few
    return (
        np.ascontiguousarray(imu.time_s[:whole:few]),
        far[:whole].reshape(-1, few).max(axis=1),
    )
