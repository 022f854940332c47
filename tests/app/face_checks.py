"""What a face lets a person see, hear and reach, and what of its texts is cut off."""

from collections.abc import Callable, Iterator

import numpy as np
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QAccessible, QImage, QTextDocument
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QScrollBar,
    QSpinBox,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QTextEdit,
    QWidget,
)

from app.editor.lanes import Lanes
from app.plots.grip_view import GripView
from app.plots.playhead_plot import PlayheadPlot

CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QTextEdit,
    QPlainTextEdit,
    GripView,
    Lanes,
    PlayheadPlot,
)
EVERY_PLACE = 80  # more stops of the Tab key than any page has
SEEN = 40  # of 255: a change of colour that is no rounding
MARGIN_PX = 4
ONE_ROWS_FRAME_PX = 2


# --- the keyboard --------------------------------------------------------------


def controls(face: QWidget) -> list[QWidget]:
    """Return what a person can use now, as far as the page has made it itself."""
    return [
        w
        for w in face.findChildren(QWidget)
        if isinstance(w, CONTROLS)
        and not isinstance(w, QScrollBar)
        and w.isVisibleTo(face)
        and w.isEnabled()
        and w.window() is face.window()
        and not w.objectName().startswith("qt_")
        and not isinstance(w.parent(), QAbstractSpinBox | QAbstractItemView | QComboBox)
    ]


def reached_by_tab(face: QWidget) -> list[QWidget]:
    """Press Tab until it comes round; return where it has stopped."""
    stops: list[QWidget] = []
    for _ in range(EVERY_PLACE):
        at = face.focusWidget() or face
        QTest.keyClick(at, Qt.Key.Key_Tab)
        now = face.focusWidget()
        if now is not None and stops and now is stops[-1]:
            continue  # to the next link of a text
        if now is None or now in stops:
            break
        stops.append(now)
    return stops


def focus_shows(widget: QWidget) -> int:
    """Return how many pixels in and around a widget tell that it has the focus."""
    window = widget.window()
    QApplication.setCursorFlashTime(0)
    above: QWidget | None = widget
    while above is not None and not isinstance(above, QScrollArea):
        above = above.parentWidget()
    if above is not None:
        above.ensureWidgetVisible(widget)
    widget.setFocus(Qt.FocusReason.TabFocusReason)  # which may scroll
    at = QRect(widget.mapTo(window, QPoint()), widget.size())
    at = at.adjusted(-MARGIN_PX, -MARGIN_PX, MARGIN_PX, MARGIN_PX)
    at = at.intersected(window.rect())
    with_focus = _pixels(window, at)
    widget.clearFocus()
    changed = np.abs(with_focus - _pixels(window, at)).max(axis=2) > SEEN
    return int(np.count_nonzero(changed))


