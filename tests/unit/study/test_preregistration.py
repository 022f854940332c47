"""A plan that is written before the data, and what `analyse` says of it."""

import json

import pytest

from hapticplayer import cli
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, Resampling
from hapticplayer.study.analysis.blocks import Paragraph
from hapticplayer.study.analysis.preregistered import deviations
from hapticplayer.study.analysis.report import analyse_study
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition
from hapticplayer.study.preregistration import PLAN_FILE
from hapticplayer.study.study_folder import drop_session

PLANNED = 8


def preregister(study, *words):
    return cli.main(["study", "preregister", str(study.folder), *words])


@pytest.fixture
def planned(study):
    claims = ("--hypothesis=qoe: realistic > none", "--hypothesis=qoe: none > random")
    power = ("--without-power=a pilot", f"--participants={PLANNED}")
    assert preregister(study, *claims, *power, "--exclude=felt sick") == 0
    return study


def add_participants(study, clock, count=PLANNED):
    answers = simulated_answers(count, "1", seed=3)
    write_answers(study, answers, clock, origin={"simulated": True})


def found_by(study, options=None):
    answers = read_answers(study.folder)
    return [
        str(about) for about, _ in deviations(answers, options or AnalysisOptions())
    ]


def test_a_study_done_as_planned_has_no_deviation(planned, manual_clock, tmp_path):
    add_participants(planned, manual_clock)
    report = analyse_study(read_answers(planned.folder), AnalysisOptions())
    kept = report.numbers["preregistration"]
    assert kept["deviations"] == []
    supported, contradicted = (one["result"] for one in kept["hypotheses"])
    assert supported.startswith("It was supported: mean of realistic less none ")
    assert "contradicted" in contradicted or "not supported" in contradicted
    texts = [one.text for one in report.blocks if isinstance(one, Paragraph)]
    assert any(kept["sha256"] in text for text in texts)
    assert any("No deviation from the plan" in text for text in texts)


def test_each_deviation_is_stated(planned, manual_clock):
    add_participants(planned, manual_clock, PLANNED - 1)
    content = json.loads(planned.content)
    content["limits"]["sync_ms"] = 30.0
    changed = change_definition(planned, content)
    add_participants(changed, manual_clock, 2)
    options = AnalysisOptions(include_invalid=True, resampling=Resampling(seed=7))
    answers = read_answers(planned.folder)
    found = {text: about for about, text in deviations(answers, options)}
    assert found == {
        "8 were planned, 9 completed a session": "participants",
        "limits.sync_ms: 20.0 was planned, it is 30.0": "definition",
        "2 of 9 sessions followed another definition": "definition",
        "inclusion of trials whose playback was not valid: False was planned, it is True": "analysis",
        "seed: 2012 was planned, it is 7": "analysis",
    }


def test_exclusions_are_deviations_unless_foreseen(planned, manual_clock):
    from hapticplayer.study.study_folder import begin_session, delete_participant

    add_participants(planned, manual_clock)
    (one, *_) = planned.codes()
    for reason in ("felt sick", "did not like it"):
        begun = begin_session(planned, "en", {}, manual_clock)
        drop_session(planned, begun.code, reason, manual_clock)
    delete_participant(planned, one)
    found = dict(deviations(read_answers(planned.folder), AnalysisOptions()))
    assert set(found) >= {"exclusions"}
    texts = [t for a, t in deviations(read_answers(planned.folder), AnalysisOptions())]
    assert sum("was ended early: did not like it" in text for text in texts) == 1
    assert not any("felt sick" in text for text in texts)
    assert "1 participant deleted" in texts


@pytest.mark.parametrize(
    ("spoil", "about"),
    [
        (lambda plan: plan.update(participants=9), ["participants", "plan"]),
        (lambda plan: plan["analysis"].update(sha256="0" * 64), ["plan", "analysis"]),
        (
            lambda plan: plan.update(written_utc="2999-01-01T00:00:00Z"),
            ["plan", "sessions"],
        ),
    ],
    ids=["plan", "analysis", "late"],
)
def test_a_plan_that_is_altered_or_late_is_named(planned, manual_clock, spoil, about):
    add_participants(planned, manual_clock)
    path = planned.folder / PLAN_FILE
    plan = json.loads(path.read_text())
    spoil(plan)
    path.write_text(json.dumps(plan))
    assert found_by(planned) == about


def test_other_orders_are_named(planned, manual_clock, monkeypatch):
    from hapticplayer.study import study_folder

    real = study_folder.assign

    def turned(*of):
        made = real(*of)
        return type(made)(
            made.conditions[::-1], made.labels, made.method, made.row, made.seed
        )

    monkeypatch.setattr(study_folder, "assign", turned)
    add_participants(planned, manual_clock)
    assert found_by(planned) == ["orders"]


def test_the_plan_is_a_document_and_is_written_once(study, capsys):
    words = (
        "--participants=12",
        "--studies=100",
        "--hypothesis=qoe: realistic > random",
        "--exclude=caf\udce9",  # typed where the terminal was not UTF-8
    )
    assert preregister(study, *words) == 0
    page = (study.folder / "preregistration.html").read_text()
    plan = json.loads((study.folder / PLAN_FILE).read_text())
    assert (study.folder / "preregistration.pdf").read_bytes().startswith(b"%PDF")
    for text in (
        "H1: qoe: realistic &gt; random. Tested by Wilcoxon",
        "12 trials (rating)",
        "caf?",
        "more than 2 % of the frames were dropped",
        "Power of 12 participants",
        plan["sha256"],
        plan["analysis"]["sha256"],
    ):
        assert text in page, text
    assert plan["power"]["of"]["none-realistic"] > 0.9
    assert preregister(study, *words) == 1
    assert "already exists" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "what"),
    [
        (["--hypothesis=qoe: realistic > loud"], "there is no 'loud'"),
        (["--without-power=none"], "needs --participants"),
        (["--measure=speed"], "--pilot"),
        (["--without-power=none", "--participants=-3"], "participants: must be at"),
        (["--without-power=none", "--participants=9", "--stop-rule= "], "is empty"),
        (["--effect=0.1", "--largest=5", "--studies=100"], "too few for a power"),
    ],
)
def test_plans_that_say_too_little_are_refused(study, capsys, words, what):
    assert preregister(study, *words) in (1, 2)
    assert what in capsys.readouterr().err
    assert not (study.folder / PLAN_FILE).exists()
