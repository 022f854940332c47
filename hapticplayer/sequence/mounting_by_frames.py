"""The mounting that the frames of a clip tell; gravity is the second opinion."""

from collections.abc import Mapping
from typing import Any

from hapticplayer.capture.frames import frame_function
from hapticplayer.capture.mounting import AS_RECORDED, gravity_agrees, mean_up
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.errors import Message, Progress, UsageError
from hapticplayer.media.clip_info import ClipInfo

SHOWN = "mounting_by_frames"
"""In the provenance: a mounting that was taken as the frames show it, with its ratio."""

_GIVE = Message("give --mounting (right, front and up of the actor)")


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
    if not gravity_agrees(mean_up(recording.imu), found.axes):
        raise UsageError(
            "{clip}: by its frames the mounting is {axes}, but by gravity another side "
            "is up; is the video upright and not mirrored? Otherwise {give}",
            clip=clip.path.name,
            axes=found.axes,
            give=_GIVE,
        )
    return found


def ask_for_shown_mounting(clip: ClipInfo, recording: Recording) -> None:
    """Ask for the mounting if the frames that were followed show another one.

    Raises:
        UsageError: naming both; a person knows which is that of the actor.
    """
    found = _already(recording.provenance.get("synchronisation"))
    if found is None or not found.is_clear or found.axes == AS_RECORDED:
        return
    if gravity_agrees(mean_up(recording.imu), found.axes):
        raise UsageError(
            "{clip}: its frames show the mounting {axes} (ratio {ratio:.1f}), not {used}; "
            "give --mounting auto to take it, or --mounting forward to keep the axes of "
            "the log",
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
