"""Getting to know a device: homing, then every force that it can make, step by step."""

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QDialog, QProgressBar, QWidget

from app.bridge.languages import translated
from app.player.force_words import homing_text, step_text
from app.player.health import device_name, stop_reason
from app.player.transport import offer_stop
from app.plots.device_picture import DevicePicture
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of
from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of, hold_text
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.playback.forces import ForcePlayer
from hapticplayer.playback.latch import STOPPED, StopLatch
from hapticplayer.rendering import demonstration

POLL_MS = 30
HOMING_AFTER_MS = 1000
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
        self.force_player: ForcePlayer | None = None
        self._unhomed_polls = 0
        entry = find_device(device)
        self._record, self._is_falcon = entry.capabilities, bool(entry.direct)
        self._track, self._steps = demonstration(self._record)
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
        """Whether a device is held."""
        return self.force_player is not None

    def begin(self) -> None:
        """Take the device and begin."""
        if self.force_player is not None:
            return
        try:
            self.force_player = ForcePlayer(
                self._clock, self._device, self._track, self._latch
            )
        except HapticPlayerError as problem:
            self._show_end(translated(message_of(problem)))
            return
        self.start_button.setEnabled(False)
        self.stop_button.setEnabled(True)
        self._timer.start()

    def stop_or_rearm(self) -> None:
        """Press the button."""
        if self.is_running:
            self.stop()
        else:
            self._latch.rearm(self._clock.now_s())
            self._show_end(self._how)

    def stop(self) -> None:
        """Take the force away until a person re-arms, and let go of the device."""
        if self.force_player is not None:
            self.force_player.stop()
            self._end(self.tr("Stopped."))

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
        player = self.force_player
        if player is None:
            return
        ticks = player.poll()
        if len(ticks):
            self.picture.show_sent(ticks, player.levels)
        if player.is_over:
            self._end(self._verdict(player))
            return
        self.progress.setValue(round(1000 * player.media_s / player.end_s))
        if player.cause is Cause.NOT_HOMED:
            self._wait_for_homing()
            self.text.setText(homing_text())
            return
        now = [s for s in self._steps if s.begin_s <= player.media_s < s.end_s]
        if now:
            self.text.setText(step_text(now[0], self._record))
        else:
            self.text.setText(
                self.tr("Pause") if player.media_s else self.tr("Starting")
            )

    def _wait_for_homing(self) -> None:
        """After a second, show how: the first answers know of no homing either."""
        self._unhomed_polls += 1
        if self._is_falcon and self._unhomed_polls * POLL_MS > HOMING_AFTER_MS:
            self.reject()
            self.homing_wanted.emit()

    def _verdict(self, player: ForcePlayer) -> str:
        if player.mode is Mode.TRIPPED:
            return stop_reason(player.cause)
        if player.media_s >= player.end_s:
            return self.tr("Demonstration finished.")
        said = translated(player.problem)
        return said or self.tr("The haptics process has ended.")

    def _end(self, text: str) -> None:
        self._timer.stop()
        player, self.force_player = self.force_player, None
        if player is not None:
            player.close()
        self._show_end(text)

    def _show_end(self, text: str) -> None:
        self.picture.set_record(self._record)
        self.text.setText(text)
        self.progress.setValue(0)
        is_held = self._latch.is_set
        self.start_button.setEnabled(not is_held)
        offer_stop(self.stop_button, is_stopped=is_held)
        self.stop_button.setEnabled(is_held)
