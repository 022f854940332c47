"""What a person should see of a recording before it becomes a sequence."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.mounting import mean_up
from hapticplayer.capture.recording import Recording, find_gaps, refuse_gravity_free
from hapticplayer.capture.sync.methods import AUTO
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import InputError, UsageError, message_of
from hapticplayer.media import ClipInfo, camera_of, probe
from hapticplayer.sequence import files
from hapticplayer.sequence.synchronizing import SyncChoices, find_sync

Curve = tuple[NDArray[np.float64], NDArray[np.float64]]

MOST_POINTS = 2_000_000
"""Of the curve of the motion; more are thinned out, each point the largest of its few."""


@dataclass(frozen=True, slots=True, eq=False)
class Recognised:
    """A recording as it was recognised, and how its clock seems to lie.

    Attributes:
        clip: the video.
        clip_camera: what the clip says of its camera, or "".
        recorder: what recorded the motion.
        samples: how many there are.
        rate_hz: median.
        duration_s: from the first sample to the last.
        begin_s: log time of the first sample.
        gaps: how many.
        notes: how it was read, units and axes, and what is doubtful.
        provenance: the same in figures.
        up: where up was on average in the recorder's axes; None where it turned.
        motion: log times and how far each sample is from rest, m/s2.
        sound: media times and loudness, each millisecond; empty without sound.
        found: how the clocks lie; None where there was nothing to go by.
        problem: why there was nothing.
    """

    clip: ClipInfo
    clip_camera: str
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
    found: Synchronisation | None
    problem: str = ""

    @property
    def knows_clip_clock(self) -> bool:
        """Whether the recorder's own clock is the clip's: nobody needs to look."""
        return self.found is not None and self.found.method == "embedded"


def recognise(
    video: Path,
    log: Path | None,
    choices: LogChoices | None = None,
    method: str = AUTO,
    *,
    progress: files.Progress = files.no_progress,
) -> Recognised:
    """Read a clip and its motion, and look how their clocks lie.

    Args:
        video: the clip.
        log: a separate log of the motion; None for the clip's own telemetry.
        choices: what was decided about a log that does not explain itself.
        method: of synchronisation, see `capture.sync.methods`.
        progress: told what is being done; stops the work by raising Cancelled.

    Raises:
        InputError: when one cannot be read or holds no motion.
        LogQuestion: when a decision about the log is needed.
    """
    progress(0.0, video.name)
    clip = probe(video)
    progress(0.1, (log or video).name)
    recording = read_recording(log or video, choices)
    refuse_gravity_free(recording)
    progress(0.5, "listening")
    found, problem, sound = _sync(clip, recording, method)
    imu = recording.imu
    progress(1.0, "")
    return Recognised(
        clip=clip,
        clip_camera=camera_of(video),
        recorder=recording.camera,
        samples=len(imu),
        rate_hz=imu.rate_hz,
        duration_s=float(imu.time_s[-1] - imu.time_s[0]),
        begin_s=float(imu.time_s[0]),
        gaps=len(find_gaps(imu)),
        notes=recording.notes,
        provenance=dict(recording.provenance),
        up=mean_up(imu),
        motion=_motion(recording),
        sound=sound,
        found=found,
        problem=problem,
    )


def _sync(
    clip: ClipInfo, recording: Recording, method: str
) -> tuple[Synchronisation | None, str, Curve]:
    """Return how the clocks lie or why nobody knows, and the loudness."""
    nothing = (np.zeros(0), np.zeros(0))
    try:
        found = find_sync(clip, recording, SyncChoices(method))
    except (InputError, UsageError) as problem:
        return (
            None,
            message_of(problem),
            nothing if not clip.has_audio else _loudness(clip),
        )
    sound = nothing if found.method == "embedded" else _loudness(clip)
    return found, "", sound


def _loudness(clip: ClipInfo) -> Curve:
    from hapticplayer.capture.sync.events import loudness
    from hapticplayer.capture.sync.synchronize import read_sound

    heard = read_sound(clip.path)
    level = loudness(heard.samples, heard.rate_hz)
    return np.arange(len(level)) / 1000.0, np.asarray(level, dtype=float)


def _motion(recording: Recording) -> Curve:
    """Return how far each sample is from rest."""
    imu = recording.imu
    size = np.linalg.norm(imu.specific_force_mps2, axis=1)
    far = np.abs(size - np.median(size))
    few = -(-len(far) // MOST_POINTS)
    whole = len(far) // few * few
    return (
        np.ascontiguousarray(imu.time_s[:whole:few]),
        far[:whole].reshape(-1, few).max(axis=1),
    )


def is_clip(path: Path) -> bool:
    """Whether a file is a video, by its content."""
    try:
        probe(path)
    except InputError:
        return False
    return True


def pair(paths: list[Path]) -> tuple[Path | None, Path | None]:
    """Return the video and the log among what was dropped, each None where missing.

    Raises:
        InputError: when there are two of a kind, or more files than two.
    """
    clips = [path for path in paths if path.is_file() and is_clip(path)]
    logs = [path for path in paths if path not in clips]
    if len(clips) > 1 or len(logs) > 1:
        names = ", ".join(path.name for path in (clips if len(clips) > 1 else logs))
        raise InputError(
            "these are two of a kind: {names}",
            remedy="drop one video and at most one log; import further ones after it",
            names=names,
        )
    return (clips[0] if clips else None), (logs[0] if logs else None)
