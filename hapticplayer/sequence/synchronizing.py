"""Synchronises a recording with its clip; uncertain results need a person."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.methods import AUTO, sync_method
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.capture.sync.synchronize import Sound, SyncInput, read_sound
from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.media.clip_info import ClipInfo, camera_of
from hapticplayer.model import ClockMap
from hapticplayer.model.ranges import SKEW_S
from hapticplayer.sequence import files

SKEWS = "cameras.json"
"""In the settings folder: how much later than its frames each camera's sound comes, s."""

_NEXT_BEST = 3
_SAME_S = 0.0005  # half a step of the window


@dataclass(frozen=True, slots=True)
class SyncChoices:
    """How to synchronise.

    Attributes:
        method: one of `capture.sync.methods.SYNC_METHODS`.
        offset_s: media time of the log's time zero.
        sound_late_s: how much later than its frames the camera's sound comes; None
            for the stored skew of the clip's camera.
        accepted: a result that a person has checked and accepted.
    """

    method: str = AUTO
    offset_s: float | None = None
    sound_late_s: float | None = None
    accepted: Synchronisation | None = None


def synchronized(
    clip: ClipInfo, recording: Recording, choices: SyncChoices
) -> Recording:
    """Return the recording synchronised with the clip, documented in its provenance.

    Raises:
        InputError: when no synchronisation is possible.
        UsageError: when the result is uncertain.
    """
    found = choices.accepted or find_sync(clip, recording, choices)
    if not found.is_confident and choices.accepted is None:
        raise UsageError(uncertainty(found, clip.path.name))
    described = {**found.described(), "seen_by_person": choices.accepted is not None}
    return dataclasses.replace(
        recording,
        clock_map=found.clock_map,
        provenance={**recording.provenance, "synchronisation": described},
    )


def moved_to(found: Synchronisation, offset_s: float) -> Synchronisation:
    """Return a result with another offset, chosen by a person."""
    if abs(offset_s - found.clock_map.offset_s) < _SAME_S:
        return found
    # the evidence was for the old offset
    clock = ClockMap(offset_s, found.clock_map.rate, 0.0, 1.0)
    return Synchronisation(
        clock, "offset", has_drift=found.has_drift, sound_late_s=found.sound_late_s
    )


def find_sync(
    clip: ClipInfo, recording: Recording, choices: SyncChoices
) -> Synchronisation:
    """Return the synchronisation of a recording with a clip, certain or not.

    Raises:
        InputError: when no synchronisation is possible.
        UsageError: for a method that does not exist or lacks its argument.
    """

    def hear() -> Sound:
        if not clip.has_audio:
            raise InputError(
                "it holds no sound, in which pats could be heard",
                where=clip.path.name,
                remedy="give --offset S, the media time at which the log's clock reads 0",
            )
        late_s = choices.sound_late_s
        if late_s is None:
            late_s = stored_skews().get(camera_of(clip.path), 0.0)
        return read_sound(clip.path, late_s)

    offset_s, own = choices.offset_s, recording.clock_map
    given = None if offset_s is None else ClockMap(offset_s)
    known = own if own.confidence > 0.0 else None
    inputs = SyncInput(recording.imu, hear, given, known)
    return sync_method(choices.method).function()(inputs)


def uncertainty(found: Synchronisation, clip: str) -> str:
    """Return why a result is uncertain and what to do."""
    look = Message(
        "compare sound and motion with `hapticplayer sync --plot FILE`, then give "
        "--offset S"
    )
    if not found.pats:
        return Message(
            "{clip}: no three pats are both heard and felt; {look}",
            clip=clip,
            look=look,
        )
    clock = found.clock_map
    others = [f"{one.shift_s:.3f}" for one in found.rivals[:_NEXT_BEST]]
    next_best = Message(", others {known} s", known=", ".join(others)) if others else ""
    return Message(
        "{clip}: the pats are uncertain (confidence {confidence:.2f}); the best offset "
        "is {offset_s:.3f} s{next_best}; {look}",
        clip=clip,
        confidence=clock.confidence,
        offset_s=clock.offset_s,
        next_best=next_best,
        look=look,
    )


def stored_skews(path: Path | None = None) -> dict[str, float]:
    """Return the stored skew of each camera, in s.

    Raises:
        SequenceError: when the file is damaged.
        InputError: when it holds anything but skews.
    """
    path = path or files.config_home() / SKEWS
    if not path.is_file():
        return {}
    content = files.read_json(path)
    held = content.get("sound_late_s")
    if not isinstance(held, Mapping):
        raise InputError("lacks the object sound_late_s", where=str(path))
    return {str(name): checked_skew(late_s) for name, late_s in held.items()}


def store_skew(camera: str, late_s: float, path: Path | None = None) -> None:
    """Store the skew of a camera."""
    path = path or files.config_home() / SKEWS
    skews = {**stored_skews(path), camera: checked_skew(late_s)}
    files.replace_json(path, {"sound_late_s": skews})


def checked_skew(late_s: object) -> float:
    """Return a valid skew.

    Raises:
        InputError: for anything else.
    """
    is_number = isinstance(late_s, int | float) and not isinstance(late_s, bool)
    if not is_number or not abs(float(late_s)) <= SKEW_S.largest:  # type: ignore[arg-type]
        raise InputError(
            "{late_s!r} is not a skew of sound and frames; it must be between "
            "-{largest_skew_s:g} and {largest_skew_s:g}",
            late_s=late_s,
            largest_skew_s=SKEW_S.largest,
        )
    return float(late_s)  # type: ignore[arg-type]
