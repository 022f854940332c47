"""Tests a device after asking, with a picture of what it is sent."""

from collections.abc import Callable

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QProgressBar, QWidget

from app.bridge.languages import translated
from app.player.device_test_words import question_text, state_text, verdict_text
from app.player.question import Question, ask
from app.player.transport import offer_stop, rearm_problem
from app.plots.device_picture import DevicePicture
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import column_of, paragraph, row_of
from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.playback.device_test import DeviceTest
from hapticplayer.playback.latch import StopLatch

POLL_MS = 33
_WHOLE = 1000


def _always() -> bool:
    return True


class DeviceTestPanel(QWidget):
    """Picture, what is done now, how far it is, and STOP.

    Args:
        clock: of the machine.
        is_free: whether nobody else holds the device; a test waits until then.
        latch: of the stop; while it is set nothing is tested.

    Signals:
        began: a person has agreed; the window has to let go of the device now.
        ended: the device can be opened by others again.
        measured: the device's latency, s.
    """

    began = Signal()
    ended = Signal()
    measured = Signal(float)

    def __init__(
        self,
        clock: Clock,
        is_free: Callable[[], bool] = _always,
        latch: StopLatch | None = None,
    ) -> None:
        super().__init__()
        self._latch = latch or StopLatch()
        self._clock, self.is_free = clock, is_free
        self._name, self._is_waiting, self._had_focus = "", False, False
        self.test: DeviceTest | None = None
        self.question: Question | None = None
        self.picture, self.progress = DevicePicture(), QProgressBar()
        self.state = paragraph("", theme.DIM, lines=2)
        self.test_button = text_button(
            self.tr("Test\u2026"), self.tr("Moves it gently; asks first")
        )
        self.stop_button = text_button(
            self.tr("STOP"), self.tr("Stop the force immediately (Esc)"), "stop"
        )
        self.progress.setRange(0, _WHOLE)
        self.progress.setTextVisible(False)
        self.progress.setAccessibleName(self.tr("Progress of the test"))
        self.test_button.clicked.connect(self.ask)
        self.stop_button.clicked.connect(self.stop_or_rearm)
        buttons = row_of(self.test_button, self.stop_button, (self.progress, 1))
        column_of((self.picture, 1), self.state, buttons, spacing=8, of=self)
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self.poll)
        self._show_buttons()

    @property
    def is_running(self) -> bool:
        """Whether a device is tested, or about to be, or comes to rest after it."""
        return self.test is not None or self._is_waiting

    @property
    def is_acting(self) -> bool:
        """Whether a device is tested, or about to be: what STOP ends."""
        return self._is_waiting or (self.test is not None and self.test.is_acting)

    def set_device(self, name: str) -> None:
        """Show another device at rest; not while one is tested."""
        if not self.is_running:
            self._name = name
            self.picture.set_record(find_device(name).capabilities)
            self.state.setText("")
            self.progress.setValue(0)

    def ask(self) -> None:
        """Say what will happen; the test begins when a person agrees."""
        if self.is_running:
            return
        try:
            self._latch.refuse()
            text = question_text(self._name)
        except HapticPlayerError as problem:
            self.state.setText(translated(message_of(problem)))
            self._show_buttons()
            return
        title, yes = self.tr("Test the device"), self.tr("Start the test")
        self.question = ask(self, title, text, yes, self.begin)

    def begin(self) -> None:
        """Test the device, once nobody else holds it."""
        self._is_waiting, self._had_focus = True, False
        self.state.setStyleSheet(f"color: {theme.TEXT};")
        self.state.setText(self.tr("Waiting until the device is at rest"))
        self._show_buttons()
        self.stop_button.setFocus()
        self.began.emit()
        self._timer.start()

    def stop_or_rearm(self) -> None:
        """Press the button: end what is acting, or re-arm the force."""
        if self.is_acting:
            self.stop()
        else:
            self.state.setText(rearm_problem(self._latch, self._clock))
            self._show_buttons()

    def stop(self) -> None:
        """Take the force away at once; the device is let go of."""
        if self._is_waiting:
            self._latch.stop()
            self._is_waiting = False
            self._end(self.tr("Stopped."))
        elif self.test is not None:
            self.test.stop()
            self.poll()

    def wait(self) -> None:
        """Wait until the device is let go of, after `stop`."""
        if self.test is not None:
            self.test.wait()
            self.poll()

    def poll(self) -> None:
        """Go on, and show what is done."""
        if self._is_waiting:
            if self.is_free():
                self._start()
            return
        test = self.test
        if test is None:
            return
        ticks = test.poll()
        if len(ticks):
            self.picture.show_sent(ticks, test.levels)
        self.progress.setValue(round(_WHOLE * test.done_s / test.end_s))
        if test.is_over:
            self._finish(test)
        elif test.is_acting:
            record = find_device(self._name).capabilities
            self._say(state_text(test, record))
        else:
            self._say(self.tr("Coming to rest"))

    def _start(self) -> None:
        self._is_waiting = False
        try:
            self.test = DeviceTest(self._clock, self._name, latch=self._latch)
        except HapticPlayerError as problem:
            self._end(translated(message_of(problem)), theme.WARN)

    def _finish(self, test: DeviceTest) -> None:
        self.test = None
        self._end(verdict_text(test), theme.WARN if test.problem else theme.DIM)
        if (latency_s := test.latency_s) is not None:
            self.measured.emit(latency_s)

    def _end(self, text: str, colour: str = "") -> None:
        self._timer.stop()
        self.state.setStyleSheet(f"color: {colour or theme.DIM};")
        self.picture.set_record(find_device(self._name).capabilities)
        self.state.setText(text)
        self.progress.setValue(0)
        self._show_buttons()
        if self._had_focus:
            self.test_button.setFocus()
        self.ended.emit()

    def _say(self, text: str) -> None:
        if text != self.state.text():
            self.state.setText(text)
        self._show_buttons()

    def _show_buttons(self) -> None:
        is_there = self.window().focusWidget() is self.stop_button
        self._had_focus = self._had_focus or is_there
        self.test_button.setEnabled(not self.is_running)
        is_held = self._latch.is_set and not self.is_acting
        offer_stop(self.stop_button, is_stopped=is_held)
        self.stop_button.setEnabled(self.is_acting or is_held)
