"""The import pipeline: from a recording to a sequence."""

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.frames import frame_function
from hapticplayer.capture.mounting import (
    BY_FRAMES,
    ask_for_mounting,
    is_fallen,
    mounted,
    refuse_upside_down,
)
from hapticplayer.capture.recording import Recording, find_gaps, refuse_gravity_free
from hapticplayer.capture.source import LogPath, name_of
from hapticplayer.errors import (
    InputError,
    MediaError,
    Message,
    Progress,
    UsageError,
    no_progress,
)
from hapticplayer.media.clip_info import ClipInfo, probe
from hapticplayer.model import (
    ImuLog,
    MotionTrack,
)
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.sequence.mounting_by_frames import (
    SHOWN,
    ask_for_shown_mounting,
    mounting_by_frames,
    sign_by_frames,
)
from hapticplayer.sequence.processing import Processed, Processing, process_motion
from hapticplayer.sequence.report import (
    notes_on_motion,
    notes_on_sequence,
)
from hapticplayer.sequence.surroundings import surroundings
from hapticplayer.sequence.synchronizing import SyncChoices, ask_for_pace, synchronized
from hapticplayer.sequence.writing import Content, RenderChoices, write_folder
from hapticplayer.storage import FOLDER, refuse_existing
from hapticplayer.untrusted import HeldFile

_FOLLOWING_SHARE = 0.75  # of the time of an import in which frames are followed


@dataclass(frozen=True, slots=True)
class Choices(RenderChoices):
    """What an experimenter may choose when importing.

    Attributes:
        processing: conditioning, gravity removal and low-pass.
        log: answers about a log that does not describe itself.
        sync: how the log is synchronised with the clip.
        mounting: right, front and up of the actor in the recorder's axes; "" if not
            given: then gravity has to confirm that the recorder was upright, and the
            frames may not show another one; `BY_FRAMES` for what the frames of the clip tell.
        suggest_gain: estimate the motion from the picture, with this gain; None for a
            recording.
    """

    processing: Processing = dataclasses.field(default_factory=Processing)
    log: LogChoices | None = None
    sync: SyncChoices = dataclasses.field(default_factory=SyncChoices)
    mounting: str = ""
    suggest_gain: float | None = None


def build_sequence(
    video: str | Path,
    target: str | Path,
    *,
    imu_log: LogPath | None = None,
    choices: Choices | None = None,
    progress: Progress = no_progress,
) -> Path:
    """Import a video with its motion and return the folder of the new sequence.

    Args:
        video: the clip; its own telemetry is used unless `imu_log` is given.
        target: the new folder; must not exist.
        imu_log: a separate motion log, in one file or several.
        choices: of the experimenter.
        progress: called with each step; raises Cancelled to stop.

    Raises:
        InputError: when the files cannot be used, or change meanwhile; no partial
            sequence remains.
        UsageError: when the synchronisation is uncertain, or gravity shows that the
            recorder was not upright, or the frames that it was mounted otherwise, and no
            mounting was given.
    """
    video, target = Path(video), Path(target)
    refuse_existing(target, FOLDER)
    choices = choices or Choices()
    source = video if imu_log is None else imu_log
    with HeldFile(video, MediaError) as clip_file:

        def report(fraction: float, step: str) -> None:
            clip_file.refuse_changed()
            progress(fraction, step)

        bar = _Bar(report)
        bar.rest(0.0, Message("reading {name}", name=video.name))
        clip = probe(video)
        ask_for_pace(clip, choices.sync)
        if choices.suggest_gain is not None:
            if choices.sync.slowed not in {None, 1.0}:
                raise UsageError(
                    "{clip}: motion is estimated as the video plays (--slow-motion 1)",
                    clip=video.name,
                )
            content = frame_function("suggest")(
                clip,
                imu_log,
                choices.suggest_gain,
                choices.mapping,
                bar.following(),
            )
            return write_folder(clip, content, target, choices, bar.rest)
        recording = read_recording(source, choices.log)
        refuse_gravity_free(recording)
        if not choices.mounting and not (choices.log and choices.log.axes):
            is_sign_known = imu_log is None or bool(
                choices.log and choices.log.accel_sign
            )
            if is_fallen(recording.imu) and not is_sign_known:
                sign_by_frames(clip, recording, choices.sync, bar.following())
            ask_for_mounting(
                recording.imu, name_of(source), is_sign_known=is_sign_known
            )
        bar.rest(0.0, Message("synchronising"))
        recording = synchronized(clip, recording, choices.sync, bar.following())
        if not choices.mounting:
            ask_for_shown_mounting(clip, recording)
        elif choices.mounting == BY_FRAMES:
            found = mounting_by_frames(clip, recording, bar.following())
            recording = _mounted(recording, found.axes, by_frames=found.described())
        else:
            recording = _mounted(recording, choices.mounting)
        refuse_upside_down(recording.imu, name_of(source), choices.mounting)
        return write_sequence(
            clip, recording, target, choices=choices, progress=bar.rest
        )


