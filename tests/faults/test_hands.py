"""A hand under strong, long forces: kept inside, never shaken, never driven.

A short part of `benchmarks.haptics centring`: the real `step` with the physics of device
and hand in virtual time.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from hand_boundary import PIPELINE_S, growth, sideways
from hand_cases import SMOOTH, Trial, swing_m
from hand_tracks import excerpt, hostile, shaken, steady_push, track

from hapticplayer.devices.dynamics import HANDS, RELAXED, Mechanism
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.limiter import PERIOD_S, Limits

WORST_WIRE = {"delay_s": 0.003, "lost": 0.1}
# The hardest seconds of each ride for a relaxed hand.
HARDEST = {
    "demo": (6.3, 8.0),
    "bike": (3.0, 5.5),
    "horse": (0.0, 2.5),
    "turning": (3.5, 7.0),
    "braking": (14.0, 17.0),
}
YIELDING = replace(RELAXED, yield_s=0.3, return_s=2.0)  # gives way to a steady push
OUTSIDE = Limits().outside


def is_held(trial):
    """Return whether nothing tripped, it stayed inside, and made no energy."""
    assert trial.state.mode is Mode.FOLLOWING
    return not trial.trips and trial.reach < OUTSIDE and trial.least_energy_j >= -0.001


@pytest.mark.parametrize("name", HARDEST)
def test_the_rides_keep_a_relaxed_hand_inside(name):
    begin_s, end_s = HARDEST[name]
    part = excerpt(track(name), begin_s, end_s)
    trial = Trial(part, RELAXED, **WORST_WIRE).run(end_s - begin_s - 0.02)
    assert is_held(trial)


@pytest.mark.parametrize("hand", [name for name in HANDS if name != "relaxed"])
def test_firmer_hands_are_kept_further_inside(hand):
    part = excerpt(track("braking"), 14.0, 16.5)
    trial = Trial(part, HANDS[hand]).run(2.4)
    assert is_held(trial)
    assert trial.reach < 0.6


@pytest.mark.parametrize("name", ["knocks 3 Hz x", "steady z"])
def test_a_compliant_hand_is_kept_inside_under_full_force(name):
    trial = Trial(hostile()[name], YIELDING, **WORST_WIRE).run(4.0)
    assert is_held(trial)
    assert trial.reach < 0.8


def test_near_the_middle_the_track_is_sent_as_it_is():
    part = excerpt(track("demo"), 6.3, 8.3)
    trial = Trial(part, HANDS["firm"]).run(1.9)
    at = np.arange(len(trial.sent_n)) * PERIOD_S
    followed = at > 0.6
    apart = np.array(trial.sent_n)[followed] - part.at(at[followed])
    assert np.abs(apart).max() < 1e-4


# --- a person who moves ------------------------------------------------------


def test_a_person_who_shakes_the_grip_at_the_edge_gets_no_energy():
    def shake(at_s):
        radius_m = 0.036 * math.sin(2.0 * math.pi * 2.5 * at_s)
        return (radius_m, 0.3 * radius_m, 0.0)

    still = steady_push(1e-3, 0, 4.0)
    firm = replace(HANDS["firm"], return_s=0.02)
    trial = Trial(still, firm, aim=shake, **WORST_WIRE).run(3.0)
    assert trial.reach > OUTSIDE  # the person wants to be there
    assert trial.trips == []  # and nothing pushes out
    assert trial.least_energy_j >= -0.001
    assert trial.energy_j > 0.1  # the damper has taken in what the arm gave


# --- nobody there ------------------------------------------------------------


@pytest.mark.parametrize("mass_kg", [0.05, 0.168, 0.3])
@pytest.mark.parametrize("axis", [0, 2])
def test_a_free_grip_comes_to_rest_at_the_edge(mass_kg, axis):
    gentle = steady_push(4.5, axis, 4.0, rise_s=1.5)
    light = SMOOTH.with_lateral_mass(mass_kg)
    trial = Trial(gentle, None, mechanism=light, **WORST_WIRE).run(3.2)
    assert swing_m(trial, 0.5) < 0.0005
    assert trial.trips == []


@pytest.mark.parametrize("moment", range(20))
def test_letting_go_under_force_is_safe(moment):
    rng = np.random.default_rng(moment)
    mass_kg = (0.05, 0.1, 0.168, 0.3)[moment % 4]
    wire = WORST_WIRE if moment % 2 else {}
    _, push = shaken("", 0.5 + 2.0 * rng.random(), moment % 3)
    trial = Trial(
        push, RELAXED, mechanism=Mechanism().with_lateral_mass(mass_kg), **wire
    )
    trial.run(0.5 + 0.4 * rng.random())
    while math.hypot(*trial.sent_n[-1]) < 2.0:
        trial.run(PERIOD_S)
    trial.simulation.let_go()
    trial.run(0.4)
    assert trial.speed_mps <= 1.5
    assert trial.trips in ([], ["RUNAWAY"], ["OUTSIDE"])
    assert math.hypot(*trial.sent_n[-1]) == 0.0 or trial.state.mode is Mode.FOLLOWING


# --- the stability boundary --------------------------------------------------


@pytest.mark.parametrize("delay_s", [0.0, 0.003])
def test_a_linear_spring_oscillates_beyond_the_known_boundary(delay_s):
    _, friction = sideways()
    boundary = friction / (PERIOD_S / 2.0 + PIPELINE_S + delay_s)
    assert growth(0.9 * boundary, delay_s) < 1.0
    assert growth(1.1 * boundary, delay_s) > 1.0
