"""The import pipeline: from a recording to a sequence."""

import dataclasses
import hashlib
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import __version__, rendering
from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.mounting import BY_FRAMES, ask_for_mounting, mounted
from hapticplayer.capture.recording import Recording, find_gaps, refuse_gravity_free
from hapticplayer.capture.source import LogPath, name_of
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import InputError, MediaError, Message, SequenceError
from hapticplayer.media.clip_info import ClipInfo, probe
from hapticplayer.model import (
    Feedback,
    ForceTrack,
    ImuLog,
    Mapping,
    MotionTrack,
)
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.outputs import FOLDER, refuse_existing
from hapticplayer.sequence import files, store
from hapticplayer.sequence.editing import describe_rendering
from hapticplayer.sequence.excursion import excursion_texts, predict
from hapticplayer.sequence.mounting_by_frames import mounting_by_frames
from hapticplayer.sequence.presets import DEFAULT_PRESET, render_preset
from hapticplayer.sequence.processing import Processed, Processing, process_motion
from hapticplayer.sequence.report import (
    describe_notes,
    notes_on_motion,
    notes_on_sequence,
)
from hapticplayer.sequence.surroundings import surroundings
from hapticplayer.sequence.synchronizing import SyncChoices, synchronized
from hapticplayer.untrusted import HeldFile

_COPY_SHARE = 0.6  # of the whole work; a long clip is mostly copied and hashed


@dataclass(frozen=True, slots=True)
class Choices:
    """What an experimenter may choose when importing.

    Attributes:
        title: None for the name of the video.
        mapping: axes, gain, limit, knee and lever arm.
        fits_gain: replace its gain by the one of `rendering.fit_gain`.
        preset: of the rendering, see `presets`.
        processing: conditioning, gravity removal and low-pass.
        seed: of the random feedback; None derives it from the clip's content.
        log: answers about a log that does not describe itself.
        sync: how the log is synchronised with the clip.
        mounting: right, front and up of the actor in the recorder's axes; "" if not
            given: then gravity has to confirm that the recorder was upright;
            `BY_FRAMES` for what the frames of the clip tell.
    """

    title: str | None = None
    mapping: Mapping = dataclasses.field(default_factory=Mapping)
    fits_gain: bool = False
    preset: str = DEFAULT_PRESET
    processing: Processing = dataclasses.field(default_factory=Processing)
    seed: int | None = None
    log: LogChoices | None = None
    sync: SyncChoices = dataclasses.field(default_factory=SyncChoices)
    mounting: str = ""


