"""What a hand got beside the plan: synthetic ticks whose figures have closed forms."""

import numpy as np
import pytest
from scipy import integrate

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import Limits
from hapticplayer.rendering.washout import weight
from hapticplayer.study.analysis.trial_force_report import (
    trial_force_blocks,
    trial_force_summary,
)
from hapticplayer.study.answers import read_answers
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.study_folder import open_study
from hapticplayer.study.trial_force import measure_trial_force
from hapticplayer.study.trial_forces import measure_trial_forces
from tests.recorded_session import SECONDS, T, recorded_session, sine, ticks

LIMITS = Limits()


def of(made):
    return measure_trial_force(made, SECONDS + 1.0, LIMITS)


def test_the_same_force_has_no_error():
    found = of(ticks(sine(2.0, 1.0), sine(2.0, 1.0)))
    assert found.error == pytest.approx(0.0, abs=1e-6)
    # RMS of a sine times its weight
    wanted_n = 2.0 / np.sqrt(2.0) * float(weight(np.array([1.0]))[0])
    assert found.planned_n == pytest.approx(wanted_n, rel=1e-4)
    assert (found.faded_s, found.saturated_share, found.is_off) == (0.0, 0.0, False)


@pytest.mark.parametrize(("frequency_hz", "delay_s"), [(0.5, 0.1), (2.0, 0.02)])
def test_a_delayed_sine_is_off_by_its_phase(frequency_hz, delay_s):
    made = ticks(sine(2.0, frequency_hz), sine(2.0, frequency_hz, delay_s))
    wanted = 2.0 * np.sin(np.pi * frequency_hz * delay_s)
    assert of(made).error == pytest.approx(wanted, rel=1e-4)
    assert of(made).is_off == (wanted > 0.15)


def test_two_frequencies_count_by_their_weights():
    planned = sine(1.0, 0.1) + sine(1.0, 5.0)
    slow, fast = weight(np.array([0.1, 5.0]))
    whole = np.hypot(slow, fast)
    for left, lost in ((sine(1.0, 5.0), slow), (sine(1.0, 0.1), fast)):
        assert of(ticks(planned, left)).error == pytest.approx(lost / whole, rel=1e-3)
    assert slow < 0.4 < 0.98 < fast


def test_a_clipped_sine_loses_what_its_fourier_series_says():
    amplitude_n, cap_n = 6.0, LIMITS.force_cap_n
    made = ticks(sine(amplitude_n, 1.0), np.clip(sine(amplitude_n, 1.0), -cap_n, cap_n))
    orders = np.arange(1, 60, 2)
    lost = [
        2 * integrate.quad(
            lambda x, n=n: max(amplitude_n * np.sin(x) - cap_n, 0.0) * np.sin(n * x),
            *(np.arcsin(cap_n / amplitude_n), np.pi - np.arcsin(cap_n / amplitude_n)),
        )[0] * 2 / (2 * np.pi)
        for n in orders
    ]  # fmt: skip
    weights = weight(orders.astype(float))
    wanted = np.linalg.norm(weights * lost) / (weights[0] * amplitude_n)
    found = of(made)
    assert found.error == pytest.approx(wanted, rel=1e-3)
    # what is short by less than 0.05 N does not count as saturated
    share = 1.0 - 2.0 / np.pi * np.arcsin((cap_n + 0.05) / amplitude_n)
    # four edges in 1000 ticks
    assert found.saturated_share == pytest.approx(share, abs=4e-3)
    assert found.faded_s == 0.0


def test_a_cap_of_warm_motors_is_saturation_too():
    limits = Limits(continuous_n=3.0)
    made = ticks(np.full(len(T), 4.0), np.full(len(T), 3.0))
    made["heat_n"] = 3.0
    found = measure_trial_force(made, SECONDS, limits)
    assert found.saturated_share == 1.0
    assert found.error == pytest.approx(0.25, rel=1e-6)
    made["heat_n"] = 0.0  # cool: something else took it
    cool = measure_trial_force(made, SECONDS, limits)
    assert (cool.saturated_share, cool.faded_s) == (
        0.0,
        pytest.approx(SECONDS, abs=2e-3),
    )


def test_entry_and_fade_are_seconds_without_full_force():
    sent = np.minimum(1.0, T / 0.2)
    made = ticks(np.ones(len(T)), sent)
    made["mode"][T <= 0.2] = Mode.ENTERING
    assert of(made).faded_s == pytest.approx(0.2, abs=2e-3)
    edge = (T > 5.0) & (T <= 6.5)
    made["force_n"][edge, 1] = 0.8
    assert of(made).faded_s == pytest.approx(1.7, abs=3e-3)
    made["force_n"][edge, 1] = 1.0 - 0.2  # the spring, of which the track is whole
    made["centring_n"][edge, 1] = -0.2
    assert of(made).faded_s == pytest.approx(0.2, abs=2e-3)


