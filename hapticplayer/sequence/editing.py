"""Edits an existing sequence: its title, its mapping, its force tracks.

New files get new names; then the description is replaced atomically, and only then are
files removed that it no longer names. An interruption leaves a consistent sequence.
"""

import dataclasses
import re
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from msgspec import structs

from hapticplayer import model, rendering, storage
from hapticplayer.errors import (
    Message,
    Progress,
    SequenceError,
    UsageError,
    no_progress,
)
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.effects import NO_EFFECTS, EffectList
from hapticplayer.sequence import effects_file, store
from hapticplayer.sequence.arrays import write_arrays
from hapticplayer.sequence.description import (
    Description,
    FileEntry,
    describe_rendering,
    written,
)
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.figures import describe_track
from hapticplayer.sequence.presets import Rendering, preset_of

MAX_TITLE = 300
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,39}")
_OWN = tuple(
    condition.name for condition in rendering.FEEDBACKS if not condition.is_derived
)


def rename_sequence(folder: Path, title: str) -> None:
    """Change the title of a sequence."""
    title = title.strip()
    if not 0 < len(title) <= MAX_TITLE:
        raise UsageError("a title must have 1 to {most} characters", most=MAX_TITLE)
    with storage.locked(folder):
        description = store.read_description(folder)
        _write(folder, structs.replace(description, title=title))


def add_track(
    folder: Path,
    name: str,
    read: Callable[[float], ForceTrack],
    *,
    progress: Progress = no_progress,
) -> None:
    """Add a force track as a new feedback condition.

    Args:
        folder: of the sequence.
        name: of the condition; letters, digits, blanks, dots, hyphens.
        read: returns the track, of which what is after this duration is not played.
        progress: called while excursions are predicted; raises Cancelled to stop.
    """
    with storage.locked(folder):
        sequence = store.open_sequence(folder)
        _check_new(name, sequence.description)
        track = read(sequence.duration_s)
        source = str(track.provenance.get("source", name))
        rendering.refuse_late(track, sequence.duration_s, source)
        _replace_tracks(folder, sequence.description, {name: track}, progress)


def rename_track(folder: Path, old: str, new: str) -> None:
    """Rename a track that was added."""
    with storage.locked(folder):
        description = store.open_sequence(folder).description
        _check_added(old, description)
        _check_new(new, description)
        feedbacks = description.feedbacks
        renamed = {(new if name == old else name): e for name, e in feedbacks.items()}
        _write(folder, structs.replace(description, feedbacks=renamed))


def remove_track(folder: Path, name: str) -> None:
    """Remove a track that was added."""
    with storage.locked(folder):
        description = store.open_sequence(folder).description
        _check_added(name, description)
        kept = {k: one for k, one in description.feedbacks.items() if k != name}
        _put(folder, structs.replace(description, feedbacks=kept), {})


def set_mapping(
    folder: Path,
    mapping: model.Mapping,
    *,
    fits_gain: bool = False,
    preset: str | None = None,
    effects: EffectList | None = None,
    progress: Progress = no_progress,
) -> None:
    """Render the realistic and the random track again with another mapping.

    The random track keeps its seed and gets the RMS per axis of the realistic one.

    Args:
        folder: of the sequence.
        mapping: axes, gain, limit, knee and lever arm.
        fits_gain: replace its gain by the one of `rendering.fit_gain`.
        preset: see `presets`; None keeps that of the realistic track.
        effects: on the timeline; None keeps those that the sequence has.
        progress: called while excursions are predicted; raises Cancelled to stop.
    """
    with storage.locked(folder):
        sequence = store.open_sequence(folder)
        mapping, realistic = render_sequence(
            sequence, mapping, fits_gain=fits_gain, preset=preset, effects=effects
        )
        tracks = {
            condition.name: condition.track(
                rendering.ConditionInputs(
                    realistic, _seed(sequence.tracks[condition.name])
                ),
                {},
            )
            for condition in rendering.FEEDBACKS
            if condition.is_stored and condition.name in sequence.tracks
        }
        description = structs.replace(
            sequence.description,
            mapping=store.describe_mapping(mapping),
            provenance={
                **sequence.description.provenance,
                "rendering": describe_rendering(fits_gain=fits_gain),
            },
        )
        _replace_tracks(folder, description, tracks, progress, effects)


