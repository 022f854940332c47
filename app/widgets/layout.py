"""Rows, columns, labels and dialogs: what the pages are built of."""

from collections.abc import Iterator
from itertools import pairwise

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QLayout,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.widgets import theme

STRETCH = -1
"""In place of a part: what takes the rest of the room."""

Part = QWidget | QLayout | int | tuple[QWidget | QLayout, int]
"""What a row or column is made of; a number is a gap in px, a pair has its stretch."""

ASKED_PX = 460
TITLE_BAR_PX = 36  # of the tallest desktops; known only once the window is shown
_INDENT_PX = 8
_BAR_PX = 16


def row_of(
    *parts: Part,
    spacing: int | None = None,
    margins: tuple[int, int, int, int] = (0, 0, 0, 0),
    of: QWidget | None = None,
) -> QHBoxLayout:
    """Return parts side by side, filling `of`; margins from the left clockwise, px."""
    made = QHBoxLayout(of) if of else QHBoxLayout()
    _fill(made, parts, spacing, margins)
    return made


def column_of(
    *parts: Part,
    spacing: int | None = None,
    margins: tuple[int, int, int, int] = (0, 0, 0, 0),
    of: QWidget | None = None,
) -> QVBoxLayout:
    """Return parts one below the other; see `row_of`."""
    made = QVBoxLayout(of) if of else QVBoxLayout()
    _fill(made, parts, spacing, margins)
    return made


def fill_page(dialog: QWidget, *parts: Part, spacing: int = 12) -> QVBoxLayout:
    return column_of(*parts, spacing=spacing, margins=(18, 16, 18, 14), of=dialog)


def _fill(
    layout: QBoxLayout,
    parts: tuple[Part, ...],
    spacing: int | None,
    margins: tuple[int, int, int, int],
) -> None:
    layout.setContentsMargins(*margins)
    if spacing is not None:
        layout.setSpacing(spacing)
    for part in parts:
        one, stretch = part if isinstance(part, tuple) else (part, 0)
        if isinstance(one, QWidget):
            layout.addWidget(one, stretch)
        elif isinstance(one, QLayout):
            layout.addLayout(one, stretch)
        elif one == STRETCH:
            layout.addStretch(1)
        else:
            layout.addSpacing(one)


def paragraph(
    text: str = "", colour: str = "", *, is_centred: bool = False, lines: int = 0
) -> QLabel:
    """Return a text, plain or rich, that may have several lines.

    It has room for `lines` from the beginning.
    """
    made = QLabel(text)
    made.setWordWrap(True)
    if colour:
        made.setStyleSheet(f"color: {colour};")
    if is_centred:
        made.setAlignment(Qt.AlignmentFlag.AlignCenter)
    if lines:
        made.setMinimumHeight(lines * made.fontMetrics().lineSpacing())
    return made


def scrolling(layout: QLayout) -> QScrollArea:
    """Return an area as wide as a layout, which scrolls where there is no room."""
    inside, area = QWidget(), QScrollArea()
    inside.setLayout(layout)
    layout.setContentsMargins(0, 0, 8, 0)
    area.setWidget(inside)
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # Tab goes to what is inside
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    keep_width(area)
    return area


def keep_width(area: QScrollArea) -> None:
    """Make such an area as wide as what is in it, after that has changed."""
    if inside := area.widget():
        area.setMinimumWidth(inside.minimumSizeHint().width() + _BAR_PX)


def captioned(text: str, widget: QWidget) -> tuple[QLabel, QWidget]:
    """Return a widget behind its caption, whose mnemonic leads to it."""
    caption = QLabel(text)
    caption.setBuddy(widget)
    return caption, widget


def read_in_order(window: QWidget) -> None:
    """Let Tab go through a window as it is laid out.

    Qt puts what was made last at the end, wherever it stands.
    """
    stops = [
        one
        for one in _laid_out(window)
        if one.focusPolicy() & Qt.FocusPolicy.TabFocus and one.focusProxy() is None
    ]
    for before, after in pairwise(stops):
        QWidget.setTabOrder(before, after)


