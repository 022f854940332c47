"""What is known of one sequence, and its force tracks."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QFileDialog,
    QTableWidgetItem,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.quality_view import QualityView
from app.player.choices import feedbacks, preset_name
from app.player.question import choose
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    ask_text,
    column_of,
    paragraph,
    row_of,
)
from app.widgets.tables import plain_table
from app.widgets.texts import local, quoted
from hapticplayer.errors import HapticPlayerError, Message, Progress, message_of
from hapticplayer.model import Feedback
from hapticplayer.sequence.editing import remove_track, rename_track
from hapticplayer.sequence.force_files import (
    ASK,
    ForceFormat,
    ForceQuestion,
    ReadChoices,
    WriteChoices,
)
from hapticplayer.sequence.force_formats import (
    loss_line,
    read_formats,
    written_formats,
)
from hapticplayer.sequence.force_import import export_force, import_force
from hapticplayer.sequence.library import Entry

translate = QCoreApplication.translate

_OWN = [feedback.value for feedback in Feedback]
Run = Callable[[str, Callable[[Progress], Any], Callable[[Any], None]], None]


class LibraryDetails(QWidget):
    """Shows an entry of the library and changes its tracks.

    `run` begins a piece of work: title, work, what is done with the result.
    """

    changed = Signal()
    rendering_wanted = Signal(object)

    def __init__(self, run: Run) -> None:
        super().__init__()
        self._run = run
        self._entry: Entry | None = None
        self.report = QualityView()
        self.tracks = plain_table(
            self.tr("Force tracks"),
            [
                self.tr("Force track"),
                self.tr("Peak"),
                self.tr("RMS"),
                self.tr("Workspace"),
            ],
            stretched=3,
            is_chosen_from=True,
        )
        self.tracks.itemSelectionChanged.connect(self._show_buttons)
        self.rendered = ElidedLabel(colour=theme.DIM)
        self.notes = paragraph("", theme.DIM)
        self.problem = paragraph("", theme.BAD)
        self.notes.hide()
        self.problem.hide()
        self._lay_out()

    def _lay_out(self) -> None:
        self.add = text_button(
            self.tr("&Add a track\u2026"), self.tr("Add a force track from a file")
        )
        self.rename = text_button(self.tr("Rena&me\u2026"), self.tr("Rename the track"))
        self.remove = text_button(self.tr("&Remove"), self.tr("Remove the track"))
        self.export = text_button(
            self.tr("E&xport\u2026"), self.tr("Save the track for other software")
        )
        self.add.clicked.connect(self._choose_force)
        self.export.clicked.connect(self._choose_target)
        self.rename.clicked.connect(self._ask_name)
        self.remove.clicked.connect(lambda: self._edit(remove_track, self._track()))
        self.rendering = text_button(
            self.tr("Ren&dering\u2026"),
            self.tr("Render the force in another way, after a look at what changes"),
        )
        self.rendering.clicked.connect(self._open_rendering)
        self._changing = (self.tracks, self.add, self.rendering)
        column_of(
            (self.report, 3),
            (self.tracks, 2),
            row_of(self.add, self.export, self.rename, self.remove, STRETCH),
            row_of(self.rendering, (self.rendered, 1)),
            *(self.notes, self.problem),
            margins=(8, 0, 0, 0),
            of=self,
        )
        self._show_buttons()

    # --- what is shown -------------------------------------------------------

    def show_entry(self, entry: Entry | None) -> None:
        """Show another entry, or none."""
        is_same = entry == self._entry
        self._entry = entry
        for widget in self._changing:
            widget.setEnabled(entry is not None and not entry.problem)
        if is_same:
            return
        self._show_problem("")
        self._show_notes([])
        if entry is None:
            self.report.clear()
        elif entry.problem:
            self.report.show_problem(entry.problem)
        else:
            self.report.show_findings(entry.findings)
        tracks = entry.tracks if entry else ()
        self.tracks.setRowCount(len(tracks))
        names = feedbacks(track.name for track in tracks)
        for row, (track, choice) in enumerate(zip(tracks, names, strict=True)):
            reach = "\u2013" if track.reach is None else f"{100.0 * track.reach:.0f} %"
            cells = (
                choice.text,
                local(f"{track.peak_n:.2f} N"),
                local(f"{track.rms_n:.2f} N"),
                reach,
            )
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setData(int(Qt.ItemDataRole.UserRole), track.name)
                self.tracks.setItem(row, column, item)
        self.rendered.set_text(rendering_text(entry) if entry else "")
        self._show_buttons()

    def _show_buttons(self) -> None:
        is_added = self._track() not in ("", *_OWN)
        self.rename.setEnabled(is_added)
        self.remove.setEnabled(is_added)
        self.export.setEnabled(self._track() not in ("", Feedback.NONE.value))

    def _track(self) -> str:
        items = self.tracks.selectedItems()
        return str(items[0].data(int(Qt.ItemDataRole.UserRole))) if items else ""

    # --- the rendering -------------------------------------------------------

    def _open_rendering(self) -> None:
        if self._entry is not None:
            self.rendering_wanted.emit(self._entry)

    # --- tracks --------------------------------------------------------------

    def _choose_force(self) -> None:
        entry = self._entry
        if entry is None:
            return
        title = self.tr("Choose a force track")
        dialog = file_dialog(self, title, str(entry.folder.parent), read_filter())
        dialog.fileSelected.connect(lambda path: self.add_force(Path(path)))
        dialog.open()

    def add_force(self, path: Path, other_is: str = ASK) -> None:
        """Add a force track that is named after its file, and ask what it does not say."""
        entry = self._entry
        if entry is None:
            return
        folder, name = entry.folder, path.name.split(".")[0][:40]

        def work(progress: Progress) -> tuple[Message, ...] | ForceQuestion:
            choices = ReadChoices(other_is=other_is)
            try:
                return in_child(
                    import_force, folder, name, path, choices=choices, progress=progress
                )
            except ForceQuestion as question:
                return question

        title = self.tr("Adding {name}").format(name=path.name)
        self._run(title, work, lambda found: self._on_added(path, found))

    def _on_added(self, path: Path, found: tuple[Message, ...] | ForceQuestion) -> None:
        if isinstance(found, ForceQuestion):
            self._ask_other(path, found)
            return
        self.changed.emit()
        self._show_notes([translated(note) for note in found])

    def _ask_other(self, path: Path, question: ForceQuestion) -> None:
        """Let a person say what a file has as `Other`."""
        text = self.tr(
            "{name} does not say what its haptics are (modality Other, as the published "
            "encoder writes it for sound and AHAP). What are they?"
        )
        answers = {self.tr("&Force"): "force", self.tr("&Vibration"): "vibration"}
        if question.has_more:
            answers[self.tr("&Leave them out")] = ""
        choose(
            self,
            self.tr("Choose a force track"),
            text.format(name=quoted(path.name)),
            {
                text: partial(self.add_force, path, meant)
                for text, meant in answers.items()
            },
        )

    def _choose_target(self) -> None:
        entry, name = self._entry, self._track()
        if entry is None or not name:
            return
        dialog = file_dialog(
            self, self.tr("Export the track"), str(entry.folder.parent), ""
        )
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setFileMode(QFileDialog.FileMode.AnyFile)
        dialog.setNameFilters(list(write_filters()))
        dialog.selectFile(f"{entry.folder.name}-{name}")
        dialog.fileSelected.connect(
            lambda path: self.export_force(
                Path(path), write_filters()[dialog.selectedNameFilter()]
            )
        )
        dialog.open()

    def export_force(self, path: Path, form: ForceFormat) -> None:
        """Save the selected track as a file of a format."""
        entry, name = self._entry, self._track()
        if entry is None or not name:
            return
        folder = entry.folder
        target = path if path.suffix else path.with_name(path.name + form.suffix)
        self._run(
            self.tr("Saving {name}").format(name=target.name),
            lambda progress: in_child(
                export_force,
                folder,
                name,
                target,
                form.name,
                choices=WriteChoices(overwrite=True),  # the dialog has asked
                progress=progress,
            ),
            lambda cost: self._show_notes(_exported(target, cost)),
        )

    def _ask_name(self) -> None:
        old = self._track()
        new = ask_text(self, self.tr("Rename the track"), self.tr("Name"), old)
        if new is not None:
            self._edit(rename_track, old, new.strip())

    def _edit(self, change: Callable[..., None], *names: str) -> None:
        entry = self._entry
        if entry is None:
            return
        try:
            change(entry.folder, *names)
        except HapticPlayerError as problem:
            self._show_problem(translated(message_of(problem)))
        else:
            self.changed.emit()

    def _show_notes(self, texts: list[str]) -> None:
        self.notes.setText("\n".join(texts))
        self.notes.setVisible(bool(texts))

    def _show_problem(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.setVisible(bool(text))


def _exported(target: Path, cost: dict[str, Any]) -> list[str]:
    """Where the file is, and what of the force it keeps."""
    saved = translate("LibraryDetails", "Saved: {name}").format(name=str(target))
    kept = translate("LibraryDetails", "It keeps {what}")
    return [saved, local(kept.format(what=translated(loss_line(cost))))]


def rendering_text(entry: Entry) -> str:
    """Return how the force of a sequence was rendered."""
    if entry.problem:
        return ""
    name, gain = preset_name(entry.preset), entry.gain_n_per_mps2
    if gain is None:
        text = translate("LibraryDetails", "{rendering}; one gain for each axis")
        return text.format(rendering=name)
    text = translate("LibraryDetails", "{rendering}; gain {gain} N per m/s\u00b2")
    return text.format(rendering=name, gain=local(f"{gain:.3g}"))


def read_filter() -> str:
    """Return the kinds of files that hold a force track."""
    patterns = {
        one.name: " ".join(f"*{end}" for end in (one.suffix, *one.other_suffixes))
        for one in read_formats().values()
    }
    kinds = [
        QCoreApplication.translate("ForceTexts", "Force tracks ({patterns})").format(
            patterns=" ".join(patterns.values())
        ),
        *(f"{_titled(one)} ({patterns[one.name]})" for one in read_formats().values()),
        QCoreApplication.translate("ForceTexts", "All files (*)"),
    ]
    return ";;".join(kinds)


def write_filters() -> dict[str, ForceFormat]:
    """Return the formats that are written, by their line in a file dialog."""
    return {
        f"{_titled(one)} (*{one.suffix})": one for one in written_formats().values()
    }


_WRITTEN = {"mpegv": "MPEG-V", "funscript": "Funscript"}
"""Names of formats that are no capital letters."""


def _titled(form: ForceFormat) -> str:
    """The name that people look for, then what it is; parentheses hold patterns here."""
    text = translated(form.text).replace("(", "").replace(")", "")
    return f"{_WRITTEN.get(form.name, form.name.upper())} \u2013 {text}"
