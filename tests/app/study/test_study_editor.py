"""An experimenter makes a study in the window, and the command line reads it."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QLabel,
)

from app.experimenter.study.document import place_of
from app.experimenter.study.editor import StudyEditor
from app.experimenter.study.new_study import NewStudyDialog
from app.experimenter.study.sequences import LibraryChoice, free_key
from app.participant.pages import QuestionsPage
from hapticplayer.cli.study import status
from hapticplayer.sequence.library import entries, read_entry
from hapticplayer.study.creation import create_study
from hapticplayer.study.definition import OrderMethod, QuestionKind
from hapticplayer.study.drafts import DRAFT, problems_of
from hapticplayer.study.study_folder import open_study
from tests.material.shaken import write_shaken_sequence

TITLES = ("Bicycle, old town", "Horse, gallop")


@pytest.fixture(scope="session")
def library(clip, tmp_path_factory) -> Path:
    """Two rides."""
    folder = tmp_path_factory.mktemp("library")
    for number, title in enumerate(TITLES):
        write_shaken_sequence(clip, folder / f"ride-{number}", title=title)
    return folder


@pytest.fixture
def editor(edit, tmp_path):
    return edit(create_study(tmp_path / "s", languages=["en", "de"]).folder)


def show(editor, page):
    editor.tabs.setCurrentWidget(page)
    return page


def words(editor):
    shown = editor.problem_list
    return [shown.item(row).text() for row in range(shown.count())]


def field(page, *place):
    fields = getattr(page, "fields", page)
    return fields.by_place[place]


def typed(widget, text):
    """Type over what is there."""
    widget.setFocus()
    widget.selectAll()
    QTest.keyClicks(widget, text)


def test_a_study_of_two_rides_and_two_questions_is_made(
    application, qtbot, library, edit, tmp_path, capsys
):
    dialog, made = NewStudyDialog(tmp_path), []
    qtbot.addWidget(dialog)
    dialog.made.connect(made.append)
    dialog.show()
    typed(dialog.name, "Rides 2026")
    dialog.create_button.click()
    editor = edit(made[0])
    sequences = show(editor, editor.sequences)
    choice = LibraryChoice(library, sequences)
    choice.chosen.connect(sequences.add)
    choice.list.selectAll()
    choice.add_button.click()
    questions = show(editor, editor.questions)
    questions.select(("pages", 0))
    questions.add(QuestionKind.NUMBER)
    typed(
        field(questions, "pages", 0, "questions", 4, "text", "en"),
        "Hours of cycling a week?",
    )
    field(questions, "pages", 0, "questions", 4, "most").setValue(60)
    questions.select(("pages", 1))
    questions.add(QuestionKind.SCALE)
    typed(
        field(questions, "pages", 1, "questions", 4, "text", "en"),
        "How safe did you feel?",
    )
    editor.keep()
    assert (editor.state.text(), words(editor)) == ("Saved", [])
    editor.close()
    study = open_study(made[0]).definition
    assert study.title == "Rides 2026"
    assert [one.key for one in study.sequences] == ["bicycle-old-town", "horse-gallop"]
    assert (study.pages[0].questions[4].text, study.pages[0].questions[4].most) == (
        {"en": "Hours of cycling a week?"},
        60,
    )
    assert study.pages[1].questions[4].text == {"en": "How safe did you feel?"}
    assert problems_of(json.loads(open_study(made[0]).content), made[0]) == []
    options = type("Options", (), {"study": made[0], "json": True})
    assert status(options) == 0  # what `study status` reads
    told = json.loads(capsys.readouterr().out)
    assert (told["conditions"], told["missing_sequences"]) == (6, [])


def test_an_unedited_study_stays_unchanged(edit, tmp_path):
    study = create_study(tmp_path / "s")
    edit(study.folder).close()
    assert (study.folder / "study.json").read_bytes() == study.content


def test_a_study_that_is_looked_at_keeps_its_french_spaces(edit, tmp_path):
    study = create_study(tmp_path / "s", languages=["fr"])
    editor = edit(study.folder)
    for number in range(editor.tabs.count()):
        editor.tabs.setCurrentIndex(number)
    assert not editor.undo_button.isEnabled()
    editor.close()
    assert (study.folder / "study.json").read_bytes() == study.content


def test_problems_are_told_in_french(edit, spoken, tmp_path):
    spoken("fr")
    editor = edit(create_study(tmp_path / "s", languages=["fr"]).folder)
    assert words(editor)[0] == (
        "S\u00e9quences \u203a \u00ab\u00a0V\u00e9lo\u00a0\u00bb \u203a Enregistrement\u00a0: "
        "il n\u2019y en a pas encore\u00a0; choisissez-en un"
    )


def test_every_page_is_filled_in_and_kept(editor):
    general = editor.general
    typed(field(general, "title"), "My study")
    field(general, "operator_is_blind").click()
    order = show(editor, editor.order)
    combo = field(order, "order", "method")
    combo.setCurrentIndex(combo.findData("williams"))
    combo.activated.emit(combo.currentIndex())
    texts = show(editor, editor.texts)
    texts.select(("texts", "thanks"))
    field(texts, "texts", "thanks", "de").setPlainText("Vielen Dank!")
    questions = show(editor, editor.questions)
    questions.select(("pages", 1, "questions", 0))
    typed(field(questions, "pages", 1, "questions", 0, "published", "en"), "As printed")
    field(questions, "pages", 1, "questions", 0, "required").click()
    editor.general.document.set(("use_published",), True, "")
    editor.keep()
    study = open_study(editor.draft.study.folder).definition
    assert study.title == "My study"
    assert study.operator_is_blind is False
    assert study.order.method is OrderMethod.WILLIAMS
    assert study.texts.thanks["de"] == "Vielen Dank!"
    assert study.wording(study.pages[1].questions[0], "en") == "As printed"
    assert study.pages[1].questions[0].required is False


def test_sequences_are_renamed_put_in_order_and_removed(editor):
    page = show(editor, editor.sequences)
    page.select(("sequences", 3))
    page.up_button.click()
    assert page.selected == ("sequences", 2)
    typed(field(page, "sequences", 2, "key"), "braking")
    page.select(("sequences", 0))
    page.remove_button.click()
    editor.keep()
    keys = [
        one.key for one in open_study(editor.draft.study.folder).definition.sequences
    ]
    assert keys == ["horse", "braking", "car-turning"]
    for _ in range(4):
        page.remove_button.click()
    assert len(editor.document.value["sequences"]) == 1  # the last one stays


def test_a_recording_is_told_on_one_line(editor, library):
    page = show(editor, editor.sequences)
    page.select(("sequences", 0))
    page.use([read_entry(library / "ride-0")])
    choose = field(page, "sequences", 0, "folder")
    rows = page.fields.rows
    row, _ = rows.getWidgetPosition(choose)
    told = rows.itemAt(row - 1, QFormLayout.ItemRole.FieldRole).widget()
    QApplication.processEvents()
    needed = told.fontMetrics().horizontalAdvance(told.text())
    assert TITLES[0] in told.text()
    assert needed <= told.width()
    assert told.height() >= told.heightForWidth(told.width())


def test_names_in_the_data_are_made_of_titles():
    assert free_key("Car, turning!", ["car-turning"]) == "car-turning-2"
    assert free_key("Ä", []) == "sequence"
    assert len(free_key("a" * 90, [])) <= 40


def test_conditions_are_added_with_parameters_and_removed(editor):
    page = show(editor, editor.conditions)
    page.add("scaled")
    page.fields.findChild(QDoubleSpinBox, "gain").setValue(1.5)
    typed(field(page, "feedbacks", 3, "key"), "strong")
    page.add("shuffled")
    combo = page.fields.findChild(QComboBox, "of")
    offered = [combo.itemData(row) for row in range(combo.count())]
    assert offered == ["", "bike", "horse", "car-turning", "car-braking"]
    page.select(("feedbacks", 2))
    page.remove_button.click()
    page.add("scaled")
    editor.keep()
    assert json.loads(editor.draft.study.content)["feedbacks"] == [
        {"condition": "realistic", "parameters": {"preset": "faithful"}},
        "none",
        {"condition": "scaled", "parameters": {"gain": 1.5}, "key": "strong"},
        "shuffled",
        "scaled",
    ]


def test_a_condition_is_previewed_on_a_ride(editor, library, wait_for):
    page = editor.conditions
    show(editor, editor.sequences).add(entries(library))
    show(editor, page)
    page.select(("feedbacks", 1))
    picture = page.preview.picture
    wait_for(lambda: picture.after is not None)
    assert abs(picture.before.force_n).max() > 0.1
    assert abs(picture.after.force_n).max() == 0.0  # no force
    page.select(("feedbacks", 0))
    wait_for(lambda: picture.after is not None and abs(picture.after.force_n).max() > 0)


def test_a_track_of_the_sequences_stays_a_condition(editor):
    page = show(editor, editor.conditions)
    before = editor.document.value["feedbacks"]
    editor.document.set(("feedbacks",), ["mine", *before[1:]], "")
    page.select(("feedbacks", 0))
    told = [label.text() for label in page.fields.findChildren(QLabel)]
    assert "The track mine that each sequence has" in told
    typed(field(page, "feedbacks", 0, "key"), "own")
    editor.undo_button.click()
    editor.undo_button.click()
    assert editor.document.value["feedbacks"] == before
    assert page.fields.findChild(QComboBox) is not None
    editor.redo_button.click()
    editor.keep()
    assert open_study(editor.draft.study.folder).definition.feedback_keys[0] == "mine"


def test_levels_of_a_consistency_study_are_edited(edit, tmp_path):
    editor = edit(create_study(tmp_path / "s", "consistency").folder)
    page = show(editor, editor.conditions)
    page.add_level()
    field(page, "levels", 8, "gain").setValue(0.5)
    field(page, "repeats").setValue(2)
    editor.keep()
    study = open_study(tmp_path / "s").definition
    assert (study.levels[8].delay_s, study.levels[8].gain) == (0.9, 0.5)
    assert study.repeats == 2
    assert "72 trials" in editor.summary.text()


def test_a_problem_is_told_in_words_and_leads_to_its_field(editor):
    page = show(editor, editor.questions)
    page.select(("pages", 0, "questions", 1))
    typed(field(page, "pages", 0, "questions", 1, "choices", 0, "text", "de"), " ")
    editor.tabs.setCurrentWidget(editor.general)
    editor.keep()
    (told,) = words(editor)
    assert told.startswith("Before the first clip \u203a \u201cWhat is your gender?")
    assert told.endswith("1 \u203a Wording \u203a Deutsch: is empty")
    assert "pages[" not in told
    editor.problem_list.itemClicked.emit(editor.problem_list.item(0))
    assert editor.tabs.currentWidget() is page
    assert field(
        page, "pages", 0, "questions", 1, "choices", 0, "text", "de"
    ).hasFocus()


def test_missing_recordings_are_told_but_the_study_is_kept(editor):
    assert len(words(editor)) == 4
    assert "none yet" in words(editor)[0]
    assert "[" not in " ".join(words(editor))
    assert "not ready" in editor.state.text()
    assert not (editor.draft.study.folder / DRAFT).exists()


def test_every_change_is_undone_and_redone(editor):
    before = editor.document.value
    page = show(editor, editor.questions)
    page.select(("pages", 2))
    page.add(QuestionKind.CHOICE)
    box = field(page, "pages", 2, "questions", 5, "kind")
    box.setCurrentIndex(box.findData("number"))
    box.activated.emit(box.currentIndex())
    line = field(page, "pages", 2, "questions", 5, "key")
    typed(line, "mine")
    after = editor.document.value
    QTest.keyClick(line, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert editor.document.at(("pages", 2, "questions", 5, "key")) == "question-14"
    while editor.undo_button.isEnabled():
        editor.undo_button.click()
    assert editor.document.value == before
    editor.keep()
    assert json.loads(editor.draft.study.content) == before
    while editor.redo_button.isEnabled():
        editor.redo_button.click()
    assert editor.document.value == after


def test_languages_come_with_the_wording_of_the_template(editor):
    boxes = editor.general.languages
    boxes["fr"].click()
    boxes["en"].click()
    editor.keep()
    study = open_study(editor.draft.study.folder).definition
    assert study.languages == ("de", "fr")
    assert study.texts.consent["fr"].startswith("Vous allez regarder")
    assert set(study.sequences[0].title) == {"de", "fr"}


def test_the_preview_is_the_participants_page(editor):
    page = show(editor, editor.questions)
    page.select(("pages", 1, "questions", 0))
    typed_in = "Was it as if you were there?"
    field(page, "pages", 1, "questions", 0, "text", "en").setPlainText(typed_in)
    page.preview.draw()
    assert page.preview.shown.questions[0].text == typed_in
    assert not page.preview.picture.shown.isNull()
    page.preview.large.click()
    shown = page.preview.findChildren(QuestionsPage)
    assert shown[0].rows[0].asked.text == typed_in
    QTest.keyClick(shown[0].window(), Qt.Key.Key_Escape)


def test_the_orders_tell_who_gets_which(editor, wait_for):
    page = show(editor, editor.order)
    editor.document.set(("order", "method"), "latin-square", "")
    wait_for(lambda: not page.jobs.is_busy)
    table = page.table
    assert (table.rowCount(), table.columnCount()) == (12, 14)
    assert table.item(0, 1).text() == "next participant"
    cells = {table.item(0, column).text() for column in range(2, 14)}
    assert len(cells) == 12
    assert "Bike, None" in cells


def test_orders_of_a_table_are_taken_into_the_study(editor, tmp_path):
    made = open_study(editor.draft.study.folder).definition.conditions
    rows = [f"a,{n},{one.sequence},{one.feedback}" for n, one in enumerate(made)]
    (tmp_path / "mine.csv").write_text("order,position,sequence,feedback\n")
    page = show(editor, editor.order)
    editor.document.set(("order", "method"), "list", "")
    editor.keep()
    assert "orders.csv" in words(editor)[-1]
    with (tmp_path / "mine.csv").open("a") as file:
        file.write("\n".join(rows) + "\n")
    page.take(tmp_path / "mine.csv")
    assert "orders.csv" not in " ".join(words(editor))
    assert page.table.rowCount() == 1


TYPING = """
import sys
from pathlib import Path

