"""Pages of the participant: the largest font that fits, legible from two metres.

A letter 1/22 of the picture's height is 14 mm on a 24-inch screen: capitals of 10 mm,
1.7 times what an acuity of 0.5 needs at 2 m (5 minutes of arc / 0.5 = 5.8 mm). The
smallest have capitals of 6 mm.
"""

from PySide6.QtCore import QCoreApplication, QEvent, QSize, Qt, QTimer
from PySide6.QtGui import QFont, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QFrame,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.widgets import theme

LARGEST, SMALLEST = 22.0, 36.0  # letters are the height divided by these
STEPS = 7
SCROLLED = 3  # the step for what has to be scrolled anyway
TOUCH_PX = 44  # no finger misses it (WCAG 2.2, 2.5.5)
_HIGH, _SIDES = 2.0, 1.4  # a button and the room beside its text, in letters
_MARGIN_SHARE = 0.06
_BAR_PX = 20


def style() -> str:
    """Return the style sheet of the participant's pages, in the current theme."""
    is_strong = theme.name == theme.CONTRAST  # its blue has no edge on black
    edge = theme.BORDER if is_strong else theme.CHOSEN
    focus = theme.FOCUS if is_strong else theme.TEXT
    return f"""
QWidget {{ background: {theme.BACKGROUND}; color: {theme.TEXT}; }}
QPushButton {{ background: {theme.RAISED}; border: 2px solid {theme.BORDER};
  border-radius: 10px; padding: 0.35em 1.0em; }}
QPushButton:hover {{ background: {theme.HOVER}; }}
QPushButton:focus {{ border: 3px solid {theme.FOCUS}; }}
QPushButton:checked {{ background: {theme.PRIMARY}; border-color: {edge};
  color: {theme.PRIMARY_TEXT}; font-weight: bold; }}
QPushButton[role="primary"] {{ background: {theme.PRIMARY};
  border-color: {edge}; color: {theme.PRIMARY_TEXT}; }}
QPushButton:checked:focus, QPushButton[role="primary"]:focus {{
  border: 3px solid {focus}; }}
QSpinBox, QPlainTextEdit {{ background: {theme.PANEL}; border: 2px solid {theme.BORDER};
  border-radius: 8px; padding: 4px; }}
QSpinBox:focus, QPlainTextEdit:focus {{ border: 3px solid {theme.FOCUS}; }}
QSpinBox::up-button, QSpinBox::down-button {{ width: 0; }}
QSpinBox::up-arrow, QSpinBox::down-arrow {{ image: none; }}
QSpinBox QLineEdit {{ background: transparent; }}
QFrame[role="question"] {{ border: 2px solid transparent; border-radius: 12px; }}
QFrame[role="current"] {{ border: 2px solid {theme.BORDER}; border-radius: 12px; }}
QScrollArea {{ border: 0; }}
QScrollBar:vertical {{ width: {_BAR_PX}px; background: {theme.BACKGROUND}; }}
QScrollBar::handle:vertical {{ background: {theme.BORDER}; border-radius: 6px;
  margin: 2px; min-height: {TOUCH_PX}px; }}
QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical {{ height: 0; }}
QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical {{ background: none; }}
"""


class FittedPage(QScrollArea):
    """A column of widgets in the largest font that the page allows.

    What does not fit even in the smallest font can be scrolled: nothing is cut off.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._fitted_for = QSize()
        self._size_step = 0
        # the style gives some widgets their true height only when they are shown
        self._settling = QTimer(self)
        self._settling.setSingleShot(True)
        self._settling.timeout.connect(self.settle)
        self._in_sight: tuple[QWidget, ...] = ()
        self.body = _Body()
        self.column = QVBoxLayout(self.body)
        self.setWidget(self.body)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # also called when the scroll bar comes or goes, which depends on the letters
        if self.size() != self._fitted_for:
            self.fit()

    def fit(self) -> None:
        """Take the largest letters with which everything is in sight."""
        room = self._fitted_for = self.size()
        margin = round(_MARGIN_SHARE * room.width())
        self.column.setContentsMargins(margin, margin // 3, margin, margin // 3)
        self._size_step = 0
        self._take_step()
        self._shrink()
        self._settling.start()

    def keep_in_sight(self, *widgets: QWidget) -> None:
        """Scroll to widgets, the last first of all, once everything has its size."""
        self._in_sight = widgets
        self._settling.start()

    def settle(self) -> None:
        """Take sizes that fit, and scroll to what is to be in sight."""
        self._shrink()
        wanted, self._in_sight = self._in_sight, ()
        self.column.activate()
        # now, not after the next painting, which would show it cut off
        QCoreApplication.sendEvent(self, QEvent(QEvent.Type.LayoutRequest))
        for widget in wanted:
            self.ensureWidgetVisible(widget)

    def _take_step(self) -> None:
        share = LARGEST + (SMALLEST - LARGEST) * self._size_step / (STEPS - 1)
        self.set_font_size(max(9, round(self._fitted_for.height() / share)))

    def _shrink(self) -> None:
        """Take smaller letters while something is out of sight."""
        width, height = self._fitted_for.width(), self._fitted_for.height()
        while not self._has_room() and self._size_step < STEPS - 1:
            self._size_step += 1
            self._take_step()
        if not self._is_wide_enough():
            return
        if self.needed_px(width) > height:
            self._size_step = SCROLLED
            self._take_step()

    def _is_wide_enough(self) -> bool:
        return self.column.totalMinimumSize().width() <= self._fitted_for.width()

    def _has_room(self) -> bool:
        room = self._fitted_for
        return self._is_wide_enough() and self.needed_px(room.width()) <= room.height()

    def set_font_size(self, font_px: int) -> None:
        """Use letters of this size."""
        font = QFont(self.body.font())
        font.setPixelSize(font_px)
        self.body.setFont(font)
        metrics = QFontMetrics(font)
        for child in self.body.findChildren(QWidget):
            child.setFont(font)
            if isinstance(child, QAbstractButton | QSpinBox):
                child.setMinimumHeight(max(TOUCH_PX, round(_HIGH * font_px)))
                # the sheet's em is that of small letters
                widest = _widest_text(child)
                wide_px = metrics.horizontalAdvance(widest)
                wide_px += round(_SIDES * font_px)
                if isinstance(child, QAbstractButton):
                    wide_px = max(wide_px, child.sizeHint().width())
                child.setMinimumWidth(wide_px)
        self.column.setSpacing(font_px // 2)
        self.column.activate()

    def needed_px(self, width_px: int) -> int:
        """Return the height that everything takes at a width."""
        layout = self.column
        if layout.hasHeightForWidth():
            return layout.totalHeightForWidth(width_px)
        return layout.totalSizeHint().height()


def _widest_text(widget: QAbstractButton | QSpinBox) -> str:
    """What a button says, or the longest number of a box."""
    if isinstance(widget, QSpinBox):
        return max(str(widget.minimum()), str(widget.maximum()), key=len)
    return widget.text()


class _Body(QWidget):
    """As high as its texts are at the page's width.

    Its own least height would be that of the texts in their narrowest shape.
    """

    def minimumSizeHint(self) -> QSize:
        """Leave the height to `heightForWidth`."""
        return QSize(0, 0)


def paragraph(text: str, *, centred: bool = False) -> QLabel:
    """Return a text that breaks into lines; it is never read as markup."""
    made = QLabel(text)
    made.setTextFormat(Qt.TextFormat.PlainText)
    made.setWordWrap(True)
    made.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
    if centred:
        made.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    return made
