"""Feedback conditions that are made of realistic tracks."""

from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.rendering import (
    FEEDBACKS,
    ConditionInputs,
    chosen_feedback,
    condition_named,
)
from hapticplayer.rendering.derived import BLEND_S, shuffled


def noise(rng, seconds, rms_n=(0.5, 1.0, 0.1), start_s=0.0):
    t = np.arange(0.0, seconds, 0.01)
    return ForceTrack(start_s + t, rng.standard_normal((len(t), 3)) * rms_n)


def made(text, of, **more):
    chosen = chosen_feedback(text)
    return condition_named(chosen.name).track(
        ConditionInputs(of, **more), chosen.parameters
    )


@pytest.mark.parametrize("reconstruction", list(Reconstruction))
def test_delayed_is_the_same_force_later_and_early_if_negative(rng, reconstruction):
    whole = noise(rng, 3.0)
    whole = ForceTrack(whole.time_s, whole.force_n, reconstruction)
    at_s = 1.0 + 0.01 * np.arange(150) + 0.004  # never where a held value changes
    for delay_s in (0.3, -0.3):
        late = made(f"delayed:delay_s={delay_s}", whole)
        assert late.at(at_s) == pytest.approx(whole.at(at_s - delay_s), abs=1e-5)
        assert late.reconstruction is reconstruction


def test_inverted_and_scaled_keep_times(rng):
    whole = noise(rng, 1.0)
    for text, factor in (("inverted", -1.0), ("scaled:gain=1.5", 1.5)):
        track = made(text, whole)
        assert np.array_equal(track.time_s, whole.time_s)
        assert track.force_n == pytest.approx(factor * whole.force_n, rel=1e-6)


@pytest.mark.parametrize("seconds", [90.0, 7.0])  # cut, and repeated
def test_shuffled_has_the_span_and_rms_of_this_clip(rng, seconds):
    own = noise(rng, 30.0, start_s=-0.5)
    track = made("shuffled", own, other=lambda _: noise(rng, seconds, (3, 2, 1)))
    assert track.rms_n() == pytest.approx(own.rms_n(), rel=1e-4)
    assert track.time_s[[0, -1]] == pytest.approx(own.time_s[[0, -1]])


def test_a_longer_clip_is_shuffled_as_it_is_but_for_the_gain():
    t = np.arange(0.0, 40.0, 0.005)
    other = ForceTrack(5.0 + t, np.sin(t)[:, None] * [1.0, 2.0, 0.5])
    own = ForceTrack([0.0, 20.0], np.full((2, 3), 0.3))
    track = shuffled(own, other)
    gain = np.array(track.provenance["gain_per_axis"])
    # RMS of sin over 0 to 20 s: sqrt(1/2 - sin(40)/80)
    rms = np.sqrt(0.5 - np.sin(40.0) / 80.0) * np.array([1.0, 2.0, 0.5])
    assert gain == pytest.approx(0.3 / rms, rel=1e-3)
    at_s = np.array([0.5, 7.0, 19.0])
    assert track.at(at_s) == pytest.approx(gain * other.at(5.0 + at_s), abs=1e-4)


def test_a_shorter_clip_is_repeated_without_a_jump():
    t = np.arange(0.0, 10.0, 0.005)
    ramp = np.linspace(1.0, 2.0, len(t))[:, None] * [1.0, 1.0, 1.0]
    own = ForceTrack([0.0, 30.0], np.ones((2, 3)))
    track = shuffled(own, ForceTrack(t, ramp))
    # back from 2 to 1 within the blend, and 0.1 N/s otherwise, times the gain
    slope = (
        np.abs(np.diff(track.force_n[:, 0]))
        * 200.0
        / track.provenance["gain_per_axis"][0]
    )
    assert slope.max() < 1.1 / BLEND_S
    assert slope[: 8 * 200] == pytest.approx(0.1, rel=0.05)


def test_an_axis_without_force_cannot_be_shuffled():
    own = ForceTrack([0.0, 1.0], np.ones((2, 3)))
    with pytest.raises(InputError, match="no force along an axis"):
        shuffled(own, ForceTrack([0.0, 1.0], np.tile([1.0, 1.0, 0.0], (2, 1))))


def test_a_preset_and_an_edited_track_are_asked_for_by_name(rng):
    whole, asked = noise(rng, 1.0), []

    def found(*wanted):
        asked.append(wanted)
        return whole

    of = {"rendered": found, "stored": found}
    assert made("realistic:preset=equal", whole, **of) is whole
    assert made("realistic:effects=off", whole, **of) is whole
    assert made("edited:track=mine, 2", whole, **of) is whole
    assert asked == [("equal", True), ("", False), ("mine, 2",)]
    assert made("realistic", whole) is whole
    with pytest.raises(UsageError, match="no effect is switched on"):
        made("edited", whole, **of)
    edited = replace(whole, provenance={"effects": [{"kind": "mute"}]})
    assert made("edited", edited) is edited
    with pytest.raises(UsageError, match="needs the sequence"):
        made("realistic:preset=equal", whole)


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("delayed:delay_s=9", "between -5 and 5 s, not 9"),
        ("delayed:delay_s=nan", "between"),
        ("delayed:delay=1", "no parameter 'delay'; it has delay_s"),
        ("inverted:by=1", "has no parameters"),
        ("scaled:2", "write NAME=VALUE"),
        ("realistic:preset=best", "one of faithful, balanced, equal"),
    ],
)
def test_a_wrong_parameter_says_what_is_allowed(text, what):
    with pytest.raises(UsageError, match=what):
        chosen_feedback(text)


def test_defaults_are_allowed_values():
    for condition in FEEDBACKS:
        for one in condition.parameters:
            if one.default != "":
                assert one.check(one.default) == one.default
