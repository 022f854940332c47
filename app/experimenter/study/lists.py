"""A list of entries of a study, and the fields of the one that is selected."""

from abc import abstractmethod
from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSplitter,
    QWidget,
)

from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.fields import Fields
from app.experimenter.study.words import label_words
from app.widgets.buttons import Button, text_button
from app.widgets.layout import STRETCH, column_of, row_of

translate = QCoreApplication.translate
_PLACE = int(Qt.ItemDataRole.UserRole)
_LEFT_PX, _RIGHT_PX = 330, 620


class Row(NamedTuple):
    """What the list shows; a heading has no place."""

    text: str
    place: Place = ()
    icon: QIcon | None = None
    may_go: bool = True


class EntryList(QWidget):
    """Lists entries, adds, removes and moves them; pages say what they are."""

    def __init__(self, document: StudyDocument, name: str, add: Button | None) -> None:
        super().__init__()
        self.document, self.add_button = document, add
        self.selected: Place = ()
        self._shown: list[Row] = []
        self.list = QListWidget()
        self.list.setAccessibleName(name)
        self.list.setSpacing(2)
        off = Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        self.list.setHorizontalScrollBarPolicy(off)  # long texts are elided
        self.list.currentItemChanged.connect(lambda *_: self._on_chosen())
        self.fields = Fields(document)
        self.remove_button = text_button(
            translate("EntryList", "Remove"), translate("EntryList", "Remove (Delete)")
        )
        self.up_button = text_button("\u25b2", translate("EntryList", "Move up"))
        self.down_button = text_button("\u25bc", translate("EntryList", "Move down"))
        for button, tip in ((self.up_button, "up"), (self.down_button, "down")):
            button.setAccessibleName(button.toolTip() or tip)
        self.remove_button.clicked.connect(self.remove)
        self.up_button.clicked.connect(lambda: self.move_by(-1))
        self.down_button.clicked.connect(lambda: self.move_by(1))
        self._lay_out()

    def _lay_out(self) -> None:
        left, split = QWidget(), QSplitter()
        moves = (self.remove_button, STRETCH, self.up_button, self.down_button)
        column_of(
            (self.list, 1),
            *((self.add_button,) if self.add_button else ()),
            *((row_of(*moves, spacing=6),) if self.add_button else ()),
            of=left,
            spacing=8,
        )
        self.right = QSplitter(Qt.Orientation.Vertical)
        self.right.setChildrenCollapsible(False)
        self.right.addWidget(self.fields)
        split.addWidget(left)
        split.addWidget(self.right)
        split.setSizes([_LEFT_PX, _RIGHT_PX])
        split.setChildrenCollapsible(False)
        column_of((split, 1), margins=(12, 12, 12, 12), of=self)

    # --- what a page says --------------------------------------------------------

    @abstractmethod
    def rows(self) -> list[Row]:
        """All entries, with headings between."""

    def shape(self, place: Place) -> object:
        """All that the fields of an entry depend on."""
        return place, tuple(self.document.languages)

    def siblings(self, place: Place) -> list[Place]:
        """The entries among which one may be moved, in their order."""
        return [one.place for one in self._shown if one.place[:-1] == place[:-1]]

    @abstractmethod
    def fill(self, place: Place) -> None:
        """Make the fields of an entry."""

    def label_row(self, at: Place, least: int, most: int) -> None:
        """Add the label of a point: text in each language, and its point."""
        label = label_words(self.document.at((*at, "at")) or 0)
        text = translate("QuestionList", "Point")
        point = self.fields.lone_number(text, (*at, "at"), least, most)
        removal = translate("QuestionList", "Remove this label")
        row = self.text_row(at, label, point, removal=removal)
        self.fields.row(label, row)
        told = self.fields.rows.labelForField(row)
        assert isinstance(told, QLabel)

        def show() -> None:
            told.setText(label_words(self.document.at((*at, "at")) or 0))
            for language in self.document.languages:
                line = self.fields.by_place[(*at, "text", language)]
                assert isinstance(line, QLineEdit)
                name = self.fields.in_language(told.text(), language)
                line.setAccessibleName(name)
                line.setPlaceholderText(name)

        self.fields.bind(at, row, show)

    def text_row(
        self,
        at: Place,
        label: str,
        *after: QWidget,
        removal: str,
        may_go: bool = True,
    ) -> QWidget:
        """A text in each language, another field, and a button that removes them."""
        lines = []
        for language in self.document.languages:
            own = self.fields.in_language(label, language)
            line = self.fields.lone_line(own, (*at, "text", language))
            line.setPlaceholderText(own)
            lines.append((line, 2))
        remove = text_button("\u2715", removal)
        remove.setAccessibleName(removal)
        remove.setEnabled(may_go)
        text = translate("QuestionList", "removal")
        remove.clicked.connect(lambda: self.document.remove(at, text))
        row = QWidget()
        row_of(*lines, *after, remove, spacing=6, of=row)
        return row

    def no_text(self) -> dict[str, str]:
        """A text that is to be written, in each language."""
        return dict.fromkeys(self.document.languages, "")

    # --- what a person does ------------------------------------------------------

    def remove(self) -> None:
        """Remove the selected entry."""
        if self.selected and self.remove_button.isEnabled():
            place = self.selected
            self.document.remove(place, translate("EntryList", "removal"))

    def move_by(self, by: int) -> None:
        """Move the selected entry in its list."""
        same = self.siblings(self.selected)
        to = same.index(self.selected) + by if self.selected in same else -1
        if 0 <= to < len(same):
            text = translate("EntryList", "another order")
            self.selected = self.document.move(self.selected, same[to], text)
            self.refresh()

    def select(self, place: Place) -> None:
        """Select the entry of a place, or what it is in."""
        rows = [row for row in self._shown if row.place]
        for length in range(len(place), 0, -1):
            for row in rows:
                if row.place == place[:length]:
                    self.selected = row.place
                    self.refresh()
                    return

    # --- what is shown -----------------------------------------------------------

    def refresh(self) -> None:
        """Show what the document has."""
        rows = self.rows()
        places = [row.place for row in rows if row.place]
        if self.selected not in places:
            self.selected = self._near(places)
        if rows != self._shown:
            self._shown = rows
            self._fill_list(rows)
        row = next((n for n, r in enumerate(rows) if r.place == self.selected), -1)
        if places and row >= 0:
            self.list.blockSignals(True)
            self.list.setCurrentRow(row)
            self.list.blockSignals(False)
        self._show_fields()

    def _near(self, places: list[Place]) -> Place:
        """The next entry after one has gone, or the last."""
        same = [p for p in places if p[:-1] == self.selected[:-1]]
        return (same or places or [()])[-1 if same else 0]

    def _fill_list(self, rows: list[Row]) -> None:
        self.list.blockSignals(True)
        self.list.clear()
        for row in rows:
            item = QListWidgetItem(row.text)
            item.setData(_PLACE, row.place)
            item.setToolTip(row.text.strip())
            if row.icon is not None:
                item.setIcon(row.icon)
            if not row.place:
                item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)
        self.list.blockSignals(False)

    def _show_fields(self) -> None:
        place, rows = self.selected, self._shown
        row = next((one for one in rows if one.place == place), None)
        same = self.siblings(place)
        may_go = bool(place) and row is not None and row.may_go
        self.remove_button.setEnabled(may_go)
        self.up_button.setEnabled(may_go and same[:1] != [place])
        self.down_button.setEnabled(may_go and same[-1:] != [place])
        make: Callable[[], None] = (lambda: self.fill(place)) if place else _nothing
        self.fields.show_shape(self.shape(place), make)

    def _on_chosen(self) -> None:
        item = self.list.currentItem()
        place = tuple(item.data(_PLACE)) if item is not None else ()  # type: ignore[redundant-expr]
        if place and place != self.selected:
            self.selected = place
            self.refresh()


def _nothing() -> None:
    """Show no fields."""


def free_key(word: str, taken: list[str]) -> str:
    """A key that no other entry has."""
    numbered = (f"{word}-{n}" for n in range(len(taken) + 1, 10_000))
    return next(one for one in numbered if one not in taken)
