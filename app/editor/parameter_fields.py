"""A number of an effect: its name, a slider over what is usual, and a field for all."""

import math
from typing import NamedTuple

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLabel, QSlider, QWidget

from app.experimenter.numbers import NumberBox
from app.widgets import theme
from app.widgets.layout import column_of, row_of
from hapticplayer.model.ranges import Range
from hapticplayer.rendering.effects.kinds import AMPLITUDE

STEPS = 200
"""Of a slider: a step is below what a hand tells apart."""

USUAL_AMPLITUDE = 5.0
"""A slider goes from minus to plus this; 4.5 N is the most that a device gives."""

_LOG_RATIO = 50.0  # from here on a slider is logarithmic
_LEAST_SLIDER_PX, _BOX_PX = 70, 116


class Scale(NamedTuple):
    """How the steps of a slider become values.

    Attributes:
        least, largest: at its ends.
        is_log: each step is a factor.
    """

    least: float
    largest: float
    is_log: bool = False

    def value(self, step: int) -> float:
        """Return the value of a step."""
        share = step / STEPS
        if self.is_log:
            return float(self.least * (self.largest / self.least) ** share)
        return self.least + share * (self.largest - self.least)

    def step(self, value: float) -> int:
        """Return the step that is next to a value, also outside of the slider."""
        value = min(max(value, self.least), self.largest)
        if self.is_log:
            share = math.log(value / self.least) / math.log(self.largest / self.least)
        else:
            share = (value - self.least) / (self.largest - self.least)
        return round(STEPS * share)


def scale_of(allowed: Range) -> Scale:
    """Return the slider of a parameter."""
    if allowed.unit == AMPLITUDE:
        return Scale(max(allowed.least, -USUAL_AMPLITUDE), USUAL_AMPLITUDE)
    is_log = allowed.least > 0.0 and allowed.largest / allowed.least >= _LOG_RATIO
    return Scale(allowed.least, allowed.largest, is_log)


def step_of(allowed: Range) -> float:
    """By how much a key changes a parameter."""
    return 1.0 if allowed.is_whole or allowed.unit == "Hz" else 0.1


def leaves_to_page(event: QEvent) -> bool:
    """Whether a key press is Space, which plays also where a number has the keyboard."""
    if event.type() != QEvent.Type.ShortcutOverride:
        return False
    return isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Space


def tidy(value: float) -> float:
    """Return a value of a slider with three digits that count."""
    return float(f"{value:.3g}")


class NumberField(QWidget):
    """One number; whole ones, such as a seed, have no slider.

    `changed` has the value and whether it belongs to the drag of before; a drag is one
    step of undo, and so are the steps of keys.
    """

    changed = Signal(float, bool)

    def __init__(self, text: str, allowed: Range, suffix: str) -> None:
        super().__init__()
        self.allowed, self._scale = allowed, scale_of(allowed)
        digits = 0 if allowed.is_whole else 3
        self.box = NumberBox(text, allowed, digits, step_of(allowed), suffix)
        self.box.setKeyboardTracking(False)
        self.box.setMinimumWidth(_BOX_PX)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setAccessibleName(text)
        self.slider.setRange(0, STEPS)
        self.slider.setMinimumWidth(_LEAST_SLIDER_PX)
        caption = QLabel(text)
        caption.setTextFormat(Qt.TextFormat.PlainText)
        caption.setStyleSheet(f"color: {theme.DIM};")
        if allowed.is_whole:
            self.slider.hide()
        column_of(
            caption,
            row_of((self.slider, 1), self.box, spacing=6),
            spacing=2,
            of=self,
        )
        for part in (self.slider, self.box):
            part.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            part.installEventFilter(self)
        self._goes_on = False
        self.slider.sliderPressed.connect(self._begin)
        self.slider.valueChanged.connect(self._on_slider)
        self.box.valueChanged.connect(lambda _value: self._on_box())

    def set_largest(self, largest: float) -> None:
        """Allow values up to another one from now on."""
        if largest != self.allowed.largest:
            self.allowed = self.allowed._replace(largest=largest)
            self._scale = scale_of(self.allowed)
            self.box.blockSignals(True)
            self.box.setMaximum(largest)
            self.box.blockSignals(False)

    def show_number(self, value: float) -> None:
        """Show a number that the field has not been given."""
        for part in (self.slider, self.box):
            part.blockSignals(True)
        if value != self.box.number():
            self.box.set_number(value)
        if self.slider.value() != self._scale.step(value):
            self.slider.setValue(self._scale.step(value))
        for part in (self.slider, self.box):
            part.blockSignals(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Leave Space to the page, and the wheel to the panel without the focus."""
        is_wheel = event.type() == QEvent.Type.Wheel
        is_idle = is_wheel and isinstance(watched, QWidget) and not watched.hasFocus()
        if is_idle or leaves_to_page(event):
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    def _begin(self) -> None:
        self._goes_on = False

    def _on_slider(self, step: int) -> None:
        value = tidy(self._scale.value(step))
        value = min(max(value, self.allowed.least), self.allowed.largest)
        goes_on, self._goes_on = self._goes_on, True
        self.changed.emit(value, goes_on)

    def _on_box(self) -> None:
        self.changed.emit(self.box.number(), True)