from PySide6.QtTest import QTest

from app.experimenter.study.editor import StudyEditor
from app.player.application import make_application

application = make_application()
editor = StudyEditor(Path(sys.argv[1]), lambda: Path(sys.argv[1]))
editor.show()
editor.tabs.setCurrentWidget(editor.questions)
editor.questions.add("text")
line = editor.questions.fields.by_place["pages", 0, "questions", 4, "key"]
line.selectAll()
QTest.keyClicks(line, "mine")
while True:
    application.processEvents()
"""


def test_changes_survive_when_the_program_is_killed(edit, tmp_path, wait_for):
    folder = create_study(tmp_path / "s", languages=["en"]).folder
    command = [sys.executable, "-c", TYPING, str(folder)]
    process = subprocess.Popen(command, cwd=Path.cwd(), env=dict(os.environ))
    try:
        draft = folder / DRAFT  # the wording is still open
        wait_for(lambda: draft.exists() and b'"mine"' in draft.read_bytes())
    finally:
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert (
        len(open_study(folder).definition.pages[0].questions) == 4
    )  # as the command line reads it
    editor = edit(folder)
    assert "restored" in editor.messages.text()
    assert editor.document.at(("pages", 0, "questions", 4, "key")) == "mine"
    page = show(editor, editor.questions)
    page.select(("pages", 0, "questions", 4))
    field(page, "pages", 0, "questions", 4, "text", "en").setPlainText("And now?")
    editor.keep()
    assert open_study(folder).definition.pages[0].questions[4].text == {
        "en": "And now?"
    }
    assert not draft.exists()
    while editor.undo_button.isEnabled():
        editor.undo_button.click()
    assert len(editor.document.value["pages"][0]["questions"]) == 4


def test_closing_keeps_what_was_typed_last(editor):
    typed(field(editor.general, "title"), "At the end")
    editor.close()
    assert open_study(editor.draft.study.folder).definition.title == "At the end"


def test_a_change_by_another_program_is_not_overwritten(editor):
    path = editor.draft.study.folder / "study.json"
    content = json.loads(path.read_text())
    path.write_text(json.dumps({**content, "title": "Theirs"}))
    typed(field(editor.general, "title"), "Mine")
    editor.keep()
    assert "another program" in editor.messages.text()
    assert json.loads(path.read_text())["title"] == "Theirs"
    editor.close_button.click()
    assert editor.isVisible()
    assert "close again" in editor.state.text()
    editor.close_button.click()
    assert not editor.isVisible()


def test_a_new_study_says_what_is_missing(application, qtbot, tmp_path):
    (tmp_path / "Taken").mkdir()
    dialog = NewStudyDialog(tmp_path)
    qtbot.addWidget(dialog)
    assert not dialog.create_button.isEnabled()
    typed(dialog.name, "Taken")
    assert str(tmp_path / "Taken") in dialog.whole_place.text()
    dialog.create_button.click()
    assert "exists" in dialog.problem.text()
    dialog.languages["en"].setChecked(False)
    dialog.create_button.click()
    assert "language" in dialog.problem.text()
    assert not dialog.result()


def test_an_empty_library_says_what_to_do(application, qtbot, tmp_path):
    choice = LibraryChoice(tmp_path / "nothing")
    qtbot.addWidget(choice)
    assert "Import a recording" in choice.nothing.text()
    assert not choice.add_button.isEnabled()


def test_fields_are_named_as_their_places_are():
    assert place_of("pages[0].questions[1].choices[0].text.de") == (
        *("pages", 0, "questions", 1, "choices", 0, "text", "de"),
    )


def test_the_player_offers_studies(window, tmp_path, monkeypatch):
    titles = [action.text() for action in window.menuBar().actions()]
    assert "&Study" in titles
    reported = []
    monkeypatch.setattr(
        window.study_menu, "report", lambda one, _over=None: reported.append(one)
    )
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: tmp_path)
    window.study_menu.edit()
    assert "study.json" in str(reported[0])


def test_the_next_study_begins_where_the_last_one_was(window, tmp_path):
    window.study_menu.new()
    (first,) = window.findChildren(NewStudyDialog)
    first.place.setText(str(tmp_path))
    typed(first.name, "Mine")
    first.create_button.click()
    (editor,) = window.findChildren(StudyEditor)
    editor.close()
    assert window.study_menu.place() == tmp_path
    exported = tmp_path / "settings.json"
    window.settings.export(exported)
    assert str(tmp_path) not in exported.read_text()


def test_a_scale_is_added_and_tells_what_is_to_be_worded(edit, tmp_path):
    folder = create_study(tmp_path / "s", languages=["en"]).folder
    editor = edit(folder)
    editor.tabs.setCurrentWidget(editor.questions)
    questions = editor.questions
    questions.select(("pages", 0))
    questions.add_scale("ssq")
    questions.add_scale("hxi")
    editor.keep()
    pages = open_study(folder).definition.pages
    assert [(one.scale, one.when) for one in pages[3:]] == [
        ("ssq", "before"),
        ("hxi", "before"),
    ]
    problems = editor.draft.keep(editor.document.value)
    open_texts = [one for one in problems if one.field.startswith("pages")]
    assert len(open_texts) == 20
    assert not any(one.is_fatal for one in problems)
    total = pages[3].scores[-1]
    questions.select(("pages", 3, "scores", 3))
    field = questions.fields.by_place[("pages", 3, "scores", 3, "polynomial")]
    assert field.text() == "0, 3.74"
    field.selectAll()
    QTest.keyClicks(field, "1, 2")
    editor.keep()
    changed = open_study(folder).definition.pages[3].scores[-1]
    assert changed.polynomial == (1.0, 2.0)
    assert changed.of == total.of


def test_levels_of_sequences_are_typed_and_asked_for(edit, tmp_path, library):
    editor = edit(create_study(tmp_path / "seen", "viewpoint").folder)
    page = show(editor, editor.sequences)
    page.select(("sequences", 1))
    line = page.fields.by_place["sequences", 1, "factors"]
    assert line.text() == "viewpoint=third"
    typed(line, "viewpoint=third, rider=expert")
    held = editor.document.at(("sequences", 1, "factors"))
    assert held == {"viewpoint": "third", "rider": "expert"}
    editor.keep()
    assert any("rider" in one.what for one in editor.problems)  # the others lack it
    choice = LibraryChoice(library, page)
    choice.chosen.connect(page.add)
    choice.list.selectAll()
    choice.add_button.click()
    editor.keep()
    added = [one["factors"] for one in editor.document.value["sequences"]]
    assert all(one == {"viewpoint": "", "rider": ""} for one in added)
    assert all(one.is_fatal for one in editor.problems)
