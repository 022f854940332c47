"""Sessions of any number of copies of a study, which other machines or sites have run."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtGui import QColor
from PySide6.QtWidgets import QLineEdit, QPlainTextEdit, QTableWidgetItem, QWidget

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.player.device_form import output_text
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import FileDrops, folder_dialog
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import STRETCH, captioned, fill_page, paragraph, row_of
from app.widgets.messages import JobRow, StatusLine
from app.widgets.tables import plain_table
from hapticplayer.errors import Progress
from hapticplayer.study.merging import Merged, account_of, copies_in, merge_copies
from hapticplayer.study.study_folder import open_study

_SIZE_PX = (900, 560)
_DETAIL_LINES = 6


def merged(
    folder: Path, copies: Sequence[tuple[str, Path]], *, progress: Progress
) -> list[Merged]:
    """Add the sessions of copies of the study, each with its site."""
    others = [(site, open_study(copy)) for site, copy in copies]
    return merge_copies(open_study(folder), others, progress)


def device_name(name: str) -> str:
    """The name of a device for people; of one that is not installed, as it is."""
    try:
        return output_text(name)
    except LookupError:
        return name


@dataclass
class Copy:
    """A copy of the study, and what came of it."""

    folder: Path
    site: str = ""
    found: Merged | None = None


class MergePage(JobDialog):
    """Lists copies of a study with their sites, merges them, and says what came of each.

    Args:
        folder: of the study.
        parent: of the dialog.
    """

    def __init__(self, folder: Path, parent: QWidget | None = None) -> None:
        super().__init__(_SIZE_PX, parent)
        self.setWindowTitle(self.tr("Merge sessions of other machines"))
        self.folder = folder
        self.copies: list[Copy] = []
        self.drops = FileDrops(self, self.add)
        headings = (self.tr("Site"), self.tr("Copy of the study"), self.tr("Result"))
        self.table = plain_table(
            self.tr("Copies to merge"), headings, 1, is_chosen_from=True
        )
        self.table.itemSelectionChanged.connect(self.show_buttons)
        self.site, self.detail, self.status = (
            QLineEdit(),
            QPlainTextEdit(),
            StatusLine(),
        )
        self.site.setPlaceholderText(self.tr("none"))
        self.site.textEdited.connect(self._name)
        self.detail.setReadOnly(True)
        self.detail.setTabChangesFocus(True)
        self.detail.setAccessibleName(self.tr("What came of this copy"))
        high_px = _DETAIL_LINES * self.detail.fontMetrics().lineSpacing()
        self.detail.setFixedHeight(high_px + 16)
        self._lay_out()
        self.begin()
        self.show_buttons()

    def _lay_out(self) -> None:
        intro = self.tr(
            "Add the folders that have come back, or one that holds several: the names of "
            "its folders are those of the sites then. Sessions that are here already stay "
            "as they are. In the mixed models each site has an intercept of its own."
        )
        self.progress = JobRow(
            text_button(self.tr("Stop"), self.tr("Stop; sessions that were added stay"))
        )
        self.progress.stop.clicked.connect(self.jobs.cancel)
        close = text_button(self.tr("Close"), self.tr("Close this window"))
        close.clicked.connect(self.reject)
        self.choose = text_button(
            self.tr("&Add\u2026"), self.tr("Add a copy, or a folder that holds several")
        )
        self.choose.clicked.connect(self._choose)
        self.remove = text_button(
            self.tr("&Remove"), self.tr("Take the selected copy off this list")
        )
        self.remove.clicked.connect(self._remove)
        self.start = text_button(
            self.tr("&Merge"),
            self.tr("Add the sessions of all these copies"),
            "primary",
        )
        self.start.clicked.connect(self.merge)
        caption, site = captioned(self.tr("&Site of the selected copy"), self.site)
        fill_page(
            self,
            paragraph(intro, theme.DIM),
            (self.table, 1),
            row_of(caption, (site, 1), spacing=8),
            self.detail,
            self.status,
            self.progress,
            row_of(close, self.choose, self.remove, STRETCH, self.start, spacing=8),
        )

    # --- what is to be merged --------------------------------------------------

    def add(self, paths: Iterable[Path]) -> None:
        """Add copies of the study, from their folders or one that holds several."""
        if self.jobs.is_busy:
            return
        known = {copy.folder for copy in self.copies}
        for site, folder in (one for path in paths for one in copies_in(path)):
            if folder not in known:
                known.add(folder)
                self.copies.append(Copy(folder, site))
        self.show_copies(len(self.copies) - 1)

    def show_copies(self, chosen: int) -> None:
        """List the copies, and select one."""
        self.table.setRowCount(len(self.copies))
        for row, copy in enumerate(self.copies):
            for column, text in enumerate((copy.site, str(copy.folder), "")):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                self.table.setItem(row, column, item)
            self._show_result(row, copy.found)
        self.table.selectRow(chosen)
        self.show_buttons()

    def _show_result(self, row: int, found: Merged | None) -> None:
        cell = self.table.item(row, 2)
        if cell is None or found is None:
            return
        text = self.tr("\u25cf added: {added}, here already: {same}")
        colour = theme.GOOD
        if found.conflicts:
            text = self.tr("\u25b2 added: {added}, left out: {left}")
            colour = theme.WARN
        cell.setText(
            text.format(
                added=len(found.added), same=len(found.same), left=len(found.conflicts)
            )
        )
        cell.setForeground(QColor(colour))

    def chosen(self) -> Copy | None:
        """The copy that is selected."""
        row = self.table.currentRow()
        return self.copies[row] if 0 <= row < len(self.copies) else None

    def show_buttons(self) -> None:
        copy, is_free = self.chosen(), not self.jobs.is_busy
        self.choose.setEnabled(is_free)
        self.remove.setEnabled(is_free and copy is not None)
        self.site.setEnabled(is_free and copy is not None)
        self.start.setEnabled(is_free and bool(self.copies))
        self.site.setText(copy.site if copy else "")
        self.detail.setPlainText(_told(copy.found) if copy and copy.found else "")

    # --- what a person does ----------------------------------------------------

    def _name(self, site: str) -> None:
        """Keep the name of a site."""
        copy, cell = self.chosen(), self.table.item(self.table.currentRow(), 0)
        if copy is not None and cell is not None:
            copy.site = site.strip()
            cell.setText(copy.site)

    def _choose(self) -> None:
        title = self.tr("Choose a copy of this study, or a folder of copies")
        dialog = folder_dialog(self, title, str(self.folder.parent))
        dialog.fileSelected.connect(lambda path: self.add([Path(path)]))
        dialog.open()

    def _remove(self) -> None:
        row = self.table.currentRow()
        del self.copies[row]
        self.show_copies(min(row, len(self.copies) - 1))

    def merge(self) -> None:
        """Add the sessions of all copies."""
        self.status.show_text("")
        copies = [(copy.site, copy.folder) for copy in self.copies]
        self.jobs.run(
            self.tr("Merging"),
            lambda progress: in_child(merged, self.folder, copies, progress=progress),
            self._take,
        )
        self.show_buttons()

    def _take(self, found: list[Merged]) -> None:
        for copy, one in zip(self.copies, found, strict=True):
            copy.found = one
        spoilt = (row for row, one in enumerate(found) if one.conflicts)
        self.show_copies(next(spoilt, self.table.currentRow()))
        left = sum(len(one.conflicts) for one in found)
        text = self.tr(
            "Sessions added: {added}; here already: {same}; left out: {left}."
        )
        self.status.show_text(
            text.format(
                added=sum(len(one.added) for one in found),
                same=sum(len(one.same) for one in found),
                left=left,
            ),
            theme.WARN if left else "",
        )


def _told(found: Merged) -> str:
    """All that there is to say of a copy, what needs a person first."""
    lines = [*found.conflicts, *found.notices, *account_of(found, device_name)]
    return "\n".join(map(translated, lines))
