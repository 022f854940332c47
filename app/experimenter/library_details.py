"""What is known of one sequence, its force tracks, and its gain."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDoubleSpinBox,
    QFileDialog,
    QHeaderView,
    QLabel,
    QSlider,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.bridge.jobs import Job, Progress, in_child
from app.bridge.languages import translated
from app.experimenter.force_texts import cost_text, read_filter, write_filters
from app.experimenter.quality_view import QualityView
from app.player.choices import feedbacks
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.layout import (
    BESIDE,
    STRETCH,
    ask_text,
    column_of,
    indent,
    paragraph,
    row_of,
)
from app.widgets.texts import local
from hapticplayer.errors import HapticPlayerError, Message, message_of
from hapticplayer.interchange.force_files import ForceFormat, WriteChoices
from hapticplayer.interchange.force_import import export_force, import_force
from hapticplayer.model import Feedback
from hapticplayer.sequence.editing import (
    preview_gain,
    remove_track,
    rename_track,
    set_gain,
)
from hapticplayer.sequence.figures import ForceFigures
from hapticplayer.sequence.library import Entry

_LEAST_GAIN, _LARGEST_GAIN, _STEPS = 0.05, 1.0, 95
_OWN = [feedback.value for feedback in Feedback]
_SETTLE_POLLS = 8
_LEAST_SLIDER_PX = 80
_PREVIEW_LINES = 3

Run = Callable[[str, Callable[[Progress], Any], Callable[[Any], None]], None]


class LibraryDetails(QWidget):
    """Shows an entry of the library and changes its tracks.

    `run` begins a piece of work: title, work, what is done with the result.
    """

    changed = Signal()

    def __init__(self, run: Run) -> None:
        super().__init__()
        self._run = run
        self._entry: Entry | None = None
        self._preview: Job[ForceFigures] | None = None
        self._wait = 0
        self.report = QualityView()
        self.tracks = QTableWidget(0, 4)
        self.tracks.setAccessibleName(self.tr("Force tracks"))
        self.tracks.setHorizontalHeaderLabels(
            [
                self.tr("Force track"),
                self.tr("Peak"),
                self.tr("RMS"),
                self.tr("Workspace"),
            ]
        )
        self.tracks.verticalHeader().hide()
        self.tracks.setTabKeyNavigation(False)  # Tab moves on to the buttons
        self.tracks.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.tracks.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.tracks.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        header = self.tracks.horizontalHeader()
        header.setDefaultAlignment(BESIDE)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self.tracks.itemSelectionChanged.connect(self._show_buttons)
        self.gain = QSlider(Qt.Orientation.Horizontal)
        self.gain.setAccessibleName(self.tr("Gain"))
        self.gain.setRange(0, _STEPS)
        self.gain.setMinimumWidth(_LEAST_SLIDER_PX)
        self.number = QDoubleSpinBox()
        self.number.setAccessibleName(self.tr("Gain"))
        self.number.setRange(_LEAST_GAIN, _LARGEST_GAIN)
        self.number.setSingleStep(0.01)
        self.number.setSuffix(self.tr(" N per m/s\u00b2"))
        indent(self.number)
        # its room is kept, so that nothing jumps while the gain is moved
        self.preview = paragraph(lines=_PREVIEW_LINES)
        self.problem = paragraph("", theme.BAD)
        self.preview.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.problem.hide()
        self._lay_out()
        self.gain.valueChanged.connect(
            lambda step: self.number.setValue(_LEAST_GAIN + 0.01 * step)
        )
        self.number.valueChanged.connect(self._on_gain)

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
        self.apply = text_button(
            self.tr("Apply &gain"),
            self.tr("Render the realistic and the random track again with this gain"),
        )
        self.apply.clicked.connect(self._set_gain)
        caption = QLabel(self.tr("Gain"))
        self._changing = (self.tracks, self.add, caption, self.gain, self.number)
        column_of(
            (self.report, 3),
            (self.tracks, 2),
            row_of(self.add, self.export, self.rename, self.remove, STRETCH),
            row_of(caption, (self.gain, 1), self.number),
            row_of(STRETCH, self.apply),
            *(self.preview, self.problem),
            margins=(8, 0, 0, 0),
            of=self,
        )
        self._show_gain()
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
        self._show_gain()
        self._show_buttons()

    def _show_gain(self) -> None:
        gain = self._entry.gain_n_per_mps2 if self._entry else None
        self.number.blockSignals(True)
        self.number.setValue(gain or _LEAST_GAIN)
        self.number.blockSignals(False)
        self._move_slider()
        self._wait = 0
        self.preview.clear()
        self.apply.setEnabled(False)

    def _move_slider(self) -> None:
        self.gain.blockSignals(True)
        self.gain.setValue(round((self.number.value() - _LEAST_GAIN) / 0.01))
        self.gain.blockSignals(False)

    def _show_buttons(self) -> None:
        is_added = self._track() not in ("", *_OWN)
        self.rename.setEnabled(is_added)
        self.remove.setEnabled(is_added)
        self.export.setEnabled(self._track() not in ("", Feedback.NONE.value))

    def _track(self) -> str:
        items = self.tracks.selectedItems()
        return str(items[0].data(int(Qt.ItemDataRole.UserRole))) if items else ""

    # --- the gain ------------------------------------------------------------

    def _on_gain(self, gain: float) -> None:
        """Say at once what follows from the figures, and soon what a hand would do."""
        self._move_slider()
        entry = self._entry
        if entry is None or entry.problem:
            return
        before = entry.gain_n_per_mps2  # None where each axis has its own
        self.apply.setEnabled(before is None or abs(gain - before) > 1e-9)
        real = [track for track in entry.tracks if track.name == _OWN[0]]
        if real and before:
            factor = gain / before
            text = self.tr("about {peak} N peak, {rms} N RMS\u2026")
            peak, rms = (
                local(f"{factor * real[0].peak_n:.2f}"),
                local(f"{factor * real[0].rms_n:.2f}"),
            )
            self.preview.setText(text.format(peak=peak, rms=rms))
        self.preview.setStyleSheet(f"color: {theme.DIM};")
        self._wait = _SETTLE_POLLS

    def poll(self) -> None:
        """Begin and take over predictions."""
        job = self._preview
        if job is not None and job.is_done:
            self._preview = None
            if self._wait == 0 and job.result is not None:
                self.show_preview(job.result)
        if self._wait > 0:
            self._wait -= 1
            if self._wait == 0 and self._preview is not None:
                self._wait = 1  # of a gain that nobody wants any more
            elif self._wait == 0 and self._entry is not None:
                folder, gain = self._entry.folder, self.number.value()
                self._preview = Job(
                    "",
                    lambda progress: in_child(
                        preview_gain, folder, gain, progress=progress
                    ),
                )
                self._preview.start()

    def show_preview(self, found: ForceFigures) -> None:
        """Show a prediction."""
        text = self.tr(
            "{peak} N peak, {rms} N RMS, {share} of the time at the "
            "limit; workspace used: relaxed hand {relaxed}, normal "
            "{normal}, firm {firm}"
        ).format(
            peak=local(f"{found.peak_n:.2f}"),
            rms=local(f"{found.rms_n:.2f}"),
            share=local(f"{100.0 * found.saturated_share:.2g} %"),
            **{name: f"{100.0 * r:.0f} %" for name, r in found.reaches.items()},
        )
        if found.trips:
            text += " \u2013 " + self.tr("the force would be stopped")
        self.preview.setText(text)
        colour = theme.BAD if found.trips else theme.TEXT
        self.preview.setStyleSheet(f"color: {colour};")

    def _set_gain(self) -> None:
        entry, gain = self._entry, self.number.value()
        if entry is not None:
            folder = entry.folder
            self._run(
                self.tr("Rendering the force"),
                lambda progress: in_child(set_gain, folder, gain, progress=progress),
                lambda _none: self.changed.emit(),
            )

    # --- tracks --------------------------------------------------------------

    def _choose_force(self) -> None:
        entry = self._entry
        if entry is None:
            return
        title = self.tr("Choose a force track")
        dialog = file_dialog(self, title, str(entry.folder.parent), read_filter())
        dialog.fileSelected.connect(lambda path: self.add_force(Path(path)))
        dialog.open()

    def add_force(self, path: Path) -> None:
        """Add a force track that is named after its file."""
        entry = self._entry
        if entry is not None:
            folder, name = entry.folder, path.name.split(".")[0][:40]
            self._run(
                self.tr("Adding {name}").format(name=path.name),
                lambda progress: in_child(
                    import_force, folder, name, path, progress=progress
                ),
                self._on_added,
            )

    def _on_added(self, notes: tuple[Message, ...]) -> None:
        self.changed.emit()
        self._show_notes([translated(note) for note in notes])

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
            lambda cost: self._show_notes([cost_text(form, cost)]),
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
        self.preview.setText("\n".join(texts))
        self.preview.setStyleSheet(f"color: {theme.DIM};")

    def _show_problem(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.setVisible(bool(text))

    def close_jobs(self) -> None:
        """Wait for a prediction that still runs."""
        if self._preview is not None:
            self._preview.cancel()
            self._preview.join()
            self._preview = None