def render_sequence(
    sequence: store.Sequence,
    mapping: model.Mapping,
    *,
    fits_gain: bool = False,
    preset: str | None = None,
    effects: EffectList | None = None,
) -> tuple[model.Mapping, ForceTrack]:
    """Return the mapping, its gain fitted if asked, and the realistic track it gives.

    Nothing is written; arguments and errors as of `set_mapping`.
    """
    if fits_gain:
        gain = fitted_gain(sequence, mapping)
        mapping = dataclasses.replace(mapping, gain_n_per_mps2=gain)
    stored = store.effects_of(sequence)
    if effects is not None:
        _refuse_unfelt(effects, stored, sequence.duration_s)
    chosen = stored if effects is None else effects
    return mapping, rendering_of(sequence, preset, mapping).track(chosen)


def _refuse_unfelt(effects: EffectList, stored: EffectList, duration_s: float) -> None:
    """Refuse new effects that nobody would ever feel, as those of a longer clip."""
    known = {(one.start_s, one.end_s) for one in stored.effects}
    for number, one in enumerate(effects.effects, 1):
        is_felt = one.end_s > 0.0 and one.start_s < duration_s
        if not is_felt and (one.start_s, one.end_s) not in known:
            raise UsageError(
                "effect {number} ({kind}, from {start_s:g} to {end_s:g} s) is beyond the "
                "clip, which lasts {duration_s:.3f} s; move or remove it",
                number=number,
                kind=one.kind,
                start_s=one.start_s,
                end_s=one.end_s,
                duration_s=duration_s,
            )


def set_effects(
    folder: Path,
    effects: EffectList,
    *,
    progress: Progress = no_progress,
) -> None:
    """Render the realistic and the random track again with other effects."""
    mapping = store.open_sequence(folder).mapping
    set_mapping(folder, mapping, effects=effects, progress=progress)


def _seed(track: ForceTrack) -> int:
    return int(track.provenance.get("seed", 0))


def rendered_again(
    folder: Path, preset: str = "", *, has_effects: bool = True
) -> ForceTrack:
    """Return the realistic track of a sequence in another way; nothing is written.

    Args:
        folder: of the sequence.
        preset: "" for that of the realistic track.
        has_effects: whether the sequence's effects are on it.
    """
    sequence = store.open_sequence(folder)
    realistic = sequence.rendered
    is_plain = not realistic.provenance.get("effects")
    if preset in ("", preset_of(realistic)) and (has_effects or is_plain):
        return realistic
    effects = store.effects_of(sequence) if has_effects else NO_EFFECTS
    return rendering_of(sequence, preset or None).track(effects)


def rendering_of(
    sequence: store.Sequence,
    preset: str | None = None,
    mapping: model.Mapping | None = None,
) -> Rendering:
    """The rendering of a sequence's motion under any list of effects.

    Args:
        sequence: with its motion.
        preset: None for that of the realistic track.
        mapping: None for the sequence's own.
    """
    mapping = mapping or sequence.mapping
    name = preset or preset_of(sequence.rendered)
    imu = _angular_rate(sequence, mapping)
    return Rendering(store.motion_of(sequence), mapping, imu, name=name)


class Change(Protocol):
    """Changes a sequence in its folder, such as `set_mapping` with its choices."""

    def __call__(self, folder: Path, *, progress: Progress) -> None:
        """Change it."""


def copy_changed(
    folder: Path,
    target: Path,
    change: Change,
    *,
    title: str | None = None,
    progress: Progress = no_progress,
) -> None:
    """Write a copy of a sequence that is changed before it has its name.

    Args:
        folder: of the sequence.
        target: folder of the copy.
        change: made in the copy.
        title: of the copy; None keeps that of the sequence.
        progress: called with the done share; raises Cancelled to stop.
    """
    with storage.folder_written_aside(target) as aside:
        store.copy_files(folder, aside, lambda f, step: progress(0.5 * f, step))
        change(aside, progress=lambda f, step: progress(0.5 + 0.5 * f, step))
        if title is not None:
            rename_sequence(aside, title)


