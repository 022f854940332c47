"""A panel for developers: inject a fault, and watch the safety contract respond."""

from PySide6.QtCore import QCoreApplication, Qt, QTimer
from PySide6.QtWidgets import (
    QDialog,
    QGridLayout,
    QLabel,
    QTableWidgetItem,
    QWidget,
)

from app.player import health
from app.player.session import Session
from app.widgets import theme
from app.widgets.buttons import set_role, text_button
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.tables import plain_table
from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.errors import HapticPlayerError
from hapticplayer.extras.faults.injected import RULES_OF, Fault, outcome_of
from hapticplayer.haptics.contract import RULES, Cause, Mode, Reaction
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.snapshot import Snapshot

translate = QCoreApplication.translate

HANGS: dict[str, tuple[float, Cause]] = {
    "hang-short": (0.4, Cause.HEARTBEAT_LATE),
    "hang-long": (1.3, Cause.HEARTBEAT_LOST),
}
"""Faults of the window itself: how long it hangs, and the rule that answers."""

_REACTIONS = {rule.cause: rule.reaction for rule in RULES}


def fault_text(name: str) -> str:
    """The name of a fault."""
    return {
        Fault.UNPLUG.value: translate("FaultTexts", "Unplug"),
        Fault.SHORT_STALL.value: translate("FaultTexts", "Stall, 60 ms"),
        Fault.LONG_STALL.value: translate("FaultTexts", "Stall, 300 ms"),
        Fault.NONSENSE.value: translate("FaultTexts", "Malformed replies"),
        Fault.LOST_HOMING.value: translate("FaultTexts", "Lose homing"),
        Fault.LET_GO.value: translate("FaultTexts", "Let go of the grip"),
        Fault.BUTTON.value: translate("FaultTexts", "Press a grip button"),
        Fault.POSITION_NAN.value: translate("FaultTexts", "Position is NaN"),
        Fault.FORCE_NAN.value: translate("FaultTexts", "Force is NaN"),
        Fault.LOOP_LATE.value: translate("FaultTexts", "Loop late, 35 ms"),
        Fault.LOOP_LOST.value: translate("FaultTexts", "Loop stalled, 80 ms"),
        Fault.STALE_COMMAND.value: translate("FaultTexts", "Command 25 ms old"),
        "hang-short": translate("FaultTexts", "Window hangs, 0.4 s"),
        "hang-long": translate("FaultTexts", "Window hangs, 1.3 s"),
    }[name]


def names() -> list[str]:
    return [fault.value for fault in Fault] + list(HANGS)


def rule_text(cause: Cause) -> str:
    """Return a rule as the contract's table has it: its name and its reaction."""
    reaction = _REACTIONS.get(cause)
    return (
        f"{cause.name} ({reaction.name})"
        if isinstance(reaction, Reaction)
        else "\u2013"
    )


def expected(name: str) -> str:
    causes = (HANGS[name][1],) if name in HANGS else RULES_OF[Fault(name)]
    return ", ".join(rule_text(cause) for cause in causes)


POLL_MS = 100
FOLLOWED_S = 3.0
"""For so long a fault's outcome may still change."""
_BEFORE_S = 0.001
_DEAD = (Health.FAILED, Health.GONE)
_COLUMNS, _WIDTH_PX, _HEIGHT_PX = 3, 620, 560


def _is_felt(now: Snapshot) -> bool:
    """Whether there is a force that a fault could end."""
    one = now.leading
    is_active = one.mode in (Mode.ENTERING, Mode.FOLLOWING)
    return one.takes_faults and one.health not in _DEAD and is_active


