"""The editor has a place for all that a definition can say; nothing needs a text editor."""

import json
from collections.abc import Iterator
from types import UnionType
from typing import Union, get_args, get_origin, get_type_hints

import pytest
from msgspec import Struct

from app.experimenter.study.lists import EntryList
from hapticplayer import cli
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.definition import (
    Definition,
    QuestionKind,
    StudyFeedback,
    Text,
    When,
)
from hapticplayer.study.study_folder import open_study
from tests.every_kind import with_every_kind

KEPT = {("schema",), ("version",), ("id",), ("template",), ("trial",)}
"""Kept as they are; the last three are told on the first page."""
UNUSED = {
    "qoe2012": {"levels", "repeats", "standard", "staircase"},
    "consistency": {"standard", "staircase"},
    "two-interval": {"staircase", "while_watching"},
    "staircase": {"levels", "repeats", "while_watching"},
}
"""Of a study of the template."""
SMALL_PX = 800, 500  # 1600 x 1000 at 200 %


def parts_of(kind) -> list[object]:
    """A type without its limits, and the types that it may be one of."""
    if hasattr(kind, "__metadata__"):
        return parts_of(get_args(kind)[0])
    if get_origin(kind) in (Union, UnionType):
        return [part for one in get_args(kind) for part in parts_of(one)]
    return [kind]


def entries(kind, place=()) -> Iterator[tuple[str, ...]]:
    """Yield the places of all entries of a structure, without numbers and languages."""
    structures = []
    for part in parts_of(kind):
        of = get_args(part)[0] if get_origin(part) is tuple else part
        structures += [
            one
            for one in parts_of(of)
            if isinstance(one, type) and issubclass(one, Struct)
        ]
    for structure in structures:
        for name, hint in get_type_hints(structure, include_extras=True).items():
            yield from entries(hint, (*place, name))
    if not structures:
        yield place


def places_shown(editor) -> set[tuple[str, ...]]:
    """The places of all fields of all entries, without numbers and languages."""
    found = set()
    for _, page, _ in editor.pages:
        editor.tabs.setCurrentWidget(page)
        lists = isinstance(page, EntryList)
        for place in [row.place for row in page.rows() if row.place] if lists else [()]:
            if lists:
                page.select(place)
                assert editor.minimumSizeHint().width() <= SMALL_PX[0], place
            fields = getattr(page, "fields", page)
            found |= {
                tuple(
                    part
                    for part in one
                    if isinstance(part, str) and part not in editor.document.languages
                )
                for one in fields.by_place
            }
    return found


@pytest.mark.parametrize(
    "template", ["qoe2012", "consistency", "two-interval", "staircase"]
)
def test_every_entry_of_a_definition_has_a_field(edit, tmp_path, template):
    study = create_study(tmp_path / "s", template)
    study = change_definition(study, with_every_kind(json.loads(study.content)))
    editor = edit(study.folder)
    editor.tabs.setCurrentWidget(editor.questions)
    editor.questions.select(("pages", 0))
    editor.questions.add_score()
    editor.keep()
    shown = places_shown(editor)
    missing = set(entries(Definition)) - shown - KEPT
    # a form of its own has the parameters of a condition
    missing -= {("feedbacks", name) for name in ("condition", "parameters")}
    if template != "qoe2012":  # ratings alone have a sum
        missing -= {("pages", "questions", "in_qoe")}
    missing -= {one for one in missing if one[0] in UNUSED[template]}
    assert missing == set()
    told = editor.general.unchanged()
    for name in ("template", "id"):
        assert str(editor.document.at((name,))) in told
    assert json.loads(editor.draft.study.content) == editor.document.value
    assert ("feedbacks", "key") in set(entries(StudyFeedback, ("feedbacks",)))
    assert Text in parts_of(get_type_hints(Definition)["title"] | Text)


def wordless(part, languages):
    """Whether a text has nothing in it, in any language."""
    return isinstance(part, dict) and part.keys() and part.keys() <= set(languages)


def word_all(editor, place=()):
    """Write a text wherever one is missing."""
    part = editor.document.at(place) if place else editor.document.value
    if wordless(part, editor.document.languages):
        for language in part:
            if not part[language]:
                editor.document.set((*place, language), f"Worded {language}?", "")
    elif isinstance(part, dict | list):
        keys = part if isinstance(part, dict) else range(len(part))
        for key in list(keys):
            word_all(editor, (*place, key))


