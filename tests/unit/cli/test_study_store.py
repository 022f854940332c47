"""The commands of the analysis on real folders of studies."""

import json

import pytest

from hapticplayer import cli

PAPER = {"none": (7.5, 2.1), "random": (10.2, 1.6), "realistic": (15.3, 2.6)}


def test_simulated_participants_give_the_results_of_the_paper(tmp_path, capsys):
    study = str(tmp_path / "study")
    simulate = ["study", "simulate", study, "--participants", "15"]
    assert cli.main([*simulate, "--effect", "paper"]) == 0
    capsys.readouterr()
    assert cli.main(["study", "analyse", study, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    for feedback, (mean, sd) in PAPER.items():
        assert found["qoe"][feedback]["mean"] == pytest.approx(mean, abs=0.06)
        assert found["qoe"][feedback]["sd"] == pytest.approx(sd, abs=0.06)
    assert all(test["p"] < 0.05 for test in found["friedman"].values())


def test_an_empty_folder_becomes_a_study_and_a_full_one_stays(tmp_path, capsys):
    empty, full = tmp_path / "empty", tmp_path / "full"
    empty.mkdir()
    full.mkdir()
    (full / "letter.txt").write_text("mine")
    simulate = ["study", "simulate", "--participants", "1"]
    assert cli.main([*simulate, str(empty)]) == 0
    assert len(list((empty / "sessions").iterdir())) == 1
    assert cli.main([*simulate, str(full)]) == 1
    assert [path.name for path in full.iterdir()] == ["letter.txt"]
    assert "full" in capsys.readouterr().err


def test_a_study_that_is_not_there_is_refused(tmp_path, capsys):
    assert cli.main(["study", "analyse", str(tmp_path / "none")]) == 1
    assert "none" in capsys.readouterr().err
