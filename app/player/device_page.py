"""Getting to know a device: homing, then every force that it can make, step by step."""

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QDialog, QProgressBar, QWidget

from app.bridge.languages import translated
from app.player.device_test_words import state_text, verdict_text
from app.player.health import device_name
from app.player.transport import offer_stop, rearm_problem
from app.plots.device_picture import DevicePicture
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of
from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of, hold_text
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.contract import Cause
from hapticplayer.playback.device_test import DeviceTest
from hapticplayer.playback.latch import STOPPED, StopLatch
from hapticplayer.rendering.demonstration import STRENGTHS

POLL_MS = 30
HOMING_AFTER_MS, HOMING_S = 1000, 120.0
WIDTH_PX = 460


class DevicePage(QDialog):
    """Plays the demonstration on a device of its own; STOP and Escape end it at once.

    The window has to let go of the device before. While the latch is set nothing begins,
    and the button re-arms. `homing_wanted` means that the Falcon
    does not know where its grip is; the page has closed.
    """

    homing_wanted = Signal()

    def __init__(
        self,
        clock: Clock,
        device: str,
        parent: QWidget | None = None,
        latch: StopLatch | None = None,
    ) -> None:
        super().__init__(parent)
        self._latch = latch or StopLatch()
        self._clock, self._device = clock, device
        self.test: DeviceTest | None = None
        self._unhomed_polls = 0
        entry = find_device(device)
        self._record, self._is_falcon = entry.capabilities, bool(entry.direct)
        self.picture, self.text = DevicePicture(), paragraph(is_centred=True, lines=4)
        self.progress = QProgressBar()
        self.start_button = text_button(
            self.tr("Start"),
            self.tr("Feel every direction, starting gently"),
            "primary",
        )
        self.stop_button = text_button(
            self.tr("STOP"), self.tr("Stop the force immediately (Esc)"), "stop"
        )
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)
        self.start_button.clicked.connect(self.begin)
        self.stop_button.clicked.connect(self.stop_or_rearm)
        self._lay_out()
        how = self.tr(
            "You will feel each force three times, starting gently. Esc, STOP or a button "
            "on the device stops it immediately."
        )
        hold = translated(hold_text(guide_of(entry), self._record))
        self._how = f"{hold} {how}"
        self._show_end(translated(STOPPED) if self._latch.is_set else self._how)

    @property
    def is_running(self) -> bool:
        return self.test is not None

    def begin(self) -> None:
        """Take the device and begin."""
        if self.test is not None:
            return
        try:
            self.test = DeviceTest(
                self._clock,
                self._device,
                latch=self._latch,
                homing_s=HOMING_S,
                strengths=STRENGTHS,
            )
        except HapticPlayerError as problem:
            self._show_end(translated(message_of(problem)))
            return
        self.stop_button.setEnabled(True)
        self.stop_button.setFocus()  # else it goes to what comes next: Close
        self.start_button.setEnabled(False)
        self._timer.start()

    def stop_or_rearm(self) -> None:
        """Press the button."""
        if self.is_running:
            self.stop()
        else:
            self._show_end(rearm_problem(self._latch, self._clock) or self._how)

    def stop(self) -> None:
        """Take the force away until a person re-arms, and let go of the device."""
        if self.test is not None:
            self.test.stop()
            self.test.wait()
            self._end(self.test)

    def reject(self) -> None:
        """Stop before anything else; Escape comes here too."""
        self.stop()
        super().reject()

    def _lay_out(self) -> None:
        name = device_name(self._device)
        self.setWindowTitle(self.tr("Try out the forces: {name}").format(name=name))
        self.setMinimumWidth(WIDTH_PX)
        self.progress.setTextVisible(False)
        self.progress.setRange(0, 1000)
        self.progress.setAccessibleName(self.tr("Progress"))
        close = text_button(self.tr("Close"), self.tr("Release the device"))
        close.clicked.connect(self.reject)
        buttons = row_of(self.start_button, self.stop_button, STRETCH, close)
        fill_page(self, (self.picture, 1), self.text, self.progress, buttons)

    def _poll(self) -> None:
        test = self.test
        if test is None:
            return
        ticks = test.poll()
        if len(ticks):
            self.picture.show_sent(ticks, test.levels)
        if test.is_over:
            self._end(test)
            return
        self.progress.setValue(round(1000 * test.done_s / test.end_s))
        self.text.setText(state_text(test, self._record))
        if test.cause is Cause.NOT_HOMED:
            self._wait_for_homing()

    def _wait_for_homing(self) -> None:
        """After a second, show how: the first answers know of no homing either."""
        self._unhomed_polls += 1
        if self._is_falcon and self._unhomed_polls * POLL_MS > HOMING_AFTER_MS:
            self.reject()
            self.homing_wanted.emit()

    def _end(self, test: DeviceTest) -> None:
        self._timer.stop()
        self.test = None
        self._show_end(verdict_text(test, self.tr("Demonstration finished.")))

    def _show_end(self, text: str) -> None:
        self.picture.set_record(self._record)
        self.text.setText(text)
        self.progress.setValue(0)
        is_held = self._latch.is_set
        self.start_button.setEnabled(not is_held)
        offer_stop(self.stop_button, is_stopped=is_held)
        if self.stop_button.hasFocus() and not is_held:
            self.start_button.setFocus()
        self.stop_button.setEnabled(is_held)
