"""The sound is felt at impacts of a slow log, and nowhere else."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import UsageError
from hapticplayer.model import Mapping, MotionTrack, Sampling
from hapticplayer.rendering import render_force
from hapticplayer.rendering.low_sound import LowSound
from hapticplayer.rendering.sound_layer import (
    SoundLayer,
    gain_of,
    layer_force,
    with_sound_layer,
)
from hapticplayer.sequence.presets import render_preset
from hapticplayer.simulation.rides.contact_sound import contact_sound, covered
from hapticplayer.simulation.rides.motion_scenes import MOTION_SCENES

BOARD_HZ, LENGTH_S, HIT_S = 30.0, 20.0, 8.0
MEDIA_S = np.arange(round(LENGTH_S * 1000)) / 1000.0


def motion(impact_mps2, sampling=Sampling.AVERAGED, rate_hz=BOARD_HZ):
    """Window means of a gentle sway with one impact of two windows at HIT_S."""
    time_s = (np.arange(round(LENGTH_S * rate_hz)) + 0.5) / rate_hz
    acceleration = np.zeros((len(time_s), 3))
    acceleration[:, 1] = 0.3 * np.sin(2.0 * time_s)
    first = round(HIT_S * rate_hz)
    acceleration[first : first + 2, 2] = [impact_mps2, -0.6 * impact_mps2]
    count = len(time_s)
    return MotionTrack(
        time_s, acceleration, np.tile([0.0, 0.0, 9.80665], (count, 1)), 1.0,
        np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)), None, np.ones(count, bool), sampling,
    )  # fmt: skip


def humming(level=0.3, gain=1.0):
    """A tone of 50 Hz all along."""
    tone = level * np.sin(2 * np.pi * 50.0 * MEDIA_S)
    return SoundLayer(LowSound(tone.astype(np.float32)), gain)


def is_near(time_s):
    return np.abs(time_s - HIT_S - 1.0 / BOARD_HZ) < 0.3


def test_a_hum_is_felt_at_the_impact_only():
    force = layer_force(motion(20.0), humming())
    assert not force[~is_near(MEDIA_S)].any()
    # 0.1 N for each m/s^2 would be more
    assert np.abs(force).max() == pytest.approx(0.5)
    # 50 Hz: the zero crossings are 10 ms apart
    felt = force[np.abs(MEDIA_S - HIT_S - 0.03) < 0.04]
    assert np.count_nonzero(np.diff(np.sign(felt))) == pytest.approx(8, abs=1)


def test_the_peak_follows_the_impact_not_the_loudness():
    loud, quiet = (layer_force(motion(4.0), humming(level)) for level in (0.9, 0.01))
    weaker = layer_force(motion(2.0), humming())
    assert np.abs(loud).max() == pytest.approx(np.abs(quiet).max(), rel=1e-3)
    assert np.abs(weaker).max() == pytest.approx(0.5 * np.abs(loud).max(), rel=0.05)
    half = layer_force(motion(4.0), humming(gain=0.5))
    np.testing.assert_allclose(half, 0.5 * layer_force(motion(4.0), humming()))


@pytest.mark.parametrize("cover", ["wind", "speech"])
def test_wind_and_speech_are_not_felt_without_impacts(cover, rng):
    sound = covered(0.01 * rng.standard_normal(len(MEDIA_S)), cover, 40.0, rng)
    assert np.std(sound.samples) > 0.5
    assert not layer_force(motion(0.0), SoundLayer(sound, 1.0)).any()
    assert not layer_force(motion(20.0), humming(level=0.0)).any()


def test_one_axis_changes_and_only_where_the_layer_is():
    moved = motion(6.0)
    plain = render_force(moved)
    made = with_sound_layer(plain, moved, humming())
    inside_s = MEDIA_S[500:-500]
    more = made.at(inside_s) - plain.at(inside_s)
    wanted = layer_force(moved, humming())[500:-500]
    assert np.abs(wanted).max() > 0.1
    assert np.abs(more[:, [0, 2]]).max() < 1e-6  # float32 of the entries
    np.testing.assert_allclose(more[:, 1], wanted, atol=1e-6)
    own = np.searchsorted(made.time_s, plain.time_s)
    far = ~is_near(plain.time_s)
    assert np.array_equal(made.force_n[own[far]], plain.force_n[far])


def test_limit_and_slew_of_the_contract_are_kept():
    made = with_sound_layer(render_force(motion(30.0)), motion(30.0), humming())
    assert made.peak_n() <= 4.5 + 1e-6
    # 0.5 N at 120 Hz slews 0.38 N in a millisecond, lines of the track less
    plain = render_force(motion(1.5))
    steps = np.diff(with_sound_layer(plain, motion(1.5), humming()).at(MEDIA_S), axis=0)
    assert np.abs(steps).max() < 1.0


def test_the_layer_is_recorded_and_comes_before_the_washout():
    made = render_preset(motion(8.0), name="equal", sound=humming(gain=0.7))
    assert made.provenance["sound_layer"] == {
        "gain": 0.7,
        "band_hz": [20.0, 120.0],
        "limit_n": 0.5,
    }
    assert gain_of(made) == 0.7
    assert gain_of(render_preset(motion(8.0), name="equal")) == 0.0
    assert "washout" in made.provenance
    direct = render_preset(motion(8.0), name="faithful", sound=humming(gain=0.7))
    fast = np.diff(made.at(MEDIA_S)[:, 1], 2), np.diff(direct.at(MEDIA_S)[:, 1], 2)
    assert np.abs(fast[0]).max() == pytest.approx(np.abs(fast[1]).max(), rel=0.1)


def test_a_log_that_is_fast_or_not_averaged_is_refused():
    for moved in (motion(5.0, rate_hz=200.0), motion(5.0, Sampling.INSTANT)):
        with pytest.raises(UsageError, match="holds the shaking itself"):
            with_sound_layer(render_force(moved), moved, humming())


def test_the_limit_of_a_mapping_is_kept():
    moved = motion(20.0)
    mapping = Mapping(force_limit_n=1.0)
    made = render_preset(moved, mapping, name="faithful", sound=humming())
    assert made.peak_n() <= 1.0 + 1e-6


def test_a_contact_sound_is_loudest_where_the_ride_is_rough():
    ride = MOTION_SCENES["bicycle"].build(np.random.default_rng(3), 40.0)
    sound = contact_sound(ride, 40.0, np.random.default_rng(4))
    assert len(sound) == 40_000
    assert np.std(sound) == pytest.approx(0.1)
    time_s = np.arange(40_000) / 1000.0
    rough = np.linalg.norm(ride.at(time_s).acceleration_mps2, axis=1)
    seconds = [np.sqrt(np.square(v).reshape(-1, 1000).mean(1)) for v in (sound, rough)]
    assert np.corrcoef(*seconds)[0, 1] > 0.5
    again = contact_sound(ride, 40.0, np.random.default_rng(4))
    assert np.array_equal(sound, again)


def test_the_gain_of_a_track_without_a_layer_is_none():
    track = dataclasses.replace(render_force(motion(1.0)), provenance={})
    assert gain_of(track) == 0.0
