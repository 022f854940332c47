"""The editor of a study, and the menu that opens it."""

import json

import pytest
from PySide6.QtWidgets import QFileDialog, QInputDialog

from app.experimenter.study_editor import StudyEditor
from hapticplayer.study.creation import create_study
from hapticplayer.study.definition import OrderMethod


@pytest.fixture
def editor(application, qtbot, tmp_path):
    made = StudyEditor(create_study(tmp_path / "s"))
    qtbot.addWidget(made)
    return made


def test_an_unedited_study_stays_unchanged(editor):
    assert editor.edited() == json.loads(editor.study.content)


def test_an_edited_study_is_kept(editor):
    editor.title.setText("My study")
    editor.method.setCurrentIndex(editor.method.findData("williams"))
    editor.folders["bike"].setText("rides/bike")
    editor.texts["0", "text", "fr"].setText("Une autre question ?")
    editor.texts["0", "published", "en"].setText("As printed")
    editor.published.setChecked(True)
    editor.save()
    study = editor.study.definition
    assert study.title == "My study"
    assert study.order.method is OrderMethod.WILLIAMS
    assert study.sequences[0].folder == "rides/bike"
    assert study.factors[0].text["fr"] == "Une autre question ?"
    assert study.wording(study.factors[0], "en") == "As printed"
    assert editor.result() == editor.DialogCode.Accepted


def test_a_wrong_study_is_reported_and_not_kept(editor):
    before = (editor.study.folder / "study.json").read_bytes()
    editor.texts["1", "text", "de"].setText(" ")
    editor.save()
    assert "factors[1].text.de" in editor.problem.text()
    assert (editor.study.folder / "study.json").read_bytes() == before
    assert editor.result() != editor.DialogCode.Accepted


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


def test_the_next_dialog_begins_where_the_last_study_was(window, tmp_path, monkeypatch):
    asked = []

    def choose(_parent, _title, before) -> str:
        asked.append(before)
        return str(tmp_path / "studies" / "rides")

    monkeypatch.setattr(QFileDialog, "getExistingDirectory", choose)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *a: (choose(*a), ""))
    monkeypatch.setattr(QInputDialog, "getItem", lambda *_, **__: ("", False))
    window.study_menu.edit()  # there is none: reported, and nothing else
    window.study_menu.new()
    assert asked == ["", str(tmp_path / "studies")]
    exported = tmp_path / "settings.json"
    window.settings.export(exported)
    assert "studies" not in exported.read_text()
