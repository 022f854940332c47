"""A definition that is being edited: every problem at once, and kept however it is."""

import json

import pytest

from hapticplayer.errors import StudyError
from hapticplayer.study.creation import (
    STUDY_TEMPLATES,
    TEMPLATES,
    create_study,
    with_languages,
)
from hapticplayer.study.definition import OrderMethod
from hapticplayer.study.drafts import DRAFT, Draft, clip_seconds, problems_of
from hapticplayer.study.order_preview import EXAMPLE, NEXT, Given, order_lines
from hapticplayer.study.study_folder import open_study


@pytest.fixture
def study(tmp_path):
    return create_study(tmp_path / "study")


@pytest.fixture
def content(study):
    return json.loads(study.content)


def fields(content, folder):
    return [p.field for p in problems_of(content, folder) if p.is_fatal]


def test_all_wrong_fields_are_named_at_once(study, content):
    content["pages"][1]["questions"][0]["key"] = "Not a key"
    content["pages"][0]["questions"][1]["text"]["de"] = " "
    content["texts"]["consent"] = []
    assert fields(content, study.folder) == [
        "pages[0].questions[1].text.de",
        "pages[1].questions[0].key",
        "texts.consent",
    ]


def test_all_contradictions_are_named_at_once(study, content):
    del content["texts"]["consent"]["fr"]
    content["pages"][0]["questions"][1]["key"] = "age"
    content["pages"][0]["questions"][0]["least"] = 200
    content["order"] |= {"method": "williams", "no_sequence_twice_in_a_row": True}
    assert fields(content, study.folder) == [
        "texts.consent",
        "pages[0].questions[1].key",
        "pages[0].questions[0].most",
        "order",
    ]


def test_an_empty_text_is_called_empty_on_the_command_line_too(study, content):
    content["pages"][1]["questions"][0]["text"]["fr"] = ""
    (problem,) = problems_of(content, study.folder)
    assert problem.what == "is empty"
    (study.folder / "study.json").write_text(json.dumps(content))
    with pytest.raises(
        StudyError, match=r"pages\[1\]\.questions\[0\]\.text\.fr: is empty"
    ):
        open_study(study.folder)


def test_a_study_without_recordings_and_orders_is_kept(study, content):
    content["order"]["method"] = "list"
    found = problems_of(content, study.folder)
    assert [one.field for one in found] == [
        *(f"sequences[{number}].folder" for number in range(4)),
        "order.method",
    ]
    assert not any(one.is_fatal for one in found)


def test_a_draft_lies_beside_the_study_until_it_is_whole(study, content):
    draft = Draft(study.folder)
    content["title"] = ""
    draft.keep(content)
    assert (study.folder / "study.json").read_bytes() == study.content
    again = Draft(study.folder)
    assert again.is_restored
    assert again.content["title"] == ""
    assert again.complete() == json.loads(study.content)
    again.keep({**content, "title": "Whole"})
    assert not (study.folder / DRAFT).exists()
    assert Draft(study.folder).study.definition.title == "Whole"


def test_a_clip_without_a_recording_is_taken_for_a_minute(study, content):
    assert set(clip_seconds(content, study.folder).values()) == {60.0}


def test_each_template_has_a_row_and_a_file():
    files = {path.stem for path in TEMPLATES.glob("*.json")}
    assert {row.name for row in STUDY_TEMPLATES} == files


def test_an_added_language_is_worded_as_in_the_template(content):
    german = with_languages(content, ["de"])
    german["pages"][1]["questions"].append(
        {"key": "mine", "kind": "visual", "text": {"de": "Na?"}}
    )
    german["pages"][1]["questions"][0]["published"] = {"de": "Wie gedruckt"}
    both = with_languages(german, ["fr", "de"])
    assert both["texts"]["consent"] == {
        name: content["texts"]["consent"][name] for name in ("fr", "de")
    }
    assert both["pages"][1]["questions"][-1]["text"] == {"fr": "", "de": "Na?"}
    assert both["pages"][1]["questions"][0]["published"] == {"de": "Wie gedruckt"}
    assert both["languages"] == ["fr", "de"]


def test_the_next_participant_gets_the_order_that_was_used_least(study, content):
    content["order"]["method"] = "latin-square"
    definition = Draft(study.folder)
    definition.keep(content)
    made = definition.study.definition
    rows = order_lines(made, [], [])
    assert [line.who for line in rows] == [(NEXT,), *[()] * 11]
    given = [
        Given("CDFGHJ", 0, rows[0].order, counts=True),
        Given("KMNPQR", 1, rows[1].order, counts=False),
    ]
    lines = order_lines(made, given, [])
    assert lines[0].who == ("KMNPQR",)  # of an earlier definition, or ended early
    assert [line.who for line in lines[1:4]] == [("CDFGHJ",), (NEXT,), ()]


def test_random_orders_are_shown_by_examples(study):
    definition = study.definition
    assert definition.order.method is OrderMethod.RANDOM
    lines = order_lines(definition, [], [])
    assert {line.who for line in lines} == {(EXAMPLE,)}
    assert all(set(line.order) == set(definition.conditions) for line in lines)
