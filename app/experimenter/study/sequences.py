"""The sequences of a study: added from the library, named, put in order, removed."""

import re
from collections.abc import Callable, Iterable
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QSizePolicy,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row
from app.experimenter.study.words import text_in
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.texts import time_text
from hapticplayer.sequence.library import Entry, entries, read_entry

_WIDTH_PX, _HEIGHT_PX = 560, 460
_ENTRY = int(Qt.ItemDataRole.UserRole)
_LONGEST_KEY = 40


class SequenceList(EntryList):
    """Lists the sequences.

    Args:
        document: of the study.
        study: its folder, which those of its sequences may be relative to.
        library: returns the folder of the library.
    """

    def __init__(
        self, document: StudyDocument, study: Path, library: Callable[[], Path]
    ) -> None:
        add = text_button(
            self.tr("Add from the library\u2026"), self.tr("Choose one or several")
        )
        super().__init__(document, self.tr("Sequences"), add)
        self._study, self._library = study, library
        add.clicked.connect(lambda: self._ask(self.add))

    def rows(self) -> list[Row]:
        languages = self.document.languages
        return [
            Row(
                self._row_text(text_in(one["title"], languages), one),
                ("sequences", number),
                may_go=len(self.document.value["sequences"]) > 1,
            )
            for number, one in enumerate(self.document.value["sequences"])
        ]

    def _row_text(self, title: str, one: dict[str, str]) -> str:
        entry = self._entry(one["folder"])
        if entry is None:
            state = self.tr("no recording yet")
        else:
            state = translated(entry.problem) or time_text(entry.duration_s)
        return f"{title or one['key']}\n{state}"

    def _entry(self, folder: str) -> Entry | None:
        return read_entry(self._study / folder) if folder else None

    def fill(self, place: Place) -> None:
        fields, folder = self.fields, (*place, "folder")
        choose = text_button(
            self.tr("Choose a recording\u2026"), self.tr("Choose from the library")
        )
        choose.clicked.connect(lambda: self._ask(self.use, is_one=True))
        is_here = QLabel()
        is_here.setWordWrap(True)
        policy = is_here.sizePolicy()  # as wide as its row, with a height for its width
        policy.setHorizontalPolicy(QSizePolicy.Policy.Expanding)
        is_here.setSizePolicy(policy)

        def show() -> None:
            entry = self._entry(str(self.document.at(folder) or ""))
            is_here.setText(self._described(entry))
            colour = theme.WARN if entry is None or entry.problem else theme.TEXT
            is_here.setStyleSheet(f"color: {colour};")

        fields.row(self.tr("Recording"), is_here)
        fields.row("", choose)
        fields.bind(folder, choose, show)
        fields.texts(self.tr("Title"), (*place, "title"))
        key = fields.line(
            self.tr("Name in the data"),
            (*place, "key"),
            tip=self.tr("In data and figures: a to z, 0 to 9, _ and -"),
        )
        key.setMaximumWidth(2 * key.sizeHint().width())
        tip = self.tr(
            "What sequences differ in, such as viewpoint = first here and viewpoint = third "
            "in others; the analysis compares feedbacks at each level"
        )
        fields.pairs(self.tr("Factors"), (*place, "factors"), tip)
        fields.whole(
            paragraph(
                self.tr(
                    "Titles are for you and for figures; participants never see them."
                ),
                theme.DIM,
            )
        )

    def _described(self, entry: Entry | None) -> str:
        if entry is None:
            return self.tr("None yet")
        if entry.problem:
            return translated(entry.problem)
        parts = (entry.title, time_text(entry.duration_s), translated(entry.camera))
        return ", ".join(filter(None, parts))

    # --- what a person does ------------------------------------------------------

    def add(self, chosen: Iterable[Entry]) -> None:
        """Add sequences; the first ones take the place of the template's examples.

        Their levels of the factors that others have are to be entered.
        """
        before = self.document.value["sequences"]
        factors = dict.fromkeys(
            (n for one in before for n in one.get("factors", {})), ""
        )
        kept = [] if all(not one["folder"] for one in before) else before
        made: list[dict[str, object]] = list(kept)
        for entry in chosen:
            made.append(
                {
                    "key": free_key(entry.title, [str(one["key"]) for one in made]),
                    "title": dict.fromkeys(self.document.languages, entry.title),
                    "folder": str(entry.folder.absolute()),
                    **({"factors": dict(factors)} if factors else {}),
                }
            )
        self.selected = ("sequences", len(made) - 1)
        text = self.tr("another sequence")
        self.document.change_list(("sequences",), lambda _before: made, text)

    def use(self, chosen: list[Entry]) -> None:
        """Take a recording for the selected sequence."""
        place = (*self.selected, "folder")
        folder = str(chosen[0].folder.absolute())
        self.document.set(place, folder, self.tr("another recording"))

    def _ask(
        self, take: Callable[[list[Entry]], None], *, is_one: bool = False
    ) -> None:
        dialog = LibraryChoice(self._library(), self, is_one=is_one)
        dialog.chosen.connect(take)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()


