"""The mechanics against closed forms, and its energy against zero."""

import math
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.devices.dynamics import HANDS, RELAXED, Hand, Mechanism
from hapticplayer.simulation.falcon.plant import Plant

ZERO = (0.0, 0.0, 0.0)
STOP_M = Mechanism().stop_radius_m


def vector(rng, longest, shortest=0.0):
    direction = rng.standard_normal(3)
    length = rng.uniform(shortest, longest)
    return tuple(map(float, length / np.linalg.norm(direction) * direction))


@pytest.mark.parametrize("hand", [None, *HANDS], ids=str)
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_energy_never_rises_without_a_force(kinematics, rng, hand, restitution):
    mechanism = replace(Mechanism(), restitution=restitution)
    bounces = 0
    for _ in range(20):
        held = HANDS[hand] if hand else None
        plant = Plant(kinematics, mechanism, held)
        plant.place(vector(rng, STOP_M, 0.5 * STOP_M), vector(rng, 3.0))
        energy_j = first_j = plant.energy_j()
        step_s = rng.uniform(1e-4, 1e-3)
        for _ in range(200):
            plant.advance(ZERO, step_s)
            bounces += math.hypot(*plant.position_m) > STOP_M - 1e-12
            assert plant.energy_j() <= energy_j * (1 + 1e-12)
            energy_j = plant.energy_j()
        assert energy_j < first_j
        assert energy_j == pytest.approx(first_j - plant.energy.lost_j, abs=1e-12)
    assert bounces >= 5  # the end stops were part of it


@pytest.mark.parametrize("hand", [None, *HANDS], ids=str)
def test_work_on_the_plant_is_kept_or_lost(kinematics, rng, hand):
    mechanism = replace(Mechanism(), restitution=0.5)
    plant = Plant(kinematics, mechanism, HANDS[hand] if hand else None)
    lost_j, force_n = 0.0, ZERO
    for tick in range(3000):
        if tick % 40 == 0:
            force_n = vector(rng, 9.0)
        plant.advance(force_n, 0.001)
        assert plant.energy.lost_j >= lost_j - 1e-15
        lost_j = plant.energy.lost_j
    assert plant.energy.force_j > 0.05
    balance_j = plant.energy.force_j - plant.energy.lost_j
    assert plant.energy_j() == pytest.approx(balance_j, abs=1e-10)


def test_joints_of_a_free_grip_turn_on_at_their_speed(kinematics, frictionless):
    plant = Plant(kinematics, frictionless, None)
    start_m, speed_mps = (-0.02, 0.01, -0.015), (0.5, -0.2, 0.4)
    first = kinematics.inverse(start_m)
    rates = np.array(first.rates) @ speed_mps
    plant.place(start_m, speed_mps)
    plant.advance(ZERO, 0.05)
    theta = kinematics.inverse(plant.position_m).theta_rad
    np.testing.assert_allclose(theta, first.theta_rad + 0.05 * rates, atol=5e-6)


def test_a_heavy_mass_goes_straight_on(kinematics, frictionless):
    plant = Plant(kinematics, frictionless, Hand(1e4, 0.0, 0.0))
    plant.place((-0.02, 0.01, -0.015), (0.5, -0.2, 0.4))
    plant.advance(ZERO, 0.05)
    np.testing.assert_allclose(plant.position_m, (0.005, 0.0, 0.005), atol=1e-6)


def test_a_small_force_lets_the_free_grip_fall_like_its_mass(kinematics, frictionless):
    rates = np.array(kinematics.inverse(ZERO).rates)
    mass = frictionless.joint_inertia_kg_m2 * rates.T @ rates
    for force_n in ((0.1, 0.0, 0.0), (0.0, -0.1, 0.0), (0.0, 0.0, 0.1)):
        plant = Plant(kinematics, frictionless, None)
        plant.advance(force_n, 0.03)
        exact_m = np.linalg.solve(mass, force_n) * 0.03**2 / 2
        np.testing.assert_allclose(
            plant.position_m, exact_m, atol=0.01 * np.abs(exact_m).max()
        )


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("name", HANDS)
def test_a_step_of_force_moves_a_hand_like_a_damped_oscillator(kinematics, name, axis):
    hand, mechanism = HANDS[name], replace(Mechanism(), coulomb_nm=0.0)
    rates = np.array(kinematics.inverse(ZERO).rates)
    per_inertia = (rates.T @ rates)[axis, axis]
    m = hand.mass_kg + mechanism.joint_inertia_kg_m2 * per_inertia
    c = hand.damping_n_s_per_m + mechanism.viscous_nm_s * per_inertia
    k, push_n = hand.stiffness_n_per_m, 0.05
    decay, omega0 = c / (2 * m), math.sqrt(k / m)
    omega = math.sqrt(omega0**2 - decay**2)
    force_n = tuple(push_n * np.eye(3)[axis])
    plant = Plant(kinematics, mechanism, hand)
    for tick in range(1, 1001):
        plant.advance(force_n, 0.001)
        t = tick / 1000
        swing = math.cos(omega * t) + decay / omega * math.sin(omega * t)
        exact_m = push_n / k * (1 - math.exp(-decay * t) * swing)
        assert plant.position_m[axis] == pytest.approx(exact_m, abs=0.01 * push_n / k)


