"""Trials of two intervals and staircases, on a virtual clock."""

import json
from collections import Counter

import pytest

from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.definition import FeedbackLevel, Staircase
from hapticplayer.study.definition_reader import faults_of
from hapticplayer.study.intervals import presented, track_of
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_data import markers_of
from hapticplayer.study.study_export import export_study
from tests.unit.study.test_runner import RunningSession

STANDARD = FeedbackLevel("realistic")


@pytest.fixture
def staircase(tmp_path):
    return smaller(create_study(tmp_path / "s", "staircase"), staircase_trials=9)


def smaller(study, staircase_trials):
    content = json.loads(study.content)
    content["sequences"] = content["sequences"][:1]
    content["staircase"]["trials"] = staircase_trials
    return change_definition(study, content)


@pytest.fixture
def running(staircase, manual_clock):
    made = RunningSession(staircase, manual_clock)
    yield made
    made.runner.close()


def watch(running):
    """Watch both clips of a trial; what was played."""
    running.runner.proceed()
    played = []
    for text in ("Clip 1", "Clip 2"):
        assert (running.kind, running.runner.page.text) == (PageKind.INTERVAL, text)
        played.append(running.stage.prepared[-1])
        running.runner.poll()
        assert running.kind is PageKind.INTERVAL
        running.clock.advance(1.1)
        running.runner.poll()
        assert running.kind is PageKind.PLAYING
        running.clock.advance(20.0)
        running.end_clip()
    return played


def answer(running, played, *, is_correct):
    is_late = [one.delay_s > 0.0 for one in played]
    place = is_late.index(True) if is_correct else is_late.index(False)
    running.clock.advance(2.0)
    running.runner.answer({"later": ("first", "second")[place]})


def test_a_staircase_goes_down_after_so_many_correct_answers():
    rule = Staircase("gain", 2, 0.5, (0.2, 0.1), 20)
    found = track_of(rule, [True, True, False, True, True, True, True, True, True])
    levels = (0.5, 0.5, 0.3, 0.4, 0.4, 0.3, 0.3, 0.2, 0.2, 0.1)
    assert found.changes == pytest.approx(levels)
    assert found.reversals == (2, 4)
    assert found.threshold is None
    three = track_of(Staircase("gain", 3, 0.5, (0.2,), 20), [True, True, True, False])
    assert three.changes == pytest.approx((0.5, 0.5, 0.5, 0.3, 0.5))
    at_ends = track_of(rule, [True] * 20)
    assert min(at_ends.changes) == pytest.approx(0.1)
    assert max(track_of(rule, [False] * 4).changes) == 0.5


def test_the_level_of_a_trial_follows_from_the_answers_before(running):
    running.to_trials()
    changes = []
    for is_correct in (True, True, True, True, False):
        played = watch(running)
        assert min(one.delay_s for one in played) == 0.0
        changes.append(max(one.delay_s for one in played))
        answer(running, played, is_correct=is_correct)
    assert changes == pytest.approx([0.6, 0.6, 0.5, 0.5, 0.4])
    running.runner.close()
    again = RunningSession(running.study, running.clock, running.code)
    played = watch(again)
    assert max(one.delay_s for one in played) == pytest.approx(0.45)
    again.runner.close()


def test_both_clips_are_in_records_markers_and_tables(running, tmp_path):
    running.to_trials()
    first = watch(running)
    answer(running, first, is_correct=True)
    answer(running, watch(running), is_correct=False)
    (trial, _) = running.contents("trial")
    levels = [
        {"feedback": "realistic", "delay_s": p.delay_s, "gain": 1.0} for p in first
    ]
    assert trial["presented"] == levels
    session = running.study.session(running.code)
    assert session.is_sound
    step = [m.text.split()[1:3] for m in markers_of(session) if "trial-01" in m.text]
    kinds = ["begin", "first", "interval", "first", "end"]
    assert [kind for kind, *_ in step] == kinds
    heard = [t.split()[1] for t, _ in running.heard.markers if "trial-01" in t]
    assert [one for one in heard if one in kinds] == kinds
    answers = read_answers(running.study.folder)
    given = {one.position: (one.delay_s, one.answer) for one in answers.judgements}
    assert [given[1], given[2]] == [(0.6, True), (0.6, False)]
    export_study(running.study, tmp_path / "csv", "csv")
    rows = (tmp_path / "csv" / "trials.csv").read_text(encoding="utf-8").splitlines()
    cells = dict(zip(rows[0].split(","), rows[1].split(","), strict=True))
    late = [p.delay_s > 0.0 for p in first].index(True)
    assert (cells["delay_s"], cells["interval"]) == ("0.6", str(1 + late))


