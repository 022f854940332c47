import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.plots.series import (
    LONGEST_HALF_S,
    MOST_POINTS,
    TRAIL_STEP_S,
    Page,
    Trail,
    cut,
    half_range,
    sampled,
    thin,
)
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack, Reconstruction


def page(count: int, seed: int = 0) -> Page:
    values = np.random.default_rng(seed).standard_normal((count, 3))
    return Page(np.arange(count) / 200.0, values)


@given(st.integers(0, 5000), st.integers(10, 800))
def test_thinning_keeps_every_peak_and_no_more_points_than_asked(count, most):
    whole = page(count)
    thinned = thin(whole, most)
    assert len(thinned.time_s) == len(thinned.values) <= max(most, 2)
    assert np.all(np.diff(thinned.time_s) > 0)
    if count:
        assert np.array_equal(thinned.values.max(axis=0), whole.values.max(axis=0))
        assert np.array_equal(thinned.values.min(axis=0), whole.values.min(axis=0))


def test_a_short_page_is_not_thinned():
    whole = page(MOST_POINTS)
    assert thin(whole) is whole


@given(st.floats(-5, 30), st.floats(0, 12))
def test_a_cut_covers_the_span_and_one_row_beyond(first_s, length_s):
    whole = page(4000)  # 0 to 20 s
    last_s = first_s + length_s
    part = cut(whole.time_s, whole.values, first_s, last_s)
    inside = (whole.time_s >= first_s) & (whole.time_s <= last_s)
    assert np.isin(whole.time_s[inside], part.time_s).all()
    assert len(part.time_s) <= inside.sum() + 2


def test_a_sparse_held_track_is_drawn_as_steps():
    track = ForceTrack(
        np.array([0.0, 1.0, 2.0]),
        np.array([[0, 0, 0], [2, 0, 0], [1, 0, 0]], np.float32),
        Reconstruction.HOLD,
    )
    shown = sampled(track, 0.5, 1.5)
    assert set(shown.values[:, 0]) == {0.0, 2.0}
    assert np.all((shown.values[:, 0] > 0) == (shown.time_s >= 1.0))


@pytest.mark.parametrize(
    ("peak", "least", "shown"), [(0.0, 1.0, 1.0), (4.5, 1.0, 5.0), (19.0, 2.0, 20.0)]
)
def test_an_axis_ends_at_a_round_number(peak, least, shown):
    assert half_range(peak, least) == shown


def ticks(first_s: float, media_s: np.ndarray, force_n: float) -> np.ndarray:
    made = np.zeros(len(media_s), TICK)
    made["monotonic_s"] = first_s + 0.001 * np.arange(1, len(media_s) + 1)
    made["media_s"] = media_s
    made["force_n"][:, 0] = force_n
    return made


def play(trail: Trail, start_s: float, media_s: float, count: int, step: int = 33):
    """Add ticks of a running clip in reads of some."""
    for first in range(0, count, step):
        rows = np.arange(first, min(first + step, count))
        trail.add(ticks(start_s + first * 1e-3, media_s + 1e-3 * rows, 1.0))


def test_a_trail_has_a_point_for_each_10_ms_and_the_newest_tick():
    trail = Trail()
    play(trail, 100.0, 0.0, 1000)
    shown = trail.page()
    assert 100 <= len(shown.time_s) <= 102
    assert shown.time_s[-1] == pytest.approx(0.999)
    assert np.all(np.diff(shown.time_s) >= 0)


def test_a_trail_forgets_what_has_left_the_view():
    trail = Trail()
    play(trail, 100.0, 0.0, 40_000)
    shown = trail.page()
    assert shown.time_s[0] >= 40.0 - LONGEST_HALF_S - 0.3
    assert len(shown.time_s) <= LONGEST_HALF_S / TRAIL_STEP_S + 50


def test_a_seek_begins_a_new_trail():
    trail = Trail()
    play(trail, 100.0, 0.0, 1000)
    play(trail, 101.0, 7.0, 100)
    assert trail.page().time_s[0] == pytest.approx(7.0, abs=0.011)


def test_a_pause_keeps_the_trail_and_shows_the_force_at_rest():
    trail = Trail()
    play(trail, 100.0, 0.0, 1000)
    # the loop had run on for 3 ms before it heard of the pause
    trail.add(ticks(101.0, np.full(50, 0.996), 0.0))
    shown = trail.page()
    assert shown.time_s[0] < 0.02
    assert shown.values[-1, 0] == 0.0
    assert shown.values[-2, 0] == 1.0


def test_ticks_that_are_known_are_not_drawn_twice():
    trail = Trail()
    read = ticks(100.0, 1e-3 * np.arange(500), 1.0)
    trail.add(read)
    before = len(trail.page().time_s)
    trail.add(read)
    assert len(trail.page().time_s) == before
