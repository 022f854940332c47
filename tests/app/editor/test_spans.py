"""Where things lie on the timeline: rows, views, lanes."""

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.editor.lane_painter import boxes
from app.editor.spans import rows_of
from app.editor.view import SHORTEST_S, TimeView

times = st.floats(0.0, 100.0)
spans = st.tuples(times, st.floats(0.001, 50.0)).map(lambda s: (s[0], s[0] + s[1]))


@given(st.lists(spans, max_size=30))
def test_spans_of_a_row_do_not_cover_each_other(found):
    rows = rows_of(found)
    for k, (begin_s, end_s) in enumerate(found):
        for other in range(k):
            if rows[other] == rows[k]:
                assert end_s <= found[other][0] or found[other][1] <= begin_s


@given(st.lists(spans, min_size=1, max_size=30))
def test_there_are_as_many_rows_as_spans_at_once(found):
    at_once = max(sum(b <= begin < e for b, e in found) for begin, _ in found)
    assert max(rows_of(found)) + 1 == at_once


@given(
    st.floats(0.1, 5000.0),
    st.lists(st.tuples(st.floats(0.01, 100.0), st.floats(0.0, 1.0))),
)
def test_a_view_stays_in_its_clip_and_around_the_pointer(duration_s, zooms):
    view = TimeView(duration_s)
    for factor, share in zooms:
        at_s = view.begin_s + share * view.span_s
        x_before = view.x_of(at_s, 1000.0)
        view.zoom(factor, at_s)
        assert 0.0 <= view.begin_s < view.end_s <= duration_s
        assert view.span_s >= min(SHORTEST_S, duration_s) * (1.0 - 1e-6)
        is_inside = view.begin_s > 0.0 and view.end_s < duration_s
        if is_inside:
            scale = 1e-6 * max(1.0, duration_s / view.span_s)
            assert view.x_of(at_s, 1000.0) == pytest.approx(x_before, abs=scale)


def test_a_view_moves_to_what_it_does_not_show():
    view = TimeView(60.0)
    view.show_span(10.0, 20.0)
    view.reveal(15.0)
    assert (view.begin_s, view.end_s) == (10.0, 20.0)
    view.reveal(40.0)
    assert (view.begin_s, view.end_s) == (39.0, 49.0)
    view.pan(100.0)
    assert (view.begin_s, view.end_s) == (50.0, 60.0)
    assert view.time_at(500.0, 1000.0) == pytest.approx(55.0)
    view.show_whole()
    assert view.time_at(-20.0, 1000.0) == 0.0  # not before the clip


@pytest.mark.parametrize(("height", "rows"), [(210, 0), (210, 9), (900, 3)])
def test_the_lanes_fill_the_height(height, rows):
    lanes = boxes(640, height, rows)
    flat = [lanes.ruler, *lanes.axes, lanes.sound, lanes.events, lanes.effects]
    assert flat[0].top() == 0.0
    for above, below in itertools.pairwise(flat):
        assert above.bottom() == pytest.approx(below.top())
        assert above.height() >= 15.0
    assert flat[-1].bottom() == pytest.approx(height)
