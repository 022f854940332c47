"""`hapticplayer study ...` as a person types it."""

import json
import shutil

import pytest

from hapticplayer import cli
from hapticplayer.clock import SystemClock
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.journal import Journal
from hapticplayer.study.study_folder import begin_session, open_study

VALUES = {"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1}


@pytest.fixture
def run(capsys):
    """Run a command; return its status, its JSON or text, and stderr."""

    def call(*arguments):
        status = cli.main(["study", *map(str, arguments)])
        reported = capsys.readouterr()
        is_json = "--json" in arguments and reported.out
        return (
            status,
            json.loads(reported.out) if is_json else reported.out,
            reported.err,
        )

    return call


@pytest.fixture
def folder(run, tmp_path):
    status, _, _ = run("new", tmp_path / "s")
    assert status == 0
    return tmp_path / "s"


def test_new_takes_other_feedbacks(run, tmp_path):
    chosen = ("none", "late=delayed:delay_s=0.4", "shuffled:of=horse", "own=mine")
    words = [word for text in chosen for word in ("--feedback", text)]
    assert run("new", tmp_path / "t", *words)[0] == 0
    study = open_study(tmp_path / "t").definition
    assert [
        (one.name, one.condition, one.parameters) for one in study.chosen_feedbacks
    ] == [
        ("none", "none", {}),
        ("late", "delayed", {"delay_s": 0.4}),
        ("shuffled", "shuffled", {"of": "horse"}),
        ("own", "mine", {}),
    ]
    assert study.feedbacks[0] == "none"
    status, _, said = run("new", tmp_path / "u", "--feedback", "delayed:delay=1")
    assert (status, (tmp_path / "u").exists()) == (2, False)
    assert "it has delay_s" in said
    status, _, said = run("new", tmp_path / "u", "--feedback", "shuffled:of=boat")
    assert (status, (tmp_path / "u").exists()) == (1, False)
    assert "feedbacks[0].parameters.of" in said


@pytest.fixture
def code(folder):
    return write_scripted_session(
        open_study(folder), {"age": 30}, lambda _c: VALUES, SystemClock(), origin={}
    )


def test_new_makes_a_study_and_says_what_is_missing(run, tmp_path):
    status, report, reported = run("new", tmp_path / "s", "--json")
    assert status == 0
    assert report["conditions"] == 12
    assert report["missing"] == ["bike", "horse", "car-turning", "car-braking"]
    assert "bike" in reported


@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        (["--template", "none"], 2),
        (["--sequence", "bike"], 2),
        (["--sequence", "boat=/x"], 2),
        (["--sequence", "bike=/x", "--sequence", "bike=/y"], 2),
    ],
)
def test_wrong_usage_is_reported_and_makes_nothing(run, tmp_path, arguments, status):
    found, _, reported = run("new", tmp_path / "s", *arguments)
    assert found == status
    assert reported.startswith("hapticplayer: ")
    assert not (tmp_path / "s").exists()


def test_status_tells_who_took_part_and_how_balanced_it_is(run, folder, code):
    begin_session(open_study(folder), "en", {}, SystemClock())
    status, report, _ = run("status", folder, "--json")
    assert status == 0
    first = report["sessions"][0]
    assert (first["code"], first["state"], first["answered"]) == (code, "complete", 12)
    assert report["sessions"][1]["state"] == "unfinished"
    assert report["balance"]["times_at_each_position"][1] <= 2
    _, text, _ = run("status", folder)
    assert code in text
    assert "12/12 answered" in text


def test_dropping_and_deleting(run, folder, code):
    other = begin_session(open_study(folder), "en", {}, SystemClock()).code
    assert run("drop", folder, other, "--reason", "ill")[0] == 0
    assert run("drop", folder, other, "--reason", "ill")[0] == 1
    assert run("delete-participant", folder, code)[0] == 0
    assert run("delete-participant", folder, code)[0] == 1
    _, report, _ = run("status", folder, "--json")
    assert report["deleted"] == 1
    assert [s["state"] for s in report["sessions"]] == ["stopped"]


def test_status_says_which_sessions_are_simulated(run, folder, code):
    begin_session(open_study(folder), "en", {}, SystemClock())
    _, report, _ = run("status", folder, "--json")
    marked = {one["code"]: one["simulated"] for one in report["sessions"]}
    assert marked.pop(code) is True
    assert list(marked.values()) == [False]
    _, text, _ = run("status", folder)
    lines = text.splitlines()
    assert "  1 of 2 sessions are simulated" in lines
    (line,) = (line for line in lines if code in line)
    assert line.endswith("  simulated")


def test_texts_are_reviewed_before_export(run, folder, code, tmp_path):
    path = open_study(folder).session_folder(code) / "answers.jsonl"
    journal = Journal(path, SystemClock())
    journal.append(
        "answers", step="post-test", page="post-test", values={"tiring": "no"}
    )
    journal.close()
    _, report, _ = run("review", folder, "--json")
    assert report["unreviewed"] == [{"code": code, "question": "tiring", "text": "no"}]
    _, _, reported = run("export", folder, "-o", tmp_path / "a")
    assert "1 text answers were left out" in reported
    assert run("review", folder, "--pass", f"{code}:tiring")[0] == 0
    _, report, reported = run("export", folder, "-o", tmp_path / "b", "--json")
    assert "texts.csv" in report["files"]
    assert "left out" not in reported


def test_merging_tells_conflicts_by_status(run, folder, code, tmp_path):
    shutil.copytree(folder, tmp_path / "other")
    shutil.rmtree(folder / "sessions" / code)
    status, report, _ = run("merge", folder, tmp_path / "other", "--json")
    assert status == 0
    assert report[0]["added"] == [code]
    path = tmp_path / "other" / "sessions" / code / "answers.jsonl"
    path.write_bytes(b"")
    status, _, _ = run("merge", folder, tmp_path / "other")
    assert status == 0  # an emptier copy of what is here


def test_running_needs_a_display(run, folder):
    status, _, reported = run("run", folder)
    assert status == 2
    assert "display" in reported


def test_a_folder_without_a_study_is_one_sentence(run, tmp_path):
    status, _, reported = run("status", tmp_path)
    assert status == 1
    assert reported.count("\n") == 1
