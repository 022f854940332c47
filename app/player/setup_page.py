"""Setting a device up: choosing it, its firmware, and homing with a live drawing."""

from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QComboBox, QDialog, QLabel, QProgressBar, QWidget

from app.bridge.jobs import Jobs
from app.bridge.jobs import Progress as Report
from app.player import choices, setup_texts
from app.player.choices import PluggedFalcons
from app.player.firmware_dialog import ask_for_firmware
from app.player.homing_view import HomingDrawing, TravelEstimate, view_of
from app.player.setup_texts import Trouble, trouble
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of
from app.widgets.texts import PERCENT
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.devices.falcon.reach import Reach, reach_of
from hapticplayer.devices.falcon.setting_up import Progress, Step, set_up

POLL_MS = 33
LOOK_MS = 1000
"""Period of looking for devices and of retries."""


class SetupPage(QDialog):
    """Holds a Falcon, without force, until a person is done with it.

    The window has to let go of the device before.
    """

    wanted = Signal(str)
    demonstration_wanted = Signal(str)

    def __init__(
        self,
        clock: Clock,
        device: str,
        plugged: PluggedFalcons,
        parent: QWidget | None = None,
        find_reach: Callable[[str], Reach] = reach_of,
    ) -> None:
        super().__init__(parent)
        self._clock, self._find_reach, self._plugged = clock, find_reach, plugged
        self._jobs = Jobs(self._on_trouble)
        self._progress: Progress | None = None
        self._trouble: Trouble | None = None
        self._ways, self._result = TravelEstimate(), 0
        self._is_ending = False
        self.drawing, self.device = HomingDrawing(), QComboBox()
        self.title = paragraph(is_centred=True)
        self.text, self.bar = paragraph(is_centred=True, lines=4), QProgressBar()
        self._make_buttons()
        self._lay_out()
        self._fill(device if device != NO_DEVICE else plugged.falcons()[0][0])
        plugged.changed.connect(self._on_plugged)
        self.device.activated.connect(lambda _: self.begin())
        self._poll_timer = self._timer(POLL_MS, self._poll)
        self._look_timer = self._timer(LOOK_MS, self._look)
        self._look()
        self._show()

    @property
    def chosen(self) -> str:
        """The engine's name of the device that is chosen here."""
        return str(self.device.currentData())

    @property
    def is_ready(self) -> bool:
        """Whether the device can be used as it is."""
        if not _is_falcon(self.chosen):
            return True
        return self._progress is not None and self._progress.step is Step.READY

    @property
    def is_busy(self) -> bool:
        """Whether a Falcon is held, or about to be."""
        return self._jobs.is_busy

    def begin(self) -> None:
        """Take the chosen device, once the one before is let go of."""
        self._progress, self._trouble, self._ways = None, None, TravelEstimate()
        self._jobs.cancel()
        self._start()
        self._show()

    def choose_firmware(self) -> None:
        """Ask for the firmware's file."""
        ask_for_firmware(self, self.begin, self.on_no_firmware)

    def freeze(self, progress: Progress) -> None:
        """Freeze this state, for a screenshot."""
        self._look_timer.stop()
        self._poll_timer.stop()
        self._jobs.close()
        self._progress, self._trouble = progress, None
        self._show()

    def done(self, result: int) -> None:
        """Close, but not before the Falcon is let go of."""
        self._look_timer.stop()
        self._is_ending, self._result = True, result
        self._jobs.cancel()
        if self._jobs.is_busy:
            self.hide()
        else:
            self._finish()

    def _finish(self) -> None:
        self._poll_timer.stop()
        super().done(self._result)

    # --- building ------------------------------------------------------------

    def _timer(self, period_ms: int, slot: Callable[[], None]) -> QTimer:
        timer = QTimer(self)
        timer.setInterval(period_ms)
        timer.timeout.connect(slot)
        timer.start()
        return timer

    def _make_buttons(self) -> None:
        self.firmware = text_button(
            self.tr("Firmware file\u2026"), self.tr("Install your copy of the firmware")
        )
        self.forces = text_button(
            self.tr("Try out the forces\u2026"),
            self.tr("Feel every direction, starting gently"),
        )
        self.use = text_button(
            self.tr("Use this device"), self.tr("Use it for playback"), "primary"
        )
        self.close_button = text_button(
            self.tr("Close"), self.tr("Keep the current device")
        )
        self.firmware.clicked.connect(self.choose_firmware)
        self.forces.clicked.connect(self._on_forces)
        self.use.clicked.connect(self._on_use)
        self.close_button.clicked.connect(self.reject)

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Set up the device"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.device.setAccessibleName(self.tr("Device"))
        self.title.setFont(theme.scaled(self.font(), 1.4, bold=True))
        self.bar.setRange(0, 100)
        self.bar.setFormat(PERCENT)
        self.bar.setAccessibleName(self.tr("Progress"))
        # two of the title's: a window that is open does not grow for a second one
        self.title.setMinimumHeight(2 * QFontMetrics(self.title.font()).lineSpacing())
        caption = QLabel(self.tr("Device"))
        caption.setBuddy(self.device)
        fill_page(
            self,
            row_of(caption, (self.device, 1)),
            (self.drawing, 1),
            self.title,
            self.text,
            self.bar,
            row_of(self.firmware, self.forces, STRETCH, self.close_button, self.use),
        )

    def _fill(self, current: str) -> None:
        self.device.clear()
        for choice in choices.devices(current, self._plugged.falcons()):
            if choice.name != NO_DEVICE:
                self.device.addItem(choice.text, choice.name)
        self.device.setCurrentIndex(max(0, self.device.findData(current)))

    # --- what happens --------------------------------------------------------

    def _look(self) -> None:
        """Look at the bus, and try again what may work by now."""
        self._plugged.refresh()
        self._start()

    def _start(self) -> None:
        is_stuck = self._trouble is not None and not self._trouble.is_watched
        if self._jobs.is_busy or is_stuck or not _is_falcon(self.chosen):
            return
        reach = self._find_reach(self.chosen)

        def work(report: Report) -> None:
            def show(progress: Progress) -> None:
                report(progress.loaded, "")
                self._progress = progress

            set_up(reach, self._clock, show)

        self._jobs.run("", work, lambda _none: None)

    def _poll(self) -> None:
        self._jobs.poll()
        if self._is_ending:
            if not self._jobs.is_busy:
                self._finish()
            return
        if self._progress is not None and self._progress.step is not Step.CONNECTING:
            self._trouble = None
        if self._trouble is None:
            self._start()
        self._show()

    def _on_trouble(self, problem: BaseException) -> None:
        self._progress, self._trouble, self._ways = (
            None,
            trouble(problem),
            TravelEstimate(),
        )

    def on_no_firmware(self, why: str) -> None:
        """Show why a file is not a firmware image."""
        self._trouble = Trouble(self.tr("That file cannot be used"), why, False)

    def _on_plugged(self) -> None:
        self._fill(self.chosen)

    def _on_use(self) -> None:
        self.wanted.emit(self.chosen)
        self.accept()

    def _on_forces(self) -> None:
        self.demonstration_wanted.emit(self.chosen)
        self.accept()

    # --- what is shown -------------------------------------------------------

    def _show(self) -> None:
        is_falcon, progress = _is_falcon(self.chosen), self._progress
        self.drawing.setVisible(is_falcon)
        self.firmware.setVisible(is_falcon)
        for button in (self.forces, self.use):
            button.setEnabled(self.is_ready)
        loading = progress is not None and progress.step is Step.LOADING
        self.bar.setVisible(loading)
        if not is_falcon:
            self._say(*setup_texts.needs_nothing(self.chosen))
            return
        if self._trouble is not None:
            self.drawing.show_view(view_of(None, self._ways))
            self._say(self._trouble.title, self._trouble.text, theme.WARN)
            return
        progress = progress or Progress(Step.CONNECTING)
        self.bar.setValue(round(100 * progress.loaded))
        self.drawing.show_view(view_of(progress, self._ways))
        colour = theme.GOOD if progress.step is Step.READY else theme.TEXT
        self._say(setup_texts.advice(progress), setup_texts.more(progress), colour)

    def _say(self, title: str, text: str, colour: str = "") -> None:
        if (title, text) != (self.title.text(), self.text.text()):
            self.title.setStyleSheet(f"color: {colour or theme.TEXT};")
            self.title.setText(title)
            self.text.setText(text)


def _is_falcon(device: str) -> bool:
    return device.startswith("falcon")
