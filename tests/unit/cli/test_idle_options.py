"""An option that would have no effect in a combination is refused by its name."""

import argparse
import json
import re

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.cli import recording_options
from hapticplayer.cli.recording_options import OF_A_RECORDING
from hapticplayer.errors import HapticPlayerError
from hapticplayer.model import ForceTrack
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    read_force,
    read_formats,
    written_formats,
)
from tests.needed_extras import needs

VALUES = {
    "--calibration": "x.json",
    "--method": "vqf",
    "--mounting": "forward",
    "--read-as": "axes=x,y,z",
    "--sync": "pats",
}
"""Of options that take no number."""


@pytest.fixture
def refused(capsys):
    """Runs a command; the sentence with which it is refused."""

    def run(*words):
        assert cli.main([str(word) for word in words]) == 2
        said = capsys.readouterr()
        assert not said.out
        return said.err

    return run


def options_of_a_recording():
    """Option and metavar, "" for a flag, as the help of `import` shows them."""
    parser = argparse.ArgumentParser()
    recording_options.add_reading(parser)
    recording_options.add_mounting(parser)
    recording_options.add_sync(parser)
    recording_options.add_processing(parser)
    shown = re.findall(
        r"^  (--[a-z-]+)(?: ([A-Z{]\S*))?", parser.format_help(), re.MULTILINE
    )
    return dict(shown)


SHOWN = options_of_a_recording()


@pytest.mark.parametrize("name", sorted({*SHOWN} - {"--overwrite", "--slow-motion"}))
def test_estimated_motion_takes_no_option_of_a_recording(name, refused, tmp_path):
    assert name in OF_A_RECORDING
    words = [f"{name}={VALUES.get(name, 1)}" if SHOWN[name] else name]
    said = refused(
        "import", "clip.mp4", "-o", tmp_path / "x", "--suggest-motion", *words
    )
    assert f"{name} would have no effect" in said
    assert "--suggest-motion" in said


@pytest.mark.parametrize(
    ("words", "option"),
    [
        (["play", "a.mp4", "--headless", "--fullscreen"], "--fullscreen"),
        (["play", "a.mp4", "--headless", "--no-plots"], "--no-plots"),
        (["play", "a.mp4", "--headless", "--close-at-end"], "--close-at-end"),
        (["sync", "a.mp4", "--check", "--offset=1"], "--offset"),
        (["sync", "a.mp4", "--check", "--slow-motion=1"], "--slow-motion"),
        (["import", "a.mp4", "--drift=1", "-o", "x"], "--drift"),
        (["sync", "a.mp4", "--check", "--sync=pats"], "--sync"),
        (["sync", "a.mp4", "--check", "--plot=x.png"], "--plot"),
        (["sync", "a.mp4", "--sync=pats", "--offset=1"], "--offset"),
        (["import", "a.mp4", "--sync=pats", "--offset=1", "-o", "x"], "--offset"),
        (["import", "a.mp4", "--camera=C", "--skew=0.1", "-o", "x"], "--camera"),
        (["export", "a.rec", "--feedback=none", "-o", "x.csv"], "--feedback"),
        (["export", "a.rec", "--with-motion", "-o", "x.csv"], "--with-motion"),
        (["export", "a.rec", "--tolerance=0.1", "-o", "x.csv"], "--tolerance"),
        (["study", "power", "--like=a=none"], "--like"),
        (["play", "a.mp4", "--headless", "--overwrite"], "--overwrite"),
        (["import", "a.mp4", "-o", "x", "--overwrite"], "--overwrite"),
        (["sync", "a.mp4", "--overwrite"], "--overwrite"),
        (["process", "a.csv", "--overwrite"], "--overwrite"),
        pytest.param(
            ["device", "measure", "--overwrite"],
            "--overwrite",
            marks=needs("measuring"),
        ),
    ],
)
def test_an_option_without_effect_is_refused_by_name(refused, words, option, tmp_path):
    words = [str(tmp_path / one) if one.startswith("x") else one for one in words]
    said = refused(*words)
    assert f"{option} would have no effect" in said
    assert "leave it out" in said


@pytest.mark.parametrize(
    ("words", "option"),
    [
        (["--allow-network"], "--allow-network"),
        (["--force", "force.csv", "--feedback", "random"], "--force"),
        (["--device", "none", "--scheduling", "normal"], "--scheduling"),
    ],
)
def test_playing_a_sequence_uses_every_option(refused, sequence_folder, words, option):
    force = sequence_folder.parent / "force.csv"
    force.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n0.5,0,1,0\n")
    words = [force if one == "force.csv" else one for one in words]
    said = refused("play", sequence_folder, "--headless", *words)
    assert f"{option} would have no effect" in said


def test_a_video_without_force_has_none_to_accept(refused, tiny_clip):
    said = refused("play", tiny_clip.path, "--headless", "--accept-changed-video")
    assert "--accept-changed-video would have no effect" in said


