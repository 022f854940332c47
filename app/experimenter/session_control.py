"""The operator's window of a session, with a mirror of the participant's page."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QRectF, QSize, Qt, QTime, Signal
from PySide6.QtGui import QCloseEvent, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMainWindow,
    QMessageBox,
    QPlainTextEdit,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.bridge.errors import IsOver
from app.bridge.languages import translated
from app.bridge.pump import Cadence
from app.experimenter.spoken_number import SpokenNumber
from app.experimenter.start_panel import StartPanel, reason_text
from app.player.display import PlotArea
from app.player.health_line import HealthLine
from app.player.video_surface import VideoSurface, letterbox
from app.widgets import theme
from app.widgets.buttons import Button, text_button
from app.widgets.layout import (
    ask_text,
    column_of,
    framed,
    resize_within_screen,
    scrolling,
)
from app.widgets.messages import MessageBar
from hapticplayer.errors import StudyError, UsageError, message_of
from hapticplayer.study.overview import SessionSummary, session_summary
from hapticplayer.study.pages import PageKind
from hapticplayer.study.runner import SessionRunner

RATE_HZ = 10.0  # enough to see where the clip is
_WIDTH_PX, _HEIGHT_PX = 320, 180


class Mirror(QWidget):
    """Draws the frame that was decoded for the participant again, smaller.

    Nothing is decoded, copied or kept: a frame takes 0.3 ms, ten times a second. The
    pages are not mirrored: their answers are the participant's.
    """

    def __init__(self, surface: VideoSurface) -> None:
        super().__init__()
        self._surface, self.is_clip = surface, False
        self._cadence = Cadence(RATE_HZ)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self.setMinimumSize(_WIDTH_PX // 2, _HEIGHT_PX // 2)
        self.setAccessibleName(
            QCoreApplication.translate("Mirror", "The participant's view")
        )

    def sizeHint(self) -> QSize:
        return QSize(_WIDTH_PX, _HEIGHT_PX)

    def follow(self, now_s: float, *, is_clip: bool) -> None:
        """Redraw if it is time; `is_clip` says whether the clip is on the screen."""
        is_due = self._cadence.is_due(now_s)
        if is_clip != self.is_clip or (is_clip and is_due):
            self.is_clip = is_clip
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), QColor("black"))
            image = self._surface.image if self.is_clip else None
            if image is not None:
                size = (image.width(), image.height())
                box = letterbox(size, (self.width(), self.height()))
                painter.drawImage(QRectF(*box), image)
            else:
                painter.setPen(QColor(theme.THEMES[theme.DARK]["DIM"]))
                text = QCoreApplication.translate(
                    "Mirror", "The participant sees a page"
                )
                painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, text)
            painter.setPen(QColor(theme.BORDER))  # black has no edge on black
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))


translate = QCoreApplication.translate
_AT_END = ("results", "close")  # buttons
WIDTH_PX, HEIGHT_PX = 1280, 720  # the health line is whole


class SessionControl(QMainWindow):
    """Shows a session to the operator; blind to the condition where that is wanted.

    Live plots reveal the condition: only with `shows_force` may they be seen.
    """

    closing = Signal()
    page_wanted = Signal()
    results_wanted = Signal()

    def __init__(self, start: StartPanel, mirror: Mirror, *, shows_force: bool) -> None:
        super().__init__()
        self.setWindowTitle(self.tr("Session \u2013 hapticplayer"))
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.start, self.mirror = start, mirror
        self.messages, self.health = MessageBar(), HealthLine()
        self.plots = PlotArea()
        self.plots.setVisible(shows_force)
        if shows_force:
            self.plots.prepare()
        self.shows_force = shows_force
        self._may_close = False
        self._runner: SessionRunner | None = None
        self._changed: Callable[[], None] = lambda: None
        self.where, self.played, self.volume = QLabel(), QLabel(), QLabel()
        self.invalid, self._is_summed_up = QLabel(), False
        self._labels = (self.where, self.played, self.invalid, self.volume)
        for label in self._labels:
            label.setWordWrap(True)
        self.invalid.hide()
        self.where.setFont(theme.scaled(self.font(), 1.4, bold=True))
        self.notes = QPlainTextEdit()
        self.notes.setReadOnly(True)
        self.notes.setAccessibleName(self.tr("Notes"))
        self.note = QLineEdit()
        self.note.setAccessibleName(self.tr("New note"))
        self.note.setPlaceholderText(self.tr("Write a note; Enter saves it"))
        self.note.returnPressed.connect(self._keep_note)
        self.spoken = SpokenNumber()
        self.buttons = self._make_buttons()
        self._stack = QStackedWidget()
        self._stack.addWidget(scrolling(column_of(start)))
        self._stack.addWidget(self._panel())
        self._lay_out()

    def _make_buttons(self) -> dict[str, Button]:
        made = {
            "pause": (
                self.tr("Pause"),
                self.tr("Pause the clip; it will restart from the beginning"),
                "",
            ),
            "repeat": (self.tr("Repeat"), self.tr("Repeat the last trial"), ""),
            "skip": (self.tr("Skip\u2026"), self.tr("Skip this step"), ""),
            "end": (
                self.tr("End\u2026"),
                self.tr("End the session; it cannot be resumed"),
                "",
            ),
            "page": (
                self.tr("Participant's page"),
                self.tr("Show the participant's page over this panel"),
                "primary",
            ),
            "results": (
                self.tr("Sessions and data"),
                self.tr("Show what came of this session and those before"),
                "primary",
            ),
            "close": (self.tr("Close"), self.tr("Close the session"), ""),
            "retry": (self.tr("Try again"), self.tr("Retry saving"), ""),
            "stop": (self.tr("STOP"), self.tr("Stop the force (Esc)"), "stop"),
        }
        buttons = {
            name: text_button(text, tip, role)
            for name, (text, tip, role) in made.items()
        }
        actions: dict[str, Callable[[SessionRunner], None]] = {
            "pause": self._pause_or_resume,
            "repeat": lambda runner: runner.repeat(),
            "skip": self._skip,
            "end": self._end,
            "retry": lambda runner: runner.retry(),
            "stop": lambda runner: runner.halt("operator"),
        }
        for name, action in actions.items():
            buttons[name].clicked.connect(lambda _on, action=action: self._do(action))
        buttons["page"].clicked.connect(self.page_wanted)
        buttons["results"].clicked.connect(self.results_wanted)
        buttons["close"].clicked.connect(self.close)
        for name in ("page", *_AT_END):
            buttons[name].hide()
        return buttons

    def _panel(self) -> QWidget:
        panel = QWidget()
        texts, above, row = QVBoxLayout(), QHBoxLayout(), QHBoxLayout()
        for label in self._labels:
            texts.addWidget(label)
        texts.addStretch(1)
        above.addLayout(texts, 1)
        above.addWidget(framed(self.mirror))
        for button in self.buttons.values():
            row.addWidget(button)
        column = QVBoxLayout(panel)
        column.setContentsMargins(18, 12, 18, 10)
        column.setSpacing(12)
        column.addLayout(above)
        column.addWidget(self.spoken)
        column.addLayout(row)
        column.addWidget(self.notes, 1)
        column.addWidget(self.note)
        return panel

    def _lay_out(self) -> None:
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.messages)
        column.addWidget(self._stack, 1)
        column.addWidget(self.plots)
        column.addWidget(self.health)
        self.setCentralWidget(middle)

    def follow(self, runner: SessionRunner, changed: Callable[[], None]) -> None:
        """Show this session from now on; `changed` is called after each action."""
        self._runner, self._changed = runner, changed
        self._stack.setCurrentIndex(1)
        text = self.tr("Volume {n} %, fixed for the session")
        self.volume.setText(text.format(n=self.start.volume.value()))
        self.refresh()

    def show_message(self, text: str, is_over: IsOver | None = None) -> None:
        """Say what went wrong, until that or the page of the session is over."""
        runner = self._runner
        page = runner.page if runner else None
        self.messages.show_text(
            text,
            is_over or (lambda: (self._runner.page if self._runner else None) != page),
        )

    def refresh(self) -> None:
        """Show where the session is."""
        runner = self._runner
        if runner is None:
            return
        page = runner.page
        self.spoken.follow(runner)
        self.where.setText(self._where_text(runner))
        self.played.setText(self._played_text(runner))
        is_paused = page.kind is PageKind.PAUSED
        self.buttons["pause"].setText(
            self.tr("Resume") if is_paused else self.tr("Pause")
        )
        is_stuck = page.kind is PageKind.PROBLEM
        self.buttons["retry"].setVisible(is_stuck)
        for name in ("pause", "repeat", "skip"):
            self.buttons[name].setEnabled(not runner.is_over and not is_stuck)
        self.buttons["end"].setEnabled(not runner.is_over)
        if runner.is_over and not self._is_summed_up:
            self._show_end()
        if is_stuck and self.messages.text() != translated(runner.problem):
            self.show_message(runner.problem)

    def _show_end(self) -> None:
        self._is_summed_up = (
            True  # before: what fails is not tried thirty times a second
        )
        for name in ("pause", "repeat", "skip", "end"):
            self.buttons[name].hide()
        for name in _AT_END:
            self.buttons[name].show()
        self.played.hide()  # all trials are summed up in its place
        self.sum_up()

    def sum_up(self) -> None:
        """Show which trials so far are invalid; reads the records."""
        if self._runner is None:
            return
        try:
            session = self._runner.study.session(self._runner.plan.code)
        except StudyError as problem:
            self.show_message(message_of(problem))
        else:
            self.invalid.setText(self._invalid_text(session_summary(session)))
            self.invalid.show()

    def _invalid_text(self, found: SessionSummary) -> str:
        """How many trials are invalid, and those of each reason; no conditions."""
        text = self.tr("Invalid trials: {k} of {n}")
        text = text.format(k=len(found.invalid), n=found.answered)
        positions: dict[str, list[str]] = {}
        for trial in found.invalid:
            for reason in trial.reasons:
                positions.setdefault(reason, []).append(str(trial.position))
        more = (
            self.tr("{reason} (trial {numbers})").format(
                reason=reason_text(reason), numbers=", ".join(numbers)
            )
            for reason, numbers in positions.items()
        )
        return " \u2013 ".join(filter(None, (text, "; ".join(more))))

    def _where_text(self, runner: SessionRunner) -> str:
        page = runner.page
        text = f"{runner.plan.code} \u2013 {_kind_text(page.kind)}"
        if page.position:
            text += self.tr(", trial {k} of {n}").format(k=page.position, n=page.count)
            if runner.attempt > 1:
                text += self.tr(", attempt {n}").format(n=runner.attempt)
        if runner.condition is not None and not runner.definition.operator_is_blind:
            text += f" ({runner.condition.key})"
        return text

    def _played_text(self, runner: SessionRunner) -> str:
        last = runner.last_trial
        if last is None:
            return self.tr("No trial played yet")
        if last.is_valid:
            return self.tr("The last trial was valid")
        return self.tr("The last trial was invalid: {reasons}").format(
            reasons=", ".join(reason_text(reason) for reason in last.reasons)
        )

    # --- what the operator does -----------------------------------------------

    def _do(self, action: Callable[[SessionRunner], None]) -> None:
        if self._runner is not None:
            try:
                action(self._runner)
            except UsageError as problem:
                self.show_message(message_of(problem))
            self._changed()
            self.refresh()

    def _pause_or_resume(self, runner: SessionRunner) -> None:
        if runner.page.kind is PageKind.PAUSED:
            runner.resume()
        else:
            runner.pause()

    def _skip(self, runner: SessionRunner) -> None:
        step = runner.step
        reason = ask_text(
            self, self.tr("Skip"), self.tr("Reason for skipping this step:")
        )
        if not reason or not reason.strip():
            return
        if runner.step == step:
            runner.skip(reason)
        else:
            self.show_message(
                self.tr(
                    "Nothing was skipped: the participant has gone on to another step "
                    "meanwhile. To skip this one, press Skip again."
                )
            )

    def _end(self, runner: SessionRunner) -> None:
        reason = ask_text(
            self,
            self.tr("End the session"),
            self.tr("Reason for ending the session (all answers so far are kept):"),
        )
        if reason is not None:
            runner.stop(reason.strip() or "ended by the operator")

    def _keep_note(self) -> None:
        text = self.note.text().strip()
        if text and self._runner is not None:
            self._do(lambda runner: runner.note(text))
            now = QTime.currentTime().toString("HH:mm:ss")
            self.notes.appendPlainText(f"{now}  {text}")
            self.note.clear()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask first while a session runs; it can be resumed."""
        runner = self._runner
        is_asked = not self._may_close and runner is not None and not runner.is_over
        if is_asked and not self.is_sure():
            event.ignore()
            return
        event.accept()
        if not self._may_close:
            self._may_close = True
            self.closing.emit()

    def close_for_good(self) -> None:
        """Close without asking."""
        self._may_close = True
        self.close()

    def is_sure(self) -> bool:
        """Ask before a session is closed."""
        answer = QMessageBox.question(
            self,
            self.tr("Close"),
            self.tr("The session is not complete. Close it and resume later?"),
        )
        return answer is QMessageBox.StandardButton.Yes


def _kind_text(kind: PageKind) -> str:
    return {
        PageKind.CONSENT: translate("SessionControl", "consent"),
        PageKind.QUESTIONS: translate("SessionControl", "questions"),
        PageKind.DEMONSTRATION: translate("SessionControl", "demonstration"),
        PageKind.READY: translate("SessionControl", "ready"),
        PageKind.INTERVAL: translate("SessionControl", "between two clips"),
        PageKind.PLAYING: translate("SessionControl", "playing"),
        PageKind.PAUSED: translate("SessionControl", "paused"),
        PageKind.PROBLEM: translate("SessionControl", "saving failed"),
        PageKind.THANKS: translate("SessionControl", "finished"),
        PageKind.STOPPED: translate("SessionControl", "ended early"),
    }[kind]
