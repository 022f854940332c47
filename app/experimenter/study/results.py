"""What came of a study: its sessions, texts to be read, and its data for other programs."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMessageBox,
    QTableWidgetItem,
    QTabWidget,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.start_panel import reason_text
from app.experimenter.study.merge_page import MergePage, device_name
from app.experimenter.study.place_dialogs import (
    PlaceDialog,
    export_dialog,
    pack_dialog,
)
from app.player.share_page import size_text
from app.widgets import theme
from app.widgets.buttons import Button, text_button
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import (
    STRETCH,
    ask_text,
    column_of,
    fill_page,
    paragraph,
    row_of,
)
from app.widgets.messages import JobRow, StatusLine
from app.widgets.tables import plain_table
from app.widgets.texts import date_text
from hapticplayer.clock import SystemClock
from hapticplayer.errors import HapticPlayerError, Progress, joined
from hapticplayer.study.definition import When
from hapticplayer.study.overview import (
    SessionSummary,
    StudyOverview,
    UnreviewedText,
    approve_texts,
    study_overview,
    traces_of,
)
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.sites import Manifest, pack_study, signature_of
from hapticplayer.study.steps import position_of
from hapticplayer.study.study_export import export_study
from hapticplayer.study.study_folder import (
    delete_participant,
    drop_session,
    open_study,
)

translate = QCoreApplication.translate
_SIZE_PX = (1040, 640)
_BELOW = ("pack", "merge", "export", "analyse")  # buttons


def deleted(folder: Path, code: str, *, progress: Progress) -> list[str]:
    """Delete a participant, and return the files that still name the code."""
    progress(0.0, "")
    return delete_participant(open_study(folder), code)


def exported(folder: Path, target: Path, form: str, *, progress: Progress) -> list[str]:
    """Export a study into a new folder, and return the notices."""
    report = export_study(open_study(folder), target, form, progress)
    return [*report["remarks"], *filter(None, [report["left_out"]])]


def packed(folder: Path, target: Path, *, progress: Progress) -> Manifest:
    """Write a copy of the study for other sites into a new folder."""
    return pack_study(open_study(folder), target, progress)


class StudyResults(JobDialog):
    """Lists the sessions of a study, and does with them what can be done.

    `analysis_wanted` means that the report is wanted.
    """

    analysis_wanted = Signal()

    def __init__(self, folder: Path, parent: QWidget | None = None) -> None:
        super().__init__(_SIZE_PX, parent)
        self.folder = folder
        self.overview: StudyOverview | None = None
        self._definition = open_study(folder).definition
        title = self._definition.title
        self.setWindowTitle(self.tr("Sessions \u2013 {title}").format(title=title))
        self.tabs, self.status = QTabWidget(), StatusLine()
        self.summary, self.details = paragraph(), paragraph()
        self.texts_state = paragraph("", theme.DIM)
        self.sessions = plain_table(
            self.tr("Sessions"),
            [
                *(self.tr("Code"), self.tr("Date"), self.tr("State")),
                *(self.tr("Answered"), self.tr("Invalid"), self.tr("Devices")),
            ],
            5,
            is_chosen_from=True,
        )
        self.texts = plain_table(
            self.tr("Text answers"),
            [self.tr("Code"), self.tr("Question"), self.tr("Answer")],
            2,
            is_chosen_from=True,
        )
        mode = QAbstractItemView.SelectionMode.ExtendedSelection
        self.texts.setSelectionMode(mode)
        self.texts.setWordWrap(True)
        header = self.texts.horizontalHeader()
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self.sessions.itemSelectionChanged.connect(self.show_buttons)
        self.texts.itemSelectionChanged.connect(self.show_buttons)
        self.progress = JobRow(text_button(self.tr("Stop"), self.tr("Cancel")))
        self.progress.stop.clicked.connect(self.jobs.cancel)
        self.buttons = self._make_buttons()
        self._lay_out()
        self.begin()
        self.refresh()

    # --- building ------------------------------------------------------------------

    def _make_buttons(self) -> dict[str, Button]:
        made: dict[str, tuple[str, str, Callable[[], None]]] = {
            "end": (
                self.tr("End\u2026"),
                self.tr(
                    "End a session that will not be resumed; its order is free again"
                ),
                self._end,
            ),
            "delete": (
                self.tr("Delete\u2026"),
                self.tr("Delete a participant; says first what is erased"),
                self._delete,
            ),
            "pack": (
                self.tr("Pack\u2026"),
                self.tr("Write a copy with all sequences, for other sites to run"),
                self._pack,
            ),
            "merge": (
                self.tr("Merge\u2026"),
                self.tr("Add the sessions of copies of this study on other machines"),
                self._merge,
            ),
            "export": (
                self.tr("Export\u2026"),
                self.tr("Write the data for other programs"),
                self._export,
            ),
            "analyse": (
                self.tr("Analyse"),
                self.tr("Statistics and report"),
                self.analysis_wanted.emit,
            ),
            "approve": (
                self.tr("Approve for export"),
                self.tr("The selected answers identify no one"),
                self._approve,
            ),
        }
        buttons = {
            name: text_button(text, tip) for name, (text, tip, _) in made.items()
        }
        for name, (_, _, slot) in made.items():
            buttons[name].clicked.connect(lambda _on, slot=slot: slot())
        return buttons

    def _lay_out(self) -> None:
        margins = (12, 12, 12, 12)
        sessions, texts = QWidget(), QWidget()
        column_of(
            self.summary,
            (self.sessions, 1),
            self.details,
            row_of(self.buttons["end"], self.buttons["delete"], STRETCH, spacing=8),
            margins=margins,
            of=sessions,
        )
        column_of(
            self.texts_state,
            (self.texts, 1),
            row_of(STRETCH, self.buttons["approve"]),
            margins=margins,
            of=texts,
        )
        self.tabs.addTab(sessions, self.tr("Sessions"))
        self.tabs.addTab(texts, self.tr("Text answers"))
        close = text_button(self.tr("&Close"), "", "primary")
        close.clicked.connect(self.reject)
        below = [self.buttons[name] for name in _BELOW]
        row = row_of(*below, STRETCH, close, spacing=8)
        fill_page(self, (self.tabs, 1), self.status, self.progress, row, spacing=8)

    # --- what is shown -------------------------------------------------------------

    def refresh(self) -> None:
        """Read the study again."""
        title, show = self.tr("Reading"), self.show_overview
        self._run(title, study_overview, show, self.folder, is_quiet=True)

    def show_overview(self, found: StudyOverview) -> None:
        """Show the state of the study."""
        held = self.chosen()
        for table in (self.sessions, self.texts):
            table.clearSelection()  # before the rows that are selected may be gone
        self.overview = found
        self._fill_sessions(found, held.code if held else "")
        self._fill_texts(found)
        count = len(found.unreviewed)
        title = self.tr("Text answers")
        self.tabs.setTabText(1, f"{title} ({count})" if count else title)
        self.summary.setText(self._summary_text(found))
        self.show_buttons()

    def _summary_text(self, found: StudyOverview) -> str:
        if not found.sessions:
            text = self.tr("Nobody has taken part yet: Study > Run a participant.")
        else:
            done = sum(s.state is SessionState.COMPLETE for s in found.sessions)
            text = self.tr("Sessions: {count}, complete: {done}, deleted: {deleted}")
            text = text.format(
                count=len(found.sessions), done=done, deleted=found.deleted
            )
        return "\n".join([text, *map(translated, found.notices)])

    def _fill_sessions(self, found: StudyOverview, held: str) -> None:
        self.sessions.setRowCount(len(found.sessions))
        for row, one in enumerate(found.sessions):
            cells = (
                *(one.code, date_text(one.created_utc), _state_text(one)),
                f"{one.answered} / {one.planned}",
                str(len(one.invalid) or ""),
                ", ".join(map(device_name, one.devices)) or "\u2013",
            )
            for column, text in enumerate(cells):
                self.sessions.setItem(row, column, QTableWidgetItem(text))
            if one.code == held:
                self.sessions.selectRow(row)

    def _details(self, one: SessionSummary) -> str:
        """What the list has no room for: invalid trials with the reasons, damage."""
        lines = [
            self.tr("Trial {n} ({condition}) is invalid: {reasons}").format(
                n=trial.position,
                condition=trial.condition,
                reasons=", ".join(reason_text(reason) for reason in trial.reasons),
            )
            for trial in one.invalid
        ]
        if one.resumed:
            lines.append(self.tr("Resumed: {n} times").format(n=one.resumed))
        if one.damaged:
            lines.append(self.tr("Damaged records: {n}").format(n=one.damaged))
        return "\n".join(lines)

    def _fill_texts(self, found: StudyOverview) -> None:
        self.texts.setRowCount(len(found.unreviewed))
        for row, one in enumerate(found.unreviewed):
            cells = one.code, self._question_text(one.question), one.text
            for column, text in enumerate(cells):
                self.texts.setItem(row, column, QTableWidgetItem(text))
        self.texts.resizeRowsToContents()
        self.texts_state.setText(self._texts_state(found))

    def _texts_state(self, found: StudyOverview) -> str:
        if found.unreviewed:
            return self.tr(
                "Answers in words may name a person. Read them; only those that you "
                "approve are exported."
            )
        if any(one.answered for one in found.sessions):
            return self.tr("All answers in words are approved.")
        return self.tr("No answers in words yet.")

    def _question_text(self, name: str) -> str:
        """The question's wording, and what an answer of this name is about."""
        key, _, of = name.partition("@")
        asked = (q for q in self._definition.questions_at(*When) if q.key == key)
        if (question := next(asked, None)) is None:
            return name  # of a session whose study was changed since
        text = self._definition.wording(question, self._definition.languages[0])
        if position := position_of(of):
            of = self.tr("trial {n}").format(n=position)
        return f"{text} ({of})" if of else text

    def chosen(self) -> SessionSummary | None:
        """The session that is selected."""
        row = self.sessions.currentRow()
        if self.overview is None or not self.sessions.selectedItems():
            return None
        return self.overview.sessions[row]

    def chosen_texts(self) -> list[UnreviewedText]:
        """The text answers that are selected."""
        if self.overview is None:
            return []
        rows = sorted({index.row() for index in self.texts.selectedIndexes()})
        return [self.overview.unreviewed[row] for row in rows]

    def show_buttons(self) -> None:
        one, is_free = self.chosen(), not self.jobs.is_busy
        is_open = one is not None and one.state is SessionState.UNFINISHED
        has_sessions = bool(self.overview and self.overview.sessions)
        self.buttons["end"].setEnabled(is_free and is_open)
        self.buttons["delete"].setEnabled(is_free and one is not None)
        self.buttons["approve"].setEnabled(is_free and bool(self.chosen_texts()))
        for name in ("pack", "merge"):
            self.buttons[name].setEnabled(is_free)
        for name in ("export", "analyse"):
            self.buttons[name].setEnabled(is_free and has_sessions)
        self.details.setText(self._details(one) if one else "")

    # --- what a person does --------------------------------------------------------

    def _end(self) -> None:
        one = self.chosen()
        reason = one and ask_text(
            self,
            self.tr("End the session"),
            self.tr("Reason for ending the session (all answers so far are kept):"),
        )
        if one and reason and reason.strip():
            self._try(
                lambda: drop_session(
                    open_study(self.folder), one.code, reason.strip(), SystemClock()
                )
            )

    def _delete(self) -> None:
        one = self.chosen()
        if one is not None and self.is_sure(one):
            self._run(
                *(
                    self.tr("Deleting"),
                    deleted,
                    self._say_deleted,
                    self.folder,
                    one.code,
                )
            )

    def is_sure(self, one: SessionSummary) -> bool:
        """Ask before a participant is deleted, and say what is erased."""
        files = traces_of(open_study(self.folder), one.code)
        text = self.tr(
            "Delete participant {code}? Answers to {answered} trials, the records of the "
            "device and the consent are erased ({count} files, {size}) and cannot be "
            "restored. That somebody was deleted stays, without the code. Exports and "
            "reports outside of the study are yours to delete."
        ).format(
            code=one.code,
            answered=one.answered,
            count=len(files),
            size=size_text(sum(path.stat().st_size for path in files)),
        )
        buttons = QMessageBox.StandardButton
        box = QMessageBox(
            QMessageBox.Icon.Warning,
            self.tr("Delete"),
            text,
            buttons.Yes | buttons.Cancel,
            self,
        )
        box.setDefaultButton(buttons.Cancel)
        return QMessageBox.StandardButton(box.exec()) is buttons.Yes

    def _say_deleted(self, left: list[str]) -> None:
        text = self.tr("The participant was deleted.")
        if left:
            more = self.tr("Still named in: {files}. Write these again or remove them.")
            text += " " + more.format(files=", ".join(left))
        self.status.show_text(text, theme.WARN if left else "")

    def _pack(self) -> None:
        self._ask_place(pack_dialog(self.folder, self), self.pack)

    def pack(self, _form: str, target: Path) -> None:
        """Write a copy for other sites into a new folder."""

        def done(made: Manifest) -> None:
            text = self.tr(
                "Packed to {folder}. Sites can compare the checksum of what they got "
                "(SHA-256 of the manifest): {checksum}"
            )
            self.status.show_text(
                text.format(folder=target, checksum=signature_of(made))
            )

        self._run(self.tr("Packing"), packed, done, self.folder, target)

    def _merge(self) -> None:
        page = MergePage(self.folder, self)
        page.finished.connect(self._on_merged)
        page.finished.connect(page.deleteLater)
        page.open()

    def _on_merged(self) -> None:
        if not self.is_leaving:
            self.refresh()

    def _export(self) -> None:
        self._ask_place(export_dialog(self.folder, self), self.export)

    def _ask_place(
        self, dialog: PlaceDialog, wanted: Callable[[str, Path], None]
    ) -> None:
        dialog.wanted.connect(wanted)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def export(self, form: str, target: Path) -> None:
        """Write the data into a new folder, in the format of this name."""

        def done(notices: list[str]) -> None:
            text = self.tr("Exported to {folder}.").format(folder=target)
            more = translated(joined("; ", notices)) if notices else ""
            self.status.show_text(f"{text}\n{more}" if more else text)

        title = self.tr("Exporting the data")
        self._run(title, exported, done, self.folder, target, form)

    def _approve(self) -> None:
        chosen = self.chosen_texts()

        def approve() -> None:
            study = open_study(self.folder)
            for one in chosen:
                approve_texts(study, one.code, one.question)

        self._try(approve)

    # --- work ----------------------------------------------------------------------

    def _try(self, action: Callable[[], None]) -> None:
        try:
            action()
        except HapticPlayerError as problem:
            self.status.show_problem(problem)
        else:
            self.status.show_text("")
            self.refresh()

    def _run(
        self,
        title: str,
        work: Callable[..., Any],
        done: Callable[[Any], None],
        *arguments: Any,
        is_quiet: bool = False,
    ) -> None:
        """Do a piece of work in a process of its own, then read the study again."""
        if self.jobs.is_busy:
            return
        if not is_quiet:
            self.status.show_text("")

        def finished(result: Any) -> None:
            done(result)
            if not is_quiet:
                self.refresh()

        self.jobs.run(
            title,
            lambda progress: in_child(work, *arguments, progress=progress),
            finished,
        )
        self.show_buttons()


def _state_text(one: SessionSummary) -> str:
    text = {
        SessionState.COMPLETE: translate("StudyResults", "complete"),
        SessionState.UNFINISHED: translate("StudyResults", "not finished"),
        SessionState.STOPPED: translate("StudyResults", "ended early"),
    }[one.state]
    simulated = translate("StudyResults", "simulated")
    return f"{text}, {simulated}" if one.simulated else text
