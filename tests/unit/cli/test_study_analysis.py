"""`hapticplayer study analyse`, `simulate` and `power` on folders of studies."""

import errno
import itertools
import json
import os

import pytest

from hapticplayer import cli
from hapticplayer.storage import disk_of
from hapticplayer.study.analysis.scores import sample_of, scores_of
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study

PAPER = {"none": (7.5, 2.1), "random": (10.2, 1.6), "realistic": (15.3, 2.6)}


@pytest.fixture(scope="module")
def rides(tmp_path_factory):
    """A study with eight simulated participants."""
    folder = tmp_path_factory.mktemp("studies") / "rides"
    assert cli.main(["study", "simulate", str(folder), "--participants", "8"]) == 0
    return folder


@pytest.fixture
def run(capsys):
    """Run an action; return its status, its JSON or text, and stderr."""

    def run_action(*words):
        status = cli.main(["study", *map(str, words)])
        said = capsys.readouterr()
        out = json.loads(said.out) if "--json" in words and said.out else said.out
        return status, out, said.err

    return run_action


def test_analyse_prints_the_promised_json_and_writes_the_report(run, rides, tmp_path):
    target = tmp_path / "report"
    status, found, _ = run("analyse", rides, "--json", "--output", target)
    assert status == 0
    assert set(found["qoe"]) == {"none", "random", "realistic"}
    assert {"mean", "sd"} <= set(found["qoe"]["none"])
    assert {"chi2", "p", "kendall_w"} <= set(found["friedman"]["qoe"])
    assert json.loads((target / "numbers.json").read_text("utf-8")) == found


def test_analyse_tells_people_what_was_found(run, rides):
    status, said, _ = run("analyse", rides, "--missing", "complete")
    assert status == 0
    assert "8 participants" in said
    assert "none-realistic: Wilcoxon" in said


def test_an_existing_report_is_refused_before_the_work(run, tmp_path):
    status, _, said = run("analyse", tmp_path / "none", "--output", tmp_path)
    assert status == 1
    assert "already exists" in said


def test_simulated_participants_are_marked_and_as_in_the_paper(run, tmp_path):
    study = tmp_path / "study"
    words = ("--participants", "15", "--effect", "paper", "--seed", "4", "--json")
    status, report, _ = run("simulate", study, *words)
    assert status == 0
    answers = read_answers(study)
    assert report["participants"] == [one.code for one in answers.participants]
    assert all(one.simulated for one in answers.participants)
    assert report["simulated"]
    _, found, _ = run("analyse", study, "--json")
    for feedback, (mean, sd) in PAPER.items():
        assert found["qoe"][feedback]["mean"] == pytest.approx(mean, abs=0.06)
        assert found["qoe"][feedback]["sd"] == pytest.approx(sd, abs=0.06)
    assert all(test["p"] < 0.05 for test in found["friedman"].values())


@pytest.mark.parametrize("count", ["0", "-3", "201", "100000", "2.5"])
def test_a_wrong_number_of_participants_makes_no_study(run, tmp_path, count):
    status, _, said = run("simulate", tmp_path / "s", f"--participants={count}")
    assert status == 2
    assert "between 1 and 200" in said
    assert list(tmp_path.iterdir()) == []


def test_consistency_studies_cannot_be_simulated(run, tmp_path):
    study = create_study(tmp_path / "s", "consistency")
    status, _, said = run("simulate", study.folder)
    assert status == 2
    assert "only rating studies" in said
    assert study.codes() == []


def test_other_feedbacks_are_rated_like_those_of_the_paper(run, tmp_path):
    study = tmp_path / "s"
    create_study(study, "controls")
    words = ("--participants", "40", "--seed", "3", "--like", "late=none")
    status, report, _ = run("simulate", study, *words, "--json")
    assert status == 0
    assert report["rated_like"] == {
        "realistic": "realistic",
        "none": "none",
        "shuffled": "random",
        "late": "none",
    }
    sample = sample_of(scores_of(read_answers(study)), "qoe")
    means = dict(zip(sample.feedbacks, sample.values.mean(axis=0), strict=True))
    # a draw of 40: three standard errors of their means
    for feedback, like in report["rated_like"].items():
        mean, sd = PAPER[like]
        assert means[feedback] == pytest.approx(mean, abs=0.5 * sd)
    _, _, said = run("simulate", study, "--participants", "1")
    assert "shuffled like random, late like random" in said


