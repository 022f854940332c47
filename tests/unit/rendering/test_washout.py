"""The optimised washout: its limit, what it leaves alone, its memory."""

import dataclasses
import os
import subprocess
import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from scipy import fft, ndimage

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.rendering import washout as module
from hapticplayer.rendering.washout import DesignHand, SolvedPieces, Washout, washed_out

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
    with fft.set_workers(2):
        three = washed_out(turns(50.0), LIMITS)
    assert np.array_equal(one.force_n, two.force_n)
    assert np.array_equal(one.force_n, three.force_n)


PRINTED = """
import hashlib, sys
import numpy as np
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.washout import DesignHand, SolvedPieces, Washout, washed_out

t = np.arange(0.0, 30.0, 0.005)
force = np.stack([np.sin(t), 2.0 * np.cos(0.3 * t), np.sin(2.0 * t)], axis=1)
hands = DesignHand((0.45, 0.45, 0.69), (8.6, 8.6, 9.2), 150.0, 0.3, 2.0),
done = washed_out(ForceTrack(t, force), Washout(hands, 0.022))
assert done.provenance["washout"]["changed_share"] > 0.5
print(hashlib.sha256(done.force_n.tobytes()).hexdigest())
"""


def test_the_number_of_threads_changes_no_bit():
    printed = set()
    for threads in ("1", "4"):
        names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
        environment = {**os.environ, **dict.fromkeys(names, threads)}
        done = subprocess.run(
            [sys.executable, "-c", PRINTED],
            cwd=Path(module.__file__).parents[2],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        printed.add(done.stdout)
    assert len(printed) == 1


def grown_bytes(wash):
    """Return how much more memory 15 min take than 3, and the size of the tracks."""
    wash(turns(30.0))  # loads what is loaded once
    peaks, sizes = [], []
    for minutes in (3.0, 15.0):
        track = turns(60.0 * minutes)
        tracemalloc.start()
        done = wash(track)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        assert done.provenance["washout"]["changed_share"] > 0.5
        sizes.append(done.time_s.nbytes + done.force_n.nbytes)
    return peaks[1] - peaks[0], sizes[1] - sizes[0]


def test_a_longer_track_takes_no_more_memory_to_solve():
    more, size = grown_bytes(lambda track: washed_out(track, LIMITS))
    # the result, the check of its values, and the correction at 50 Hz; solved in one
    # piece it would be 4 times as much
    assert more < 3.0 * size


def test_pieces_that_are_kept_take_the_size_of_the_track():
    more, size = grown_bytes(
        lambda track: washed_out(track, LIMITS, SolvedPieces(LIMITS))
    )
    assert more < 4.5 * size


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