@needs("web")
def test_a_sequence_to_be_served_has_no_changed_video(refused, sequence_folder):
    said = refused("serve", sequence_folder, "--accept-changed-video")
    assert "--accept-changed-video would have no effect on a sequence" in said


def test_only_options_of_the_command_are_named(refused):
    said = refused("import", "a.mp4", "-o", "x", "--overwrite")
    assert "without --save-template; leave" in said


@needs("formats")
def test_a_record_is_not_written_under_another_formats_name(refused, tmp_path):
    said = refused("export", tmp_path / "ride", "-o", tmp_path / "x.hjif")
    assert "a record is not exported as hjif" in said


@pytest.mark.parametrize("option", ["--read-as", "--mounting"])
def test_a_sequence_is_not_read_as_anything(refused, sequence_folder, option):
    said = refused("process", sequence_folder, option, VALUES[option])
    assert f"{option} would have no effect on {sequence_folder.name}" in said


def test_answers_of_a_study_take_no_plan(refused, tmp_path, capsys):
    study = tmp_path / "s"
    assert cli.main(["study", "simulate", str(study), "--participants", "2"]) == 0
    capsys.readouterr()
    said = refused("study", "power", study, "--effect=none")
    assert "--effect would have no effect with the answers of s" in said


def test_a_skew_without_the_sound_is_refused(
    refused, tiny_clip, still_log, tmp_path, capsys
):
    write_imu_csv(tmp_path / "log.csv", still_log)
    words = ["sync", tiny_clip.path, "--imu", tmp_path / "log.csv", "--offset=0"]
    assert cli.main([str(word) for word in words]) == 0
    capsys.readouterr()
    said = refused(*words, "--skew=0.1")
    assert "the skew of the sound would have no effect" in said


@pytest.fixture(scope="module")
def track():
    time_s = np.arange(0.0, 2.0, 0.01)
    force_n = np.stack(
        [np.sin(5.0 * time_s), np.cos(7.0 * time_s), 0.3 * time_s], axis=1
    )
    return ForceTrack(time_s, force_n.astype(np.float32))


def refusal_of(call):
    try:
        call()
    except HapticPlayerError as refusal:
        return str(refusal)
    return ""


WRITTEN = {"tolerance_n": 0.3, "sample_rate_hz": 2000, "funscript_version": "2.0"}
READ = {
    "full_scale_n": 3.0,
    "direction": (1.0, 0.0, 0.0),
    "stiffness_n_per_m": 90.0,
    "other_is": "force",
}


@pytest.mark.parametrize("choice", WRITTEN)
@pytest.mark.parametrize("name", written_formats())
@needs("formats")
def test_a_choice_changes_the_written_file_or_is_refused(name, choice, track, tmp_path):
    form, plain, other = force_formats()[name], tmp_path / "a", tmp_path / "b"
    export_track(track, plain, form, WriteChoices())
    choices = WriteChoices(**{choice: WRITTEN[choice]})
    refusal = refusal_of(lambda: export_track(track, other, form, choices))
    if refusal:
        assert "has no effect" in refusal
        assert not other.exists()
    else:
        assert other.read_bytes() != plain.read_bytes()


@pytest.mark.parametrize("choice", READ)
@pytest.mark.parametrize(
    "name", [one for one in written_formats() if one in read_formats()]
)
@needs("formats")
def test_a_choice_changes_the_read_force_or_is_refused(name, choice, track, tmp_path):
    form = force_formats()[name]
    path = tmp_path / f"a{form.suffix}"
    export_track(track, path, form, WriteChoices())
    forces = [read_force(path).track.force_n]

    def read():
        choices = ReadChoices(**{choice: READ[choice]})
        forces.append(read_force(path, choices).track.force_n)

    if refusal := refusal_of(read):
        assert "has no effect" in refusal
    else:
        assert not np.array_equal(*forces)


def test_options_of_the_command_line_reach_that_check(
    refused, sequence_folder, tmp_path
):
    target = tmp_path / "a.csv"
    said = refused("export", sequence_folder, "-o", target, "--tolerance=0.1")
    assert "--tolerance has no effect: csv does not use it" in said
    assert not target.exists()
    csv = tmp_path / "in.csv"
    csv.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n0.5,0,1.5,0\n")
    said = refused("import-force", csv, sequence_folder, "--full-scale=2")
    assert "--full-scale has no effect" in said
    assert "in" not in json.loads((sequence_folder / "sequence.json").read_text())


def test_an_effect_that_adds_nothing_takes_no_direction(refused, sequence_folder):
    words = ["effects", sequence_folder, "add", "gain", "--start=0", "--end=1"]
    said = refused(*words, "--direction=1,0,0")
    assert "--direction would have no effect on gain, which adds nothing" in said
