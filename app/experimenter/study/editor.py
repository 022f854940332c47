"""The editor of a study: all of its definition, kept as it is changed."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QColor, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QDialog,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QTabWidget,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.study.conditions import ConditionList
from app.experimenter.study.document import (
    Place,
    StudyDocument,
    filled,
    place_of,
)
from app.experimenter.study.general import GeneralFields
from app.experimenter.study.lists import EntryList
from app.experimenter.study.order_page import OrderPage
from app.experimenter.study.page_texts import TextList
from app.experimenter.study.questions import QuestionList
from app.experimenter.study.ratings import RatingList
from app.experimenter.study.sequences import SequenceList
from app.experimenter.study.words import place_words
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import (
    column_of,
    fill_page,
    resize_within_screen,
    row_of,
)
from app.widgets.messages import MessageBar
from app.widgets.texts import titled
from hapticplayer.errors import InputError, Message, message_of
from hapticplayer.structures import convert
from hapticplayer.study.definition import Definition
from hapticplayer.study.drafts import DefinitionProblem, Draft, clip_seconds

WIDTH_PX, HEIGHT_PX = 1180, 720
KEEP_MS = 250  # after the last key
_PLACE = int(Qt.ItemDataRole.UserRole)
_MOST_PROBLEM_ROWS, _FRAME_PX, _SMALL_PX = 4, 14, 560
_REMEDIES_FOR_FILES = ("correct it", "")


class StudyEditor(QDialog):
    """Edits the definition of a study; sessions keep the one they began with.

    Every change is kept at once: in `study.json` where the study is whole, else in a
    draft beside it.
    """

    def __init__(
        self,
        folder: Path,
        library: Callable[[], Path],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.draft = Draft(folder)
        self.document = StudyDocument(self.draft.content)
        self.problems: list[DefinitionProblem] = []
        self._is_kept, self._is_warned = True, False
        name = self.draft.study.folder.name
        self.setWindowTitle(self.tr("Study \u2013 {name}").format(name=name))
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.messages = MessageBar()
        self.general = GeneralFields(self.document)
        self.sequences = SequenceList(self.document, self.draft.study.folder, library)
        self.conditions = ConditionList(self.document, self.draft.study.folder)
        self.questions = QuestionList(self.document, self.draft.study.folder)
        self.ratings = RatingList(self.document)
        self.texts = TextList(self.document, self.draft.study.folder)
        self.order = OrderPage(self.document, lambda: self.draft.study, self.keep)
        self.pages: list[
            tuple[str, GeneralFields | EntryList | OrderPage, tuple[str, ...]]
        ] = [
            (self.tr("General"), self.general, ("",)),
            (self.tr("Sequences"), self.sequences, ("sequences",)),
            (
                self.tr("Conditions"),
                self.conditions,
                ("feedbacks", "levels", "repeats"),
            ),
            (self.tr("Questions"), self.questions, ("pages",)),
            (self.tr("During clips"), self.ratings, ("while_watching",)),
            (self.tr("Texts"), self.texts, ("texts", "words")),
            (self.tr("Order"), self.order, ("order",)),
        ]
        self.tabs = QTabWidget()
        for text, page, _ in self.pages:
            self.tabs.addTab(page, text)
        self.tabs.currentChanged.connect(lambda _row: self._refresh())
        self.problem_list = QListWidget()
        self.problem_list.setAccessibleName(self.tr("Problems"))
        self.problem_list.itemActivated.connect(self._lead)
        self.problem_list.itemClicked.connect(self._lead)
        self.summary, self.state = QLabel(), QLabel()
        self.state.setStyleSheet(f"color: {theme.DIM};")
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(KEEP_MS)
        self._timer.timeout.connect(self.keep)
        self.document.changed.connect(self._on_changed)
        self._refresh()
        self.keep()
        if self.draft.is_restored:
            self._say_restored()

    def _lay_out(self) -> None:
        stack = self.document.stack
        self.undo_button = text_button(self.tr("Undo"), self.tr("Undo (Ctrl+Z)"))
        self.redo_button = text_button(self.tr("Redo"), self.tr("Redo (Ctrl+Shift+Z)"))
        self.close_button = text_button(self.tr("&Close"), "", "primary")
        for key, button, slot in (
            (QKeySequence.StandardKey.Undo, self.undo_button, stack.undo),
            (QKeySequence.StandardKey.Redo, self.redo_button, stack.redo),
        ):
            QShortcut(QKeySequence(key), self, slot)
            button.clicked.connect(slot)
        stack.canUndoChanged.connect(self.undo_button.setEnabled)
        stack.canRedoChanged.connect(self.redo_button.setEnabled)
        self.undo_button.setEnabled(False)
        self.redo_button.setEnabled(False)
        self.close_button.clicked.connect(self.reject)
        below = row_of(
            *(self.undo_button, self.redo_button, 12),
            (column_of(self.summary, self.state, spacing=2), 1),
            self.close_button,
            spacing=8,
        )
        fill_page(
            self, self.messages, (self.tabs, 1), self.problem_list, below, spacing=8
        )

    # --- keeping -----------------------------------------------------------------

    def _on_changed(self) -> None:
        self._is_kept = self._is_warned = False
        self._refresh()
        self.state.setText(self.tr("Saving\u2026"))
        self._timer.start()

    def keep(self) -> None:
        """Write what there is, and show what is wrong with it."""
        self._timer.stop()
        try:
            self.problems = self.draft.keep(self.document.value)
        except InputError as problem:
            self.messages.show_text(message_of(problem))
            self.state.setText(self.tr("Not saved"))
            return
        self._is_kept = True
        self._show_problems()
        self._show_summary()
        if any(one.is_fatal for one in self.problems):
            text = self.tr("Saved as a draft until the problems are solved")
        elif self.problems:
            text = self.tr("Saved; not ready for participants yet")
        else:
            text = self.tr("Saved")
        self.state.setText(text)

    def _say_restored(self) -> None:
        text = self.tr(
            "Changes that were not complete were restored. Undo goes back to the last "
            "complete study."
        )
        kept = self.document.value
        self.document.begin(self.draft.complete())
        self.document.change(kept, self.tr("restored changes"))
        self.keep()
        self.messages.show_text(text, lambda: self.document.value != kept)

    def done(self, result: int) -> None:
        """Close; what was typed last is kept, and what cannot be is not lost at once."""
        if not self._is_kept:
            self.keep()
        if not self._is_kept and not self._is_warned:
            self._is_warned = True
            self.state.setText(self.tr("Not saved: close again to lose the changes"))
            return
        self.close_jobs()
        super().done(result)

    def close_jobs(self) -> None:
        """Stop what runs and wait for it."""
        self.conditions.preview.close_jobs()
        self.order.close_jobs()

    def closeEvent(self, event: QCloseEvent) -> None:
        self.done(0)
        event.setAccepted(not self.isVisible())

    # --- what is shown -----------------------------------------------------------

    def _refresh(self) -> None:
        page = self.pages[self.tabs.currentIndex()][1]
        page.refresh()

    def _show_problems(self) -> None:
        self.problem_list.clear()
        for one in self.problems:
            item = QListWidgetItem(self._problem_text(one))
            item.setData(_PLACE, place_of(one.field))
            item.setForeground(QColor(theme.BAD if one.is_fatal else theme.WARN))
            self.problem_list.addItem(item)
        self.problem_list.setVisible(bool(self.problems))
        most = _MOST_PROBLEM_ROWS if self.height() > _SMALL_PX else 2
        rows = min(most, len(self.problems))
        height_px = self.problem_list.sizeHintForRow(0) if rows else 0
        self.problem_list.setFixedHeight(rows * height_px + _FRAME_PX)

    def _problem_text(self, one: DefinitionProblem) -> str:
        place = place_of(one.field)
        what = one.what
        if place and one.remedy not in _REMEDIES_FOR_FILES:
            what = Message("{what}; {remedy}", what=what, remedy=one.remedy)
        return titled(place_words(self.document.value, place), translated(what))

    def _show_summary(self) -> None:
        try:
            made = convert(filled(self.document.value), Definition, "")
        except InputError:
            return  # what was counted last stays
        clips_s = clip_seconds(self.document.value, self.draft.study.folder)
        text = self.tr("{trials} trials for each participant, about {minutes} minutes")
        trials, minutes = len(made.conditions), made.expected_min(clips_s)
        self.summary.setText(text.format(trials=trials, minutes=minutes))

    def _lead(self, item: QListWidgetItem) -> None:
        self.lead_to(tuple(item.data(_PLACE)))

    def lead_to(self, place: Place) -> None:
        """Show the field of a place."""
        first = str(place[0]) if place else ""
        for row, (_, page, rooms) in enumerate(self.pages):
            if first in rooms:
                self.tabs.setCurrentIndex(row)
                if isinstance(page, EntryList):
                    page.select(place)
                    page.fields.focus(place)
                else:
                    page.focus(place)
                return
        self.tabs.setCurrentIndex(0)
        self.general.focus(place)