def _pixels(window: QWidget, at: QRect) -> np.ndarray:
    image = window.grab(at).toImage().convertToFormat(QImage.Format.Format_RGB32)
    flat = np.frombuffer(image.constBits(), np.uint8)
    rows = flat.reshape(image.height(), image.bytesPerLine() // 4, 4)
    return rows[:, : image.width(), :3].astype(int)


def spoken_name(widget: QWidget) -> str:
    """Return what a screen reader says."""
    face = QAccessible.queryAccessibleInterface(widget)
    return face.text(QAccessible.Text.Name) if face else ""


# --- the texts -----------------------------------------------------------------


def cut_off(face: QWidget) -> Iterator[str]:
    """Yield each text that has less room than it needs."""
    for widget in face.findChildren(QWidget):
        if not widget.isVisibleTo(face) or not widget.width():
            continue
        for kind, look in _LOOKS.items():
            if isinstance(widget, kind):
                yield from look(widget)
                break
        if not isinstance(widget.parent(), QAbstractScrollArea | QAbstractItemView):
            yield from _outside(widget)


def _cut_button(button: QAbstractButton) -> Iterator[str]:
    needed, has = button.sizeHint(), button.size()
    is_whole = has.width() >= needed.width() and has.height() >= needed.height()
    if button.text() and not is_whole:
        yield f"button {button.text()!r}: {has} of {needed}"


def _cut_tabs(tabs: QTabBar) -> Iterator[str]:
    for k in range(tabs.count()):
        if tabs.tabRect(k).width() < _wide(tabs, tabs.tabText(k)):
            yield f"tab {tabs.tabText(k)!r}"


def _cut_items(combo: QComboBox) -> Iterator[str]:
    """Yield the choices that would be cut off once they are chosen."""
    option = QStyleOptionComboBox()
    combo.initStyleOption(option)
    part = QStyle.SubControl.SC_ComboBoxEditField
    kind = QStyle.ComplexControl.CC_ComboBox
    room_px = combo.style().subControlRect(kind, option, part, combo).width()
    for k in range(combo.count()):
        needed_px = combo.fontMetrics().horizontalAdvance(combo.itemText(k))
        if needed_px > room_px:
            yield f"choice {combo.itemText(k)!r}: {room_px} of {needed_px}"


def _cut_number(box: QAbstractSpinBox) -> Iterator[str]:
    """Yield a number whose field has no room for it."""
    field = box.lineEdit()
    margins = field.textMargins()
    room_px = field.width() - margins.left() - margins.right()
    texts = [box.text()]
    if isinstance(box, QSpinBox):
        texts += [f"{n}{box.suffix()}" for n in (box.minimum(), box.maximum())]
    for text in texts:
        if _wide(field, text) > room_px:
            yield f"number {text!r}: {room_px} of {_wide(field, text)}"


def short_lists(face: QWidget) -> Iterator[str]:
    """Open each choice that has the keyboard; yield the lists that are cut off."""
    for combo in face.findChildren(QComboBox):
        if not (combo.isVisibleTo(face) and combo.isEnabled() and combo.count()):
            continue
        combo.setFocus(Qt.FocusReason.TabFocusReason)
        QApplication.processEvents()
        combo.showPopup()
        QApplication.processEvents()
        view = combo.view()
        rows = min(combo.count(), combo.maxVisibleItems())
        needed_px = sum(view.sizeHintForRow(row) for row in range(rows))
        room_px = view.viewport().height()
        is_whole_screen = view.window().height() >= face.screen().size().height() - 60
        if room_px < needed_px - ONE_ROWS_FRAME_PX and not is_whole_screen:
            yield f"list {combo.accessibleName()!r}: {room_px} of {needed_px} px"
        combo.hidePopup()


def _cut_sections(header: QHeaderView) -> Iterator[str]:
    for k in range(header.count()):
        along = header.orientation() == Qt.Orientation.Horizontal
        size = header.sectionSizeFromContents(k)
        needed_px = size.width() if along else size.height()
        if not header.isSectionHidden(k) and header.sectionSize(k) < needed_px:
            text = header.model().headerData(k, header.orientation())
            yield f"header {text!r}: {header.sectionSize(k)} of {needed_px}"


def _cut_label(label: QLabel) -> Iterator[str]:
    if not label.text():
        return
    room = label.contentsRect()
    if label.wordWrap():
        wide, high = 0.0, float(label.heightForWidth(label.width()))
    elif "<" in label.text():
        document = QTextDocument()
        document.setDocumentMargin(0)
        document.setDefaultFont(label.font())
        document.setHtml(label.text())
        high, wide = document.size().height(), document.idealWidth()
    else:
        lines = label.text().split("\n")
        high = label.fontMetrics().height() * len(lines)
        wide = max(_wide(label, line) for line in lines)
    if high > room.height() + 2 or wide > room.width() + 2:
        needed = f"{wide:.0f} x {high:.0f}"
        yield f"label {label.text()!r}: {room.width()} x {room.height()} of {needed}"


_LOOKS: dict[type[QWidget], Callable[..., Iterator[str]]] = {
    QLabel: _cut_label,
    QAbstractButton: _cut_button,
    QComboBox: _cut_items,
    QAbstractSpinBox: _cut_number,
    QHeaderView: _cut_sections,
    QTabBar: _cut_tabs,
}


def _wide(widget: QWidget, text: str) -> int:
    plain = text.replace("&&", "\0").replace("&", "").replace("\0", "&")
    return widget.fontMetrics().horizontalAdvance(plain)


def _outside(widget: QWidget) -> Iterator[str]:
    parent = widget.parentWidget()
    if parent is None or widget.isWindow() or not isinstance(widget, CONTROLS):
        return
    if not parent.rect().contains(widget.geometry()):
        yield f"{type(widget).__name__} {spoken_name(widget)!r} reaches out of its place"
