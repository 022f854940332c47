"""Writes a sequence: copies the clip, renders the tracks, describes what is there."""

import dataclasses
import hashlib
import shutil
from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hapticplayer import __version__, rendering, storage
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import InputError, MediaError, Message, Progress
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import (
    ClockMap,
    Feedback,
    ForceTrack,
    ImuLog,
    Mapping,
    MotionTrack,
    rendered_feedback,
)
from hapticplayer.sequence import store
from hapticplayer.sequence.arrays import write_arrays
from hapticplayer.sequence.description import (
    ClipEntry,
    Description,
    ExcursionEntry,
    FileEntry,
    TrackEntry,
    describe_rendering,
    written,
)
from hapticplayer.sequence.excursion import excursion_texts, predict
from hapticplayer.sequence.figures import describe_track
from hapticplayer.sequence.presets import DEFAULT_PRESET, render_preset
from hapticplayer.sequence.report import describe_notes, notes_on_force
from hapticplayer.untrusted import HeldFile

_COPY_SHARE = 0.6  # of the whole work; a long clip is mostly copied and hashed


ESTIMATE = "estimate"
"""Of a motion that frames suggest: arrays with sigma and trust, and their summary."""


@dataclass(frozen=True, slots=True)
class RenderChoices:
    """What an experimenter may choose for any motion.

    Attributes:
        title: None for the name of the video.
        mapping: axes, gain, limit, knee and lever arm.
        fits_gain: replace its gain by the one of `rendering.fit_gain`.
        preset: of the rendering, see `presets`.
        seed: of the random feedback; None derives it from the clip's content.
    """

    title: str | None = None
    mapping: Mapping = field(default_factory=Mapping)
    fits_gain: bool = False
    preset: str = DEFAULT_PRESET
    seed: int | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Content:
    """What a sequence is made of besides its clip.

    Attributes:
        track: the motion, in media time.
        clock_map: of the log.
        imu: the log; None where nothing measured the motion.
        notes: of everything before the rendering.
        provenance: of the motion.
        extras: further arrays to store, by name of the .npz.
    """

    track: MotionTrack
    clock_map: ClockMap
    imu: ImuLog | None
    notes: tuple[str, ...]
    provenance: Dict[str, Any]
    extras: Dict[str, Dict[str, Any]] = field(default_factory=dict)


def write_folder(
    clip: ClipInfo,
    content: Content,
    target: Path,
    choices: RenderChoices,
    progress: Progress,
) -> Path:
    """Write a sequence and return its folder.

    Raises:
        InputError: when the clip changes, or writing fails.
    """
    with storage.folder_written_aside(target) as folder:
        clip_name = "clip" + clip.path.suffix.lower()
        clip_hash = _copy_clip(clip.path, folder / clip_name, progress)
        progress(0.85, Message("rendering the force"))
        mapping, tracks = _render(content, clip, choices, clip_hash)
        excursions = _predict(tracks, clip, progress)
        _write_arrays(folder, content, tracks)
        listed = _checksums(folder, {clip_name: clip_hash})
        progress(0.95, Message("writing"))
        described = _describe_tracks(
            tracks, excursions, clip.duration_s, mapping.force_limit_n
        )
        notes = [
            *content.notes,
            *notes_on_force(described[rendered_feedback(tracks)]),
            *excursion_texts(excursions[rendered_feedback(tracks)]),
        ]
        description = Description(
            title=choices.title or clip.path.stem,
            clip=_describe_clip(clip, clip_name),
            mapping=store.describe_mapping(mapping),
            feedbacks=described,
            files=listed,
            clock_map=content.clock_map,
            provenance={
                "program": f"hapticplayer {__version__}",
                "created_utc": utc_now_iso(),
                "video": clip.path.name,
                "rendering": describe_rendering(fits_gain=choices.fits_gain),
                **describe_notes(notes),
                **content.provenance,
            },
        )
        storage.write_json(folder / store.DESCRIPTION, written(description))
        progress(1.0, Message("done"))
    return target


