"""Setting a device up: what it is and needs, its firmware, homing with a live drawing."""

from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QDialog, QLabel, QProgressBar, QWidget

from app.bridge.jobs import Jobs
from app.bridge.languages import translated
from app.bridge.settings import Settings
from app.player import setup_texts
from app.player.check_list import CheckList
from app.player.choices import PluggedFalcons
from app.player.device_form import DeviceForm, entry_of, problem_of
from app.player.device_test_panel import DeviceTestPanel
from app.player.firmware_dialog import ask_for_firmware
from app.player.homing_view import HomingDrawing, TravelEstimate, view_of
from app.player.latency_field import LatencyField
from app.player.setup_texts import DeviceProblem, describe_problem
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    column_of,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
    scrolling,
)
from app.widgets.texts import PERCENT, breakable
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, takes_motion
from hapticplayer.devices.falcon.reach import Reach, reach_of
from hapticplayer.devices.falcon.setting_up import Progress, Step, set_up
from hapticplayer.devices.guides import guide_of
from hapticplayer.errors import Progress as Report
from hapticplayer.errors import message_of
from hapticplayer.playback.latch import StopLatch

POLL_MS = 33
LOOK_MS = 1000
"""Period of looking for Falcons and of retries."""
_WIDTH_PX, _HEIGHT_PX, _SETTINGS_PX = 900, 500, 160


def _always() -> bool:
    return True


