"""Changes of a list of effects, undone and redone to the bit."""

from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.editor import edits
from app.editor.document import Document, Handle
from app.editor.spans import Part, Snap, hit, marks_of
from hapticplayer.rendering.effects import EFFECTS, Effect, EffectList, TimeMarker
from hapticplayer.sequence.effects_file import written

CLIP_S = 20.0
kinds = st.sampled_from([kind.name for kind in EFFECTS])
times = st.floats(-5.0, CLIP_S + 5.0)


@st.composite
def any_effect(draw):
    return edits.new_effect(draw(kinds), draw(times), CLIP_S)


steps = st.lists(
    st.tuples(
        st.sampled_from(["add", "move", "stretch", "remove", "switch", "copy"]),
        st.integers(0, 9),
        times,
        kinds,
    ),
    max_size=25,
)


def step(document, what, number, at_s, kind) -> None:
    """Make one change, as the page does."""
    effects = document.effects
    if what == "add" or not len(effects):
        new = edits.new_effect(kind, at_s, CLIP_S)
        document.change(edits.added(effects, new), what)
        return
    number %= len(effects)
    one = effects.effects[number]
    made = {
        "move": lambda: edits.moved(one, at_s, CLIP_S),
        "stretch": lambda: edits.stretched(
            one, Part.START if at_s < 8.0 else Part.END, at_s, CLIP_S
        ),
        "switch": lambda: replace(one, enabled=not one.enabled),
    }
    if what == "remove":
        document.change(edits.removed(effects, [number]), what)
    elif what == "copy":
        new = edits.copies_at([one], at_s, CLIP_S)
        document.change(edits.added(effects, *new), what)
    else:
        changed = edits.replaced(effects, {number: made[what]()})
        document.change(changed, what, f"{what} {number}")


@given(steps)
def test_undo_and_redo_return_equal_lists_to_the_bit(qapp, done):
    document = Document()
    seen = {document.stack.index(): document.effects}
    for one in done:
        step(document, *one)
        # a gesture that goes on has replaced its last list
        seen = {k: v for k, v in seen.items() if k < document.stack.index()}
        seen[document.stack.index()] = document.effects
    for index in reversed(range(document.stack.count() + 1)):
        document.stack.setIndex(index)
        assert written(document.effects) == written(seen[index])
    for index in range(document.stack.count() + 1):
        document.stack.setIndex(index)
        assert document.effects == seen[index]
    assert document.stack.undoLimit() == 0  # none


@given(any_effect(), times)
def test_a_move_stays_in_the_clip_and_keeps_the_length(effect, by_s):
    moved = edits.moved(effect, by_s, CLIP_S)
    assert 0.0 <= moved.start_s < moved.end_s <= CLIP_S + 1e-9
    assert moved.duration_s == pytest.approx(effect.duration_s, abs=2e-6)
    if effect.start_s + by_s >= 0.0 and effect.end_s + by_s <= CLIP_S:
        assert moved.start_s == pytest.approx(effect.start_s + by_s, abs=1e-6)


@given(any_effect(), st.sampled_from([Part.START, Part.END]), times)
def test_a_stretch_keeps_the_other_end_and_valid_fades(effect, part, to_s):
    made = edits.stretched(effect, part, to_s, CLIP_S)
    if part is Part.START:
        assert made.end_s == effect.end_s
    else:
        assert made.start_s == effect.start_s
    assert 0.0 <= made.start_s < made.end_s <= CLIP_S
    assert made.fade_in_s + made.fade_out_s <= made.duration_s * (1 + 1e-9)


def test_control_points_keep_their_place_in_a_stretched_effect():
    effect = Effect("gain", 2.0, 4.0, curve=((0.0, 1.0), (1.0, 2.0), (2.0, 1.0)))
    made = edits.stretched(effect, Part.END, 6.0, CLIP_S)
    assert made.curve == ((0.0, 1.0), (2.0, 2.0), (4.0, 1.0))