def free_key(title: str, taken: Iterable[str]) -> str:
    """Return a name in data and figures that is not taken, from a title."""
    base = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")
    base = base[: _LONGEST_KEY - 4].strip("-") or "sequence"
    names = (base if n == 1 else f"{base}-{n}" for n in range(1, 1000))
    known = set(taken)
    return next(name for name in names if name not in known)


class LibraryChoice(QDialog):
    """Offers the sequences of the library; `chosen` has a list of them."""

    chosen = Signal(object)

    def __init__(
        self, library: Path, parent: QWidget | None = None, *, is_one: bool = False
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Choose a recording"))
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Library"))
        mode = QAbstractItemView.SelectionMode
        self.list.setSelectionMode(
            mode.SingleSelection if is_one else mode.ExtendedSelection
        )
        for entry in entries(library):
            if not entry.problem:
                self._offer(entry)
        self.nothing = paragraph(
            self.tr(
                "There is no sequence in {folder}. Import a recording first "
                "(File > Import), or choose another folder."
            ).format(folder=library),
            theme.DIM,
        )
        self.nothing.setVisible(not self.list.count())
        self.add_button = text_button(
            self.tr("&Choose") if is_one else self.tr("&Add"), "", "primary"
        )
        self.add_button.clicked.connect(self._take)
        self.list.itemActivated.connect(lambda _item: self._take())
        self.list.itemSelectionChanged.connect(self._enable)
        other = text_button(
            self.tr("&Folder\u2026"), self.tr("Choose a sequence in another folder")
        )
        other.clicked.connect(self._browse)
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        buttons = row_of(other, STRETCH, cancel, self.add_button, spacing=8)
        fill_page(self, self.nothing, (self.list, 1), buttons)
        self._enable()

    def _offer(self, entry: Entry) -> None:
        item = QListWidgetItem(f"{entry.title}\n{time_text(entry.duration_s)}")
        item.setData(_ENTRY, entry)
        item.setToolTip(str(entry.folder))
        self.list.addItem(item)

    def _enable(self) -> None:
        self.add_button.setEnabled(bool(self.list.selectedItems()))

    def _take(self) -> None:
        items = sorted(self.list.selectedItems(), key=self.list.row)
        if items:
            self.chosen.emit([item.data(_ENTRY) for item in items])
            self.accept()

    def _browse(self) -> None:
        dialog = folder_dialog(self, self.tr("Sequence folder"), str(Path.home()))
        dialog.fileSelected.connect(lambda path: self._take_folder(Path(path)))
        dialog.open()

    def _take_folder(self, folder: Path) -> None:
        entry = read_entry(folder)
        if entry.problem:
            self.nothing.setText(translated(entry.problem))
            self.nothing.setStyleSheet(f"color: {theme.BAD};")
            self.nothing.show()
        else:
            self.chosen.emit([entry])
            self.accept()
