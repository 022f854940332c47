"""The optimised washout: its optimum, its limit, and what it leaves alone."""

import dataclasses

import numpy as np
import pytest
from scipy import ndimage, optimize

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.rendering import washout as module
from hapticplayer.rendering.washout import DesignHand, Washout, solve, washed_out

HAND = DesignHand((0.45, 0.45, 0.69), (8.6, 8.6, 9.2), 150.0)
YIELDING = dataclasses.replace(HAND, yield_s=0.3, return_s=2.0)
LIMITS = Washout((YIELDING, HAND), 0.022)


def turns(length_s, seed=7):
    """Return smooth forces of up to some 3 N, at 200 Hz, that begin and end at zero."""
    t = np.arange(0.0, length_s, 0.005)
    rng = np.random.default_rng(seed)
    force = np.zeros((len(t), 3))
    for frequency_hz in (0.07, 0.19, 0.41, 1.3):
        phase = rng.uniform(0.0, 2.0 * np.pi, 3)
        force += np.sin(2.0 * np.pi * frequency_hz * t[:, None] + phase)
    force *= np.clip(np.minimum(t, t[-1] - t), 0.0, 1.0)[:, None]
    return ForceTrack(t, force)


def way_matrix(size, count, yield_s, return_s):
    """Return the ways (size, count) along x, m, of unit forces at each sample."""
    s = 2j * np.pi * np.fft.rfftfreq(size, 0.02)[:, None]
    kept = 1.0 - (1.0 / yield_s) / (s + 1.0 / yield_s + 1.0 / return_s)
    ways = (1.0 + 0.01 * s) / (0.45 * s**2 + 8.6 * s + 150.0 * kept)
    return np.fft.irfft(ways * np.fft.rfft(np.eye(size, count), axis=0), size, axis=0)


def test_another_solver_finds_the_same_optimum():
    count, size = 40, 440
    force = np.zeros((3, count))
    force[0, 5:30] = 3.0
    found = solve(force, LIMITS)[0]
    ways = np.concatenate(
        [way_matrix(size, count, 0.3, 2.0), way_matrix(size, count, np.inf, 0.5)]
    )
    f = np.fft.rfftfreq(size, 0.02)[:, None]
    square = (0.09 + (f / 0.5) ** 2) / (1.0 + (f / 0.5) ** 2) / (1.0 + (f / 15.0) ** 4)
    spectra = np.fft.rfft(np.eye(size, count), axis=0) * np.sqrt(square)
    root = np.concatenate([spectra.real, spectra.imag])[:, :count]
    hessian = root.T @ root
    hessian /= force[0] @ hessian @ force[0]

    def cost(u):
        return 0.5 * (u - force[0]) @ hessian @ (u - force[0])

    best = optimize.minimize(
        cost,
        np.zeros(count),
        jac=lambda u: hessian @ (u - force[0]),
        method="SLSQP",
        bounds=[(min(0.0, f) - 0.15, max(0.0, f) + 0.15) for f in force[0]],
        constraints={
            "type": "ineq",
            "fun": lambda u: 1.0 - np.concatenate([ways @ u, -ways @ u]) / 0.022,
            "jac": lambda _u: -np.concatenate([ways, -ways]) / 0.022,
        },
        options={"maxiter": 500, "ftol": 1e-8},
    )
    assert best.success
    assert np.max(np.abs(ways @ found)) < 1.005 * 0.022
    assert np.sqrt(cost(found) / best.fun) == pytest.approx(1.0, abs=0.01)


def test_a_track_within_the_limit_keeps_its_bits():
    track = turns(40.0)
    wide = washed_out(track, dataclasses.replace(LIMITS, reach_m=1.0))
    assert np.array_equal(wide.force_n, track.force_n)
    assert np.array_equal(wide.time_s, track.time_s)
    assert wide.provenance["washout"]["changed_share"] == 0.0


def test_a_quiet_part_of_a_long_track_keeps_its_bits():
    track = turns(120.0)
    force = track.force_n * np.where(track.time_s < 20.0, 1.0, 0.01)[:, None]
    track = ForceTrack(track.time_s, force)
    done = washed_out(track, LIMITS)
    is_late = track.time_s > 60.0
    assert np.array_equal(done.force_n[is_late], track.force_n[is_late])
    assert not np.array_equal(done.force_n[~is_late], track.force_n[~is_late])


def test_equal_arguments_give_equal_bits():
    one, two = (washed_out(turns(50.0), LIMITS) for _ in range(2))
    assert np.array_equal(one.force_n, two.force_n)


def test_pieces_join_as_if_solved_in_one(monkeypatch):
    track = turns(75.0)
    pieces = washed_out(track, LIMITS).force_n
    monkeypatch.setattr(module, "PIECE_S", 1000.0)
    whole = washed_out(track, LIMITS).force_n
    away = np.abs(whole - track.force_n)
    assert away.max() > 0.5
    # both stop within 0.5 % of the limit, 22 mm of 150 N/m: 0.02 N, and vectors turn
    assert np.abs(pieces - whole).max() < 0.1
    steps = [np.abs(np.diff(one, axis=0)).max() for one in (pieces, whole)]
    assert steps[0] < 1.1 * steps[1]


def test_a_hand_that_remembers_stays_within_across_pieces():
    t = np.arange(0.0, 70.0, 0.02)
    force = np.zeros((len(t), 3))
    force[:, 0] = 0.45 + 0.25 * np.sin(2.0 * np.pi * 0.1 * t)
    done = washed_out(ForceTrack(t, force), LIMITS).force_n[:, 0].astype(float)
    s = 2j * np.pi * np.fft.rfftfreq(len(t) + 1000, 0.02)
    kept = 1.0 - (1.0 / 0.3) / (s + 1.0 / 0.3 + 0.5)
    ways = (1.0 + 0.01 * s) / (0.45 * s**2 + 8.6 * s + 150.0 * kept)
    way_m = np.fft.irfft(ways * np.fft.rfft(done, len(t) + 1000))
    assert np.abs(way_m).max() < 1.01 * 0.022


def test_force_keeps_its_side_and_its_limit():
    track = turns(40.0)
    done = washed_out(track, LIMITS).force_n.astype(float)
    force = track.force_n.astype(float)
    # the bound is kept at 50 Hz; between, that of the neighbours, four entries away
    low = ndimage.minimum_filter1d(np.minimum(0.0, force), 9, axis=0) - 0.15
    high = ndimage.maximum_filter1d(np.maximum(0.0, force), 9, axis=0) + 0.15
    assert np.all((done > low - 0.01) & (done < high + 0.01))
    assert np.linalg.norm(done, axis=1).max() < 4.5 + 1e-6


def test_long_lines_get_entries_to_be_washed_out():
    track = ForceTrack(
        np.array([0.0, 1.0, 11.0, 12.0]), [[0, 0, 0], *[[3, 0, 0]] * 2, [0, 0, 0]]
    )
    done = washed_out(track, LIMITS)
    assert np.isin(track.time_s, done.time_s).all()
    middle = done.at(np.array([9.0]))[0, 0]
    # a yielding hand of 19.6 N/m at rest bears 0.43 N within 22 mm
    assert middle == pytest.approx(0.022 * 150.0 * (1.0 - 2.0 / 2.3), abs=0.1)


def test_a_track_that_holds_is_refused():
    track = ForceTrack(np.array([0.0]), [[1, 0, 0]], Reconstruction.HOLD)
    with pytest.raises(InputError, match="straight lines"):
        washed_out(track, LIMITS)
