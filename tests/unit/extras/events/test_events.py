"""Events are found in motions of closed form, and in rides that are known."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.extras.events.detectors import DETECTORS, find_events
from hapticplayer.extras.events.inputs import EventInputs, LowSound, low_sound, over
from hapticplayer.extras.events.shocks import find_shocks
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack
from hapticplayer.model import quaternions as quat
from hapticplayer.motion import remove_gravity
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.rendering.effects.values import MAX_EFFECT_S
from hapticplayer.sequence.effects_file import effects_in, written
from hapticplayer.sequence.events import events_of
from tests.material.known_events import known_events, score

RATE_HZ, LENGTH_S = 200.0, 20.0
TIME_S = np.arange(round(LENGTH_S * RATE_HZ)) / RATE_HZ
UP = [0.0, 0.0, STANDARD_GRAVITY_MPS2]


def motion_of(acceleration, yaw_rad=None):
    """A motion in frame A of a level sensor with a heading."""
    count = len(TIME_S)
    yaw = np.zeros(count) if yaw_rad is None else yaw_rad
    turned = quat.from_rotation_vector(np.outer(yaw, [0.0, 0.0, 1.0]))
    return MotionTrack(
        TIME_S, acceleration, np.tile(UP, (count, 1)), 1.0, turned, None,
        np.ones(count, bool),
    )  # fmt: skip


def along(axis, values):
    acceleration = np.zeros((len(TIME_S), 3))
    acceleration[:, axis] = values
    return acceleration


def log_of(acceleration, rate_radps=0.0):
    rate = np.tile([0.0, 0.0, rate_radps], (len(TIME_S), 1))
    return ImuLog(TIME_S, acceleration + UP, rate)


def blow(at_s, peak_mps2, length_s=0.05):
    phase = (TIME_S - at_s) / length_s
    return peak_mps2 * np.where((phase > 0) & (phase < 1), np.sin(np.pi * phase), 0.0)


def level(first_s, last_s, mps2, edge_s=0.5):
    from hapticplayer.extras.rides.trajectory import smooth_step

    rise = smooth_step(TIME_S, first_s, edge_s)
    return mps2 * (rise - smooth_step(TIME_S, last_s, edge_s))


def found(kind, motion, imu=None, sound=None):
    return list(find_events(motion, imu, sound, kinds=[kind]))


def test_a_single_blow_is_an_impact_with_a_knock_at_it():
    (event,) = found("impact", motion_of(along(2, blow(8.0, 20.0))))
    assert event.start_s < 8.025 < event.end_s
    assert event.end_s - event.start_s < 0.3
    assert event.confidence > 0.9
    assert event.effect.kind == "knock"
    # a half sine is symmetric about its middle, and so is zero phase
    assert event.effect.start_s == pytest.approx(8.025, abs=0.02)


def test_regular_steps_are_no_impacts():
    steps = sum(blow(at_s, 20.0) for at_s in np.arange(0.25, 20.0, 0.5))
    assert found("impact", motion_of(along(2, steps))) == []


def test_steps_that_begin_are_no_impacts():
    steps = sum(blow(at_s, 8.0, 0.1) for at_s in np.arange(10.0, 20.0, 0.4))
    assert found("impact", motion_of(along(2, steps))) == []


def test_a_brake_that_is_applied_fast_is_no_impact():
    assert found("impact", motion_of(along(1, -level(8.0, 11.0, 6.0, 0.35)))) == []


def test_a_landing_is_found_in_rough_ground(rng):
    ground = np.convolve(rng.standard_normal(len(TIME_S)), np.ones(8) / 8, "same")
    ground *= 4.0 / ground.std()
    in_air = level(10.0, 10.4, -9.5, 0.08) + level(10.48, 10.68, 18.6, 0.08)
    assert found("impact", motion_of(along(2, ground))) == []
    (event,) = found("impact", motion_of(along(2, ground + in_air)))
    assert event.start_s < 10.7
    assert event.end_s > 10.4


def test_a_landing_is_told_from_a_blow(rng):
    ground = np.convolve(rng.standard_normal(len(TIME_S)), np.ones(8) / 8, "same")
    ground *= 4.0 / ground.std()
    in_air = level(10.0, 10.4, -9.5, 0.08) + level(10.48, 10.68, 18.6, 0.08)
    for moved, expected in ((in_air, True), (blow(8.0, 60.0), False)):
        (shock,) = find_shocks(
            EventInputs(motion_of(along(2, ground + moved)), None, None)
        )
        assert shock.is_landing is expected


def test_a_release_into_a_fall_is_no_impact():
    fall = level(10.0, 10.5, -9.8, 0.03)
    caught = fall + level(10.53, 10.6, 68.0, 0.03)
    starts_s = [one.start_s for one in found("impact", motion_of(along(2, caught)))]
    assert min(starts_s) > 10.3


def test_a_weak_blow_counts_if_it_is_heard(rng):
    noise = 0.4 * rng.standard_normal((len(TIME_S), 3))
    motion = motion_of(noise + along(2, blow(8.0, 4.5)))
    sound = 0.01 * rng.standard_normal(20_000)
    assert found("impact", motion, sound=LowSound(sound.astype(np.float32))) == []
    sound[8000:8060] += np.sin(0.5 * np.arange(60))
    (event,) = found("impact", motion, sound=LowSound(sound.astype(np.float32)))
    assert event.start_s < 8.025 < event.end_s
    assert "heard" in event.text


def test_a_sound_that_is_always_heard_confirms_no_event(rng):
    motion = motion_of(
        0.4 * rng.standard_normal((len(TIME_S), 3)) + along(2, blow(8.0, 4.5))
    )
    sound = 0.01 * rng.standard_normal(20_000)
    for first in range(0, 20_000, 400):
        sound[first : first + 60] += np.sin(0.5 * np.arange(60))
    assert found("impact", motion, sound=LowSound(sound.astype(np.float32))) == []


def test_braking_says_how_hard_and_how_much():
    (event,) = found("braking", motion_of(along(1, -level(8.0, 10.5, 4.0))))
    assert event.text.values["level_mps2"] == pytest.approx(4.0, abs=0.15)
    # a trapezoid of 4 m/s^2 over 2.5 s; what is below half of 0.3 g is not counted
    assert event.text.values["change_mps"] == pytest.approx(10.0, rel=0.1)
    assert (event.start_s, event.end_s) == pytest.approx((8.2, 10.8), abs=0.2)
    assert event.effect.kind == "gain"


@pytest.mark.parametrize("mps2", [-2.0, 4.0])
def test_gentle_braking_and_starting_are_none(mps2):
    assert found("braking", motion_of(along(1, level(8.0, 10.5, mps2)))) == []


def test_a_waving_hand_does_not_brake():
    waving = 5.0 * np.sin(2.0 * np.pi * 0.9 * TIME_S)
    assert found("braking", motion_of(along(1, waving))) == []


@pytest.mark.parametrize(("side", "word"), [(1.0, "left"), (-1.0, "right")])
def test_a_bend_at_10_mps_is_a_turn_to_its_side(side, word):
    lateral = level(8.0, 12.0, 3.0)
    yaw = side * np.cumsum(lateral) / RATE_HZ / 10.0
    (event,) = found("turn", motion_of(along(0, -side * lateral), yaw))
    assert word in event.text
    assert event.text.values["level_mps2"] == pytest.approx(3.0, abs=0.1)
    assert (event.start_s, event.end_s) == pytest.approx((8.2, 12.3), abs=0.25)


def test_a_push_sideways_without_a_bend_is_no_turn():
    assert found("turn", motion_of(along(0, level(8.0, 12.0, 3.0)))) == []


def test_stillness_ends_where_motion_begins():
    shaken = along(2, np.where(TIME_S > 6.0, 2.0 * np.sin(20.0 * TIME_S), 0.0))
    (event,) = found("stillness", motion_of(shaken), log_of(shaken))
    assert event.start_s == pytest.approx(0.0, abs=0.01)
    assert event.end_s == pytest.approx(6.0, abs=0.5)  # found in windows of 1 s


def test_an_even_push_is_not_stillness():
    pushed = along(1, np.full(len(TIME_S), 1.0))
    assert found("stillness", motion_of(pushed), log_of(pushed)) == []


def test_a_clipped_sensor_is_found_in_its_log_only():
    wave = along(0, 40.0 * np.sin(2.0 * np.pi * 0.5 * TIME_S))
    clipped = dataclasses.replace(
        log_of(wave), specific_force_mps2=np.clip(wave + UP, -19.6, 19.6)
    )
    events = found("saturation", motion_of(wave), clipped)
    assert len(events) == 20  # twice in each of ten periods
    # from asin(0.49) to pi less that, at pi radians a second
    assert events[0].start_s == pytest.approx(np.arcsin(0.49) / np.pi, abs=0.01)
    assert events[0].end_s == pytest.approx(1.0 - np.arcsin(0.49) / np.pi, abs=0.01)
    assert found("saturation", motion_of(wave)) == []


def test_a_gap_and_a_spike_are_artefacts_and_no_impact():
    smooth = along(2, np.sin(2.0 * TIME_S))
    imu = log_of(smooth)
    force = imu.specific_force_mps2.copy()
    force[1000, 0] += 40.0
    keep = (TIME_S < 14.0) | (TIME_S > 14.2)
    imu = ImuLog(TIME_S[keep], force[keep], imu.angular_rate_radps[keep])
    spiky = smooth.copy()
    spiky[1000, 0] += 40.0
    spike, gap = found("artefact", motion_of(spiky), imu)
    assert spike.start_s == spike.end_s == 5.0
    assert spike.effect.start_s < 5.0 < spike.effect.end_s
    assert (gap.start_s, gap.end_s) == pytest.approx((14.0, 14.2), abs=0.011)
    assert found("impact", motion_of(spiky), imu) == []


def test_events_are_offered_and_change_nothing():
    motion = motion_of(along(2, blow(8.0, 20.0)))
    before = motion.acceleration_mps2.copy()
    events = find_events(motion)
    assert np.array_equal(motion.acceleration_mps2, before)
    assert all(0.5 <= one.confidence <= 1.0 for one in events)
    assert all(one.effect.end_s > one.effect.start_s for one in events)


def test_effects_of_events_go_into_a_list_as_they_are():
    imu = log_of(along(2, blow(8.0, 20.0)))
    events = find_events(motion_of(along(2, blow(8.0, 20.0))), imu)
    effects = EffectList(tuple(one.effect for one in events))
    assert {one.kind for one in effects.effects} == {"knock", "mute"}
    assert effects_in(written(effects), "here") == effects
    assert over("gain", (10.0, 12.0), 0.5) == Effect(
        "gain", 9.5, 12.5, fade_in_s=0.5, fade_out_s=0.5
    )
    assert over("gain", (0.2, 9e3), 0.5).duration_s <= MAX_EFFECT_S


def test_events_before_the_clip_are_found_too():
    motion = motion_of(along(2, blow(8.0, 20.0)))
    early = dataclasses.replace(motion, time_s=TIME_S - 15.0)
    log = log_of(along(2, blow(8.0, 20.0)))
    events = find_events(early, dataclasses.replace(log, time_s=TIME_S - 15.0))
    kinds = [one.kind for one in events]
    assert kinds == ["stillness", "impact", "stillness"]
    assert events[1].start_s == pytest.approx(-7.0, abs=0.1)
    assert all(one.effect.start_s >= 0.0 for one in events)


def test_an_event_is_cut_to_its_clip():
    (event,) = found("stillness", motion_of(along(0, np.zeros(len(TIME_S)))))
    cut = event.within(0.3)
    assert (cut.start_s, cut.end_s) == (0.0, 0.3)
    assert cut.effect.end_s == 0.3
    assert cut.effect.fade_in_s == cut.effect.fade_out_s <= 0.15


def test_an_effect_that_would_begin_after_the_clip_ends_in_it():
    (event,) = found("impact", motion_of(along(2, blow(8.0, 20.0))))
    cut = event.within(8.0)
    assert cut.effect.end_s == 8.0
    assert cut.effect.start_s == pytest.approx(7.999)
    assert (cut.start_s, cut.end_s) == (event.start_s, 8.0)


def test_unknown_kinds_and_empty_motions_are_refused():
    motion = motion_of(along(0, np.zeros(len(TIME_S))))
    with pytest.raises(UsageError, match="kind of event 'crash' not found"):
        events_of("nowhere", kinds=["crash"])
    with pytest.raises(InputError, match="no motion"):
        find_events(motion.part(slice(0, 1)))


def test_low_sound_keeps_50_hz_and_drops_2000():
    time_s = np.arange(32_000) / 16_000.0
    kept = low_sound(np.sin(2 * np.pi * 50.0 * time_s), 16_000.0)
    gone = low_sound(np.sin(2 * np.pi * 2000.0 * time_s), 16_000.0)
    assert len(kept.samples) == 2000
    middle = slice(200, 1800)
    expected = np.sin(2 * np.pi * 50.0 * np.arange(2000) / 1000.0)
    np.testing.assert_allclose(kept.samples[middle], expected[middle], atol=2e-3)
    assert np.abs(gone.samples[middle]).max() < 2e-3
    np.testing.assert_allclose(
        kept.band(20.0, 120.0)[middle], expected[middle], atol=0.03
    )


@pytest.mark.parametrize(
    ("ride", "sensor"), [("bicycle", "camera"), ("car-hard", "paper-board")]
)
def test_known_rides_have_their_events(ride, sensor):
    from hapticplayer.extras.rides.motion_scenes import simulate_motion

    made = simulate_motion(ride, 3, duration_s=60.0, sensor=sensor)
    known = known_events(made.trajectory, 60.0)
    events = find_events(remove_gravity(made.imu), made.imu)
    scores = [score(one, events, known) for one in DETECTORS]
    assert sum(one.known for one in scores) >= 8
    assert sum(one.hit for one in scores) >= 0.9 * sum(one.known for one in scores)
    assert sum(one.right for one in scores) >= 0.9 * sum(one.found for one in scores)
