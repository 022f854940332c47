"""Sequences whose motion was estimated from the picture, and where they are marked."""

import json

import numpy as np
import pytest

from hapticplayer.cli import main
from hapticplayer.errors import InputError, StudyError, TelemetryError, UsageError
from hapticplayer.extras.frames import estimate, suggesting, watching
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.source import open_source
from hapticplayer.rendering import render_force
from hapticplayer.sequence import open_sequence, sharing, store
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.comparison import stored_rendering
from hapticplayer.sequence.editing import set_mapping
from hapticplayer.sequence.library import read_entry
from hapticplayer.sequence.packed import read_packed
from hapticplayer.sequence.report import Mark
from hapticplayer.study.creation import create_study
from hapticplayer.study.session_setup import load_study_sources
from tests.unit.capture.conftest import recorded
from tests.unit.extras.frames.made_up import stepping, steps, suggested, turning


@pytest.fixture(scope="module")
def suggest():
    """Stand in for the frames: a bend and steps at 2 Hz, as if they were seen."""
    pytest.importorskip("scipy")

    def made(_clip, *, gain=1.0, progress):
        progress(0.5, "following")
        return suggested(steps(turn_radps=turning, sinking=stepping), gain=gain)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(estimate, "suggest_motion", made)
        yield


@pytest.fixture(scope="module")
def folder(suggest, tiny_clip, tmp_path_factory):
    target = tmp_path_factory.mktemp("estimated") / "ride"
    choices = Choices(title="Ride", seed=5, suggest_gain=2.0)
    return build_sequence(tiny_clip.path, target, choices=choices)


def test_its_tracks_are_estimated_never_realistic(folder):
    sequence = open_sequence(folder)

    assert list(sequence.tracks) == ["estimated", "none", "random"]
    assert sequence.rendered is sequence.tracks["estimated"]
    assert sequence.rendered.is_estimated
    assert sequence.motion.is_estimated
    assert not sequence.tracks["random"].is_estimated
    direct = render_force(sequence.motion, sequence.mapping)
    assert direct.provenance["feedback"] == "estimated"
    assert open_source(folder).feedback == "estimated"


def test_the_provenance_says_that_nothing_measured_it(folder):
    description = open_sequence(folder).description
    made_of = description.provenance

    assert made_of["motion_source"] == "estimated from the picture"
    assert made_of["estimate"]["gain"] == 2.0
    assert any("nothing measured it" in note for note in made_of["notes"])
    assert "synchronisation" not in made_of
    assert store.IMU not in description.files
    with np.load(folder / "estimate.npz") as kept:
        assert kept["sigma_mps2"].shape == kept["trust"].shape == (2000, 2)
        assert (kept["sigma_mps2"] > 0.0).all()
    first = read_entry(folder).findings[0]
    assert (first.name, first.mark) == ("estimate", Mark.DOUBTFUL)
    assert "sync" not in [one.name for one in read_entry(folder).findings]


def test_an_estimate_stays_one_when_rendered_again(folder, tmp_path):
    copy = tmp_path / "copy"
    copy.mkdir()
    store.copy_files(folder, copy)
    mapping = open_sequence(copy).mapping
    set_mapping(copy, mapping, preset="faithful")

    sequence = open_sequence(copy)
    assert list(sequence.tracks) == ["estimated", "none", "random"]
    assert sequence.rendered.is_estimated
    assert stored_rendering(copy).preset == "faithful"


def test_no_condition_is_made_of_an_estimate(folder):
    for name in ("delayed", "inverted", "scaled"):
        with pytest.raises(UsageError, match="estimated from the picture"):
            with_feedback(open_source(folder), name)
    with pytest.raises(UsageError, match="choose one of estimated, none, random"):
        with_feedback(open_source(folder), "realistic")


@pytest.mark.parametrize("form", ["hjif", "ahap", "funscript", "wav", "mpegv"])
def test_an_exported_file_says_it(folder, tmp_path, form, capsys):
    target = tmp_path / "force"
    command = ["export", str(folder), "--format", form, "-o", str(target), "--json"]
    assert main(command) == 0

    said = capsys.readouterr()
    report = json.loads(said.out)
    assert (report["feedback"], report["is_estimated"]) == ("estimated", True)
    assert "estimated from the picture, not measured" in said.err
    assert b"; estimated from the picture, not measured" in target.read_bytes()[:600]
    assert main([*command, "--overwrite"]) == 0  # it knows its own file


