"""What a simulated ride says of its events is what its exact motion does."""

import numpy as np
import pytest

from hapticplayer.extras.rides.catalogue import SCENES
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES
from tests.material.known_events import (
    KnownEvent,
    Score,
    known_events,
    known_taps,
    score,
)


def peak_mps2(trajectory, event):
    time_s = np.arange(event.start_s, event.end_s, 0.005)
    motion = trajectory.at(time_s)
    return np.linalg.norm(motion.acceleration_mps2, axis=1).max()


def test_impacts_are_where_the_exact_motion_has_them():
    drops = SCENES["free-fall"](np.random.default_rng(5))
    known = [
        one
        for one in known_events(drops.trajectory, drops.duration_s)
        if one.kind == "impact" and one.is_clear
    ]
    assert len(known) == 3
    # a metre's fall that is stopped within an eighth of its time
    assert all(peak_mps2(drops.trajectory, one) > 50.0 for one in known)
    bicycle = MOTION_SCENES["bicycle"].build(np.random.default_rng(5), 60.0)
    kerbs = [one for one in known_events(bicycle, 60.0) if one.kind == "impact"]
    assert all(peak_mps2(bicycle, one) > 15.0 for one in kerbs)
    assert len(kerbs) >= 2


def test_the_braking_ride_brakes_three_times():
    ride = SCENES["car-braking"](np.random.default_rng(1))
    known = known_events(ride.trajectory, ride.duration_s)
    braking = [one for one in known if one.kind == "braking" and one.is_clear]
    assert len(braking) == 3
    for one in braking:
        speeds = ride.trajectory.at(np.array([one.start_s, one.end_s])).velocity_mps
        before, after = np.linalg.norm(speeds, axis=1)
        assert before - after > 5.0


def test_taps_are_known_too():
    ride = SCENES["still"](np.random.default_rng(2))
    assert [one.start_s for one in known_taps(ride)] == [p.time_s for p in ride.pats]


@pytest.mark.parametrize(("kind", "expected"), [("turn", (2, 1, 2, 1)), ("fall", None)])
def test_scores_count_what_overlaps(kind, expected):
    known = [
        KnownEvent("turn", 1.0, 2.0),
        KnownEvent("turn", 5.0, 6.0),
        KnownEvent("turn", 8.0, 9.0, is_clear=False),
    ]
    found = [KnownEvent("turn", 1.9, 3.0), KnownEvent("turn", 20.0, 21.0)]
    wanted = Score(*expected) if expected else Score(0, 0, 0, 0)
    assert score(kind, found, known) == wanted
