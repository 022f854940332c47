"""Synchronises a recording with its clip; uncertain results need a person."""

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

from msgspec import Meta, Struct

from hapticplayer import storage
from hapticplayer.capture.frames import FrameRotation, frame_function, has_frames
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.methods import AUTO, sync_method
from hapticplayer.capture.sync.result import (
    COARSE_NOTE,
    ClipSound,
    Synchronisation,
    SyncInput,
)
from hapticplayer.capture.sync.synchronize import NO_FIT, NO_PATS, read_sound
from hapticplayer.errors import (
    InputError,
    Message,
    Progress,
    SequenceError,
    UsageError,
    joined,
    no_progress,
)
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.ranges import SKEW_S
from hapticplayer.structures import read_json

SKEWS = "cameras.json"
"""In the settings folder: how much later than its frames each camera's sound comes, s."""

_EXTRA = Message(
    "with hapticplayer[vision] installed, the frames are compared with the gyro exactly, "
    "and those of H.265 too"
)
_PACED = Message("frames cannot be compared with the gyroscope at another speed")
_NEXT_BEST = 3
_SAME_S = 0.0005  # half a step of the window


@dataclass(frozen=True, slots=True)
class SyncChoices:
    """How to synchronise.

    Attributes:
        method: one of `capture.sync.methods.SYNC_METHODS`.
        offset_s: media less log time, in the middle of the clip.
        drift_ppm: by how much faster media time runs than the log's clock.
        slowed: how many times as slow as it was recorded the video plays; None where
            its metadata may not say that it does.
        sound_late_s: how much later than its frames the camera's sound comes; None
            for the stored skew of the clip's camera.
        refuses_idle_skew: a skew that has no effect is refused.
        accepted: a result that a person has checked and accepted, or the clip's own
            clock as it was found before.
    """

    method: str = AUTO
    offset_s: float | None = None
    drift_ppm: float = 0.0
    slowed: float | None = None
    sound_late_s: float | None = None
    refuses_idle_skew: bool = False
    accepted: Synchronisation | None = None


def synchronized(
    clip: ClipInfo,
    recording: Recording,
    choices: SyncChoices,
    progress: Progress = no_progress,
) -> Recording:
    """Return the recording synchronised with the clip, documented in its provenance.

    `progress` is called with the share of the frames followed; it raises Cancelled.

    Raises:
        InputError: when no synchronisation is possible.
        UsageError: when the result is uncertain.
    """
    found = choices.accepted or find_sync(clip, recording, choices, progress)
    if not found.is_confident and choices.accepted is None:
        raise UsageError(uncertainty(found, clip.path.name))
    is_trusted = found.method == "embedded" and not found.contradiction
    is_seen = choices.accepted is not None and not is_trusted
    described = {**found.described(), "seen_by_person": is_seen}
    provenance = {**recording.provenance, "synchronisation": described}
    if found.lag is not None:
        provenance["clock_lag"] = found.lag.described()
    return dataclasses.replace(
        recording,
        clock_map=found.clock_map,
        notes=notes_on_sync(recording, found),
        lag=found.lag or recording.lag,
        provenance=provenance,
    )


def notes_on_sync(recording: Recording, found: Synchronisation) -> tuple[str, ...]:
    """Return the recording's notes, with what is known now of its clock."""
    notes, before, after = recording.notes, recording.lag, found.lag
    if before is not None and after is not None:
        notes = tuple(after.text if n == before.text else n for n in notes)
    if found.is_seen_otherwise:
        notes = (*notes, found.seen)
    return (*notes, *coarse_notes()) if found.is_coarse else notes


def coarse_notes() -> tuple[Message, ...]:
    """Return that frames were compared coarsely, and why if OpenCV is installed."""
    return (COARSE_NOTE, _broken()) if why_broken() else (COARSE_NOTE,)


def _broken() -> Message:
    return Message("OpenCV is installed, but cannot be loaded: {why}", why=why_broken())


def moved_to(found: Synchronisation, offset_s: float, rate: float) -> Synchronisation:
    """Return a result with another offset or clock rate, chosen by a person."""
    before = found.clock_map
    if abs(offset_s - before.offset_s) < _SAME_S and rate == before.rate:
        return found
    # the evidence was for the old offset
    clock = ClockMap(offset_s, rate, 0.0, 1.0)
    return Synchronisation(
        clock, "offset", has_drift=found.has_drift, sound_late_s=found.sound_late_s
    )


