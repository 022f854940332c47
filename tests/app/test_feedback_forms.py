"""Conditions with parameters: felt in the window, and listed in a study."""

import json

import numpy as np
import pytest
from PySide6.QtWidgets import QComboBox, QDoubleSpinBox, QLineEdit

from app.experimenter.feedback_list import FeedbackDialog
from app.experimenter.study_editor import StudyEditor
from app.player.choices import feedbacks
from app.player.condition_form import ConditionDialog, ConditionForm
from hapticplayer.playback.source import open_source
from hapticplayer.rendering import FEEDBACKS, ChosenFeedback, chosen_feedback
from hapticplayer.study.creation import create_study


@pytest.fixture
def form(application, qtbot):
    made = ConditionForm(["mine"])
    qtbot.addWidget(made)
    return made


def choose(form, name):
    form.condition.setCurrentIndex(form.condition.findData(name))


def test_every_condition_can_be_chosen_with_its_defaults(form):
    for one in FEEDBACKS:
        choose(form, one.name)
        chosen = form.chosen()
        assert chosen.name == one.name
        allowed = {p.name: p.default for p in one.parameters if p.default != ""}
        assert chosen.parameters == allowed
        assert chosen_feedback(chosen.text) == chosen


def test_numbers_words_and_folders_are_read(form):
    choose(form, "delayed")
    spin = form.findChild(QDoubleSpinBox, "delay_s")
    assert (spin.minimum(), spin.maximum(), spin.suffix()) == (-5.0, 5.0, " s")
    spin.setValue(-0.25)
    assert form.chosen().text == "delayed:delay_s=-0.25"
    choose(form, "realistic")
    combo = form.findChild(QComboBox, "preset")
    combo.setCurrentIndex(combo.findData("equal"))
    assert form.chosen().text == "realistic:preset=equal"
    choose(form, "shuffled")
    form.findChild(QLineEdit).setText("/rides/a, b")
    assert form.chosen() == chosen_feedback("shuffled:of=/rides/a, b")


def test_a_chosen_condition_is_made_and_played(window, wait_for, sequence):
    source = open_source(sequence)
    window.session.show_source(source)
    wait_for(window.commands.feedback.isEnabled)
    window.session.make_feedback(ChosenFeedback("delayed", {"delay_s": 0.4}))
    wait_for(lambda: window.player.snapshot().feedback == "delayed:delay_s=0.4")
    made = window.player.snapshot().source.tracks
    whole = source.tracks["realistic"]
    assert made["delayed:delay_s=0.4"].time_s == pytest.approx(whole.time_s + 0.4)
    assert np.array_equal(made["realistic"].force_n, whole.force_n)
    combo = window.transport.feedback
    assert combo.currentText() == "Delayed (delay_s 0.4)"
    window.session.choose_feedback("realistic")
    wait_for(lambda: combo.currentText() == "Realistic")


def test_a_condition_that_cannot_be_made_is_reported(window, wait_for, sequence):
    window.session.show_source(open_source(sequence))
    window.session.make_feedback(ChosenFeedback("shuffled", {}))
    wait_for(lambda: "of=FOLDER" in window.messages.text())
    assert window.player.snapshot().feedback == "realistic"


def test_the_dialog_says_what_is_wanted(application, qtbot):
    dialog, wanted = ConditionDialog(["mine"]), []
    qtbot.addWidget(dialog)
    dialog.wanted.connect(wanted.append)
    combo = dialog.form.condition
    names = [combo.itemData(i) for i in range(combo.count())]
    made = [one.name for one in FEEDBACKS if one.parameters or one.is_derived]
    assert names[: len(made)] == made
    choose(dialog.form, "inverted")
    dialog.play_button.click()
    assert wanted == [ChosenFeedback("inverted", {})]


def test_a_long_folder_is_called_by_its_name():
    (choice,) = feedbacks(["shuffled:of=/a/very/long/folder/ride"])
    assert choice.text == "Shuffled (of ride)"


@pytest.fixture
def editor(application, qtbot, tmp_path):
    made = StudyEditor(create_study(tmp_path / "s"))
    qtbot.addWidget(made)
    return made


def test_feedbacks_are_added_to_a_study_and_removed(editor, qtbot):
    listed = editor.feedbacks
    dialog = FeedbackDialog(["bike", "horse"])
    qtbot.addWidget(dialog)
    dialog.wanted.connect(listed.add)
    choose(dialog.form, "scaled")
    dialog.form.findChild(QDoubleSpinBox, "gain").setValue(1.5)
    dialog.key.setText("strong")
    dialog.add_button.click()
    choose(dialog.form, "shuffled")
    dialog.key.clear()
    combo = dialog.form.findChild(QComboBox, "of")
    assert [combo.itemData(i) for i in range(combo.count())] == ["", "bike", "horse"]
    dialog.add_button.click()
    listed.list.setCurrentRow(2)
    listed.remove_button.click()
    rows = [listed.list.item(row).text() for row in range(listed.list.count())]
    assert rows[0] == "Realistic (preset faithful)"  # as the paper did it
    assert rows[1:] == ["None", "strong: Scaled (gain 1.5)", "Shuffled"]
    editor.save()
    assert json.loads(editor.study.content)["feedbacks"] == [
        {"condition": "realistic", "parameters": {"preset": "faithful"}},
        "none",
        {"condition": "scaled", "parameters": {"gain": 1.5}, "key": "strong"},
        "shuffled",
    ]


def test_a_wrong_key_is_named_by_its_field(editor):
    editor.feedbacks.add({"condition": "inverted", "key": "Not a key"})
    editor.save()
    assert "feedbacks[3].key" in editor.problem.text()
    assert not editor.study.definition.feedback_keys[3:]


def test_the_last_feedback_stays(editor):
    for _ in range(5):
        editor.feedbacks.list.setCurrentRow(0)
        editor.feedbacks.remove_button.click()
    assert editor.feedbacks.entries == ["random"]
