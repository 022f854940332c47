"""More devices: what plays beside the chosen one, each with its state, test and mute."""

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
from app.bridge.settings import MOST_OUTLETS
from app.player import choices
from app.player.device_form import (
    example_of,
    outlet_text,
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
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.devices.options import GAIN, LATENCY_MS
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.latency import LatencySource
from hapticplayer.playback.snapshot import OutletState, Snapshot

translate = QCoreApplication.translate

POLL_MS = 100
GENTLE_GAIN = 0.25
_WIDTH_PX, _HEIGHT_PX, _RIG = 640, 520, "rig"


def state_text(outlet: OutletState) -> str:
    """The state of an output, or its problem."""
    if outlet.problem or outlet.health in (Health.FAILED, Health.GONE):
        return translated(outlet.problem) or translate("Health", "failed")
    if outlet.health is Health.STARTING:
        return translate("Health", "starting")
    if outlet.note and not outlet.is_muted:
        return translated(outlet.note)
    return mode_text(outlet.mode)


def figures_text(outlet: OutletState) -> str:
    """Return latency and gain of an outlet."""
    sign = "\u2248\u2009" * (outlet.latency_source is LatencySource.ASSUMED)
    latency = f"{sign}{1e3 * outlet.latency_s:.0f}\u00a0ms"
    return local(f"{latency}, \u00d7\u2009{outlet.gain:.2f}")


class OutletsPage(QDialog):
    """Stays beside the window; what stops the force there stops a test here, too.

    Signals:
        changed: a person has chosen others, or muted one; has names, each with whether
            it is muted.
        set_up_wanted: the set-up page of one is wanted.
    """

    changed = Signal(object)
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
        """Play on the outlet of the form as well."""
        choice = str(self.kind.currentData())
        name = put_together(choice, self.address.text().strip())
        if self._is_rig:
            name += f",gain={self.gain.value():g},latency_ms={self.latency.value():g}"
        if name in (*self._names(), self._player.snapshot().device):
            self._say(self.tr("This device plays already"))
        elif not name.isprintable():
            self._say(self.tr("Settings are letters, digits and signs"))
        elif len(self._names()) >= MOST_OUTLETS:
            self._say(self.tr("No more devices can be added; remove one first"))
        else:
            self._use([*self._names(), name])

    def remove(self, name: str) -> None:
        """Bring an outlet to rest and let go of it."""
        self._use([one for one in self._names() if one != name])

    def mute(self, name: str, *, is_muted: bool) -> None:
        """Let an outlet come to rest, or play again."""
        self._player.set_outlet(name, is_muted=is_muted)

    def chosen(self) -> dict[str, bool]:
        """Return the outlets, each with whether a person has muted it."""
        outlets = self._player.snapshot().outlets
        return {outlet.name: outlet.is_muted for outlet in outlets}

    def test(self, name: str) -> None:
        """Test an outlet gently, after asking; nothing else plays on it meanwhile."""
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
        self._player.lend_outlet(self._tested)

    def _is_free(self) -> bool:
        return self._player.is_outlet_free(self._tested)

    def _on_test_ended(self) -> None:
        """Let the outlet play again, and say how the test has ended."""
        self._show_panel(is_wanted=False)
        self._say(self.panel.state.text())
        if self._tested in self._names():
            try:
                self._player.take_back_outlet(self._tested)
            except HapticPlayerError as problem:
                self._say(translated(message_of(problem)))

    def _show_panel(self, *, is_wanted: bool) -> None:
        """Show the picture of a test in the place of rows and form."""
        self.heading.setText(outlet_text(self._tested) if is_wanted else self._text())
        self.panel.setVisible(is_wanted)
        for part in (self._scroll, self._form):
            part.setHidden(is_wanted)

    def reject(self) -> None:
        """Stop before anything else; Escape comes here too."""
        self._session.stop()
        super().reject()

    def done(self, result: int) -> None:
        """Close; the outlets go on."""
        self.end_test()
        self._timer.stop()
        self.panel.wait()
        super().done(result)

    def close_jobs(self) -> None:
        """End what still moves: the window closes."""
        self.end_test()

    def _on_mute(self, name: str, *, is_muted: bool) -> None:
        self.mute(name, is_muted=is_muted)
        self.changed.emit(self.chosen())

    # --- what is shown -------------------------------------------------------

    def look(self) -> None:
        """Show what has changed."""
        now = self._player.snapshot()
        names = [outlet.name for outlet in now.outlets]
        if names != self._shown:
            self._shown = names
            self._fill_rows(now)
        is_playing = now.is_playing and self.panel.is_acting
        if is_playing or (self.panel.is_running and self._tested not in names):
            self.end_test()
        offer_stop(self.stop_button, is_stopped=now.is_stopped)
        for outlet in now.outlets:
            self.states[outlet.name].setText(state_text(outlet))
            self.figures[outlet.name].setText(figures_text(outlet))
            source = source_text(outlet.latency_source)
            tip = self.tr("Latency that is compensated ({source}), and gain")
            self.figures[outlet.name].setToolTip(tip.format(source=source))
            self.mutes[outlet.name].setChecked(outlet.is_muted)
            self.meters[outlet.name].show_levels(outlet.levels)
            may_test = not (now.is_playing or self.panel.is_running)
            self.tests[outlet.name].setEnabled(may_test)

    @property
    def _is_rig(self) -> bool:
        return _is_rig(str(self.kind.currentData()))

    def _names(self) -> list[str]:
        return [outlet.name for outlet in self._player.snapshot().outlets]

    def _use(self, names: list[str]) -> None:
        try:
            for name in names:
                find_device(name)
            self._player.set_outlets(names)
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))
            return
        self._say("")
        self.look()
        self.changed.emit(self.chosen())

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
        self.setWindowTitle(self.tr("More devices"))
        self.setMinimumWidth(_WIDTH_PX)
        add = text_button(self.tr("Add"), self.tr("Play on this device, too"))
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
            "Each of these plays beside the chosen device and stops with it. A rig "
            "moves with the motion of the recording: begin with a small gain."
        )

    def _fill_rows(self, now: Snapshot) -> None:
        while (item := self.rows.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        self.states, self.figures, self.tests, self.mutes = {}, {}, {}, {}
        self.meters = {}
        for row, outlet in enumerate(now.outlets):
            self._add_row(row, outlet.name)

    def _add_row(self, row: int, name: str) -> None:
        text = outlet_text(name)
        label, self.states[name] = ElidedLabel(text), paragraph("", theme.DIM)
        label.setToolTip(text)
        self.figures[name] = figures = QLabel()
        self.mutes[name] = mute = QCheckBox(self.tr("Mute"))
        test = text_button(
            self.tr("Test\u2026"), self.tr("Move it gently, after a question")
        )
        set_up = text_button(
            self.tr("Set up\u2026"), self.tr("What it needs, and how it is connected")
        )
        remove = text_button(self.tr("Remove"), self.tr("Release this device"))
        for widget in (mute, test, set_up, remove):
            widget.setAccessibleName(titled(text, widget.text()))
        mute.clicked.connect(lambda on: self._on_mute(name, is_muted=on))
        test.clicked.connect(lambda: self.test(name))
        set_up.clicked.connect(lambda: self.set_up_wanted.emit(name))
        remove.clicked.connect(lambda: self.remove(name))
        self.tests[name] = test
        for column, part in enumerate((label, figures, mute, test, set_up, remove)):
            self.rows.addWidget(part, 3 * row, column)
        self.rows.addWidget(self.states[name], 3 * row + 1, 0, 1, -1)
        self.meters[name] = meter = LevelMeter(text)
        self.rows.addWidget(meter, 3 * row + 2, 0, 1, -1)
        self.rows.setColumnStretch(0, 1)


def _is_rig(name: str) -> bool:
    return name.partition(":")[0] == _RIG