def test_questions_of_each_kind_go_from_the_editor_to_data(edit, tmp_path, capsys):
    folder = create_study(tmp_path / "s").folder
    editor = edit(folder)
    editor.tabs.setCurrentWidget(editor.questions)
    questions = editor.questions
    for when in When:
        questions.add_page(when)
        page = int(questions.selected[1])
        for kind in QuestionKind:
            questions.add(kind)
        questions.select(("pages", page, "questions", 0))
        questions.remove()  # the one that a new page has
    word_all(editor)
    editor.keep()
    assert not any(one.is_fatal for one in editor.problems), editor.problems
    definition = open_study(folder).definition
    pages = [page for page in definition.pages if page.key.startswith("page-")]
    kinds = [[one.kind for one in page.questions] for page in pages]
    assert kinds == [list(QuestionKind)] * len(When)
    editor.close()
    for words in (
        ("simulate", "--participants", "3"),
        ("status",),
        ("export", "-o", str(tmp_path / "csv")),
        ("analyse", "--output", str(tmp_path / "report")),
    ):
        assert cli.main(["study", words[0], str(folder), *words[1:]]) == 0
    columns = (tmp_path / "csv" / "data_dictionary.csv").read_text()
    for asked in [one for page in pages for one in page.questions]:
        assert (asked.key in columns) is (asked.kind is not QuestionKind.TEXT)
    numbers = json.loads((tmp_path / "report" / "numbers.json").read_text())
    asked = next(page for page in pages if page.when is When.AFTER_CLIP).questions
    assert {one.key for one in asked[:3]} < set(numbers["factors"])
    assert {one.key for one in asked[3:6]} < set(numbers["questions"])
    again = edit(folder)
    assert again.document.value == editor.document.value
    capsys.readouterr()


def test_pages_are_moved_among_those_of_the_same_time(edit, tmp_path):
    editor = edit(create_study(tmp_path / "s").folder)
    questions = editor.questions
    editor.tabs.setCurrentWidget(questions)
    before = editor.document.value
    questions.add_page(When.BEFORE)
    questions.select(("pages", 3))
    assert questions.up_button.isEnabled()
    assert not questions.down_button.isEnabled()
    questions.move_by(-1)
    shown = [page["key"] for page in editor.document.value["pages"]]
    assert shown == ["page-4", "sheet", "rating", "post-test"]
    assert questions.selected == ("pages", 0)
    questions.select(("pages", 2, "questions", 3))
    questions.move_to_page(questions.selected, 0)
    moved = editor.document.value["pages"]
    assert [len(page["questions"]) for page in moved] == [2, 4, 3, 5]
    assert moved[0]["questions"][1]["key"] == "satisfaction"
    assert questions.selected == ("pages", 0, "questions", 1)
    word_all(editor)
    editor.keep()
    (told,) = [one for one in editor.problems if "in_qoe" in one.field]
    assert told.field == "pages[0].questions[1].in_qoe"
    while editor.undo_button.isEnabled():
        editor.undo_button.click()
    assert editor.document.value == before


def test_the_label_of_an_end_goes_with_it(edit, tmp_path):
    editor = edit(create_study(tmp_path / "s").folder)
    questions, place = editor.questions, ("pages", 1, "questions", 0)
    editor.tabs.setCurrentWidget(questions)
    questions.select(place)
    questions.fields.by_place[(*place, "most")].setValue(7)
    asked = editor.document.at(place)
    assert [one["at"] for one in asked["labels"]] == [1, 7]
    editor.keep()
    study = open_study(tmp_path / "s").definition
    assert study.pages[1].questions[0].labels[1].text["en"] == "totally"
    editor.undo_button.click()
    assert editor.document.at((*place, "most")) == 5


def test_rows_of_labels_are_named_and_ordered_by_point(edit, tmp_path):
    editor = edit(create_study(tmp_path / "s").folder)
    questions, place = editor.questions, ("pages", 1, "questions", 0)
    fields, labels = questions.fields, (*place, "labels")
    editor.tabs.setCurrentWidget(questions)
    questions.select(place)
    fields.by_place[(*place, "most")].setValue(7)

    def told(number):
        return fields.rows.labelForField(fields.by_place[(*labels, number)]).text()

    assert [told(0), told(1)] == ["Label of 1", "Label of 7"]
    line = fields.by_place[(*labels, 1, "text", "en")]
    assert line.accessibleName() == line.placeholderText() == "Label of 7 (English)"
    questions._add_label(place)
    fields.by_place[(*labels, 2, "at")].setValue(4)
    assert told(2) == "Label of 4"
    questions.select(("pages", 1, "questions", 1))
    questions.select(place)
    rows = [
        fields.rows.getWidgetPosition(fields.by_place[(*labels, n)])[0]
        for n in (0, 2, 1)
    ]
    assert rows == sorted(rows)
    editor.keep()
    shown = editor.problem_list
    said = [shown.item(row).text() for row in range(shown.count())]
    assert any("\u203a Label of 4 \u203a Wording" in one for one in said)
    assert not any("Labels of points" in one for one in said)


def test_the_preview_has_the_duration_of_the_editor(edit, tmp_path):
    editor = edit(create_study(tmp_path / "s", languages=["en"]).folder)
    page = editor.texts
    editor.tabs.setCurrentWidget(page)
    page.select(("texts", "consent"))
    page.preview.draw()
    minutes = editor.summary.text().split("about ")[1]
    assert f"about {minutes}" in page.preview.shown.text
