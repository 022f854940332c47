"""Clipped peaks: rails found, short ones rebuilt within bounds, long ones marked."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.motion.conditioning import repair_clipping
from hapticplayer.motion.conditioning.clipping import MAX_OVERSHOOT, reconstruct

RAILS = np.array([[-20.0, 20.0]])


def rebuilt(time_s, values, rails=RAILS):
    return reconstruct(time_s, values, rails, np.ones(len(values), bool))


def test_a_clipped_sine_comes_back_close_to_its_closed_form():
    t = np.arange(1000) / 200.0
    truth = 22.0 * np.sin(2 * np.pi * 8.0 * t + 0.3)[:, None]
    cut = np.clip(truth, -20.0, 20.0)
    out, clipped, done = rebuilt(t, cut)
    # a rail may be smeared by 0.2 %
    assert np.array_equal(clipped, np.abs(truth) >= 0.998 * 20.0)
    assert done[np.abs(truth) > 20.1].all()
    before = np.sqrt(np.mean((cut - truth)[clipped] ** 2))
    after = np.sqrt(np.mean((out - truth)[clipped] ** 2))
    assert before > 1.2
    assert after < 0.12 * before
    assert np.array_equal(out[~clipped], cut[~clipped])


@given(heights=st.lists(st.floats(-60, 60), min_size=20, max_size=60))
@settings(max_examples=60)
def test_a_reconstruction_never_leaves_its_bounds(heights):
    cut = np.clip(np.array(heights), -20.0, 20.0)[:, None]
    time_s = np.arange(len(cut)) / 100.0
    out, clipped, done = rebuilt(time_s, cut)
    assert np.array_equal(out[~done], cut[~done])
    assert not (done & ~clipped).any()
    assert (np.sign(out[done]) == np.sign(cut[done])).all()
    assert (np.abs(out[done]) >= np.abs(cut[done])).all()
    assert (np.abs(out) <= 20.0 * (1.0 + MAX_OVERSHOOT) + 1e-9).all()


@given(
    rise=st.tuples(st.floats(-19, 19), st.floats(-19, 19)),
    fall=st.tuples(st.floats(-19, 19), st.floats(-19, 19)),
    length=st.integers(1, 8),
)
@settings(max_examples=200)
def test_a_peak_stays_below_the_tent_of_its_flanks(rise, fall, length):
    values = np.array([*rise, *[20.0] * length, *fall])
    row = np.arange(len(values))
    out, clipped, _ = rebuilt(row / 200.0, values[:, None])
    peak = np.flatnonzero(clipped[:, 0])
    up = rise[1] + (rise[1] - rise[0]) * (peak - 1)
    down = fall[0] + (fall[0] - fall[1]) * (length + 2 - peak)
    tent = np.maximum(np.minimum(up, down), 20.0)
    assert peak.tolist() == list(range(2, 2 + length))
    assert (out[peak, 0] <= tent * (1 + 1e-9)).all()


def test_a_parabola_is_rebuilt_exactly_at_uneven_times():
    t = np.array([-9.0, -7.0, -4.0, -3.1, -1.0, 0.5, 1.1, 3.5, 4.0, 8.0])
    truth = (28.0 - 0.8 * t**2)[:, None]
    out, clipped, done = rebuilt(t, np.minimum(truth, 20.0), RAILS * [[9, 1]])
    assert clipped.sum() == 4
    assert np.array_equal(clipped, done)
    assert np.allclose(out, truth, atol=1e-9)


def clipped_log(make_log, height=30.0):
    """Half-sine knocks of growing length at 200 Hz, clipped at 2 g."""
    t = np.arange(4000) / 200.0
    wave = np.zeros(4000)
    for knock, half in enumerate([8, 10, 12, 14, 40]):
        start = 400 + 600 * knock
        wave[start : start + half + 1] = height * np.sin(
            np.pi * np.arange(half + 1) / half
        )
    force = np.stack([wave, -0.5 * wave, 0 * wave + 9.8], axis=1)
    return make_log(t, force=np.clip(force, -19.545, 19.552)), wave


def test_short_clipping_is_repaired_and_long_is_marked(make_log):
    log, wave = clipped_log(make_log)
    out, report = repair_clipping(log)
    assert report.force.rails[0, 1] == pytest.approx(19.552, rel=2e-4)
    assert np.isinf(report.force.rails[0, 0])
    assert np.isinf(report.force.rails[1:]).all()
    assert np.isinf(report.rate.rails).all()
    short = report.force.reconstructed[:, 0]
    error = (out.specific_force_mps2[:, 0] - wave)[short]
    assert np.sqrt(np.mean(error**2)) < 0.35 * np.sqrt(
        np.mean((log.specific_force_mps2[:, 0] - wave)[short] ** 2)
    )
    # the knock of 40 samples is above the rail for 21
    assert np.flatnonzero(~out.valid).tolist() == list(range(2810, 2831))
    assert report.force.marked.sum() == 21
    assert "21 of them not reconstructed" in report.message
    assert np.array_equal(out.angular_rate_radps, log.angular_rate_radps)


def test_a_gyro_saturates_too(make_log):
    t = np.arange(2000) / 200.0
    spin = 6.0 * np.sin(2 * np.pi * 7.0 * t)
    log = make_log(t, force=9.8, rate=np.clip(spin, -5.24, 5.24)[:, None])
    out, report = repair_clipping(log)
    assert np.allclose(np.abs(report.rate.rails), 5.24)
    assert report.rate.clipped.any(axis=1).mean() > 0.25
    truth = spin[:, None] * np.ones(3)
    error = np.abs(out.angular_rate_radps - truth)[report.rate.reconstructed]
    assert error.max() < 0.1


def test_clipping_beside_a_gap_or_the_end_is_only_marked(make_log):
    t = np.arange(200) / 200.0
    wave = 22.0 * np.sin(2 * np.pi * 8.0 * t)
    cut = np.clip(wave, -20.0, 20.0)
    time_s = t.copy()
    time_s[6:] += 1.0  # in the flank of the first peak
    valid = np.ones(200, bool)
    valid[27] = False  # in the flank of the second
    starts = np.flatnonzero(np.diff((cut >= 20.0).astype(int)) == 1) + 1
    assert starts.tolist()[:2] == [5, 30]
    valid[29] = False
    log = make_log(time_s, force=np.stack([cut, 0 * t, 0 * t], axis=1), valid=valid)
    out, report = repair_clipping(log)
    assert not report.force.reconstructed[:50].max(
        where=(wave > 0)[:50, None], initial=0
    )
    assert report.force.reconstructed[50:150].any()
    assert (~out.valid[[5, 6, 7, 30, 31, 32]]).all()


def test_unclipped_recordings_come_out_bit_for_bit(recording):
    for name in ("broad_15", "broad_24", "tumvi_room1"):
        log = recording(name)
        out, report = repair_clipping(log)
        assert np.array_equal(out.specific_force_mps2, log.specific_force_mps2)
        assert report.force.samples == report.rate.samples == 0
        assert out.valid is None


def test_the_rails_of_a_running_phone_are_found(recording):
    log = recording("tyrex_Guillaume_Nexus5_NoDist_RunningHand")
    _, report = repair_clipping(log)
    wanted = [[-19.545, np.inf], [-19.446, 19.553], [-19.499, 19.500]]
    assert np.allclose(report.force.rails, wanted, rtol=2e-4)
    low = log.specific_force_mps2[:, 0].min()
    assert np.sum(log.specific_force_mps2[:, 0] == low) == 6699
    assert report.force.clipped[:, 0].sum() >= 6699
    assert 0.25 < report.force.samples / len(log) < 0.3


def test_recordings_clipped_afterwards_come_closer_to_the_truth(recording):
    before = after = count = 0.0
    for name, rail in (("broad_15", 15.0), ("broad_07", 18.0), ("broad_28", 18.0)):
        log = recording(name)
        truth = log.specific_force_mps2
        cut = dataclasses.replace(log, specific_force_mps2=np.clip(truth, -rail, rail))
        out, report = repair_clipping(cut)
        done = report.force.reconstructed & (np.abs(truth) > rail)
        before += np.sum((cut.specific_force_mps2 - truth)[done] ** 2)
        after += np.sum((out.specific_force_mps2 - truth)[done] ** 2)
        count += done.sum()
    assert count > 200
    assert np.sqrt(after / before) < 0.7


@pytest.mark.parametrize("count", [0, 1, 2])
def test_short_recordings_are_left_alone(make_log, count):
    log = make_log(np.arange(count) / 100.0, force=19.6)
    out, report = repair_clipping(log)
    assert np.array_equal(out.specific_force_mps2, log.specific_force_mps2)
    assert report.force.samples == 0
