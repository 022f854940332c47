"""The plain estimate under the smoother: what it says, and when it is preferred."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.motion.smoother.nodes import Nodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.short_memory import SHORT_MEMORY_S, floor_under

STEP_S, COUNT = 0.75, 200
TIME_S = STEP_S * np.arange(COUNT + 1)
IDENTITY = np.ones(COUNT + 1, complex), np.zeros(COUNT + 1, complex)
LEVEL = np.zeros((2, COUNT + 1))


def moved(velocity_mps):
    """Return the nodes of a sensor that stays upright, with this velocity along x."""
    impulse = np.zeros((3, COUNT))
    impulse[0], impulse[2] = np.diff(velocity_mps), G * STEP_S
    nothing = np.zeros(COUNT)
    return Nodes(
        per_node=12,
        start=IDENTITY,
        at=IDENTITY,
        duration_s=np.full(COUNT, STEP_S),
        impulse_mps=impulse,
        bias_turn_s=np.zeros((3, 3, COUNT)),
        matrix_turn_rad=np.zeros((3, 0, COUNT)),
        power_m2ps3=nothing,
        turned_rad=nothing,
        lost_s=nothing,
        doubt_s=nothing,
    )


def floor(tilt, nodes):
    return floor_under(tilt, nodes, IDENTITY, 4.0, SmootherParameters())


def test_a_vibration_is_averaged_out_as_by_a_gaussian():
    rate_radps = 2.0 * np.pi / 6.0
    found = floor(LEVEL, moved(np.sin(rate_radps * TIME_S))).tilt[0, 20:-20]
    acceleration = rate_radps * np.cos(rate_radps * TIME_S)[20:-20]
    left = np.exp(-0.5 * (rate_radps * SHORT_MEMORY_S) ** 2)
    # the mean over two intervals is a low-pass, too
    left *= np.sinc(rate_radps * STEP_S / np.pi)
    assert found == pytest.approx(left * acceleration / G, abs=2e-3)


def test_the_smoother_is_kept_where_both_agree():
    nodes = moved(0.3 * np.sin(1.5 * TIME_S))
    # at either end half of what is averaged is missing
    assert floor(LEVEL, nodes).weight[30:-30].max() < 0.05


def test_a_smoother_that_drifts_gives_way_where_it_drifts():
    nodes = moved(0.3 * np.sin(1.5 * TIME_S))
    tilt = LEVEL.copy()
    tilt[0] = 0.2 / (1.0 + np.exp(-(TIME_S - 75.0) / 3.0))
    found = floor(tilt, nodes)
    mixed = found.mixed(tilt, found.tilt)
    assert np.abs(mixed[0, TIME_S > 110.0]).max() < 0.02
    assert found.weight[TIME_S < 40.0].max() < 0.05
    assert np.abs(np.diff(found.weight)).max() < 0.5


def test_windows_across_a_gap_are_not_used():
    nodes = moved(0.3 * np.sin(1.5 * TIME_S))
    lost_s = np.where((TIME_S[:-1] > 70.0) & (TIME_S[:-1] < 80.0), STEP_S, 0.0)
    found = floor(LEVEL + 0.2, dataclasses.replace(nodes, lost_s=lost_s))
    assert found.weight[(TIME_S > 70.0) & (TIME_S < 80.0)].max() == 0.0
    assert found.weight[TIME_S < 60.0].min() > 0.9


def test_its_sigma_grows_with_what_lasts_as_long():
    quiet = floor(LEVEL, moved(0.3 * np.sin(3.0 * TIME_S))).variance
    slow = floor(LEVEL, moved(3.0 * np.sin(0.6 * TIME_S))).variance
    assert np.median(slow) > 10.0 * np.median(quiet)
