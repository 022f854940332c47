"""What every method owes its caller, whatever it is made of."""

import dataclasses
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion import (
    DEFAULT_METHOD,
    METHODS,
    EkfParameters,
    SmootherParameters,
    analyse,
    estimate_orientation,
    remove_gravity,
)

WITH_HEADING = ("ekf", "vqf", "offline-vqf")
EARTH_FIELD_UT = (0.0, 20.0, -44.0)
"""Of central Europe: x east, y north, z up."""


def nod_and_turn(t):
    """Return a hand's attitude; it looks around by 1.5 rad and nods by 0.5."""
    angles = [1.5 * np.sin(0.4 * t) + 0.8, 0.5 * np.sin(1.1 * t), 0.3 * np.sin(1.7 * t)]
    return Rotation.from_euler("ZYX", np.stack(angles, axis=1))


def looking_around(seconds=60.0, rate_hz=100.0):
    """Return (log with a magnetometer, its attitude)."""
    t = np.arange(1, seconds * rate_hz + 1) / rate_hz
    before, at = nod_and_turn(t - 1 / rate_hz), nod_and_turn(t)
    waves = [0.5 * np.sin(5.0 * t), 0.6 * np.cos(7.0 * t), 0.4 * np.sin(11.0 * t)]
    earth = np.array([0.0, 0.0, G]) + np.stack(waves, axis=1)
    log = ImuLog(
        t,
        at.inv().apply(earth),
        rate_hz * (before.inv() * at).as_rotvec(),
        magnetic_field_ut=at.inv().apply(EARTH_FIELD_UT),
    )
    return log, at


def test_the_methods_are_those_that_are_promised():
    assert {"ekf", "smoother", "vqf", "offline-vqf", "lowpass"} <= set(METHODS)
    assert DEFAULT_METHOD == "smoother"


# ---- heading --------------------------------------------------------------------


def heading_errors_deg(log, attitude, method):
    """Return the angle about earth's vertical by which the answer is off."""
    q = estimate_orientation(log, method, heading=True)
    error = Rotation.from_quat(q, scalar_first=True) * attitude.inv()
    _, _, z, w = error.as_quat().T
    angle = 2.0 * np.arctan2(z, w)
    return np.degrees((angle + np.pi) % (2.0 * np.pi) - np.pi)


@pytest.mark.parametrize("method", WITH_HEADING)
def test_with_a_magnetometer_north_is_north(method):
    log, attitude = looking_around()
    error = heading_errors_deg(log, attitude, method)
    # causal filters need some seconds to turn to it
    assert np.abs(error[2000:]).max() < 3.0


@pytest.mark.parametrize("method", WITH_HEADING)
def test_without_being_asked_for_it_the_heading_costs_nothing(method):
    log, _ = looking_around(10.0)
    bare = dataclasses.replace(log, magnetic_field_ut=None)
    with_field = estimate_orientation(log, method)
    assert np.array_equal(with_field, estimate_orientation(bare, method))


@pytest.mark.parametrize("method", WITH_HEADING)
def test_the_vertical_is_the_same_with_and_without_heading(method):
    log, attitude = looking_around(30.0)
    up = attitude.inv().apply([0.0, 0.0, 1.0])
    for heading in (False, True):
        q = estimate_orientation(log, method, heading=heading)
        got = Rotation.from_quat(q, scalar_first=True).inv().apply([0.0, 0.0, 1.0])
        assert np.linalg.norm(got - up, axis=1)[500:].max() < 0.02


@pytest.mark.parametrize("method", WITH_HEADING)
def test_a_heading_on_uneven_times_is_found_as_well(method, rng):
    log, attitude = looking_around(40.0)
    keep = np.sort(rng.choice(len(log), round(0.9 * len(log)), replace=False))
    names = ("time_s", "specific_force_mps2", "angular_rate_radps", "magnetic_field_ut")
    thinned = ImuLog(*(getattr(log, name)[keep] for name in names))
    error = heading_errors_deg(thinned, attitude[keep], method)
    assert np.abs(error[1800:]).max() < 4.0


