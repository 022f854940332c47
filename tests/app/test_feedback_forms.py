"""Conditions with parameters, felt in the window."""

import numpy as np
import pytest
from PySide6.QtWidgets import QComboBox, QDoubleSpinBox, QLineEdit

from app.player.choices import feedback_words, feedbacks
from app.player.condition_form import ConditionDialog, ConditionForm
from hapticplayer.playback.source import open_source
from hapticplayer.rendering import FEEDBACKS, ChosenFeedback, chosen_feedback


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
    assert combo.currentText() == "Delayed (Delay 0.4\u00a0s)"
    window.session.choose_feedback("realistic")
    wait_for(lambda: combo.currentText() == "Realistic")


def test_a_condition_that_cannot_be_made_is_reported(window, wait_for, sequence):
    window.session.show_source(open_source(sequence))
    window.session.make_feedback(ChosenFeedback("shuffled", {}))
    wait_for(lambda: "choose its folder" in window.messages.text())
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
    assert choice.text == "Shuffled (Other sequence ride)"


def test_a_condition_is_shown_and_changes_of_it_are_told(form):
    told = []
    form.changed.connect(lambda: told.append(form.chosen().text))
    form.show_chosen(chosen_feedback("scaled:gain=1.5"))
    assert form.chosen().text == "scaled:gain=1.5"
    assert told == []  # nobody has chosen
    form.findChild(QDoubleSpinBox, "gain").setValue(2.0)
    form.show_chosen(chosen_feedback("realistic:preset=equal"))
    combo = form.findChild(QComboBox, "preset")
    combo.setCurrentIndex(combo.findData("balanced"))
    assert told == ["scaled:gain=2", "realistic:preset=balanced"]


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("realistic", {"preset": "faithful"}, "Realistic (Preset Faithful)"),
        ("delayed", {"delay_s": 0.5}, "Delayed (Delay 0.5\u00a0s)"),
        ("scaled", {"gain": 2}, "Scaled (Gain 2)"),
        ("shuffled", {"of": "/rides/horse"}, "Shuffled (Other sequence horse)"),
        ("none", {}, "None"),
    ],
)
def test_a_condition_is_shown_in_words(name, given, words):
    assert feedback_words(ChosenFeedback(name, given)) == words
