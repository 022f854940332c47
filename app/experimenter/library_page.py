"""The library: the sequences of a folder, to search, open, check, change and delete."""

from pathlib import Path

from PySide6.QtCore import QFile, QPoint, QSize, Qt, QUrl, Signal
from PySide6.QtGui import QColor, QDesktopServices, QIcon, QImage, QPixmap
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QMessageBox,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.bridge.jobs import Job, in_child
from app.bridge.languages import translated
from app.experimenter.library_details import LibraryDetails
from app.experimenter.quality_view import colour_of, mark_name
from app.experimenter.rendering_page import RenderingPage
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import ElidedLabel, ask_text
from app.widgets.messages import JobRow, StatusLine
from app.widgets.texts import date_text, quoted, time_text
from hapticplayer.errors import HapticPlayerError, InputError, Message, Progress
from hapticplayer.media.thumbnails import Thumbnail, cover_thumbnails
from hapticplayer.sequence import verify_sequence
from hapticplayer.sequence.editing import rename_sequence
from hapticplayer.sequence.library import Entry, entries
from hapticplayer.sequence.report import Mark, worst
from hapticplayer.storage import FOLDER, refuse_existing

WIDTH_PX, HEIGHT_PX = 1080, 680
THUMBNAIL_PX = 72
_ENTRY = int(Qt.ItemDataRole.UserRole)
_LEFT_PX, _RIGHT_PX = 480, 600
_LONGEST = 80  # characters of a title in a question