def build_sequence(
    video: str | Path,
    target: str | Path,
    *,
    imu_log: LogPath | None = None,
    choices: Choices | None = None,
    progress: files.Progress = files.no_progress,
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
            recorder was not upright and no mounting was given.
    """
    video, target = Path(video), Path(target)
    refuse_existing(target, FOLDER, error=SequenceError)
    choices = choices or Choices()
    source = video if imu_log is None else imu_log
    with HeldFile(video, MediaError) as clip_file:

        def report(fraction: float, step: str) -> None:
            clip_file.refuse_changed()
            progress(fraction, step)

        report(0.0, Message("reading {name}", name=video.name))
        clip = probe(video)
        recording = read_recording(source, choices.log)
        refuse_gravity_free(recording)
        if not choices.mounting and not (choices.log and choices.log.axes):
            ask_for_mounting(recording.imu, name_of(source))
        report(0.02, Message("synchronising"))
        recording = synchronized(clip, recording, choices.sync, _share(report))
        axes = choices.mounting
        if axes == BY_FRAMES:
            axes = mounting_by_frames(clip, recording, _share(report))
        recording = _mounted(recording, axes)
        return write_sequence(clip, recording, target, choices=choices, progress=report)


def _share(report: files.Progress) -> files.Progress:
    """Return the progress of following frames, within that of an import."""
    return lambda share, step: report(0.02 + 0.03 * share, step)


def _mounted(recording: Recording, axes: str) -> Recording:
    """Return the recording in the actor's axes, with the mounting in its provenance."""
    if not axes:
        return recording
    return dataclasses.replace(
        recording,
        imu=mounted(recording.imu, axes),
        provenance={**recording.provenance, "mounting": axes},
    )


def write_sequence(
    clip: ClipInfo,
    recording: Recording,
    target: Path,
    *,
    choices: Choices | None = None,
    extras: dict[str, dict[str, Any]] | None = None,
    progress: files.Progress = files.no_progress,
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
    with files.written_aside(target) as folder:
        clip_name = "clip" + clip.path.suffix.lower()
        clip_hash = _copy_clip(clip.path, folder / clip_name, progress)
        progress(0.85, Message("rendering the force"))
        mapping, tracks = _render(track, recording, clip, choices, clip_hash)
        excursions = _predict(tracks, clip, progress)
        _write_arrays(folder, recording.imu, track, tracks, extras or {})
        listed = _checksums(folder, {clip_name: clip_hash})
        progress(0.95, Message("writing"))
        notes = [
            *recording.notes,
            *_notes_on_calibration(choices.processing, recording),
            *notes_on_motion(processed.imu, processed.summary),
            *notes_on_sequence(recording, track, tracks, clip),
            *excursion_texts(excursions[Feedback.REALISTIC.value]),
        ]
        description = {
            "schema": store.SCHEMA,
            "version": store.VERSION,
            "title": choices.title or clip.path.stem,
            "clip": _describe_clip(clip, clip_name),
            "clock_map": dataclasses.asdict(recording.clock_map),
            "mapping": store.describe_mapping(mapping),
            "feedbacks": _describe_tracks(tracks, excursions),
            "files": listed,
            "provenance": {
                "program": f"hapticplayer {__version__}",
                "created_utc": utc_now_iso(),
                "video": clip.path.name,
                "motion_source": Path(recording.imu.source).name,
                "camera": recording.camera,
                "imu_rate_hz": round(recording.imu.rate_hz, 3),
                "imu_samples": len(recording.imu),
                **_describe_cover(recording.imu, track, clip),
                **_describe_processing(processed, choices.processing),
                "rendering": describe_rendering(fits_gain=choices.fits_gain),
                **describe_notes(notes),
                **recording.provenance,
            },
        }
        files.write_json(folder / store.DESCRIPTION, description)
        progress(1.0, Message("done"))
    return target


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
            remedy="give another --offset",
            first_s=first_s,
            last_s=last_s,
            duration_s=clip.duration_s,
        )


def _copy_clip(clip: Path, target: Path, progress: files.Progress) -> str:
    """Copy the clip and return its checksum."""
    with HeldFile(clip, MediaError) as source:
        free = shutil.disk_usage(target.parent).free
        if free < source.size_bytes:
            raise InputError(
                "needs {needed_mb} MB and only {free_mb} MB are free",
                where=str(target.parent.parent),
                remedy="free some space or choose another folder",
                needed_mb=source.size_bytes >> 20,
                free_mb=free >> 20,
            )
        return files.copy_file(
            source,
            target,
            lambda f: progress(0.2 + _COPY_SHARE * f, Message("copying the clip")),
        )


def _render(
    track: MotionTrack,
    recording: Recording,
    clip: ClipInfo,
    choices: Choices,
    clip_hash: str,
) -> tuple[Mapping, dict[str, ForceTrack]]:
    """Return the mapping, with its gain fitted where that is chosen, and the tracks."""
    mapping = choices.mapping
    imu = store.in_media_time(recording.imu, recording.clock_map)
    if choices.fits_gain:
        gain = rendering.fit_gain(track, mapping, clip.duration_s, imu)
        mapping = dataclasses.replace(mapping, gain_n_per_mps2=gain)
    realistic = render_preset(track, mapping, imu, name=choices.preset)
    seed = choices.seed
    if seed is None:
        # the same clip gives the same random track, on every machine
        seed = int.from_bytes(hashlib.sha256(clip_hash.encode()).digest()[:4], "big")
    return mapping, {
        condition.name: condition.track(rendering.Ingredients(realistic, seed), {})
        for condition in rendering.FEEDBACKS
        if condition.is_stored
    }


def _predict(
    tracks: dict[str, ForceTrack], clip: ClipInfo, progress: files.Progress
) -> dict[str, dict[str, Any]]:
    """Return the predicted excursion of the hand for each track."""
    share, found = 0.05 / len(tracks), {}
    for number, (name, force) in enumerate(tracks.items()):

        def report(done: float, begin: float = 0.9 + share * number) -> None:
            progress(begin + share * done, Message("predicting excursions"))

        found[name] = predict(force, clip.duration_s, report)
    return found


def _write_arrays(
    folder: Path,
    imu: ImuLog,
    track: MotionTrack,
    tracks: dict[str, ForceTrack],
    extras: dict[str, dict[str, Any]],
) -> None:
    fields: dict[str, Any] = {
        "time_s": imu.time_s,
        "specific_force_mps2": imu.specific_force_mps2,
        "angular_rate_radps": imu.angular_rate_radps,
        "sampling": imu.sampling.value,
    }
    for name in store.OPTIONAL_IMU_FIELDS:
        if getattr(imu, name) is not None:
            fields[name] = getattr(imu, name)
    files.write_arrays(folder / store.IMU, **fields)
    kept = {f.name: getattr(track, f.name) for f in dataclasses.fields(track)}
    kept = {name: value for name, value in kept.items() if value is not None}
    kept["sampling"] = track.sampling.value
    files.write_arrays(folder / store.MOTION, **kept)
    for name, force in tracks.items():
        files.write_arrays(folder / f"force_{name}.npz", **store.track_arrays(force))
    for name, arrays in extras.items():
        files.write_arrays(folder / f"{name}.npz", **arrays)


def _checksums(folder: Path, known: dict[str, str]) -> dict[str, Any]:
    return {
        path.name: {
            "sha256": known.get(path.name) or files.sha256_of(path),
            "size_bytes": path.stat().st_size,
        }
        for path in sorted(folder.iterdir())
    }


def _describe_clip(clip: ClipInfo, name: str) -> dict[str, Any]:
    return {
        "file": name,
        "duration_s": clip.duration_s,
        "width": clip.width,
        "height": clip.height,
        "frame_rate_hz": clip.frame_rate_hz,
        "has_audio": clip.has_audio,
    }


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


def _describe_tracks(
    tracks: dict[str, ForceTrack], excursions: dict[str, dict[str, Any]]
) -> dict[str, Any]:
    described: dict[str, Any] = {
        name: store.describe_track(track, f"force_{name}.npz", excursions[name])
        for name, track in tracks.items()
    }
    for condition in rendering.FEEDBACKS:
        if condition.is_made_at_opening:
            described[condition.name] = {"provenance": {"feedback": condition.name}}
    return described
