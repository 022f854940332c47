"""Conditions of what can be played, made when they are chosen."""

from dataclasses import replace

import numpy as np
import pytest
from msgspec import structs

from hapticplayer.errors import UsageError
from hapticplayer.model import ForceTrack, Mapping, PresetName
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.source import open_source
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.description import TrackEntry
from hapticplayer.sequence.editing import _put, set_effects, set_mapping
from hapticplayer.sequence.presets import PRESETS, render_preset


@pytest.fixture
def source(sequence_folder):
    return open_source(sequence_folder)


def test_a_stored_track_is_played_as_it_is(source):
    assert with_feedback(source, None) == (source, "realistic")
    assert with_feedback(source, "random")[0] is source


def test_a_derived_condition_is_added_under_its_text(source):
    made, name = with_feedback(source, "delayed:delay_s=0.25")
    assert name == "delayed:delay_s=0.25"
    late, whole = made.tracks[name], source.tracks["realistic"]
    assert late.time_s == pytest.approx(whole.time_s + 0.25)
    assert source.tracks.keys() == {"realistic", "none", "random"}


def test_another_preset_is_what_render_would_write(source):
    set_mapping(source.path, Mapping(gain_n_per_mps2=2.0))
    source = open_source(source.path)
    made, name = with_feedback(source, "realistic:preset=equal")
    sequence = open_sequence(source.path)
    wanted = render_preset(sequence.motion, sequence.mapping, name="equal")
    assert np.array_equal(made.tracks[name].force_n, wanted.force_n)
    assert made.tracks[name].provenance["preset"] == "equal"
    same, name = with_feedback(source, "realistic:preset=faithful")
    whole = source.tracks["realistic"]
    assert np.array_equal(same.tracks[name].force_n, whole.force_n)


def test_every_preset_has_a_name_that_conditions_know():
    assert [one.name for one in PRESETS] == list(PresetName)


def test_the_force_of_another_folder(source, sequence_folder):
    made, name = with_feedback(source, f"shuffled:of={sequence_folder}")
    rms_n = source.tracks["realistic"].rms_n()
    assert made.tracks[name].rms_n() == pytest.approx(rms_n, rel=1e-4)
    with pytest.raises(UsageError, match="choose its folder"):
        with_feedback(source, "shuffled")


def test_a_track_of_a_conditions_name_comes_first(source, sequence_folder):
    with pytest.raises(UsageError, match="no effect is switched on"):
        with_feedback(source, "edited")
    track = ForceTrack([0.0, 1.0], np.ones((2, 3)))
    _add(sequence_folder, track)
    made, _ = with_feedback(open_source(sequence_folder), "edited")
    assert np.array_equal(made.tracks["edited"].force_n, track.force_n)


def test_the_force_with_effects_and_without_them(source):
    plain = source.tracks["realistic"]
    mute = EffectList((Effect("mute", 1.0, 1.5),))
    set_effects(source.path, mute)
    source = open_source(source.path)
    edited = with_feedback(source, "edited")[0].tracks["edited"]
    assert not edited.at(np.linspace(1.01, 1.49, 40)).any()
    name = "realistic:effects=off"
    off = with_feedback(source, name)[0].tracks[name]
    assert np.array_equal(off.force_n, plain.force_n)
    assert off.provenance == plain.provenance
    set_effects(source.path, EffectList((replace(mute.effects[0], enabled=False),)))
    with pytest.raises(UsageError, match="no effect is switched on"):
        with_feedback(open_source(source.path), "edited")


def _add(folder, track):
    description = open_sequence(folder).description
    entry = TrackEntry("force_1.npz", 1.0, (1.0,) * 3)
    feedbacks = {**description.feedbacks, "edited": entry}
    changed = structs.replace(description, feedbacks=feedbacks)
    _put(folder, changed, {"force_1.npz": track})


@pytest.mark.parametrize("text", ["strong", "strong:x=1", "nothing"])
def test_an_unknown_feedback_is_wrong_usage(source, text):
    with pytest.raises(UsageError, match="realistic, none, random"):
        with_feedback(source, text)


def test_a_video_alone_has_nothing_to_derive_from(tiny_clip):
    source = open_source(tiny_clip.path)
    with pytest.raises(UsageError, match="no realistic feedback"):
        with_feedback(source, "inverted")
    with pytest.raises(UsageError, match="choose one of none"):
        with_feedback(source, "realistic")
