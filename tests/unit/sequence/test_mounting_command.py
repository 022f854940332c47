"""The mounting of a recorder is asked for, applied and stored."""

import json

import numpy as np
import pytest

from hapticplayer.capture.mounting import mounted
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.cli import main
from hapticplayer.sequence import build, open_sequence


@pytest.fixture
def hanging(tmp_path, still_log):
    """A log whose recorder hung upside down: half a turn about its front."""
    path = tmp_path / "log.csv"
    write_imu_csv(path, mounted(still_log, "-x,y,-z"))
    return path


def run(tiny_clip, log, target, *more):
    rest = ("--offset", "0", "-o", str(target), *more)
    return main(["import", str(tiny_clip.path), "--imu", str(log), *rest])


def test_an_import_asks_for_a_recorder_that_hung(tmp_path, tiny_clip, hanging, capsys):
    target = tmp_path / "ride"
    assert run(tiny_clip, hanging, target) == 2
    words = capsys.readouterr().err
    assert "gravity shows that -z of the recorder was up" in words
    assert "--mounting upside-down" in words
    assert "or auto for what the frames tell" in words
    assert not target.exists()


@pytest.mark.parametrize("said", ["upside-down", "-x,y,-z"])
def test_a_mounting_rotates_the_motion_and_is_stored(
    tmp_path, tiny_clip, hanging, still_log, said
):
    assert run(tiny_clip, hanging, tmp_path / "ride", f"--mounting={said}") == 0
    sequence = open_sequence(tmp_path / "ride")
    made_of = sequence.description.provenance
    assert made_of["mounting"] == "-x,y,-z"
    assert not any("gravity shows" in note for note in made_of["notes"])
    with np.load(tmp_path / "ride" / "imu.npz") as kept:
        np.testing.assert_allclose(
            kept["specific_force_mps2"], still_log.specific_force_mps2, atol=1e-6
        )


def test_a_mounting_against_gravity_gets_a_note(tmp_path, tiny_clip, hanging):
    assert run(tiny_clip, hanging, tmp_path / "ride", "--mounting", "forward") == 0
    made_of = open_sequence(tmp_path / "ride").description.provenance
    assert made_of["mounting"] == "x,y,z"
    assert any("-z of the recorder was up" in note for note in made_of["notes"])


def test_the_mounting_that_frames_show_is_stored_and_printed(
    tmp_path, tiny_clip, hanging, monkeypatch, capsys
):
    shown = FoundMounting("-x,y,-z", 4.04, "x,y,z")
    monkeypatch.setattr(build, "mounting_by_frames", lambda *_given: shown)

    assert run(tiny_clip, hanging, tmp_path / "ride", "--mounting", "auto") == 0

    assert "mounting -x,y,-z by the frames, ratio 4.0\n" in capsys.readouterr().out
    made_of = open_sequence(tmp_path / "ride").description.provenance
    assert made_of["mounting"] == "-x,y,-z"
    assert made_of["mounting_by_frames"] == shown.described()


def test_process_rotates_too_or_adds_a_note(hanging, capsys):
    def notes(*more):
        assert main(["process", str(hanging), "--json", *more]) == 0
        return " ".join(json.loads(capsys.readouterr().out)["notes"])

    assert "-z of the recorder was up" in notes()
    assert "was up" not in notes("--mounting", "upside-down")


@pytest.mark.parametrize("said", ["sideways", "x,y", "x,y,-z", ""])
def test_an_unknown_mounting_is_refused(hanging, capsys, said):
    assert main(["process", str(hanging), f"--mounting={said}"]) == 2
    assert "upside-down" in capsys.readouterr().err


def test_a_sequence_is_not_rotated_again(sequence_folder, capsys):
    assert main(["process", str(sequence_folder), "--mounting", "backward"]) == 2
    assert "is a sequence" in capsys.readouterr().err


def test_a_mounting_that_turns_the_wearer_over_is_refused(
    tmp_path, tiny_clip, swing, capsys
):
    log = tmp_path / "upright.csv"
    write_imu_csv(log, swing[0])
    wrong = ("--mounting", "upside-down")
    assert run(tiny_clip, log, tmp_path / "ride", *wrong) == 2
    assert "the wearer was upside down" in capsys.readouterr().err
    assert not (tmp_path / "ride").exists()
    assert main(["process", str(log), *wrong]) == 2
    turned = ("--read-as", "axes=-x,y,-z")
    assert run(tiny_clip, log, tmp_path / "ride", *turned) == 2
    assert run(tiny_clip, log, tmp_path / "ride", *turned, "--mounting", "forward") == 0