def test_a_drag_is_one_step_and_none_where_it_leads_back(qapp):
    first = Effect("mute", 1.0, 2.0)
    document = Document(EffectList((first,)))
    for by_s in (0.1, 0.2, 0.3):
        moved = edits.moved(first, by_s, CLIP_S)
        document.change(EffectList((moved,)), "Move", "drag 1")
    assert document.stack.count() == 1
    assert document.effect.start_s == pytest.approx(1.3)
    document.change(EffectList((first,)), "Move", "drag 1")
    assert document.stack.count() == 0
    assert document.stack.isClean()


def test_a_saved_edit_is_never_merged_into(qapp):
    first = Effect("mute", 1.0, 2.0)
    document = Document(EffectList((first,)))
    document.change(EffectList((edits.moved(first, 0.1, 9.0),)), "Move", "keys")
    document.stack.setClean()
    document.change(EffectList((edits.moved(first, 0.2, 9.0),)), "Move", "keys")
    assert not document.stack.isClean()
    document.stack.undo()
    assert document.stack.isClean()
    assert document.effect.start_s == pytest.approx(1.1)


def test_undo_selects_what_it_changes(qapp):
    every = [Effect("mute", k, k + 0.5) for k in range(3)]
    document = Document(EffectList(tuple(every)))
    document.select(2)
    document.change(edits.removed(document.effects, [1]), "Delete")
    assert document.selected == 1
    document.select(0)
    document.stack.undo()
    assert document.selected == 1
    assert document.effect == every[1]


def test_the_pointer_takes_ends_and_the_top_most():
    spans = [(0.0, 100.0), (50.0, 150.0), None]
    assert hit(spans, 2.0, 5.0) == (0, Part.START)
    assert hit(spans, -4.0, 5.0) == (0, Part.START)
    assert hit(spans, 20.0, 5.0) == (0, Part.BODY)
    assert hit(spans, 70.0, 5.0) == (1, Part.BODY)
    assert hit(spans, 148.0, 5.0) == (1, Part.END)
    assert hit(spans, 160.0, 5.0) is None
    assert hit([(10.0, 16.0)], 13.0, 5.0) == (0, Part.BODY)  # short, but movable


@given(times, st.lists(st.floats(0.0, CLIP_S), max_size=9))
def test_snapping_goes_to_a_near_mark_or_a_frame(time_s, marks_s):
    snap = Snap(tuple(marks_s), 0.05, 0.04)
    found_s = snap.at(time_s)
    if found_s not in marks_s:
        assert found_s / 0.04 == pytest.approx(round(found_s / 0.04), abs=1e-6)
        assert all(abs(mark - time_s) > 0.05 for mark in marks_s)
    assert abs(found_s - time_s) <= 0.05 + 1e-9


def test_a_moved_span_snaps_with_its_nearer_end():
    snap = Snap(marks_of([(3.0, 5.0)]), 0.05, 1.0 / 30.0)
    assert snap.shift((1.0, 2.0), 2.03) == pytest.approx(2.0)  # begin to 3
    assert snap.shift((1.0, 2.0), 2.98) == pytest.approx(3.0)  # end to 5
    shift_s = snap.shift((1.0, 2.0), 0.512)
    assert 30.0 * (1.0 + shift_s) == pytest.approx(round(30.0 * (1.0 + shift_s)))


# --- several, points, markers ----------------------------------------------------


def test_several_keep_their_distances_and_stop_together():
    every = [Effect("mute", 2.0, 3.0), Effect("mute", 5.0, 6.5)]
    later = edits.moved_together(every, 100.0, CLIP_S)
    # the last may end at 20 s: 13.5 s later
    assert [(one.start_s, one.end_s) for one in later] == [(15.5, 16.5), (18.5, 20.0)]
    earlier = edits.moved_together(every, -100.0, CLIP_S)
    assert [(one.start_s, one.end_s) for one in earlier] == [(0.0, 1.0), (3.0, 4.5)]
    copies = edits.copies_at(every, 10.0, CLIP_S)
    assert [one.start_s for one in copies] == [10.0, 13.0]


