"""Electronics and encoders in virtual time, and the whole against published gains."""

import math
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import FIRM, HANDS, RELAXED, Mechanism
from hapticplayer.simulation.falcon.parameters import Electronics, PlantGeometry
from hapticplayer.simulation.falcon.simulation import Simulation

ZERO = (0.0, 0.0, 0.0)
PUSH = (2.0, 0.0, 0.0)
START_S = 1000.0


def silent_after(hold_s, **others):
    """Return a simulation that was pushed for 10 ms and then hears nothing."""
    simulation = Simulation(electronics=Electronics(hold_s, **others))
    for tick in range(11):
        simulation.command(PUSH, START_S + tick / 1000)
    return simulation


@pytest.mark.parametrize("hold_s", [0.0, 0.020])
def test_the_last_force_goes_when_its_hold_time_is_over(hold_s):
    simulation = silent_after(hold_s)
    ends_s = START_S + 0.010 + 0.001 + hold_s  # the next command was due after 1 ms
    assert simulation.next_change_s == pytest.approx(ends_s, abs=1e-9)
    simulation.advance(ends_s - 1e-6)
    assert simulation.applied_n == PUSH
    simulation.advance(ends_s + 0.5)
    assert simulation.applied_n == ZERO
    assert simulation.applied_since_s == pytest.approx(ends_s, abs=1e-9)


def test_the_moment_of_the_end_does_not_depend_on_when_one_looks():
    rarely, often = silent_after(0.020), silent_after(0.020)
    for tick in range(1, 101):
        often.advance(START_S + 0.010 + tick / 1000)
    rarely.advance(START_S + 0.110)
    # 1 ms more of the force would be 100 um; the longer steps err by 5 um
    np.testing.assert_allclose(rarely.position_m, often.position_m, atol=1e-5)


def test_an_endless_hold_keeps_the_force():
    simulation = silent_after(math.inf)
    simulation.advance(START_S + 60.0)
    assert simulation.applied_n == PUSH
    assert simulation.position_m[0] == pytest.approx(2.0 / 150.0, rel=0.02)


def test_a_command_takes_effect_after_the_delay():
    simulation = silent_after(0.020, delay_s=0.003)
    simulation.command(ZERO, START_S + 0.011)
    simulation.advance(START_S + 0.0139)
    assert simulation.applied_n == PUSH
    simulation.advance(START_S + 0.0141)
    assert simulation.applied_n == ZERO
    assert simulation.applied_since_s == pytest.approx(START_S + 0.014, abs=1e-9)


def test_the_same_commands_give_the_same_bits():
    def positions():
        rng = np.random.default_rng(7)
        simulation = Simulation()
        now_s, found = START_S, []
        for tick in range(2000):
            now_s += float(rng.uniform(0.0005, 0.0015))
            simulation.command(tuple(map(float, rng.normal(0.0, 2.0, 3))), now_s)
            if tick == 1500:
                simulation.let_go()
            found.append((simulation.position_m, simulation.reading(now_s)))
        return found

    assert positions() == positions()


def test_readings_are_whole_encoder_counts_near_the_truth(kinematics):
    geometry, simulation = PlantGeometry(), Simulation()
    seen, errors = set(), []
    for tick in range(1000):
        now_s = START_S + tick / 1000
        force_n = (3.0 * math.sin(tick / 40), 2.0 * math.cos(tick / 55), 1.5)
        simulation.command(force_n, now_s)
        reading = simulation.reading(now_s)
        theta = np.array(kinematics.inverse(reading.position_m).theta_rad)
        counts = (theta - geometry.theta0_rad) / geometry.count_rad
        np.testing.assert_allclose(counts, np.round(counts), atol=1e-6)
        seen.add(tuple(np.round(counts)))
        errors.append(np.subtract(reading.position_m, simulation.position_m))
    assert len(seen) > 300
    # 46 um to a count sideways and 28 um along the axis, three joints together
    assert 10e-6 < np.std(errors, axis=0).max() < 30e-6
    assert np.abs(errors).max() < 60e-6


def test_a_grip_at_rest_reads_still():
    simulation = Simulation()
    readings = {
        simulation.reading(START_S + tick).position_m
        for tick in range(20)
        if simulation.command(ZERO, START_S + tick)
    }
    assert len(readings) == 1


@pytest.mark.parametrize(
    ("axis", "gain_n_per_m", "period_s"),
    [(0, 185.0, 0.166), (1, 185.0, 0.166), (2, 200.0, 0.300)],
)
def test_a_bare_spring_oscillates_as_with_a_real_falcon(axis, gain_n_per_m, period_s):
    """ros_falcon: proportional gain at which a free Falcon began to oscillate."""
    home_m = np.array([0.0, 0.0, 0.0146])  # encoder counts zero
    found = oscillation(axis, gain_n_per_m, home_m)
    assert found[0] == pytest.approx(period_s, rel=0.06)