def _copy_clip(clip: Path, target: Path, progress: Progress) -> str:
    with HeldFile(clip, MediaError) as source:
        free = shutil.disk_usage(target.parent).free
        if free < source.size_bytes:
            raise InputError(
                "the clip needs {needed_mb} MB and only {free_mb} MB are free",
                where=str(storage.disk_of(target)),
                remedy="free some space or choose a folder on another disk",
                needed_mb=source.size_bytes >> 20,
                free_mb=free >> 20,
            )
        return storage.copy_file(
            source,
            target,
            lambda f: progress(0.2 + _COPY_SHARE * f, Message("copying the clip")),
        )


def _render(
    content: Content, clip: ClipInfo, choices: RenderChoices, clip_hash: str
) -> tuple[Mapping, dict[str, ForceTrack]]:
    """Return the mapping, with its gain fitted where that is chosen, and the tracks."""
    mapping, track, imu = choices.mapping, content.track, content.imu
    if imu is not None:
        imu = store.in_media_time(imu, content.clock_map)
    if choices.fits_gain:
        gain = rendering.fit_gain(track, mapping, clip.duration_s, imu)
        mapping = dataclasses.replace(mapping, gain_n_per_mps2=gain)
    rendered = render_preset(track, mapping, imu, name=choices.preset)
    seed = choices.seed
    if seed is None:
        # the same clip gives the same random track, on every machine
        seed = int.from_bytes(hashlib.sha256(clip_hash.encode()).digest()[:4], "big")
    other = Feedback.REALISTIC if track.is_estimated else Feedback.ESTIMATED
    return mapping, {
        condition.name: condition.track(rendering.ConditionInputs(rendered, seed), {})
        for condition in rendering.FEEDBACKS
        if condition.is_stored and condition.name != other
    }


def _predict(
    tracks: dict[str, ForceTrack], clip: ClipInfo, progress: Progress
) -> dict[str, ExcursionEntry]:
    """Return the predicted excursion of the hand for each track."""
    share, found = 0.05 / len(tracks), {}
    for number, (name, force) in enumerate(tracks.items()):

        def report(done: float, begin: float = 0.9 + share * number) -> None:
            progress(begin + share * done, Message("predicting excursions"))

        found[name] = predict(force, clip.duration_s, report)
    return found


def _write_arrays(
    folder: Path, content: Content, tracks: dict[str, ForceTrack]
) -> None:
    if content.imu is not None:
        write_arrays(folder / store.IMU, **_log_arrays(content.imu))
    track = content.track
    kept = {f.name: getattr(track, f.name) for f in dataclasses.fields(track)}
    kept = {name: value for name, value in kept.items() if value is not None}
    kept["sampling"] = track.sampling.value
    write_arrays(folder / store.MOTION, **kept)
    for name, force in tracks.items():
        write_arrays(folder / f"force_{name}.npz", **store.track_arrays(force))
    for name, arrays in content.extras.items():
        write_arrays(folder / f"{name}.npz", **arrays)


def _log_arrays(imu: ImuLog) -> dict[str, Any]:
    fields: dict[str, Any] = {
        "time_s": imu.time_s,
        "specific_force_mps2": imu.specific_force_mps2,
        "angular_rate_radps": imu.angular_rate_radps,
        "sampling": imu.sampling.value,
    }
    for name in store.OPTIONAL_IMU_FIELDS:
        if getattr(imu, name) is not None:
            fields[name] = getattr(imu, name)
    return fields


def _checksums(folder: Path, known: dict[str, str]) -> dict[str, FileEntry]:
    return {
        path.name: FileEntry(
            path.stat().st_size, known.get(path.name) or storage.sha256_of(path)
        )
        for path in sorted(folder.iterdir())
    }


def _describe_clip(clip: ClipInfo, name: str) -> ClipEntry:
    return ClipEntry(
        name,
        clip.duration_s,
        clip.width,
        clip.height,
        clip.frame_rate_hz,
        clip.has_audio,
    )


def _describe_tracks(
    tracks: dict[str, ForceTrack],
    excursions: dict[str, ExcursionEntry],
    duration_s: float,
    force_limit_n: float,
) -> dict[str, TrackEntry]:
    described = {
        name: describe_track(
            *(track, f"force_{name}.npz", duration_s, force_limit_n),
            excursions[name],
        )
        for name, track in tracks.items()
    }
    for condition in rendering.FEEDBACKS:
        if condition.is_made_at_opening:
            described[condition.name] = TrackEntry(
                provenance={"feedback": condition.name}
            )
    return described