def find_sync(
    clip: ClipInfo,
    recording: Recording,
    choices: SyncChoices,
    progress: Progress = no_progress,
    look: Callable[[], FrameRotation] | None = None,
) -> Synchronisation:
    """Return the synchronisation of a recording with a clip, certain or not.

    `progress` is called with the share of the frames followed; it raises Cancelled.
    `look` watches the frames in place of `watch`.

    Raises:
        InputError: when no synchronisation is possible.
        UsageError: for a method that does not exist or lacks its argument.
        LogQuestion: when frames that were followed show that the log is misread.
    """
    heard: list[ClipSound] = []
    seen: list[FrameRotation] = []

    def follow() -> FrameRotation:
        seen.append(look() if look else watch(clip, progress, near))
        return seen[-1]

    def hear() -> ClipSound:
        late_s = choices.sound_late_s
        if late_s is None:
            late_s = stored_skews().get(clip.camera, 0.0)
        sound = read_sound(clip.path, late_s) if clip.has_audio else None
        if sound is None or not len(sound.samples):
            raise InputError(
                "it holds no sound, in which taps could be heard",
                where=clip.path.name,
                remedy="enter the media time at which the log's clock reads 0 (--offset S)",
            )
        heard.append(sound)
        return sound

    middle_s, own = 0.5 * clip.duration_s, recording.clock_map
    is_placed = recording.lag is not None and recording.lag.is_of_machine
    near = recording.imu if is_placed else None
    given = _given(clip, choices, middle_s)
    known = own if own.confidence > 0.0 else None
    contradiction = contradicted(recording, clip)
    inputs = SyncInput(
        recording.imu,
        hear,
        given,
        known,
        follow if has_frames() else None,
        recording.lag,
        contradiction or "",
        recording.placing.others if recording.placing else (),
    )
    found = _at(sync_method(choices.method).function()(inputs), middle_s)
    found = _compared(clip, recording, choices, found, seen, progress)
    if choices.refuses_idle_skew and not heard:
        raise UsageError(
            "{clip}: the skew of the sound would have no effect, because the offset "
            "comes from elsewhere ({method}); leave it out (--skew, --camera)",
            clip=clip.path.name,
            method=found.method,
        )
    return found


def _compared(
    clip: ClipInfo,
    recording: Recording,
    choices: SyncChoices,
    found: Synchronisation,
    seen: list[FrameRotation],
    progress: Progress,
) -> Synchronisation:
    """The result, with what frames tell of the gyroscope; a few where none were followed."""
    frames = seen[-1] if seen else None
    if frames is None:
        is_followed = choices.method in {AUTO, "frames"} and found.is_measured
        if is_followed or not found.is_confident:
            return found
        if choices.slowed not in {None, 1.0} or not is_exact():
            why = _PACED if is_exact() else _EXTRA
            return dataclasses.replace(found, seen=why)
    compare = frame_function("compare")
    result = compare(clip, recording, found, progress, frames=frames)
    assert isinstance(result, Synchronisation)
    return result


def _given(clip: ClipInfo, choices: SyncChoices, middle_s: float) -> ClockMap | None:
    """The clock map that a person gave.

    Raises:
        UsageError: for another pace without an offset.
    """
    slowed = 1.0 if choices.slowed is None else choices.slowed
    if choices.offset_s is None:
        if slowed != 1.0:
            raise UsageError(
                "{clip}: taps and frames cannot be compared at another speed; enter the "
                "offset, too (--offset S)",
                clip=clip.path.name,
            )
        return None
    rate = slowed * (1.0 + 1e-6 * choices.drift_ppm)
    return ClockMap.at(middle_s, choices.offset_s, rate)


def ask_for_pace(clip: ClipInfo, choices: SyncChoices) -> None:
    """Refuse a clip that says that it plays at another pace, where nobody answered.

    Raises:
        UsageError: with what can be done.
    """
    if choices.slowed is not None or choices.accepted is not None:
        return
    from hapticplayer.media.pace import pace_of

    if (pace := pace_of(clip.path)) is not None:
        raise UsageError(pace.question(clip.path))


def _at(found: Synchronisation, middle_s: float) -> Synchronisation:
    """The result with offsets as they are in the middle of the clip."""
    second = None if found.second is None else _at(found.second, middle_s)
    return dataclasses.replace(found, middle_s=middle_s, second=second)


def contradicted(recording: Recording, clip: ClipInfo) -> Message | None:
    """Why the clock of a recording cannot be believed for a clip, or None."""
    placing = recording.placing
    return placing.contradiction(clip.duration_s) if placing else None


def watch(
    clip: ClipInfo, progress: Progress, near: ImuLog | None = None
) -> FrameRotation:
    """The camera's rotation as the frames of a clip tell it.

    `near` is a log that a clock places in it to some ms.

    Raises:
        InputError: when this installation cannot look at frames, or without OpenCV.
        MediaError: when the clip cannot be decoded.
    """
    found: FrameRotation = frame_function("watch")(clip, progress, near)
    return found


