"""More devices: what plays beside the chosen one, each with its state, test and mute."""

import threading

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
from app.player.health import mode_text
from app.player.session import Session
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
from hapticplayer.devices.rig.settings import GAIN, LATENCY_MS
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.forces import ForcePlayer
from hapticplayer.playback.snapshot import OutletState, Snapshot
from hapticplayer.rendering import rig_demonstration

translate = QCoreApplication.translate

POLL_MS = 100
GENTLE_GAIN = 0.25
_WIDTH_PX, _HEIGHT_PX, _RIG = 640, 520, "rig"


def state_text(outlet: OutletState) -> str:
    """Return what an outlet does, or what is wrong with it."""
    if outlet.problem or outlet.health in (Health.FAILED, Health.GONE):
        return translated(outlet.problem) or translate("Health", "failed")
    if outlet.health is Health.STARTING:
        return translate("Health", "starting")
    if outlet.note and not outlet.is_muted:
        return translated(outlet.note)
    return mode_text(outlet.mode)


def figures_text(outlet: OutletState) -> str:
    """Return latency and gain of an outlet."""
    return local(f"{1e3 * outlet.latency_s:.0f} ms, \u00d7\u2009{outlet.gain:.2f}")


class RigTest:
    """A test of a rig, from its beginning until its processes have ended.

    `was_muted` is whether a person had silenced the outlet before.
    """

    def __init__(self, name: str, was_muted: bool) -> None:
        self.name, self.was_muted = name, was_muted
        self._releaser: threading.Thread | None = None

    def release(self, player: ForcePlayer) -> None:
        """Let the rig come to rest, in a thread of its own."""
        self._releaser = threading.Thread(target=player.close, name="rig-test")
        self._releaser.start()

    @property
    def is_at_rest(self) -> bool:
        """Whether it is over."""
        return self._releaser is not None and not self._releaser.is_alive()

    def wait(self) -> None:
        """Wait until it is over."""
        if self._releaser is not None:
            self._releaser.join()


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
        self.tested: ForcePlayer | None = None
        self._test: RigTest | None = None
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
        muted = {outlet.name: outlet.is_muted for outlet in outlets}
        if self._test is not None and self._test.name in muted:
            muted[self._test.name] = self._test.was_muted
        return muted

    def test(self, name: str) -> None:
        """Move a rig gently along and about each axis; once more: stop."""
        if self.tested is not None:
            self.end_test()
            return
        if self._test is not None:  # the last one still comes to rest
            return
        self._player.pause()
        try:
            self.tested = ForcePlayer(self._clock, name, rig_demonstration()[0])
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))
            return
        # the player's own packets to the same rig would alternate with these
        self._test = RigTest(name, self.mutes[name].isChecked())
        self.mute(name, is_muted=True)
        self._say(
            self.tr("The rig moves gently, one axis after the other. Esc stops it.")
        )

    def end_test(self) -> None:
        """Let the rig come to rest; its processes end when it has."""
        player, self.tested = self.tested, None
        if player is not None:
            self._say(translated(player.problem))
            player.stop()
            if self._test is not None:
                self._test.release(player)

    def _note_rest(self) -> None:
        """Let an outlet play again once its test has come to rest."""
        test = self._test
        if test is None or not test.is_at_rest:
            return
        self._test = None
        if test.name in self._names():
            self.mute(test.name, is_muted=test.was_muted)

    def reject(self) -> None:
        """Stop before anything else; Escape comes here too."""
        self._session.stop()
        super().reject()

    def done(self, result: int) -> None:
        """Close; the outlets go on."""
        self.end_test()
        self._timer.stop()
        if self._test is not None:
            self._test.wait()
            self._note_rest()
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
        if self.tested is not None:
            self.tested.poll()
            if self.tested.is_over:
                self.end_test()
        self._note_rest()
        for outlet in now.outlets:
            self.states[outlet.name].setText(state_text(outlet))
            self.figures[outlet.name].setText(figures_text(outlet))
            self.mutes[outlet.name].setChecked(outlet.is_muted)
            self.meters[outlet.name].show_levels(outlet.levels)
            may_test = outlet.mode is Mode.IDLE and not now.is_playing
            self.tests[outlet.name].setEnabled(
                self.tested is not None or (may_test and _is_rig(outlet.name))
            )

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
        stop = text_button(self.tr("STOP"), self.tr("Stop all of them (Esc)"), "stop")
        stop.clicked.connect(self._session.stop)
        close = text_button(self.tr("Close"), self.tr("The devices keep playing"))
        close.clicked.connect(self.accept)
        where = captioned(self.tr("Address or settings"), self.address)
        gain = captioned(self.tr("Gain"), self.gain)
        latency = captioned(self.tr("Latency"), self.latency)
        self.kind.setAccessibleName(self.tr("Device to add"))
        fill_page(
            self,
            paragraph(
                self.tr(
                    "Each of these plays beside the chosen device and stops with it. A rig "
                    "moves with the motion of the recording: begin with a small gain."
                )
            ),
            (scrolling(column_of(self.rows, STRETCH)), 1),
            row_of((self.kind, 1)),
            row_of(where[0], (self.address, 1)),
            row_of(*gain, *latency, STRETCH, add),
            self.problem,
            row_of(stop, STRETCH, close),
        )
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)

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
        figures.setToolTip(self.tr("Latency that is compensated, and gain"))
        self.mutes[name] = mute = QCheckBox(self.tr("Mute"))
        test = text_button(
            self.tr("Test"), self.tr("Move the rig gently, or stop that")
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