# ---- refusals -------------------------------------------------------------------


@pytest.mark.parametrize("method", ["smoother", "lowpass"])
def test_who_has_no_heading_names_those_who_have(method):
    log, _ = looking_around(2.0)
    with pytest.raises(UsageError, match=r"no heading; choose one of ekf, vqf"):
        estimate_orientation(log, method, heading=True)


@pytest.mark.parametrize("method", WITH_HEADING)
def test_a_heading_without_a_magnetometer_is_refused(method, swing):
    with pytest.raises(UsageError, match="no magnetometer to find the heading with"):
        estimate_orientation(swing[0], method, heading=True)


@pytest.mark.parametrize(
    ("method", "parameters", "says"),
    [
        ("smoother", EkfParameters(), "SmootherParameters, not EkfParameters"),
        ("ekf", SmootherParameters(), "EkfParameters, not SmootherParameters"),
        ("vqf", SmootherParameters(), "takes no parameters"),
        ("offline-vqf", EkfParameters(), "takes no parameters"),
        ("lowpass", SmootherParameters(), "takes no parameters"),
    ],
)
def test_parameters_of_another_method_are_refused(method, parameters, says, still_log):
    for call in (analyse, remove_gravity, estimate_orientation):
        with pytest.raises(UsageError, match=says):
            call(still_log, method, parameters=parameters)


@pytest.mark.parametrize("call", [analyse, remove_gravity, estimate_orientation])
def test_an_unknown_method_is_named_with_those_that_exist(call, still_log):
    with pytest.raises(
        UsageError, match=r"method 'magic' not found; choose one of smoother"
    ):
        call(still_log, "magic")


@pytest.mark.parametrize("method", sorted(METHODS))
@pytest.mark.parametrize("count", [0, 1])
def test_fewer_than_two_samples_are_refused(count, method):
    log = ImuLog(
        np.zeros(count), np.ones((count, 3)), np.ones((count, 3)), source="walk.csv"
    )
    for call in (analyse, remove_gravity, estimate_orientation):
        with pytest.raises(InputError, match=rf"walk\.csv: {count} motion samples"):
            call(log, method)


# ---- answers --------------------------------------------------------------------


@pytest.mark.parametrize("method", ["ekf", "vqf", "offline-vqf"])
def test_means_get_the_orientation_of_the_middle_of_their_window(swing, method):
    log, _ = swing
    averaged = dataclasses.replace(log, sampling=Sampling.AVERAGED)
    end = Rotation.from_quat(estimate_orientation(log, method), scalar_first=True)
    q = estimate_orientation(averaged, method)
    middle = Rotation.from_quat(q, scalar_first=True)
    half_s = 0.5 / log.rate_hz
    turned = (middle.inv() * end).as_rotvec()
    assert np.allclose(turned, half_s * log.angular_rate_radps, atol=1e-9)


@pytest.mark.parametrize("method", ["ekf", "vqf", "offline-vqf", "smoother"])
def test_a_mean_of_gravity_is_shorter_while_the_sensor_turns(method):
    # 4 rad/s about a horizontal axis at 10 Hz: sin(0.2) / 0.2
    count, rate = 300, np.array([4.0, 0.0, 0.0])
    middle = 0.1 * (np.arange(count) + 0.5)
    shrunk = np.sin(0.2) / 0.2
    up = Rotation.from_rotvec(np.outer(-middle, rate)).apply([0.0, 0.0, shrunk])
    log = ImuLog(middle, G * up, np.tile(rate, (count, 1)), sampling=Sampling.AVERAGED)
    norm = np.linalg.norm(remove_gravity(log, method).gravity_mps2, axis=1)
    assert np.allclose(norm[1:-1], shrunk * G, rtol=1e-3)


