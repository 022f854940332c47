"""How a log is read: what each column holds, units, signs, and what comes of it."""

from collections.abc import Callable, Mapping
from html import escape
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QCoreApplication, Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.import_columns import (
    Choice,
    ColumnMap,
    Number,
    answer_fields,
    choices_of,
    in_words,
    named,
    words_of,
)
from app.widgets import theme
from app.widgets.buttons import Button, text_button
from app.widgets.files import file_dialog, settings_filter
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import (
    STRETCH,
    captioned,
    column_of,
    fill_page,
    paragraph,
    row_of,
    scrolling,
)
from app.widgets.texts import capitalised, local, time_text
from hapticplayer.capture.choices import (
    LogQuestion,
)
from hapticplayer.capture.log_tables import (
    BETWEEN_TABLES,
    NUMBER,
    TIME,
    KeptAnswers,
    LogTable,
    header_of,
    keep_answers,
    kept_answers,
    kept_for,
)
from hapticplayer.capture.source import LogPath, name_of
from hapticplayer.errors import HapticPlayerError, Progress, message_of
from hapticplayer.model.limits import REST_MPS2
from hapticplayer.sequence.import_preview import (
    ReadingCheck,
    check_reading,
    tables_of,
)

translate = QCoreApplication.translate

WIDTH_PX, HEIGHT_PX = 1080, 684
_CHECK_PX, _ROWS = 200, 7
_SOON_MS = 300
_MOST_NOTES = 6
_GOOD, _DOUBTFUL, _BAD = "\u25cf", "\u25b2", "\u25a0"


Kind = TypeVar("Kind")