def test_a_trial_that_was_stopped_begins_with_its_first_clip(running):
    running.to_trials()
    running.runner.proceed()
    running.clock.advance(1.1)
    running.runner.poll()
    running.end_clip()
    assert running.runner.page.text == "Clip 2"
    running.runner.halt("escape")
    assert running.contents("trial")[-1]["reasons"] == ["escape"]
    running.runner.proceed()
    assert running.kind is PageKind.READY
    played = watch(running)
    answer(running, played, is_correct=True)
    assert [one["is_valid"] for one in running.contents("trial")] == [False, True]


def test_a_fault_in_either_clip_makes_a_trial_invalid(running):
    running.to_trials()
    running.runner.proceed()
    running.clock.advance(1.1)
    running.runner.poll()
    running.stage.reasons = ("frames_dropped",)
    running.end_clip()
    running.stage.reasons = ()
    running.clock.advance(1.1)
    running.runner.poll()
    running.end_clip()
    assert running.contents("trial")[-1]["reasons"] == ["frames_dropped"]
    running.runner.answer({"later": "first"})
    played = watch(running)  # what was not valid does not count
    assert max(one.delay_s for one in played) == pytest.approx(0.6)


def test_the_standard_comes_first_in_half_of_the_trials(tmp_path, manual_clock):
    study = create_study(tmp_path / "s", "two-interval")
    session = RunningSession(study, manual_clock)
    plan, made = session.runner.plan, study.definition
    first = Counter(
        presented(made, plan, position, attempt)[0].level == STANDARD
        for position in range(1, len(plan.order) + 1)
        for attempt in range(1, 21)
    )
    assert 0.45 < first[True] / first.total() < 0.55
    assert STANDARD not in {one.level for one in made.conditions}
    session.runner.close()


@pytest.mark.parametrize(
    ("change", "field", "what"),
    [
        ({"standard": None}, "standard", "is missing"),
        ({"standard": {"feedback": "none"}}, "standard.feedback", "is not a feedback"),
        ({"levels": [{"gain": 2.0}]}, "levels", "not used in staircase trials"),
        ({"trial": "rating"}, "staircase", "not used in rating trials"),
        ({"trial": "magnitude"}, "pages", "no question for a number"),
        ({"staircase": {"start": 6.0}}, "staircase.start", "above 5"),
        ({"staircase": {"steps": [0.0]}}, "staircase.steps", "above 0"),
    ],
)
def test_a_definition_that_lacks_something_is_refused(tmp_path, change, field, what):
    content = json.loads(create_study(tmp_path / "s", "staircase").content)
    if "staircase" in change:
        change = {"staircase": {**content["staircase"], **change["staircase"]}}
    from hapticplayer.structures import convert
    from hapticplayer.study.definition import Definition

    made = convert({**content, **change}, Definition, "")
    found = {place: str(told) for place, told, _ in faults_of(made)}
    assert what in found[field]


def test_forces_that_a_trial_does_not_have_are_left_out(running):
    running.to_trials()
    answer(running, watch(running), is_correct=True)
    path = running.study.session_folder(running.code) / "answers.jsonl"
    from hapticplayer.study.journal import encode, read_journal

    records = read_journal(path).intact
    trial = next(one for one in records if one.kind == "trial")
    wrong = {**trial.content, "presented": trial.content["presented"][:1]}
    line = encode(trial.number, trial.utc, trial.monotonic_s, trial.kind, wrong)
    lines = path.read_bytes().splitlines(keepends=True)
    lines[trial.number - 1] = line
    path.write_bytes(b"".join(lines))
    session = running.study.session(running.code)
    assert any("standard is not one of two forces" in one for one in session.notices)
