from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.errors import UsageError, no_progress
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.sequence import mounting_by_frames as module
from hapticplayer.sequence.mounting_by_frames import (
    ask_for_shown_mounting,
    mounting_by_frames,
)

CLIP = ClipInfo(Path("ride.mp4"), 10.0, 320, 180, 30.0, 300, False, 0, False)


def recording(axes: str, by_frames: FoundMounting | None) -> Recording:
    """A log at rest, upright once its axes are taken as given."""
    time_s = np.arange(0.0, 10.0, 0.01)
    accel = np.tile(np.array([0.0, 0.0, 9.81]) @ axes_matrix(axes), (len(time_s), 1))
    found = {"mounting": by_frames.described()} if by_frames else {}
    return Recording(
        imu=ImuLog(time_s, accel, np.ones_like(accel)),
        clock_map=ClockMap(),
        camera="logger",
        provenance={"synchronisation": found},
    )


def test_a_mounting_found_by_synchronising_is_taken() -> None:
    by_frames = FoundMounting("z,y,-x", 4.0, "x,y,z")

    found = mounting_by_frames(CLIP, recording("z,y,-x", by_frames), no_progress)

    assert found == by_frames


def test_frames_are_followed_where_nothing_was_found(monkeypatch) -> None:
    by_frames = FoundMounting("y,-x,z", 2.0, "x,y,z")
    asked = {"mounting": lambda *_given: by_frames}
    monkeypatch.setattr(module, "frame_function", asked.get)

    found = mounting_by_frames(CLIP, recording("x,y,z", None), no_progress)

    assert found == by_frames


def test_a_close_rival_is_a_question() -> None:
    by_frames = FoundMounting("y,-x,z", 1.1, "x,y,z")

    with pytest.raises(UsageError, match=r"y,-x,z or x,y,z \(ratio 1\.10\)"):
        mounting_by_frames(CLIP, recording("x,y,z", by_frames), no_progress)


def test_gravity_that_disagrees_is_a_question() -> None:
    by_frames = FoundMounting("-x,y,-z", 4.0, "x,y,z")

    with pytest.raises(UsageError, match="by gravity another side is up"):
        mounting_by_frames(CLIP, recording("x,y,z", by_frames), no_progress)


def test_a_mounting_that_frames_contradict_is_a_question() -> None:
    by_frames = FoundMounting("-x,-y,z", 25.6, "z,y,-x")

    with pytest.raises(UsageError, match=r"-x,-y,z \(ratio 25\.6\), not x,y,z.* auto"):
        ask_for_shown_mounting(CLIP, recording("x,y,z", by_frames))


@pytest.mark.parametrize(
    "by_frames",
    [
        None,
        FoundMounting("x,y,z", 25.6, "z,y,-x"),
        FoundMounting("-x,-y,z", 1.1, "x,y,z"),  # not clear
        FoundMounting("-x,y,-z", 25.6, "x,y,z"),  # against gravity: mirrored, perhaps
    ],
)
def test_a_mounting_without_contradiction_is_no_question(by_frames) -> None:
    ask_for_shown_mounting(CLIP, recording("x,y,z", by_frames))