@pytest.mark.parametrize("method", sorted(METHODS))
def test_the_summary_of_a_method_can_be_written_as_json(method, still_log, swing):
    for log in (still_log, swing[0]):
        summary = analyse(log, method).summary
        assert json.loads(json.dumps(dict(summary))) == dict(summary)
        assert summary["method"] == method
        assert summary["invalid_share"] == 0.0


@pytest.mark.parametrize("method", sorted(METHODS))
def test_orientation_and_motion_come_from_the_same_estimate(method, swing):
    log, _ = swing
    q = estimate_orientation(log, method)
    track = remove_gravity(log, method)
    assert np.array_equal(track.quaternion_wxyz, q)
    up = Rotation.from_quat(q, scalar_first=True).inv().apply([0.0, 0.0, G])
    assert np.allclose(track.gravity_mps2, up, rtol=0.0, atol=1e-6)
    assert np.array_equal(analyse(log, method).track.gravity_mps2, track.gravity_mps2)


# ---- anything -------------------------------------------------------------------


def random_log(seed, count, step_s, sizes, extras):
    """Return a log without any sense: noise, pieces, constants, uneven times."""
    rng = np.random.default_rng(seed)
    force_size, rate_size = sizes
    jitter, pieces, averaged, filled, field = extras
    steps = step_s * np.exp(jitter * rng.standard_normal(count))
    force = force_size * rng.standard_normal((count, 3))
    rate = rate_size * rng.standard_normal((count, 3))
    if pieces:
        rows = np.arange(count) // pieces * pieces
        force, rate = force[rows], rate[rows]
    return ImuLog(
        np.cumsum(steps),
        force,
        rate,
        magnetic_field_ut=rng.standard_normal((count, 3)) if field else None,
        sampling=Sampling.AVERAGED if averaged else Sampling.INSTANT,
        valid=rng.random(count) < 0.8 if filled else None,
    )


LOGS = st.builds(
    random_log,
    seed=st.integers(0, 2**32),
    count=st.integers(2, 150),
    step_s=st.sampled_from([1e-4, 0.001, 0.005, 0.01, 1 / 30, 0.1, 0.5, 1.0, 10.0]),
    sizes=st.tuples(
        st.sampled_from([0.0, 1e-9, 1.0, 9.8, 160.0, 1e4]),
        st.sampled_from([0.0, 1e-9, 0.01, 1.0, 35.0]),
    ),
    extras=st.tuples(
        st.sampled_from([0.0, 0.001, 0.1, 1.0, 3.0]),
        st.sampled_from([0, 1, 7, 40, 1000]),
        st.booleans(),
        st.booleans(),
        st.booleans(),
    ),
)


@pytest.mark.parametrize("method", sorted(METHODS))
@settings(max_examples=40, derandomize=True)
@given(log=LOGS)
def test_whatever_is_in_a_log_the_answer_is_sound_or_a_refusal(method, log):
    try:
        done = analyse(log, method)
    except InputError:
        return
    track, count = done.track, len(log)
    assert len(track) == count
    # MotionTrack refuses what is not finite
    norm = np.linalg.norm(track.quaternion_wxyz, axis=1)
    assert np.abs(norm - 1.0).max() < 1e-9
    length = np.linalg.norm(track.gravity_mps2, axis=1)
    assert length.max() <= G * (1.0 + 1e-9)
    if log.sampling is Sampling.INSTANT:
        assert length.min() >= G * (1.0 - 1e-9)
    total = track.acceleration_mps2 + track.gravity_mps2
    scaled = track.accelerometer_gain * log.specific_force_mps2
    assert np.allclose(total, scaled, rtol=1e-12, atol=1e-12)
    if track.gravity_sigma_mps2 is not None:
        assert (track.gravity_sigma_mps2 >= 0.0).all()
    if log.valid is not None:
        assert not track.valid[~log.valid].any()
    json.dumps(dict(done.summary))