class LibraryPage(JobDialog):
    """Shows what lies in the library; one piece of work at a time."""

    open_wanted = Signal(object)
    import_wanted = Signal()
    edit_wanted = Signal(object)
    library_chosen = Signal(object)

    def __init__(self, library: Path, parent: QWidget | None = None) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Library"))
        self.library = library
        self._job: Job[list[Thumbnail | None]] | None = None
        self._pictured: list[Path] = []
        self.thumbnails: dict[Path, QIcon] = {}
        self._binned: tuple[Path, Path] | None = None
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setAccessibleName(self.tr("Search"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._filter)
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Sequences"))
        self.list.setIconSize(QSize(THUMBNAIL_PX * 16 // 9, THUMBNAIL_PX))
        self.list.setSpacing(2)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.currentItemChanged.connect(lambda *_: self.show_buttons())
        self.list.itemActivated.connect(lambda _item: self._open())
        self.list.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.list.customContextMenuRequested.connect(self.open_menu)
        self.nothing = QLabel()  # lies on the list, where it is empty
        self.nothing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.nothing.setWordWrap(True)
        self.nothing.setStyleSheet(f"color: {theme.DIM};")
        QVBoxLayout(self.list.viewport()).addWidget(self.nothing)
        self.details = LibraryDetails(self._run)
        self.details.changed.connect(self.refresh)
        self.details.rendering_wanted.connect(self.open_rendering)
        self.status = StatusLine()
        self._lay_out()
        self.begin()
        self.refresh()
        self.list.setFocus()

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        self.place = ElidedLabel(
            str(self.library), theme.DIM, elide=Qt.TextElideMode.ElideMiddle
        )
        left, split = QWidget(), QSplitter()
        inner = QVBoxLayout(left)
        inner.setContentsMargins(0, 0, 0, 0)
        for widget in (self.search, self.list, self.place):
            inner.addWidget(widget)
        split.addWidget(left)
        split.addWidget(self.details)
        split.setSizes([_LEFT_PX, _RIGHT_PX])
        split.setChildrenCollapsible(False)
        message = QHBoxLayout()
        message.addWidget(self.status, 1)
        self.undo = text_button(self.tr("&Undo"), self.tr("Undo the last deletion"))
        self.undo.clicked.connect(self._undo)
        self.undo.hide()
        message.addWidget(self.undo)
        self.progress = JobRow(
            text_button(self.tr("S&top"), self.tr("Cancel; nothing is kept"))
        )
        self.progress.stop.clicked.connect(self.jobs.cancel)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 14, 16, 14)
        column.addWidget(split, 1)
        column.addLayout(message)
        column.addWidget(self.progress)
        column.addLayout(self._button_row())

    def _button_row(self) -> QHBoxLayout:
        made = (
            ("import", self.tr("&Import\u2026"), self.tr("Import a recording"), ""),
            (
                "folder",
                self.tr("&Folder\u2026"),
                self.tr("Choose the library folder"),
                "",
            ),
            ("edit", self.tr("&Effects\u2026"), self.tr("Edit the effects"), ""),
            ("rename", self.tr("Re&name\u2026"), self.tr("Change the title"), ""),
            (
                "check",
                self.tr("&Verify"),
                self.tr("Check the checksums of all files"),
                "",
            ),
            ("delete", self.tr("&Delete\u2026"), self.tr("Move to the bin"), ""),
            ("open", self.tr("&Open"), self.tr("Play (Enter)"), "primary"),
        )
        self.buttons = {name: text_button(*rest) for name, *rest in made}
        slots = {
            "import": self._import,
            "folder": self._choose_library,
            "edit": self._edit,
            "rename": self._rename,
            "check": self._check,
            "delete": self._delete,
            "open": self._open,
        }
        row = QHBoxLayout()
        row.setSpacing(8)
        for name, button in self.buttons.items():
            button.clicked.connect(slots[name])
            row.addWidget(button)
            if name == "folder":
                row.addStretch(1)
        return row

    def open_menu(self, at: QPoint) -> QMenu | None:
        """What a right click on a sequence offers."""
        entry = self.chosen()
        if entry is None or self.list.itemAt(at) is not self.list.currentItem():
            return None
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for name in ("open", "edit", "rename", "check", "delete"):
            button = self.buttons[name]
            action = menu.addAction(button.text())
            action.setEnabled(button.isEnabled())
            action.triggered.connect(button.click)
        rendering = menu.addAction(self.tr("&Rendering\u2026"))
        rendering.setEnabled(self.buttons["open"].isEnabled())
        rendering.triggered.connect(lambda: self.open_rendering(entry))
        menu.addSeparator()
        place = QUrl.fromLocalFile(str(entry.folder))
        show = menu.addAction(self.tr("Show in the file &manager"))
        show.triggered.connect(lambda: QDesktopServices.openUrl(place))
        menu.popup(self.list.viewport().mapToGlobal(at))
        return menu

    # --- what is there -------------------------------------------------------

    def refresh(self) -> None:
        """Read the folder again; the selection stays."""
        chosen = self.chosen()
        held, found = chosen.folder if chosen else None, entries(self.library)
        self.list.blockSignals(True)
        self.list.clear()
        for entry in found:
            item = QListWidgetItem(self._text(entry))
            item.setData(_ENTRY, entry)
            item.setToolTip(f"{entry.title}\n{entry.folder}")
            mark = Mark.BAD if entry.problem else worst(entry.findings)
            item.setForeground(
                QColor(theme.TEXT if mark is Mark.GOOD else colour_of(mark))
            )
            item.setIcon(self.thumbnails.get(entry.folder, _nothing()))
            self.list.addItem(item)
            if entry.folder == held:
                self.list.setCurrentItem(item)
        self.list.blockSignals(False)
        self._filter()
        if self.list.currentItem() is None and self.list.count():
            self.list.setCurrentRow(0)
        self.show_buttons()

    def chosen(self) -> Entry | None:
        """Return the sequence that is chosen, if one is."""
        item = self.list.currentItem()
        if item is None or item.isHidden():  # type: ignore[redundant-expr]
            return None
        entry: Entry = item.data(_ENTRY)
        return entry

    def _text(self, entry: Entry) -> str:
        if entry.problem:
            problem = translated(entry.problem).removeprefix(f"{entry.folder}/")
            return f"{entry.title}\n\u25a0 {problem}"
        parts = [
            time_text(entry.duration_s),
            translated(entry.camera),
            date_text(entry.created_utc),
        ]
        first = ", ".join(part for part in parts if part)
        return f"{entry.title}\n{first}\n{mark_name(worst(entry.findings))}"

    def _filter(self) -> None:
        words = self.search.text()
        for row in range(self.list.count()):
            item = self.list.item(row)
            entry: Entry = item.data(_ENTRY)
            item.setHidden(not entry.matches(words))
        self.show_buttons()

    def show_buttons(self) -> None:
        entry = self.chosen()
        self.details.show_entry(entry)
        is_whole = entry is not None and not entry.problem
        for name in ("open", "edit", "rename"):
            self.buttons[name].setEnabled(is_whole and not self.jobs.is_busy)
        for name in ("check", "delete"):
            self.buttons[name].setEnabled(entry is not None and not self.jobs.is_busy)
        rows = range(self.list.count())
        if not rows:
            text = self.tr("No sequences yet. Import a recording.")
        elif all(self.list.item(row).isHidden() for row in rows):
            text = self.tr("No matches")
        else:
            text = ""
        self.nothing.setText(text)

    # --- what a person does --------------------------------------------------

    def _open(self) -> None:
        entry = self.chosen()
        if entry is not None and not entry.problem and not self.jobs.is_busy:
            self.accept()
            self.open_wanted.emit(entry.folder)

    def _edit(self) -> None:
        entry = self.chosen()
        if entry is not None:
            self.accept()
            self.edit_wanted.emit(entry.folder)

    def _import(self) -> None:
        self.accept()
        self.import_wanted.emit()

    def _choose_library(self) -> None:
        title = self.tr("Choose the library folder")
        dialog = folder_dialog(self, title, str(self.library))
        dialog.fileSelected.connect(self._take_library)
        dialog.open()

    def _take_library(self, path: str) -> None:
        self.library = Path(path)
        self.place.set_text(path)
        self.library_chosen.emit(self.library)
        self.refresh()

    def _rename(self) -> None:
        entry = self.chosen()
        if entry is None:
            return
        title = ask_text(self, self.tr("Rename"), self.tr("Title"), entry.title)
        if title is not None:
            self.rename(entry, title)

    def rename(self, entry: Entry, title: str) -> None:
        """Give a sequence another title."""
        try:
            rename_sequence(entry.folder, title)
        except HapticPlayerError as problem:
            self.on_failed(problem)
        self.refresh()

    def open_rendering(self, entry: Entry) -> RenderingPage | None:
        """Let people render the force of a sequence in another way."""
        if self.jobs.is_busy:
            return None
        page = RenderingPage(entry.folder, entry.title, self.library, self)
        page.changed.connect(lambda _folder: self.refresh())
        page.made.connect(lambda _folder: self.refresh())
        page.finished.connect(page.deleteLater)
        page.open()
        return page

    def _check(self) -> None:
        entry = self.chosen()
        if entry is None:
            return
        folder, title = entry.folder, entry.title

        def work(progress: Progress) -> None:
            in_child(verify_sequence, folder, progress=progress)

        self._run(
            self.tr("Verifying"),
            work,
            lambda _none: self.status.show_text(
                self.tr("{title}: all files are intact").format(title=title),
                theme.GOOD,
            ),
        )

    def _delete(self) -> None:
        entry = self.chosen()
        if entry is not None and self.is_sure(entry):
            self.delete(entry)

    def is_sure(self, entry: Entry) -> bool:
        """Ask before a sequence is moved to the bin."""
        text = self.tr("Move {title} to the bin? You can restore it from there.")
        buttons = QMessageBox.StandardButton
        box = QMessageBox(
            QMessageBox.Icon.Question,
            self.tr("Delete"),
            text.format(title=quoted(_shortened(entry.title))),
            buttons.Yes | buttons.Cancel,
            self,
        )
        return QMessageBox.StandardButton(box.exec()) is buttons.Yes

    def delete(self, entry: Entry) -> None:
        """Move a sequence to the desktop's bin."""
        moved = QFile(str(entry.folder))
        if not moved.moveToTrash():
            text = self.tr("Could not move {title} to the bin; nothing was deleted.")
            self.status.show_text(text.format(title=entry.title), theme.BAD)
            return
        binned = moved.fileName()  # "" where the platform does not say
        self._binned = (Path(binned), entry.folder) if binned else None
        self.undo.setVisible(bool(binned))
        self.status.show_text(
            self.tr("Moved {title} to the bin.").format(title=entry.title)
        )
        self.refresh()

    def _undo(self) -> None:
        if self._binned is None:
            return
        binned, folder = self._binned
        try:
            refuse_existing(folder, FOLDER)
            binned.rename(folder)
            info = binned.parent.parent / "info" / f"{binned.name}.trashinfo"
            info.unlink(missing_ok=True)
        except InputError as problem:
            self.status.show_problem(problem)
        except OSError as problem:
            what = Message(
                "{path}: cannot be restored ({reason})", path=folder, reason=problem
            )
            self.status.show_text(translated(what), theme.BAD)
        else:
            self.status.show_text("")
        self._binned = None
        self.undo.hide()
        self.refresh()

    # --- work ----------------------------------------------------------------

    def _run(self, title: str, work: object, done: object) -> None:
        """Begin a piece of work, unless one runs."""
        if self.jobs.is_busy:
            return
        self.status.show_text("")
        self.jobs.run(title, work, done)  # type: ignore[arg-type]
        self.show_buttons()

    def poll(self) -> None:
        """Show what came of the work, and the thumbnails that are made."""
        super().poll()
        self._poll_pictures()

    def _poll_pictures(self) -> None:
        """Take over thumbnails of clips, and ask for those that are missing."""
        job = self._job
        if job is not None:
            if not job.is_done:
                return
            self._job = None
            made = job.result or [None] * len(self._pictured)
            for folder, one in zip(self._pictured, made, strict=True):
                self.thumbnails[folder] = _nothing() if one is None else _icon(one)
            self._show_pictures()
            return
        held = [self.list.item(row).data(_ENTRY) for row in range(self.list.count())]
        wanted = [e for e in held if e.folder not in self.thumbnails and e.clip][:16]
        if wanted and not self.is_leaving:
            self._pictured = [entry.folder for entry in wanted]
            clips = [entry.clip for entry in wanted]
            self._job = Job(
                "",
                lambda progress: in_child(
                    cover_thumbnails, clips, THUMBNAIL_PX, progress=progress
                ),
            )
            self._job.start()

    def _show_pictures(self) -> None:
        for row in range(self.list.count()):
            item = self.list.item(row)
            if (thumbnail := self.thumbnails.get(item.data(_ENTRY).folder)) is not None:
                item.setIcon(thumbnail)

    # --- the end -------------------------------------------------------------

    def cancel_jobs(self) -> None:
        """Ask what runs to stop."""
        super().cancel_jobs()
        if self._job is not None:
            self._job.cancel()

    @property
    def is_working(self) -> bool:
        """Whether closing has to wait for something."""
        is_looking = self._job is not None and not self._job.is_done
        return super().is_working or is_looking

    def close_jobs(self) -> None:
        """Stop what runs and wait for it."""
        super().close_jobs()
        for page in self.findChildren(RenderingPage):
            page.close_jobs()
        if self._job is not None:
            self._job.cancel()
            self._job.join()
            self._job = None


def _shortened(title: str) -> str:
    return title if len(title) <= _LONGEST else f"{title[: _LONGEST - 1]}\u2026"


def _icon(made: Thumbnail) -> QIcon:
    kind = QImage.Format.Format_RGB888
    image = QImage(made.rgb, made.width, made.height, 3 * made.width, kind)
    return QIcon(QPixmap.fromImage(image))


def _nothing() -> QIcon:
    empty = QPixmap(THUMBNAIL_PX * 16 // 9, THUMBNAIL_PX)
    empty.fill(theme.RAISED)
    return QIcon(empty)
