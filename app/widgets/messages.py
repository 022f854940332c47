"""What the window says for a while: errors, progress, what a key has changed."""

import math
from collections.abc import Iterable

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QProgressBar, QSizePolicy, QWidget

from app.bridge.errors import IsOver
from app.bridge.jobs import JobState
from app.bridge.languages import translated
from app.bridge.recovery import Kept, forget
from app.widgets import theme
from app.widgets.buttons import Button, text_button
from app.widgets.layout import ElidedLabel, row_of
from app.widgets.texts import PERCENT, job_text, moment_text, quoted
from hapticplayer.errors import HapticPlayerError, message_of

_LONGEST, _LOOK_MS = 600, 200


def _never() -> bool:
    return False


class MessageBar(QFrame):
    """One message, until its cause is gone, it is closed, or another one comes."""

    def __init__(self) -> None:
        super().__init__()
        self._is_over: IsOver = _never
        self._timer = QTimer(self)
        self._timer.setInterval(_LOOK_MS)
        self._timer.timeout.connect(self._look)
        self.setStyleSheet(
            f"MessageBar {{ background: {theme.ALARM}; "
            f"border: 0; border-bottom: 1px solid {theme.BAD}; }}"
        )
        self._message = ""
        self._sign = QLabel("\u25a0")  # the same sign as "bad" in the health line
        self._sign.setStyleSheet(f"color: {theme.BAD};")
        self._text = QLabel()
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setWordWrap(True)
        # a long path must neither widen the window nor be cut off
        self._text.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.close_button = text_button(self.tr("Close"), self.tr("Hide this message"))
        self.close_button.clicked.connect(self.hide)
        self.copy = text_button(
            self.tr("Copy"), self.tr("Copy the message, also in English, for a report")
        )
        self.copy.clicked.connect(self._copy)
        parts = (self._sign, (self._text, 1), self.copy, self.close_button)
        row_of(*parts, margins=(12, 6, 8, 6), of=self)
        self.hide()

    def minimumSizeHint(self) -> QSize:
        """Return the room for all lines at this width; a label guesses too many."""
        least, parts = super().minimumSizeHint(), self.layout()
        if parts is None or not parts.hasHeightForWidth():
            return least
        return QSize(
            least.width(), parts.totalHeightForWidth(max(least.width(), self.width()))
        )

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.updateGeometry()

    def text(self) -> str:
        """The text, "" while hidden."""
        return "" if self.isHidden() else translated(self._message)

    def show_text(self, message: str, is_over: IsOver | None = None) -> None:
        """Say something in the window's language, also to a screen reader.

        It goes when `is_over`: when what it complains about is no longer so.
        """
        self._is_over = is_over or _never
        self._timer.start()
        self._message, text = message, translated(message)
        shown = text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "\u2026"
        self._text.setText(breakable(shown))
        self.setAccessibleName(text)
        self.show()
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.Alert))

    def _look(self) -> None:
        if self.isHidden() or self._is_over():
            self._timer.stop()
            self.hide()

    def _copy(self) -> None:
        said = dict.fromkeys((self.text(), self._message))  # once where it is English
        QGuiApplication.clipboard().setText("\n".join(said))


def breakable(text: str) -> str:
    """Return the text with places where a long path may be broken."""
    return text.replace("/", "/\u200b").replace("_", "_\u200b")


_PARTS = 1000
_AT_ONCE_S = 0.3
_PACE_S, _PACE_SHARE = 3.0, 0.05  # from when on the pace says how long it takes
_LONG_S, _REST_STEP_S = 90.0, 5


class JobRow(QFrame):
    """Title, step, progress and a button that stops the work; hidden without work."""

    def __init__(self, stop: Button) -> None:
        super().__init__()
        self.stop = stop
        self.text_label = ElidedLabel()
        self.bar = QProgressBar()
        self.bar.setRange(0, _PARTS)
        self.bar.setFormat(PERCENT)
        self.bar.setFixedWidth(240)
        row_of((self.text_label, 1), self.bar, stop, spacing=12, of=self)
        self.hide()

    def show_state(self, state: JobState | None, rest: str = "") -> None:
        """Show how far the work is, and how long it takes; None hides all."""
        self.setVisible(state is not None)
        if state is not None:
            text = " \u2013 ".join(filter(None, (job_text(state), rest)))
            self.text_label.set_text(text)
            self.text_label.setToolTip(text)
            self.bar.setValue(round(_PARTS * min(1.0, max(0.0, state.fraction))))
            self.bar.setAccessibleName(text)


