"""A take as it is shown back: sound, motion without gravity and taps on one time line."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hapticplayer.capture import read_recording, synchronize
from hapticplayer.capture.recorded import CLIP, Take, finished
from hapticplayer.capture.recording import refuse_gravity_free
from hapticplayer.capture.sync.synchronize import read_sound
from hapticplayer.errors import (
    InputError,
    Message,
    Progress,
    UsageError,
    message_of,
    no_progress,
)
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.sequence.import_preview import Curve, loudness_of
from hapticplayer.sequence.processing import Processing, process_motion

_NOTHING: Curve = (np.zeros(0), np.zeros(0))


@dataclass(frozen=True, slots=True, eq=False)
class TakeOverview:
    """What a take holds, in media time.

    Attributes:
        take: its description.
        duration_s: of all.
        sound: loudness each millisecond; empty without sound.
        motion: acceleration without gravity, or None.
        taps_s: where three taps are heard and felt; () for none.
        taps_late_s: by how much the taps place the samples later than their clock does.
        problem: why there is no motion of the samples; "" for none.
    """

    take: Take
    duration_s: float
    sound: Curve = _NOTHING
    motion: MotionTrack | None = None
    taps_s: tuple[float, ...] = ()
    taps_late_s: float = 0.0
    problem: str = ""


def overview_of(folder: Path, *, progress: Progress = no_progress) -> TakeOverview:
    """Look at a take that has been stopped.

    Raises:
        InputError: when nothing of it can be read.
    """
    progress(0.0, Message("reading"))
    take = finished(folder)
    clip = folder / CLIP if take.camera else None
    info = probe(clip) if clip else None
    has_sound = info is not None and info.has_audio
    sound = loudness_of(clip) if clip and has_sound else _NOTHING
    duration_s = info.duration_s if info else 0.0
    problem, motion = "", None
    taps: tuple[tuple[float, ...], float] = (), 0.0
    if take.imu:
        progress(0.3, Message("removing gravity"))
        try:
            recording = read_recording(folder)
            refuse_gravity_free(recording)
            motion = process_motion(recording.imu, Processing()).track
        except (InputError, UsageError) as failure:
            problem = message_of(failure)
        else:
            duration_s = max(duration_s, float(motion.time_s[-1]))
            progress(0.8, Message("listening"))
            taps = _taps(recording.imu, clip) if clip and len(sound[0]) else taps
    return TakeOverview(take, duration_s, sound, motion, *taps, problem)


def _taps(imu: ImuLog, clip: Path) -> tuple[tuple[float, ...], float]:
    """Times of taps in both streams, and by how much they move the samples."""
    heard = read_sound(clip)
    found = synchronize(imu, heard.samples, heard.rate_hz)
    if not (found.is_confident and found.pats):
        return (), 0.0
    clock = found.clock_map
    late_s = (clock.rate - 1.0) * found.pats[0].felt_s + clock.offset_s
    return tuple(pat.heard_s for pat in found.pats), late_s
