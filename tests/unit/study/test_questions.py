"""Every kind of question, from the definition to the data."""

import csv
import json

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.errors import StudyError
from hapticplayer.study.analysis.report import analyse_study
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition
from hapticplayer.study.definition import PointLabel, Question, QuestionKind, When
from hapticplayer.study.pages import PageKind, check_answers
from hapticplayer.study.questions import kind_of
from hapticplayer.study.steps import answered_trials
from hapticplayer.study.study_folder import open_study
from tests.every_kind import drawn, with_every_kind
from tests.unit.study.test_runner import RunningSession

GIVEN = {
    QuestionKind.SCALE: -2,
    QuestionKind.VISUAL: 71,
    QuestionKind.NUMBER: -5,
    QuestionKind.YES_NO: False,
    QuestionKind.CHOICE: "bike",
    QuestionKind.CHOICES: ["sea", "land"],
    QuestionKind.PAIR: 2,
    QuestionKind.TEXT: "so, Anna",
}
MEASURED = ("scale", "visual", "number", "pair")
WRONG = {
    QuestionKind.SCALE: (4, -4, "1", True, 1.0),
    QuestionKind.VISUAL: (101, -1, 50.5, "50"),
    QuestionKind.NUMBER: (6, "5", False),
    QuestionKind.YES_NO: (0, "yes"),
    QuestionKind.CHOICE: ("plane", 1, ["car"]),
    QuestionKind.CHOICES: (["plane"], "sea", ["sea", "sea"], [1], {}),
    QuestionKind.PAIR: (4, "dull"),
    QuestionKind.TEXT: ("x" * 31, 5),
}


@pytest.fixture
def study(study):
    return change_definition(study, with_every_kind(json.loads(study.content)))


@pytest.fixture
def running(study, manual_clock):
    made = RunningSession(study, manual_clock)
    yield made
    made.runner.close()


def given(page):
    return {
        one.name: GIVEN[one.kind]
        if one.name.startswith(f"{one.kind}_")
        else drawn(page, np.random.default_rng(1))[one.name]
        for one in page.questions
    }


def answer_all(running):
    """Go through a whole session."""
    while running.kind is not PageKind.THANKS:
        if running.kind is PageKind.CONSENT:
            running.runner.consent(given=True)
        elif running.kind is PageKind.QUESTIONS:
            running.clock.advance(2.0)
            running.runner.answer(given(running.runner.page))
        elif running.kind is PageKind.PLAYING:
            running.end_clip()
        else:
            running.runner.proceed()


def table(path):
    return list(csv.DictReader(path.read_text().splitlines()))


def run(*words):
    assert cli.main([*map(str, words)]) == 0


def test_a_participant_is_asked_page_by_page(running):
    pages = []
    running.runner.consent(given=True)
    while running.kind is PageKind.QUESTIONS:
        pages.append(running.runner.page.key)
        running.runner.answer(given(running.runner.page))
    running.runner.proceed()
    for key in ("more-before-clip", "rating", "more-after-clip"):
        if key == "rating":
            running.play()
        assert running.runner.page.key == key
        assert running.runner.page.position == 1
        running.clock.advance(4.0)
        running.runner.answer(given(running.runner.page))
    assert pages == ["sheet", "more-before"]
    assert running.runner.page.position == 2
    (answered,) = read_answers(running.study.folder).conduct.playbacks
    assert answered.response_s == 8.0


def to_first_clip(running):
    """Go on to the first page of questions before a clip."""
    running.runner.consent(given=True)
    while running.runner.page.key != "more-before-clip":
        if running.kind is PageKind.QUESTIONS:
            running.runner.answer(given(running.runner.page))
        else:
            running.runner.proceed()


def test_questions_before_a_clip_belong_to_its_coming_attempt(running):
    to_first_clip(running)
    before = given(running.runner.page)
    with pytest.raises(StudyError, match="ready"):
        running.runner.proceed()
    running.runner.answer({**before, "number_before-clip": 1})
    assert (running.kind, running.runner.attempt) == (PageKind.READY, 0)
    running.play()
    running.runner.repeat()
    assert running.runner.page.key == "more-before-clip"  # for the second attempt
    running.runner.answer({**before, "number_before-clip": 2})
    running.play()
    for _ in range(2):
        running.runner.answer(given(running.runner.page))
    (trial,) = answered_trials(running.study.session(running.code).records)
    assert (trial.attempt, trial.values["number_before-clip"]) == (2, 2)
    assert trial.values["scale_after-clip"] == -2
    assert running.study.session(running.code).notices == ()


