"""The outputs: all that plays, in order, each with all that can be chosen of it."""

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication, Qt, QTimer, Signal
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QLabel,
    QLineEdit,
    QWidget,
)

from app.bridge.languages import translated
from app.bridge.settings import MOST_OUTPUTS
from app.player import choices
from app.player.device_form import (
    example_of,
    output_text,
    put_together,
    takes_settings,
    variants,
)
from app.player.device_test_panel import DeviceTestPanel
from app.player.health import mode_text
from app.player.latency_field import source_text
from app.player.session import Session
from app.player.transport import offer_stop
from app.widgets import theme
from app.widgets.buttons import Button, text_button
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    captioned,
    column_of,
    fill_page,
    indent,
    keep_width,
    paragraph,
    resize_within_screen,
    row_of,
    scrolling,
)
from app.widgets.level_meter import LevelMeter
from app.widgets.texts import titled
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, takes_motion
from hapticplayer.devices.options import GAIN, LATENCY_MS
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.latency import LatencySource
from hapticplayer.playback.snapshot import OutputSnapshot, Snapshot

translate = QCoreApplication.translate

POLL_MS = 100
GENTLE_GAIN = 0.25
_GAIN_STEP, _LATENCY_STEP_MS = 0.05, 5.0
_WIDTH_PX, _HEIGHT_PX = 640, 520


def state_text(output: OutputSnapshot) -> str:
    """The state of an output, or its problem."""
    if output.problem or output.health in (Health.FAILED, Health.GONE):
        return translated(output.problem) or translate("Health", "failed")
    if output.health is Health.STARTING:
        return translate("Health", "starting")
    if (what := output.note or output.fault) and not output.is_muted:
        return translated(what)
    return mode_text(output.mode)


class NumberBox(QDoubleSpinBox):
    """A number that takes effect when it is complete, and scrolls with its page."""

    def __init__(self, name: str, decimals: int, step: float) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setDecimals(decimals)
        self.setSingleStep(step)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def follow(self, value: float) -> None:
        """Show what is, but not over what is being typed."""
        if not self.hasFocus():
            self.blockSignals(True)
            self.setValue(value)
            self.blockSignals(False)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """A turn of the wheel over it is meant for the page."""
        event.ignore()


@dataclass
class OutputRow:
    """The widgets of an output."""

    state: QLabel
    gain: NumberBox
    latency: NumberBox
    mute: QCheckBox
    test: QWidget
    meter: LevelMeter

    def show_output(self, output: OutputSnapshot, *, may_test: bool) -> None:
        self.state.setText(state_text(output))
        self.gain.follow(output.gain)
        self.latency.follow(1e3 * output.latency_s)
        source = output.latency_source
        self.latency.setPrefix("\u2248\u2009" * (source is LatencySource.ASSUMED))
        self.latency.setEnabled(source is not LatencySource.SETTINGS)
        tip = translate("OutputsPage", "Latency that is compensated ({source})")
        self.latency.setToolTip(tip.format(source=source_text(source)))
        self.mute.setChecked(output.is_muted)
        self.meter.show_levels(output.levels)
        self.test.setEnabled(may_test)


