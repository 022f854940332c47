"""Fields that show entries of a study's definition, and change them."""

from collections.abc import Callable, Iterable
from typing import Any

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QFrame,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QSpinBox,
    QWidget,
)

from app.bridge.languages import NAMES
from app.experimenter.study.document import Place, StudyDocument
from app.widgets import theme
from app.widgets.layout import STRETCH, indent, keep_width, read_in_order, row_of
from hapticplayer.model.ranges import Range

translate = QCoreApplication.translate
_STEP = 0.1
_LINES = 3  # of a text that has several


class Fields(QScrollArea):
    """A form whose fields are entries of a document, made again where its shape is another.

    The keys that undo and redo go to the document.
    """

    def __init__(self, document: StudyDocument) -> None:
        super().__init__()
        self.document = document
        self.by_place: dict[Place, QWidget] = {}
        self._show: list[Callable[[], None]] = []
        self._shape: object = None
        self._left: list[QWidget] = []
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def show_shape(self, shape: object, fill: Callable[[], None]) -> None:
        """Show what the document has; `fill` makes the rows where the shape is new."""
        if shape != self._shape:
            self._shape = shape
            self._make_again(fill)
            read_in_order(self.window())
        for show in list(self._show):
            show()

    def _make_again(self, fill: Callable[[], None]) -> None:
        """One of the fields that go may be what has called: it is freed later."""
        held = next((p for p, w in self.by_place.items() if w.hasFocus()), None)
        if (old := self.takeWidget()) is not None:
            old.hide()
            old.deleteLater()
            self._left = [old]
        self.by_place, self._show = {}, []
        body = QWidget()
        self.rows = QFormLayout(body)
        self.rows.setContentsMargins(4, 4, 12, 4)
        self.rows.setVerticalSpacing(10)
        growth = QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow
        self.rows.setFieldGrowthPolicy(growth)
        self.rows.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        fill()
        self.setWidget(body)
        keep_width(self)
        if held in self.by_place:
            self.by_place[held].setFocus()

    def focus(self, place: Place) -> bool:
        """Go to the field of a place, or of what it is in or has in it."""
        for length in range(len(place), 0, -1):
            part = place[:length]
            near = [p for p in self.by_place if p[:length] == part]
            if (near and length > 1) or part in self.by_place:
                widget = self.by_place[part if part in self.by_place else near[0]]
                self.ensureWidgetVisible(widget)
                widget.setFocus(Qt.FocusReason.OtherFocusReason)
                return True
        return False

    # --- rows ------------------------------------------------------------------

    def row(self, label: str, widget: QWidget) -> None:
        """Add a row that shows no entry."""
        self.rows.addRow(label, widget)

    def whole(self, widget: QWidget) -> None:
        """Add a row without a label."""
        self.rows.addRow(widget)

    def heading(self, text: str) -> None:
        """Begin a part of the form."""
        label = QLabel(text)
        label.setFont(theme.scaled(self.font(), 1.0, bold=True))
        self.rows.addRow(label)

    def bind(self, place: Place, widget: QWidget, show: Callable[[], None]) -> None:
        """Have `show` called whenever the document has changed."""
        self.by_place[place] = widget
        self._show.append(show)

    def line(
        self, label: str, place: Place, *, tip: str = "", is_optional: bool = False
    ) -> QLineEdit:
        """Add a line of text."""
        line = self.lone_line(label, place, is_optional=is_optional)
        line.setToolTip(tip)
        self.rows.addRow(label, line)
        return line

    def lone_line(
        self, label: str, place: Place, *, is_optional: bool = False
    ) -> QLineEdit:
        """Return a line of text without a row; where it is optional, "" is no entry."""
        line = QLineEdit()

        def typed(text: str) -> None:
            self._set(place, None if is_optional and not text else text, label)

        def show() -> None:
            value = str(self.document.at(place) or "")
            if line.text() != value:
                line.setText(value)
                line.setCursorPosition(0)

        line.textEdited.connect(typed)
        self._bind(label, place, line, show)
        return line

    def listed(
        self,
        label: str,
        place: Place,
        *,
        tip: str = "",
        is_optional: bool = False,
        is_one: bool = False,
    ) -> QLineEdit:
        """Add a line of words and numbers, separated by commas; or of one of them."""
        line = self.lone_listed(label, place, is_optional=is_optional, is_one=is_one)
        line.setToolTip(tip)
        self.rows.addRow(label, line)
        return line

    def lone_listed(
        self, label: str, place: Place, *, is_optional: bool, is_one: bool
    ) -> QLineEdit:
        """Return such a line without a row; where it is optional, "" is no entry."""
        line = QLineEdit()

        def typed(text: str) -> None:
            value: Any = [
                _word_or_number(one) for one in text.split(",") if one.strip()
            ]
            if is_one:
                value = value[0] if value else ""
            nothing = is_optional and value in ([], "")
            self._set(place, None if nothing else value, label)

        def show() -> None:
            value = self.document.at(place)
            held = (
                [] if value is None else value if isinstance(value, list) else [value]
            )
            shown = [
                _word_or_number(one) for one in line.text().split(",") if one.strip()
            ]
            if shown != held:
                line.setText(", ".join(map(_plain, held)))
                line.setCursorPosition(0)

        line.textEdited.connect(typed)
        self._bind(label, place, line, show)
        return line

    def pairs(self, label: str, place: Place, tip: str) -> None:
        """Add a line of names with values, such as `viewpoint=first`."""
        line = QLineEdit()
        line.setToolTip(tip)

        def show() -> None:
            held = self.document.at(place) or {}
            if _pairs_in(line.text()) != held:
                line.setText(", ".join(f"{name}={one}" for name, one in held.items()))
                line.setCursorPosition(0)

        line.textEdited.connect(
            lambda text: self._set(place, _pairs_in(text) or None, label)
        )
        self._add(label, place, line, show)

    def area(
        self,
        label: str,
        place: Place,
        lines: int = _LINES,
        *,
        is_optional: bool = False,
    ) -> QPlainTextEdit:
        """Add a text of several lines; where it is optional, "" is no entry."""
        area = QPlainTextEdit()
        area.setTabChangesFocus(True)
        area.setFixedHeight(round((lines + 1.2) * area.fontMetrics().lineSpacing()))

        def show() -> None:
            value = str(self.document.at(place) or "")
            if _text_of(area) != value:
                area.setPlainText(value)

        def typed() -> None:
            if _text_of(area) != str(self.document.at(place) or ""):
                text = _text_of(area)
                self._set(place, text or (None if is_optional else ""), label)

        area.textChanged.connect(typed)
        self._add(label, place, area, show)
        return area

    def check(self, text: str, place: Place, *, usually: bool = False) -> QCheckBox:
        """Add a box to tick."""
        box = QCheckBox(text)
        box.clicked.connect(lambda is_on: self._set(place, is_on, text))

        def show() -> None:
            value = self.document.at(place)
            box.setChecked(usually if value is None else bool(value))

        self._add("", place, box, show, name=text)
        return box

    def number(
        self,
        label: str,
        place: Place,
        least: int,
        most: int,
        take: Callable[[int], None] | None = None,
        usually: int | None = None,
    ) -> QSpinBox:
        """Add a whole number; `take` does more than to change the entry."""
        box = self.lone_number(label, place, least, most, take, usually)
        self.rows.addRow(label, box)
        return box

    def lone_number(
        self,
        label: str,
        place: Place,
        least: int,
        most: int,
        take: Callable[[int], None] | None = None,
        usually: int | None = None,
    ) -> QSpinBox:
        """Return a whole number without a row; `usually` where there is no entry."""
        box = QSpinBox()
        box.setRange(least, most)
        indent(box)

        def show() -> None:
            value = self.document.at(place)
            box.blockSignals(True)
            other = least if usually is None else usually
            box.setValue(other if value is None else min(most, int(value)))
            box.blockSignals(False)

        box.valueChanged.connect(take or (lambda value: self._set(place, value, label)))
        self._bind(label, place, box, show)
        return box

    def ticks(
        self,
        label: str,
        place: Place,
        choices: Iterable[tuple[str, str]],
        usually: Iterable[str] = (),
    ) -> QWidget:
        """Add a list of which at least one entry is ticked."""
        boxes = {value: QCheckBox(text) for text, value in choices}

        def take() -> None:
            chosen = [value for value, box in boxes.items() if box.isChecked()]
            self._set(place, chosen, label)

        def show() -> None:
            held = list(self.document.at(place) or usually)
            for value, box in boxes.items():
                box.setChecked(value in held)
                box.setEnabled(held != [value])

        row = QWidget()
        row_of(*boxes.values(), STRETCH, spacing=16, of=row)
        for box in boxes.values():
            box.clicked.connect(take)
        self._add(label, place, row, show)
        return row

    def decimal(
        self, label: str, place: Place, limits: Range, *, usually: float = 0.0
    ) -> QDoubleSpinBox:
        """Add a number with a unit."""
        box = QDoubleSpinBox()
        box.setDecimals(3)
        box.setRange(limits.least, limits.largest)
        box.setSingleStep(_STEP)
        box.setSuffix(f" {limits.unit}" if limits.unit else "")
        indent(box)

        def show() -> None:
            box.blockSignals(True)
            value = self.document.at(place)
            box.setValue(usually if value is None else float(value))
            box.blockSignals(False)

        box.valueChanged.connect(lambda value: self._set(place, round(value, 3), label))
        self._add(label, place, box, show)
        return box

    def choice(
        self,
        label: str,
        place: Place,
        choices: Iterable[tuple[str, Any]],
        chosen: Callable[[Any], None] | None = None,
    ) -> QComboBox:
        """Add a list; `chosen` does more than to change the entry."""
        box = QComboBox()
        for text, value in choices:
            box.addItem(text, value)
        take = chosen or (lambda value: self._set(place, value, label))
        box.activated.connect(lambda row: take(box.itemData(row)))

        def show() -> None:
            box.setCurrentIndex(box.findData(self.document.at(place)))

        self._add(label, place, box, show)
        return box

    def texts(
        self, label: str, place: Place, *, lines: int = 1, is_optional: bool = False
    ) -> None:
        """Add a text in each language of the study."""
        for language in self.document.languages:
            own, entry = self.in_language(label, language), (*place, language)
            if lines == 1:
                self.line(own, entry, is_optional=is_optional)
            else:
                self.area(own, entry, lines, is_optional=is_optional)

    def in_language(self, label: str, language: str) -> str:
        """A label, with the language where there are several."""
        if len(self.document.languages) == 1:
            return label
        pattern = translate("StudyFields", "{text} ({language})")
        return pattern.format(text=label, language=NAMES.get(language, language))

    def _add(
        self,
        label: str,
        place: Place,
        widget: QWidget,
        show: Callable[[], None],
        name: str = "",
    ) -> None:
        self._bind(name or label, place, widget, show)
        self.rows.addRow(label, widget)

    def _bind(
        self, name: str, place: Place, widget: QWidget, show: Callable[[], None]
    ) -> None:
        widget.setAccessibleName(name)
        widget.installEventFilter(self)
        self.bind(place, widget, show)

    def _set(self, place: Place, value: Any, label: str) -> None:
        pattern = translate("StudyFields", "change of {what}")
        self.document.set(place, value, pattern.format(what=label))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Leave undo and redo to the window: there is one history."""
        if isinstance(event, QKeyEvent) and (
            event.matches(QKeySequence.StandardKey.Undo)
            or event.matches(QKeySequence.StandardKey.Redo)
        ):
            event.ignore()
            return True
        return super().eventFilter(watched, event)


def _pairs_in(text: str) -> dict[str, str]:
    parts = (one.partition("=") for one in text.split(",") if one.strip())
    return {name.strip(): value.strip() for name, _, value in parts}


def _word_or_number(text: str) -> str | int | float:
    word = text.strip()
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            continue
    return word


def _plain(value: object) -> str:
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def _text_of(area: QPlainTextEdit) -> str:
    """The text with its spaces that do not break, which `toPlainText` loses."""
    return area.document().toRawText().replace("\u2029", "\n").replace("\u2028", "\n")
