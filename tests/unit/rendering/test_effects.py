"""Effects against closed forms; what is off changes nothing."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.rendering.effects import (
    EFFECTS,
    NO_EFFECTS,
    Effect,
    EffectList,
    Target,
    applied_to_force,
    applied_to_motion,
)
from hapticplayer.sequence.effects_file import effects_in, written

RATE_HZ = 200.0
TIME_S = np.arange(0.0, 20.0, 1.0 / RATE_HZ) + 0.0003
LIMIT_N = 100.0


def track_of(values: np.ndarray) -> ForceTrack:
    force = np.zeros((len(TIME_S), 3), np.float32)
    force[:, 1] = values
    return ForceTrack(TIME_S, force)


ONES = track_of(np.ones(len(TIME_S)))
SILENCE = track_of(np.zeros(len(TIME_S)))


def y_of(track: ForceTrack, effect: Effect, at_s: np.ndarray) -> np.ndarray:
    made = applied_to_force(track, EffectList((effect,)), LIMIT_N)
    return made.at(at_s)[:, 1]


INSIDE_S = np.arange(5.0, 9.0, 1e-3)[1:]


def test_gain_follows_its_curve():
    effect = Effect("gain", 5.0, 9.0, curve=((0.0, 1.0), (2.0, 3.0), (4.0, 1.0)))
    wanted = 1.0 + 2.0 * (1.0 - np.abs(INSIDE_S - 7.0) / 2.0)
    np.testing.assert_allclose(y_of(ONES, effect, INSIDE_S), wanted, atol=2e-6)


@pytest.mark.parametrize(("fade_in_s", "fade_out_s"), [(0, 0), (1, 0.5), (2, 2)])
def test_fades_take_half_their_length_from_a_pulse(fade_in_s, fade_out_s):
    parameters = {"amplitude": 2.0}
    effect = Effect(
        "pulse",
        5.0,
        9.0,
        fade_in_s=fade_in_s,
        fade_out_s=fade_out_s,
        parameters=parameters,
    )
    at_s = np.arange(4.0, 10.0, 1e-4)
    integral = np.trapezoid(y_of(SILENCE, effect, at_s), at_s)
    wanted = 2.0 * (4.0 - 0.5 * (fade_in_s + fade_out_s))
    assert integral == pytest.approx(wanted, abs=3e-3)


def test_a_ramp_is_a_straight_line():
    parameters = {"from_amplitude": -1.0, "to_amplitude": 3.0}
    effect = Effect("ramp", 5.0, 9.0, parameters=parameters)
    wanted = -1.0 + (INSIDE_S - 5.0)
    np.testing.assert_allclose(y_of(SILENCE, effect, INSIDE_S), wanted, atol=1e-5)


def test_a_sine_has_its_rms_and_its_frequency():
    effect = Effect(
        "sine", 5.0, 9.0, parameters={"amplitude": 2.0, "frequency_hz": 7.0}
    )
    found = y_of(SILENCE, effect, INSIDE_S)
    assert np.sqrt(np.mean(found**2)) == pytest.approx(2.0 / math.sqrt(2.0), rel=1e-3)
    assert np.count_nonzero(np.diff(np.sign(found))) == pytest.approx(2 * 7 * 4, abs=1)


def test_a_knock_decays_with_its_time_constant():
    parameters = {"amplitude": 3.0, "frequency_hz": 20.0, "decay_s": 0.2}
    effect = Effect("knock", 5.0, 9.0, parameters=parameters)
    crests_s = 5.0 + (0.25 + np.arange(8)) / 20.0
    wanted = 3.0 * np.exp(-(crests_s - 5.0) / 0.2)
    np.testing.assert_allclose(y_of(SILENCE, effect, crests_s), wanted, rtol=2e-3)


@pytest.mark.parametrize(
    ("kind", "cutoff_hz", "frequency_hz", "wanted"),
    [
        # forwards and backwards: the square of 1 / sqrt(1 + (f / fc)^4)
        ("low-pass", 5.0, 5.0, 0.5),
        ("low-pass", 5.0, 1.0, 1.0 / (1.0 + 0.2**4)),
        ("low-pass", 5.0, 20.0, 1.0 / (1.0 + 4.0**4)),
        ("high-pass", 2.0, 2.0, 0.5),
        ("high-pass", 2.0, 10.0, 1.0 / (1.0 + 0.2**4)),
        ("high-pass", 2.0, 0.5, 1.0 / (1.0 + 4.0**4)),
    ],
)
def test_filters_keep_the_phase_and_have_their_gain(
    kind, cutoff_hz, frequency_hz, wanted
):
    wave = np.sin(2.0 * np.pi * frequency_hz * TIME_S)
    effect = Effect(kind, 5.0, 15.0, parameters={"cutoff_hz": cutoff_hz})
    at_s = TIME_S[(TIME_S > 6.0) & (TIME_S < 14.0)]
    found = y_of(track_of(wave), effect, at_s)
    expected = wanted * np.sin(2.0 * np.pi * frequency_hz * at_s)
    np.testing.assert_allclose(found, expected, atol=0.012)


def test_noise_has_its_rms_its_band_and_its_seed():
    parameters = {"rms": 0.5, "low_hz": 5.0, "high_hz": 20.0, "seed": 3}
    effect = Effect("noise", 5.0, 15.0, parameters=parameters)
    at_s = np.arange(5.0, 15.0, 1e-3)
    found = y_of(SILENCE, effect, at_s)
    assert np.sqrt(np.mean(found**2)) == pytest.approx(0.5, rel=0.01)
    power = np.square(np.abs(np.fft.rfft(found)))
    frequency_hz = np.fft.rfftfreq(len(found), 1e-3)
    inside = power[(frequency_hz > 4.0) & (frequency_hz < 25.0)].sum()
    assert inside / power.sum() > 0.9
    np.testing.assert_array_equal(found, y_of(SILENCE, effect, at_s))
    other = replace(effect, parameters={**parameters, "seed": 4})
    assert abs(np.corrcoef(found, y_of(SILENCE, other, at_s))[0, 1]) < 0.3


def test_an_engine_turns_as_often_as_its_curve_says():
    effect = Effect(
        "engine", 5.0, 9.0, parameters={"amplitude": 1.5}, curve=((0, 10.0), (4, 30.0))
    )
    found = y_of(SILENCE, effect, INSIDE_S)
    turns = 10.0 * (INSIDE_S - 5.0) + 2.5 * (INSIDE_S - 5.0) ** 2
    phase = 2.0 * np.pi * turns
    wanted = np.sin(phase) + 0.5 * np.sin(2.0 * phase)
    np.testing.assert_allclose(found, wanted, atol=0.15)  # half a sample of phase
    assert np.sqrt(np.mean(found**2)) == pytest.approx(math.sqrt(0.625), rel=0.01)


def test_mute_leaves_silence_and_nothing_else():
    effect = Effect("mute", 5.0, 9.0)
    assert not y_of(ONES, effect, INSIDE_S).any()


@pytest.mark.parametrize("kind", EFFECTS, ids=lambda kind: kind.name)
def test_outside_of_its_span_an_effect_changes_nothing(kind):
    rng = np.random.default_rng(1)
    track = track_of(rng.normal(size=len(TIME_S)))
    effect = Effect(kind.name, 5.0, 9.0, fade_in_s=0.5, fade_out_s=0.5)
    made = applied_to_force(track, EffectList((effect,)), LIMIT_N)
    outside = (made.time_s < 5.0 - 0.002) | (made.time_s > 9.0 + 0.002)
    own = (TIME_S < 5.0 - 0.002) | (TIME_S > 9.0 + 0.002)
    np.testing.assert_array_equal(made.time_s[outside], TIME_S[own])
    np.testing.assert_array_equal(made.force_n[outside], track.force_n[own])
    at_s = np.arange(5.0, 9.0, 1e-3)
    assert np.abs(made.at(at_s) - track.at(at_s)).max() > 0.02


def test_disabled_or_motion_effects_return_the_track_itself():
    off = Effect("mute", 5.0, 9.0, enabled=False)
    motion = Effect("mute", 5.0, 9.0, Target.MOTION)
    for effects in (NO_EFFECTS, EffectList((off,)), EffectList((off, motion))):
        assert applied_to_force(ONES, effects) is ONES


def test_effects_are_applied_in_their_order():
    pulse = Effect("pulse", 5.0, 9.0)
    mute = Effect("mute", 5.0, 9.0)
    first = applied_to_force(ONES, EffectList((pulse, mute)))
    then = applied_to_force(ONES, EffectList((mute, pulse)))
    assert first.at(np.array([7.0]))[0, 1] == 0.0
    assert then.at(np.array([7.0]))[0, 1] == pytest.approx(1.0)


def test_force_keeps_to_its_limit_and_its_direction():
    effect = Effect("pulse", 5.0, 9.0, direction=(3, 0, 4), parameters={"amplitude": 9})
    made = applied_to_force(SILENCE, EffectList((effect,)), 4.5)
    found = made.at(np.array([7.0]))[0]
    np.testing.assert_allclose(found, [2.7, 0.0, 3.6], rtol=1e-6)


def test_a_motion_keeps_its_samples_and_stays_as_it_was():
    count = len(TIME_S)
    motion = MotionTrack(
        time_s=TIME_S,
        acceleration_mps2=np.ones((count, 3)),
        gravity_mps2=np.tile([0, 0, 9.8], (count, 1)),
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        accelerometer_gain=1.0,
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool),
    )
    effect = Effect("gain", 5.0, 9.0, Target.MOTION, parameters={"gain": 2.0})
    made = applied_to_motion(motion, EffectList((effect,)))
    inside = (TIME_S >= 5.0) & (TIME_S <= 9.0)
    np.testing.assert_allclose(made.acceleration_mps2[inside], 2.0)
    np.testing.assert_array_equal(made.acceleration_mps2[~inside], 1.0)
    np.testing.assert_array_equal(motion.acceleration_mps2, 1.0)


LIST = EffectList(
    (
        Effect("gain", 1.0, 2.0, fade_in_s=0.25, curve=((0.0, 1.0), (1.0, 2.0))),
        Effect("knock", 3.0, 4.0, direction=(1, 0, 0), parameters={"decay_s": 0.1}),
        Effect("low-pass", 5.0, 6.0, Target.MOTION, enabled=False),
    )
)


def test_a_list_is_the_same_after_writing_and_reading():
    assert effects_in(json.loads(json.dumps(written(LIST))), "effects.json") == LIST


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"kind": "explosion"}, r"effects\[1\]: effect 'explosion' not found"),
        ({"end_s": 0.5}, r"effects\[1\]: end_s: 0.5 s must come after"),
        ({"end_s": "4"}, r"effects\[1\].end_s: must be a number"),
        ({"end_s": float("nan")}, "end_s must be between 0 and"),
        ({"end_s": 9000.0}, "by 3600 s at most"),
        ({"fade_in_s": 3.0}, "must fit into the 1 s"),
        ({"fade_in_s": -0.1}, "fade_in_s must be between"),
        ({"parameters": {"decay_s": 99.0}}, "decay_s must be between 0.002 and 2 s"),
        ({"parameters": {"size": 1.0}}, "size: knock has no such parameter"),
        (
            {"parameters": {"decay_s": "a"}},
            r"effects\[1\].parameters.decay_s: must be a number",
        ),
        (
            {"target": "sound"},
            "target: 'sound' is not allowed; choose one of motion, force",
        ),
        ({"direction": [0, 0, 0]}, "direction: must be three numbers"),
        ({"direction": [1, 0]}, r"effects\[1\].direction: must have 3 entries"),
        ({"curve": [[0, 1]]}, "curve: knock takes 0 points"),
        ({"curve": [[0, 1], [1]]}, r"effects\[1\].curve\[1\]: must have 2 entries"),
        ({"colour": "red"}, r"effects\[1\]: unknown entry 'colour'; allowed: kind,"),
        ({"enabled": 1}, "enabled: must be true or false"),
    ],
)
def test_an_entry_that_is_wrong_is_named(change, said):
    content = written(LIST)
    content["effects"][1] |= change
    with pytest.raises(InputError, match=said):
        effects_in(content, "effects.json")


@pytest.mark.parametrize("content", [None, [], {}, {"schema": "x"}, {"effects": []}])
def test_another_file_is_refused(content):
    with pytest.raises(InputError, match="is not a list of effects"):
        effects_in(content, "effects.json")


def test_an_effect_moves_no_further_than_the_start():
    assert Effect("mute", 5.0, 9.0).moved(-7.0) == Effect("mute", 0.0, 4.0)
    with pytest.raises(UsageError):
        Effect("mute", 5.0, 4.0)