@pytest.mark.parametrize(("share", "grows"), [(0.5, False), (2.0, True)])
def test_the_critical_gain_is_near_the_published_one(share, grows):
    home_m = np.array([0.0, 0.0, 0.0146])
    _, first_m, last_m = oscillation(0, share * 185.0, home_m)
    assert (last_m > first_m) == grows


def oscillation(axis, gain_n_per_m, home_m):
    """Return (period, swing in the first period, swing in the last), s and m.

    A spring at 1 kHz with 1 ms of delay, on what the encoders say.
    """
    simulation = Simulation(
        None,
        mechanism=replace(Mechanism(), coulomb_nm=0.0),
        electronics=Electronics(delay_s=0.001),
    )
    start_m = home_m + 0.004 * np.eye(3)[axis]
    simulation.place(tuple(map(float, start_m)))
    trace = []
    for tick in range(900):
        now_s = START_S + tick / 1000
        simulation.advance(now_s)
        away_m = np.subtract(simulation.reading(now_s).position_m, home_m)
        simulation.command(tuple(map(float, -gain_n_per_m * away_m)), now_s)
        trace.append(simulation.position_m[axis] - home_m[axis])
    trace = np.array(trace)
    up = np.flatnonzero((trace[:-1] < 0.0) & (trace[1:] >= 0.0)) / 1000
    period = round(1000 * np.diff(up).mean())
    first, last = np.ptp(trace[:period]), np.ptp(trace[-period:])
    return np.diff(up).mean(), first, last


def test_no_silence_makes_it_hang():
    simulation = silent_after(math.inf)
    simulation.let_go()
    simulation.advance(START_S + 1e7)
    assert math.hypot(*simulation.position_m) <= FALCON.workspace_radius_m * (1 + 1e-12)
    simulation.command(PUSH, START_S)  # and time does not run backwards
    assert simulation.applied_n == PUSH


def test_a_force_that_is_no_number_is_refused_and_counted():
    simulation = silent_after(math.inf)
    for bad in ((math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, -math.inf)):
        assert not simulation.command(bad, START_S + 0.011)
    assert simulation.refused == 3
    assert simulation.applied_n == PUSH


@pytest.mark.parametrize("gap_ticks", [50, 100, 170, 300, 400])
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("turns", [1, -1])
def test_pulses_of_3_n_leave_the_default_hand_inside(axis, gap_ticks, turns):
    simulation, farthest_m, fastest_mps, sign = Simulation(), 0.0, 0.0, 1.0
    for tick in range(3000):
        if tick % (100 + gap_ticks) == 0:
            sign *= turns
        is_on = tick % (100 + gap_ticks) < 100
        force_n = tuple(map(float, 3.0 * sign * is_on * np.eye(3)[axis]))
        simulation.command(force_n, START_S + tick / 1000)
        farthest_m = max(farthest_m, math.hypot(*simulation.position_m))
        fastest_mps = max(fastest_mps, math.hypot(*simulation.velocity_mps))
    assert 0.005 < farthest_m < 0.9 * FALCON.workspace_radius_m
    assert fastest_mps < 0.8


def test_hands_from_relaxed_to_firm_yield_less_and_less():
    assert list(HANDS) == ["relaxed", "light", "normal", "tense", "firm"]
    ways_m = []
    for hand in HANDS.values():
        simulation = Simulation(hand)
        simulation.command((4.5, 0.0, 0.0), START_S)
        simulation.advance(START_S + 5.0)
        ways_m.append(simulation.position_m[0])
    assert ways_m == sorted(ways_m, reverse=True)
    assert ways_m[0] == pytest.approx(4.5 / RELAXED.stiffness_n_per_m, rel=0.02)
    assert ways_m[-1] == pytest.approx(4.5 / FIRM.stiffness_n_per_m, rel=0.02)


@pytest.mark.parametrize("mass_kg", [0.05, 0.13, 0.3])
def test_a_released_grip_of_any_mass_runs_into_its_end_stop(mass_kg):
    mechanism = Mechanism().with_lateral_mass(mass_kg)
    simulation = Simulation(mechanism=mechanism)
    simulation.command((4.5, 0.0, 0.0), START_S)
    simulation.let_go()
    simulation.advance(START_S + 0.010)
    fallen_m = 0.5 * 4.5 / mass_kg * 0.010**2
    assert simulation.position_m[0] == pytest.approx(fallen_m, rel=0.10)
    simulation.advance(START_S + 1.0)
    assert simulation.position_m[0] == pytest.approx(0.04, abs=1e-4)
