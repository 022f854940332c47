"""Drives the player from Qt's event loop, and says when there is time to draw."""

import math
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from hapticplayer.clock import Clock

EARLY = 0.3
"""Of a period. A caller at each frame of 30 a second, a little early or late,
is not to be sent away every other time."""


class Cadence:
    """Says when it is time again; a late start does not lead to a burst."""

    def __init__(self, rate_hz: float) -> None:
        self._period_s = 1.0 / rate_hz
        self._next_s = float("-inf")

    def is_due(self, now_s: float) -> bool:
        """Whether a period has passed; starts the next one if so."""
        if now_s < self._next_s - EARLY * self._period_s:
            return False
        on_time_s = self._next_s + self._period_s
        self._next_s = on_time_s if on_time_s > now_s else now_s + self._period_s
        return True

    def reset(self) -> None:
        """Be due at once."""
        self._next_s = float("-inf")


LONGEST_MS = 34
"""As the player's own `POLL_S`, and the heartbeat of the haptics process: it ramps after 150 ms of silence."""
TIMER_LATE_MS = 0.5
"""Qt counts whole milliseconds and wakes 0.3 to 0.6 ms late."""
NAP_S = 0.0015
"""What is left until the frame is due is slept away: shorter than painting it."""
GAP_S = 0.008
"""Drawing plots and labels takes 2 to 5 ms; a frame must not wait for it."""
LONGEST_WITHOUT_GAP_S = 0.1
REST_AFTER_S = 30.0
"""Without anything due and without a person: as the haptic loop's own rest."""
REST_MS, REST_GAP_S = 400, 0.8
"""At rest, when the loop expects no heartbeat, and what is shown stands still."""


class Pump(QObject):
    """Calls `poll` when it asks to be called, also in menus and modal dialogs.

    A precise single-shot timer is armed again after each call, whatever happened in it:
    an error reaches sys.excepthook, the next call comes all the same. `gap` is called
    after `poll` when nothing is due for a while: the time to draw everything but the
    video. One that `rests` calls less often while nothing happens, until `wake`.

    Signals:
        rested: whether it rests from now on.
    """

    rested = Signal(bool)

    def __init__(
        self,
        poll: Callable[[], float],
        clock: Clock,
        gap: Callable[[], None],
        parent: QObject | None = None,
        *,
        rests: bool = False,
    ) -> None:
        super().__init__(parent)
        self._poll, self._rests, self.is_resting = poll, rests, False
        self._active_s = clock.now_s()
        self._clock = clock
        self._gap = gap
        self._last_gap_s = float("-inf")
        self._due_s = float("-inf")
        self._is_running = False
        self.timer = QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.setTimerType(Qt.TimerType.PreciseTimer)
        self.timer.timeout.connect(self.beat)

    def start(self) -> None:
        """Begin to call."""
        self._is_running = True
        self.timer.start(0)

    def stop(self) -> None:
        self._is_running = False
        self.timer.stop()

    def wake(self) -> None:
        """A person is here, or something happens."""
        self._active_s = self._clock.now_s()
        if self.is_resting and self._is_running:
            self._set_resting(is_resting=False)
            self.timer.start(0)

    def beat(self) -> None:
        """Poll the player if it is due, and come back when it is again."""
        if not self.is_resting and self._due_s - self._clock.now_s() <= NAP_S:
            self._clock.sleep_until(self._due_s)
        next_s = begin_s = self._clock.now_s()
        try:
            next_s = self._poll()
            self._note_rest(begin_s, next_s)
            self._fill_gap(next_s)
        finally:
            self._due_s = next_s
            if self._is_running:
                left_ms = delay_ms(next_s - self._clock.now_s())
                self.timer.start(REST_MS if self.is_resting else left_ms)

    def _note_rest(self, begin_s: float, next_s: float) -> None:
        if (
            1e3 * (next_s - begin_s) < LONGEST_MS - 1.0
        ):  # a frame, or one that is awaited
            self._active_s = begin_s
        is_quiet = begin_s - self._active_s > REST_AFTER_S
        self._set_resting(is_resting=self._rests and is_quiet)

    def _set_resting(self, *, is_resting: bool) -> None:
        if is_resting is not self.is_resting:
            self.is_resting = is_resting
            self.rested.emit(is_resting)

    def _fill_gap(self, next_s: float) -> None:
        now_s = self._clock.now_s()
        is_free = next_s - now_s >= GAP_S
        longest_s = REST_GAP_S if self.is_resting else LONGEST_WITHOUT_GAP_S
        is_overdue = now_s - self._last_gap_s >= longest_s
        if is_overdue or (is_free and not self.is_resting):
            self._last_gap_s = now_s
            self._gap()


def delay_ms(remaining_s: float) -> int:
    """Return the timer's interval: a little early, at least 1 ms."""
    if math.isnan(remaining_s):
        return LONGEST_MS
    early_ms = 1e3 * remaining_s - TIMER_LATE_MS
    return math.floor(min(max(1.0, early_ms), LONGEST_MS))
