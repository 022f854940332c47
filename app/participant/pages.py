"""The pages: a text with buttons, and questions."""

import math
from collections.abc import Callable, Mapping
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFontMetrics, QKeyEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from app.participant.fitted_page import FittedPage, paragraph
from app.participant.questions import (
    AFTER,
    BEFORE,
    ROWS,
    PairRow,
    QuestionRow,
    TextRow,
    digit_of,
    is_typing,
)
from app.widgets import theme
from app.widgets.buttons import Button, set_role
from app.widgets.layout import STRETCH, row_of
from hapticplayer.study.pages import Page, PageKind, PageMaker

Word = Callable[[str], str]
_APART_PX = 16
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class TextPage(FittedPage):
    """A text, and up to a few buttons (name, text) under it.

    The last one continues; it has the keyboard unless a person is to decide.
    """

    pressed = Signal(str)

    def __init__(
        self, page: Page, buttons: list[tuple[str, str]], *, decides: bool = False
    ) -> None:
        super().__init__()
        self._decides = decides
        self._waits_s, self._last_text = 0, buttons[-1][1] if buttons else ""
        self.column.addStretch(1)
        if page.position:
            where = f"{page.position} / {page.count}"
            self.column.addWidget(paragraph(where, centred=True))
        is_short = len(page.text) < 160
        self.text = paragraph(page.text, centred=is_short)
        self.column.addWidget(self.text)
        self.problem = paragraph("", centred=True)
        self.problem.setStyleSheet(f"color: {theme.WARN};")
        self.problem.hide()
        self.column.addWidget(self.problem)
        self.buttons: dict[str, Button] = {}
        for name, text in buttons:
            button = self.buttons[name] = Button(text)
            button.clicked.connect(lambda _on, name=name: self.pressed.emit(name))
        made = self.buttons.values()
        row = row_of(STRETCH, *made, STRETCH, margins=(0, _APART_PX, 0, 0))
        self.column.addLayout(row)
        self.column.addStretch(1)
        if buttons and not decides:
            set_role(self.buttons[buttons[-1][0]], "primary")

    def focus(self) -> None:
        if self._decides:
            self.setFocus(Qt.FocusReason.OtherFocusReason)
        elif self.buttons:
            list(self.buttons.values())[-1].setFocus(Qt.FocusReason.TabFocusReason)

    def wait(self, seconds: float) -> None:
        """Let the last button wait so long; it counts the seconds."""
        if not self.buttons:
            return
        button = list(self.buttons.values())[-1]
        left = math.ceil(seconds)
        if left == self._waits_s:
            return
        self._waits_s = left
        button.setEnabled(not left)
        button.setText(f"{self._last_text} ({left})" if left else self._last_text)
        if not left:
            self.focus()

    def show_problem(self, text: str) -> None:
        """Say why a button did nothing."""
        self.problem.setText(text)
        self.problem.show()
        self.fit()

    def values(self) -> dict[str, Any]:
        """Return no answers."""
        return {}