def test_a_crash_while_a_clip_plays_asks_again_before_it(running):
    to_first_clip(running)
    running.runner.answer(given(running.runner.page))
    back = running.again()
    assert (back.kind, back.runner.page.position) == (PageKind.READY, 1)
    back.runner.proceed()
    assert back.kind is PageKind.PLAYING
    last = back.again()
    assert last.runner.page.key == "more-before-clip"
    assert list(answered_trials(last.study.session(last.code).records)) == []


def test_a_crash_between_two_pages_of_a_clip_asks_the_second(running):
    running.runner.consent(given=True)
    while running.kind is not PageKind.PLAYING:
        if running.kind is PageKind.QUESTIONS:
            running.runner.answer(given(running.runner.page))
        else:
            running.runner.proceed()
    running.end_clip()
    first = given(running.runner.page)
    running.runner.answer(first)
    back = running.again()
    assert (back.kind, back.runner.page.key) == (PageKind.QUESTIONS, "more-after-clip")
    back.runner.answer(given(back.runner.page))
    assert back.runner.page.position == 2
    ratings = read_answers(back.study.folder).ratings
    assert {r.factor: r.value for r in ratings if r.value is not None} == {
        **first,
        **{f"{kind}_after-clip": GIVEN[kind] for kind in MEASURED},
    }
    back.runner.repeat()  # and the whole trial, if the operator wants it
    back.runner.repeat()
    back.runner.close()


def test_a_repeated_trial_asks_all_its_pages_again(running):
    to_first_clip(running)
    running.runner.answer(given(running.runner.page))
    running.play()
    running.runner.answer(given(running.runner.page))
    running.runner.repeat()
    running.runner.answer(given(running.runner.page))
    assert running.kind is PageKind.READY
    running.play()
    assert running.runner.page.key == "rating"


@pytest.mark.parametrize("kind", list(QuestionKind))
def test_an_answer_of_the_wrong_kind_is_refused(running, kind):
    maker, definition = running.runner.maker, running.study.definition
    page = next(page for page in definition.pages if page.key == "more-before")
    questions = [one for one in maker.asked(page) if one.kind is kind]
    (asked,) = questions
    assert check_answers(questions, {asked.name: GIVEN[kind]}) == {
        asked.name: GIVEN[kind]
    }
    for wrong in WRONG[kind]:
        with pytest.raises(StudyError, match=r"must be|has more than"):
            check_answers(questions, {asked.name: wrong})
    if asked.question.required:
        for nothing in (None, "", []):
            with pytest.raises(StudyError, match="not answered"):
                check_answers(questions, {asked.name: nothing})


def test_the_csv_export_has_every_kind_with_its_type(running, tmp_path):
    answer_all(running)
    run("study", "export", running.study.folder, "-o", tmp_path / "csv")
    for name, when in (
        ("participants.csv", "before"),
        ("participants.csv", "after"),
        ("trials.csv", "after-clip"),
    ):
        rows = table(tmp_path / "csv" / name)
        assert len(rows) == (12 if name == "trials.csv" else 1)
        for row in rows:
            assert row[f"scale_{when}"] == "-2"
            assert row[f"visual_{when}"] == "71"
            assert row[f"number_{when}"] == "-5"
            assert row[f"yes-no_{when}"] == "false"
            assert row[f"choice_{when}"] == "bike"
            chosen = [row[f"choices_{when}.{key}"] for key in ("sea", "air", "land")]
            assert chosen == ["true", "false", "true"]
            assert not any("Anna" in cell for cell in row.values())
    dictionary = table(tmp_path / "csv" / "data_dictionary.csv")
    meanings = {row["column"]: row["meaning"] for row in dictionary}
    assert meanings["simulated"] == "simulated participant (not the device)"
    said = {row["column"]: row["unit_or_levels"] for row in dictionary}
    assert said["scale_before"] == "from -3 to 3 (-3: bad en, 0: so en, 3: good en)"
    assert said["visual_before"] == "from 0 to 100 (0: none en, 100: most en)"
    assert said["number_before"] == "from -5 to 5 kg"
    assert said["choice_before"] == "car|bike"
    assert said["choices_before.sea"] == said["yes-no_before"] == "true|false"


