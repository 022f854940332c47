"""Questions for mouse, touch and keys: digits answer, Enter continues."""

from abc import abstractmethod
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QLabel,
    QPlainTextEdit,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.participant.fitted_page import paragraph
from app.widgets import theme
from app.widgets.buttons import Button
from app.widgets.layout import STRETCH, indent, row_of
from hapticplayer.study.definition import LIKERT, QuestionKind
from hapticplayer.study.pages import AskedQuestion

Word = Callable[[str], str]
TEXT_LINES = 2
_BESIDE_PX = 14  # between a scale and the labels at its ends


class QuestionRow(QFrame):
    """One question with its answer; `entered` means that the keyboard is here now."""

    answered = Signal()
    entered = Signal()

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__()
        self.asked = asked
        self.setProperty("role", "question")
        column = self.column = QVBoxLayout(self)
        column.setContentsMargins(12, 6, 12, 8)
        self.title = paragraph("")
        column.addWidget(self.title)
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
        """Emit `entered` when a field gets the focus; buttons do so themselves."""
        if event.type() == QEvent.Type.FocusIn:
            self.entered.emit()
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
    """An answer out of a few (value, text), with labels before and after them."""

    def __init__(
        self,
        asked: AskedQuestion,
        answers: list[tuple[Any, str]],
        ends: tuple[str, str] = ("", ""),
    ) -> None:
        super().__init__(asked)
        self._values = [value for value, _ in answers]
        self.group = QButtonGroup(self)
        for number, (_, text) in enumerate(answers):
            button = _AnswerButton(text, self.entered.emit)
            button.setCheckable(True)
            button.setAccessibleName(f"{asked.text} {text}")
            self.group.addButton(button, number)
        self.group.idClicked.connect(lambda _number: self._on_clicked())
        buttons = [(button, 1) for button in self.group.buttons()]
        first = (QLabel(ends[0]), _BESIDE_PX) if ends[0] else ()
        last = (_BESIDE_PX, QLabel(ends[1])) if ends[1] else ()
        self.column.addLayout(row_of(*first, *buttons, *last))

    def _on_clicked(self) -> None:
        self.show_missing("")
        self.answered.emit()

    def value(self) -> Any:
        number = self.group.checkedId()
        return None if number < 0 else self._values[number]

    def set_value(self, value: Any) -> None:
        if value in self._values:
            self.group.button(self._values.index(value)).setChecked(True)

    def take_digit(self, _digit: int) -> bool:
        """Press the button of this number."""
        if _digit > len(self._values):
            return False
        button = self.group.button(_digit - 1)
        button.setFocus(Qt.FocusReason.ShortcutFocusReason)
        button.click()
        return True

    def focus(self) -> None:
        """Put the keyboard on the chosen button, or the first."""
        self.group.button(max(0, self.group.checkedId())).setFocus(
            Qt.FocusReason.TabFocusReason
        )


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


class NumberRow(QuestionRow):
    """A whole number, typed or stepped to."""

    def __init__(self, asked: AskedQuestion) -> None:
        super().__init__(asked)
        self.box = QSpinBox()
        # one below the least means "not answered"
        self.box.setRange(asked.least - 1, asked.most)
        self.box.setSpecialValueText(" ")
        self.box.setValue(asked.least - 1)
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
        return value if value >= self.asked.least else None

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
        self.box = QPlainTextEdit()
        self.box.setTabChangesFocus(True)
        self.box.setAccessibleName(asked.text)
        self.box.textChanged.connect(self._on_changed)
        self.box.installEventFilter(self)
        self.column.addWidget(self.box)

    def _on_changed(self) -> None:
        """Keep what is too long from being typed: nothing is cut off later."""
        text = self.box.toPlainText()
        if len(text) > self.asked.most:
            self.box.setPlainText(text[: self.asked.most])
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


def make_row(asked: AskedQuestion, word: Word, scale: tuple[str, str]) -> QuestionRow:
    """Return the row for a question."""
    match asked.kind:
        case QuestionKind.LIKERT:
            return ButtonsRow(asked, [(n, str(n)) for n in LIKERT], scale)
        case QuestionKind.YES_NO:
            return ButtonsRow(asked, [(True, word("yes")), (False, word("no"))])
        case QuestionKind.CHOICE:
            return ButtonsRow(asked, list(asked.choices))
        case QuestionKind.NUMBER:
            return NumberRow(asked)
        case QuestionKind.TEXT:
            return TextRow(asked)


def digit_of(event: QKeyEvent) -> int:
    """Return which of the keys 1 to 9 was pressed; 0 for another."""
    digit = event.key() - Qt.Key.Key_0
    return digit if 1 <= digit <= 9 else 0


def is_typing(widget: QWidget | None) -> bool:
    """Whether digits belong into the widget that has the keyboard."""
    return isinstance(widget, QSpinBox | QPlainTextEdit)