class FaultPanel(QDialog):
    """Stays beside the window; while it is open the simulated device takes faults."""

    def __init__(self, clock: Clock, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._clock, self._session = clock, session
        self._followed: tuple[int, float] | None = None  # row of the table, since when
        self.state, self.hint = QLabel(), paragraph("", theme.DIM)
        self.table = plain_table(
            self.tr("Fault results"),
            [
                self.tr("Fault"),
                self.tr("Rule triggered"),
                self.tr("Reaction, ms"),
                self.tr("Time to zero, ms"),
            ],
            stretched=1,
        )
        self.buttons = {
            name: text_button(fault_text(name), expected(name)) for name in names()
        }
        self.rearm = text_button(
            self.tr("Re-arm"), self.tr("Re-enable the force (Ctrl+R)"), "rearm"
        )
        self.again = text_button(
            self.tr("Restart device"),
            self.tr("Start the simulated device again, without the fault"),
        )
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)
        self._timer.start()
        self.start()

    def start(self) -> None:
        """Restart the simulated device so that it accepts faults."""
        player = self._session.player
        names = player.output_names
        if names and find_device(names[0]).server:
            player.set_outputs(names, takes_faults=True)
            self._session.changed.emit()
        self._poll()

    def inject(self, name: str) -> None:
        """Make one thing happen."""
        self._note(name)
        if name in HANGS:
            now_s = self._clock.now_s()
            self._follow(now_s)
            self._clock.sleep_until(now_s + HANGS[name][0])  # this is the fault
            return
        try:
            self._follow(self._session.player.inject(Fault(name)))
        except HapticPlayerError as problem:
            self._session.report_outputs(problem)

    def done(self, result: int) -> None:
        """Give the window a device back that takes no faults."""
        self._timer.stop()
        player, now = self._session.player, self._session.player.snapshot()
        if now.leading.takes_faults:
            player.set_outputs(player.output_names)
            self._session.changed.emit()
        super().done(result)

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Inject faults into the simulated device"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)
        self.state.setFont(theme.scaled(self.font(), 1.2, bold=True))
        grid = QGridLayout()
        for place, (name, button) in enumerate(self.buttons.items()):
            button.clicked.connect(lambda _=False, name=name: self.inject(name))
            grid.addWidget(button, place // _COLUMNS, place % _COLUMNS)
        self.rearm.clicked.connect(self._session.rearm)
        self.again.clicked.connect(self.start)
        close = text_button(self.tr("Close"), self.tr("Stop injecting faults"))
        close.clicked.connect(self.reject)
        buttons = row_of(self.rearm, self.again, STRETCH, close)
        fill_page(self, self.state, self.hint, grid, (self.table, 1), buttons)

    # --- what is shown -------------------------------------------------------

    def _note(self, name: str) -> None:
        self.table.insertRow(0)
        for column, text in enumerate((fault_text(name), "\u2026", "\u2013", "\u2013")):
            self.table.setItem(0, column, QTableWidgetItem(text))

    def _follow(self, at_s: float) -> None:
        self._followed = (self.table.rowCount(), at_s)

    def _poll(self) -> None:
        now = self._session.player.snapshot()
        self.state.setText(health.device(now).text)
        self.hint.setText(self._hint(now))
        for button in self.buttons.values():
            button.setEnabled(_is_felt(now))
        self.rearm.setEnabled(now.is_stopped)
        set_role(self.rearm, "rearm" if now.is_stopped else "")
        self._show_outcome()

    def _hint(self, now: Snapshot) -> str:
        if not now.leading.takes_faults:
            return self.tr(
                "Faults can only be injected into a simulated device while this "
                "panel is open: choose it in the window, then press Restart "
                "device."
            )
        if now.leading.health in _DEAD:
            return self.tr("The device has failed: press Restart device.")
        if not _is_felt(now):
            return self.tr("Play a clip with force first.")
        return self.tr(
            "The force is active. Press a fault to see how the safety "
            "contract responds."
        )

    def _show_outcome(self) -> None:
        """Tell what has come of the newest fault; a stall has its end later."""
        if self._followed is None:
            return
        rows, at_s = self._followed
        ticks = self._session.player.ticks_since(at_s - _BEFORE_S)
        found = outcome_of(ticks, at_s) if len(ticks) else None
        if found is not None:
            zero = "\u2013" if found.zero_s is None else f"{1e3 * found.zero_s:.0f}"
            texts = (rule_text(found.cause), f"{1e3 * found.reaction_s:.0f}", zero)
            for column, text in enumerate(texts, start=1):
                row = self.table.rowCount() - rows  # newer ones are above it
                self.table.setItem(row, column, QTableWidgetItem(text))
        if self._clock.now_s() > at_s + FOLLOWED_S:
            self._followed = None
            if found is None:  # the device has gone, or nothing had to answer
                row = self.table.rowCount() - rows
                self.table.setItem(row, 1, QTableWidgetItem("\u2013"))
