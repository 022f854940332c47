"""What a device needs on this computer, as a list that follows what a person does."""

from html import escape

from PySide6.QtCore import QCoreApplication, QElapsedTimer, QObject, Qt, QTimer, Signal

from app.bridge.jobs import Jobs
from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.layout import paragraph
from app.widgets.texts import breakable, titled
from hapticplayer.devices import find_device
from hapticplayer.devices.checks import Check
from hapticplayer.devices.guides import checks_of
from hapticplayer.errors import DeviceError, Progress

translate = QCoreApplication.translate

LOOK_MS = 3000
"""Period of looking again while something is missing."""
MOST_SHARE = 0.05
"""Of the time in which it may look; some looks need a process of their own."""
POLL_MS = 50
_SIGNS = {True: "\u2713", False: "\u2717", None: "?"}


class CheckList(QObject):
    """Looks in a thread, again and again until nothing is missing.

    Signals:
        changed: another list is shown.
    """

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.label = paragraph()
        self.label.setTextFormat(Qt.TextFormat.RichText)
        self.label.setAccessibleName(self.tr("What the device needs"))
        self.found: list[Check] | None = None
        self._name = ""
        self._jobs = Jobs(self._on_problem)
        self._begun = QElapsedTimer()
        self._poll_timer, self._look_timer = QTimer(self), QTimer(self)
        self._poll_timer.setInterval(POLL_MS)
        self._look_timer.setInterval(LOOK_MS)
        self._poll_timer.timeout.connect(self._jobs.poll)
        self._look_timer.timeout.connect(self.look)

    @property
    def is_busy(self) -> bool:
        """Whether it looks now."""
        self._jobs.poll()
        return self._jobs.is_busy

    @property
    def is_met(self) -> bool | None:
        """Whether nothing is missing; None while that is not known."""
        if self.found is None:
            return None
        met = [check.is_met for check in self.found]
        return False if False in met else None if None in met else True

    def follow(self, name: str) -> None:
        """Show what another device needs; "" for none."""
        self._name, self.found = name, None
        self._show()
        self.look()

    def look(self) -> None:
        """Look again, unless everything is there or a look is under way."""
        if self._jobs.is_busy or self.is_met or not self._name:
            return
        self._look_timer.start()
        self._poll_timer.start()
        self._begun.start()
        name = self._name

        def work(_progress: Progress) -> tuple[str, list[Check]]:
            return name, checks_of(find_device(name))

        self._jobs.run("", work, self._take)

    def stop(self) -> None:
        """Look no more; a look that is under way ends by itself."""
        self._look_timer.stop()
        self._poll_timer.stop()

    def close(self) -> None:
        """Look no more, and wait for the look that is under way."""
        self.stop()
        self._jobs.close()

    def _take(self, found: tuple[str, list[Check]]) -> None:
        name, checks = found
        pause_ms = max(LOOK_MS, round(self._begun.elapsed() / MOST_SHARE))
        self._look_timer.setInterval(pause_ms)
        if name != self._name:
            self.look()
        elif checks != self.found:
            self.found = checks
            self._show()
            self.changed.emit()

    def _on_problem(self, problem: BaseException) -> None:
        if not isinstance(
            problem, DeviceError
        ):  # the page says what is wrong with a name
            raise problem

    def _show(self) -> None:
        rows = "".join(map(_row, self.found or ()))
        self.label.setText(f"<table cellspacing='0'>{rows}</table>" if rows else "")


def _row(check: Check) -> str:
    """Return a check as rich text: its sign, what it is about, and what to do."""
    colour = {True: theme.GOOD, False: theme.BAD, None: theme.WARN}[check.is_met]
    states = {
        True: translate("CheckList", "OK"),
        False: translate("CheckList", "missing"),
        None: translate("CheckList", "not visible from here"),
    }
    text = titled(translated(check.what), states[check.is_met])
    if check.is_met is False:
        text += f"\n\u2192 {translated(check.remedy)}"
    sign = f"<td style='color:{colour}'><b>{_SIGNS[check.is_met]}</b>&nbsp;</td>"
    return f"<tr>{sign}<td>{escape(breakable(text), quote=False).replace(chr(10), '<br>')}</td></tr>"
