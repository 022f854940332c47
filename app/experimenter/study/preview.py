"""A page as the participant will see it, while it is written."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
)
from PySide6.QtWidgets import QComboBox, QSizePolicy, QStyle, QVBoxLayout, QWidget

from app.bridge.languages import NAMES, spoken
from app.experimenter.study.document import Content, filled
from app.participant.fitted_page import FittedPage, style
from app.participant.pages import make_page
from app.participant.window import participant_screen
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, captioned, column_of, row_of
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import InputError
from hapticplayer.structures import convert
from hapticplayer.study.definition import Definition
from hapticplayer.study.drafts import clip_seconds
from hapticplayer.study.pages import Page, PageKind, PageMaker
from hapticplayer.study.plan import LENGTH, LETTERS, Plan

_LATER_MS = 150
_LEAST_PX = 80


class ShownPage(NamedTuple):
    """A page of the participant: kind, step, and key of the page of questions."""

    kind: PageKind
    step: str
    key: str = ""


def sample_page(
    content: Content, folder: Path, shown: ShownPage, language: str
) -> tuple[Page, PageMaker] | None:
    """A page of a session that has not begun; None where there is no study yet."""
    try:
        made = convert(filled(content), Definition, "")
    except InputError:
        return None
    plan = Plan(
        code=LETTERS[:LENGTH],
        study=made.id,
        definition_sha256="",
        program="",
        created_utc=utc_now_iso("milliseconds"),
        language=language,
        method=made.order.method,
        seed=made.order.seed,
        row=None,
        order=made.conditions,
        labels=made.feedback_keys,
        clips={},
    )
    minutes = made.expected_min(clip_seconds(content, folder))
    maker = PageMaker(made, plan, minutes)
    asking = next((page for page in made.pages if page.key == shown.key), None)
    return maker.page(shown.kind, shown.step, 1, asking), maker


@contextmanager
def _held(page: FittedPage, size: QSize) -> Iterator[QWidget]:
    """A participant's page at a size, laid out as on a screen but on none."""
    holder = QWidget()
    holder.setAttribute(Qt.WidgetAttribute.WA_DontShowOnScreen)
    holder.setStyleSheet(style())
    column_of(page, of=holder)
    holder.resize(size)
    holder.show()
    try:
        page.fit()
        page.settle()
        yield holder
    finally:
        holder.close()
        holder.deleteLater()


class PagePreview(QWidget):
    """A small picture of a page, made again soon after every change."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._content: Content = {}
        self._page: ShownPage | None = None
        self.shown: Page | None = None
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(_LATER_MS)
        self._later.timeout.connect(self.draw)
        self.language = QComboBox()
        self.language.activated.connect(lambda _row: self._later.start())
        self.picture = _Picture()
        self.large = text_button(
            self.tr("Full size"), self.tr("Show the page on the participant's screen")
        )
        self.large.clicked.connect(self._show_large)
        caption, _ = captioned(self.tr("Preview"), self.language)
        top = row_of(caption, self.language, STRETCH, self.large, spacing=8)
        column_of(top, (self.picture, 1), spacing=6, of=self)

    def follow(self, content: Content, page: ShownPage | None) -> None:
        """Show a page of a definition; None for a text that is on no page."""
        self.setVisible(page is not None)
        if page is None or (content is self._content and page == self._page):
            return
        self._content, self._page = content, page
        self._offer(content["languages"])
        self._later.start()

    def _offer(self, languages: list[str]) -> None:
        held = self.language.currentData() or spoken()
        offered = [self.language.itemData(n) for n in range(self.language.count())]
        if offered != languages:
            self.language.clear()
            for one in languages:
                self.language.addItem(NAMES.get(one, one), one)
            self.language.setCurrentIndex(max(0, self.language.findData(held)))

    def _made(self) -> FittedPage | None:
        assert self._page is not None
        language = self.language.currentData()
        made = sample_page(self._content, self._folder, self._page, language)
        if made is None:
            return None
        self.shown, maker = made
        return make_page(self.shown, maker, {}, has_felt=False)

    def draw(self) -> None:
        """Draw the page as it is now; what cannot be one yet leaves the last picture."""
        self._later.stop()
        page = self._made() if self._page else None
        if page is not None:
            with _held(page, participant_screen(self.screen()).size()) as holder:
                self.picture.show_picture(holder.grab())

    def _show_large(self) -> None:
        page = self._made()
        if page is not None:
            shown = _LargePage(page, self)
            screen = participant_screen(self.screen())
            shown.setScreen(screen)
            shown.setGeometry(screen.geometry())
            shown.showFullScreen()
            page.focus()  # type: ignore[attr-defined]


class _Picture(QWidget):
    """Draws a picture as large as there is room."""

    def __init__(self) -> None:
        super().__init__()
        self.shown = QPixmap()
        self.setAccessibleName(self.tr("The page as the participant sees it"))
        self.setMinimumHeight(_LEAST_PX)
        policy = QSizePolicy.Policy.Expanding
        self.setSizePolicy(policy, policy)

    def show_picture(self, picture: QPixmap) -> None:
        self.shown = picture
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self.shown.isNull():
            return
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            size = self.shown.size().scaled(
                self.size(), Qt.AspectRatioMode.KeepAspectRatio
            )
            room = QStyle.alignedRect(
                self.layoutDirection(), Qt.AlignmentFlag.AlignHCenter, size, self.rect()
            )
            painter.drawPixmap(room, self.shown)
            painter.setPen(QColor(theme.BORDER))
            painter.drawRect(room.adjusted(0, 0, -1, -1))


class _LargePage(QWidget):
    """The page over the whole screen; Esc and a button leave it."""

    def __init__(self, page: FittedPage, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setStyleSheet(style())
        leave = text_button(self.tr("Close the preview (Esc)"), "")
        leave.clicked.connect(self.close)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(page, 1)
        leave.setParent(page)
        leave.move(12, 12)
        leave.show()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)
