"""Questions for mouse, touch and keys: digits answer, Enter continues."""

import re
from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QFocusEvent, QFontMetrics, QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QGridLayout,
    QLabel,
    QLayout,
    QPlainTextEdit,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.participant.fitted_page import paragraph
from app.participant.visual_scale import VisualScale
from app.widgets import theme
from app.widgets.buttons import Button
from app.widgets.layout import STRETCH, indent, row_of
from hapticplayer.study.definition import QuestionKind
from hapticplayer.study.pages import AskedQuestion
from hapticplayer.study.questions import kind_of, range_of

TEXT_LINES = 2
_BESIDE_PX = 14  # between a scale and the labels at its ends
BEFORE, AFTER = "before", "after"  # names of these labels
_BESIDE_LETTERS = 16  # a longer label has its place below
_OF_PAIR = 3  # times as wide as a point
_IN_A_LINE = 11  # points
_ROW_LETTERS, _BUTTON_LETTERS = 60, 5  # of a row of answers; beside a button's text
_NUMBERED = re.compile(r"(\d+)\b")
_OFF, _ON = "\u2610 ", "\u2611 "


class QuestionRow(QFrame):
    """One question with its answer; `entered` means that the keyboard is here now.

    Attributes:
        goes_on: whether the next question comes after a digit.
    """

    answered = Signal()
    entered = Signal()
    goes_on = True

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__()
        self.asked = asked
        self.setProperty("role", "question")
        column = self.column = QVBoxLayout(self)
        column.setContentsMargins(12, 6, 12, 8)
        self.title = paragraph("")
        column.addWidget(self.title)
        if asked.help:
            line = paragraph(asked.help)
            line.setStyleSheet(f"color: {theme.DIM};")
            column.addWidget(line)
        self.show_missing("")

    @abstractmethod
    def value(self) -> Any:
        """Return the answer; None where there is none."""

    @abstractmethod
    def set_value(self, value: Any) -> None:
        """Answer as before."""

    def take_digit(self, _digit: int) -> bool:
        """Answer by a key; False where a digit means nothing here."""
        return False

    @abstractmethod
    def focus(self) -> None:
        """Take the keyboard."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Emit `entered` when a field gets the focus; buttons do so themselves.

        The wheel scrolls the page and changes no answer.
        """
        if event.type() == QEvent.Type.FocusIn:
            self.entered.emit()
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    def show_current(self, *, is_current: bool) -> None:
        """Show whether the digits go here."""
        role = "current" if is_current else "question"
        if self.property("role") != role:
            self.setProperty("role", role)
            self.style().unpolish(self)
            self.style().polish(self)

    def show_missing(self, text: str) -> None:
        """Say what is wrong with the answer behind the question: nothing moves."""
        asked = (self.asked.heading, self.asked.text, text)
        self.title.setText(" \u2013 ".join(filter(None, asked)))
        self.title.setStyleSheet(f"color: {theme.WARN};" if text else "")