class _Bar:
    """Progress of an import, most of which is following frames where that is done."""

    def __init__(self, report: Progress) -> None:
        self._report = report
        self._done = 0.0

    def following(self) -> Progress:
        begin = self._done

        def report(share: float, step: str) -> None:
            self._done = begin + _FOLLOWING_SHARE * (1.0 - begin) * share
            self._report(self._done, step)

        return report

    def rest(self, share: float, step: str) -> None:
        """Report the share of everything else, in what following frames has left."""
        self._report(self._done + (1.0 - self._done) * share, step)


def _mounted(
    recording: Recording, axes: str, by_frames: dict[str, Any] | None = None
) -> Recording:
    """Return the recording in the actor's axes, with the mounting in its provenance."""
    provenance = {**recording.provenance, "mounting": axes}
    if by_frames is not None:
        provenance[SHOWN] = by_frames
    return dataclasses.replace(
        recording, imu=mounted(recording.imu, axes), provenance=provenance
    )


def write_sequence(
    clip: ClipInfo,
    recording: Recording,
    target: Path,
    *,
    choices: Choices | None = None,
    extras: dict[str, dict[str, Any]] | None = None,
    progress: Progress = no_progress,
) -> Path:
    """Write the sequence of a clip and a synchronised recording.

    Args:
        clip: the video.
        recording: its motion, with its clock map.
        target: the new folder; must not exist.
        choices: of the experimenter.
        extras: further arrays to store, by name of the .npz (a simulation's truth).
        progress: called with each step.

    Raises:
        InputError: when motion and clip do not overlap, the clip changes, or writing
            fails.
    """
    choices = choices or Choices()
    progress(0.05, Message("removing gravity"))
    _check_overlap(recording, clip)
    recording, elsewhere = _around(recording, clip)
    mounting = str(recording.provenance.get("mounting", ""))
    processing = choices.processing.mounted(mounting)
    processed = process_motion(recording.imu, processing, elsewhere)
    track = _mapped(processed.track, recording)
    notes = (
        *recording.notes,
        *_notes_on_calibration(choices.processing, recording),
        *notes_on_motion(processed.imu, processed.summary),
        *notes_on_sequence(recording, track, clip),
    )
    provenance = {
        "motion_source": Path(recording.imu.source).name,
        "camera": recording.camera,
        "imu_rate_hz": round(recording.imu.rate_hz, 3),
        "imu_samples": len(recording.imu),
        **_describe_cover(recording.imu, track, clip),
        **_describe_processing(processed, choices.processing),
        **recording.provenance,
    }
    content = Content(
        track, recording.clock_map, recording.imu, notes, provenance, extras or {}
    )
    return write_folder(clip, content, target, choices, progress)


def _mapped(track: MotionTrack, recording: Recording) -> MotionTrack:
    """Return the motion in media time."""
    clock = recording.clock_map
    return dataclasses.replace(track, time_s=clock.rate * track.time_s + clock.offset_s)


def _notes_on_calibration(
    processing: Processing, recording: Recording
) -> tuple[str, ...]:
    given = processing.calibration
    return () if given is None else given.notes(recording.camera)


def _around(
    recording: Recording, clip: ClipInfo
) -> tuple[Recording, SensorCalibration | None]:
    """Return the recording around the clip, and what the rest tells of the sensor."""
    clock = recording.clock_map
    start_s = -clock.offset_s / clock.rate
    end_s = start_s + clip.duration_s / clock.rate
    near, elsewhere = surroundings(recording.imu, start_s, end_s)
    return dataclasses.replace(recording, imu=near), elsewhere


def _check_overlap(recording: Recording, clip: ClipInfo) -> None:
    clock, time_s = recording.clock_map, recording.imu.time_s
    first_s, last_s = (
        clock.rate * float(time_s[end]) + clock.offset_s for end in (0, -1)
    )
    if last_s <= 0.0 or first_s >= clip.duration_s:
        raise InputError(
            "the motion covers {first_s:.1f} to {last_s:.1f} s of media time, but "
            "the clip lasts from 0 to {duration_s:.1f} s",
            where=clip.path.name,
            remedy="enter another offset (--offset S)",
            first_s=first_s,
            last_s=last_s,
            duration_s=clip.duration_s,
        )


def _describe_cover(imu: ImuLog, track: MotionTrack, clip: ClipInfo) -> dict[str, Any]:
    gaps = find_gaps(imu)
    first_s = max(0.0, float(track.time_s[0]))
    last_s = min(clip.duration_s, float(track.time_s[-1]))
    return {
        "gaps": len(gaps),
        "longest_gap_s": float(np.diff(imu.time_s)[gaps].max()) if len(gaps) else 0.0,
        "uncovered_share": round(1.0 - (last_s - first_s) / clip.duration_s, 5),
    }


def _describe_processing(processed: Processed, chosen: Processing) -> dict[str, Any]:
    summary = processed.summary
    return {
        "gravity_removal": chosen.method,
        "accelerometer_gain": summary["accelerometer_gain"],
        "accelerometer_gain_from": summary["accelerometer_gain_from"],
        "motion_summary": dict(summary),
        "processing": dataclasses.asdict(chosen),
        "conditioning": list(processed.conditioning),
    }
