"""The guide inside the window: the documents, section by section, with a search."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QDialog,
    QLineEdit,
    QSplitter,
    QTextBrowser,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    column_of,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from hapticplayer.shipped import shipped
from hapticplayer.untrusted import read_regular

_FIRST = ("play", "import", "recording", "force", "effects", "devices", "study")
_THEN = ("participant", "safety", "formats", "methods", "reference")
WIDTH_PX, HEIGHT_PX = 900, 640
_LEFT_PX, _RIGHT_PX = 250, 650
_MOST_BYTES = 1 << 20
_HEADING = re.compile(r"^#{1,6} (.+?)\s*$", re.MULTILINE)
_CHAPTER = re.compile(r"^(?=#{1,3} )", re.MULTILINE)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)


class Section(NamedTuple):
    """A chapter of a page: short, so that showing it delays nothing."""

    page: str
    title: str
    text: str

    def matches(self, words: str) -> bool:
        whole = self.text.lower()
        return all(word in whole for word in words.lower().split())


def read_guide(folder: Path) -> list[Section]:
    """All sections, the pages in the order in which people need them."""
    order = {f"{name}.md": n for n, name in enumerate((*_FIRST, *_THEN))}
    pages = sorted(
        folder.glob("*.md"), key=lambda p: (order.get(p.name, len(order)), p.name)
    )
    return [one for path in pages for one in _sections(path)]


def _sections(path: Path) -> Iterator[Section]:
    text = _COMMENT.sub("", read_regular(path, _MOST_BYTES).decode(errors="replace"))
    for part in _CHAPTER.split(text):
        if found := _HEADING.search(part):
            yield Section(path.name, found[1].replace("`", ""), part)


def slug(heading: str) -> str:
    """The anchor of a heading, as links in the documents name it."""
    kept = re.sub(r"[^\w\- ]", "", heading.lower())
    return kept.strip().replace(" ", "-")


class GuideWindow(QDialog):
    """Stays beside the window."""

    def __init__(self, parent: QWidget | None, folder: Path | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Guide"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        folder = folder or shipped("docs")
        self.sections = read_guide(folder)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search the guide"))
        self.search.setAccessibleName(self.tr("Search the guide"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._fill)
        self.tree = QTreeWidget()
        self.tree.setHeaderHidden(True)
        self.tree.setAccessibleName(self.tr("Contents"))
        self.tree.currentItemChanged.connect(self._show_item)
        self.nothing = paragraph(self.tr("No matches"), is_centred=True)
        self.page = QTextBrowser()
        self.page.setAccessibleName(self.tr("Page"))
        self.page.setSearchPaths([str(folder)])
        self.page.setOpenLinks(False)
        self.page.anchorClicked.connect(self.follow)
        self._lay_out()
        self._fill()
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.search.setFocus()

    def _lay_out(self) -> None:
        left, split = QWidget(), QSplitter()
        column_of(self.search, (self.tree, 1), self.nothing, of=left)
        split.addWidget(left)
        split.addWidget(self.page)
        split.setSizes([_LEFT_PX, _RIGHT_PX])
        split.setChildrenCollapsible(False)
        close = text_button(self.tr("&Close"), "")
        close.clicked.connect(self.reject)
        fill_page(self, (split, 1), row_of(STRETCH, close))

    def _fill(self) -> None:
        """List the sections that hold the words, below their pages."""
        words = self.search.text()
        found = [one for one in self.sections if one.matches(words)]
        self.tree.clear()
        tops: dict[str, QTreeWidgetItem] = {}
        titles = {one.page: one.title for one in reversed(self.sections)}
        for one in found:
            top = tops.get(one.page)
            if top is None:
                top = tops[one.page] = QTreeWidgetItem([titles[one.page]])
                self.tree.addTopLevelItem(top)
            is_first = one.title == titles[one.page]
            item = top if is_first else QTreeWidgetItem(top, [one.title])
            item.setData(0, Qt.ItemDataRole.UserRole, one)
            top.setExpanded(bool(words))
        self.nothing.setVisible(not found)
        if found:
            self.show_section(found[0])
        else:
            self.page.clear()

    def show_section(self, section: Section) -> None:
        """Show a section, at the first of the words that are looked for."""
        self.page.setMarkdown(section.text)
        if words := self.search.text().split():
            self.page.find(words[0])

    def _show_item(self, item: QTreeWidgetItem | None) -> None:
        section = item.data(0, Qt.ItemDataRole.UserRole) if item else None
        if section is not None:
            self.show_section(section)

    def follow(self, link: QUrl) -> None:
        """Go to another section; what is not in the guide opens in the browser."""
        if link.scheme() in ("http", "https"):
            QDesktopServices.openUrl(link)
            return
        name, anchor = Path(link.path()).name, link.fragment()
        known = [one for one in self.sections if not name or one.page == name]
        for one in known:
            if any(slug(h) == anchor for h in _HEADING.findall(one.text)):
                self.show_section(one)
                return
        if known:
            self.show_section(known[0])