def test_a_shared_video_names_it(folder, tmp_path):
    sharing.share(folder, tmp_path / "ride.mkv", with_motion=True)

    packed = read_packed(tmp_path / "ride.mkv")
    assert "force_estimated.hjif" in packed.attached
    assert packed.sequence.motion.is_estimated


def test_a_study_refuses_it_unless_it_is_named(folder, tmp_path):
    with pytest.raises(StudyError, match=r"sequences\[0\].*nothing measured it"):
        create_study(tmp_path / "one", folders={"bike": folder})
    assert not (tmp_path / "one").exists()

    keys = ("bike", "horse", "car-turning", "car-braking")
    named = create_study(
        tmp_path / "two",
        folders=dict.fromkeys(keys, folder),
        feedbacks=("estimated", "none"),
    )
    (first, *_) = named.definition.chosen_feedbacks
    assert "estimated from the picture" in first.text
    tracks = load_study_sources(named).sources["bike"].tracks
    assert tracks["estimated"].is_estimated


def test_a_session_refuses_what_became_an_estimate(folder, sequence_folder, tmp_path):
    keys = ("bike", "horse", "car-turning", "car-braking")
    study = create_study(
        tmp_path / "study", folders=dict.fromkeys(keys, sequence_folder)
    )
    estimated = (folder / store.DESCRIPTION).read_bytes()
    (sequence_folder / store.DESCRIPTION).write_bytes(estimated)

    with pytest.raises(StudyError, match="nothing measured it"):
        load_study_sources(study)


def run(tiny_clip, target, *more):
    return main(["import", str(tiny_clip.path), "-o", str(target), *more])


def test_a_plain_video_is_refused_and_the_option_named(tiny_clip, tmp_path, capsys):
    assert run(tiny_clip, tmp_path / "ride") == 1
    words = capsys.readouterr().err
    assert "--imu LOG" in words
    assert "--suggest-motion" in words


def test_the_command_says_what_was_estimated(suggest, tiny_clip, tmp_path, capsys):
    target = tmp_path / "ride"
    assert run(tiny_clip, target, "--suggest-motion", "--suggest-gain", "0.5") == 0

    words = capsys.readouterr().out
    assert "motion estimated from the picture, not measured; sway in" in words
    assert "gain 0.5" in words
    assert open_sequence(target).description.provenance["estimate"]["gain"] == 0.5


def test_recorded_motion_is_not_estimated(suggest, tiny_clip, tmp_path, capsys):
    log = tmp_path / "log.csv"
    log.write_text("")
    more = ("--suggest-motion", "--imu", str(log))
    assert run(tiny_clip, tmp_path / "ride", *more) == 2
    words = capsys.readouterr().err
    assert "the motion of ride.mp4 was recorded" in words
    assert "import it without an estimate" in words
    assert run(tiny_clip, tmp_path / "ride", "--suggest-gain", "2") == 2
    assert "belongs to --suggest-motion" in capsys.readouterr().err


def test_telemetry_that_cannot_be_read_is_no_recording(
    suggest, tiny_clip, tmp_path, monkeypatch
):
    def unreadable(_video):
        raise TelemetryError("record at least 4 s")

    monkeypatch.setattr(suggesting, "read_recording", unreadable)

    assert run(tiny_clip, tmp_path / "ride", "--suggest-motion") == 0


def test_telemetry_that_can_be_read_is_not_estimated(suggest, tmp_path, capsys):
    clip = recorded("gopro/karma.mp4")

    status = main(["import", str(clip), "--suggest-motion", "-o", str(tmp_path / "a")])

    assert status == 2
    assert "the motion of karma.mp4 was recorded" in capsys.readouterr().err


def test_without_opencv_it_says_what_to_install(tiny_clip, monkeypatch):
    monkeypatch.setattr(watching, "is_available", lambda: False)

    with pytest.raises(InputError, match=r"install hapticplayer\[vision\]"):
        next(watching.watched(tiny_clip.path))


def test_a_picture_that_shows_nothing_makes_no_sequence(
    tiny_clip, tmp_path, monkeypatch
):
    monkeypatch.setattr(
        estimate, "suggest_motion", lambda _clip, **_more: suggested(steps(), speed=0.0)
    )

    with pytest.raises(InputError, match="the camera does not move"):
        build_sequence(
            tiny_clip.path, tmp_path / "ride", choices=Choices(suggest_gain=1.0)
        )
    assert not (tmp_path / "ride").exists()
