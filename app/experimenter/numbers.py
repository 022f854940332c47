"""Fields for numbers that keep what they were given until a person changes it."""

from collections.abc import Iterable

from PySide6.QtCore import QLocale, Signal
from PySide6.QtWidgets import QDoubleSpinBox, QGridLayout, QLabel, QWidget

from app.widgets import theme
from app.widgets.layout import indent
from hapticplayer.model.ranges import Range


class NumberBox(QDoubleSpinBox):
    """A number without the zeros that it does not need.

    `number` is exactly what was set, which may have more digits than are shown.
    """

    def __init__(
        self, name: str, within: Range, digits: int, step: float, suffix: str = ""
    ) -> None:
        super().__init__()
        self._exact = self._rounded = 0.0
        self.setAccessibleName(name)
        self.setDecimals(digits)
        self.setRange(within.least, within.largest)
        self.setSingleStep(step)
        self.setSuffix(suffix)
        indent(self)

    def set_number(self, value: float) -> None:
        self.setValue(value)
        self._exact, self._rounded = value, self.value()

    def number(self) -> float:
        """Return it."""
        return self._exact if self.value() == self._rounded else self.value()

    def textFromValue(self, value: float) -> str:  # noqa: N802 - Qt's name
        return QLocale().toString(round(value, self.decimals()), "g", 8)


def spin_box(largest: float, digits: int, step: float, suffix: str) -> QDoubleSpinBox:
    """A number from -`largest` to it, taken when it is complete."""
    spin = QDoubleSpinBox()
    spin.setRange(-largest, largest)
    spin.setDecimals(digits)
    spin.setSingleStep(step)
    spin.setSuffix(suffix)
    spin.setKeyboardTracking(False)
    indent(spin)
    return spin


class ThreeNumbers(QWidget):
    """Three numbers side by side, each below its name."""

    changed = Signal()

    def __init__(
        self,
        title: str,
        names: Iterable[str],
        within: Range,
        digits: int,
        step: float,
        suffix: str = "",
    ) -> None:
        super().__init__()
        self.boxes: list[NumberBox] = []
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(2)
        for column, name in enumerate(names):
            caption = QLabel(name)
            caption.setStyleSheet(f"color: {theme.DIM};")
            box = NumberBox(f"{title}, {name}", within, digits, step, suffix)
            box.valueChanged.connect(lambda _value: self.changed.emit())
            grid.addWidget(caption, 0, column)
            grid.addWidget(box, 1, column)
            self.boxes.append(box)
        grid.setColumnStretch(len(self.boxes), 1)

    def set_numbers(self, values: Iterable[float]) -> None:
        for box, value in zip(self.boxes, values, strict=True):
            box.set_number(value)

    def numbers(self) -> tuple[float, float, float]:
        """Return them."""
        x, y, z = (box.number() for box in self.boxes)
        return x, y, z