class JobBar(QFrame):
    """The same over the lower edge of a widget, for work longer than a moment.

    Nothing makes room for it: what a person looks at or is about to click stays.
    """

    cancelled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"JobBar {{ background: {theme.PANEL}; "
            f"border: 0; border-top: 1px solid {theme.BORDER}; }}"
        )
        self._since_s: float | None = None
        self._below: QWidget | None = None
        self.cancel_button = text_button(
            self.tr("Cancel"), self.tr("Cancel; nothing is kept")
        )
        self.cancel_button.clicked.connect(self._on_cancel)
        self._row = JobRow(self.cancel_button)
        self.text_label = self._row.text_label
        row_of(self._row, margins=(12, 6, 8, 6), of=self)
        self.hide()

    def lie_over(self, below: QWidget) -> None:
        """Be shown on this widget from now on."""
        self._below = below
        self.setParent(below)
        below.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Follow the size of what it lies on."""
        if event.type() == QEvent.Type.Resize:
            self._place()
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        if (below := self._below) is not None:
            high_px = self.sizeHint().height()
            self.setGeometry(0, below.height() - high_px, below.width(), high_px)

    def show_state(self, state: JobState | None, now_s: float) -> None:
        """Show how far the work is; what is done at once is not worth a line."""
        if state is None:
            self._since_s = None
            self.cancel_button.setEnabled(True)
            self._row.show_state(None)
            self.hide()
            return
        if self._since_s is None:
            self._since_s = now_s
        self._row.show_state(state, self._rest(state.fraction, now_s - self._since_s))
        if self.isHidden() and now_s - self._since_s >= _AT_ONCE_S:
            self._place()
            self.show()
            self.raise_()

    def _rest(self, fraction: float, gone_s: float) -> str:
        """How long it still takes at this pace, once that can be told."""
        if gone_s < _PACE_S or fraction < _PACE_SHARE:
            return ""
        rest_s = gone_s * (1.0 - fraction) / fraction
        if rest_s > _LONG_S:
            return self.tr("about {minutes} min left").format(
                minutes=math.ceil(rest_s / 60.0)
            )
        steps = max(1, math.ceil(rest_s / _REST_STEP_S))
        return self.tr("about {seconds} s left").format(seconds=_REST_STEP_S * steps)

    def _on_cancel(self) -> None:
        self.cancel_button.setEnabled(False)
        self.cancelled.emit()


class OfferBar(QFrame):
    """Something that can be done with what is open, until it is done or closed."""

    accepted = Signal()
    refused = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"OfferBar {{ background: {theme.PANEL}; "
            f"border: 0; border-bottom: 1px solid {theme.BORDER}; }}"
        )
        self.text = ElidedLabel()
        self.accept_button = text_button("", "", "primary")
        self.accept_button.clicked.connect(self.hide)
        self.accept_button.clicked.connect(self.accepted)
        self.refuse_button = text_button(self.tr("Close"), self.tr("Hide this message"))
        self.refuse_button.clicked.connect(self.hide)
        self.refuse_button.clicked.connect(self.refused)
        parts = ((self.text, 1), self.accept_button, self.refuse_button)
        row_of(*parts, spacing=12, margins=(12, 6, 8, 6), of=self)
        self.hide()

    def show_offer(self, text: str, button: str) -> None:
        self.text.set_text(text)
        self.text.setToolTip(text)
        self.accept_button.setText(button)
        self.setAccessibleName(text)
        self.show()


class RecoveryBar(OfferBar):
    """Work of a window that was killed: taken back, or thrown away for good."""

    wanted = Signal(object)
    """To be edited again: `Kept` of those that were offered."""

    def __init__(self) -> None:
        super().__init__()
        self._left: list[Kept] = []
        self.accepted.connect(lambda: self.wanted.emit(self._left[0]))
        self.refused.connect(self._discard)
        self.refuse_button.setText(self.tr("Discard"))
        self.refuse_button.setToolTip(self.tr("Throw these changes away for good"))

    def offer(self, left: Iterable[Kept], text: str = "") -> None:
        """Offer these, one after the other; `text` in place of the usual sentence."""
        self._left = list(left)
        self.setVisible(bool(self._left))
        if self._left:
            text = text or self.tr("Changes to {name} from {moment} were not saved.")
            first = self._left[0]
            name, moment = quoted(first.title), moment_text(first.kept_utc)
            text = text.format(name=name, moment=moment)
            self.show_offer(text, self.tr("Recover"))

    def _discard(self) -> None:
        forget(self._left.pop(0))
        self.offer(self._left)


class StatusLine(QLabel):
    """What came of the work: a text in a colour, or what went wrong."""

    def __init__(self) -> None:
        super().__init__()
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)

    def show_text(self, text: str, colour: str = "") -> None:
        self.setText(text)
        self.setStyleSheet(f"color: {colour or theme.TEXT};")

    def show_problem(self, problem: BaseException) -> None:
        """Show what a person can do something about; other exceptions are raised."""
        if not isinstance(problem, HapticPlayerError):
            raise problem
        self.show_text(translated(message_of(problem)), theme.BAD)


STAYS_MS = 1200
_MARGIN_PX = 14
_STYLE = """
QLabel { background: rgba(12, 14, 17, 215); color: #ffffff; border-radius: 6px;
  padding: 6px 12px; }
"""


class OnPicture(QLabel):
    """A box with a text in the upper left corner of another widget.

    Pointers and keys go through to what it lies on.
    """

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setStyleSheet(_STYLE)
        self.move(_MARGIN_PX, _MARGIN_PX)
        self.hide()

    def show_text(self, text: str) -> None:
        """Show a text, as large as it is."""
        if text != self.text():
            self.setText(text)
            self.setAccessibleName(text)
            self.adjustSize()
        self.show()
        self.raise_()


class Toast(OnPicture):
    """A label that hides after a timeout."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(STAYS_MS)
        self._timer.timeout.connect(self.hide)

    def show_text(self, text: str) -> None:
        """Show a text for a while."""
        super().show_text(text)
        self._timer.start()
