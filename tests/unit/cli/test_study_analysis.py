import argparse
import json
from dataclasses import replace
from types import SimpleNamespace

import pytest

from hapticplayer.cli import study_analysis
from hapticplayer.errors import SequenceError, UsageError
from hapticplayer.simulation.participants import simulated_answers


@pytest.fixture
def study(monkeypatch):
    """What a folder of the name "rides" holds, and what is written into it."""
    held = SimpleNamespace(
        design=replace(simulated_answers(8, seed=1), participants=(), ratings=()),
        origin=None,
        rated=[],
    )

    def writer(_folder, origin):
        held.origin = dict(origin)

        def write(_person, rate):
            held.rated.append(rate("horse", "realistic"))
            return f"C{len(held.rated)}"

        return write

    monkeypatch.setattr(
        study_analysis, "read_study", lambda _: simulated_answers(8, seed=1)
    )
    monkeypatch.setattr(study_analysis, "read_design", lambda _: held.design)
    monkeypatch.setattr(study_analysis, "session_writer", writer)
    return held


@pytest.fixture
def run(study):
    def run_with(*words: str) -> int:
        parser = argparse.ArgumentParser()
        study_analysis.add_actions(parser.add_subparsers())
        chosen = parser.parse_args(words)
        return chosen.run(chosen, None)

    return run_with


def test_analyse_prints_the_promised_json_and_writes_the_report(run, tmp_path, capsys):
    target = tmp_path / "report"
    assert run("analyse", "rides", "--json", "--output", str(target)) == 0
    found = json.loads(capsys.readouterr().out)
    assert set(found["qoe"]) == {"none", "random", "realistic"}
    assert {"mean", "sd"} <= set(found["qoe"]["none"])
    assert {"chi2", "p", "kendall_w"} <= set(found["friedman"]["qoe"])
    assert json.loads((target / "numbers.json").read_text("utf-8")) == found


def test_analyse_tells_people_what_was_found(run, capsys):
    assert run("analyse", "rides", "--missing", "complete") == 0
    said = capsys.readouterr().out
    assert "8 participants" in said
    assert "none-realistic: Wilcoxon" in said


def test_an_existing_report_is_refused_before_the_work(run, tmp_path):
    with pytest.raises(SequenceError, match="already exists"):
        run("analyse", "rides", "--output", str(tmp_path))


def test_simulate_writes_sessions_that_are_marked(run, study, capsys):
    assert run("simulate", "rides", "--participants", "3", "--seed", "4", "--json") == 0
    report = json.loads(capsys.readouterr().out)
    assert report["participants"] == ["C1", "C2", "C3"]
    assert study.origin == {"simulated": True, "effect": "paper", "seed": 4}
    assert set(study.rated[0]) == {"realism", "sensory", "comfort", "satisfaction"}


def test_only_the_papers_design_can_be_simulated(run, study):
    study.design = replace(study.design, feedbacks=("late", "none"))
    with pytest.raises(UsageError, match="paper's feedbacks"):
        run("simulate", "rides")
    assert study.rated == []


def test_power_tells_how_many_participants_a_design_needs(run, capsys):
    words = ("--effect", "0.5", "--studies", "300", "--largest", "30")
    assert run("power", *words, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert 5 <= found["needed"]["friedman"] <= 14
    assert found["population"] == "effect 0.5"
    assert run("power", "rides", *words) == 0  # the study as the pilot
    assert "8 participants of rides" in capsys.readouterr().out


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
def test_what_power_cannot_compute_is_refused(run, words):
    with pytest.raises(UsageError):
        run("power", *words)
