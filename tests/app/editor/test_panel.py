"""The numbers of an effect: sliders and fields, and what they make of it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.editor.document import Document
from app.editor.editing import Editing
from app.editor.effect_panel import EffectPanel
from app.editor.parameter_fields import STEPS, scale_of, tidy
from hapticplayer.rendering.effects import EFFECTS, Effect, EffectList, Target

CLIP_S = 10.0
PARAMETERS = [
    parameter
    for kind in EFFECTS
    for parameter in kind.parameters
    if parameter.range and not parameter.range.is_whole
]


@pytest.fixture
def panel(application, qtbot):
    every = tuple(Effect(kind.name, 1.0, 3.0) for kind in EFFECTS)
    made = EffectPanel(Editing(Document(EffectList(every)), CLIP_S))
    qtbot.addWidget(made)
    made.show()
    return made


def chosen(panel, kind) -> EffectPanel:
    names = [one.kind for one in panel.editing.document.effects.effects]
    panel.editing.document.select(names.index(kind))
    return panel


def effect(panel) -> Effect:
    return panel.editing.document.effect


@given(st.sampled_from(PARAMETERS), st.integers(0, STEPS))
def test_a_slider_returns_to_the_step_of_its_value(parameter, step):
    scale = scale_of(parameter.range)
    assert scale.step(scale.value(step)) == step
    assert abs(scale.step(tidy(scale.value(step))) - step) <= 1
    assert parameter.range.least <= scale.value(step)
    assert scale.value(step) <= parameter.range.largest * (1 + 1e-9)


@pytest.mark.parametrize("kind", [kind.name for kind in EFFECTS])
def test_every_kind_shows_its_parameters_and_they_change_it(panel, kind):
    chosen(panel, kind)
    for name in effect(panel).values():
        field = panel.fields[name]
        assert field.box.number() == effect(panel).values()[name]
        before = effect(panel)
        field.box.setValue(field.box.value() + field.box.singleStep())
        assert effect(panel).values()[name] == pytest.approx(field.box.value())
        panel.editing.document.stack.undo()
        assert effect(panel) == before
        assert field.box.number() == before.values()[name]


def test_moving_a_slider_is_one_step_of_undo(panel):
    slider = chosen(panel, "sine").fields["amplitude"].slider
    for first, last in ((110, 120), (60, 70)):
        slider.sliderPressed.emit()
        for step in range(first, last):
            slider.setValue(step)
    assert panel.editing.document.stack.count() == 2
    # from -5 to 5 in 200 steps
    assert effect(panel).parameters["amplitude"] == pytest.approx(69 * 0.05 - 5.0)
    panel.editing.document.stack.undo()
    assert effect(panel).parameters["amplitude"] == pytest.approx(119 * 0.05 - 5.0)


def test_fades_fit_beside_each_other(panel):
    chosen(panel, "gain").fields["fade_in_s"].box.setValue(1.5)
    panel.fields["fade_out_s"].box.setValue(1.0)
    assert effect(panel).fade_in_s == 1.5
    assert effect(panel).fade_out_s == 0.5
    panel.fields["end_s"].box.setValue(2.0)
    assert effect(panel).end_s == 2.0
    assert effect(panel).fade_in_s + effect(panel).fade_out_s <= 1.0 + 1e-9
    assert panel.fields["fade_in_s"].box.maximum() == pytest.approx(1.0)


def test_the_target_changes_units_and_directions(panel, qtbot):
    chosen(panel, "pulse")
    assert panel.fields["amplitude"].box.suffix() == " N"
    panel.target.setCurrentIndex(1)
    panel.target.activated.emit(1)
    assert effect(panel).target is Target.MOTION
    assert panel.fields["amplitude"].box.suffix() == " m/s\u00b2"
    panel.direction.boxes[0].setValue(1.0)
    panel.direction.boxes[1].setValue(0.0)
    assert effect(panel).direction == (1.0, 0.0, 0.0)
    panel.direction.boxes[0].setValue(0.0)
    assert "direction" in panel.problem.text()  # not all may be zero
    assert effect(panel).direction == (1.0, 0.0, 0.0)
    chosen(panel, "low-pass")
    assert not panel.direction.isVisible()


def test_control_points_are_entered_as_text(panel):
    chosen(panel, "gain")
    panel.curve.setFocus()
    QTest.keyClicks(panel.curve, "0 1; 0.5 2; 2 1")
    QTest.keyClick(panel.curve, Qt.Key.Key_Return)
    assert effect(panel).curve == ((0.0, 1.0), (0.5, 2.0), (2.0, 1.0))
    assert "gain" not in panel.fields  # they stand for it
    assert panel.curve.text() == "0 1; 0.5 2; 2 1"
    panel.curve.setText("2 1; 1 1")
    panel.curve.editingFinished.emit()
    assert "times must increase" in panel.problem.text()
    panel.curve.setText("half 1")
    panel.curve.editingFinished.emit()
    assert "must be a time in s and a value" in panel.problem.text()
    panel.curve.setText("")
    panel.curve.editingFinished.emit()
    assert effect(panel).curve == ()
    assert "gain" in panel.fields


def test_fields_that_go_change_nothing(panel):
    chosen(panel, "gain").curve.setFocus()
    QTest.keyClicks(panel.curve, "0 1")
    before = panel.editing.document.effects
    chosen(panel, "engine")
    QTest.qWait(10)
    assert panel.editing.document.effects == before


def test_the_order_can_be_changed_and_the_effect_stays_chosen(panel):
    chosen(panel, "mute")
    assert panel.order.text() == f"4/{len(EFFECTS)}"
    panel.later.click()
    names = [one.kind for one in panel.editing.document.effects.effects]
    assert names[3:5] == ["pulse", "mute"]
    assert effect(panel).kind == "mute"
    for _ in range(4):
        panel.earlier.click()
    assert panel.order.text() == f"1/{len(EFFECTS)}"
    assert not panel.earlier.isEnabled()
    while panel.editing.document.stack.canUndo():
        panel.editing.document.stack.undo()
    names = [one.kind for one in panel.editing.document.effects.effects]
    assert names == [kind.name for kind in EFFECTS]


def test_the_wheel_changes_only_what_has_the_focus(panel, qtbot):
    field = chosen(panel, "sine").fields["frequency_hz"]

    def turn(widget) -> None:
        middle = QPointF(widget.rect().center())
        event = QWheelEvent(
            middle,
            widget.mapToGlobal(middle),
            QPoint(),
            QPoint(0, 120),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier(0),
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(widget, event)

    before = effect(panel)
    turn(field.box)
    turn(field.slider)
    assert effect(panel) == before
    panel.activateWindow()
    qtbot.waitUntil(panel.isActiveWindow)
    field.box.setFocus()
    turn(field.box)
    assert effect(panel) != before
