"""The outputs: all that plays, in order, each with its state, test and mute."""

from PySide6.QtCore import QCoreApplication, QTimer, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QGridLayout,
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
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    captioned,
    column_of,
    fill_page,
    indent,
    paragraph,
    resize_within_screen,
    row_of,
    scrolling,
)
from app.widgets.level_meter import LevelMeter
from app.widgets.texts import local, titled
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.devices.options import GAIN, LATENCY_MS
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.latency import LatencySource
from hapticplayer.playback.snapshot import OutputSnapshot, Snapshot

translate = QCoreApplication.translate

POLL_MS = 100
GENTLE_GAIN = 0.25
_WIDTH_PX, _HEIGHT_PX, _RIG = 640, 520, "rig"


def state_text(output: OutputSnapshot) -> str:
    """The state of an output, or its problem."""
    if output.problem or output.health in (Health.FAILED, Health.GONE):
        return translated(output.problem) or translate("Health", "failed")
    if output.health is Health.STARTING:
        return translate("Health", "starting")
    if output.note and not output.is_muted:
        return translated(output.note)
    return mode_text(output.mode)


def figures_text(output: OutputSnapshot) -> str:
    sign = "\u2248\u2009" * (output.latency_source is LatencySource.ASSUMED)
    latency = f"{sign}{1e3 * output.latency_s:.0f}\u00a0ms"
    return local(f"{latency}, \u00d7\u2009{output.gain:.2f}")


class OutputsPage(QDialog):
    """Stays beside the window; what stops the force there stops a test here, too.

    Signals:
        changed: a person has chosen others or another order, or muted one.
        set_up_wanted: the set-up page of one is wanted.
    """

    changed = Signal()
    set_up_wanted = Signal(str)

    def __init__(
        self, clock: Clock, session: Session, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._clock, self._session, self._player = clock, session, session.player
        session.stopped.connect(self.end_test)
        self._tested = ""
        self.panel = DeviceTestPanel(clock, self._is_free, session.player.latch)
        self._shown: list[str] = []
        self.states: dict[str, QLabel] = {}
        self.figures: dict[str, QLabel] = {}
        self.tests: dict[str, QWidget] = {}
        self.mutes: dict[str, QCheckBox] = {}
        self.meters: dict[str, LevelMeter] = {}
        self.rows, self.problem = QGridLayout(), paragraph("", theme.DIM, lines=2)
        self.kind, self.address = QComboBox(), QLineEdit()
        self.gain, self.latency = QDoubleSpinBox(), QDoubleSpinBox()
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
        if self._is_rig:
            name += f",gain={self.gain.value():g},latency_ms={self.latency.value():g}"
        names = self._player.output_names
        if name in names:
            self._say(self.tr("This device is already in use"))
        elif not name.isprintable():
            self._say(self.tr("Settings may contain letters, digits and punctuation"))
        elif len(names) >= MOST_OUTPUTS:
            self._say(self.tr("No more devices can be added; remove one first"))
        else:
            self._use([*names, name])

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

    def test(self, name: str) -> None:
        """Test an output gently, after asking; nothing else plays on it meanwhile."""
        if not self.panel.is_running:
            self._tested = name
            self.panel.set_device(name)
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
        for output in now.outputs:
            self.states[output.name].setText(state_text(output))
            self.figures[output.name].setText(figures_text(output))
            source = source_text(output.latency_source)
            tip = self.tr("Latency that is compensated ({source}), and gain")
            self.figures[output.name].setToolTip(tip.format(source=source))
            self.mutes[output.name].setChecked(output.is_muted)
            self.meters[output.name].show_levels(output.levels)
            may_test = not (now.is_playing or self.panel.is_running)
            self.tests[output.name].setEnabled(may_test)

    @property
    def _is_rig(self) -> bool:
        return _is_rig(str(self.kind.currentData()))

    def _use(self, names: list[str]) -> None:
        try:
            self._player.set_outputs(names)
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))
            return
        self._session.changed.emit()
        self._say("")
        self.look()
        self.changed.emit()

    def _say(self, text: str) -> None:
        self.problem.setText(text)

    def _make_form(self) -> None:
        for choice in (*variants(), *choices.devices()):
            if choice.name != NO_DEVICE:
                self.kind.addItem(choice.text, choice.name)
        self.kind.currentIndexChanged.connect(self._on_kind)
        for box, within, value in (
            (self.gain, GAIN, GENTLE_GAIN),
            (self.latency, LATENCY_MS, 0.0),
        ):
            box.setRange(within.least, within.largest)
            box.setValue(value)
            indent(box)
        self.gain.setSingleStep(0.05)
        self.latency.setSuffix("\u00a0ms")
        self._on_kind()

    def _on_kind(self) -> None:
        choice = str(self.kind.currentData())
        for widget in (self.gain, self.latency):
            widget.setEnabled(self._is_rig)
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
        gain = captioned(self.tr("Gain"), self.gain)
        latency = captioned(self.tr("Latency"), self.latency)
        self.kind.setAccessibleName(self.tr("Device to add"))
        self.heading = paragraph(self._text(), lines=2)
        self._scroll = scrolling(column_of(self.rows, STRETCH))
        self._form = QWidget()
        column_of(
            row_of((self.kind, 1)),
            row_of(where[0], (self.address, 1)),
            row_of(*gain, *latency, STRETCH, add),
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
        while (item := self.rows.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        self.states, self.figures, self.tests, self.mutes = {}, {}, {}, {}
        self.meters = {}
        for row, output in enumerate(now.outputs):
            self._add_row(row, output.name)

    def _add_row(self, row: int, name: str) -> None:
        text = output_text(name)
        label, self.states[name] = ElidedLabel(text), paragraph("", theme.DIM)
        label.setToolTip(text)
        self.figures[name] = figures = QLabel()
        self.mutes[name] = mute = QCheckBox(self.tr("Mute"))
        test = text_button(
            self.tr("Test\u2026"), self.tr("Moves it gently; asks first")
        )
        set_up = text_button(
            self.tr("Set up\u2026"), self.tr("What it needs, and how it is connected")
        )
        remove = text_button(self.tr("Remove"), self.tr("Release this device"))
        up = text_button("\u2191", self.tr("Move up; the first one leads"))
        up.setEnabled(row > 0)
        for widget in (mute, test, set_up, remove):
            widget.setAccessibleName(titled(text, widget.text()))
        mute.clicked.connect(lambda on: self.mute(name, is_muted=on))
        test.clicked.connect(lambda: self.test(name))
        set_up.clicked.connect(lambda: self.set_up_wanted.emit(name))
        remove.clicked.connect(lambda: self.remove(name))
        self.tests[name] = test
        up.setAccessibleName(titled(text, self.tr("Move up")))
        up.clicked.connect(lambda: self.move_up(name))
        parts = (label, figures, mute, up, test, set_up, remove)
        for column, part in enumerate(parts):
            self.rows.addWidget(part, 3 * row, column)
        self.rows.addWidget(self.states[name], 3 * row + 1, 0, 1, -1)
        self.meters[name] = meter = LevelMeter(text)
        self.rows.addWidget(meter, 3 * row + 2, 0, 1, -1)
        self.rows.setColumnStretch(0, 1)


def _is_rig(name: str) -> bool:
    return name.partition(":")[0] == _RIG
