"""Even grids for filters that know one interval only."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog
from hapticplayer.motion import METHODS, analyse, remove_gravity
from hapticplayer.motion.grid import even, pieces, with_gaps_closed
from tests.unit.motion.smoother.conftest import TIME_S, WOBBLE, rms

COUNT = len(TIME_S)
LATER_S = 5 * 3600.0


def with_a_hole(log: ImuLog) -> ImuLog:
    """Let the second half be recorded hours later."""
    time_s = log.time_s + LATER_S * (np.arange(COUNT) >= COUNT // 2)
    return dataclasses.replace(log, time_s=time_s)


def test_an_even_log_stays_as_it_is():
    log = WOBBLE.instant(TIME_S)
    assert with_gaps_closed(log) is log
    assert even(log, log.specific_force_mps2).time_s is log.time_s


def test_a_hole_of_hours_is_closed_and_nothing_else_moves():
    log = WOBBLE.instant(TIME_S)
    closed = with_gaps_closed(with_a_hole(log))
    steps = np.diff(closed.time_s)
    assert steps[COUNT // 2 - 1] == pytest.approx(1.0)
    steps[COUNT // 2 - 1] = 0.01
    assert np.abs(steps - 0.01).max() < 1e-9
    grid = even(closed, closed.specific_force_mps2)
    assert grid.interval_s == pytest.approx(0.01, rel=1e-3)
    assert len(grid.time_s) == COUNT + 99


def test_holes_that_can_be_waited_for_stay():
    log = WOBBLE.instant(TIME_S)
    time_s = log.time_s + 30.0 * (np.arange(COUNT) >= COUNT // 2)
    held = dataclasses.replace(log, time_s=time_s)
    assert with_gaps_closed(held) is held


@pytest.mark.parametrize("method", METHODS)
def test_a_gap_of_hours_costs_a_method_only_a_new_start(method):
    log, up = WOBBLE.instant(TIME_S), WOBBLE.up(TIME_S)
    late = slice(COUNT - 1500, COUNT)  # 15 s after the hole
    usual = remove_gravity(log, method).gravity_mps2[late] - G * up[late]
    track = remove_gravity(with_a_hole(log), method)
    assert track.time_s[-1] > LATER_S
    error = track.gravity_mps2[late] - G * up[late]
    # on one grid over all of it: ekf 3.6, vqf 0.81, offline-vqf 0.43 m/s^2
    assert rms(error) < rms(usual) + 0.05


def test_a_method_says_that_it_restarted():
    done = analyse(with_a_hole(WOBBLE.instant(TIME_S)), "ekf")
    assert done.summary["pieces"] == 2
    assert len(done.track.gravity_sigma_mps2) == COUNT


@pytest.mark.parametrize("method", METHODS)
def test_a_few_samples_between_holes_are_no_piece(method):
    log = WOBBLE.instant(TIME_S)
    lonely = (np.arange(COUNT) >= 3000).astype(float) + (np.arange(COUNT) >= 3003)
    held = dataclasses.replace(log, time_s=log.time_s + LATER_S * lonely)
    assert pieces(held) == [slice(0, 3003), slice(3003, COUNT)]
    track = remove_gravity(held, method)
    error = track.gravity_mps2[-1500:] - G * WOBBLE.up(TIME_S[-1500:])
    assert np.isfinite(track.gravity_mps2).all()
    assert rms(error) < (2.0 if method == "lowpass" else 0.1)