class ReadingPage(JobDialog):
    """Answers about a log, and at once what they make of it.

    Signals:
        taken: the answers by key.
    """

    taken = Signal(dict)

    def __init__(
        self, log: LogPath, answers: Mapping[str, str], parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("How the log is read"))
        self._log, self._others = log, dict(answers)
        self._is_stale = False
        self.problem = paragraph("", theme.BAD)
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        self.problem.hide()
        none: tuple[LogTable, ...] = ()
        self.tables = self._try(lambda: tables_of(log, choices_of(answers)), none)
        kept = self._kept()
        self.columns = ColumnMap(self.tables)
        self.fields: dict[str, Choice | Number | ColumnMap] = {
            "columns": self.columns,
            **answer_fields(),
        }
        self.kept = Choice(self.tr("Filled in from"), {name: name for name in kept})
        self.kept.setItemText(0, self.tr("nothing"))
        self.name = QLineEdit()
        self.name.setAccessibleName(self.tr("Keep as"))
        self.name.setMaxLength(60)
        self.name.setPlaceholderText(self.tr("a name, to use this for the next log"))
        self.check = paragraph()
        self.check.setTextFormat(Qt.TextFormat.RichText)
        self.check.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._soon = QTimer(self, singleShot=True, interval=_SOON_MS)
        self._soon.timeout.connect(self._look)
        self._lay_out()
        self._fill(kept)
        for field in self.fields.values():
            field.changed.connect(self._on_changed)
        self.kept.changed.connect(self._on_kept)
        self.begin()
        self._on_changed()

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        self.columns.setVisible(bool(self.tables))
        forms = QHBoxLayout()
        forms.setSpacing(18)
        fields = [field for key, field in self.fields.items() if key != "columns"]
        for begin in range(0, len(fields), _ROWS):
            form = QFormLayout()
            form.setVerticalSpacing(4)
            form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
            for field in fields[begin : begin + _ROWS]:
                form.addRow(*captioned(field.accessibleName(), field))
            forms.addLayout(form, 1)
        file = text_button(
            self.tr("From a &file\u2026"), self.tr("Load the answers from a template")
        )
        file.clicked.connect(self._choose_template)
        self._proposals = QVBoxLayout()
        self._beside = beside = QWidget()
        beside.setMinimumWidth(_CHECK_PX)
        column_of(self.check, self._proposals, STRETCH, of=beside)
        cancel = text_button(
            self.tr("Cancel"), self.tr("Keep what was answered before")
        )
        cancel.clicked.connect(self.reject)
        self.take = text_button(
            self.tr("&Use this"), self.tr("Read the log with these answers"), "primary"
        )
        self.take.clicked.connect(self._on_take)
        from_kept = row_of(
            *captioned(self.tr("F&illed in from"), self.kept), file, STRETCH
        )
        keep = captioned(self.tr("&Keep as"), self.name)
        fill_page(
            self,
            paragraph(self._intro(), theme.DIM),
            from_kept,
            (self.columns, 12),
            (row_of((scrolling(forms), 3), (beside, 1), spacing=18), 3),
            self.problem,
            row_of(*keep, cancel, self.take, spacing=8),
            spacing=10,
        )

    def _intro(self) -> str:
        name = name_of(self._log)
        if self.tables:
            text = self.tr(
                "Say what each column of {name} holds and in which units. The check shows "
                "at once whether gravity agrees."
            )
        else:
            text = self.tr(
                "{name} describes itself. Say here what it has wrong; the check shows at "
                "once whether gravity agrees."
            )
        return text.format(name=name)

    def _fill(self, kept: Mapping[str, KeptAnswers]) -> None:
        """Begin with what was answered, else with what is kept or what the header says."""
        proposed = BETWEEN_TABLES.join(",".join(one.proposed) for one in self.tables)
        answers = {"columns": proposed.strip(BETWEEN_TABLES), **self._others}
        known = kept_for(header_of(self.tables), kept)
        if known and "columns" not in self._others:
            self.kept.put(known)
            self.name.setText(known)
            answers = {**kept[known].answers, **self._others}
        self._put(answers)

    def _kept(self) -> dict[str, KeptAnswers]:
        none: dict[str, KeptAnswers] = {}
        return self._try(kept_answers, none)

    def _try(self, work: Callable[[], Kind], otherwise: Kind) -> Kind:
        try:
            return work()
        except HapticPlayerError as problem:
            self._tell(translated(message_of(problem)))
            return otherwise

    def _tell(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.setVisible(bool(text))

    def _put(self, answers: Mapping[str, str]) -> None:
        for key, field in self.fields.items():
            field.put(answers.get(key, ""))

    # --- what is said --------------------------------------------------------

    def answers(self) -> dict[str, str]:
        """What a person says, by key; the format is chosen elsewhere."""
        form = self._others.get("format", "")
        said = {"format": form} if form else {}
        given = ((key, field.value()) for key, field in self.fields.items())
        return said | {
            key: value for key, value in given if value and self.fields[key].isEnabled()
        }

    def _on_changed(self) -> None:
        self._show_needed()
        self.take.setEnabled(False)
        self._soon.start()

    def _show_needed(self) -> None:
        """Ask only for what the columns leave open."""
        if not self.columns.value():
            return
        times, fields = self.columns.kinds_of(TIME), self.columns.kinds_of("mx")
        self.fields["time-unit"].setEnabled(NUMBER in times)
        self.fields["rate-hz"].setEnabled("" in times)
        self.fields["field-unit"].setEnabled(fields != {""})

    def _on_kept(self) -> None:
        name = self.kept.value()
        if one := self._kept().get(name):
            self._put(one.answers)
            self.name.setText(name)

    def _choose_template(self) -> None:
        title = self.tr("Choose a template")
        place = str(Path(str(self._log)).parent) if isinstance(self._log, Path) else ""
        dialog = file_dialog(self, title, place, settings_filter())
        dialog.fileSelected.connect(self.load)
        dialog.open()

    def load(self, path: str) -> None:
        """Fill in the answers of a template."""
        self._tell("")
        self._put(
            self._try(lambda: choices_of({"template": path}).given(), self.answers())
        )

    def _on_take(self) -> None:
        answers, name = self.answers(), self.name.text().strip()

        def keep() -> bool:
            if name:
                keep_answers(name, header_of(self.tables), answers)
            return True

        self._tell("")
        if not self._try(keep, False):
            return
        self.accept()
        self.taken.emit(answers)

    # --- what comes of it ----------------------------------------------------

    def _look(self) -> None:
        """Read the log as it is answered now."""
        if self.is_leaving:
            return
        if self.jobs.is_busy:
            self._is_stale = True
            self.jobs.cancel()
            return
        self._show_proposals(())
        try:
            log, choices = self._log, choices_of(self.answers())
        except HapticPlayerError as problem:
            self.on_failed(problem)
            return

        def work(progress: Progress) -> ReadingCheck:
            return in_child(check_reading, log, choices, progress=progress)

        self._show_lines([(theme.DIM, "", self.tr("Checking\u2026"))])
        self.jobs.run("", work, self.on_checked)

    def poll(self) -> None:
        """Show what has been found; look again if it is old."""
        self.jobs.poll()
        if self._is_stale and not self.jobs.is_busy:
            self._is_stale = False
            self._look()

    @property
    def is_unsettled(self) -> bool:
        """Whether the check is of answers that are not the ones now."""
        return self._soon.isActive() or self._is_stale or self.jobs.is_busy

    def proposals(self) -> list[Button]:
        """What can be filled in at once, as a question has proposed it."""
        return self._beside.findChildren(Button)

    def on_checked(self, found: ReadingCheck) -> None:
        """Show what gravity says of the log, and what was noticed."""
        if self._is_stale:
            return
        read = self.tr("Read: {rate} Hz, {duration}").format(
            rate=local(f"{found.rate_hz:.4g}"), duration=time_text(found.duration_s)
        )
        lines = [(theme.GOOD, _GOOD, read), self._of_rest(found), self._of_turns(found)]
        notes = [
            (theme.DIM, "", translated(note)) for note in found.notes[:_MOST_NOTES]
        ]
        self._show_lines([*lines, *notes])
        self.take.setEnabled(not self._soon.isActive())

    def _of_rest(self, found: ReadingCheck) -> tuple[str, str, str]:
        norm = found.at_rest_mps2
        if norm is None:
            text = self.tr("Never at rest: not compared with gravity (9.81 m/s\u00b2)")
            return theme.WARN, _DOUBTFUL, local(text)
        text = self.tr("At rest {norm} m/s\u00b2; gravity is {gravity} m/s\u00b2")
        text = text.format(norm=local(f"{norm:.2f}"), gravity=local("9.81"))
        is_right = REST_MPS2[0] <= norm <= REST_MPS2[1]
        mark = (theme.GOOD, _GOOD) if is_right else (theme.WARN, _DOUBTFUL)
        return *mark, text

    def _of_turns(self, found: ReadingCheck) -> tuple[str, str, str]:
        if found.agrees is None:
            text = self.tr("Gravity hardly turns: the gyroscope cannot be compared")
            return theme.WARN, _DOUBTFUL, text
        if found.agrees:
            return (
                theme.GOOD,
                _GOOD,
                self.tr("The gyroscope agrees with turning gravity"),
            )
        text = self.tr("The gyroscope does not agree with turning gravity")
        return theme.WARN, _DOUBTFUL, text

    def on_failed(self, problem: BaseException) -> None:
        """Say why the log cannot be read so, and what would change that."""
        if self._is_stale:
            return
        if not isinstance(problem, HapticPlayerError):
            raise problem
        if not isinstance(problem, LogQuestion):
            self._show_lines([(theme.BAD, _BAD, translated(message_of(problem)))])
            return
        lines = [(theme.BAD, _BAD, capitalised(translated(problem.what)))]
        if missing := self._missing(problem):
            text = self.tr("Choose: {fields}").format(fields=", ".join(missing))
            lines.append((theme.DIM, "", text))
        self._show_lines(lines)
        self._show_proposals(problem.answers)

    def _missing(self, question: LogQuestion) -> list[str]:
        """The fields that a question asks for without proposing one answer."""
        asked = [
            word.partition("=") for one in question.answers for word in one.split()
        ]
        keys = [key for key, _, values in asked if key in self.fields and "|" in values]
        return [self.fields[key].accessibleName() for key in keys]

    def _show_lines(self, lines: list[tuple[str, str, str]]) -> None:
        shown = [
            f"<p style='margin:0 0 6px 0'><span style='color:{colour}'>{sign} "
            f"{'' if sign else escape(text)}</span>{escape(text) if sign else ''}</p>"
            for colour, sign, text in lines
        ]
        self.check.setText("".join(shown))
        self.check.setAccessibleName("\n".join(text for _, _, text in lines))

    def _show_proposals(self, answers: tuple[str, ...]) -> None:
        """Offer the answers that the fields can take."""
        while (item := self._proposals.takeAt(0)) is not None:
            if widget := item.widget():
                widget.setParent(None)
                widget.deleteLater()
        for answer in answers:
            words = words_of(answer)
            is_fitting = self.columns.fits(words.get("columns", ""))
            if is_fitting and any(key in self.fields for key in words):
                button = text_button(named(words), in_words(answer))
                button.clicked.connect(lambda _on=False, w=words: self._propose(w))
                self._proposals.addWidget(button)

    def _propose(self, words: Mapping[str, str]) -> None:
        for key, value in words.items():
            if key in self.fields:
                self.fields[key].put(value)