def test_labels_in_the_data_are_in_the_order_of_points():
    labels = [
        PointLabel(at=at, text={"en": word})
        for at, word in ((1, "in danger"), (7, "safe"), (4, "neither"))
    ]
    asked = Question(
        key="safety",
        kind=QuestionKind.SCALE,
        text={"en": "How safe?"},
        least=1,
        most=7,
        labels=tuple(labels),
    )
    (column,) = kind_of(asked).columns
    assert list(column.levels) == ["1", "4", "7"]


def test_the_texts_after_a_clip_are_exported_once_reviewed(running, tmp_path):
    answer_all(running)
    folder = running.study.folder
    run("study", "review", folder, "--pass", running.code)
    run("study", "export", folder, "-o", tmp_path / "csv")
    rows = table(tmp_path / "csv" / "texts.csv")
    clips = [row for row in rows if row["question"] == "text_after-clip"]
    order = running.study.session(running.code).plan.order
    assert {(r["position"], r["sequence"], r["feedback"]) for r in clips} == {
        (str(n), one.sequence, one.feedback) for n, one in enumerate(order, 1)
    }
    assert {row["text"] for row in clips} == {"so, Anna"}


def test_only_numbers_are_compared_and_the_rest_is_counted(running):
    answer_all(running)
    answers = read_answers(running.study.folder)
    assert answers.factors == (
        *("realism", "sensory", "comfort", "satisfaction"),
        *(f"{kind}_after-clip" for kind in MEASURED),
    )
    assert answers.qoe == answers.factors[:4]
    numbers = analyse_study(answers).numbers
    assert numbers["factors"]["visual_after-clip"]["none"]["mean"] == 71.0
    counted = numbers["questions"]
    assert counted["choice_before"]["counts"] == {"car": 0, "bike": 1}
    assert counted["number_after"]["median"] == -5.0
    clip = counted["choices_after-clip"]["feedbacks"]["random"]
    assert clip == {"n": 4, "counts": {"sea": 4, "air": 0, "land": 4}}
    assert not any(name.startswith("text") for name in counted)


def test_a_study_without_the_sum_is_analysed(study, scripted, tmp_path):
    content = json.loads(study.content)
    del content["pages"][1], content["while_watching"]
    made = change_definition(study, content)
    run("study", "simulate", made.folder, "--participants", "7")
    run("study", "analyse", made.folder, "--output", tmp_path / "out")
    numbers = json.loads((tmp_path / "out" / "numbers.json").read_text())
    assert numbers["qoe"] == {}
    assert set(numbers["friedman"]) == {f"{kind}_after-clip" for kind in MEASURED}
    drawn_by = {path.stem for path in (tmp_path / "out").glob("*.svg")}
    assert drawn_by == {
        "effects-by-measure",
        "factors-by-feedback",
        "factors-by-feedback-0-to-100",
        "factors-by-feedback--5-to-5",
    }
    report = (tmp_path / "out" / "report.html").read_text()
    assert "QoE" not in report.partition("References")[0]


def test_simulated_participants_answer_every_question(study, capsys):
    run("study", "simulate", study.folder, "--participants", "5")
    assert "answered at random: scale_before-clip, visual" in capsys.readouterr().err
    found = open_study(study.folder)
    sessions, notices = found.sessions()
    assert notices == []
    for session in sessions:
        pages = {
            record.content["page"]
            for record in session.records.intact
            if record.kind in ("answers", "answers-before")
        }
        assert pages == {page.key for page in found.definition.pages} - {"post-test"}
    answers = read_answers(study.folder)
    assert all(r.value is not None for r in answers.ratings)
    people = answers.participants
    asked = found.definition.questions_at(When.BEFORE)
    assert all(
        one.values[q.key] is not None for one in people for q in asked if q.required
    )


def test_a_wrong_answer_in_a_record_is_named(running):
    answer_all(running)
    path = running.study.session_folder(running.code) / "answers.jsonl"
    from tests.unit.study.test_spoilt_sessions import line_of

    lines = path.read_bytes().splitlines(keepends=True)
    number, record = next(
        (n, json.loads(line))
        for n, line in enumerate(lines)
        if b'"more-before"' in line
    )
    record.pop("crc")
    record["values"]["choices_before"] = ["plane"]
    lines[number] = line_of(record)
    path.write_bytes(b"".join(lines))
    notices = read_answers(running.study.folder).notices
    place = f"{running.code}/answers.jsonl: record {number + 1}: the answer to "
    assert notices == (
        f"{place}'choices_before' in more-before was left out: ['plane'] is not allowed",
    )
    assert (
        read_answers(running.study.folder).participants[0].values.get("visual_before")
    )
