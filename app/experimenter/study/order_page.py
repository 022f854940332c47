"""How the orders of conditions are made, and the table of who gets which."""

from collections.abc import Callable, Mapping
from pathlib import Path

from PySide6.QtCore import QTimerEvent
from PySide6.QtWidgets import QHeaderView, QTableWidgetItem, QWidget

from app.bridge.jobs import Jobs, in_child
from app.bridge.languages import translated
from app.experimenter.study.document import Content, StudyDocument, filled
from app.experimenter.study.fields import Fields
from app.experimenter.study.words import condition_words, text_in
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.layout import column_of, paragraph
from app.widgets.tables import plain_table
from app.widgets.texts import local
from hapticplayer import storage
from hapticplayer.errors import HapticPlayerError, InputError, message_of
from hapticplayer.structures import convert
from hapticplayer.study.definition import Condition, Definition, OrderMethod, read_file
from hapticplayer.study.order_list import read_orders
from hapticplayer.study.order_preview import (
    EXAMPLE,
    NEXT,
    Given,
    OrderLine,
    given_orders,
    order_lines,
)
from hapticplayer.study.orders import ORDERS
from hapticplayer.study.study_folder import Study

_MOST_SEED = 2**31 - 1
_POLL_MS = 50


class OrderPage(QWidget):
    """The method, and who gets which order."""

    def __init__(
        self,
        document: StudyDocument,
        study: Callable[[], Study],
        keep: Callable[[], None],
    ) -> None:
        super().__init__()
        self.document, self._study, self._keep = document, study, keep
        self.fields = Fields(document)
        self.table = plain_table(self.tr("Orders"), ["", ""], 1)
        mode = QHeaderView.ResizeMode.ResizeToContents
        self.table.horizontalHeader().setSectionResizeMode(mode)
        self.note = paragraph("", theme.DIM)
        self._given: list[Given] | None = None
        self.jobs = Jobs(self._on_failed)
        self._lay_out()

    def _lay_out(self) -> None:
        parts = (self.fields, self.note, (self.table, 1))
        column_of(*parts, spacing=8, margins=(12, 12, 12, 12), of=self)

    def _fill(self) -> None:
        fields = self.fields
        fields.choice(
            self.tr("Order"),
            ("order", "method"),
            [(text, method.value) for method, text in self._methods().items()],
        )
        fields.check(
            self.tr("Never the same sequence twice in a row"),
            ("order", "no_sequence_twice_in_a_row"),
        )
        seed = fields.number(self.tr("Seed"), ("order", "seed"), 0, _MOST_SEED)
        seed.setToolTip(self.tr("The same seed gives the same orders"))
        self.take_file = text_button(
            self.tr("Take the orders of a file\u2026"),
            self.tr("A CSV file with order, position, sequence and feedback"),
        )
        self.take_file.clicked.connect(self._ask_file)
        fields.row("", self.take_file)

    def _methods(self) -> dict[OrderMethod, str]:
        return {
            OrderMethod.RANDOM: self.tr("Random for each participant"),
            OrderMethod.LATIN_SQUARE: self.tr("Latin square"),
            OrderMethod.WILLIAMS: self.tr("Williams: balanced for carry-over"),
            OrderMethod.LIST: self.tr("From a table of your own (orders.csv)"),
        }

    def focus(self, place: tuple[str | int, ...]) -> None:
        self.fields.focus(place)

    def refresh(self) -> None:
        """Show the orders of the definition as it is."""
        self.fields.show_shape("order", self._fill)
        if (form := self.fields.widget()) is not None:
            self.fields.setMaximumHeight(form.sizeHint().height() + 8)
        method = self.document.at(("order", "method"))
        self.take_file.setVisible(method == OrderMethod.LIST)
        if self._given is None and not self.jobs.is_busy:
            study = self._study()
            self.jobs.run(
                "",
                lambda progress: in_child(given_orders, study, progress=progress),
                self._take,
            )
            self.startTimer(_POLL_MS)
        self._show_lines()

    def timerEvent(self, event: QTimerEvent) -> None:
        self.jobs.poll()
        if not self.jobs.is_busy:
            self.killTimer(event.timerId())

    def _take(self, given: list[Given]) -> None:
        self._given = given
        self._show_lines()

    def _on_failed(self, _problem: BaseException) -> None:
        self._given = []

    def _show_lines(self) -> None:
        content, study = self.document.value, self._study()
        try:
            made = convert(filled(content), Definition, "")
            is_list = made.order.method is OrderMethod.LIST
            listed = read_orders(study.folder / ORDERS, made) if is_list else []
            lines = order_lines(made, self._given or [], listed)
        except HapticPlayerError:
            lines = []
        self._fill_table(lines, content)
        self.note.setText(self._note_text(bool(lines)))

    def _fill_table(self, lines: list[OrderLine], content: Content) -> None:
        count = max((len(line.order) for line in lines), default=0)
        headings = [self.tr("Order"), self.tr("Participants")]
        headings += [str(number) for number in range(1, count + 1)]
        self.table.setColumnCount(len(headings))
        self.table.setHorizontalHeaderLabels(headings)
        self.table.setRowCount(len(lines))
        titles = {
            one["key"]: text_in(one["title"], content["languages"])
            for one in content["sequences"]
        }
        feedbacks = {
            one if isinstance(one, str) else one.get("key") or one["condition"]: words
            for one in content["feedbacks"]
            if (words := condition_words(one))
        }
        names = {NEXT: self.tr("next participant"), EXAMPLE: self.tr("example")}
        for row, line in enumerate(lines):
            who = ", ".join(names.get(one, one) for one in line.who)
            cells = [str(line.number or ""), who]
            cells += [_trial_words(trial, titles, feedbacks) for trial in line.order]
            for column, text in enumerate(cells):
                self.table.setItem(row, column, QTableWidgetItem(text))

    def _note_text(self, has_lines: bool) -> str:
        if not has_lines:
            return self.tr("There is no order yet: see the problems below.")
        if self.document.at(("order", "method")) == OrderMethod.RANDOM:
            return self.tr(
                "Every participant gets an order of their own, drawn from the seed and "
                "the participant's code."
            )
        return self.tr(
            "Participants get the order that was used least; that of a session which "
            "ended early is given again."
        )

    def _ask_file(self) -> None:
        kinds = self.tr("Tables (*.csv)")
        title = self.tr("Orders")
        dialog = file_dialog(self, title, str(Path.home()), kinds)
        dialog.fileSelected.connect(lambda path: self.take(Path(path)))
        dialog.open()

    def take(self, path: Path) -> None:
        """Copy the orders of a file into the study."""
        try:
            storage.replace_file(self._study().folder / ORDERS, read_file(path))
        except InputError as problem:
            self.note.setText(translated(message_of(problem)))
        else:
            self._keep()
            self._show_lines()

    def close_jobs(self) -> None:
        """Stop what runs and wait for it."""
        self.jobs.close()


def _trial_words(
    trial: Condition, titles: Mapping[str, str], feedbacks: Mapping[str, str]
) -> str:
    parts = [titles.get(trial.sequence) or trial.sequence]
    parts.append(feedbacks.get(trial.feedback, trial.feedback))
    if (trial.delay_s, trial.gain) != (0.0, 1.0):
        parts.append(local(f"{1e3 * trial.delay_s:+.0f} ms \u00d7{trial.gain:g}"))
    return ", ".join(parts)