def _laid_out(parent: QWidget | QLayout) -> Iterator[QWidget]:
    inside: list[QWidget | QLayout | None] = []
    if isinstance(parent, QTabWidget):
        inside = [parent.tabBar(), *map(parent.widget, range(parent.count()))]
    elif isinstance(parent, QSplitter):
        inside = list(map(parent.widget, range(parent.count())))
    elif isinstance(parent, QScrollArea):
        inside = [parent.widget()]
    elif layout := parent if isinstance(parent, QLayout) else parent.layout():
        # not by its items: their wrappers outlive them, and the program would crash
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        owner = layout.parentWidget()
        parts: list[QWidget | QLayout] = []
        parts += owner.findChildren(QWidget, options=direct) if owner else []
        parts += [one for one in layout.children() if isinstance(one, QLayout)]
        placed = [(layout.indexOf(one), number) for number, one in enumerate(parts)]
        inside = [parts[number] for at, number in sorted(placed) if at >= 0]
    for one in inside:
        if isinstance(one, QWidget):
            yield one
        if one is not None:
            yield from _laid_out(one)


def resize_within_screen(window: QWidget, width_px: int, height_px: int) -> None:
    """Give a window a size, or less where the screen has no room for it and its title.

    At a scale of 200 % a screen of 1920 x 1080 pixels has room for half as many.
    """
    room = window.screen().availableSize()
    room_px = max(0, room.height() - TITLE_BAR_PX)
    window.resize(min(width_px, room.width()), min(height_px, room_px))


def ask_text(parent: QWidget, title: str, label: str, text: str = "") -> str | None:
    """Ask for a line of text in a window in which it can be read; None is declined."""
    dialog = QInputDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setLabelText(label)
    dialog.setTextValue(text)
    resize_within_screen(dialog, ASKED_PX, dialog.sizeHint().height())
    is_meant = dialog.exec() == QInputDialog.DialogCode.Accepted
    return dialog.textValue() if is_meant else None


def indent(box: QAbstractSpinBox) -> None:
    """Keep a number off its frame, as other fields do; after its range and suffix.

    A style sheet's padding does not reach the field within such a box.
    """
    box.lineEdit().setTextMargins(_INDENT_PX, 0, 0, 0)
    box.setMinimumWidth(box.sizeHint().width() + _INDENT_PX)


def framed(widget: QWidget) -> QWidget:
    """Return a frame around a widget whose ground may be that of the window."""
    frame = QFrame()
    frame.setObjectName("framed")
    frame.setStyleSheet(f"QFrame#framed {{ border: 1px solid {theme.BORDER}; }}")
    column_of(widget, of=frame)
    return frame


def is_seen(widget: QWidget) -> bool:
    """Return whether a widget may be on a screen; else it need not be drawn.

    Not hidden, not in a minimised window (which X11 without a window manager still
    exposes). Whether another window covers it is known only where the desktop reports it
    (macOS, some of Wayland's); on X11 it counts as seen, and so it does where in doubt.
    """
    if not widget.isVisible():
        return False
    window = widget.window()
    handle = window.windowHandle()
    return bool(handle) and handle.isExposed() and not window.isMinimized()


BESIDE = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
"""Alignment of headings: over the left edge of their column."""


class ElidedLabel(QWidget):
    """One line that shortens itself to the room it gets; the tooltip has it all."""

    def __init__(
        self,
        text: str = "",
        colour: str = "",
        *,
        elide: Qt.TextElideMode = Qt.TextElideMode.ElideRight,
    ) -> None:
        super().__init__()
        self._text = text
        self._colour = QColor(colour or theme.TEXT)
        self._elide = elide
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        return self._text

    def set_text(self, text: str, colour: str | None = None) -> None:
        """Show a text; nothing is drawn when it is the same."""
        new = QColor(colour) if colour else self._colour
        if text != self._text or new != self._colour:
            self._text, self._colour = text, new
            self.update()

    def spoken(self) -> str:
        return self._text

    def fix_width(self, width_px: int) -> None:
        """Take exactly this width from now on."""
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setFixedWidth(width_px)

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        return QSize(metrics.horizontalAdvance(self._text) + 1, metrics.height())

    def minimumSizeHint(self) -> QSize:
        """Return a height only."""
        return QSize(0, self.fontMetrics().height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(self._colour)
        shown = self.fontMetrics().elidedText(self._text, self._elide, self.width())
        painter.drawText(self.rect(), int(BESIDE), shown)