@pytest.mark.parametrize(
    ("like", "what"),
    [
        ("late", "KEY=NAME"),
        ("late=none --like late=random", "each key once"),
        ("strong=none", "the keys are realistic, none, shuffled, late"),
        ("late=strong", "rated like 'strong'; choose one of none, random, realistic"),
    ],
)
def test_a_wrong_likeness_adds_nobody(run, tmp_path, like, what):
    study = create_study(tmp_path / "s", "controls")
    status, _, said = run("simulate", study.folder, "--like", *like.split())
    assert status == 2
    assert what in said
    assert study.codes() == []


def test_power_of_other_feedbacks_is_that_of_their_likeness(run):
    words = ("--studies", "200", "--largest", "20", "--json")
    _, paper, _ = run("power", *words)
    feedbacks = ("none", "x=random", "late=delayed:delay_s=0.2")
    named = [word for text in feedbacks for word in ("--feedback", text)]
    status, found, said = run("power", *words, *named, "--like", "late=realistic")
    assert status == 0
    assert "late like realistic" in said
    assert list(found["needed"].values()) == list(paper["needed"].values())
    assert "x-late" in found["needed"]
    status, _, said = run("power", "--feedback", "delayed:delay_s=99")
    assert status == 2
    assert "between -5 and 5" in said


def test_an_empty_folder_becomes_a_study_and_a_full_one_stays(run, tmp_path):
    empty, full = tmp_path / "empty", tmp_path / "full"
    empty.mkdir()
    full.mkdir()
    (full / "letter.txt").write_text("mine")
    assert run("simulate", empty, "--participants", "1")[0] == 0
    assert len(list((empty / "sessions").iterdir())) == 1
    status, _, said = run("simulate", full, "--participants", "1")
    assert status == 1
    assert [path.name for path in full.iterdir()] == ["letter.txt"]
    assert "full" in said


def failing(at, problem):
    """A sync that fails when it is called for the time `at`."""
    calls = itertools.count(1)
    real = os.fsync

    def fsync(descriptor):
        if next(calls) == at:
            raise problem
        real(descriptor)

    return fsync


FULL = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize("at", [1, 9, 40])
@pytest.mark.parametrize("problem", [FULL, KeyboardInterrupt()])
@pytest.mark.parametrize("place", ["missing", "empty", "study"])
def test_a_simulation_that_ends_early_leaves_nothing(
    run, tmp_path, monkeypatch, at, problem, place
):
    folder = tmp_path / "s"
    if place == "study":
        create_study(folder)
        assert run("simulate", folder, "--participants", "1")[0] == 0
    elif place == "empty":
        folder.mkdir()
    before = sorted(path.name for path in tmp_path.rglob("*"))
    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", failing(at, problem))
        status, _, said = run("simulate", folder, "--participants", "2")
    assert status == (1 if problem is FULL else 130)
    if problem is FULL:
        assert f"the disk at {disk_of(folder)} is full" in said
        assert ".part" not in said
    assert sorted(path.name for path in tmp_path.rglob("*")) == before


def test_a_study_that_is_not_there_is_refused(run, tmp_path):
    status, _, said = run("analyse", tmp_path / "none")
    assert status == 1
    assert "none" in said


def test_power_tells_how_many_participants_a_design_needs(run, rides):
    words = ("--effect", "0.5", "--studies", "300", "--largest", "30")
    status, found, _ = run("power", *words, "--json")
    assert status == 0
    assert 5 <= found["needed"]["friedman"] <= 14
    assert found["population"] == "effect 0.5"
    status, said, _ = run("power", rides, *words[2:])  # the study as the pilot
    assert "8 participants of rides" in said


@pytest.mark.parametrize(
    "words",
    [
        ("--measure", "joy"),
        ("--alpha", "2"),
        ("--largest", "1000000"),
        ("--studies", "1"),
        ("--sequences", "0"),
        ("--effect", "huge"),
    ],
)
def test_a_power_that_cannot_be_computed_is_refused(run, words):
    assert run("power", *words)[0] == 2