class SetupPage(QDialog):
    """What a device is and needs; holds a Falcon, without force, until one is done with it.

    The window has to let go of its devices before; `is_free` is whether they are at rest.

    Signals:
        wanted: a device is to be used.
        demonstration_wanted: its forces are to be felt.
        others_wanted: the list of outputs is wanted, once this page has closed.
        latency_changed: another latency is compensated from here on.
    """

    wanted = Signal(str)
    demonstration_wanted = Signal(str)
    others_wanted = Signal()
    latency_changed = Signal()

    def __init__(  # noqa: PLR0913 - three of them only tests and lists have
        self,
        clock: Clock,
        device: str,
        plugged: PluggedFalcons,
        settings: Settings,
        parent: QWidget | None = None,
        find_reach: Callable[[str], Reach] = reach_of,
        *,
        is_free: Callable[[], bool] = _always,
        with_gain: Callable[[str], str] = str,
        latch: StopLatch | None = None,
    ) -> None:
        super().__init__(parent)
        self._is_lent_free, self._with_gain = is_free, with_gain
        self._clock, self._find_reach, self._plugged = clock, find_reach, plugged
        self._jobs = Jobs(self._on_trouble)
        self._progress: Progress | None = None
        self._trouble: DeviceProblem | None = None
        self._ways, self._result = TravelEstimate(), 0
        self._is_ending = False
        self.drawing, self.form = HomingDrawing(), DeviceForm(self)
        self.panel = DeviceTestPanel(clock, self._is_free, latch)
        self.device = self.form.kind
        self.title = paragraph()
        self.what, self.text = paragraph(lines=2), paragraph(lines=4)
        self.checks, self.bar = CheckList(self), QProgressBar()
        self.latency = LatencyField(settings, self)
        self._make_buttons()
        self._lay_out()
        start = device if device != NO_DEVICE else plugged.falcons()[0][0]
        self.form.fill(start, plugged.falcons())
        plugged.changed.connect(self._on_plugged)
        self.form.changed.connect(self.begin)
        self._poll_timer = self._timer(POLL_MS, self._poll)
        self._look_timer = self._timer(LOOK_MS, self._look)
        self.panel.began.connect(self._jobs.cancel)
        self.panel.ended.connect(self._on_test_ended)
        self.panel.measured.connect(self.latency.take)
        self.latency.changed.connect(self.latency_changed)
        self._follow()
        self._look()
        self._show()

    @property
    def chosen(self) -> str:
        return self.form.name

    @property
    def is_ready(self) -> bool:
        """Whether the device can be used as it is."""
        if not _is_falcon(self.chosen):
            is_missing = self.checks.is_met is False
            return problem_of(self.chosen) is None and not is_missing
        return self._progress is not None and self._progress.step is Step.READY

    @property
    def is_busy(self) -> bool:
        """Whether a device is held, or about to be, or something is looked at."""
        return self._jobs.is_busy or self.checks.is_busy or self.panel.is_running

    def begin(self) -> None:
        """Take the chosen device, once the one before is let go of."""
        self._progress, self._trouble, self._ways = None, None, TravelEstimate()
        self._jobs.cancel()
        self._follow()
        self._start()
        self._show()

    def choose_firmware(self) -> None:
        ask_for_firmware(self, self.begin, self.on_no_firmware)

    def freeze(self, progress: Progress) -> None:
        """Freeze this state, for a screenshot."""
        self._look_timer.stop()
        self._poll_timer.stop()
        self._jobs.close()
        self._progress, self._trouble = progress, None
        self._show()

    def reject(self) -> None:
        """Stop a test before anything else; Escape comes here too."""
        if self.panel.is_acting:
            self.panel.stop()
        else:
            super().reject()

    def close_jobs(self) -> None:
        """End what still moves, and what is looked at: the window closes."""
        self.panel.stop()
        self.panel.wait()
        self.checks.close()

    def done(self, result: int) -> None:
        """Close, but not before the device is let go of."""
        self.panel.stop()
        self._look_timer.stop()
        self._is_ending, self._result = True, result
        self._jobs.cancel()
        self.checks.stop()
        if self.is_busy:
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
        self.others = text_button(
            self.tr("Outputs\u2026"), self.tr("Play on several devices at once")
        )
        self.close_button = text_button(
            self.tr("Close"), self.tr("Keep the current device")
        )
        self.firmware.clicked.connect(self.choose_firmware)
        self.forces.clicked.connect(self._on_forces)
        self.use.clicked.connect(self._on_use)
        self.others.clicked.connect(self._on_others)
        self.close_button.clicked.connect(self.reject)

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Set up the device"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.title.setFont(theme.scaled(self.font(), 1.4, bold=True))
        self.bar.setRange(0, 100)
        self.bar.setFormat(PERCENT)
        self.bar.setAccessibleName(self.tr("Progress"))
        caption = QLabel(self.tr("Device"))
        caption.setBuddy(self.device)
        self.title.setMinimumHeight(QFontMetrics(self.title.font()).lineSpacing())
        pictures = column_of((self.drawing, 1), (self.panel, 1), spacing=8)
        said = column_of(
            *(self.title, self.what, self.text, self.checks.label, self.bar, STRETCH),
            spacing=8,
        )
        latency = self.latency
        words = column_of(
            (scrolling(said), 1),
            row_of(latency.caption, latency.number, (latency.source, 1)),
            spacing=8,
        )
        self.form.settings.setMinimumWidth(_SETTINGS_PX)
        fill_page(
            self,
            row_of(
                caption, (self.device, 1), self.form.caption, (self.form.settings, 2)
            ),
            (row_of((pictures, 1), (words, 1), spacing=16), 1),
            row_of(
                *(self.firmware, self.forces, self.others, STRETCH),
                *(self.close_button, self.use),
            ),
        )
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)

    # --- what happens --------------------------------------------------------

    def _look(self) -> None:
        """Look at the bus, and try again what may work by now."""
        self._plugged.refresh()
        self._start()

    def _start(self) -> None:
        is_stuck = self._trouble is not None and not self._trouble.is_watched
        is_held = self._jobs.is_busy or self.panel.is_running
        if is_held or is_stuck or not _is_falcon(self.chosen):
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
            if not self.is_busy:
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
            describe_problem(problem),
            TravelEstimate(),
        )

    def on_no_firmware(self, why: str) -> None:
        self._trouble = DeviceProblem(self.tr("That file cannot be used"), why, False)

    def _on_plugged(self) -> None:
        self.form.fill(self.chosen, self._plugged.falcons())

    def _follow(self) -> None:
        """Look at what is chosen, unless its name is not right."""
        is_right = problem_of(self.chosen) is None
        self.checks.follow(self.chosen if is_right else "")
        if is_right:
            self.panel.set_device(self._with_gain(self.chosen))
            self.latency.follow(self.chosen)
        else:
            self.latency.number.setEnabled(False)

    def _is_free(self) -> bool:
        """Whether this page and the window have let go of the device."""
        self._jobs.poll()
        return not self._jobs.is_busy and self._is_lent_free()

    def _on_test_ended(self) -> None:
        self._progress = None
        self._show()

    def _on_others(self) -> None:
        self.others_wanted.emit()
        self.reject()

    def _on_use(self) -> None:
        self.wanted.emit(self.chosen)
        self.accept()

    def _on_forces(self) -> None:
        self.demonstration_wanted.emit(self.chosen)
        self.accept()

    # --- what is shown -------------------------------------------------------

    def _show(self) -> None:
        is_falcon, progress = _is_falcon(self.chosen), self._progress
        is_testing = self.panel.is_running
        self.firmware.setVisible(is_falcon)
        self.drawing.setVisible(is_falcon and not is_testing)
        self.panel.picture.setVisible(is_testing or not is_falcon)
        self.device.setEnabled(not is_testing)
        self.form.settings.setEnabled(not is_testing)
        self.forces.setVisible(not takes_motion(self.chosen))
        for button in (self.forces, self.use):
            button.setEnabled(self.is_ready and not is_testing)
        self.panel.test_button.setEnabled(self.is_ready and not is_testing)
        loading = progress is not None and progress.step is Step.LOADING
        self.bar.setVisible(loading)
        guide = guide_of(entry_of(self.chosen))
        self.what.setText(translated(guide.what))
        connect = translated(guide.connect)
        if is_testing:
            self._say(self.tr("Test"), theme.TEXT, connect)
            return
        if not is_falcon:
            self._say(*self._state(), connect)
            return
        if self._trouble is not None:
            self.drawing.show_view(view_of(None, self._ways))
            self._say(self._trouble.title, theme.WARN, self._trouble.text)
            return
        progress = progress or Progress(Step.CONNECTING)
        self.bar.setValue(round(100 * progress.loaded))
        self.drawing.show_view(view_of(progress, self._ways))
        colour = theme.GOOD if progress.step is Step.READY else theme.TEXT
        more = setup_texts.more(progress) or connect
        self._say(setup_texts.advice(progress), colour, more)

    def _state(self) -> tuple[str, str]:
        """Return how far a device is that is not led through homing, and its colour."""
        if problem := problem_of(self.chosen):
            return breakable(translated(message_of(problem))), theme.WARN
        found, is_met = self.checks.found, self.checks.is_met
        if found is None:
            return self.tr("Looking for the device"), theme.TEXT
        if is_met is False:
            return self.tr("Not ready yet"), theme.WARN
        if not found:
            return self.tr("No setup needed"), theme.TEXT
        return self.tr("Ready to be tested"), theme.GOOD if is_met else theme.TEXT

    def _say(self, title: str, colour: str, text: str) -> None:
        if (title, text) != (self.title.text(), self.text.text()):
            self.title.setStyleSheet(f"color: {colour};")
            self.title.setText(title)
            self.text.setText(text)


def _is_falcon(device: str) -> bool:
    return bool(entry_of(device).direct)