class ButtonsRow(QuestionRow):
    """An answer out of a few."""

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        self._values = [value for value, _ in asked.options]
        self.group = QButtonGroup(self)
        for number, (value, text) in enumerate(asked.options):
            button = _AnswerButton(text, self.entered.emit)
            button.setCheckable(True)
            label = asked.labels.get(value, "")
            name = " ".join(filter(None, (asked.text, text, label)))
            button.setAccessibleName(name)
            self.group.addButton(button, number)
        self.group.idClicked.connect(self._on_clicked)
        self.column.addLayout(self._laid_out())

    def _laid_out(self) -> QLayout:
        """As many beside each other as there is room for."""
        texts = [button.text() for button in self.group.buttons()]
        letters = max(map(len, texts), default=0) + _BUTTON_LETTERS
        most = min(len(texts), max(1, _ROW_LETTERS // letters)) or 1
        rows = -(-len(texts) // most)
        columns = -(-len(texts) // rows)  # no row is much shorter than the others
        grid = QGridLayout()
        for number, button in enumerate(self.group.buttons()):
            grid.addWidget(button, number // columns, number % columns)
        return grid

    def _on_clicked(self, _number: int) -> None:
        self.show_missing("")
        self.answered.emit()

    def value(self) -> Any:
        number = self.group.checkedId()
        return None if number < 0 else self._values[number]

    def set_value(self, value: Any) -> None:
        if value in self._values:
            self.group.button(self._values.index(value)).setChecked(True)

    def _number_of(self, digit: int) -> int:
        """Which answer a digit means: its number if all begin with one, else its place."""
        numbers = [_NUMBERED.match(text) for _, text in self.asked.options]
        shown = [int(one[1]) for one in numbers if one]
        if len(shown) < len(numbers):
            return digit - 1
        return shown.index(digit) if digit in shown else -1

    def take_digit(self, digit: int) -> bool:
        """Press the button of this number."""
        number = self._number_of(digit)
        if not 0 <= number < len(self._values):
            return False
        button = self.group.button(number)
        button.setFocus(Qt.FocusReason.ShortcutFocusReason)
        button.click()
        return True

    def focus(self) -> None:
        """Put the keyboard on the chosen button, or the first."""
        self.group.button(max(0, self.group.checkedId())).setFocus(
            Qt.FocusReason.TabFocusReason
        )


class ScaleRow(ButtonsRow):
    """A scale of points; digits are its numbers, unless some are negative."""

    def _laid_out(self) -> QLayout:
        buttons: list[QWidget] = list(self.group.buttons())
        return labelled(buttons, self.asked.labels, self._values)

    def _number_of(self, digit: int) -> int:
        is_negative = self._values[0] < 0
        return digit - (1 if is_negative else int(self._values[0]))


class PairRow(ScaleRow):
    """Points between two opposites, which are the question."""

    def _laid_out(self) -> QLayout:
        self._grid, self._above = QGridLayout(), row_of(spacing=_BESIDE_PX)
        for number, button in enumerate(self.group.buttons()):
            self._grid.addWidget(button, 1, 1 + number)
            self._grid.setColumnStretch(1 + number, 1)
        self._grid.addLayout(self._above, 0, 1, 1, len(self._values))
        labels = self.asked.labels
        self._ends = [QLabel(labels.get(self._values[at], "")) for at in (0, -1)]
        for end in self._ends:
            end.setTextFormat(Qt.TextFormat.PlainText)
        self.put_beside(is_beside=True)
        return self._grid

    def fits_beside(self, width_px: int) -> bool:
        """Whether a page has room for the opposites beside the points."""
        wide_px = [one.minimumWidth() for one in self.group.buttons()]
        metrics = QFontMetrics(self._ends[0].font())
        ends_px = (metrics.horizontalAdvance(end.text()) for end in self._ends)
        wide_px += [end_px + _BESIDE_PX for end_px in ends_px]
        gaps_px = len(wide_px) * self._grid.horizontalSpacing()
        return (
            sum(wide_px) + gaps_px
            <= width_px - 2 * self.column.contentsMargins().left()
        )

    def put_beside(self, *, is_beside: bool) -> None:
        """Put the opposites beside the points, or above the first and the last."""
        align = Qt.AlignmentFlag
        for end, column in zip(self._ends, (0, 1 + len(self._values)), strict=True):
            is_left = bool(column) == is_beside
            high = align.AlignVCenter if is_beside else align.AlignBottom
            end.setAlignment((align.AlignLeft if is_left else align.AlignRight) | high)
            end.setWordWrap(not is_beside)
            end.setIndent(_BESIDE_PX * is_beside)  # on the side of the points
            if is_beside:
                self._grid.addWidget(end, 1, column)
            else:
                self._above.addWidget(end, 1)
            self._grid.setColumnStretch(column, _OF_PAIR * is_beside)
        self.column.activate()

    def show_missing(self, text: str) -> None:
        """Show the title where it says more than the opposites."""
        super().show_missing(text)
        ends = " \u2013 ".join(one for _, one in sorted(self.asked.labels.items()))
        self.title.setVisible(self.title.text() != ends)


class ChoicesRow(ButtonsRow):
    """Any number of a few answers; digits and the space bar turn each on and off."""

    goes_on = False

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        self.group.setExclusive(False)
        for button, (_, text) in zip(self.group.buttons(), asked.options, strict=True):
            button.setText(_OFF + text)
            button.toggled.connect(
                lambda is_on, button=button, text=text: button.setText(
                    (_ON if is_on else _OFF) + text
                )
            )

    def value(self) -> Any:
        buttons = zip(self._values, self.group.buttons(), strict=True)
        return [value for value, button in buttons if button.isChecked()]

    def set_value(self, value: Any) -> None:
        for one in value or []:
            super().set_value(one)


class _AnswerButton(Button):
    """Reports its focus; Enter belongs to the page, which continues."""

    def __init__(self, text: str, entered: Callable[[], None]) -> None:
        super().__init__(text)
        self._entered = entered

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._entered()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            event.ignore()
        else:
            super().keyPressEvent(event)


class VisualRow(QuestionRow):
    """A mark on a line."""

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        limits = range_of(asked.question) or (0, 0)
        # beside the line, or all below it
        below = {} if asked.labels.keys() <= set(limits) else asked.labels
        self.scale = VisualScale(limits, below)
        self.scale.setAccessibleName(asked.text)
        self.scale.marked.connect(self._on_marked)
        self.scale.installEventFilter(self)
        beside = {} if below else asked.labels
        self.column.addLayout(labelled([self.scale], beside, limits))

    def _on_marked(self) -> None:
        self.show_missing("")
        self.answered.emit()

    def value(self) -> int | None:
        return self.scale.value() if self.scale.is_marked else None

    def set_value(self, value: Any) -> None:
        if isinstance(value, int):
            self.scale.mark(value)

    def focus(self) -> None:
        self.scale.setFocus(Qt.FocusReason.TabFocusReason)


class NumberRow(QuestionRow):
    """A whole number, typed or stepped to."""

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        self._least, most = range_of(asked.question) or (0, 0)
        self.box = QSpinBox()
        # one below the least means "not answered"
        self.box.setRange(self._least - 1, most)
        self.box.setSpecialValueText(" ")
        self.box.setValue(self._least - 1)
        self.box.setAccessibleName(asked.text)
        self.box.valueChanged.connect(lambda _value: self.answered.emit())
        self.box.installEventFilter(self)
        indent(self.box)
        # the box's own are too small for a finger: the style gives them no room
        steps = []
        for sign, step in (("\u2212", self.box.stepDown), ("+", self.box.stepUp)):
            button = Button(sign)
            button.setAutoRepeat(True)
            button.setAccessibleName(f"{asked.text} {sign}")
            button.clicked.connect(step)
            steps.append(button)
        self.column.addLayout(row_of(self.box, *steps, STRETCH))

    def value(self) -> int | None:
        value = self.box.value()
        return value if value >= self._least else None

    def set_value(self, value: Any) -> None:
        if isinstance(value, int):
            self.box.setValue(value)

    def focus(self) -> None:
        """Let it be typed."""
        self.box.setFocus(Qt.FocusReason.TabFocusReason)
        self.box.selectAll()


class TextRow(QuestionRow):
    """An answer in words; Tab leaves it."""

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        self._most = kind_of(asked.question).most  # type: ignore[attr-defined]
        self.box = QPlainTextEdit()
        self.box.setTabChangesFocus(True)
        self.box.setAccessibleName(asked.text)
        self.box.textChanged.connect(self._on_changed)
        self.box.installEventFilter(self)
        self.column.addWidget(self.box)

    def _on_changed(self) -> None:
        """Keep what is too long from being typed: nothing is cut off later."""
        text = self.box.toPlainText()
        if len(text) > self._most:
            self.box.setPlainText(text[: self._most])
            cursor = self.box.textCursor()
            cursor.movePosition(cursor.MoveOperation.End)
            self.box.setTextCursor(cursor)
        self.answered.emit()

    def set_font_size(self, font_px: int) -> None:
        """Be some lines high."""
        self.box.setFixedHeight(round(1.5 * TEXT_LINES * font_px) + 12)

    def value(self) -> str:
        """Return the words."""
        return self.box.toPlainText()

    def set_value(self, value: Any) -> None:
        """Show words."""
        self.box.setPlainText(str(value or ""))

    def focus(self) -> None:
        """Let them be typed."""
        self.box.setFocus(Qt.FocusReason.TabFocusReason)


def labelled(
    parts: list[QWidget], labels: Mapping[int, str], points: Sequence[int]
) -> QLayout:
    """Parts side by side with the labels of points: at both ends, or below.

    Many parts have two lines, so that each is wide enough for a finger.

    Args:
        parts: one for each point, or one for all.
        labels: by point.
        points: from left to right.
    """
    first, last = labels.get(points[0], ""), labels.get(points[-1], "")
    across = -(-len(points) // (1 + (len(parts) > _IN_A_LINE)))
    is_of_ends = labels.keys() <= {points[0], points[-1]}
    is_short = max(len(first), len(last)) <= _BESIDE_LETTERS
    if is_short and is_of_ends and across == len(points):
        return _beside(parts, first, last)
    grid = QGridLayout()
    for number, part in enumerate(parts):
        columns = 1 if len(parts) > 1 else across
        grid.addWidget(part, 2 * (number // across), number % across, 1, columns)
    for column in range(across):
        grid.setColumnStretch(column, 1)
    align = Qt.AlignmentFlag
    for begin in range(0, len(points), across):
        row, of_row = 2 * (begin // across) + 1, points[begin : begin + across]
        of_ends = row_of(spacing=_BESIDE_PX)
        for column, at in enumerate(of_row):
            if at not in labels:
                continue
            line = paragraph(labels[at], centred=True)
            if is_of_ends:
                side = align.AlignRight if at == points[-1] else align.AlignLeft
                line.setAlignment(side | align.AlignTop)
                of_ends.addWidget(line, 1)
            else:
                grid.addWidget(line, row, column)
        grid.addLayout(of_ends, row, 0, 1, len(of_row))
    return grid


def _beside(parts: list[QWidget], first: str, last: str) -> QLayout:
    """Parts between the labels of their ends."""
    before, after = QLabel(first), QLabel(last)
    before.setObjectName(BEFORE)
    before.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    after.setObjectName(AFTER)
    of_first = (before, _BESIDE_PX) if first else ()
    of_last = (_BESIDE_PX, after) if last else ()
    return row_of(*of_first, *((part, 1) for part in parts), *of_last)


ROWS: dict[QuestionKind, type[QuestionRow]] = {
    QuestionKind.SCALE: ScaleRow,
    QuestionKind.VISUAL: VisualRow,
    QuestionKind.NUMBER: NumberRow,
    QuestionKind.YES_NO: ButtonsRow,
    QuestionKind.CHOICE: ButtonsRow,
    QuestionKind.CHOICES: ChoicesRow,
    QuestionKind.PAIR: PairRow,
    QuestionKind.TEXT: TextRow,
}
"""How each kind of question looks."""


def digit_of(event: QKeyEvent) -> int:
    """Return which of the keys 0 to 9 was pressed; -1 for another."""
    digit = event.key() - Qt.Key.Key_0
    return digit if 0 <= digit <= 9 else -1


def is_typing(widget: QWidget | None) -> bool:
    """Whether digits belong into the widget that has the keyboard."""
    return isinstance(widget, QSpinBox | QPlainTextEdit)
