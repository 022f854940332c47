"""The mounting that the frames of a clip tell; gravity is the second opinion."""

from collections.abc import Mapping
from typing import Any

from hapticplayer.capture.choices import LogQuestion
from hapticplayer.capture.frames import frame_function
from hapticplayer.capture.mounting import (
    AS_RECORDED,
    gravity_agrees,
    mean_up,
    up_in_frame_a,
)
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.errors import InputError, Message, Progress, UsageError
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model.limits import UPRIGHT
from hapticplayer.sequence.synchronizing import SyncChoices, synchronized

SHOWN = "mounting_by_frames"
"""In the provenance: a mounting that was taken as the frames show it, with its ratio."""

_GIVE = Message("choose the mounting: right, front and up of the wearer (--mounting)")


def mounting_by_frames(
    clip: ClipInfo, recording: Recording, progress: Progress
) -> FoundMounting:
    """Return the mounting of a synchronised recording.

    What synchronising has found is used; else the frames are followed now.

    Raises:
        UsageError: when frames do not tell two mountings apart, or gravity disagrees.
        InputError: when frames or log tell of no rotation.
    """
    found = _already(recording.provenance.get("synchronisation"))
    if found is None:
        of_frames = frame_function("mounting")
        found = of_frames(clip, recording.imu, recording.clock_map, progress)
    assert isinstance(found, FoundMounting)
    if not found.is_clear:
        raise UsageError(
            "{clip}: the frames do not tell whether the mounting is {axes} or "
            "{next_best} (ratio {ratio:.2f}); {give}",
            clip=clip.path.name,
            axes=found.axes,
            next_best=found.next_best,
            ratio=found.ratio,
            give=_GIVE,
        )
    ask_about_sign(recording, found)
    if not gravity_agrees(mean_up(recording.imu), found.axes):
        raise UsageError(
            "{clip}: by its frames the mounting is {axes}, but by gravity another side "
            "is up; is the video upright and not mirrored? Otherwise {give}",
            clip=clip.path.name,
            axes=found.axes,
            give=_GIVE,
        )
    return found


def ask_about_sign(recording: Recording, found: FoundMounting | None) -> None:
    """Ask for the accelerometer's sign if the frames' mounting puts up where down is.

    The gyro alone tells that mounting, so that nothing else explains it.

    Raises:
        LogQuestion: naming the other sign.
    """
    up = mean_up(recording.imu)
    if up is None or up[2] >= UPRIGHT or found is None or not found.is_clear:
        return
    if up_in_frame_a(up, found.axes)[2] > -UPRIGHT:
        return
    raise LogQuestion(
        Message(
            "by the frames of the clip the mounting is {axes}, by gravity it is the other "
            "way up, so that the accelerometer has the other sign",
            axes=found.axes,
        ),
        (Message("accel-sign=-, or correct the sign in the log"),),
        recording.imu.source,
    )


def sign_by_frames(
    clip: ClipInfo, recording: Recording, choices: SyncChoices, progress: Progress
) -> None:
    """Ask for the sign of an accelerometer as far as the clip can be followed.

    Raises:
        LogQuestion: see `ask_about_sign`, or when the frames show other axes.
    """
    try:
        synced = synchronized(clip, recording, choices, progress)
        found = _already(synced.provenance.get("synchronisation"))
        if found is None:
            of_frames = frame_function("mounting")
            found = of_frames(clip, recording.imu, synced.clock_map, progress)
    except LogQuestion:
        raise
    except (InputError, UsageError):  # then gravity alone is asked about
        return
    ask_about_sign(recording, found)


def ask_for_shown_mounting(clip: ClipInfo, recording: Recording) -> None:
    """Ask for the mounting if the frames that were followed show another one.

    Raises:
        UsageError: naming both; a person knows which is that of the actor.
    """
    found = _already(recording.provenance.get("synchronisation"))
    ask_about_sign(recording, found)
    if found is None or not found.is_clear or found.axes == AS_RECORDED:
        return
    if gravity_agrees(mean_up(recording.imu), found.axes):
        raise UsageError(
            "{clip}: its frames show the mounting {axes} (ratio {ratio:.1f}), not {used}; "
            "take it (--mounting auto), or keep the axes of the log (--mounting forward)",
            clip=clip.path.name,
            axes=found.axes,
            ratio=found.ratio,
            used=AS_RECORDED,
        )


def _already(synchronisation: Any) -> FoundMounting | None:
    """The result of synchronising."""
    if not isinstance(synchronisation, Mapping):
        return None
    found = synchronisation.get("mounting")
    return FoundMounting(**found) if isinstance(found, Mapping) else None