def why_broken() -> str:
    """Why OpenCV cannot be loaded, "" where it can, or is not wanted."""
    return str(frame_function("why-broken")()) if has_frames() else ""


def is_exact() -> bool:
    """Whether frames are followed exactly here."""
    return has_frames() and bool(frame_function("is-exact")())


def uncertainty(found: Synchronisation, clip: str) -> str:
    """Return why a result is uncertain and what to do."""
    if found.contradiction:
        return _undecided(found, clip)
    if _disagree(found):
        return _disagreement(found, clip)
    reasons: list[str] = [
        _reason(one) for one in (found, found.second) if one is not None
    ]
    if found.unused:
        reasons.append(found.unused)
    look = Message("otherwise enter the offset (--offset S)")
    if found.method != "frames":
        look = Message(
            "compare sound and motion by eye (`hapticplayer sync --plot FILE`), then enter "
            "the offset (--offset S)"
        )
    if found.is_coarse or not is_exact():
        look = Message("{look}; {brings}", look=look, brings=_brings())
    why = joined(Message("; "), reasons)
    return Message("{clip}: {why}; {look}", clip=clip, why=why, look=look)


def _undecided(found: Synchronisation, clip: str) -> str:
    """A contradiction that neither pats nor frames could decide."""
    places = [
        Message(
            "{offset_s:.3f} s (--offset {offset_s:.3f}), {by}",
            offset_s=one.offset_s,
            by=one.by,
        )
        for one in found.others
    ]
    why = found.unused
    if found.second is not None:
        seconds = (found.second, found.second.second)
        parts = [_reason(one) for one in seconds if one is not None]
        why = joined(Message("; "), [*parts, *filter(None, [found.second.unused])])
    return Message(
        "{clip}: {what}, and neither frames nor taps tell which is right ({why}); enter "
        "the offset: {places}, or another one",
        clip=clip,
        what=found.contradiction,
        why=why,
        places=joined(Message(" or "), places),
    )


def _reason(found: Synchronisation) -> Message:
    """Return why the result of one method is uncertain."""
    if found.method == "frames":
        return _doubtful_frames(found)
    if found.method == "variance":
        return Message("the first sudden rise of sound and motion is uncertain")
    if not found.pats:
        return NO_PATS
    clock = found.clock_map
    others = [f"{one.shift_s:.3f}" for one in found.rivals[:_NEXT_BEST]]
    next_best = Message(", others {known} s", known=", ".join(others)) if others else ""
    return Message(
        "the taps are uncertain (confidence {confidence:.2f}); the best offset is "
        "{offset_s:.3f} s{next_best}",
        confidence=clock.confidence,
        offset_s=found.offset_s,
        next_best=next_best,
    )


def _disagree(found: Synchronisation) -> bool:
    """Whether two methods are certain of different offsets."""
    return found.second is not None and found.second.is_confident


def _disagreement(found: Synchronisation, clip: str) -> str:
    by_method = {one.method: one for one in (found, found.second) if one is not None}
    pats, frames = (by_method[name] for name in ("pats", "frames"))
    return Message(
        "{clip}: the taps give an offset of {pats_s:.3f} s, the frames {frames_s:.3f} "
        "s; choose one of them (--sync pats, --sync frames), or enter the offset "
        "(--offset S); if the camera's sound is late, say by how much (--skew S)",
        clip=clip,
        pats_s=pats.offset_s,
        frames_s=frames.offset_s,
    )


def _doubtful_frames(found: Synchronisation) -> Message:
    evidence = found.frames
    if evidence is None:
        return NO_FIT
    return Message(
        "the frames are uncertain (confidence {confidence:.2f}): the gyro explains "
        "{explained:.0%} of the camera's rotation, at an offset of {offset_s:.3f} s "
        "({doubt})",
        confidence=found.clock_map.confidence,
        explained=evidence.explained,
        offset_s=found.offset_s,
        doubt=evidence.doubt,
    )


def _brings() -> Message:
    """The reason why frames cannot be compared exactly."""
    return _broken() if why_broken() else _EXTRA


class _Skews(Struct):
    sound_late_s: dict[str, Annotated[float, Meta(ge=SKEW_S.least, le=SKEW_S.largest)]]


def stored_skews() -> dict[str, float]:
    """Return the stored skew of each camera, in s.

    Raises:
        SequenceError: when the file is damaged, or holds anything but skews.
    """
    path = storage.config_home() / SKEWS
    if not path.is_file():
        return {}
    return read_json(path, _Skews, SequenceError).sound_late_s


def store_skew(camera: str, late_s: float) -> None:
    home = storage.config_home()
    storage.make_folder(home)
    with storage.locked(home):
        skews = {**stored_skews(), camera: late_s}
        storage.replace_json(home / SKEWS, {"sound_late_s": skews})
