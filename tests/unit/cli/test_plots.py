"""A long recording is drawn by few points that show all that matters."""

import numpy as np
import pytest

from hapticplayer.cli.plots import BINS, draw_motion, envelope, invalid_spans
from hapticplayer.sequence.processing import Processing, process_motion


def test_a_short_curve_is_drawn_as_it_is():
    time_s = np.arange(2 * BINS) / 200.0
    assert envelope(time_s, time_s)[0] is time_s


def test_no_peak_of_a_long_curve_is_lost(rng):
    time_s = np.arange(1_000_003) / 200.0
    values = rng.standard_normal(len(time_s))
    values[654_321], values[654_400] = 50.0, -60.0
    drawn_s, drawn = envelope(time_s, values)
    assert len(drawn_s) == len(drawn) == 2 * BINS
    assert (drawn.min(), drawn.max()) == (-60.0, 50.0)
    part_s = time_s[-1] / BINS
    assert drawn_s[np.argmax(drawn)] == pytest.approx(time_s[654_321], abs=part_s)
    assert np.all(np.diff(drawn_s) >= 0.0)


def test_spans_reach_from_the_last_good_sample_to_the_next():
    time_s = np.arange(100.0)
    valid = np.ones(100, dtype=bool)
    valid[[0, 1, 40, 41, 42, 70, 99]] = False
    assert invalid_spans(time_s, valid) == [
        (0.0, 2.0),
        (39.0, 43.0),
        (69.0, 71.0),
        (98.0, 99.0),
    ]
    assert invalid_spans(time_s, np.ones(100, dtype=bool)) == []
    assert invalid_spans(time_s, np.zeros(100, dtype=bool)) == [(0.0, 99.0)]


def test_there_are_never_more_spans_than_can_be_seen():
    time_s = np.arange(200_000) / 200.0
    valid = np.arange(200_000) % 10 != 5
    spans = invalid_spans(time_s, valid)
    assert len(spans) <= BINS
    assert spans[0][0] == time_s[4]
    assert spans[-1][1] == time_s[199_996]


@pytest.mark.parametrize("title", ["a$b_$x^", "\udcff", "<b>&", "名前", ""])
def test_any_name_can_be_a_title(tmp_path, still_log, title):
    done = process_motion(still_log, Processing("lowpass"))
    draw_motion(tmp_path / "a.svg", done, title)
    assert (tmp_path / "a.svg").stat().st_size > 10_000
