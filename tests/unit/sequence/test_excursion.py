"""Where a track would push a hand: the quick prediction against the full physics."""

import json
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from hapticplayer.cli.process import quality_text
from hapticplayer.devices.dynamics import RELAXED
from hapticplayer.haptics.centring import Centring, centring_force
from hapticplayer.haptics.limiter import Limits
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.excursion import (
    HANDS,
    Grip,
    excursion_texts,
    predict,
    stored_texts,
)
from hapticplayer.sequence.process_report import describe_quality
from hapticplayer.sequence.processing import (
    Processing,
    process_motion,
)

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "faults"))

from hand_cases import Trial
from hand_tracks import excerpt, steady_push, track


def quiet(duration_s=60.0):
    return ForceTrack([0.0, duration_s], np.zeros((2, 3)))


@pytest.mark.parametrize(
    ("name", "begin_s", "end_s"),
    [("bike", 2.5, 5.5), ("horse", 0.0, 3.0), ("turning", 0.0, 4.0),
     ("braking", 13.5, 17.5)],
)  # fmt: skip
@pytest.mark.parametrize("hand", ["relaxed", "firm"])
def test_the_prediction_agrees_with_the_full_physics(name, begin_s, end_s, hand):
    part = excerpt(track(name), begin_s, end_s)
    duration_s = end_s - begin_s - 0.02
    trial = Trial(part, HANDS[hand]).run(duration_s)
    found = predict(part, duration_s).hands[hand]
    assert found.reach == pytest.approx(trial.reach, abs=0.02)
    radii = np.array(trial.radii_m) / 0.04
    assert found.far_share == pytest.approx(np.mean(radii > 0.6), abs=0.02)
    assert found.trip is None
    assert trial.trips == []


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_steady_push_goes_where_spring_fade_and_pull_balance(axis):
    found = predict(steady_push(3.0, axis, 8.0), 8.0).hands
    balance = [abs(Limits().workspace_m * one.reach) for one in found.values()]
    for radius_m, hand in zip(balance, HANDS.values(), strict=True):
        fade = min(1.0, max(0.0, (radius_m - 0.024) / 0.012))
        pull = -centring_force((radius_m, 0.0, 0.0), Centring())[0]
        held = hand.stiffness_n_per_m * radius_m + pull
        # beyond by a little: it swings past before it rests there
        assert held == pytest.approx(3.0 * (1.0 - fade), rel=0.15)


def test_seconds_computed_side_by_side_are_those_of_one_long_run():
    whole = track("braking")
    found = predict(whole, 18.0).hands["relaxed"]
    grip = Grip([RELAXED], Limits(), Centring())
    grip.rest(1)
    time_s = np.arange(0.0, 18.0, 0.002)
    force = whole.at(time_s) * np.minimum(1.0, time_s / 0.2)[:, None]
    radii = [float(grip.advance(f[:, None])[0, 0]) for f in force]
    assert found.reach == pytest.approx(max(radii), abs=1e-3)
    assert found.reach_at_s == pytest.approx(np.argmax(radii) * 0.002, abs=0.01)
    assert found.far_share == pytest.approx(np.mean(np.array(radii) > 0.6), abs=2e-3)


def test_a_hand_that_gives_way_does_as_in_the_full_physics():
    yielding = replace(RELAXED, yield_s=0.3, return_s=2.0)
    grip = Grip([yielding, RELAXED], Limits(), Centring())
    push = steady_push(1.5, 0, 5.0)
    trial = Trial(push, yielding).run(4.9)
    time_s = np.arange(0.0, 4.9, 0.002)
    force = push.at(time_s) * np.minimum(1.0, time_s / 0.2)[:, None]
    radii = np.array([grip.advance(one[:, None])[:, 0] for one in force])
    assert radii[:, 0].max() == pytest.approx(trial.reach, abs=0.02)
    assert radii[-1, 0] > 1.5 * radii[-1, 1]
    assert np.linalg.norm(grip.sent_n[:, 0, 0] - trial.sent_n[-1]) < 0.05


def test_a_lower_cap_is_sent():
    grip = Grip([RELAXED], Limits(), Centring())
    grip.cap_n = np.array([[1.0]])
    grip.advance(np.array([[0.0], [3.0], [4.0]]))
    assert grip.sent_n[:, 0, 0] == pytest.approx([0.0, 0.6, 0.8])


def test_a_blow_that_no_hand_can_hold_is_a_trip():
    blow = ForceTrack([0.0, 1.0, 1.001, 1.2, 1.201, 2.0], np.zeros((6, 3)))
    force = np.zeros((6, 3))
    force[2:4, 0] = 4.5
    blow = ForceTrack(blow.time_s, force)
    weak = type(RELAXED)(0.02, 10.0, 0.2)
    grip = Grip([weak], Limits(speed_mps=0.3), Centring())
    grip.rest(1)
    fast = []
    for at_s in np.arange(0.0, 2.0, 0.002):
        grip.advance(blow.at(np.array([at_s])).T)
        fast.append(bool(grip.is_fast[0, 0]))
    assert 0.002 * fast.index(True) == pytest.approx(1.03, abs=0.03)
    assert predict(blow, 2.0).hands["firm"].trip is None


