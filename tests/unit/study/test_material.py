"""The tracks of a study's feedbacks, made when its sequences are opened."""

import json

import numpy as np
import pytest

from hapticplayer.errors import StudyError
from hapticplayer.model import ForceTrack
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.source import Source, open_source
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.pack import pack
from hapticplayer.study import session_setup
from hapticplayer.study.creation import change_definition
from hapticplayer.study.session_setup import load_study_sources
from hapticplayer.study.study_folder import open_study

KEYS = ("bike", "horse", "car-turning", "car-braking")


def with_sequences(study, folder_of, feedbacks):
    """Return the study with other feedbacks, and the folder of each sequence."""
    study = open_study(study.folder)
    content = {**json.loads(study.content), "feedbacks": list(feedbacks)}
    for entry in content["sequences"]:
        entry["folder"] = str(folder_of(entry["key"]))
    return change_definition(study, content)


@pytest.fixture
def material(study, monkeypatch, tmp_path, tiny_clip):
    """Load the study, whose sequence k has a force of (k + 1) sin((k + 1) t)."""
    time_s = np.arange(0.0, 20.0, 0.005)

    def track(number):
        return np.sin(number * time_s)[:, None] * [number, 1.0, 0.5 * number]

    def opened(path):
        number = 1 + KEYS.index(path.name)
        made = ForceTrack(time_s, track(number))
        tracks = {"realistic": made, "none": made, "mine": made}
        return Source(path.name, path, tiny_clip, tracks, None, "realistic")

    monkeypatch.setattr(session_setup, "open_source", opened)
    monkeypatch.setattr(session_setup, "demonstration_source", lambda: None)

    def folder_of(key):
        folder = tmp_path / key
        folder.mkdir(exist_ok=True)
        (folder / "sequence.json").write_text("{}")
        return folder

    return lambda *chosen: (
        load_study_sources(with_sequences(study, folder_of, chosen)).sources
    )


def test_each_sequence_has_the_tracks_of_the_study_alone(material):
    late = {"key": "late", "condition": "delayed", "parameters": {"delay_s": 0.5}}
    sources = material("realistic", late, "inverted", "mine")
    for source in sources.values():
        assert list(source.tracks) == ["realistic", "late", "inverted", "mine"]
        whole = source.tracks["realistic"]
        at_s = np.array([3.0, 7.7])
        assert source.tracks["late"].at(at_s + 0.5) == pytest.approx(whole.at(at_s))
        assert np.array_equal(source.tracks["inverted"].force_n, -whole.force_n)


@pytest.mark.parametrize(
    ("parameters", "felt"),
    [
        ({}, ("horse", "car-turning", "car-braking", "bike")),
        ({"of": "horse"}, ("horse", "car-turning", "horse", "horse")),
    ],
)
def test_shuffled_is_the_next_sequence_or_the_one_named(material, parameters, felt):
    sources = material("none", {"condition": "shuffled", "parameters": parameters})
    for source, other in zip(sources.values(), felt, strict=True):
        track, own = source.tracks["shuffled"], source.tracks["none"]
        assert track.rms_n() == pytest.approx(own.rms_n(), rel=1e-3)
        wanted = np.sin((1 + KEYS.index(other)) * track.time_s[:-1])
        found = track.force_n[:-1, 0]
        assert np.corrcoef(found, wanted)[0, 1] == pytest.approx(1.0, abs=1e-6)


def test_a_feedback_that_cannot_be_made_is_named_by_its_place(material):
    with pytest.raises(StudyError, match=r"feedbacks\[1\].*'bike'.*no effect"):
        material("none", "edited")
    with pytest.raises(StudyError, match=r"feedbacks\[1\].*'bike'.*realistic, none"):
        material("none", "strong")


OFF = {"key": "plain", "condition": "realistic", "parameters": {"effects": "off"}}


def test_edited_force_is_compared_with_the_force_without(study, sequence_folder):
    plain = open_source(sequence_folder).tracks["realistic"]
    set_effects(sequence_folder, EffectList((Effect("mute", 1.0, 1.5),)))
    compared = with_sequences(study, lambda _key: sequence_folder, [OFF, "edited"])
    source = load_study_sources(compared).sources["bike"]
    assert np.array_equal(source.tracks["plain"].force_n, plain.force_n)
    at_s = np.linspace(1.01, 1.49, 30)
    assert not source.tracks["edited"].at(at_s).any()
    assert plain.at(at_s).any()


def test_an_edited_force_is_not_compared_with_itself(study, sequence_folder):
    set_effects(sequence_folder, EffectList((Effect("mute", 1.0, 1.5),)))
    same = with_sequences(study, lambda _key: sequence_folder, ["realistic", "edited"])
    with pytest.raises(StudyError, match=r"'bike'.*are the same force.*\"off\""):
        load_study_sources(same)


def test_a_packed_sequence_keeps_its_edited_force(sequence_folder, tmp_path):
    set_effects(sequence_folder, EffectList((Effect("mute", 1.0, 1.5),)))
    pack(sequence_folder, tmp_path / "ride.mkv")
    source, name = with_feedback(open_source(tmp_path / "ride.mkv"), "edited")
    whole = open_source(sequence_folder).tracks["realistic"]
    assert np.array_equal(source.tracks[name].force_n, whole.force_n)
