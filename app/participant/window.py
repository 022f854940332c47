"""The participant's screen: one page or the clip, nothing else."""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QScreen,
    QShortcut,
)
from PySide6.QtWidgets import QStackedWidget, QWidget

from app.participant.fitted_page import style
from app.participant.pages import QuestionsPage, TextPage, make_page
from app.participant.rating_strip import RatingStrip
from app.player.fullscreen import EscapeFilter
from app.player.video_surface import VideoSurface
from app.widgets.layout import column_of
from hapticplayer.errors import StudyError, UsageError
from hapticplayer.study.pages import Page, PageKind
from hapticplayer.study.runner import SessionRunner

GUARD_MS = 400  # a key that started the last page answers nothing on this one
WAY_BACK = "Ctrl+Shift+F10"  # three keys that nobody presses together by accident
_MEDIA_KEYS = range(Qt.Key.Key_VolumeDown, Qt.Key.Key_Launch0 + 1)


class ParticipantWindow(QWidget):
    """Shows the runner's page; whatever a person does goes to the runner.

    `refused` has why something could not be done; `operator_wanted` means that the
    operator wants the panel back where there is one screen.
    """

    refused = Signal(object)
    operator_wanted = Signal()

    def __init__(self, surface: VideoSurface) -> None:
        super().__init__()
        self.setStyleSheet(style())
        self.setWindowTitle(" ")  # seen in task switchers
        self.surface = surface
        self.content: TextPage | QuestionsPage | None = None
        self._leaving: TextPage | QuestionsPage | None = None
        self._runner: SessionRunner | None = None
        self.shown_number = -1
        self._kind = PageKind.READY
        self._drafts: dict[str, dict[str, Any]] = {}
        self._has_felt = False
        self._may_close = False
        self.pages = QStackedWidget()
        self.strip, self._clip = RatingStrip(), QWidget()
        column_of((surface, 1), self.strip, spacing=0, of=self._clip)
        surface.wheeled.connect(lambda notches, _shift: self.strip.turn(notches))
        self.pages.addWidget(self._clip)
        column_of(self.pages, of=self)
        self.guard = QTimer(self)
        self.guard.setSingleShot(True)
        self.guard.setInterval(GUARD_MS)
        self._escape = EscapeFilter(lambda: self.halt("escape"), self)
        self._escape.install()
        QShortcut(QKeySequence(WAY_BACK), self, self.operator_wanted.emit)
        application = QGuiApplication.instance()
        if isinstance(application, QGuiApplication):
            application.applicationStateChanged.connect(self._on_application_state)

    def follow(self, runner: SessionRunner) -> None:
        """Show this session from now on."""
        self._runner, self.shown_number = runner, -1
        self._drafts = {}
        self._has_felt = False
        self.refresh()

    def refresh(self) -> None:
        """Show the runner's page if it is another one than before."""
        if self._runner is None:
            return
        page = self._runner.page
        if page.number == self.shown_number:
            if page.kind is PageKind.READY and isinstance(self.content, TextPage):
                self.content.wait(self._runner.gap_s)
            return
        self._keep_draft()
        self.shown_number, self._kind = page.number, page.kind
        if page.kind is PageKind.PLAYING:
            self._has_felt = True
            self._show_clip()
        else:
            self.show_page(page)

    def _keep_draft(self) -> None:
        if isinstance(self.content, QuestionsPage):
            self._drafts[self.content.objectName()] = self.content.values()

    def _show_clip(self) -> None:
        self._drop_content()
        self.pages.setCurrentWidget(self._clip)
        self.setCursor(Qt.CursorShape.BlankCursor)
        self.surface.setFocus()
        runner = self._runner
        if runner is not None and runner.watching is not None:
            self.strip.begin(runner.watching, runner.plan.language)

    def show_page(self, page: Page) -> None:
        """Show a page in place of the one before."""
        self.strip.end()
        self.unsetCursor()
        made = self._make(page)
        self._drop_content()
        self.content = made
        made.setObjectName(page.step)
        self.pages.addWidget(made)
        self.pages.setCurrentWidget(made)
        self.guard.start()
        made.focus()

    def _drop_content(self) -> None:
        """Take the page away; it may be one of its own buttons that asks for it.

        The stack gives it back to Python, which would delete it under that button.
        """
        if self.content is not None:
            self._leaving = self.content
            self.pages.removeWidget(self.content)
            self.content.hide()
            self.content.deleteLater()
            self.content = None

    def _make(self, page: Page) -> TextPage | QuestionsPage:
        assert self._runner is not None
        draft = self._drafts.get(page.step, {})
        made = make_page(page, self._runner.maker, draft, has_felt=self._has_felt)
        if isinstance(made, QuestionsPage):
            made.finished.connect(self._answer)
            made.replay_wanted.connect(self._replay)
        else:
            made.pressed.connect(self._press)
        return made

    # --- what a person does ---------------------------------------------------

    def _press(self, name: str) -> None:
        runner = self._runner
        assert runner is not None
        actions: dict[str, Callable[[], None]] = {
            "agree": lambda: runner.consent(given=True),
            "decline": lambda: runner.consent(given=False),
            "feel": runner.demonstrate,
            "leave": runner.leave,
        }
        self._do(actions.get(name, runner.proceed))

    def _replay(self, token: str) -> None:
        runner = self._runner
        assert runner is not None
        self._do(lambda: runner.replay(token))

    def _answer(self) -> None:
        runner, page = self._runner, self.content
        if runner is None or not isinstance(page, QuestionsPage):
            return
        if self.guard.isActive():
            return
        try:
            runner.answer(page.values())
        except StudyError as problem:
            page.show_problem(problem.where, runner.maker.word("missing"))
            return
        self._drafts.pop(page.objectName(), None)
        page.setObjectName("")
        self.refresh()

    def _do(self, action: Callable[[], None]) -> None:
        if not self.guard.isActive():
            try:
                action()
                self.refresh()
            except (StudyError, UsageError) as problem:
                self.refused.emit(problem)
                self.refresh()
                word = "centre" if isinstance(problem, UsageError) else "problem"
                if isinstance(self.content, TextPage) and self._runner is not None:
                    self.content.show_problem(self._runner.maker.word(word))

    def halt(self, reason: str) -> None:
        """Take the force away at once."""
        if self._runner is not None:
            self._runner.halt(reason)
            self.refresh()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """The space bar stops a clip; media keys do nothing. Esc: see `_escape`."""
        is_playing = self._kind is PageKind.PLAYING
        if is_playing and event.key() == Qt.Key.Key_Space:
            self.halt("space")
        elif event.key() in _MEDIA_KEYS:
            event.accept()
        elif not self.strip.take_key(event, is_pressed=True):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if not self.strip.take_key(event, is_pressed=False):
            super().keyReleaseEvent(event)

    def _on_application_state(self, state: Qt.ApplicationState) -> None:
        """Another program has come in front: nobody watches the clip any more."""
        is_away = state != Qt.ApplicationState.ApplicationActive
        if is_away and self._kind is PageKind.PLAYING and self.isVisible():
            self.halt("focus_lost")

    def closeEvent(self, event: QCloseEvent) -> None:
        """Only the program closes this window; a person who tries takes a pause."""
        if self._may_close:
            event.accept()
        else:
            event.ignore()
            self.halt("window_closed")

    def close_for_good(self) -> None:
        """Close, whatever is shown."""
        self._may_close = True
        self._escape.remove()
        self.strip.end()
        self.close()

    def changeEvent(self, event: QEvent) -> None:
        """Come back from being minimised: there is nothing else to see."""
        if event.type() == QEvent.Type.WindowStateChange and self.isMinimized():
            self.showFullScreen()
        super().changeEvent(event)


def participant_screen(operator: QScreen) -> QScreen:
    """The screen of the participant's pages: another one than the operator's if there is."""
    others = [one for one in QGuiApplication.screens() if one is not operator]
    return others[0] if others else operator