@pytest.mark.parametrize("hand", [None, RELAXED], ids=["free", "relaxed"])
def test_halving_the_step_quarters_the_error(kinematics, hand):
    def end_of(max_step_s):
        plant = Plant(
            kinematics, replace(Mechanism(), coulomb_nm=0.0), hand, max_step_s
        )
        plant.advance((2.0, 1.0, 1.5), 0.02)
        plant.advance((-2.0, 1.0, -1.5), 0.02)
        return np.array(plant.position_m)

    fine = end_of(1e-5)
    errors = [np.abs(end_of(step_s) - fine).max() for step_s in (1e-3, 5e-4, 2.5e-4)]
    assert errors[0] < 3e-7
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


def test_the_end_stop_is_never_passed_and_turns_the_speed_round(kinematics, rng):
    mechanism = replace(Mechanism(), restitution=0.4)
    for _ in range(20):
        plant = Plant(kinematics, mechanism, None)
        force_n = vector(rng, 9.0, 1.0)
        fastest_mps = 0.0
        for _ in range(400):
            plant.advance(force_n, 0.0005)
            assert math.hypot(*plant.position_m) <= STOP_M * (1 + 1e-12)
            fastest_mps = max(fastest_mps, math.hypot(*plant.velocity_mps))
        assert fastest_mps > 0.05
    plant = Plant(kinematics, mechanism, None)
    plant.place((0.0, 0.0, STOP_M - 1e-6), (0.0, 0.0, 0.5))
    plant.advance(ZERO, 0.0005)
    assert plant.velocity_mps[2] == pytest.approx(-0.4 * 0.5, rel=0.02)


def test_a_grip_pressed_against_the_stop_rests_there(kinematics):
    plant = Plant(kinematics, replace(Mechanism(), restitution=0.5), None)
    plant.advance((0.0, 0.0, 5.0), 1.0)
    assert plant.position_m[2] == pytest.approx(STOP_M, abs=1e-6)
    # what is left of the speed is what half a step of force gives
    assert math.hypot(*plant.velocity_mps) < 1e-3


def test_dry_friction_holds_a_small_force_and_stops_the_grip(kinematics):
    plant = Plant(kinematics, Mechanism(), None)
    plant.advance((0.03, 0.0, 0.0), 1.0)
    assert 0.0 < plant.position_m[0] < 1e-3  # it creeps, and does not run
    plant.place(ZERO, (0.1, 0.0, 0.0))
    plant.advance(ZERO, 1.0)
    assert math.hypot(*plant.velocity_mps) < 1e-6


def test_letting_go_leaves_a_grip_that_runs_at_once(kinematics):
    plant = Plant(kinematics, Mechanism(), RELAXED)
    plant.advance((3.0, 0.0, 0.0), 2.0)
    assert plant.position_m[0] == pytest.approx(3.0 / 150.0, rel=0.02)
    plant.let_go()
    before_m = plant.position_m
    plant.advance((3.0, 0.0, 0.0), 0.01)
    assert plant.position_m[0] - before_m[0] > 4e-4  # 3 N on about 0.17 kg
    plant.grasp(RELAXED)
    assert plant.rest_m == plant.position_m


def test_a_rest_point_follows_slowly_and_its_work_is_booked(kinematics):
    hand = replace(RELAXED, return_s=0.5)
    plant = Plant(kinematics, Mechanism(), hand)
    plant.aim_m = (0.02, 0.0, 0.0)
    plant.advance(ZERO, 0.5)
    assert plant.rest_m[0] == pytest.approx(0.02 * (1 - math.exp(-1.0)), rel=1e-6)
    plant.advance(ZERO, 4.0)
    assert plant.position_m[0] == pytest.approx(0.02, abs=5e-4)
    balance_j = plant.energy.hand_j - plant.energy.lost_j
    assert plant.energy_j() == pytest.approx(balance_j, abs=1e-12)


def test_a_hand_that_yields_gives_way_and_loses_energy(kinematics):
    hand = replace(RELAXED, yield_s=1.0, return_s=1.0)
    plant = Plant(kinematics, Mechanism(), hand)
    plant.advance((1.0, 0.0, 0.0), 10.0)
    # both pull alike: the rest point is half way, so the hand seems half as stiff
    assert plant.position_m[0] == pytest.approx(2.0 / 150.0, rel=0.03)
    passive = Plant(kinematics, Mechanism(), replace(RELAXED, yield_s=0.3))
    passive.place((0.03, 0.0, 0.0))
    before_j = passive.energy_j()
    for _ in range(500):
        passive.aim_m = passive.rest_m  # nobody brings it back
        passive.advance(ZERO, 0.001)
        assert passive.energy_j() <= before_j
        before_j = passive.energy_j()
