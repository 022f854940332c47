"""A motion rendered again after each edit is the one rendered from scratch."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.model import MotionTrack
from hapticplayer.rendering import washout
from hapticplayer.rendering.effects import (
    EFFECTS,
    NO_EFFECTS,
    Effect,
    EffectList,
    Target,
)
from hapticplayer.sequence.presets import PRESETS, Rendering, render_preset

LENGTH_S = 70.0


def ride():
    """Return a motion that pushes hands too far in each of the washout's pieces."""
    t = np.arange(0.0, LENGTH_S, 0.01)
    along = 9.0 * np.sign(np.sin(2.0 * np.pi * 0.11 * t)) + np.sin(t**1.5)
    acceleration = np.stack([along, 0.3 * along, np.cos(3.0 * t)], axis=1)
    count = len(t)
    return MotionTrack(
        time_s=t,
        acceleration_mps2=acceleration,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool),
    )


RIDE = ride()


@pytest.fixture
def short_solutions(monkeypatch):
    """Few iterations: how good a solution is has its own tests."""
    monkeypatch.setattr(washout, "MOST_ITERATIONS", 12)


starts = st.floats(0.0, LENGTH_S)
lengths = st.floats(0.01, 30.0)
kinds = st.sampled_from([kind.name for kind in EFFECTS])
additions = st.builds(
    lambda kind, start_s, length_s, target: Effect(
        kind, start_s, start_s + length_s, target, fade_in_s=0.2 * length_s
    ),
    kinds,
    starts,
    lengths,
    st.sampled_from(Target),
)
edits = st.one_of(
    additions.map(lambda new: ("add", new)),
    st.floats(-30.0, 30.0).map(lambda by_s: ("move", by_s)),
    st.sampled_from([("switch", None), ("remove", None), ("swap", None)]),
)


def edited(effects, edit):
    what, value = edit
    every = list(effects.effects)
    if what == "add":
        every.append(value)
    elif what == "swap":
        every.reverse()
    elif every and what == "move":
        every[-1] = every[-1].moved(value)
    elif every and what == "switch":
        every[0] = replace(every[0], enabled=not every[0].enabled)
    elif every:
        every.pop()
    return EffectList(tuple(every))


def assert_same(one, other):
    assert one.time_s.tobytes() == other.time_s.tobytes()
    assert one.force_n.tobytes() == other.force_n.tobytes()
    assert one.provenance == other.provenance


@pytest.mark.parametrize("preset", [one.name for one in PRESETS])
@pytest.mark.usefixtures("short_solutions")
def test_any_edits_give_the_bits_of_a_new_rendering(preset):
    @settings(max_examples=12)
    @given(st.lists(edits, min_size=1, max_size=5))
    def check(several):
        rendering, effects = Rendering(RIDE, name=preset), NO_EFFECTS
        for edit in several:
            effects = edited(effects, edit)
            wanted = render_preset(RIDE, name=preset, effects=effects)
            assert_same(rendering.track(effects), wanted)

    check()


@pytest.mark.usefixtures("short_solutions")
def test_only_pieces_that_an_edit_reaches_are_solved(monkeypatch):
    lengths = []
    solve = washout.solve

    def counted(force_n, limits):
        lengths.append(force_n.shape[1])
        return solve(force_n, limits)

    monkeypatch.setattr(washout, "solve", counted)
    rendering = Rendering(RIDE, name="equal")
    rendering.track()
    whole = len(lengths)
    rendering.track(EffectList((Effect("knock", 5.0, 5.5),)))
    assert whole >= 3
    assert len(lengths) == whole + 1  # it lies in the first piece only
    rendering.track()
    assert len(lengths) == whole + 1  # as it was before