def test_undo_selects_all_that_it_brings_back(qapp):
    every = [Effect("mute", k, k + 0.5) for k in range(4)]
    document = Document(EffectList(tuple(every)))
    document.select(1, 3)
    document.change(edits.removed(document.effects, document.selection), "Delete")
    assert [one.start_s for one in document.effects.effects] == [0.0, 2.0]
    document.stack.undo()
    assert document.effects.effects == tuple(every)
    assert document.selection == (1, 3)
    document.stack.redo()
    assert len(document.effects) == 2


def test_the_first_point_leaves_the_rest_as_it_was():
    effect = Effect("gain", 1.0, 3.0, parameters={"gain": 1.2})
    made, point = edits.with_new_point(effect, 0.5, 2.0)
    assert made.curve == ((0.0, 1.2), (0.5, 2.0), (2.0, 1.2))
    assert point == 1
    again, same = edits.with_new_point(made, 0.5002, None)  # there is one
    assert (again, same) == (made, 1)
    between, point = edits.with_new_point(made, 1.25)
    assert point == 2
    assert between.curve[2] == (1.25, pytest.approx(1.6))  # halfway from 2 to 1.2


@given(st.integers(0, 2), st.floats(-9.0, 9.0), st.floats(-99.0, 99.0))
def test_a_point_stays_between_its_neighbours(point, since_s, value):
    effect = Effect("gain", 1.0, 3.0, curve=((0.0, 1.0), (1.0, 2.0), (2.0, 1.0)))
    made = edits.with_point(effect, point, since_s, value)
    assert made.curve[point][1] == min(max(value, 0.0), 10.0)
    times_s = [time_s for time_s, _ in made.curve]
    assert all(0.0 <= time_s <= 2.0 for time_s in times_s)
    assert all(b - a >= 0.001 - 1e-9 for a, b in pairwise(times_s))
    if all(abs(since_s - one) > 0.01 for one in (0.0, 1.0, 2.0)) and 0 < since_s < 2:
        neighbours = (times_s[:point] or [0.0])[-1], [*times_s[point + 1 :], 2.0][0]
        is_between = neighbours[0] < since_s < neighbours[1]
        assert (times_s[point] == pytest.approx(since_s, abs=1e-6)) == is_between


def test_a_point_that_is_taken_back_is_held_no_more(qapp):
    document = Document(EffectList((Effect("gain", 1.0, 3.0, curve=((0.0, 1.0),)),)))
    document.select(0)
    made, point = edits.with_new_point(document.effect, 1.0)
    document.change(edits.replaced(document.effects, {0: made}), "Add a point")
    document.hold(Handle(Part.POINT, point))
    document.stack.undo()
    assert document.handle is None
    assert document.selection == (0,)


def test_markers_are_in_the_order_of_their_times_and_undone(qapp):
    document = Document()
    for at_s, name in ((2.0, "b"), (1.0, "a")):
        document.change(edits.with_marker(document.effects, at_s, name), "Mark")
    marked = document.effects
    assert marked.markers == (TimeMarker(1.0, "a"), TimeMarker(2.0, "b"))
    document.change(edits.added(document.effects, Effect("mute", 0.0, 1.0)), "Add")
    assert document.effects.markers == marked.markers
    document.change(edits.with_marker(document.effects, 1.0, "new"), "Rename")
    assert document.effects.markers[0].name == "new"
    document.change(
        edits.without_marker(document.effects, TimeMarker(2.0, "b")), "Remove"
    )
    assert document.effects.markers == (TimeMarker(1.0, "new"),)
    while document.stack.canUndo():
        document.stack.undo()
    assert document.effects == EffectList()
