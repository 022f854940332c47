"""Shares a sequence: what a file for others would hold, how large it is, and writes it."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFileDialog,
    QRadioButton,
    QTableWidgetItem,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    row_of,
)
from app.widgets.messages import JobRow, StatusLine
from app.widgets.tables import plain_table
from app.widgets.texts import capitalised, local
from hapticplayer.errors import Progress
from hapticplayer.sequence.contents import MOTION_FILES, Contents, Part
from hapticplayer.sequence.library import name_from
from hapticplayer.sequence.pack import is_packed, outputs_of
from hapticplayer.sequence.sharing import share, shared_contents
from hapticplayer.untrusted import without_controls

translate = QCoreApplication.translate

WIDTH_PX, HEIGHT_PX = 760, 560
_MEGABYTE = 1e6


class Wanted(NamedTuple):
    """What a person has chosen."""

    ending: str
    with_motion: bool
    with_places: bool = False


class SharePage(JobDialog):
    """Lists what is shared of one sequence; `shared` has the file once it is there."""

    shared = Signal(object)

    def __init__(
        self, folder: Path, where: str, title: str, parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Share"))
        self._folder, self._where, self._title = folder, where, title
        self._contents: Contents | None = None
        self.one_file = QRadioButton(self.tr("&One file (MKV)"))
        self.two_files = QRadioButton(self.tr("M&P4, with a second file for the force"))
        self.with_motion = QCheckBox(self.tr("Include &motion and recorded samples"))
        self.with_places = QCheckBox(self.tr("Include &names, dates and places"))
        self.table = plain_table(
            self.tr("What is shared"),
            [self.tr("Content"), self.tr("File"), self.tr("Size")],
            stretched=0,
            has_grid=False,
        )
        self.status = StatusLine()
        self._lay_out()
        self.begin()
        self.jobs.run(
            self.tr("Preparing"),
            lambda progress: in_child(
                shared_contents, folder, with_motion=True, progress=progress
            ),
            self._take,
        )

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        text = self.tr(
            "A video file to send: every player shows it, hapticplayer also plays the force."
        )
        self.one_file.setChecked(True)
        self.with_motion.setToolTip(
            self.tr("Others can then render another force from it")
        )
        choices = (self.one_file, self.two_files, self.with_motion, self.with_places)
        for button in choices:
            button.toggled.connect(self._show_contents)
        self.progress = JobRow(
            text_button(self.tr("C&ancel"), self.tr("Cancel; nothing is kept"))
        )
        self.progress.stop.clicked.connect(self.jobs.cancel)
        self.close_button = text_button(self.tr("&Close"), "")
        self.close_button.clicked.connect(self.reject)
        self.save_button = text_button(
            self.tr("&Save\u2026"), self.tr("Choose a name, and write it"), "primary"
        )
        self.save_button.clicked.connect(self._choose)
        self.save_button.setEnabled(False)
        buttons = (STRETCH, self.close_button, self.save_button)
        fill_page(
            self,
            paragraph(text),
            row_of(self.one_file, self.two_files, STRETCH, spacing=16),
            self.with_motion,
            self.with_places,
            (self.table, 1),
            self.status,
            self.progress,
            row_of(*buttons),
        )

    # --- what is shared ------------------------------------------------------

    @property
    def wanted(self) -> Wanted:
        """What is chosen now."""
        ending = ".mkv" if self.one_file.isChecked() else ".mp4"
        return Wanted(
            ending, self.with_motion.isChecked(), self.with_places.isChecked()
        )

    def _take(self, found: Contents) -> None:
        self._contents = found
        self.with_motion.setEnabled(found.has_motion)
        self.save_button.setEnabled(True)
        self._show_contents()

    def parts(self) -> list[Part]:
        """The contents as they are chosen now."""
        if self._contents is None:
            return []
        kept = [
            part
            for part in self._contents.attached
            if self.wanted.with_motion or part.name not in MOTION_FILES
        ]
        return [self._contents.video, *kept]

    def _show_contents(self) -> None:
        parts = self.parts()
        rows = [
            (capitalised(translated(part.text)), part.name, size_text(part.size_bytes))
            for part in parts
        ]
        if self._contents is not None:
            wanted = self.wanted
            chosen = replace(
                self._contents,
                with_places=wanted.with_places,
                has_motion=self._contents.has_motion and wanted.with_motion,
            )
            for one, along in chosen.told(with_track=wanted.ending == ".mp4"):
                how = self.tr("included") if along else self.tr("left out")
                text = capitalised(translated(one.text))
                rows.append((text, without_controls(one.value), how))
        whole = sum(part.size_bytes for part in parts)
        rows.append((self.tr("Total"), "", size_text(whole)))
        self.table.setRowCount(len(rows))
        for row, texts in enumerate(rows):
            for column, shown in enumerate(texts):
                item = QTableWidgetItem(shown)
                item.setToolTip(shown)
                if column == 2:
                    right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
                    item.setTextAlignment(right)
                self.table.setItem(row, column, item)

    # --- writing -------------------------------------------------------------

    def _choose(self) -> None:
        ending = self.wanted.ending
        name = f"{name_from(self._title)}{ending}"
        kinds = self.tr("Matroska video (*.mkv)")
        if ending == ".mp4":
            kinds = self.tr("MP4 video (*.mp4)")
        dialog = file_dialog(self, self.tr("Share as"), self._where, kinds)
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setFileMode(QFileDialog.FileMode.AnyFile)
        dialog.selectFile(name)
        dialog.setDefaultSuffix(ending[1:])
        # an MP4 of another program must not be replaced, and it looks the same
        no_question = QFileDialog.Option.DontConfirmOverwrite
        dialog.setOption(no_question, ending == ".mp4")
        dialog.fileSelected.connect(lambda path: self.write(Path(path)))
        dialog.open()

    def write(self, target: Path) -> None:
        """Write the file, unless something runs."""
        if self.jobs.is_busy:
            return
        folder, wanted = self._folder, self.wanted

        def work(progress: Progress) -> Path:
            in_child(
                share,
                folder,
                target,
                with_motion=wanted.with_motion,
                with_places=wanted.with_places,
                is_ours=is_packed,
                progress=progress,
            )
            return target

        self.status.show_text("")
        self.jobs.run(self.tr("Sharing"), work, self._on_written)
        self.show_buttons()

    def _on_written(self, target: Path) -> None:
        names = ", ".join(path.name for path in outputs_of(target))
        size_bytes = sum(path.stat().st_size for path in outputs_of(target))
        text = self.tr("Saved: {names}, {size}").format(
            names=names, size=size_text(size_bytes)
        )
        self.status.show_text(text, theme.GOOD)
        self.shared.emit(target)

    def show_buttons(self) -> None:
        is_busy = self.jobs.is_busy
        self.progress.show_state(self.jobs.state())
        self.save_button.setEnabled(self._contents is not None and not is_busy)
        for button in (self.one_file, self.two_files):
            button.setEnabled(not is_busy)
        has_motion = self._contents is not None and self._contents.has_motion
        self.with_motion.setEnabled(has_motion and not is_busy)


def size_text(size_bytes: int) -> str:
    if size_bytes < _MEGABYTE:
        text = translate("SharePage", "{number} kB")
        return text.format(number=local(f"{1e-3 * size_bytes:.1f}"))
    text = translate("SharePage", "{number} MB")
    return text.format(number=local(f"{size_bytes / _MEGABYTE:.1f}"))