def fitted_gain(sequence: store.Sequence, mapping: model.Mapping) -> float:
    """Return the gain that `rendering.fit_gain` offers for a sequence.

    Raises:
        InputError: when there is no motion to fit a gain to.
    """
    return rendering.fit_gain(
        store.motion_of(sequence),
        mapping,
        sequence.duration_s,
        _angular_rate(sequence, mapping),
    )


def _angular_rate(
    sequence: store.Sequence, mapping: model.Mapping
) -> model.ImuLog | None:
    """Return the recorded samples in media time where the mapping needs them."""
    if not mapping.moves_point:
        return None
    return store.recorded_log(sequence)


def _write(folder: Path, description: Description) -> None:
    storage.replace_json(folder / store.DESCRIPTION, written(description))


def _check_new(name: str, description: Description) -> None:
    if not _NAME.fullmatch(name):
        raise UsageError(
            "{name!r} is not a valid track name; use up to 40 letters, digits, blanks, "
            "dots and hyphens",
            name=name,
        )
    if rendering.condition_named(name.lower()) is not None:
        raise UsageError(
            "{name!r} is the name of a condition; choose another name", name=name
        )
    if name.lower() in map(str.lower, description.feedbacks):
        raise UsageError("a track {name!r} exists; choose another name", name=name)


def _check_added(name: str, description: Description) -> None:
    if name in _OWN:
        raise UsageError("every sequence needs its track {name!r}", name=name)
    if name not in description.feedbacks:
        raise UsageError("track {name!r} not found", name=name)


def _replace_tracks(
    folder: Path,
    description: Description,
    tracks: dict[str, ForceTrack],
    progress: Progress,
    effects: EffectList | None = None,
) -> None:
    duration_s, feedbacks = description.clip.duration_s, dict(description.feedbacks)
    limit_n = description.mapping.force_limit_n
    made: dict[str, ForceTrack] = {}
    for number, (name, track) in enumerate(tracks.items()):
        report = _reporter(progress, number, len(tracks))
        file = f"force_{secrets.token_hex(4)}.npz"
        made[file] = track
        excursion = predict(track, duration_s, report)
        feedbacks[name] = describe_track(track, file, duration_s, limit_n, excursion)
    _put(folder, structs.replace(description, feedbacks=feedbacks), made, effects)


def _reporter(progress: Progress, number: int, count: int) -> Callable[[float], None]:
    return lambda done: progress(
        (number + done) / count, Message("predicting excursions")
    )


def _put(
    folder: Path,
    description: Description,
    tracks: dict[str, ForceTrack],
    effects: EffectList | None = None,
) -> None:
    """Write new tracks and effects, then the description, then remove files it no longer names."""
    made: list[Path] = []
    try:
        for file, track in tracks.items():
            made.append(folder / file)
            write_arrays(folder / file, **store.track_arrays(track))
        if effects is not None:
            path = _new_effects(folder, description)
            storage.write_json(path, effects_file.written(effects))
            made.append(path)
            description = structs.replace(description, effects=path.name)
        named = {one.file for one in description.feedbacks.values()}
        named.add(description.effects)
        listed = {
            name: entry
            for name, entry in description.files.items()
            if name in named or not name.startswith(("force_", store.EFFECTS))
        }
        for path in made:
            digest = storage.sha256_of(path)
            listed[path.name] = FileEntry(path.stat().st_size, digest)
        dropped = set(description.files) - set(listed)
        _write(folder, structs.replace(description, files=listed))
    except OSError as problem:
        _remove(made)
        raise SequenceError(
            "cannot be written ({reason}); it is as it was",
            where=str(folder),
            remedy="free some space or copy the sequence to a folder of your own",
            reason=storage.write_problem(problem, folder),
        ) from problem
    except BaseException:
        _remove(made)
        raise
    _remove([folder / name for name in dropped])


def _new_effects(folder: Path, description: Description) -> Path:
    """Return the path of `effects.json`, or another one while that is in use."""
    usual = f"{store.EFFECTS}.json"
    other = f"{store.EFFECTS}_{secrets.token_hex(4)}.json"
    return folder / (other if usual in description.files else usual)


def _remove(paths: list[Path]) -> None:
    for path in paths:
        path.unlink(missing_ok=True)