class QuestionsPage(FittedPage):
    """Questions one under the other.

    A clip that is to be played again is named by its token, see `Page.replays`; `draft`
    is what was typed before.
    """

    finished = Signal()
    replay_wanted = Signal(str)

    def __init__(
        self,
        page: Page,
        word: Word,
        draft: Mapping[str, Any],
    ) -> None:
        super().__init__()
        self._word = word
        self._current = 0
        if page.text:
            self.column.addWidget(paragraph(page.text))
        if page.replays:
            self.column.addWidget(self._replay_table(page))
        self.rows: list[QuestionRow] = []
        for asked in page.questions:
            row = ROWS[asked.kind](asked)
            if asked.name in draft:
                row.set_value(draft[asked.name])
            number = len(self.rows)
            row.entered.connect(lambda number=number: self._go_to(number))
            self.rows.append(row)
            self.column.addWidget(row)
        self.next = Button(word("next"))
        set_role(self.next, "primary")
        self.next.clicked.connect(self._on_next)
        self.column.addStretch(1)
        self._one_by_one = page.one_by_one
        self.back, self.place = Button("\u25c0"), QLabel()
        self.back.clicked.connect(lambda: self._step(-1))
        aside = (self.back, self.place) if page.one_by_one else ()
        self.column.addLayout(row_of(*aside, STRETCH, self.next))
        if page.one_by_one:
            self._go_to(0)

    def _replay_table(self, page: Page) -> QWidget:
        table = QWidget()
        grid = QGridLayout(table)
        grid.setContentsMargins(0, 0, 0, 0)
        for line, (heading, clips) in enumerate(page.replays):
            grid.addWidget(paragraph(heading), line, 0)
            for place, (text, token) in enumerate(clips, 1):
                button = Button(f"\u25b6 {text}")
                button.setAccessibleName(f"{heading}, {text}")
                button.clicked.connect(
                    lambda _on, token=token: self.replay_wanted.emit(token)
                )
                grid.addWidget(button, line, place)
        return table

    def set_font_size(self, font_px: int) -> None:
        """Use letters of this size."""
        super().set_font_size(font_px)
        for row in self.rows:
            if isinstance(row, TextRow):
                row.set_font_size(font_px)
        metrics = QFontMetrics(self.body.font())
        for name in (BEFORE, AFTER):  # scales of a page are equally long
            labels = self.body.findChildren(QLabel, name)
            texts = (label.text() for label in labels)
            wide_px = max(map(metrics.horizontalAdvance, texts), default=0)
            for label in labels:
                label.setFixedWidth(wide_px + 1)  # its own hint is that of old letters
        pairs = [row for row in self.rows if isinstance(row, PairRow)]
        margins = self.column.contentsMargins()
        room_px = self.width() - margins.left() - margins.right()
        is_beside = all(row.fits_beside(room_px) for row in pairs)
        for pair in pairs:  # all alike
            pair.put_beside(is_beside=is_beside)
        self.column.activate()

    def values(self) -> dict[str, Any]:
        """Return all answers, whatever they are."""
        return {row.asked.name: row.value() for row in self.rows}

    def focus(self) -> None:
        """Put the keyboard on the first question."""
        if self.rows:
            self._go_to(0)
            self.rows[0].focus()

    def show_problem(self, name: str, text: str) -> None:
        """Say at a question what is wrong with its answer."""
        for row in self.rows:
            is_it = row.asked.name == name
            row.show_missing(text if is_it else "")
            if is_it:
                self._go_to(self.rows.index(row))
                row.focus()
                self.fit()
                is_last = row is self.rows[-1]
                last = [self.next] if is_last else []
                self.keep_in_sight(*last, row, row.title)  # the row may be higher

    def keyPressEvent(self, event: QKeyEvent) -> None:
        digit = digit_of(event)
        if event.isAutoRepeat() and (digit >= 0 or event.key() in _ENTER):
            event.accept()  # a key that is held answers one question
        elif digit >= 0 and self.rows and not is_typing(self.focusWidget()):
            row = self.rows[self._current]
            if row.take_digit(digit) and row.goes_on:
                self._to_next()
        elif event.key() == Qt.Key.Key_Down:
            self._step(1)
        elif event.key() == Qt.Key.Key_Up:
            self._step(-1)
        elif event.key() in _ENTER:
            self._on_next()
        else:
            super().keyPressEvent(event)

    def _on_next(self) -> None:
        """Show the next question, or be done with the page."""
        row = self.rows[self._current] if self._one_by_one else None
        if row is None or row is self.rows[-1]:
            self.finished.emit()
        elif row.asked.question.required and row.value() in (None, "", []):
            row.show_missing(self._word("missing"))
        else:
            self._step(1)

    def _step(self, by: int) -> None:
        number = min(max(0, self._current + by), len(self.rows) - 1)
        self._go_to(number)
        self.rows[number].focus()

    def _to_next(self) -> None:
        if self._current + 1 < len(self.rows):
            self._step(1)
        else:
            self.next.setFocus(Qt.FocusReason.TabFocusReason)

    def _go_to(self, number: int) -> None:
        self._current = number
        for place, row in enumerate(self.rows):
            row.show_current(is_current=place == number)
        if self._one_by_one:
            self._show_alone(number)
        self.ensureWidgetVisible(self.rows[number])

    def _show_alone(self, number: int) -> None:
        shown = [row.isVisibleTo(self.body) for row in self.rows]
        for place, row in enumerate(self.rows):
            row.setVisible(place == number)
        count = f"{number + 1} / {len(self.rows)}"
        self.place.setText(count)
        self.back.setAccessibleName(f"{number} / {len(self.rows)}")
        self.back.setEnabled(number > 0)
        if shown != [row.isVisibleTo(self.body) for row in self.rows]:
            self.fit()


_BUTTONS: dict[PageKind, tuple[str, ...]] = {
    PageKind.CONSENT: ("decline", "agree"),
    PageKind.DEMONSTRATION: ("feel", "next"),
    PageKind.READY: ("start",),
    PageKind.PAUSED: ("leave", "resume"),
}


def make_page(
    page: Page, maker: PageMaker, draft: Mapping[str, Any], *, has_felt: bool
) -> TextPage | QuestionsPage:
    """Return the widget of a page, with what was answered on it before.

    Args:
        page: to be shown.
        maker: of the session's pages.
        draft: what was typed before.
        has_felt: whether the demonstration may be passed over by Enter.
    """
    if page.kind is PageKind.QUESTIONS:
        return QuestionsPage(page, maker.word, draft)
    names = _BUTTONS.get(page.kind, ())
    if page.kind is PageKind.DEMONSTRATION and not has_felt:
        names = names[::-1]  # nothing is skipped by Enter
    buttons = [(name, maker.word(name)) for name in names]
    return TextPage(page, buttons, decides=page.kind is PageKind.CONSENT)