def test_the_motors_load_is_the_hottest_ten_seconds():
    pause = ForceTrack(
        [0.0, 20.0, 20.001, 60.0], [[0, 3, 0], [0, 3, 0], [0] * 3, [0] * 3]
    )
    found = predict(pause, 60.0)
    expected = 3.0 * math.sqrt(1.0 - math.exp(-2.0))
    assert found.rms_10s_n == pytest.approx(expected, rel=0.01)
    assert found.thermal_share == pytest.approx(expected / 3.0, rel=0.01)


# --- cost, progress, ends ----------------------------------------------------


class StoppedError(Exception):
    pass


def test_a_track_without_force_is_not_computed():
    progress = []
    found = predict(quiet(3600.0), 3600.0, progress.append)
    assert progress == []
    assert found.hands["relaxed"].reach == 0.0
    assert found.rms_10s_n == 0.0


def test_the_progress_rises_and_can_stop_the_work():
    progress = []
    predict(track("bike"), 20.0, progress.append)
    assert progress == sorted(progress)
    assert 0.0 <= progress[0] < progress[-1] <= 1.0

    def stop(share):
        raise StoppedError

    with pytest.raises(StoppedError):
        predict(track("bike"), 20.0, stop)


def test_a_minute_takes_so_many_steps_and_no_more(monkeypatch):
    """The cost is that of the steps: a minute's seconds go side by side."""
    steps, advance = [], Grip.advance
    monkeypatch.setattr(
        Grip, "advance", lambda grip, f: steps.append(f.shape) or advance(grip, f)
    )
    sway = 2.0 * np.sin(np.arange(0.0, 60.0, 0.01))
    minute = ForceTrack(np.arange(len(sway)) / 100.0, np.stack([sway] * 3, axis=1))
    predict(minute, 60.0)
    assert len(steps) <= 1200
    assert steps[0][1] <= 62


def test_only_what_is_played_counts():
    late = steady_push(4.5, 0, 10.0)
    assert predict(late, 0.3).hands["relaxed"].reach == 0.0
    held = ForceTrack([0.0, 1.0], [[0, 0, 0], [0, 4, 0]], Reconstruction.HOLD)
    assert predict(held, 5.0).hands["relaxed"].reach > 0.5


# --- what is said ------------------------------------------------------------


def test_only_a_strong_track_gets_a_notice():
    assert excursion_texts(predict(quiet(), 60.0)) == []
    text, _heat = excursion_texts(predict(steady_push(4.5, 0, 4.0), 4.0))
    assert text.startswith("this track would reach 6")
    assert "% of the workspace with a relaxed hand" in text


def test_a_trip_is_reported_instead():
    found = predict(quiet(), 60.0)
    trip = structs.replace(found.hands["normal"], trip="runaway", trip_at_s=12.34)
    found = structs.replace(found, hands={**found.hands, "normal": trip})
    assert excursion_texts(found) == [
        "this track would move a normal hand so far that the device trips (runaway) at 12.3 s"
    ]


def test_a_sequence_keeps_its_prediction(sequence_folder):
    sequence = open_sequence(sequence_folder)
    kept = sequence.description.feedbacks
    again = predict(sequence.tracks["realistic"], sequence.duration_s)
    assert kept["realistic"].excursion == again
    assert set(kept["random"].excursion.hands) == {"relaxed", "normal", "firm"}
    assert stored_texts(sequence.description, "realistic") == []
    far = structs.replace(again.hands["relaxed"], reach=0.96)
    strong = structs.replace(again, hands={**again.hands, "relaxed": far})
    entry = structs.replace(kept["realistic"], excursion=strong)
    changed = structs.replace(
        sequence.description, feedbacks={**kept, "realistic": entry}
    )
    (text,) = stored_texts(changed, "realistic")
    assert "would reach 96 % of the workspace with a relaxed hand" in text


def test_a_clip_without_a_prediction_has_no_warnings(sequence_folder):
    description = open_sequence(sequence_folder).description
    assert stored_texts(None, "realistic") == []
    assert stored_texts(description, "none") == []
    assert stored_texts(description, "another") == []


def test_the_quality_report_has_figures_and_words(swing, recording):
    processed = process_motion(swing[0], Processing())
    report = describe_quality(recording, processed)
    reach = report["excursion"]["hands"]["relaxed"]["reach"]
    assert 0.1 < reach < 0.6
    json.dumps(report, allow_nan=False)
    text = quality_text(report)
    assert f"relaxed {100.0 * reach:.0f} %" in text
    assert "N over 10 s at most" in text
