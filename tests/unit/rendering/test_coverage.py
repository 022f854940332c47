"""Force tracks whose times do not fit the clip, which lasts 60 s here."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.rendering import coverage_notice, refuse_late

CLIP_S = 60.0


def track(*time_s):
    return ForceTrack(
        np.array(time_s), np.ones((len(time_s), 3), np.float32), Reconstruction.HOLD
    )


@pytest.mark.parametrize(
    ("time_s", "unit"),
    [((0.0, 60e3), "milliseconds: divide time_s by 1000"),
     ((0.0, 5e3), "milliseconds"),
     ((0.5e6, 59e6), "microseconds: divide time_s by 1000000"),
     ((0.0, 60e9), "nanoseconds: divide time_s by 1000000000"),
     ((0.0, 900.0), ""), ((0.0, 5.9), ""), ((6.1, 60.0), ""), ((-9.0, -1.0), "")],
)  # fmt: skip
def test_a_track_that_covers_hardly_anything_is_noticed(time_s, unit):
    notice = coverage_notice(track(*time_s), CLIP_S)
    assert f"{time_s[0]:.6g} s to {time_s[1]:.6g} s, the clip to 60 s" in notice
    assert unit in notice
    assert ("it looks like" in notice) is bool(unit)


@pytest.mark.parametrize(
    "time_s", [(0.0, 60.0), (5.9, 20.0), (0.0, 6.1), (-3.0, 600.0), (0.0,)]
)
def test_a_track_that_goes_with_the_clip_has_no_notice(time_s):
    assert coverage_notice(track(*time_s), CLIP_S) is None


@pytest.mark.parametrize(
    ("time_s", "remedy"),
    [((33_333.0, 60e6), "microseconds"), ((1.7e9, 1.7e9 + 60), "seconds of the clip")],
)
def test_a_track_after_the_clip_is_refused_with_its_unit(time_s, remedy):
    with pytest.raises(InputError, match=f"clip ends at 60.000 s.*{remedy}"):
        refuse_late(track(*time_s), CLIP_S, "force.csv")