class OutputsPage(QDialog):
    """Stays beside the window; what stops the force there stops a test here, too.

    Signals:
        changed: a person has chosen others or another order, gain or mute.
        latency_entered: of an output, ms.
        set_up_wanted: the set-up page of one is wanted.
    """

    changed = Signal()
    latency_entered = Signal(str, float)
    set_up_wanted = Signal(str)

    def __init__(
        self, clock: Clock, session: Session, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._clock, self._session, self._player = clock, session, session.player
        session.stopped.connect(self.end_test)
        self._tested = ""
        self.panel = DeviceTestPanel(clock, self._is_free, session.player.latch)
        self._shown: list[str] | None = None
        self.rows: dict[str, OutputRow] = {}
        self._list, self.problem = (
            column_of(spacing=4),
            paragraph("", theme.DIM, lines=2),
        )
        self.kind, self.address = QComboBox(), QLineEdit()
        self._make_form()
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self.look)
        self._timer.start()
        self.look()

    # --- what a person does --------------------------------------------------

    def add(self) -> None:
        """Play on the device of the form as well."""
        choice = str(self.kind.currentData())
        name = put_together(choice, self.address.text().strip())
        names = self._player.output_names
        if name in names:
            self._say(self.tr("This device is already in use"))
        elif not name.isprintable():
            self._say(self.tr("Settings may contain letters, digits and punctuation"))
        elif len(names) >= MOST_OUTPUTS:
            self._say(self.tr("No more devices can be added; remove one first"))
        elif self._use([*names, name]) and takes_motion(name):
            self.set_gain(name, GENTLE_GAIN)

    def remove(self, name: str) -> None:
        """Bring an output to rest and let go of it."""
        self._use([one for one in self._player.output_names if one != name])

    def move_up(self, name: str) -> None:
        """Put an output before the one above it; the first one leads."""
        names = self._player.output_names
        place = names.index(name)
        names.insert(max(0, place - 1), names.pop(place))
        self._use(names)

    def mute(self, name: str, *, is_muted: bool) -> None:
        """Let an output come to rest, or play again."""
        self._player.set_output(name, is_muted=is_muted)
        self.changed.emit()

    def set_gain(self, name: str, gain: float) -> None:
        """Multiply what an output plays, also while it plays."""
        self._player.set_output(name, gain=gain)
        self.look()
        self.changed.emit()

    def test(self, name: str) -> None:
        """Test an output gently, after asking; nothing else plays on it meanwhile."""
        if not self.panel.is_running:
            self._tested = name
            now = self._player.snapshot()
            self.panel.set_device(next(o.device for o in now.outputs if o.name == name))
            self.panel.ask()
            self._say(self.panel.state.text())

    def end_test(self) -> None:
        """Let what is tested come to rest."""
        self.panel.stop()

    def _on_test_begun(self) -> None:
        self._show_panel(is_wanted=True)
        self.stop_button.setFocus()
        self._player.lend_outputs(self._tested)

    def _is_free(self) -> bool:
        return self._player.are_outputs_free

    def _on_test_ended(self) -> None:
        """Let the output play again, and say how the test has ended."""
        self._show_panel(is_wanted=False)
        self._say(self.panel.state.text())
        try:
            self._player.take_back_outputs(self._tested)
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))

    def _show_panel(self, *, is_wanted: bool) -> None:
        """Show the picture of a test in the place of rows and form."""
        self.heading.setText(output_text(self._tested) if is_wanted else self._text())
        self.panel.setVisible(is_wanted)
        for part in (self._scroll, self._form):
            part.setHidden(is_wanted)

    def reject(self) -> None:
        """Stop before anything else; Escape comes here too."""
        self._session.stop()
        super().reject()

    def done(self, result: int) -> None:
        """Close; the outputs play on."""
        self.end_test()
        self._timer.stop()
        self.panel.wait()
        super().done(result)

    def close_jobs(self) -> None:
        """End what still moves: the window closes."""
        self.end_test()

    # --- what is shown -------------------------------------------------------

    def look(self) -> None:
        """Show what has changed."""
        now = self._player.snapshot()
        names = [output.name for output in now.outputs]
        if names != self._shown:
            self._shown = names
            self._fill_rows(now)
        is_playing = now.is_playing and self.panel.is_acting
        if is_playing or (self.panel.is_running and self._tested not in names):
            self.end_test()
        offer_stop(self.stop_button, is_stopped=now.is_stopped)
        may_test = not (now.is_playing or self.panel.is_running)
        for output in now.outputs:
            self.rows[output.name].show_output(output, may_test=may_test)

    def _use(self, names: list[str]) -> bool:
        """Play on these; return whether that can be."""
        try:
            self._player.set_outputs(names)
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))
            return False
        self._session.changed.emit()
        self._say("")
        self.look()
        self.changed.emit()
        return True

    def _say(self, text: str) -> None:
        self.problem.setText(text)

    def _make_form(self) -> None:
        for choice in (*variants(), *choices.devices()):
            if choice.name != NO_DEVICE:
                self.kind.addItem(choice.text, choice.name)
        self.kind.currentIndexChanged.connect(self._on_kind)
        self._on_kind()

    def _on_kind(self) -> None:
        choice = str(self.kind.currentData())
        takes_text = takes_settings(choice)
        self.address.setEnabled(takes_text)
        self.address.setPlaceholderText(example_of(choice))
        if not takes_text:
            self.address.clear()

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Outputs"))
        self.setMinimumWidth(_WIDTH_PX)
        add = text_button(self.tr("Add"), self.tr("Also play on this device"))
        add.clicked.connect(self.add)
        self.address.returnPressed.connect(self.add)
        self.stop_button = text_button(
            self.tr("STOP"), self.tr("Stop all of them (Esc)"), "stop"
        )
        self.stop_button.clicked.connect(self._session.stop_or_rearm)
        close = text_button(self.tr("Close"), self.tr("The devices keep playing"))
        close.clicked.connect(self.accept)
        where = captioned(self.tr("Address or settings"), self.address)
        caption, _ = captioned(self.tr("Device to add"), self.kind)
        caption.hide()  # it names the list for screen readers
        self.heading = paragraph(self._text(), lines=2)
        self.list_end = paragraph("", theme.DIM)
        self._scroll = scrolling(column_of(self._list, self.list_end, STRETCH))
        self._form = QWidget()
        column_of(
            row_of(caption, (self.kind, 1), add),
            row_of(where[0], (self.address, 1)),
            self.problem,
            spacing=12,
            of=self._form,
        )
        self.panel.test_button.hide()  # each row has its own, and STOP is that of all
        self.panel.stop_button.hide()
        self.panel.began.connect(self._on_test_begun)
        self.panel.ended.connect(self._on_test_ended)
        self.panel.hide()
        fill_page(
            self,
            self.heading,
            (self._scroll, 1),
            (self.panel, 2),
            self._form,
            row_of(self.stop_button, STRETCH, close),
        )
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)

    def _text(self) -> str:
        return self.tr(
            "All of these play at once and stop at once. The first one leads: its "
            "position is shown and its buttons count. A rig moves with the motion of the "
            "recording: begin with a small gain."
        )

    def _fill_rows(self, now: Snapshot) -> None:
        while (item := self._list.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        self.rows = {one.name: self._add_row(one.name) for one in now.outputs}
        is_empty = self.tr("Nothing plays yet. Choose a device below and press Add.")
        self.list_end.setText("" if now.outputs else is_empty)
        keep_width(self._scroll)

    def _add_row(self, name: str) -> OutputRow:
        text = output_text(name)
        label = ElidedLabel(text, elide=Qt.TextElideMode.ElideMiddle)
        label.setToolTip(text)
        buttons = self._buttons_of(name)
        made = OutputRow(
            paragraph("", theme.DIM),
            self._gain_of(name),
            self._latency_of(name),
            QCheckBox(self.tr("Mute")),
            buttons[2],
            LevelMeter(text),
        )
        made.mute.clicked.connect(lambda on: self.mute(name, is_muted=on))
        for widget in (made.mute, *buttons):
            widget.setAccessibleName(
                titled(text, widget.accessibleName() or widget.text())
            )
        for box in (made.gain, made.latency):
            indent(box)
            box.setAccessibleName(titled(text, box.accessibleName()))
        gain = captioned(self.tr("Gain"), made.gain)
        latency = captioned(self.tr("Latency"), made.latency)
        whole = QWidget()
        column_of(
            row_of((label, 1), made.mute, *buttons[:2]),
            row_of(*gain, *latency, STRETCH, *buttons[2:]),
            made.state,
            made.meter,
            spacing=6,
            margins=(0, 0, 0, 10),
            of=whole,
        )
        self._list.addWidget(whole)
        return made

    def _gain_of(self, name: str) -> NumberBox:
        box = NumberBox(self.tr("Gain"), 2, _GAIN_STEP)
        box.setRange(GAIN.least, GAIN.largest)
        box.setPrefix("\u00d7\u2009")
        box.setToolTip(self.tr("Multiplies everything that this output plays"))
        box.valueChanged.connect(lambda gain: self.set_gain(name, gain))
        return box

    def _latency_of(self, name: str) -> NumberBox:
        box = NumberBox(self.tr("Latency"), 0, _LATENCY_STEP_MS)
        box.setRange(LATENCY_MS.least, LATENCY_MS.largest)
        box.setPrefix("\u2248\u2009")  # room for it
        box.setSuffix("\u00a0ms")
        box.valueChanged.connect(lambda ms: self.latency_entered.emit(name, ms))
        return box

    def _buttons_of(self, name: str) -> tuple[Button, ...]:
        up = text_button("\u2191", self.tr("Move up; the first one leads"))
        up.setAccessibleName(self.tr("Move up"))
        up.setEnabled(name != self._player.output_names[0])
        made = (
            (up, self.move_up),
            (
                text_button(self.tr("Remove"), self.tr("Release this device")),
                self.remove,
            ),
            (
                text_button(
                    self.tr("Test\u2026"), self.tr("Moves it gently; asks first")
                ),
                self.test,
            ),
            (
                text_button(
                    self.tr("Set up\u2026"),
                    self.tr("What it needs, and how it is connected"),
                ),
                self.set_up_wanted.emit,
            ),
        )
        for button, does in made:
            button.clicked.connect(lambda _=False, does=does: does(name))
        return tuple(button for button, _ in made)