def test_a_stop_counts_as_if_the_plan_went_on():
    made = ticks(np.full(len(T), 1.0), np.full(len(T), 1.0))
    off = (T > 4.0) & (T <= 9.0)
    for field in ("planned_n", "force_n"):
        made[field][off] = 0.0
    made["mode"][off], made["cause"][off] = Mode.TRIPPED, Cause.STOPPED
    found = of(made)
    assert found.faded_s == pytest.approx(5.0, abs=2e-3)
    # a rectangle of a quarter of the time: between its mean alone and all of it
    assert 0.3 * 0.5 < found.error * 0.3 < 1.0
    assert found.is_off
    made["cause"][off] = Cause.TRACK_ENDED  # then nothing was planned
    assert of(made).error == pytest.approx(0.0, abs=1e-6)
    assert of(made).faded_s == 0.0


def test_a_force_where_none_is_planned_is_off():
    found = of(ticks(np.zeros(len(T)), sine(0.05, 2.0)))
    assert found.error is None
    assert not found.is_off  # 0.035 N: not perceived
    assert of(ticks(np.zeros(len(T)), sine(0.1, 2.0))).is_off


def test_values_that_are_not_numbers_do_not_count():
    made = ticks(sine(2.0, 0.5), 0.5 * sine(2.0, 0.5))
    made["force_n"][5000:5010] = np.nan
    made["planned_n"][7000, 2] = np.inf
    made["heat_n"][:] = np.nan
    assert of(made).error == pytest.approx(0.5, rel=1e-3)
    made["centring_n"] = np.nan
    assert of(made) is None


def test_reach_is_the_largest_distance_that_was_measured():
    made = ticks(np.ones(len(T)), np.ones(len(T)))
    made["position_m"][100] = [0.012, 0.0, 0.016]
    made["position_m"][200] = np.nan
    assert of(made).reach_m == pytest.approx(0.02)


def test_ticks_outside_of_the_clip_do_not_count():
    made = ticks(np.ones(len(T)), np.ones(len(T)))
    made["force_n"][T > 5.0] = 0.0
    assert measure_trial_force(made, 4.9, LIMITS).error == pytest.approx(0.0, abs=1e-6)
    assert measure_trial_force(made[:50], SECONDS, LIMITS) is None


def test_slow_and_lost_ticks_are_joined_by_lines():
    made = ticks(sine(2.0, 0.5), 0.5 * sine(2.0, 0.5))
    keep = np.ones(len(T), bool)
    keep[5000:5020] = False
    assert of(made[keep]).error == pytest.approx(0.5, rel=1e-3)


# --- from records on disk -----------------------------------------------------


@pytest.fixture
def session(study, manual_clock):
    return recorded_session(study, manual_clock)


def test_trials_are_found_in_the_record_of_their_session(session):
    found = measure_trial_forces(session, [])
    assert found.keys() == {(1, 1), (2, 1)}
    assert found[1, 1].error == pytest.approx(0.0, abs=1e-6)
    assert found[2, 1].error == pytest.approx(0.5, rel=1e-3)


def test_a_session_without_records_has_no_figures(session):
    (session.folder / "ticks-01.hprec").unlink()
    assert measure_trial_forces(session, []) == {}
    answers = read_answers(session.folder.parents[1], lambda _share, _step: None)
    assert [one.trial_force for one in answers.conduct.playbacks] == [None] * 3


def test_a_damaged_record_is_a_notice(session):
    path = session.folder / "ticks-01.hprec"
    path.write_bytes(path.read_bytes()[:3_000_000])
    notices = []
    assert (1, 1) in measure_trial_forces(session, notices)
    assert "truncated" in notices[0]
    path.write_bytes(b"nothing")
    assert measure_trial_forces(session, notices) == {}
    assert "not a recording" in notices[1]


def test_a_trial_whose_playback_was_lost_has_no_figures(session):
    path = session.folder / ANSWERS
    lines = path.read_text().splitlines()
    kept = [line for line in lines if '"kind":"trial"' not in line]
    path.write_text("\n".join(kept) + "\n")
    damaged = open_study(session.folder.parents[1]).session(session.code)
    assert measure_trial_forces(damaged, []) == {}


def test_a_report_names_the_trials_that_are_off(session):
    answers = read_answers(session.folder.parents[1], lambda _share, _step: None)
    blocks = [*trial_force_blocks(answers, answers.feedbacks)]
    second = session.plan.order[1]
    said = blocks[-1].text
    assert "1 of 2 trials with a record are off" in said
    assert f"{session.code} 2 ({second.key}): 50 %" in said
    assert blocks[1].rows[-1][:4] == ("all", "2", "0.25, 0.50", "20.00, 20.00")
    found = trial_force_summary(answers)
    assert sum(one["trials"] for one in found.values()) == 2
    assert found[second.feedback]["off"] == [f"{session.code} 2 ({second.key})"]
    assert found[second.feedback]["error"]["largest"] == pytest.approx(0.5, rel=1e-3)
    assert found[second.feedback]["reach_m"]["largest"] == pytest.approx(0.02)


def test_without_records_a_report_says_nothing_of_felt_force(session):
    (session.folder / "ticks-01.hprec").unlink()
    answers = read_answers(session.folder.parents[1], lambda _share, _step: None)
    assert [*trial_force_blocks(answers, answers.feedbacks)] == []
    assert trial_force_summary(answers) == {}
